"""Predictions of chapter 2: from a folder to a node that can be started."""

from param_tutorial.exercises.prediction import Prediction, right, wrong

SOLVED = 'You have been `ros2 run` yourself, so it has few secrets left.'

RECALLS = ()

PREDICTIONS = (
    Prediction('2-1', 'The build has succeeded, and `install` holds the package. What does '
               '`ros2 run param_tutorial …` say in this terminal?', (
        wrong('It starts the node', 'There is no node in the package yet, and the terminal does not even know of the '
              'package.'),
        right('The package is not found', 'A package that is built is not found yet: this terminal was never told '
              'where to look.'),
        wrong('The package is found, but no executable', 'That will be the second answer. For now the terminal does '
              'not know where to look for packages.'))),
    Prediction('2-2', 'The first terminal has sourced the workspace. The second is in the same folder, and has not. '
               'What does `ros2 run` say there?', (
        wrong('The same as in the first: the workspace is known now', 'Sourcing changes the environment of one '
              'terminal. Nothing is registered for the others.'),
        right('The package is not found', 'Sourcing changes the environment of one terminal, and of what it starts.'),
        wrong('It is found, because this is the folder of the workspace', '`ros2 run` does not look at the folder in '
              'which you are. It searches `AMENT_PREFIX_PATH`.'))),
    Prediction('2-3', 'The last line of `data_files` asks for a file `param_tutorial` beside `setup.py`, where there '
               'is only a folder of that name. What does colcon say?', (
        wrong('It copies the folder', 'An entry of `data_files` names files. The folder is no regular file, and the '
              'build ends.'),
        wrong('It builds, with a warning', 'There is a warning too, and it is about the marker. The missing file is an '
              'error.'),
        right('The build fails', "`can't copy`: setuptools finds no such file, and the build ends."))),
    Prediction('2-4', 'The source says *second version* now, and nothing else was done. Which version starts?', (
        right('the first', '`ros2 run` starts the copy in the install space, and the build that makes the copy has '
              'not been run.'),
        wrong('the second', 'What runs is the copy in the install space, not the file that you edit. The copy is made '
              'by a build.'),
        wrong('none: ROS notices that the build is out of date', 'Nobody compares the two files. The old copy starts, '
              'without a warning.'))),
    Prediction('2-5', 'The workspace was built with `--symlink-install`. The source says *third version* now, and '
               'nothing was built since. Which version starts?', (
        wrong('the second', 'That would be a copy. With `--symlink-install` Python is led back to the source.'),
        right('the third', 'There is no copy. Python is led back to the source, as it is when the node starts.'),
        wrong('none: the link is out of date', 'A link leads to a place, not to a version. It finds whatever stands '
              'there now.'))),
)
