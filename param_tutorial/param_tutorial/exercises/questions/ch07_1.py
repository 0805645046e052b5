"""Predictions of chapter 7.1: what a file brings back."""

from param_tutorial.exercises.prediction import Prediction, Recall, Scale, right, wrong

SOLVED = 'Your robot keeps what you have tuned, and you know which programs to distrust on the way.'

RECALLS = (
    Recall('7.1-r1', 'Your driver starts with overrides for both `max_speed_mps` and `stop_distance_m`. The speed '
           'alone would break the rule, and together they keep it. What does the driver do?', (
        right('It starts', 'The constructor judges once, after all declarations, so it sees both new values.'),
        wrong('It fails', 'The constructor judges once, after all declarations. By then both values are there.')),
           chapter='5.2', section='Who judges the start?'),
    Recall('7.1-r2', 'The parameter `label` is a string. What do you type after `ros2 param set /gripper label` to set '
           'it to the string 42?', (
        wrong('42', 'YAML reads a number, and the node rejects it.'),
        wrong("'42'", 'The shell removes these quotes, and YAML reads a number.'),
        right('"\'42\'"', 'The shell removes one pair of quotes, and YAML the other.')),
           chapter='5.1', section='Which type did you mean?'),
)

PREDICTIONS = (
    Prediction('7.1-1', '`tuned.yaml` holds all six parameters of the driver. How many of the six does `ros2 param '
               'load` set in a driver that has just started?', (
        right('4', 'Two are read-only, and the node rejects them even with the value that they already have.'),
        wrong('6', 'Two are read-only. The node rejects them even with the value that they already have.'),
        wrong('5', 'One fewer. Besides `rate_hz`, `start_type_description_service` is read-only.'),
        wrong('3', 'The command sets every parameter in the file, whether its value is new or not. The node rejects '
              'only the two that are read-only.')),
        otherwise='It sets four. The node rejects the two read-only ones, although they already have that value.'),
    Prediction('7.1-2', 'The driver holds 0.5 m/s and 0.5 m, and gets a file with `max_speed_mps: 1.2` and, below '
               'that, `stop_distance_m: 1.0`. What is `max_speed_mps` after `ros2 param load`?', (
        right('0.5', 'The speed comes first, and is judged with the old stop distance. Half a meter is too little.'),
        wrong('1.2', 'Together they keep the rule, but the node judges each value alone, and the speed comes first.'),
        wrong('1.0', 'The node takes the value as it is, or rejects it.')),
        scale=Scale(0, 2, 0.1, 'm/s'),
        otherwise='It stays 0.5. The node judges each value alone, and the speed comes before the stop distance.'),
    Prediction('7.1-3', 'The file says `label: 1e5`, without quotes. What happens to a courier that starts with it?', (
        wrong('Its label is 1e5', 'That is what the writer meant. But rcl reads the file by its own rules, and to rcl '
              '`1e5` is a number.'),
        wrong('Its label is 100000.0', 'rcl does read that number. But the node declares a string, and ROS converts '
              'nothing.'),
        right('It does not start', 'rcl reads a double, the node declares a string, and the constructor ends with an '
              'exception.'))),
    Prediction('7.1-4', '`ros2 param dump` writes four strings, and rcl reads them at a start. Which one comes back as '
               'something else?', (
        right('inf', 'To the command it is an ordinary string, so it gets no quotes. To rcl it is a double, infinity.'),
        wrong('on', 'The command puts quotes around it, because by its own rules `on` means true. So it comes back.'),
        wrong('1.0', 'The command puts quotes around it, because it looks like a double. So it comes back.'),
        wrong('12:30', 'The command puts quotes around it, because without them it would be 750. So it comes back.'))),
    Prediction('7.1-5', "The file says `label: '1.0'`, in quotes, and the node declares a string. What does "
               '`ros2 param load` do with that line?', (
        wrong('It asks for the string 1.0', 'The first reading removes the quotes. Then `load` guesses the type again, '
              'and gets a double.'),
        right('It asks for the double 1.0', '`load` reads the file, turns each value into text, and guesses again. '
              "Quotes don't survive that, and the node rejects the double."))),
    Prediction('7.1-6', "The file says `stops: []`, and the default is ['dock']. What does the node get when it reads "
               '`stops`?', (
        wrong('an empty list', "An empty array in a file has no type, so it isn't a value either."),
        right('an exception', 'The empty array takes the default away and puts nothing in its place.'),
        wrong("['dock']", 'The file takes the default away, and puts nothing in its place.'))),
    Prediction('7.1-7', 'Since last night `saved.yaml` holds a force and a calibration. Now the calibration is not '
               'set, and the script runs `ros2 param dump /gripper > saved.yaml` again. How many values are in the '
               'file then?', (
        right('0', 'One parameter without a value, and the dump is empty. The exit status is 0, and nobody notices '
              "until last night's values are needed."),
        wrong('2', "Last night's are gone: the dump does not fail, and writes an empty file over them. And there is no "
              'null for the value that is not set.'),
        wrong('3', 'None, not even the two of every node. If one value is not set, the node answers with nothing.'),
        wrong('1', 'None. A node that is asked for several values answers with nothing at all if one of them is not '
              'set.')),
        otherwise='None. One parameter without a value, and the dump is empty. Its exit status is 0 all the same.'),
)
