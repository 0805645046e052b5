"""ros2 launch, embedded: what a launch file may say, what comes of it, and what is rejected by name."""

import io
import itertools
import os
import signal
import subprocess
import sys
from pathlib import Path

import psutil
import pytest
import yaml

from param_tutorial import ParameterClient, Terminal, wait_until
from param_tutorial.ros2 import command
from param_tutorial.ros2.launch.description import Context, LaunchFailed, Node
from param_tutorial.ros2.launch.reading import MODULES, load_description
from tests.support.paths import ROOT

FILES = sorted((ROOT / 'param_tutorial' / 'launch').glob('*.py'))
HEAD = '''
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution, TextSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    return LaunchDescription([
'''


@pytest.fixture
def launch_file(tmp_path):
    """Write a launch file around some entities, and give its path."""
    def write(entities, head=HEAD, name='some_launch.py'):
        path = tmp_path / name
        path.write_text(f'{head}{entities}\n    ])\n')
        return path
    return write


@pytest.fixture
def context(tmp_path):
    warnings = []
    context = Context({'speed': '60', 'name': '42', 'gains': '[1.0, 2.0]'}, tmp_path, warnings.append)
    context.warnings = warnings
    return context


def launch(*words, in_notebook=True):
    """Run ros2 launch in this process: standard output, standard error, exit status."""
    stdout, stderr = io.StringIO(), io.StringIO()
    status = command.main(['launch', *map(str, words)], stdout=stdout, stderr=stderr, get_executor=pytest.fail,
                       in_notebook=in_notebook)
    return stdout.getvalue(), stderr.getvalue(), status


def arguments(node, context):
    """Return what stands after --ros-args, and the content of the parameter files among it."""
    words = node.command(['program'], context)
    assert words[:1] == ['program']
    after = words[words.index('--ros-args') + 1:]
    paths = [path for word, path in itertools.pairwise(after) if word == '--params-file']
    return after, [yaml.safe_load(Path(path).read_text()) for path in paths]


# -- reading --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize('path', FILES, ids=lambda path: path.stem)
def test_the_courses_launch_files_import_only_what_the_genuine_launch_has(path):
    found = load_description(path)
    assert any(isinstance(entity, Node) for entity in found.entities)


def test_the_stand_ins_are_gone_after_reading(launch_file):
    before = {name: sys.modules.get(name) for name in MODULES}
    load_description(launch_file("        Node(package='p', executable='e')"))
    assert {name: sys.modules.get(name) for name in MODULES} == before
    with pytest.raises(ModuleNotFoundError):
        import launch_ros  # noqa: F401


def test_a_launch_file_has_the_real_ament_index_and_finds_the_course_in_it(tmp_path, monkeypatch):
    path = tmp_path / 'index_launch.py'
    path.write_text("""
import ament_index_python
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    prefix = ament_index_python.get_packages_with_prefixes()['param_tutorial']
    return LaunchDescription([Node(package=prefix, executable='x')])
""")
    monkeypatch.setenv('AMENT_PREFIX_PATH', '/nowhere')
    node, = load_description(path).entities
    assert Path(node.package, 'share/param_tutorial/config/clawbot_config.yaml').is_file()
    assert os.environ['AMENT_PREFIX_PATH'] == '/nowhere'
    # One that has been built and sourced comes first.
    marker = tmp_path / 'share/ament_index/resource_index/packages/param_tutorial'
    marker.parent.mkdir(parents=True)
    marker.touch()
    monkeypatch.setenv('AMENT_PREFIX_PATH', str(tmp_path))
    node, = load_description(path).entities
    assert node.package == str(tmp_path)


def test_where_nothing_is_sourced_and_the_course_must_not_be_found_a_sentence_says_so(monkeypatch):
    monkeypatch.delenv('AMENT_PREFIX_PATH', raising=False)
    monkeypatch.setenv('PARAM_TUTORIAL_OWN_NODES', '0')
    _, err, status = launch('param_tutorial', 'simple_param_launch.py')
    assert status == 1
    assert err.startswith("Package 'param_tutorial' not found: ")
    assert 'AMENT_PREFIX_PATH' not in os.environ


def test_modules_that_were_there_before_are_there_again(launch_file, monkeypatch):
    mine = type(sys)('launch')
    monkeypatch.setitem(sys.modules, 'launch', mine)
    load_description(launch_file("        Node(package='p', executable='e')"))
    assert sys.modules['launch'] is mine


@pytest.mark.parametrize(('text', 'why'), [
    ('from launch.actions import TimerAction', r'has no launch\.actions\.TimerAction; .* it has DeclareLaunchArgument'),
    ('from launch_ros.actions import ComposableNodeContainer', r'has no launch_ros\.actions\.ComposableNodeContainer'),
    ('import launch.event_handlers', r'has no module launch\.event_handlers'),
    ('import launch\nlaunch.LaunchService', r'has no launch\.LaunchService'),
    ('from launch_ros.actions import Node\nNode(package="p", executable="e", respawn=True)', "'respawn'"),
    ('from launch import LaunchDescription\nLaunchDescription([1])', 'takes Node and DeclareLaunchArgument here'),
])
def test_what_only_a_full_installation_has_is_rejected_by_name(launch_file, text, why):
    path = launch_file('', head=f'{text}\ndef generate_launch_description():\n    return ([')
    with pytest.raises(LaunchFailed, match=f'(?s){why}.*environment/README.md'):
        load_description(path)


@pytest.mark.parametrize('name', ['some_launch.xml', 'some_launch.yaml'])
def test_other_formats_are_rejected(launch_file, name):
    with pytest.raises(LaunchFailed, match=rf'{name} is no launch file in Python.*environment/README.md'):
        load_description(launch_file('', name=name))


@pytest.mark.parametrize(('text', 'why'), [
    ('x = 1', "required function 'generate_launch_description"),
    ('x =', 'SyntaxError'),
    ('def generate_launch_description():\n    return 5', 'must return a LaunchDescription, and returned 5'),
    ('def generate_launch_description():\n    return 1 / 0', 'ZeroDivisionError'),
])
def test_a_file_that_is_none(tmp_path, text, why):
    path = tmp_path / 'x_launch.py'
    path.write_text(text)
    assert not launch(path, in_notebook=False)[0]
    with pytest.raises(LaunchFailed, match=why):
        load_description(path)


# -- command lines --------------------------------------------------------------------------------------------------


def test_name_namespace_remappings_and_arguments_in_the_order_of_launch_ros(context):
    node = Node(package='p', executable='e', name='clawbot', namespace='lab', remappings=[('a', 'b')],
                arguments=['--fast'], ros_arguments=['--log-level', 'debug'])
    assert node.command(['program'], context) == [
        'program', '--fast', '--ros-args', '--log-level', 'debug', '-r', '__node:=clawbot', '-r', '__ns:=/lab',
        '-r', 'a:=b']
    assert Node(package='p', executable='e').command(['program'], context) == ['program', '--ros-args']


def test_files_and_dictionaries_keep_their_order(context, tmp_path):
    (tmp_path / 'a.yaml').write_text('first: 1')
    node = Node(package='p', executable='e', parameters=[tmp_path / 'a.yaml', {'speed': 200}])
    after, files = arguments(node, context)
    assert after[::2] == ['--params-file', '--params-file']
    assert files == [{'first': 1}, {'/**': {'ros__parameters': {'speed': 200}}}]


def test_a_dictionary_names_the_node_where_the_launch_file_names_it_in_full(context):
    _, files = arguments(Node(package='p', executable='e', name='n', parameters=[{'x': 1}]), context)
    assert list(files[0]) == ['/**']
    _, files = arguments(Node(package='p', executable='e', name='n', namespace='ns', parameters=[{'x': 1}]), context)
    assert list(files[0]) == ['/ns/n']


def test_values_are_what_launch_ros_makes_of_them(context, tmp_path):
    path = tmp_path / 'v.py'
    path.write_text(HEAD + """
        Node(package='p', executable='e', parameters=[{
            'text': '42', 'flag': True, 'mixed': [1, 2.5], 'inner': {'kp': 1.5},
            'speed': LaunchConfiguration('speed'), 'gains': LaunchConfiguration('gains'),
            'joined': [LaunchConfiguration('speed'), '0'],
            'name': ParameterValue(LaunchConfiguration('name'), value_type=str),
            'wide': ParameterValue(LaunchConfiguration('speed'), value_type=float),
            'missing': LaunchConfiguration('missing', default='off')}])])
""")
    (node,) = load_description(path).entities
    _, files = arguments(node, context)
    assert files[0]['/**']['ros__parameters'] == {
        'text': '42', 'flag': True, 'mixed': [1.0, 2.5], 'inner.kp': 1.5, 'speed': 60, 'gains': [1.0, 2.0],
        'joined': 600, 'name': '42', 'wide': 60.0, 'missing': False}


def test_a_parameter_file_that_is_missing_is_a_warning_only(context):
    node = Node(package='p', executable='e', parameters=['/nowhere/x.yaml'])
    assert node.command(['program'], context) == ['program', '--ros-args']
    assert context.warnings == ['Parameter file path is not a file: /nowhere/x.yaml']


@pytest.mark.parametrize('value', [None, [], [1, 'a'], {1, 2}])
def test_what_cannot_be_a_parameter(context, value):
    with pytest.raises(LaunchFailed, match='cannot be the value of a parameter'):
        Node(package='p', executable='e', parameters=[{'x': value}]).command(['program'], context)


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
                       ([], 'Required launch argument "robot" was not provided'),
                       (['fast'], "malformed launch argument 'fast'")):
        _, err, status = launch(path, *words, in_notebook=False)
        assert status == 1
        assert why in err


def test_mistakes_have_a_sentence(launch_file):
    assert 'was not found in the share directory of package' in launch('param_tutorial', 'no_launch.py')[1]
    assert launch('nobody', 'no_launch.py')[1].startswith("Package 'nobody' not found: \"package 'nobody' not found")
    assert "Terminal('ros2 launch param_tutorial simple_param_launch.py')" in launch(
        'param_tutorial', 'simple_param_launch.py')[1]
    path = launch_file("        Node(package='param_tutorial', executable='nope')")
    assert launch(path, in_notebook=False)[1:] == (
        '[ERROR] [launch]: Caught exception in launch (see debug for traceback): No executable found\n', 1)


@pytest.mark.slow
@pytest.mark.parametrize(('words', 'expected'), [
    (['simple_param_launch.py'], {'robot_name': 'AlphaClaw', 'max_speed_rpm': 180, 'enable_safety_mode': False}),
    (['override_param_launch.py'], {'robot_name': 'AlphaClaw', 'max_speed_rpm': 200, 'enable_safety_mode': True}),
    (['argument_param_launch.py', 'robot_name:=42', 'max_speed_rpm:=60'],
     {'robot_name': '42', 'max_speed_rpm': 60, 'enable_safety_mode': True}),
], ids=lambda value: value[0] if isinstance(value, list) else '')
def test_the_courses_launch_files_start_the_robot(ros, words, expected):
    terminal = Terminal(' '.join(['ros2 launch param_tutorial', *words]))
    terminal.read(until='robot_serial_number')
    assert ParameterClient('/simple_param_node', timeout_sec=30).get_parameters(list(expected)) == expected
    assert terminal.interrupt() == 0
    lines = terminal.text.splitlines()
    assert lines[:2] == ['[INFO] [launch]: Default logging verbosity is set to INFO',
                         '[INFO] [simple_param_node-1]: process started']
    assert lines[-2:] == ['[WARNING] [launch]: user interrupted with ctrl-c (SIGINT)',
                          '[INFO] [simple_param_node-1]: process has finished cleanly']


@pytest.mark.slow
def test_several_nodes_are_ended_together_also_by_sigterm(ros, launch_file):
    path = launch_file("""
        Node(package='param_tutorial', executable='simple_param_node', name='a', output='screen'),
        Node(package='param_tutorial', executable='simple_param_node', name='b', namespace='x', output='screen')""")
    terminal = Terminal(f'ros2 launch {path}')
    for name in ('/a', '/x/b'):
        wait_until(lambda name=name: name in ros.services.node_names(), name, 30)
        ParameterClient(name, timeout_sec=30).list_parameters()
    children = psutil.Process(terminal._process.pid).children()
    terminal._process.send_signal(signal.SIGTERM)
    terminal.read(until='user interrupted with SIGTERM')
    assert terminal.interrupt() == 0
    assert terminal.text.count('process has finished cleanly') == 2
    assert not any(child.is_running() for child in children)


@pytest.mark.slow
def test_a_program_that_dies_is_told_of_and_ends_the_launch(launch_file):
    path = launch_file("""        Node(package='param_tutorial', executable='simple_param_node', output='screen',
             parameters=[{'max_speed_rpm': 'fast'}])""")
    done = subprocess.run([sys.executable, '-m', 'param_tutorial', 'launch', str(path)], capture_output=True, text=True,
                          env={**os.environ, 'ROS_DOMAIN_ID': '0', 'ROS_AUTOMATIC_DISCOVERY_RANGE': 'LOCALHOST'})
    assert done.returncode == 0  # as the genuine command: the launch itself did what it was told
    assert '[ERROR] [simple_param_node-1]: process has died [exit code 1, cmd' in done.stdout
    assert "'max_speed_rpm' to 'fast' of type 'STRING', expecting type 'INTEGER'" in done.stdout
