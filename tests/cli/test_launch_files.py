"""Launch files as people write them: the embedded launch beside recorded answers of the genuine one."""

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
import yaml

from param_tools.cli.launch.actions import carry_out
from param_tools.cli.launch.context import Context, LaunchFailed
from param_tools.cli.launch.markup import load
from param_tools.cli.launch.rehearsal import RehearsedLaunch
from param_tools.cli.launch.verb import include
from tests.support.commands import run

FOLDER = Path(__file__).parent / 'launch_files'
RECORDED = json.loads((FOLDER / 'recorded.json').read_text())


@pytest.fixture
def context(tmp_path, monkeypatch):
    """A context that knows any program."""
    monkeypatch.setattr(Context, 'find_program', lambda _self, package, executable: [f'{package}/{executable}'])
    return Context(folder=tmp_path)


def comparable(words, written):
    """Return a command line with the content of each file that launch has written."""
    return [yaml.safe_load(Path(word).read_text()) if Path(word).parent == written else word for word in words]


@pytest.mark.parametrize('case', RECORDED, ids=lambda case: ' '.join((case['file'], *case['arguments'].values())))
def test_the_command_lines_are_those_of_the_genuine_launch(case, context):
    path, arguments = FOLDER / case['file'], case['arguments']
    if 'error' in case:
        with pytest.raises(LaunchFailed, match=f'^{re.escape(case["error"])}$'):
            carry_out([include(path, arguments)], context)
        return
    programs = carry_out([include(path, arguments)], context)
    # launch_ros writes --ros-args twice where ros_arguments are given, which changes nothing.
    found = json.dumps([comparable(program.command, context.folder) for program in programs])
    assert json.loads(found.replace(str(FOLDER), 'FOLDER')) == [
        [word for number, word in enumerate(words) if word != '--ros-args' or word not in words[:number]]
        for words in case['commands']]


def test_programs_have_the_environment_of_their_place(context):
    programs = {each.name: each for each in carry_out([include(FOLDER / 'functions_launch.py', {})], context)}
    assert [programs[name].environment['TRY'] for name in ('set', 'in_group', 'after_group')] == ['1', '2', '1']
    assert programs['set'].environment['TRY_PATH'] == 'c:a:b;d'


# -- launch files in XML and YAML -----------------------------------------------------------------------------------


@pytest.mark.parametrize(('text', 'why'), [
    ('<include/>', "Attribute 'file' not found in Entity 'include'"),
    ('<node pkg="p" exec="e" tint="red"/>', "no attribute or nested tag 'tint' in `node`: the genuine"),
    ('<nod/>', 'has no action `nod`: the genuine'),
    ('<group if="1" unless="1"/>', "can't be used simultaneously"),
    ('<node pkg="p" exec="e"><param name="x" value="null"/></node>', "cannot be 'null': .* type='str' keeps it a text"),
    ('<node pkg="p" exec="e" args="\'open"/>', 'No closing quotation'),
    ('[node]', "what is below 'launch' has to be a list of entries with one key each"),
    ('[{arg: {name: x, default: true}}]', "'arg' has to be a text, and is True: put quotes around it"),
])
def test_what_is_wrong_in_xml_and_in_yaml_is_named(write, text, why):
    is_xml = text.startswith('<')
    path = write(f'<launch>{text}</launch>', 'x.launch.xml') if is_xml else write(f'launch: {text}', 'x.launch.yaml')
    with pytest.raises(LaunchFailed, match=why):
        load(path)


# -- check --launch -------------------------------------------------------------------------------------------------

LAUNCH = """
from pathlib import Path

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess, GroupAction, RegisterEventHandler
from launch.event_handlers import OnProcessExit
from launch.substitutions import Command, FindExecutable, LaunchConfiguration
from launch_ros.actions import ComposableNodeContainer, Node, PushRosNamespace, SetParameter
from launch_ros.descriptions import ComposableNode
from launch_ros.parameter_descriptions import ParameterFile, ParameterValue

FOLDER = Path(__file__).parent


def generate_launch_description():
    first = ExecuteProcess(cmd=['sh', '-c', 'exit 1'])
    return LaunchDescription([
        DeclareLaunchArgument('speed', default_value='fast'), first,
        GroupAction([
            PushRosNamespace('lab'), SetParameter('use_sim_time', True),
            Node(package='nobody_has_it', executable='simple_param_node', name='clawbot', parameters=[
                ParameterFile(FOLDER / 'robot.yaml', allow_substs=True),
                {'max_speed_rpm': LaunchConfiguration('speed')}])]),
        ComposableNodeContainer(
            name='box', namespace='', package='rclcpp_components', executable='component_container',
            parameters=[FOLDER / 'robot.yaml'], composable_node_descriptions=[
                ComposableNode(package='p', plugin='p::Camera', name='camera', parameters=[{'rate': 30.0}])]),
        RegisterEventHandler(OnProcessExit(target_action=first, on_exit=[
            Node(package='p', executable='describer', parameters=[{'robot_description': ParameterValue(
                Command([FindExecutable(name='xacro'), ' robot.xacro']), value_type=str)}])])),
    ])
"""
ROBOT = """/**/clawbot:
  ros__parameters:
    robot_name: $(var speed)bot
    max_sped_rpm: 5
"""


@pytest.fixture
def lab(tmp_path, ros):
    """A folder with a launch file, its parameter file and the description of a node."""
    (tmp_path / 'lab_launch.py').write_text(LAUNCH)
    (tmp_path / 'robot.yaml').write_text(ROBOT)
    from param_tutorial.nodes.simple_param_node import SimpleParamNode

    ros.add(SimpleParamNode)
    assert run('describe', '/simple_param_node', '--save', tmp_path / 'saved.yaml')[2] == 0
    ros.remove_all()
    return tmp_path


def check(*words):
    return run('check', '--launch', *words, in_notebook=False, get_executor=pytest.fail)


def test_check_launch_shows_what_each_node_would_get_from_where_and_what_it_would_reject(lab):
    stdout, stderr, status = check(lab / 'lab_launch.py', '--against', lab / 'saved.yaml')
    assert stdout.replace(f'{lab}/', '') == """\
/lab/clawbot  (nobody_has_it/simple_param_node)
  max_sped_rpm: 5        robot.yaml:4
  max_speed_rpm: 'fast'  lab_launch.py:23
  robot_name: 'fastbot'  robot.yaml:3
  use_sim_time: True     lab_launch.py:20
/box  (rclcpp_components/component_container)
  no parameters
/camera  (p/p::Camera)
  rate: 30.0  lab_launch.py:27
/describer  (p/describer, whose node may have another name)
  robot_description: '$(command xacro)'  lab_launch.py:29
robot.yaml:4:5: unknown parameter: /lab/clawbot has no parameter 'max_sped_rpm'. Did you mean max_speed_rpm?
lab_launch.py:23:1: wrong type: max_speed_rpm of /lab/clawbot cannot be 'fast': it is of type integer, and 'fast' is \
a string
"""
    assert stderr == 'Not checked, because nothing is known of these nodes: /box, /camera, /describer\n'
    assert status == 1


def test_a_value_that_another_file_overrides_is_found_where_a_person_wrote_it(lab):
    (lab / 'robot.yaml').write_text('/lab/clawbot: {ros__parameters: {use_sim_time: false}}')
    path = lab / 'lab_launch.py'
    path.write_text(LAUNCH.replace(
        "{'max_speed_rpm': LaunchConfiguration('speed')}", "'/nowhere/x.yaml'"))
    stdout, _, status = check(path)
    assert f'{path}:21:1: unreadable: Parameter file path is not a file: /nowhere/x.yaml\n' in stdout
    assert f'  use_sim_time: False  {lab}/robot.yaml:1\n' in stdout
    assert status == 1


PLACES = {
    'rates_launch.py': '''
import yaml
from launch import LaunchDescription
from launch_ros.actions import Node, SetParameter

# The rate is in Hz.
def robot(name, rate):
    return Node(package='p', executable='robot', namespace='', name=name,
                parameters=[{'rate': rate, 'size.width': 1}, {'size': {
                    'depth': 2}}])


def generate_launch_description():
    loaded = yaml.safe_load('{speed: 1}')
    return LaunchDescription([
        SetParameter('debug', True), robot('left', 10.0), robot('right', 'fast'),
        Node(package='p', executable='robot', namespace='', name='third', parameters=[
            loaded, {'rate': 3.0}]),
        Node(package='p', executable='robot', namespace='', name='fourth',
             additional_env={
                 'speed': '2'},
             parameters=[
                 {'speed': 2}, loaded])])
''',
    'rates_launch.xml': '''<launch>
  <!-- the rate is in Hz -->
  <node pkg="p" exec="robot" name="left" namespace=""><param name="rate" value="1.0"/>
    <param name="size" value="1"/></node>
  <set_parameter name="debug" value="true"/>
  <node pkg="p" exec="robot" name="right" namespace="">
    <param name="rate" value="fast"/></node>
  <include file="rates_launch.yaml"/>
</launch>
''',
    'rates_launch.yaml': '''launch:
- let: {name: rate, value: '5'}
- node:
    pkg: p
    exec: robot
    name: third
    namespace: ''
    param:
    - {name: size, value: 3}
    - name: rate
      value: $(var rate)
''',
}


@pytest.mark.parametrize(('file', 'places'), [
    ('rates_launch.py', {'/left debug': 16, '/left rate': 9, '/left size.width': 9, '/left size.depth': 10,
                         '/right debug': 16, '/right rate': 9, '/right size.width': 9, '/right size.depth': 10,
                         '/third debug': 16, '/third speed': 17, '/third rate': 18,
                         '/fourth debug': 16, '/fourth speed': 19}),
    ('rates_launch.xml', {'/left rate': 3, '/left size': 4, '/right debug': 5, '/right rate': 7, '/third debug': 5,
                          '/third rate': 'rates_launch.yaml:10', '/third size': 'rates_launch.yaml:9'}),
])
def test_check_launch_names_the_line_that_sets_a_value(tmp_path, monkeypatch, file, places):
    monkeypatch.chdir(tmp_path)
    for name, content in PLACES.items():
        (tmp_path / name).write_text(content)
    found, node = {}, ''
    for line in check(file)[0].replace(f'{tmp_path}/', '').splitlines():
        words = line.split()
        if line.startswith('/'):
            node = words[0]
        else:
            found[f'{node} {words[0].rstrip(":")}'] = words[-1]
    assert found == {name: place if isinstance(place, str) else f'{file}:{place}' for name, place in places.items()}
    (tmp_path / file).write_text(f'\n{PLACES[file]}')  # edited, and checked once more
    assert f'{file}:{places["/left rate"] + 1}\n' in check(file)[0]


IMPORTS = '''
from launch import LaunchDescription
from launch_ros.actions import LoadComposableNodes, Node, SetParameter, SetUseSimTime
from launch_ros.descriptions import ComposableNode


def node(*parameters, **options):
    return Node(package='p', executable='e', name='n', namespace='', parameters=list(parameters), **options)


def component(*parameters, **options):
    return LoadComposableNodes(target_container='box', composable_node_descriptions=[
        ComposableNode(package='p', plugin='p::Camera', parameters=list(parameters), **options)])


def generate_launch_description():
    return LaunchDescription([
        {}])
'''


def findings(tmp_path, actions, content=''):
    """Return what check says of a launch file in Python that gives nodes the file robot.yaml."""
    (tmp_path / 'robot.yaml').write_text(content)
    (tmp_path / 'x_launch.py').write_text(IMPORTS.replace('{}', actions.replace('FILE', f"'{tmp_path}/robot.yaml'")))
    stdout, stderr, status = check(tmp_path / 'x_launch.py')
    assert (stderr, status) in (('', 0), ('', 1)), stderr
    return stdout.replace(f'{tmp_path}/', '').splitlines()


@pytest.mark.parametrize(('actions', 'found'), [
    ("node({'vendor': '0483'})", "the text '0483' for vendor without its quotes, so that rcl reads 483.0: write it"),
    ("node({'serial': '123E5'})", "the text '123E5' for serial without its quotes, so that rcl reads 12300000.0:"),
    ("node({'axis': ['y', 'n']})", "the text 'y' for axis without its quotes, so that rcl reads [True, False]:"),
    ("SetParameter('id', '12'), node()", "the text '12' for id without its quotes, so that rcl reads 12:"),
    ("SetParameter('k', [1, 2]), node()", "so that /n gets the text '(1, 2)' for k: give the list in parameters="),
    ("node({'/**': {'ros__parameters': {'rate': 1}}})", 'so that /n gets a parameter /**.ros__parameters.rate: give'),
    ("node({'n': {'ros__parameters': {'rate': 1}}})", 'so that /n gets a parameter n.ros__parameters.rate: give'),
    ("component({'ros__parameters': {'a': 1}}, name='n')", 'so that /n gets a parameter ros__parameters.a: give'),
    ('SetUseSimTime(True), node()', "SetUseSimTime sets use_sim_time of launch's own node, and no node"),
])
def test_what_launch_hands_on_otherwise_than_it_is_written_is_found(tmp_path, actions, found):
    said, = [line for line in findings(tmp_path, actions) if 'likely mistake' in line]
    assert said.startswith('x_launch.py:')
    assert found in said


@pytest.mark.parametrize('actions', [
    "node({'a': '12', 'b': 'x1', 'c': '1.5', 'd': ['1', '2']})", "component({'a': '0483'}, name='n')",
    "SetParameter('id', 12), node()", "SetParameter('id', '12'), component()",
    "node(shell=True, sigterm_timeout='9', sigkill_timeout='9', respawn_max_retries=3, log_cmd=True)"])
def test_what_launch_hands_on_as_it_is_written_is_not_found(tmp_path, actions):
    assert 'likely mistake' not in str(findings(tmp_path, actions))


@pytest.mark.parametrize(('content', 'given'), [
    ('n: {ros__parameters: {a: 1e-3, b: 12:30:00, c: 1_000}}', {'a': "'1e-3'", 'b': '45000', 'c': '1000'}),
    ('rate: &r 30\ndeep:\n  er: *r', {'rate': '30', 'deep.er': '30'}),  # no header
    ('n: {ros__parameters: {a: 1}}\n/**: {ros__parameters: {a: 2, b: [0, 0.5]}}', {'a': '1', 'b': '[0.0, 0.5]'}),
    ('other: {ros__parameters: {a: 1}}', {}),
    ('a: [1, true]', {'a': '[1, 1]'}),
])
def test_a_component_gets_what_launch_ros_reads_for_it(tmp_path, content, given):
    lines = findings(tmp_path, "component(FILE, name='n')", content)
    assert lines[0] == '/n  (p/p::Camera)'
    found = {name: value.rpartition('  ')[0].strip() for name, value in (
        line.strip().split(': ', 1) for line in lines[1:] if line != '  no parameters')}
    assert found == given


@pytest.mark.parametrize(('actions', 'content', 'found'), [
    ("component(FILE, name='n')", '/**:\n  n: {ros__parameters: {a: 1}}', '2:1: never matched: launch ignores'),
    ("component(FILE, name='n')", '/*: {ros__parameters: {a: 1}}', '1:1: never matched: launch ignores'),
    ('component(FILE)', 'n: {ros__parameters: {a: 1}}', ' never matched: launch gives a component without name='),
    ("component(FILE, name='n')", 'a: 1\nb: null', "2:1: unreadable: launch reads a component's file with Py"),
    ("component(FILE, name='n')", 'n:\n  ros__parameters:', 'with PyYAML, and ends: nothing is below ros'),
    ("component(FILE, name='n')", 'a: 1\nb: [', "2:1: unreadable: launch reads a component's file with Py"),
    ("component(FILE, name='n')", 'a: 1\nb: $(env HOME)', '2:1: not filled in: /n gets this text as it stands'),
    ('node(FILE)', 'n: {ros__parameters: {a: "${HOME}/x"}}', 'Neither launch nor rcl replaces ${HOME}: write $(env'),
    ("Node(package='controller_manager', executable='spawner', arguments=['arm', '--param-file', FILE])",
     'arm:\n  gains: 1', '1:1: no header: the file has no ros__parameters'),
    ('node(FILE)', 'n: {ros__parameters: {a: $(find x)}}', 'Launch has no $(find …), which is of ROS 1: write'),
])
def test_what_a_file_of_a_launch_file_says_in_vain_is_found(tmp_path, actions, content, found):
    said, = [line for line in findings(tmp_path, actions, content) if line.startswith('robot.yaml:')]
    assert found in said


@pytest.mark.parametrize(('text', 'found'), [
    ('<launch>\n <node pkg="p" name="b"/>\n</launch>', "2: Attribute 'exec' not found"),
    ('<launch>\n <node pkg="p" exec="e">\n  <param name="a"/></node></launch>', '3: either a value attribute or'),
    ('<launch>\n <node', '2: Caught exception when trying to load'),
    ('launch:\n- node:\n    exec: [1', '3: Caught exception when trying to load'),
    ('launch:\n- let: {name: a, value: b}\n- nod: {exec: e}', '3: the course'),
    ('<launch>\n <param name="rate" value="10"/></launch>', "2: launch rejects 'param' in `launch`, "),
    ('<launch>\n <node pkg="p" type="e"/></launch>', "2: launch rejects 'type' in `node`, "),
    ('<launch>\n <group ns="p"/></launch>', "2: launch rejects 'ns' in `group`, "),
    ('<launch>\n <let name="a" value="$(arg b)"/></launch>', '2: launch has no substitution $(arg b), which'),
    ('<launch>\n <let name="a" value="$(var b)"/></launch>', "2: launch configuration 'b' does not exist"),
    ('<launch><node exec="e">\n <param name="a" from="b" allow_substs="yes!"/></node></launch>', '2: Cannot'),
    ('<launch><node exec="e">\n <param name="a" value="[1, 2.5]"/></node></launch>', '2: launch rejects the list'),
    ('launch:\n- node:\n    exec: e\n    param: [{name: a, value: [true, 2.5]}]', '4: launch rejects the list'),
])
def test_an_error_of_an_included_launch_file_names_its_file_and_line(tmp_path, write, text, found):
    path = write(text, 'inner.launch.xml' if text.startswith('<') else 'inner.launch.yaml')
    outer = write(f'<launch><include file="{path}"/></launch>', 'outer.launch.xml')
    stdout, stderr, status = check(outer)
    assert (stdout, status) == ('', 2)
    assert stderr.startswith(f'{path}:{found}')


@pytest.mark.parametrize(('actions', 'found'), [
    ("node({'a': [{'b': 1}]})", "8: a: ROS has no lists of maps or of lists, and launch rejects [{'b': 1}]: give"),
    ("component({'a': [[1, 2]]}, name='n')", '13: a: ROS has no lists of maps or of lists, and launch rejects'),
    ("node(__import__('launch_ros').descriptions.ParameterFile('x', allow_substs='true'))", '18: ParameterFile takes'),
    ("node(), component(name='a b')", '13: Invalid node name'),
    ("node({'a': __import__('launch').substitutions.PythonExpression('[')})", '8: the expression'),
    ("node(__import__('launch_ros').substitutions.FindPackageShare('-'))", "8: '-' is not"),
    ("node(*__import__('yaml').safe_load('[{a: [[1.5]]}]'))", '8: a: ROS has no lists of maps or of lists, and launch'),
])
def test_what_launch_rejects_has_the_line_of_the_call(write, actions, found):
    path = write(IMPORTS.replace('{}', actions), 'x_launch.py')
    stdout, stderr, status = check(path)
    assert (stdout, status) == ('', 2)
    assert stderr.startswith(f'{path}:{found}')


def test_a_launch_file_takes_functions_of_another_one(tmp_path):
    (tmp_path / 'lib.py').write_text(IMPORTS)
    lib = "__import__('launch').launch_description_sources.load_python_launch_file_as_module(__file__[:-11] + 'lib.py')"
    assert findings(tmp_path, f"{lib}.node({{'rate': 1}})")[1] == '  rate: 1  lib.py:8'


def test_an_option_that_has_another_name_since_galactic_is_named(tmp_path, write):
    path = write(IMPORTS.replace('{}', "node(node_executable='e')"), 'x_launch.py')
    assert 'ROS 2 has called it executable= since Galactic, and launch rejects the old name' in check(path)[1]


def test_a_substitution_that_nothing_fills_in_is_found(lab):
    path = lab / 'lab_launch.py'
    path.write_text(LAUNCH.replace("'robot.yaml', allow_substs=True", "'robot.yaml'"))
    assert f'{lab}/robot.yaml:3:17: not filled in: /lab/clawbot gets this text as it stands: launch' in check(path)[0]


def test_a_file_that_holds_nothing_for_the_node_that_gets_it_is_found(lab):
    (lab / 'robot.yaml').write_text(ROBOT.replace('/**/clawbot', '/clawbot'))
    stdout, _, status = check(lab / 'lab_launch.py', 'speed:=5')
    assert stdout.splitlines()[-1] == (
        f'{lab}/robot.yaml:1:1: never matched: the launch file gives /lab/clawbot this file, and no block in it is for '
        f'that node: it has /clawbot')  # and the container's file is for what it loads
    assert status == 1


def test_what_cannot_be_rehearsed_is_an_error_of_the_check(lab):
    (lab / 'empty_launch.py').write_text('from launch import LaunchDescription as generate_launch_description')
    assert check(lab / 'empty_launch.py') == ('The launch file starts no node.\n', '', 0)
    for words, why in (([lab / 'lab_launch.py', 'speed:='], 'malformed launch argument'),
                       ([lab / 'none_launch.py'], 'is not a launch file here'),
                       ([FOLDER / 'inner/inner_launch.py'], "missing required argument 'robot'")):
        stdout, stderr, status = check(*words)
        assert (stdout, status) == ('', 2)
        assert why in stderr


def test_a_rehearsal_leaves_the_environment_as_it_was_and_loads_no_ros(tmp_path):
    before = dict(os.environ)
    launch = RehearsedLaunch(FOLDER / 'functions_launch.py', {}, tmp_path)
    assert [given.value for given in launch.given(next(each for each in launch.nodes if each.name == '/set'))] == [
        'c:a:b;d', 1]
    assert dict(os.environ) == before
    code = ('import sys; from param_tools.cli import command, session; '
            'command.main(sys.argv[1:], session.Session(sys.stdout, sys.stderr, None, in_notebook=False)); '
            'print([name for name in ("rclpy", "IPython") if name in sys.modules])')
    shown = subprocess.run([sys.executable, '-c', code, 'check', '--launch', str(FOLDER / 'groups_launch.py')],
                           capture_output=True, text=True, check=True).stdout
    assert shown.splitlines()[-1] == '[]'
