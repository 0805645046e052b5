"""Exercises of chapter 7.2: a launch file for the reader's driver, what a build installs of it, and its argument.

A check works on a copy of the package with other values in its parameter file: what a launch file says itself, or takes
from a path on this computer, comes to light.
"""

import contextlib
import re
from collections.abc import Mapping

from param_tutorial.exercises.exercise import Exercise
from param_tutorial.exercises.steps import (
    CONFIG,
    LAUNCH,
    PACKAGE,
    expect_installed,
    launch,
    needed_packages,
    package_xml,
    remark_elsewhere,
)
from param_tutorial.exercises.trial import NotYet, NoUse, Trial, expect, take_for_granted

CHAPTER = '07_2_launch_files'
TYPES = 'The command line that a launch types'
BUILD = 'What a build installs'
ARGUMENT = 'The file as an argument'
SPEED, STOP = 'max_speed_mps', 'stop_distance_m'
# What the parameter file of the copy says, and another one, for a launch with an argument.
IN_PACKAGE, GIVEN = {SPEED: 0.65, STOP: 0.75}, {SPEED: 0.35, STOP: 0.45}


def parameter_file(values: Mapping[str, float]) -> str:
    """Return the text of a parameter file for the driver."""
    return '\n'.join(['/driver:', '  ros__parameters:', *(f'    {name}: {value}' for name, value in values.items())])


OURS = parameter_file(IN_PACKAGE)


def expect_start(trial: Trial, values: Mapping[str, float], because: str, given: str | None = None) -> None:
    """Expect the driver to start with some values.

    :param because: What to think of if it starts with others.
    :param given: As in ``launch``.
    """
    launched = launch(trial, OURS, given)
    driver = launched.start(trial)
    for name, value in values.items():
        found = driver.get_parameter(name).value
        remark = '. '.join(['', *launched.warnings]) or f'. {because}'
        expect(found == value, f'`{name}` is {value!r}, as the file says that the check has put there',
               f'it is {found!r}{remark}')


def require_start(exercise: Exercise) -> None:
    """Add the requirement that the launch file starts the driver."""
    @exercise.require('`ros2 launch` can run the file, which starts your driver, once', see=TYPES)
    def starts(trial: Trial) -> None:
        try:
            launch(trial, OURS).start(trial)
        except NotYet as error:
            raise NoUse(error.expected, error.happened) from None


write = Exercise('7.2a', 'Your launch file', CHAPTER, PACKAGE, hints=(
    'It has the same shape as `words_launch.py`: two imports, the function, and in its list one `Node`. This one has a '
    '`package` and an `executable`, as after `ros2 run`, a `name`, and `parameters`.',
    "`parameters=[PathJoinSubstitution([FindPackageShare('my_robot'), 'config', 'my_robot.yaml'])]`. The first class "
    'comes from `launch.substitutions`, the second from `launch_ros.substitutions`.'))

require_start(write)


@write.require(f'it starts with what `{CONFIG}` says', see=TYPES)
def has_values(trial: Trial) -> None:
    expect_start(trial, IN_PACKAGE, f'The check has put another `{CONFIG}` into a copy of your package. Does the '
                 'launch file name it, is the node called `driver`, and does no later source say something else?')


install = Exercise('7.2b', 'What your package installs', CHAPTER, PACKAGE, hints=(
    'An entry of `data_files` is a pair: the folder in the install space, and a list of files in your package. The '
    'entry for `config` shows it.',
    "`('share/' + package_name + '/launch', ['launch/my_robot_launch.py']),` is the new line in `setup.py`, and "
    '`<exec_depend>ros2launch</exec_depend>` the one in `package.xml`.'))


@install.require('`setup.py` installs your launch file, and still your parameter file', see=BUILD)
def installs_both(trial: Trial) -> None:
    for name in (LAUNCH, CONFIG):
        expect_installed(trial, name)


@install.require('`package.xml` says that your package needs `ros2launch` when it runs', see=BUILD)
def names_launch(trial: Trial) -> None:
    root, either = package_xml(trial.work), {'ros2launch', 'launch_ros'}
    expect(either & needed_packages(root), '`<exec_depend>ros2launch</exec_depend>`',
           'there is none' + remark_elsewhere(root, either))


take = Exercise('7.2c', 'Any file', CHAPTER, PACKAGE, hints=(
    'Two things change: a `DeclareLaunchArgument` stands before the node, and your path becomes its `default_value`. '
    "In `parameters`, `LaunchConfiguration('params_file')` takes its place.",
    "`parameters=[ParameterFile(LaunchConfiguration('params_file'), allow_substs=True)]`, with `ParameterFile` from "
    '`launch_ros.parameter_descriptions`.'))

require_start(take)


@take.require(f'without an argument, it starts with what `{CONFIG}` says', see=ARGUMENT)
def has_default(trial: Trial) -> None:
    expect_start(trial, IN_PACKAGE, 'Is your file the `default_value` of the argument?')


@take.require('with `params_file:=…`, it starts with what that file says', see=ARGUMENT)
def takes_file(trial: Trial) -> None:
    arguments = launch(trial, OURS).arguments
    expect('params_file' in arguments, 'an argument `params_file`, which the launch file declares',
           'it declares ' + (', '.join(f'`{each}`' for each in arguments) or 'none'))
    expect_start(trial, GIVEN, 'Does `parameters` take the file from the argument?', parameter_file(GIVEN))


@take.require('a file that is not there ends the launch', see=ARGUMENT)
def rejects_missing(trial: Trial) -> None:
    take_for_granted(trial, takes_file)
    with contextlib.suppress(NoUse):
        try:
            launched = launch(trial, OURS, '')
        except NotYet as error:
            if re.search('No such file', error.happened):
                return
            raise
    raise NotYet('an error', 'the launch only warns: ' + (launched.warnings or ['or not even that'])[0])


EXERCISES = (write, install, take)
