"""Predictions of chapter 3: what a declaration settles."""

from param_tutorial.exercises.prediction import Prediction, Scale, right, wrong

SOLVED = 'Your driver declares what it means, and drives.'

RECALLS = ()

PREDICTIONS = (
    Prediction('3-1', 'Your node will declare one parameter. How many names does `ros2 param list` show for it?', (
        right('3', 'rclpy declares two more in every node: `start_type_description_service` and `use_sim_time`.'),
        wrong('1', 'That is the one that you have declared. rclpy declares two more in every node.'),
        wrong('2', 'Nearly: rclpy declares two more in every node, so there are three.')),
        otherwise='It shows three: the one that you have declared, and two that rclpy declares in every node.'),
    Prediction('3-2', 'The parameter is a double, 0.5. What does the node do with the whole number `1`?', (
        wrong('It stores the double 1.0', 'Python would convert; ROS does not. `1` is an integer, and the node expects '
              'a double.'),
        wrong('It stores the integer 1', 'The default has decided the type for good. No later value changes it.'),
        right('It rejects the value', 'An integer is not a double, and ROS does not convert. The second cell below '
              'adds a dot.'))),
    Prediction('3-3', 'The constructor declares a name again, with another default. What happens?', (
        wrong('The second default counts', 'To declare is to create, not to set. You cannot create a name that '
              'exists.'),
        wrong('The first default counts', 'rclpy does not pass over it. It raises '
              '`ParameterAlreadyDeclaredException`.'),
        right('The constructor fails', 'rclpy raises `ParameterAlreadyDeclaredException`, and there is no such '
              'node.'))),
    Prediction('3-4', 'The range of `alarm_c` is -20 to 50, and its description asks for less than zero. `calibration` '
               'is a double without a value. The requests are 51, 50, and the word `rough`. Which are accepted?', (
        wrong('None of the three', '50 is the end of the range, and both ends are valid. The sentence in the '
              'description enforces nothing.'),
        right('50 and no other', 'Both ends of a range are valid. The word contradicts the type, which is settled even '
              'without a value.'),
        wrong('50 and `rough`', 'There is no value yet, but there is a type, and the node checks every value against '
              'it.'),
        wrong('`rough` and no other', '50 is the end of the range, and both ends are valid. The word contradicts the '
              'type.'))),
    Prediction('3-5', 'The range is 0 to 100, and the default is 120. With which value does the node start?', (
        wrong('With 120', 'A range is enforced from the first value on, and the default is the first value.'),
        wrong('With 100', 'A range does not correct a value. The node accepts it or rejects it.'),
        right('It does not start', 'The declaration raises `InvalidParameterValueException`: the default is out of '
              'range.'))),
    Prediction('3-6', 'The robot drives with 0.5 m/s. The panel sets `max_speed_mps` to 2.0. Which speed does your '
               'driver command then, in m/s?', (
        right('0.5', 'The constructor has looked at the parameter once, and kept a copy.'),
        wrong('2.0', 'The node holds 2.0, and the driver still uses the copy that its constructor made.')),
        scale=Scale(0, 2, 0.1, 'm/s'),
        otherwise='It still commands 0.5: the constructor has looked at the parameter once, and kept a copy.'),
)
