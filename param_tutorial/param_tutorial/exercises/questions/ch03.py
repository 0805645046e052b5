"""Predictions of chapter 3: what a declaration settles."""

from param_tutorial.exercises.prediction import Prediction, right, wrong

SOLVED = 'Your nodes declare what they mean, and no default will surprise you again.'

RECALLS = ()

PREDICTIONS = (
    Prediction('3-1', 'The node never declared `robot_name`. What does it get when it asks itself for the value?', (
        wrong('the value None', 'A parameter that is not declared is not an empty parameter. It does not exist, and '
              '`get_parameter` raises an exception.'),
        right('an exception', '`get_parameter` raises `ParameterNotDeclaredException`: the name does not exist.'),
        wrong("'Clawbot'", 'A parameter belongs to one node. What another node declares makes no difference to this '
              'one.'))),
    Prediction('3-2', 'The parameter is a double, 0.15. What does the node answer to the whole number `1`?', (
        wrong('It stores the double 1.0', 'Python would convert; ROS does not. `1` is an integer, and the node expects '
              'a double.'),
        wrong('It stores the integer 1', "The default has decided the type for good. Later values don't change it."),
        right('It rejects the integer 1', 'An integer is not a double, and ROS does not convert. The second cell below '
              'adds a dot.'))),
    Prediction('3-3', 'The constructor declares `robot_name` a second time, with another default. What happens?', (
        wrong('The second default counts', 'To declare is to create, not to set. You cannot create a name that '
              'exists.'),
        wrong('The first default counts', 'rclpy does not ignore it. It raises `ParameterAlreadyDeclaredException`.'),
        right('The constructor fails', 'rclpy raises `ParameterAlreadyDeclaredException`, and there is no such '
              'node.'))),
    Prediction('3-4', 'The range is 0 to 100, and the default is 120. What does the node do when it starts?', (
        wrong('It starts with 120', 'A range is enforced from the first value on, and the default is the first value.'),
        wrong('It starts with 100', 'A range does not correct a value. The node accepts it or rejects it.'),
        right('It does not start', 'The declaration raises `InvalidParameterValueException`: the default is out of '
              'range.'))),
    Prediction('3-5', 'The descriptor says integer, and the default is 0.5. Which type does `gain` get?', (
        wrong('the type integer', 'When you declare a parameter, rclpy overwrites the field `type` with the type of '
              'the default.'),
        right('the type double', 'The default decides. rclpy overwrites the field `type`, without a warning.'),
        wrong('none, it fails', 'It looks like a contradiction, but nothing compares the two. rclpy overwrites the '
              'field.'))),
    Prediction('3-6', '`calibration` is a double that is not set. What does the node answer to the word `rough`?', (
        wrong('It accepts it for once', 'There is no value yet, but there is a type, and the node checks every value '
              'against it.'),
        right('It rejects the word', 'Just as you would think: the declaration says double, and a word is none. The '
              'type counts from the declaration on, with or without a value.'),
        wrong('It becomes a string', "The declaration has fixed the type. A first value doesn't change it."))),
    Prediction('3-7', 'The description of `max_acceleration_mps2` says *Must be positive.* What does the node answer '
               'to -3.0?', (
        wrong('It rejects the value', 'A description is for people. Without a range or a callback, nothing enforces '
              'it.'),
        wrong('It accepts and warns', 'The node does not read its own descriptions, so it has nothing to warn about.'),
        right('It accepts the value', 'The sentence is for people. To enforce something, the node needs a range or a '
              'callback.'))),
)
