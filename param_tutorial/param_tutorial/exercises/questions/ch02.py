"""Predictions of chapter 2: from a folder to a program that can be started."""

from param_tutorial.exercises.prediction import Prediction, right, wrong

SOLVED = 'Your package is built, and you know which copy of it runs.'

RECALLS = ()

PREDICTIONS = (
    Prediction('2-1', 'The build has succeeded, and `install` holds the package. What does `ros2 run my_robot '
               'driver_node` do in the terminal that built it?', (
        wrong('It starts the program', 'The program is there, but nobody has told this terminal where to look.'),
        wrong('It finds no executable', 'It does not get that far: this terminal does not even know of the package.'),
        right('It finds no package', 'The package is built, but nobody has told this terminal where to look.'))),
    Prediction('2-2', 'The runner has sourced `install/setup.bash`, and starts the program. In how many of the two '
               'terminals does `ros2 run my_robot driver_node` work now?', (
        right('1', 'Sourcing changes the environment of one terminal, and of what you start from it.'),
        wrong('2', 'Sourcing changes the environment of one terminal. Nothing is registered for the others.'),
        wrong('0', 'The runner has just started it. The builder has not sourced anything.')),
        otherwise='It works in one of the two, the one that has sourced the workspace.'),
    Prediction('2-3', 'The program comes from the file `driver_node.py`. What does `ros2 run my_robot driver_node.py` '
               'do?', (
        wrong('It runs the file in `src`', '`ros2 run` never looks into `src`. It looks in `lib/my_robot` of the '
              'install space.'),
        right('It finds no such program', 'In `lib/my_robot` there is a `driver_node`, without an ending.'),
        wrong('It runs the copy of the file', 'The copy is in `site-packages`. `ros2 run` looks in `lib/my_robot`, '
              'and for a program.'))),
    Prediction('2-4', 'The file in `src` says *Hello*, and nothing else was done. What does `ros2 run my_robot '
               'driver_node` print?', (
        wrong('Hello from my_robot.', 'What runs is the copy in the install space, not the file that you edit. A '
              'build makes the copy.'),
        right('Hi from my_robot.', '`ros2 run` starts the copy in the install space, and no build has replaced it.'),
        wrong('Nothing but an error', 'Nothing compares the two files. The old copy starts, without a warning.'))),
    Prediction('2-5', 'You want to build only the package that you have edited, and type `colcon build '
               '--packages-select driver_node`. How many packages does colcon finish?', (
        right('0', '`driver_node` is a program, and no package has this name. colcon warns, and exits with 0.'),
        wrong('1', 'colcon knows packages, not programs. No package has this name, so it builds nothing.')),
        otherwise='None: `driver_node` is a program, and no package has this name.'),
)
