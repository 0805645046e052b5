"""Predictions of chapter 7.2: what a launch file starts, and with which values."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'Your robot starts with its own values every time, and if it did not, you would notice.'

RECALLS = (
    Recall('7.2-r1', 'In a parameter file, what is between the name of the node and its parameters?', (
        right('ros__parameters:', 'With two underscores, on a level of its own.'),
        wrong('parameters:', 'That is the word in a launch file. In a parameter file it is `ros__parameters:`.'),
        wrong('nothing at all', 'rcl rejects such a file. There has to be a level `ros__parameters:` in between.')),
           chapter='7.1', section='The format'),
    Recall('7.2-r2', 'A node declares `max_speed_rpm` with the default 100, and you start it with '
           '`-p max_speed_rpm:=120`. What does it read in its constructor, right after the declaration?', (
        right('120', 'The override replaces the default in the declaration itself.'),
        wrong('100', 'The override replaces the default while the parameter is being declared. There is no later.')),
           otherwise='It reads 120. The override replaces the default in the declaration itself.',
           chapter='4', section='Which value does a node start with?'),
)

PREDICTIONS = (
    Prediction('7.2-1', 'The file says AlphaClaw, 180 rpm, safety off. The dictionary after it says 200 rpm, safety '
               'on. The defaults are Clawbot, 100 rpm, safety on. How does the robot start?', (
        wrong('Clawbot, 200 rpm, safety on', 'A dictionary does not replace the file. Each parameter has the last '
              'value that it was given.'),
        right('AlphaClaw, 200 rpm, safety on', 'As the list suggests: each parameter has the last value that it was '
              'given. The name comes from the file, the rest from the dictionary.'),
        wrong('AlphaClaw, 180 rpm, safety off', 'The dictionary comes later in the list, and of these two sources the '
              'later one wins.'))),
    Prediction('7.2-2', 'You give the launch `robot_name:=42`, and the launch file says '
               '`ParameterValue(…, value_type=str)`. What is the name of the robot?', (
        right('It is the string 42', '`value_type=str` does what it says, and keeps 42 a string.'),
        wrong('It is the integer 42', 'That would happen without `ParameterValue`, and the node would not start. '
              '`value_type=str` keeps 42 a string.'),
        wrong('It is still Clawbot', 'A launch passes on what you gave it, here as a string. It does not fall back to '
              'the default.'))),
    Prediction('7.2-3', '`SetParameter` gives 50 rpm. Anna comes before it, Berta after it, and the third robot, after '
               'both, also has the file with 180 rpm. How many of the three start with 50?', (
        right('1', 'Only Berta. Anna comes too early, and the file hides the value for the third robot.'),
        wrong('2', 'The file hides the value for the third robot: `SetParameter` comes before everything in '
              '`parameters`.'),
        wrong('3', '`SetParameter` reaches only what comes after it, so not Anna. And the file hides the value for '
              'the third robot.'),
        wrong('0', 'Berta does: she comes after `SetParameter`, and nothing hides the value for her.')),
        otherwise='One: Berta. Anna comes too early, and the file hides the value for the third robot.'),
    Prediction('7.2-4', 'The folder `launch/` is in the package in `src`, the `setup.py` does not mention it, and the '
               'build has succeeded. What does `ros2 launch` do?', (
        wrong('It starts the robot with its file', '`ros2 launch` looks only in the install space, and nothing has '
              'installed the file there.'),
        wrong('It starts the robot with defaults', 'Without the launch file it can start nothing, and that file is not '
              'in the install space.'),
        right('It does not find the launch file', 'Nothing has installed it. A build installs only what `setup.py` '
              'lists.'))),
    Prediction('7.2-5', 'The launch file is installed now, but the parameter file that it names is not. Does the robot '
               'start?', (
        right('Yes, with its defaults', 'A missing parameter file is a warning, one line above the others. The robot '
              'drives with its defaults.'),
        wrong('No, the launch fails', 'To a launch, a missing parameter file is a warning, not an error.'),
        wrong('Yes, with the file in src', 'Nothing looks in `src`. The file is not in the install space, so nobody '
              'reads its values.'))),
    Prediction('7.2-6', 'The key at the top of the file is `/simple_param_node`, and below it the robot is named '
               'AlphaClaw. A node called `other_robot` starts with the file. What is its `robot_name`?', (
        wrong('AlphaClaw, from the file', 'A file is for the node that it names. It holds nothing for this one.'),
        wrong('none, it does not start', 'There is no error, and not even a warning: the node ignores values for '
              'another node.'),
        right('Clawbot, from the program', 'The file is for another node, so this one ignores it without a word.'))),
)
