"""ros2 launch, embedded: what a launch file may say, what comes of it, and what is rejected by name."""

import itertools
import os
import re
import sys
from pathlib import Path
from typing import List  # noqa: UP035  # as launch files write it

import pytest
import yaml
from rclpy.node import Node as RclNode

from param_tools.cli.launch.actions import LaunchDescription
from param_tools.cli.launch.context import Context, LaunchFailed
from param_tools.cli.launch.importing import MODULES
from param_tools.cli.launch.parameters import ParameterFile, ParameterValue, parameter_value
from param_tools.cli.launch.processes import Launcher, Program
from param_tools.cli.launch.reading import load_description
from param_tools.cli.launch.ros_actions import Node, SetParameter
from param_tools.cli.launch.substitutions import LaunchConfiguration
from param_tools.cli.run import node_programs
from param_tools.ros.waiting import to_end
from tests.support.commands import run, source_package

HEAD = '''
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
'''
# launch knows this one, and not list[int].
INTS = List[int]  # noqa: UP006
given = LaunchConfiguration


@pytest.fixture
def launch_file(write):
    """Return a function that writes a launch file around some entities, and returns its path."""
    return lambda entities, head=HEAD: write(f'{head}{entities}\n    ])\n', 'some_launch.py')


@pytest.fixture
def context(tmp_path):
    context = Context({'speed': '60'}, tmp_path)
    context.warnings = []
    context.log = lambda _level, _name, text: context.warnings.append(text)
    return context


def launch(*words, in_notebook=True):
    """Run ros2 launch in this process: standard output, standard error, exit status."""
    return run('launch', *words, in_notebook=in_notebook, get_executor=pytest.fail)


def robot(**options):
    return Node(package='param_tutorial', executable='simple_param_node', **options)


def arguments(node, context):
    """Return what stands after --ros-args, and the content of the parameter files among it."""
    words = node.command(['program'], context)
    after = words[words.index('--ros-args') + 1:]
    paths = [path for word, path in itertools.pairwise(after) if word == '--params-file']
    return after, [yaml.safe_load(Path(path).read_text()) for path in paths]


def values_of(parameters, context):
    """Return the overrides that a node is started with."""
    _, files = arguments(robot(parameters=[parameters]), context)
    return files[0]['/**']['ros__parameters']


# -- reading --------------------------------------------------------------------------------------------------------


def test_after_reading_the_imports_find_what_they_found_before(launch_file, monkeypatch):
    mine = type(sys)('launch')
    monkeypatch.setitem(sys.modules, 'launch', mine)
    before = {name: sys.modules.get(name) for name in MODULES}
    load_description(launch_file("        Node(package='p', executable='e')"))
    assert {name: sys.modules.get(name) for name in MODULES} == before
    assert sys.modules['launch'] is mine
    with pytest.raises(ModuleNotFoundError):
        import launch_ros  # noqa: F401


def test_a_launch_file_has_the_real_ament_index_and_finds_the_course_in_it(write, tmp_path, monkeypatch):
    path = write("""
import ament_index_python
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    prefix = ament_index_python.get_packages_with_prefixes()['param_tutorial']
    return LaunchDescription([Node(package=prefix, executable='x')])
""", 'index_launch.py')
    monkeypatch.setenv('AMENT_PREFIX_PATH', '/nowhere')
    node, = load_description(path).entities
    assert Path(node.package, 'share/param_tutorial/config/clawbot_config.yaml').is_file()
    assert os.environ['AMENT_PREFIX_PATH'] == '/nowhere'
    # A package that has been built and sourced comes first.
    source_package('param_tutorial', tmp_path, monkeypatch)
    node, = load_description(path).entities
    assert node.package == str(tmp_path)


@pytest.mark.parametrize('entity', [
    'Fancy()', 'UnregisterEventHandler(1)', 'RegisterEventHandler(OnProcessExit(on_exit=[]))',
    'EmitEvent(event=Shutdown())', "Node(package='p', executable='e', on_exit=[LogInfo(msg='gone')])",
    'TimerAction(period=1.0, actions=[])', "Node(package='p', executable='e', respawn=True)",
    "ComposableNodeContainer(name='c', namespace='', package='p', executable='e', composable_node_descriptions=["
    "ComposableNode(package='p', plugin='p::C')])"])
def test_what_is_left_out_may_be_imported_and_is_rejected_by_name_where_it_is_used(
        launch_file, context, monkeypatch, entity):
    monkeypatch.setattr(Context, 'find_program', lambda *_: ['program'])
    head = HEAD.replace('def generate', """
from launch.actions import EmitEvent, Fancy, LogInfo, RegisterEventHandler, Shutdown, TimerAction
from launch.actions import UnregisterEventHandler
from launch.event_handlers import OnProcessExit
from launch_ros.actions import ComposableNodeContainer
from launch_ros.descriptions import ComposableNode


def generate""")
    assert load_description(launch_file('', head)).entities == []
    with pytest.raises(LaunchFailed, match=r'launch has no .*: the genuine `ros2 launch` has.*README'):
        load_description(launch_file(entity, head)).execute(context)


@pytest.mark.parametrize(('name', 'text', 'why'), [
    ('x_launch.txt', '', 'x_launch.txt is no launch file in Python, XML or YAML'),
    ('x_launch.xml', '', r'file of format \[xml\]: no element found'),
    ('x_launch.yaml', '- launch', "has one key at the top, which is 'launch'"),
    ('x_launch.py', 'x = 1', "required function 'generate_launch_description"),
    ('x_launch.py', 'x =', r'SyntaxError: invalid syntax \(x_launch\.py, line 1\)\n'),
    ('x_launch.py', 'import launch_testing.actions', "'launch_testing'.*the genuine `ros2 launch` has it"),
    ('x_launch.py', 'def generate_launch_description():\n    return 5', 'must return a LaunchDescription'),
    ('x_launch.py', 'def generate_launch_description():\n    return 1 / 0',
     r'ZeroDivisionError: division by zero \(x_launch\.py, line 2\)'),
    ('x_launch.py', 'from launch import LaunchDescription\nLaunchDescription([1])', 'takes actions such as Node'),
])
def test_a_file_that_is_none(write, name, text, why):
    out, err, status = launch(write(text, name), in_notebook=False)
    assert (err, status) == ('', 1)
    assert re.search(rf'\n\[ERROR\] \[launch\]: Caught exception in launch \(see debug for traceback\): .*{why}', out)


# -- command lines --------------------------------------------------------------------------------------------------


def test_files_and_dictionaries_keep_their_order(context, tmp_path):
    (tmp_path / 'a.yaml').write_text('first: 1')
    after, files = arguments(robot(parameters=[tmp_path / 'a.yaml', {'speed': 200}]), context)
    assert after[::2] == ['--params-file', '--params-file']
    assert files == [{'first': 1}, {'/**': {'ros__parameters': {'speed': 200}}}]


def test_a_parameter_file_that_is_missing_is_a_warning_only(context):
    assert arguments(robot(parameters=['/nowhere/x.yaml']), context) == ([], [])
    assert context.warnings == ['Parameter file path is not a file: /nowhere/x.yaml']


@pytest.mark.parametrize(('options', 'why'), [
    ({'name': 'bad name'}, "Invalid node name: .*: 'bad name'"), ({'namespace': '//lab'}, 'Invalid namespace'),
    ({'executable': 'nope'}, "executable 'nope' not found in package 'param_tutorial', which has .*base_node, "),
    ({'package': 'nope'}, r"package 'nope' not found.* Correct its name, or build it and source"),
    ({'parameters': [5]}, 'has 5 where a string or a substitution belongs'),
    ({'parameters': {'x': 1}}, "expected 'parameters' to be a list, but got a value of type 'dict'"),
    ({'remappings': [('a', 'b', 'c')]}, 'ValueError: too many values to unpack'),
    ({'output': 'everywhere'}, "output='everywhere' is not valid: use 'screen', 'log', "),
])
def test_a_node_that_cannot_be_started_is_an_error_before_anything_starts(context, options, why):
    with pytest.raises(LaunchFailed, match=why):
        LaunchDescription([robot(), Node(**{
            'package': 'param_tutorial', 'executable': 'simple_param_node', **options})]).execute(context)


@pytest.mark.parametrize(('output', 'streams'), [
    ('screen', (True, True)), ('log', (False, True)),
    ({'stdout': {'log'}, 'stderr': {'screen', 'log'}}, (False, True))])
def test_which_streams_are_shown(context, output, streams):
    assert robot(output=output).streams_on_screen(context) == streams


def test_with_set_parameter_a_file_for_the_node_beats_the_dictionary_after_it(context, write, ros):
    path = write('/trip: {ros__parameters: {speed: 180}}')
    node = robot(parameters=[path, {'speed': 200}])

    def speed():
        words = node.command(['program'], context)[2:]
        return ros.add(RclNode, 'trip', automatically_declare_parameters_from_overrides=True,
                       ros_args=words).get_parameter('speed').value

    assert speed() == 200
    SetParameter('fleet', 'north').execute(context)
    assert speed() == 180


# -- values, as measured with the genuine one (launch 3.4.3, launch_ros 0.26.6) ---------------------------------------


@pytest.mark.parametrize('text', ['null', '2026-02-31', '[1, a]', '[]', 'a: b: c'])
def test_a_string_that_yaml_makes_no_parameter_of_is_an_error_that_says_how_to_keep_it(context, text):
    context.launch_configurations['n'] = text
    with pytest.raises(LaunchFailed, match=r'^n: .* read as YAML\. .*value_type=str\) keeps it one'):
        values_of({'n': given('n')}, context)
    assert values_of({'n': ParameterValue(given('n'), value_type=str)}, context) == {'n': text}


@pytest.mark.parametrize(('text', 'value_type', 'value'), [
    ('yes', bool, True), ('60', float, 60.0), ('42', str, '42'), ('[1, 2]', INTS, [1, 2])])
def test_a_parameter_value_turns_the_string_of_a_substitution_into_its_type(context, text, value_type, value):
    context.launch_configurations['n'] = text
    found = parameter_value('x', ParameterValue(given('n'), value_type=value_type), context)
    assert (type(found), found) == (type(value), value)
    context.launch_configurations['n'] = '[1, a]'
    if value_type is not str:
        with pytest.raises(LaunchFailed, match=r"^'\[1, a\]' was given where the launch file takes a value of type"):
            parameter_value('x', ParameterValue(given('n'), value_type=value_type), context)


@pytest.mark.parametrize(('text', 'why'), [
    ('x: $(anon speed)', r'no substitution \$\(anon speed\): the genuine `ros2 launch` has'),
    ('x: $(arg speed)', r'no substitution \$\(arg speed\), which is of ROS 1: ROS 2 has \$\(var'),
    ('x: $(var)', r'\$\(var\) has too many arguments or too few'),
    ("x: $(eval '1 + nothing')", r"the expression '1 \+ nothing' fails: NameError"),
    ('x: $(var speed', r'a substitution cannot be read: \$\(var speed; it has to be \$\(name argument …\)'),
    ('x: $(var nobody)', "'nobody' does not exist")])
def test_a_substitution_in_a_file_that_cannot_be_carried_out_is_named(context, write, text, why):
    with pytest.raises(LaunchFailed, match=why):
        ParameterFile(write(text), allow_substs=True).evaluate(context)
    with pytest.raises(LaunchFailed, match=r'No such file or directory: /nowhere/x\.yaml'):
        ParameterFile('/nowhere/x.yaml', allow_substs=True).evaluate(context)


# -- the command ----------------------------------------------------------------------------------------------------


def test_arguments_are_shown_and_checked(launch_file):
    path = launch_file("""
        DeclareLaunchArgument('mode', default_value='slow', choices=['slow', 'fast'], description='How.'),
        DeclareLaunchArgument('robot')""")
    assert launch('--show-args', path) == ("""Arguments (pass arguments as '<name>:=<value>'):

    'mode':
        How. Valid choices are: ['slow', 'fast']
        (default: 'slow')

    'robot':
        no description given
""", '', 0)
    for words, why in ((['mode:=wild', 'robot:=x'], 'provided value "wild" is not valid'),
                       (['fast'], "malformed launch argument 'fast'"),
                       (['robot:='], "malformed launch argument 'robot:='")):
        out, err, status = launch(path, *words, in_notebook=False)
        assert status == 1
        assert why in (err if 'malformed' in why else out)  # before the launch begins, or in it


def test_mistakes_have_a_sentence(launch_file, monkeypatch, tmp_path):
    assert 'was not found in the share directory of package' in launch('param_tutorial', 'no_launch.py')[1]
    with monkeypatch.context() as changed:
        changed.setenv('AMENT_PREFIX_PATH', str(tmp_path))
        assert launch('nobody', 'no_launch.py')[1] == (
            f"Package 'nobody' not found: \"package 'nobody' not found, searching: ['{tmp_path}']\"\n")
    assert 'in a terminal: ros2 launch param_tutorial simple_param_launch.py; or' in launch(
        'param_tutorial', 'simple_param_launch.py')[1]
    path = launch_file("        Node(package='param_tutorial', executable='nope')")
    assert launch(path, in_notebook=False) == (
        '[INFO] [launch]: Default logging verbosity is set to INFO\n'
        "[ERROR] [launch]: Caught exception in launch (see debug for traceback): executable 'nope' not found in "
        f"package 'param_tutorial', which has {', '.join(node_programs('param_tutorial'))}\n", '', 1)


def test_a_launch_file_is_found_at_any_depth_and_must_be_the_only_one_of_its_name(tmp_path, monkeypatch):
    source_package('deep', tmp_path, monkeypatch)
    share = tmp_path / 'share/deep'
    (share / 'launch/robots/arm').mkdir(parents=True)
    (share / 'launch/robots/arm/x_launch.py').write_text(HEAD + '    ])\n')
    assert launch('--show-args', 'deep', 'x_launch.py')[1:] == ('', 0)
    (share / 'launch/x_launch.py').write_text(HEAD + '    ])\n')
    _, err, status = launch('--show-args', 'deep', 'x_launch.py')
    assert status == 1
    assert f"file 'x_launch.py' was found more than once in the share directory of package 'deep': ['{share}" in err


def test_a_program_that_ignores_signals_is_killed_in_the_end(write, monkeypatch, capfd):
    monkeypatch.setattr('param_tools.cli.launch.processes.GRACE_SEC', 0.2)
    script = write('trap "" INT TERM; kill -INT $PPID; while :; do sleep 0.1; done\n', 'stubborn')
    to_end(Launcher(sys.stdout).run([Program(['sh', str(script)], 'stubborn', True, True)]))
    shown = capfd.readouterr().out
    assert "'0.2' seconds after receiving 'SIGINT', escalating to 'SIGTERM'" in shown
    assert "'0.2' seconds after receiving 'SIGTERM', escalating to 'SIGKILL'" in shown
    assert 'exit code -9' in shown


def test_a_program_has_its_folder_and_its_environment_and_one_ends_the_others(tmp_path, capfd):
    def shell(name, text, **options):
        return Program(['sh', '-c', text], name, True, True, **options)

    to_end(Launcher(sys.stdout).run([
        shell('first', 'echo "$TRY in $PWD"; sleep 60', environment={**os.environ, 'TRY': 'here'}, folder=tmp_path),
        shell('required', 'sleep 1', ends_all=True)]))
    shown = capfd.readouterr().out
    assert f'[first-1] here in {tmp_path}\n' in shown
    was_required = '[INFO] [launch]: process[required-2] was required: shutting down launched system'
    assert shown.index(was_required) < shown.index('[ERROR] [first-1]: process has died')
