"""Predictions of chapter 7.2: what a launch file starts, and with which values."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'Your robot starts with its own values every time, and you would notice if it did not.'

RECALLS = (
    Recall('7.2-r1', 'In a parameter file, what stands between the name of the node and its parameters?', (
        wrong('parameters:', 'That is the word of a launch file. In a parameter file it is `ros__parameters:`.'),
        right('ros__parameters:', 'With two underscores, on a level of its own.'),
        wrong('nothing: they follow on the next level', 'rcl does not read such a file. It wants a level '
              '`ros__parameters:` in between.')),
           chapter='7.1', section='The format'),
    Recall('7.2-r2', 'A node declares `max_speed_rpm` with the default 100, and is started with `-p '
           'max_speed_rpm:=120`. What does it read in its constructor, right after the declaration?', (
        wrong('100: the override comes later', 'An override takes the place of the default while the parameter '
              'is being declared. There is no later.'),
        right('120', 'The override takes the place of the default in the declaration itself.')),
           chapter='4', section='Which value does a node start with?'),
)

PREDICTIONS = (
    Prediction('7.2-1', 'The file says AlphaClaw, 180 rpm, safety off. The dictionary after it says 200 rpm, safety '
               'on. The defaults are Clawbot, 100 rpm, safety on. How does the robot start?', (
        wrong('Clawbot, 200 rpm, safety on', 'A dictionary does not replace the file. Each parameter has the last '
              'value that was given for it.'),
        right('AlphaClaw, 200 rpm, safety on', 'Each parameter has the last value that was given for it: the name from '
              'the file, the rest from the dictionary.'),
        wrong('AlphaClaw, 180 rpm, safety off', 'The dictionary comes later in the list, and here the later source '
              'wins.'))),
    Prediction('7.2-2', 'The launch is given `robot_name:=42`, and the file says '
               '`ParameterValue(…, value_type=str)`. What is the name of the robot?', (
        wrong('The integer 42, so the node does not start', 'It would be so without `ParameterValue`. With '
              '`value_type=str` the text stays a text.'),
        right('The text 42', 'With `value_type=str` the text of the command line stays a text.'),
        wrong('Clawbot: a number is no name, so the default stays', 'A launch never falls back to a default. It hands '
              'on what was given, here as a text.'))),
    Prediction('7.2-6', '`SetParameter` gives 50 rpm. Anna comes before it, Berta after it, and the third robot, after '
               'both, also has the file with 180 rpm. How many of the three start with 50?', (
        right('1', 'Only Berta. Anna comes too early, and the file covers the value for the third robot.'),
        wrong('2', 'The file covers the value for the third robot: `SetParameter` comes before everything in '
              '`parameters`.'),
        wrong('3', 'Anna comes before `SetParameter`, and it reaches only what comes after it. The file covers the '
              'value for the third robot.'),
        wrong('0', 'Berta does: she comes after `SetParameter`, and nothing covers the value for her.')),
        otherwise='One: Berta. Anna comes too early, and the file covers the value for the third robot.'),
    Prediction('7.2-3', 'The folder `launch/` lies in the package in `src`, the `setup.py` does not mention it, and '
               'the build has succeeded. What does `ros2 launch` say?', (
        wrong('It starts the robot', '`ros2 launch` looks into the install space only, and nothing has installed the '
              'file.'),
        right('The file was not found', 'Nothing has installed it. A build takes what `setup.py` names, and no more.'),
        wrong('It starts the robot, without its parameters', 'It would need the launch file to start anything, and '
              'that is not in the install space.'))),
    Prediction('7.2-4', 'The launch file is installed now, and the parameter file that it names is not. Does the robot '
               'start?', (
        wrong('No: a file is missing', 'For a launch, a missing parameter file is a warning and no error.'),
        right('Yes, with its defaults', 'A missing parameter file is a warning, one line above the others. The robot '
              'drives with its defaults.'),
        wrong('Yes, with the values of the file in src', 'Nobody looks into `src`. The file is not in the install '
              'space, so its values are nowhere.'))),
    Prediction('7.2-5', 'The first line of the file is `/simple_param_node:`, and it names the robot AlphaClaw. A node '
               'called `other_robot` starts with it. What is its name afterwards?', (
        wrong('AlphaClaw: it was given the file', 'A file is read for the node that it names. For this one it holds '
              'nothing.'),
        right('Clawbot: the file is passed over', 'The file is for another node. It is passed over in silence.'),
        wrong('There is none: the node does not start', 'No error, and not even a warning: what is for another node is '
              'passed over in silence.'))),
)
