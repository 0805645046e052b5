"""Exercises of chapter 7.2: fill in what a launch file says, complete a launch file, and predict what a robot starts
with."""

import ast
import contextlib
import itertools
import shlex
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

import yaml

from param_tools.cli.index import share_folder_of
from param_tools.cli.launch.actions import LaunchDescription
from param_tools.cli.launch.context import Context, LaunchFailed
from param_tools.cli.launch.processes import Program
from param_tools.cli.launch.reading import load_description
from param_tools.errors import WaitTimeoutError
from param_tutorial.exercises.exercise import DICTIONARY, TEXT, Exercise
from param_tutorial.exercises.expectations import expect_no_gap
from param_tutorial.exercises.trial import NoStart, NotYet, NoUse, Trial, expect, take_for_granted
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from param_tutorial.notebook.terminal import Terminal

CHAPTER = '07_2_launch_files'
SEE = 'See it'
READ = 'Read it'
VALUES = 'Change it: values in the launch file'
ARGUMENTS = 'Change it: arguments'
NOT_INSTALLED = 'Break it: a package of your own'
SOMEBODY_ELSE = 'Break it: a robot of another name'
FILE_NAME = 'my_launch.py'


class Reckless(SimpleParamNode):
    """The robot with its safety mode off by default, which tells a mode that is set from one that is left alone."""

    def declare_parameter(self, name: str, value: Any = None, *args: Any, **options: Any) -> Any:
        return super().declare_parameter(name, False if name == 'enable_safety_mode' else value, *args, **options)


class Launched(NamedTuple):
    """What a launch file starts."""

    words: list[str]
    """What follows ``--ros-args``; a parameter file by its name in ``files``."""
    files: dict[str, str]
    """The text of each parameter file."""
    arguments: list[str]
    """The names of the arguments that the launch file declares."""

    def start(self, trial: Trial, node_class: type[SimpleParamNode] = SimpleParamNode) -> SimpleParamNode:
        """Put the robot on the stage, in the corner.

        :raises NoStart: it does not start.
        """
        namespace = next((word.partition(':=')[2] for word in self.words if word.startswith('__ns:=')), '')
        return trial.start_with_files(node_class, self.files, *self.words, namespace=namespace.rstrip('/'))


def launch(trial: Trial, text: str, **arguments: str) -> Launched:
    """Work out what ``ros2 launch`` would start.

    :param text: Of the launch file; it has to start the robot, and nothing else.
    :param arguments: Of the launch file.
    :raises NoUse: it cannot be carried out, or starts something else.
    """
    expect_no_gap(names=_gaps(text))
    with tempfile.TemporaryDirectory(prefix='param_tutorial_') as folder:
        path = Path(folder, FILE_NAME)
        path.write_text(text, encoding='utf-8')

        def work_out() -> tuple[LaunchDescription, list[Program]]:
            description = load_description(path)
            return description, description.execute(Context(dict(arguments), Path(folder)))

        try:
            description, found = trial.call('the launch file', work_out)
        except NotYet as error:
            raise NoUse('a launch file that `ros2 launch` can run',
                        error.happened.replace(f'{folder}/', '').removeprefix(f'{LaunchFailed.__name__}: ')) from None
        if [program.name for program in found] != ['simple_param_node']:
            names = ', '.join(f'`{program.name}`' for program in found) or 'nothing'
            raise NoUse('a launch file that starts the robot, `simple_param_node`, once', f'it starts {names}')
        command = found[0].command
        words = command[command.index('--ros-args') + 1:]
        paths = [word for option, word in itertools.pairwise(words) if option == '--params-file']
        for each in paths:
            if not Path(each).is_absolute():
                raise NoUse('a path that leads to the file from every folder',
                            f'`{each}` leads there only from the folder `{Path.cwd().name}`')
        short = {path: f'{position}.yaml' for position, path in enumerate(paths)}
        return Launched([short.get(word, word) for word in words],
                        {name: Path(path).read_text(encoding='utf-8') for path, name in short.items()},
                        [each.declaration.name for each in description.declared_arguments()])


def _gaps(text: str) -> list[str]:
    """Return the arguments, and the keys of dictionaries, whose value is still an ellipsis."""
    try:
        nodes = list(ast.walk(ast.parse(text)))
    except (SyntaxError, ValueError):
        return []  # reading the launch file says so
    pairs = [(each.arg, each.value) for each in nodes if isinstance(each, ast.keyword)]
    for each in nodes:
        if isinstance(each, ast.Dict):
            pairs += [(getattr(key, 'value', None), value) for key, value in zip(each.keys, each.values, strict=True)]
    return [f'`{name}`' for name, value in pairs if isinstance(value, ast.Constant) and value.value is ...]


complete = Exercise('7.2b', 'Complete a launch file', CHAPTER, TEXT, hints=(
    '`parameters` is a list: first the file, then what covers it. The chapter’s three launch files contain all that '
    'you need. `print((launch_files / "argument_param_launch.py").read_text())` shows one of them.',
    'The file: `PathJoinSubstitution([FindPackageShare("param_tutorial"), "config", "clawbot_config.yaml"])`. The '
    'values: a dictionary after it, in which `LaunchConfiguration("max_speed_rpm")` stands for the argument.',
    'Declare each argument before the node: `DeclareLaunchArgument(name, default_value=...)`. To keep a string that '
    'may look like a number: `ParameterValue(LaunchConfiguration("serial"), value_type=str)`.'))


def starts(trial: Trial, node_class: type[SimpleParamNode] = SimpleParamNode, **arguments: str) -> SimpleParamNode:
    """Start the robot of the learner's launch file."""
    words = ''.join(f' {argument}:={given}' for argument, given in arguments.items())
    try:
        return launch(trial, trial.work, **arguments).start(trial, node_class)
    except NoStart as error:
        if not arguments:
            raise  # what dies without arguments dies in each requirement
        raise NotYet(f'the robot starts with `{words.strip()}`',
                     f'{error.happened}. A launch reads the string of an argument as YAML') from None


def config() -> Any:
    """Return what the course's file holds."""
    return yaml.safe_load((share_folder_of('param_tutorial') / 'config' / 'clawbot_config.yaml').read_text())


def expect_holds(trial: Trial, name: str, value: object, because: str = '', **arguments: str) -> None:
    """Expect the robot to start with a value.

    :param because: What to think of when it starts with another one.
    """
    words = ' '.join(f'{argument}:={given}' for argument, given in arguments.items())
    found = starts(trial, SimpleParamNode, **arguments).get_parameter(name).value
    expect(type(found) is type(value) and found == value,
           f'`{name}` is `{value!r}`' + (f' with `{words}`' if words else ' without arguments'),
           f'it is `{found!r}`' + (f'. {because}' if because else ''))


def expect_covered(trial: Trial, name: str, because: str) -> None:
    """Expect the launch file to give a parameter another value than the course's file does.

    :raises NotTried: the file covers the safety mode, too, and the requirement for that says so.
    """
    in_file = config()['/simple_param_node']['ros__parameters'][name]
    found = starts(trial).get_parameter(name).value
    if found == in_file:
        take_for_granted(trial, override_arrives)
    expect(found != in_file, f'a value for `{name}` that covers the file’s', f'it is still `{found!r}`. {because}')


@complete.require('the robot starts, and has its name from `clawbot_config.yaml`', see=READ)
def file_arrives(trial: Trial) -> None:
    starts(trial)
    found = launch(trial, trial.work)
    expect(config() in [yaml.safe_load(text) for text in found.files.values()], 'the robot gets this file',
           'it gets no such file. Is it in the list, and is its path right?')
    expect_holds(trial, 'robot_name', 'AlphaClaw', 'Is the file for a node of this name, and does nothing cover it?')


@complete.require('its safety mode is on, whatever the file says', see=VALUES)
def override_arrives(trial: Trial) -> None:
    found = starts(trial, Reckless).get_parameter('enable_safety_mode').value
    expect(found, '`enable_safety_mode` is `True`, and does not depend on the default',
           f'it is `{found!r}`. Of these two sources, the later one wins')
    for argument in launch(trial, trial.work).arguments:
        with contextlib.suppress(NotYet):  # what else the word does to the robot is not asked here
            found = starts(trial, Reckless, **{argument: 'false'}).get_parameter('enable_safety_mode').value
        expect(found, 'the safety mode is always on', f'with `{argument}:=false` it is off')


@complete.require('its speed is 90 rpm, and 60 with `max_speed_rpm:=60`', see=ARGUMENTS)
def speed_arrives(trial: Trial) -> None:
    expect_covered(trial, 'max_speed_rpm', 'Is there a value for it, and does it come after the file?')
    expect_holds(trial, 'max_speed_rpm', 90, 'Does the argument have this default, and is it used?')
    for speed in (60, 245):
        expect_holds(trial, 'max_speed_rpm', speed, 'Is the argument used?', max_speed_rpm=str(speed))


@complete.require('its serial number is `SN-1`, and `0042` with `serial:=0042`', see=ARGUMENTS)
def serial_arrives(trial: Trial) -> None:
    expect_covered(trial, 'robot_serial_number', 'The parameter is called `robot_serial_number`, and its value has to '
                                                 'come after the file')
    expect_holds(trial, 'robot_serial_number', 'SN-1', 'Does the argument have this default, and is it used?')
    for serial in ('0042', 'on', 'B 7'):
        expect_holds(trial, 'robot_serial_number', serial, 'Is the argument used, and does it stay a string?',
                     serial=serial)


@complete.require('`ros2 launch` starts it, in a process of its own', see=SEE)
def runs(trial: Trial) -> None:
    take_for_granted(trial, file_arrives, override_arrives, speed_arrives, serial_arrives)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, FILE_NAME)
        path.write_text(trial.work, encoding='utf-8')
        # The robot must neither see nor be seen by a learner's own of the same name.
        terminal = Terminal(shlex.join(['ros2', 'launch', str(path), 'serial:=0042']),
                            variables={'ROS_AUTOMATIC_DISCOVERY_RANGE': 'OFF'})
        try:
            said = terminal.read(until='robot_serial_number: 0042', timeout_sec=60.0)
        except WaitTimeoutError:
            last = (terminal.text.strip() or 'nothing').splitlines()[-1]
            raise NotYet('the robot logs its parameters in the terminal', f'the last line is: {last}') from None
        finally:
            terminal.interrupt()
    expect('max_speed_rpm: 90' in said, 'it logs `max_speed_rpm: 90`', 'it does not')


HEAD = """
from launch import LaunchDescription
from launch.substitutions import PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

config = PathJoinSubstitution([FindPackageShare('param_tutorial'), 'config', 'clawbot_config.yaml'])


def generate_launch_description():
    return LaunchDescription([Node(package='param_tutorial', executable='simple_param_node', {words})])
"""

foresee = Exercise('7.2c', 'Predict the start', CHAPTER, DICTIONARY, hints=(
    'Ask three questions about each line. Is the file there? Is it for a node of this name? Does a later source win?',
    'A missing file is only a warning, and a file for another node is ignored without one. In both cases the default '
    'stays.',
    'A dictionary in a launch file holds Python values, and a string stays a string. ROS converts nothing.'))


def require_foresight(words: str, because: Mapping[object, str], see: str) -> None:
    """Add the requirement to know the speed of a robot that is started with these words in its ``Node``."""
    @foresee.require_prediction(words, see=see, because=because, word='dead')
    def speed(trial: Trial) -> Any:
        try:
            robot = launch(trial, HEAD.replace('{words}', words)).start(trial)
            return robot.get_parameter('max_speed_rpm').value
        except NoStart:
            return 'dead'


require_foresight('parameters=[config]', {100: 'The file is for `/simple_param_node`'}, READ)
require_foresight("parameters=[config, {'max_speed_rpm': 200}]", {180: 'Which source is the later one?'}, VALUES)
require_foresight("parameters=[{'max_speed_rpm': 200}, config]", {
    200: 'Which source is the later one?'}, VALUES)
require_foresight("parameters=[config], name='berta'", {
    180: 'Which node is the file for?', 'dead': 'Nothing complains, and that is the trouble'}, SOMEBODY_ELSE)
require_foresight("parameters=['clawbot_confg.yaml']", {
    'dead': 'A missing file is a warning, not an error', 180: 'Look at the name of the file'}, NOT_INSTALLED)
require_foresight("parameters=[{'max_speed_rpm': '200'}]", {
    200: 'There are quotes around it', '200': 'ROS converts nothing',
    100: 'A start value of the wrong type is not ignored'}, ARGUMENTS)
require_foresight("parameters=[config, {'max_speed': 200}]", {
    200: 'Is there a parameter of that name?', 'dead': 'A value for an undeclared parameter is ignored'}, VALUES)


fill = Exercise('7.2a', 'Fill four gaps', CHAPTER, TEXT, hints=(
    'The first two gaps are what you type after `ros2 run`: a package, and an executable in it. The robot is '
    '`simple_param_node` in `param_tutorial`.',
    '`parameters` is a list. A dictionary in it holds Python values, so the name needs quotes and the speed does not.'))


@fill.require('the robot starts', see=READ)
def filled_starts(trial: Trial) -> None:
    launch(trial, trial.work).start(trial)


def require_filled(name: str, value: object) -> None:
    """Add the requirement that the robot starts with a value."""
    @fill.require(f'`{name}` is `{value!r}`', see=VALUES)
    def holds(trial: Trial) -> None:
        found = launch(trial, trial.work).start(trial).get_parameter(name).value
        expect(found == value, f'`{value!r}`', f'it is `{found!r}`')


require_filled('max_speed_rpm', 150)
require_filled('robot_name', 'Berta')


EXERCISES = (fill, complete, foresee)
