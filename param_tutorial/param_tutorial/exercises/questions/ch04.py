"""Predictions of chapter 4: when a node notices."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'You read at the right moment. Many a robot in the field does not.'

RECALLS = (
    Recall('4-r1', 'A node declares `max_speed_mps` with the default `1`. Which type does the parameter get?', (
        wrong('double: a speed needs its decimals', 'The name of a parameter says nothing about its type. In '
              'Python `1` is an `int`; write `1.0` for a double.'),
        right('integer', 'The default decides the type, and `1` is an `int`.'),
        wrong('none, until somebody sets a value', 'The declaration fixes the type at once, and the default '
              'decides it.')),
           chapter='3', section='Build it: one declaration, one type'),
    Recall('4-r2', 'Two robots run the same program, each under its own name. You set the speed of the first to '
           '150. What does the second do?', (
        wrong('It drives at 150 too: the program is the same', 'The program is the same, but each node keeps '
              'parameters of its own.'),
        right('It keeps its own speed', 'A parameter lives in one node.'),
        wrong('It drives at 150 once it is started again', 'A restart brings back the default. What you set on '
              'one node never reaches another.')),
           chapter='1', section='Each node has its own'),
)

PREDICTIONS = (
    Prediction('4-1', 'The object `parameter` was taken when the speed was 100. Somebody has set it to 150 since. What '
               'is `parameter.value`?', (
        right('100', 'The object keeps the value of the moment when it was taken.'),
        wrong('150', 'The object is not connected with the node. To see 150, ask the node again with '
              '`get_parameter`.'),
        wrong('None: the object is out of date', 'An object never learns that it is out of date. It keeps the value '
              'that it was made with.'))),
    Prediction('4-2', '`get_parameter_or` has just returned the alternative for `battery_volts`. What does '
               "`has_parameter('battery_volts')` say now?", (
        wrong('True: the alternative was stored', '`get_parameter_or` stores nothing. Only `declare_parameter` creates '
              'a parameter.'),
        right('False', 'The alternative is used on the spot and stored nowhere. The parameter still does not '
              'exist.'))),
    Prediction('4-3', '`calibration` was declared as a double, without a value. What does `get_parameter` do?', (
        wrong('It returns 0.0', 'ROS has no default for a type. A parameter without a value has none, not even '
              'zero.'),
        wrong('It returns a parameter whose value is None', 'A node that needs a value could overlook that. '
              'rclpy raises an exception.'),
        right('It raises an exception', '`ParameterUninitializedException`: the parameter exists, and has no '
              'value.'))),
    Prediction('4-4', 'Both nodes have accepted 150. One copied the parameter when it started, the other reads it each '
               'time. At which speeds do they drive?', (
        wrong('both at 150: both said yes', 'Accepting a value and acting on it are two things. The first still drives '
              'with its copy.'),
        right('100 and 150', 'The first drives with its copy, though its parameter says 150.'),
        wrong('both at 100 until they are started again', 'The second reads its parameter ten times a second, and '
              'needs no restart.'))),
    Prediction('4-5', 'The override is `-p max_speed_rpm:=fast`, and the default is the integer 100. What does the '
               'node do?', (
        wrong('It starts with 100, and warns', 'A wrong override is not ignored. The declaration raises an exception, '
              'and ends the constructor.'),
        wrong("It starts, and the parameter is the string 'fast'", 'The default has decided that the parameter is an '
              'integer, also for an override.'),
        right('It does not start', 'The declaration raises `InvalidParameterTypeException`, and that ends the '
              'constructor.'))),
)
