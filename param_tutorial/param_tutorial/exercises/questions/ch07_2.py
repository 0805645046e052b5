"""Predictions of chapter 7.2: what a launch types, what a build installs, and which values arrive."""

from param_tutorial.exercises.prediction import Prediction, Recall, Scale, right, wrong

SOLVED = 'Your robot starts with its own values every time, and if it did not, you would notice.'

RECALLS = (
    Recall('7.2-r1', 'In a parameter file, what is between the name of the node and its parameters?', (
        right('ros__parameters:', 'With two underscores, on a level of its own.'),
        wrong('parameters:', 'That is the word in a launch file. In a parameter file it is `ros__parameters:`.'),
        wrong('nothing at all', 'rcl rejects such a file. There has to be a level `ros__parameters:` in between.')),
           chapter='7.1', section='The format'),
    Recall('7.2-r2', 'You edit your program in `src`, and start it with `ros2 run` in a terminal that has sourced the '
           'workspace. Which code runs?', (
        wrong('that of the edited file', 'The file in `src` is what you edit. What runs is its copy in the install '
              'space, until you build again.'),
        right('that of the last build', 'What runs is the copy in the install space, and a build replaces it.')),
           chapter='2', section='Edit it, and run it'),
)

PREDICTIONS = (
    Prediction('7.2-1', '`parameters` lists a file and a dictionary. How many parameter files are on the command '
               'line?', (
        right('2', 'The launch writes the dictionary into a file of its own, and names both in the order of the list.'),
        wrong('1', 'The dictionary becomes a file as well: the launch writes it, and names both.'),
        wrong('0', 'The launch names both: your file, and one that it has written for the dictionary.')),
        otherwise='There are two: your file, and one that the launch has written for the dictionary.'),
    Prediction('7.2-2', 'Your launch file is in `src`, the build has succeeded, and the terminal has sourced the '
               'workspace. What does `ros2 launch` do?', (
        wrong('It starts the driver with your file', '`ros2 launch` looks in the install space, and nothing has '
              'installed the launch file there.'),
        right('It does not find the launch file', 'A build installs what `setup.py` lists, and the launch file is not '
              'in that list.'),
        wrong('It starts it with its defaults', 'Without the launch file it starts nothing, and that file is not '
              'in the install space.'))),
    Prediction('7.2-3', 'The launch file is installed, and the parameter file that it names is gone. With which '
               '`max_speed_mps` does the driver start? Type 0 if you think that it does not start.', (
        right('0.5', 'That is the default in its code. A plain path that leads nowhere is only a warning.'),
        wrong('0', 'It starts, with its default of 0.5 m/s: a plain path that leads nowhere is only a warning.'),
        wrong('0.8', 'That stands in the file in `src`, where nothing looks. The driver starts with its default of '
              '0.5 m/s.')),
        otherwise='It starts with 0.5, the default in its code.'),
    Prediction('7.2-4', 'The launch file says `ParameterFile(…, allow_substs=True)`, and you give it a path that leads '
               'nowhere. What happens?', (
        wrong('The driver starts with its defaults', 'The launch has to read the file, to replace what is in it. It '
              'cannot, and ends.'),
        wrong('The driver starts with the usual file', 'That is the default of the argument, and counts only if you '
              'give no other path.'),
        right('The launch ends with an error message', 'It has to read the file itself, to replace what is in it.'))),
    Prediction('7.2-5', 'The launch file says `ParameterValue(…, value_type=str)`, and you give `robot_name:=42`, then '
               '`robot_name:=1e5`. With which of them does the robot start?', (
        wrong('with both of these names', '42 stays a string. `1e5` is written into a file without quotes, and rcl '
              'reads it as a number.'),
        right('only with the name 42', '`1e5` is written into a file without quotes, and rcl reads it as a number.'),
        wrong('only with the name 1e5', '`value_type=str` keeps 42 a string, and `1e5` loses its quotes on the way.'))),
    Prediction('7.2-6', '`SetParameter` gives `use_sim_time` to the driver, and nothing publishes on `/clock`. How '
               'fast does the robot drive, in m/s?', (
        right('0', 'Time stands still for the driver. Its timer never fires, so it sends no command.'),
        wrong('0.5', 'The driver holds this value, and sends no command: its timer never fires.'),
        wrong('0.8', 'This launch file names no parameter file. And the driver sends no command at all: its timer '
              'never fires.')),
        scale=Scale(0, 1, 0.1, 'm/s'),
        otherwise='It stands still: the timer of the driver never fires.'),
)
