"""Predictions of chapter 2: from a folder to a node that can be started."""

from param_tutorial.exercises.prediction import Prediction, right, wrong

SOLVED = 'You have been `ros2 run` yourself, so it has few secrets left.'

RECALLS = ()

PREDICTIONS = (
    Prediction('2-1', 'The build has succeeded, and `install` holds the package. What does `ros2 run param_tutorial …` '
               'say in this terminal?', (
        wrong('It starts the node', 'There is no node in the package yet, and this terminal does not even know of the '
              'package.'),
        wrong('There is no executable', 'That will be the second answer. So far, this terminal does not know where to '
              'look for packages.'),
        right('There is no such package', 'The package is built, but nobody has told this terminal where to look.'))),
    Prediction('2-2', 'The second terminal has sourced the workspace. The first one built the package, and has not '
               'sourced anything. What does `ros2 run` say there now?', (
        wrong('The same as in the second', 'Sourcing changes the environment of one terminal. Nothing is registered '
              'for the others.'),
        right('The package is not found', 'Sourcing changes the environment of one terminal, and of what you start '
              'from it.'),
        wrong('Only the build is found', 'A build writes files. It changes nothing in the environment of its '
              'terminal.'))),
    Prediction('2-3', 'The last line of `data_files` asks for a file `param_tutorial` beside `setup.py`, where there '
               'is only a folder of that name. What does colcon say?', (
        wrong('It copies the folder', 'An entry of `data_files` names files. A folder is not a regular file, and the '
              'build fails.'),
        wrong('It builds, with a warning', 'There is a warning too, but it is about the marker. The missing file is an '
              'error.'),
        right('It stops, with an error', "`can't copy`: setuptools finds no such file, and the build fails."))),
    Prediction('2-4', 'The source says *second version* now, and nothing else was done. Which version starts?', (
        right('the first version', '`ros2 run` starts the copy in the install space, and no build has renewed that '
              'copy.'),
        wrong('the second version', 'What runs is the copy in the install space, not the file that you edit. A build '
              'makes the copy.'),
        wrong('neither version', 'Nothing compares the two files. The old copy starts, without a warning.'))),
    Prediction('2-5', 'You want to build only the package that you have edited, and type '
               '`colcon build --packages-select simple_param_node`. What does colcon do?', (
        wrong('It builds the package of the node', 'colcon knows packages, not nodes or executables. No package has '
              'this name, so nothing is built.'),
        wrong('It fails with an error', 'It only warns. The exit status is 0, so a script that runs it goes on as if '
              'all were well.'),
        right('It builds nothing, and succeeds', 'No package has this name. colcon warns, finishes 0 packages, and '
              'exits with 0.'))),
    Prediction('2-6', 'The workspace was built with `--symlink-install`. Since then, the node has been changed to read '
               'its text from a new file, which says *third version*. Nothing has been rebuilt. Which version '
               'starts?', (
        wrong('the second version', 'That version would be in a copy. With `--symlink-install`, Python follows links '
              'to the source.'),
        right('the third version', 'This time you get what you wrote: there is no copy. The link leads to the folder '
              'in `src`, with all that is in it.'),
        wrong('neither of the two', 'The link leads to the folder, not to single files. Python finds whatever you put '
              'into the folder.'))),
    Prediction('2-7', 'The list has the overlay first and its underlay after it. Which version starts?', (
        right('the fourth, from the overlay', 'First in the list, first found: the first folder that has the package '
              'decides, and that is the overlay.'),
        wrong('the third, from the underlay', 'The underlay was sourced first, but it stands last in the list. The '
              'search ends at the first folder that has the package.'),
        wrong('none, and an error message', 'Nothing counts the packages. The search ends at the first folder that has '
              'one of this name.'))),
)
