"""Exercises of chapter 11: the reader's package gets a version and a launch file for two robots; and a last course."""

import re

from param_tools.cli.launch.processes import Program
from param_tutorial.exercises.exercise import DICTIONARY, Exercise
from param_tutorial.exercises.steps import (
    CONFIG,
    PACKAGE,
    carry_out,
    copied,
    drive,
    expect_installed,
    expect_settings,
    file_of,
    needed_packages,
    package_xml,
    remark_elsewhere,
    setup_calls,
    text_of,
)
from param_tutorial.exercises.trial import NoUse, Trial, expect, take_for_granted

CHAPTER = '11_conclusion'
VERSION = 'A version'
TWO = 'Two robots, one launch file'
COURSE = 'The last course'
NUMBER = '1.0.0'
LAUNCH = 'launch/two_robots_launch.py'
NAMESPACES = ('left', 'right')

# -- 11a: a version ---------------------------------------------------------------------------------------------------

release = Exercise('11a', 'Version 1.0.0', CHAPTER, PACKAGE, hints=(
    'In `package.xml` it is the element `<version>`, and in `setup.py` the argument `version` of `setup`.',
    "A string in `setup.py`: `version='1.0.0',`. And each name of a ROS package after `import` or `from` in a file of "
    'yours has an `<exec_depend>`.'))


@release.require(f'`package.xml` says {NUMBER}', see=VERSION)
def package_says(trial: Trial) -> None:
    found = (package_xml(trial.work).findtext('version') or '').strip()
    expect(found == NUMBER, f'`<version>{NUMBER}</version>`', f'it says `{found}`')


@release.require('`setup.py` says the same', see=VERSION)
def setup_says(trial: Trial) -> None:
    found = next((given.get('version') for given in setup_calls(trial, trial.work.root)), None)
    expect(found == NUMBER, f'`version={NUMBER!r}`', f'it says `{found!r}`')


@release.require('`package.xml` names each ROS package that your nodes import', see=VERSION)
def names_dependencies(trial: Trial) -> None:
    root = package_xml(trial.work)
    named = needed_packages(root)
    for path in sorted((trial.work.root / 'my_robot').glob('*_node.py')):
        for each in re.findall(r'^(?:from|import) (\w+)', path.read_text(encoding='utf-8'), re.MULTILINE):
            if each == 'rclpy' or each.endswith(('_msgs', '_interfaces')):
                expect(each in named, f'`<exec_depend>{each}</exec_depend>`', f'`{path.name}` imports `{each}`, and '
                       'nobody who builds the package is told' + remark_elsewhere(root, [each]))


# -- 11b: two robots --------------------------------------------------------------------------------------------------

fleet = Exercise('11b', 'Two robots', CHAPTER, PACKAGE, hints=(
    '`IncludeLaunchDescription(PythonLaunchDescriptionSource(path), launch_arguments={...}.items())` includes '
    'another launch file. Two of them, with two namespaces, make two robots.',
    "The path is that of your first launch file: `PathJoinSubstitution([FindPackageShare('my_robot'), 'launch', "
    "'my_robot_launch.py'])`.",
    f"`setup.py` installs one launch file so far. Its list takes a second name, `'{LAUNCH}'`."))


def programs(trial: Trial) -> list[Program]:
    """Return what the reader's launch file starts.

    :raises NotYet: it cannot be carried out.
    :raises NoUse: there is none.
    """
    file_of(trial.work, LAUNCH)
    with copied(trial.work, text_of(trial.work, CONFIG)) as root:
        return carry_out(trial, root, LAUNCH, {}, lambda *_: None)[1]


@fleet.require(f'`{LAUNCH}` starts two drivers, `/left/driver` and `/right/driver`', see=TWO)
def starts_two(trial: Trial) -> None:
    found = []
    for each in programs(trial):
        if each.name != 'driver_node':
            raise NoUse('drivers, and nothing else', f'it starts `{each.name}`')
        place = next((word for word in each.command if word.startswith('__ns:=')), '__ns:=/')
        found.append(f'{place.partition(":=")[2].rstrip("/")}/driver')
    wanted = [f'/{name}/driver' for name in NAMESPACES]
    expect(sorted(found) == wanted, '`/left/driver` and `/right/driver`',
           'it starts ' + (' and '.join(f'`{each}`' for each in found) or 'nothing'))


@fleet.require('both get your parameter file', see=TWO)
def both_get_file(trial: Trial) -> None:
    take_for_granted(trial, starts_two)
    for each in programs(trial):
        expect('--params-file' in each.command, 'a driver with `--params-file`', 'one has none')


@fleet.require('`setup.py` installs both launch files', see=TWO)
def is_installed(trial: Trial) -> None:
    for each in ('launch/my_robot_launch.py', LAUNCH):
        expect_installed(trial, each)


# -- 11c: the last course ---------------------------------------------------------------------------------------------

COLD = {'max_acceleration_mps2': 0.5, 'wall_m': 6.0}
MOST_SEC, MOST_GAP_M = 8.0, 0.3

course = Exercise('11c', 'The last course', CHAPTER, DICTIONARY, hints=(
    'With 0.5 m/s², the braking distance from *v* is *v*² meters. `stop_distance_m` is that, and a little more.',
    'A faster robot loses more time when it speeds up and brakes, and less on the way. `took_sec` says that 1.0 m/s is '
    'enough.',
    'At 1.0 m/s the robot brakes for 1.0 m. It hears of the distance late, and should stop within 0.3 m of the wall: '
    'try 1.2.'))


@course.require('the driver accepts each of your settings', see=COURSE)
def accepted(trial: Trial) -> None:
    expect_settings(trial)


@course.require('the robot stops in one piece', see=COURSE)
def stops(trial: Trial) -> None:
    end = drive(trial, COLD)
    expect(end.crash_speed_mps is None, 'it stops before the wall',
           f'it hits the wall at {end.crash_speed_mps or 0:.2f} m/s')


@course.require(f'it stops at most {MOST_GAP_M:g} m from the wall', see=COURSE)
def stops_near(trial: Trial) -> None:
    take_for_granted(trial, stops)
    gap_m = drive(trial, COLD).gap_m
    expect(gap_m <= MOST_GAP_M, f'at most {MOST_GAP_M:.2f} m', f'it stops {gap_m:.2f} m from the wall')


@course.require(f'it takes at most {MOST_SEC:g} s', see=COURSE)
def is_fast(trial: Trial) -> None:
    take_for_granted(trial, stops)
    took_sec = drive(trial, COLD).took_sec
    expect(took_sec <= MOST_SEC, f'at most {MOST_SEC:.1f} s', f'it takes {took_sec:.1f} s')


EXERCISES = (release, fleet, course)
