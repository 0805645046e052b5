"""Exercises of chapter 7.2: fill in what a launch file says, complete a launch file, and foresee what a robot
starts with."""

import itertools
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from param_tutorial.errors import WaitTimeoutError
from param_tutorial.exercises.exercise import DICTIONARY, TEXT, Exercise
from param_tutorial.exercises.trial import NoStart, NotYet, NoUse, Trial, expect
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from param_tutorial.notebook.shell import Shell
from param_tutorial.notebook.terminal import Terminal
from param_tutorial.ros2.launch.reading import load_description
from param_tutorial.ros2.launch.substitutions import Context
from param_tutorial.ros2.launch.verb import programs

CHAPTER = '07_2_launch_files'
READ = 'Read it'
VALUES = 'Change it: values in the launch file'
ARGUMENTS = 'Change it: arguments'
NOT_INSTALLED = 'Break it: the file that was not installed'
SOMEBODY_ELSE = 'Break it: a file for somebody else'
FILE_NAME = 'my_launch.py'


def launched(trial: Trial, text: str, **arguments: str) -> SimpleParamNode:
    """Put on the stage, in the corner, what a launch file starts, with the words that ``ros2 launch`` gives it.

    :param text: Of the launch file; it has to start the robot, and nothing else.
    :param arguments: Of the launch file.
    :raises NoUse: it cannot be carried out.
    :raises NotYet: it starts something else.
    """
    with tempfile.TemporaryDirectory(prefix='param_tutorial_') as folder:
        path = Path(folder, FILE_NAME)
        path.write_text(text, encoding='utf-8')
        try:
            found = trial.call('the launch file', lambda: programs(
                load_description(path), Context(dict(arguments), Path(folder), warn=lambda _: None)))
        except NotYet as error:
            raise NoUse(error.expected, error.happened.replace(f'{folder}/', '')) from None
        expect(len(found) == 1, 'one node is started', f'there are {len(found)}')
        program, = found
        expect(program.name == 'simple_param_node', 'the robot, `simple_param_node`', f'`{program.name}` is started')
        words = program.command[program.command.index('--ros-args') + 1:]
        namespace = next((word.partition(':=')[2] for word in words if word.startswith('__ns:=')), '')
        files = {word: Path(word).read_text(encoding='utf-8') for option, word in itertools.pairwise(words)
                 if option == '--params-file'}
        names = {word: f'{position}.yaml' for position, word in enumerate(files)}
        return trial.start_with_files(
            SimpleParamNode, {names[word]: content for word, content in files.items()},
            *(names.get(word, word) for word in words), namespace=namespace)


complete = Exercise('7.2a', 'Complete a launch file', CHAPTER, TEXT, hints=(
    '`parameters` is a list. First the file, then what stands above it: the chapter’s three launch files have all that '
    'you need, and `print((launch_files / "argument_param_launch.py").read_text())` shows one of them whole.',
    'The file: `PathJoinSubstitution([FindPackageShare("param_tutorial"), "config", "clawbot_config.yaml"])`. The '
    'values: a dictionary behind it, in which `LaunchConfiguration("max_speed_rpm")` stands for what was given.',
    'An argument is announced with `DeclareLaunchArgument(name, default_value=...)`, before the node. A text that may '
    'look like a number: `ParameterValue(LaunchConfiguration("serial"), value_type=str)`.'))


def expect_holds(trial: Trial, name: str, value: object, because: str, **arguments: str) -> None:
    """Expect the robot to start with a value."""
    words = ' '.join(f'{argument}:={given}' for argument, given in arguments.items())
    with_words = f' with `{words}`' if words else ' without arguments'
    try:
        node = launched(trial, trial.work, **arguments)
    except NoStart as error:  # the other requirements may be met
        raise NotYet(error.expected, f'{error.happened}. {because}') from None
    found = node.get_parameter(name).value
    expect(found == value, f'`{name}` is `{value!r}`{with_words}', f'it is `{found!r}`. {because}')


@complete.require('the robot has the name from `clawbot_config.yaml`', see=READ)
def file_arrives(trial: Trial) -> None:
    expect_holds(trial, 'robot_name', 'AlphaClaw', 'Is the file in `parameters`, and is it for this node?')


@complete.require('its safety mode is on, though the file says otherwise', see=VALUES)
def override_arrives(trial: Trial) -> None:
    file_arrives(trial)  # without the file it would be on anyway
    expect_holds(trial, 'enable_safety_mode', True, 'Of two sources the later one wins')


@complete.require('its speed is 90 rpm, and 60 with `max_speed_rpm:=60`', see=ARGUMENTS)
def speed_arrives(trial: Trial) -> None:
    expect_holds(trial, 'max_speed_rpm', 90, 'Does the argument have a default, and does it come after the file?')
    expect_holds(trial, 'max_speed_rpm', 60, 'Is the argument used?', max_speed_rpm='60')


@complete.require('its serial number is `SN-1`, and `0042` with `serial:=0042`', see=ARGUMENTS)
def serial_arrives(trial: Trial) -> None:
    expect_holds(trial, 'robot_serial_number', 'SN-1', 'The parameter is called `robot_serial_number`')
    expect_holds(trial, 'robot_serial_number', '0042', 'What is typed is read as YAML, unless it is to stay a text',
                 serial='0042')


@complete.require('`ros2 launch` starts it, in a process of its own', see='See it')
def runs(trial: Trial) -> None:
    for each in (override_arrives, speed_arrives, serial_arrives):  # else a process would be wasted
        each(trial)
    shell = Shell()
    try:
        # The robot must neither see nor be seen by a learner's own of the same name.
        shell.run('export ROS_AUTOMATIC_DISCOVERY_RANGE=OFF; unset PARAM_TUTORIAL_OWN_NODES')
        Path(shell.home, FILE_NAME).write_text(trial.work, encoding='utf-8')
        terminal = Terminal(f'ros2 launch ./{FILE_NAME} serial:=0042', shell=shell)
        try:
            said = terminal.read(until='robot_serial_number: 0042', timeout_sec=60.0)
        except WaitTimeoutError:
            last = (terminal.text.strip() or 'nothing').splitlines()[-1]
            raise NotYet('the robot tells its parameters in the terminal', f'the last line is: {last}') from None
        finally:
            terminal.interrupt()
    finally:
        shell.close()
    expect('max_speed_rpm: 90' in said, 'it tells `max_speed_rpm: 90`', 'it does not')


HEAD = """
from launch import LaunchDescription
from launch.substitutions import PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

config = PathJoinSubstitution([FindPackageShare('param_tutorial'), 'config', 'clawbot_config.yaml'])


def generate_launch_description():
    return LaunchDescription([Node(package='param_tutorial', executable='simple_param_node', {words})])
"""

foresee = Exercise('7.2b', 'Predict the start', CHAPTER, DICTIONARY, hints=(
    'Three questions for each line: is the file there, is it for a node of this name, and does a later source win?',
    'What is not found is warned of, and what is for somebody else is passed over in silence. In both cases the '
    'default stays.',
    'A dictionary in a launch file holds Python values, and a text is a text. ROS converts nothing.'))


def require_foresight(words: str, because: Mapping[object, str], see: str) -> None:
    """Add the requirement to know the speed of a robot that is started with these words in its ``Node``."""
    @foresee.require_prediction(words, see=see, because=because)
    def speed(trial: Trial) -> Any:
        try:
            return launched(trial, HEAD.replace('{words}', words)).get_parameter('max_speed_rpm').value
        except NoStart:
            return 'dead'


require_foresight('parameters=[config]', {100: 'The file is for `/simple_param_node`'}, READ)
require_foresight("parameters=[config, {'max_speed_rpm': 200}]", {180: 'Which source is the later one?'}, VALUES)
require_foresight("parameters=[{'max_speed_rpm': 200}, config]", {
    200: 'Which source is the later one?'}, VALUES)
require_foresight("parameters=[config], name='berta'", {
    180: 'For whom is the file?', 'dead': 'Nobody complains, and that is the trouble'}, SOMEBODY_ELSE)
require_foresight("parameters=['clawbot_confg.yaml']", {
    'dead': 'A missing file is a warning and no error', 180: 'Look at the name of the file'}, NOT_INSTALLED)
require_foresight("parameters=[{'max_speed_rpm': '200'}]", {
    200: 'There are quotes around it', 100: 'A start value of the wrong type is not passed over'}, ARGUMENTS)
require_foresight("parameters=[config, {'max_speed': 200}]", {
    200: 'Is there a parameter of that name?', 'dead': 'A value whose name nobody declares is passed over'}, VALUES)


fill = Exercise('7.2c', 'Fill four gaps', CHAPTER, TEXT, hints=(
    'The first two gaps are what you type after `ros2 run`: a package, and an executable in it. The robot that you '
    'know is `simple_param_node` of `param_tutorial`.',
    '`parameters` is a list, and a dictionary in it holds values as Python writes them: a text in quotes.'))


@fill.require('the robot starts', see=READ)
def robot_starts(trial: Trial) -> None:
    launched(trial, trial.work)


def require_filled(name: str, value: object) -> None:
    """Add the requirement that the robot starts with a value."""
    @fill.require(f'`{name}` is `{value!r}`', see=VALUES)
    def holds(trial: Trial) -> None:
        expect_filled(trial, name, value)


def expect_filled(trial: Trial, name: str, value: object) -> None:
    """Expect the robot that the learner's launch file starts to hold a value."""
    found = launched(trial, trial.work).get_parameter(name).value
    expect(found == value, f'`{value!r}`', f'it is `{found!r}`')


require_filled('max_speed_rpm', 150)
require_filled('robot_name', 'Berta')


EXERCISES = (fill, complete, foresee)
