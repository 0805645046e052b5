"""Predictions of chapter 4: when a node notices a change."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'You read at the right moment. Many robots in the field do not.'

RECALLS = (
    Recall('4-r1', 'A node declares `max_speed_mps` with the default `1`. Which type does the parameter get?', (
        wrong('double', 'The name of a parameter says nothing about its type. In Python `1` is an `int`; write `1.0` '
              'for a double.'),
        right('integer', 'The default decides the type, and `1` is an `int`.'),
        wrong('none yet', 'The declaration fixes the type at once: it is the type of the default.')),
           chapter='3', section='One default, one type'),
    Recall('4-r2', 'Two robots run the same program, each under its own name. You set the speed of the first to 150. '
           'What does the second do?', (
        wrong('It drives at 150 too', 'The program is the same, but each node has its own parameters.'),
        right('It keeps its own speed', 'A parameter lives in one node.'),
        wrong('It does after a restart', 'A restart brings back the default. What you set on one node does not reach '
              'the other.')),
           chapter='1', section='Two robots of one class'),
)

PREDICTIONS = (
    Prediction('4-1', 'You took the object `parameter` when the speed was 100. Then a client set the speed to 150. '
               'What is `parameter.value` now?', (
        right('100', 'The object of a number keeps the value that it had when you took it.'),
        wrong('150', 'The object is not connected with the node. To see 150, ask the node again with `get_parameter`.'),
        wrong('None', 'The object does not learn that it is out of date. It keeps the value that it had when you took '
              'it.'))),
    Prediction('4-2', 'The courier has driven its route once, and nobody has set `stops`. What does a client get for '
               '`stops` now?', (
        wrong("['dock', 'shelf', 'door']", 'Nobody has sent a request. But the method took the stops off a list, and '
              "for an array `.value` is the node's own list."),
        right('[], the empty list', '`.value` is the list that the node holds, so `pop` changed the parameter itself.'),
        wrong("['door'], the last stop", 'The loop takes stops off until the list is empty, and that list is the '
              "node's own."))),
    Prediction('4-3', 'This courier copies the list before it takes stops off it. It has driven its route once. What '
               'does a client get for `stops` now?', (
        wrong('[], the empty list', 'Its loop has emptied a list, but that was the copy. The list that the node holds '
              'was never touched.'),
        right("['dock', 'shelf', 'door']", 'No trick here: a copy is a list of its own, and the node still holds all '
              'three stops.'),
        wrong("['door'], the last stop", 'The loop takes all stops off the copy, and none off the list that the node '
              'holds.'))),
    Prediction('4-4', '`get_parameter_or` has returned the fallback for `battery_volts`. What does '
               "`has_parameter('battery_volts')` return now?", (
        wrong('True', '`get_parameter_or` stores nothing. To create the parameter, the node would have to declare it.'),
        right('False', 'The fallback was used once and stored nowhere. The parameter still does not exist.'))),
    Prediction('4-5', 'The node declares `calibration` as a double, without a value. What does `get_parameter` do?', (
        wrong('It returns the value 0.0', 'A type brings no default with it, not even zero. This parameter has no '
              'value.'),
        wrong('It returns the value None', 'A node could easily overlook a None. rclpy raises an exception instead.'),
        right('It raises an exception', 'It is a `ParameterUninitializedException`: the parameter exists, but it has '
              'no value.'))),
    Prediction('4-6', 'Both robots have accepted 150. The first copied the parameter when it started, the second reads '
               'it each time. At which speeds do they drive?', (
        wrong('both at 150', 'Accepting a value and acting on it are two things. The first still uses its copy.'),
        right('100 and 150', 'The first still uses its copy, although its parameter says 150.'),
        wrong('both at 100', 'The second reads its parameter ten times a second. It needs no restart.'))),
    Prediction('4-7', 'The override is `-p max_speed_rpm:=fast`, and the default is the integer 100. What does the '
               'node do?', (
        wrong('It starts with 100', 'rclpy does not ignore a wrong override. The declaration raises an exception, '
              'which ends the constructor.'),
        wrong("It starts with 'fast'", 'The default has decided that the parameter is an integer, and that holds for '
              'an override too.'),
        right('It does not start', 'The declaration raises `InvalidParameterTypeException`, which ends the '
              'constructor.'))),
)
