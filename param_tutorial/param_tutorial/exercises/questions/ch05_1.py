"""Predictions of chapter 5.1: what a terminal asks, and what the node answers."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'A dot, a quote, a pair of quotes: you spell values so that they arrive.'

_ONE = 'Only 0.75. `1` and `42` are integers, and `2.0` is a double. The gripper converts none of them.'

RECALLS = (
    Recall('5.1-r1', 'A parameter is described as “below zero, please”, and its range goes from -20 to 50. Someone '
           'sets it to 30. What does the node do?', (
        wrong('It rejects the value', 'A description is for people, and 30 is in the range.'),
        right('It stores the value', 'The range decides, and 30 is in it. A description enforces nothing.'),
        wrong('It stores a zero', 'A node does not correct a value. It accepts it or rejects it.')),
           chapter='3', section='Limits'),
    Recall('5.1-r2', 'A program is started with `--ros-args -p max_speed_mps:=1.5`, and its file declares a default of '
           '0.5. With which value does it begin?', (
        wrong('With 0.5', 'The words after `--ros-args` give the parameter another first value.'),
        wrong('With none', 'It has a value from the first moment on: the one after `-p`.'),
        right('With 1.5', 'The words after `--ros-args` override the default.')),
           chapter='3', section='Start it'),
)

PREDICTIONS = (
    Prediction('5.1-1', 'A terminal sets `max_speed_mps` to 0.6, and the node accepts. What does the driver log?', (
        wrong('A line with the new value', 'A node logs what its program tells it to log. Yours has no such line.'),
        wrong('A line with the old value', 'A node logs what its program tells it to log. Yours has no such line.'),
        right('No line about that value', 'The node has stored the value, and nothing in your file logs that.'))),
    Prediction('5.1-2', '`tolerance_m` is a double, `retries` an integer, and `label` a string. How many of these four '
               'are accepted: 0.75 and 1 for `tolerance_m`, 2.0 for `retries`, 42 for `label`?', (
        right('1', _ONE), wrong('0', _ONE), wrong('2', _ONE), wrong('3', _ONE), wrong('4', _ONE)),
        otherwise=_ONE),
    Prediction('5.1-3', '`retries`, an integer, is 3. You set it to `12:30`. What does it hold then?', (
        wrong('It is still 3', 'The gripper does not reject it: YAML 1.1 reads a number in base 60.'),
        wrong('It is now 12', 'YAML 1.1 does not stop at the colon. It reads 12 times 60 plus 30.'),
        right('It is now 750', '12 times 60 plus 30: YAML 1.1 reads numbers in base 60.'))),
    Prediction('5.1-4', 'The driver rejects 5.0. With which exit status does `ros2 param set` end?', (
        right('0', 'The command has sent the request, and printed the answer. It ends with 0 whatever that is.'),
        wrong('1', 'A rejection is an answer, and the command has printed it. It ends with 0.')),
        otherwise='It ends with 0: the command has sent the request, and printed the answer.'),
    Prediction('5.1-5', 'The first line below sets a misspelled parameter, and the second one gets it. With which exit '
               'status does the second one end?', (
        right('1', 'There is no value to print, so the command has failed.'),
        wrong('0', '`set` had an answer to print. `get` has no value to print, and ends with 1.')),
        otherwise='It ends with 1: there is no value to print.'),
    Prediction('5.1-6', 'The file says `1e0` for `max_speed_mps`, and `1.5` for `stop_distance_m`. What does `ros2 '
               'param load` set?', (
        wrong('Both of the values', '`load` guesses as `set` does: without a dot and a sign, `1e0` is a string.'),
        wrong('Only the first value', 'It is the other way around: without a dot and a sign, `1e0` is a string.'),
        right('Only the second value', '`load` guesses as `set` does: without a dot and a sign, `1e0` is a string.'),
        wrong('Neither of the two values', 'A rejected value does not keep the others out.'))),
    Prediction('5.1-7', 'The same file, and a driver that starts with it. Which value does its `max_speed_mps` have?', (
        right('1.0', 'To rcl, `1e0` is a number.'),
        wrong('0.5', 'That is the default. To rcl, `1e0` is a number, and it overrides the default.')),
        otherwise='It is 1.0: rcl reads the file at the start, and to rcl `1e0` is a number.'),
)
