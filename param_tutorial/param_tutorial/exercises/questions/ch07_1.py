"""Predictions of chapter 7.1: what a file brings back."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'What you save is what you get back, and you know which programs to distrust on the way.'

RECALLS = (
    Recall('7.1-r1', 'A double has an `integer_range` from 0 to 10. Someone sets it to 50.0. What does the node do?', (
        right('It accepts the value', 'rclpy ignores a range of the wrong kind.'),
        wrong('It rejects the value', 'rclpy ignores a range of the wrong kind. A double needs a '
              '`floating_point_range`.'),
        wrong('It has never started', 'rclpy does not compare the kind of a range with the type. It ignores this range '
              'without a word.')),
           chapter='6.1', section='A range that nobody enforces'),
    Recall('7.1-r2', 'The parameter `label` is a string. What do you type after `ros2 param set /gripper label` to set '
           'it to the string 42?', (
        wrong('42', 'YAML reads a number, and the node rejects it.'),
        wrong("'42'", 'The shell removes these quotes, and YAML reads a number.'),
        right('"\'42\'"', 'The shell removes one pair of quotes, and YAML the other.')),
           chapter='5.1', section='Which type did you mean?'),
)

PREDICTIONS = (
    Prediction('7.1-1', 'The file holds all nine parameters of the robot. How many of the nine does `ros2 param load` '
               'set on a fresh robot?', (
        right('7', 'Two are read-only, and the node rejects them even with the value that they already have.'),
        wrong('9', 'Two are read-only. The node rejects them even with the value that they already have.'),
        wrong('8', 'One fewer. Besides the serial number, `start_type_description_service` is read-only.'),
        wrong('3', 'The command sets every parameter in the file, whether its value is new or not. The node rejects '
              'only the two that are read-only.')),
        otherwise='It sets seven. The node rejects the two read-only ones, although they already have that value.'),
    Prediction('7.1-2', 'The file says `robot_name: 1e5`, without quotes. What happens to a robot that starts with '
               'it?', (
        wrong('Its name is 1e5', 'That is what the writer meant. But rcl reads the file by its own rules, and to rcl '
              '`1e5` is a number.'),
        wrong('Its name is 100000.0', 'rcl does read that number. But the node declares a string, and ROS converts '
              'nothing.'),
        right('It does not start', 'rcl reads a double, the node declares a string, and the constructor ends with an '
              'exception.'))),
    Prediction('7.1-3', '`ros2 param dump` writes four strings, and rcl reads them at a start. Which one comes back as '
               'something else?', (
        right('inf', 'To the command it is an ordinary string, so it gets no quotes. To rcl it is a double, infinity.'),
        wrong('on', 'The command puts quotes around it, because by its own rules `on` means true. So it comes back.'),
        wrong('1.0', 'The command puts quotes around it, because it looks like a double. So it comes back.'),
        wrong('12:30', 'The command puts quotes around it, because without them it would be 750. So it comes back.'))),
    Prediction('7.1-4', "The file says `version: '1.0'`, in quotes, and the node declares a string. What does "
               '`ros2 param load` do with that line?', (
        wrong('It asks for the string 1.0', 'The first reading removes the quotes. Then `load` guesses the type again, '
              'and gets a double.'),
        right('It asks for the double 1.0', '`load` reads the file, turns each value into text, and guesses again. '
              "Quotes don't survive that, and the node rejects the double."))),
    Prediction('7.1-5', "The file says `waypoints: []`, and the default is ['dock']. What does the node get when it "
               'reads `waypoints`?', (
        wrong('an empty list', "An empty array in a file has no type, so it isn't a value either."),
        right('an exception', 'The empty array takes the default away and puts nothing in its place.'),
        wrong("['dock']", 'The file takes the default away, and puts nothing in its place.'))),
    Prediction('7.1-6', 'Since last night `saved.yaml` holds a name, a speed and a calibration. Now the calibration is '
               'not set, and the script runs `ros2 param dump /uncalibrated > saved.yaml` again. How many values are '
               'in the file then?', (
        right('0', 'One parameter without a value, and the dump is empty. The exit status is 0, and nobody notices '
              "until last night's values are needed."),
        wrong('3', "Last night's are gone: the dump does not fail, and writes an empty file over them. And there is no "
              'null for the value that is not set.'),
        wrong('2', 'None. A node that is asked for several values answers with nothing at all if one of them is '
              'unset.')),
        otherwise='None. One parameter without a value, and the dump is empty. Its exit status is 0 all the same.'),
    Prediction('7.1-7', 'Names, numbers and booleans, and none of the strings that caused trouble: how many of the '
               'nine parameters differ between the two robots?', (
        right('0', 'A dump keeps ordinary values, also the read-only serial number: the second robot starts with the '
              'file. The traps of this chapter are exceptions. Test for them, and trust the rest.'),
        wrong('1', 'None. A read-only parameter cannot be set in a running robot. This robot starts with the file, and '
              'an override counts.'),
        wrong('2', 'None. Two are read-only, and cannot be set in a running robot. This robot starts with the file, '
              'and an override counts.')),
        otherwise='None. The robot starts with the file, so even its read-only parameters arrive. And the client '
                  'writes each double so that rcl reads the same double again.'),
)
