"""%ros2 and %%ros2 in an IPython shell: what is typed, where it goes, and which ros2 answers."""

import functools
import os
import re
import signal
import stat
import subprocess
import sys
import textwrap
import threading

import pytest
from IPython.utils.capture import capture_output

import param_tutorial
from param_tools.cli import genuine
from param_tools.ros import domain, environment
from param_tutorial import ParameterClient, Terminal, wait_until
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from param_tutorial.notebook import magics


@pytest.fixture
def shell(ipython):
    return ipython


@pytest.fixture
def cell(shell, monkeypatch):
    """Run a cell; return what it printed on standard output and standard error, and the exit status."""
    monkeypatch.setenv('PARAM_TOOLS_ROS2', 'embedded')

    def run(text):
        with capture_output() as captured:
            result = shell.run_cell(text)
        result.raise_error()
        return captured.stdout, captured.stderr, shell.user_ns.get('_exit_code')

    return run


@pytest.fixture
def node(ros):
    return ros.add(SimpleParamNode)


def test_an_answer_goes_to_standard_output_and_a_rejection_to_standard_error(cell, node):
    assert cell('%ros2 param set /simple_param_node max_speed_rpm 150') == ('Set parameter successful\n', '', 0)
    assert cell('%ros2 param get /simple_param_node max_speed_rpm') == ('Integer value is: 150\n', '', 0)
    stdout, stderr, status = cell('%ros2 param set /simple_param_node max_speed_rpm -1')
    assert (stdout, status) == ('', 0)
    assert stderr == 'Setting parameter failed: max_speed_rpm must not be negative, got -1\n'
    assert cell('%ros2 param get /nobody x') == ('', 'Node not found\n', 1)


def test_without_an_executor_it_says_what_to_do(cell):
    param_tutorial.stop()
    stdout, stderr, status = cell('%ros2 node list')
    assert (stdout, status) == ('', 1)
    assert stderr.count('\n') == 1
    assert 'call start() first' in stderr


@pytest.mark.parametrize('value', ['{robot}', '$robot', '[{a: 1}]', 'a > b', 'a | b', 'x#1', 'a;b', 'back\\slash'])
def test_values_in_quotes_arrive_as_they_are_typed(cell, shell, node, value):
    shell.user_ns['robot'] = 'EXPANDED'
    # Quoted twice, as learners are told to: once for the command line, once for YAML.
    assert cell(f"""%ros2 param set /simple_param_node robot_name "'{value}'" """)[1:] == ('', 0)
    assert ParameterClient('/simple_param_node').get_parameter('robot_name') == value


def test_a_cell_runs_one_command_a_line_and_goes_on_after_a_failure(cell, node):
    stdout, stderr, status = cell(textwrap.dedent('''\
        %%ros2
        # The word ros2 may be there, as in a terminal.
        ros2 param get /nobody x

        param set /simple_param_node \\
            max_speed_rpm 170   # and a comment here
        param get /simple_param_node max_speed_rpm
        '''))
    assert stdout == 'Set parameter successful\nInteger value is: 170\n'
    assert stderr == 'Node not found\n'
    assert status == 0


def test_output_goes_into_a_file(cell, node, tmp_path):
    path = tmp_path / 'my file.yaml'
    assert cell(f'%ros2 param dump /simple_param_node > "{path}"') == ('', '', 0)
    assert path.read_text().startswith('/simple_param_node:\n  ros__parameters:\n')
    assert cell(f'%ros2 param get /simple_param_node robot_name >>"{path}"') == ('', '', 0)
    assert path.read_text().endswith('\nString value is: Clawbot\n')
    assert cell(f'%ros2 param get /nobody robot_name > "{path}"') == ('', 'Node not found\n', 1)
    assert path.read_text() == ''


@pytest.mark.parametrize(('line', 'complaint'), [
    ('param list | sort', "'|' needs a shell"),
    ('param list>a|sort', "'|' needs a shell"),
    ('param list; node list', "';' needs a shell"),
    ('run param_tutorial simple_param_node &', "'&' needs a shell"),
    ('param list >', 'a file name must follow'),
    ('param list 2> a', 'only one >'),
    ('param list > a >> b', 'only one >'),
    ('param list >>> a', 'only one >'),
    ("param set /n a 'x", 'cannot be split'),
    ('param list > no/such/folder/file', 'No such file or directory'),
    # The advice leaves the other nodes alone: start() would remove them.
    ('run param_tutorial simple_param_node', "Run it beside the notebook: terminal = param_tutorial.Terminal('ros2 run "
     "param_tutorial simple_param_node'); or add its node to the executor in the notebook: ros.add(...)\n"),
])
def test_what_is_not_one_command_is_rejected_with_a_sentence(cell, ros, line, complaint):
    stdout, stderr, status = cell(f'%ros2 {line}')
    assert (stdout, status) == ('', 1)
    assert complaint in stderr
    assert stderr.count('\n') == 1


@pytest.mark.parametrize(('line', 'words', 'target'), [
    ("param set /n a '>'", ['param', 'set', '/n', 'a', '>'], None),
    (r'param set /n a \>', ['param', 'set', '/n', 'a', '>'], None),
    ("param set /n a ''", ['param', 'set', '/n', 'a', ''], None),
    (r'param set /n a "\"|\"" # a comment > f', ['param', 'set', '/n', 'a', '"|"'], None),
    ('param set /n a x#1', ['param', 'set', '/n', 'a', 'x#1'], None),
    ("param set /n a 'x #1'>f", ['param', 'set', '/n', 'a', 'x #1'], 'f'),
    ('param set /n a 2 > f', ['param', 'set', '/n', 'a', '2'], 'f'),
    ('ros2 param > f dump /n', ['param', 'dump', '/n'], 'f'),
    ("param list > '>'", ['param', 'list'], '>'),
    (' # ros2 param list | sort', [], None),
])
def test_a_line_is_split_as_bash_splits_it(tmp_path, line, words, target):
    assert magics._parse(line) == (words, target, False)
    functions = """ros2() { printf '%s\\0' "$@"; }; param() { ros2 param "$@"; }"""
    done = subprocess.run(['bash', '-c', f'{functions}\n{line}'], cwd=tmp_path, capture_output=True, check=True)
    output = done.stdout if target is None else (tmp_path / target).read_bytes()
    assert output.decode().split('\0')[:-1] == words
    assert [path.name for path in tmp_path.iterdir()] == ([] if target is None else [target])


def test_nothing_typed_does_nothing_and_help_is_help(cell, ros):
    assert cell('%ros2')[:2] == ('', '')
    stdout, stderr, status = cell('%ros2 --help')
    assert 'param' in stdout
    assert (stderr, status) == ('', 0)


class Recorder:
    """A stream that notes what reaches it, and in which order."""

    def __init__(self, name, notes):
        self.name, self.notes, self.pending = name, notes, ''

    def write(self, text):
        self.pending += text
        return len(text)

    def flush(self):
        if self.pending:
            self.notes.append((self.name, self.pending))
            self.pending = ''


def test_one_stream_is_flushed_before_the_other_is_written():
    notes = []
    streams = magics._Streams(Recorder('out', notes), Recorder('err', notes))
    for stream, text in ((streams.stdout, 'a'), (streams.stderr, 'b'), (streams.stdout, 'c'), (streams.stdout, 'd')):
        stream.write(text)
    streams.flush()
    assert notes == [('out', 'a'), ('err', 'b'), ('out', 'cd')]


# -- the genuine command ---------------------------------------------------------------------------------------

FAKE = '''\
#!{python} -IS
import os, signal, sys, time
sys.stdout.write('genuine ' + ' '.join(sys.argv[1:]) + '\\n')
sys.stdout.flush()
sys.stderr.write('domain %s libraries %s\\n' % (os.environ['ROS_DOMAIN_ID'], os.environ.get('LD_LIBRARY_PATH')))
if sys.argv[1:] == ['wait']:
    try:
        open(os.environ['READY'], 'w').close()
        signal.pause()
    except KeyboardInterrupt:
        sys.stdout.write('interrupted\\n')
sys.exit(7)
'''


@pytest.fixture
def fake_ros2(tmp_path, monkeypatch):
    """Put a program called ros2 on the PATH, in an install space that has been sourced."""
    path = tmp_path / 'opt' / 'bin' / 'ros2'
    path.parent.mkdir(parents=True)
    (tmp_path / 'opt' / 'lib').mkdir()
    # It needs no packages, and a first line may have no space before its first option.
    path.write_text(FAKE.format(python=os.path.realpath(sys.executable)))
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    monkeypatch.setenv('PATH', f'{path.parent}{os.pathsep}{os.environ["PATH"]}')
    monkeypatch.setenv('AMENT_PREFIX_PATH', str(tmp_path / 'opt'))
    monkeypatch.setenv('READY', str(tmp_path / 'ready'))
    return path


@pytest.fixture
def cell_with_genuine(cell, monkeypatch, fake_ros2):
    monkeypatch.delenv('PARAM_TOOLS_ROS2')
    return cell


def test_the_genuine_command_is_preferred_and_gets_its_own_libraries(cell_with_genuine, fake_ros2):
    stdout, stderr, status = cell_with_genuine("%ros2 param set /n a 'b c'")
    assert stdout == 'genuine param set /n a b c\n'
    assert stderr == f'domain {domain.choose()} libraries {fake_ros2.parents[1] / "lib"}\n'
    assert status == 7


def test_the_embedded_one_can_be_asked_for(cell, fake_ros2, node):
    assert cell('%ros2 param get /simple_param_node robot_name') == ('String value is: Clawbot\n', '', 0)


def test_output_of_the_genuine_command_goes_into_a_file(cell_with_genuine, tmp_path):
    stdout, _, _ = cell_with_genuine(f'%ros2 param dump /n > {tmp_path}/out')
    assert stdout == ''
    assert (tmp_path / 'out').read_text() == 'genuine param dump /n\n'


def test_the_genuine_command_may_not_block_the_cell_either(cell_with_genuine):
    stdout, stderr, status = cell_with_genuine('%ros2 run demo talker')
    assert (stdout, status) == ('', 1)
    assert 'Terminal' in stderr


@pytest.mark.parametrize('line', ['launch demo demo_launch.py --show-args', 'run --help', 'launch -h'])
def test_the_genuine_command_runs_what_ends_by_itself(cell_with_genuine, line):
    stdout, _, status = cell_with_genuine(f'%ros2 {line}')
    assert (stdout, status) == (f'genuine {line}\n', 7)


def test_the_courses_own_nodes_are_started_by_its_own_command(cell_with_genuine, tmp_path):
    """The package has not been built, so the genuine command would not find it."""
    stdout, _, status = cell_with_genuine('%ros2 launch param_tutorial argument_param_launch.py --show-args')
    assert ("'robot_name':" in stdout, status) == (True, 0)
    theirs, ours = tmp_path / 'theirs_launch.py', tmp_path / 'ours_launch.py'
    theirs.write_text("Node(package='demo', executable='talker')")
    ours.write_text("Node(package='param_tutorial', executable='simple_param_node')")
    assert genuine.path_for(['launch', str(theirs)]) == genuine.path()
    assert genuine.path_for(['launch', str(ours)]) is None
    assert genuine.path_for(['run', '--prefix', 'nice', 'param_tutorial', 'simple_param_node']) is None
    assert genuine.path_for(['param', 'list', '/param_tutorial']) == genuine.path()
    assert genuine.path_for(['diff', '/a', '/b']) is None
    assert genuine.path_for(['param', 'get', '--all-nodes', 'rate']) is None


def test_an_old_build_of_the_course_is_not_found(tmp_path, monkeypatch, fake_ros2):
    """In the user's own workspace, which a .bashrc has sourced."""
    spaces = [tmp_path / 'isolated' / 'param_tutorial', tmp_path / 'merged']
    for space in spaces:
        marker = space / 'share' / 'ament_index' / 'resource_index' / 'packages' / 'param_tutorial'
        marker.parent.mkdir(parents=True)
        marker.touch()
    monkeypatch.setenv('AMENT_PREFIX_PATH', os.pathsep.join([*map(str, spaces), str(fake_ros2.parents[1])]))
    monkeypatch.setenv('COLCON_PREFIX_PATH', os.pathsep.join([str(tmp_path / 'isolated'), str(tmp_path / 'other')]))
    environment.drop_old_builds()
    assert os.environ['AMENT_PREFIX_PATH'] == str(fake_ros2.parents[1])
    assert os.environ['COLCON_PREFIX_PATH'] == str(tmp_path / 'other')


@pytest.mark.slow
def test_a_terminal_starts_them_too(ros, cell_with_genuine):
    terminal = Terminal('ros2 run param_tutorial simple_param_node')
    assert 'max_speed_rpm: 100' in terminal.read(until='max_speed_rpm')
    assert terminal.interrupt() == 0


@pytest.mark.slow
@pytest.mark.parametrize('end', ['', '; import os; os.kill(os.getpid(), 9)'], ids=['ended', 'killed'])
@pytest.mark.parametrize('used', ['genuine.command(["param", "list"])', 'Shell().run("ros2 param list")'],
                         ids=['command', 'shell'])
@pytest.mark.parametrize('chosen', ['', '7'], ids=['claimed', 'chosen'])
def test_the_daemon_of_a_claimed_domain_ends_with_the_kernel(fake_ros2, tmp_path, chosen, used, end):
    log = tmp_path / 'log'
    fake_ros2.write_text(f'#!/bin/sh\necho $ROS_DOMAIN_ID "$@" >> {log}\n')
    source = ('from param_tools.cli import genuine; from param_tools.ros import domain; '
              f'from param_tutorial import Shell; domain.choose(); {used}; '
              f'guard = genuine.stop_daemon_in_the_end(); assert not guard or guard.poll() is None{end}')
    environment = {**domain.environment_without_domain(), **({'ROS_DOMAIN_ID': chosen} if chosen else {})}
    environment.pop('PARAM_TOOLS_ROS2', None)
    done = subprocess.run([sys.executable, '-c', source], env=environment, capture_output=True, text=True)
    assert done.returncode == (-9 if end else 0)
    stopped = re.compile(r'[0-9]+ daemon stop\n')
    if not chosen:
        wait_until(lambda: log.exists() and stopped.search(log.read_text()), 'the daemon to be stopped')
    assert len(stopped.findall(log.read_text() if log.exists() else '')) == (0 if chosen else 1)


@pytest.mark.parametrize('before', [signal.default_int_handler, signal.SIG_IGN], ids=['heeded', 'ignored'])
def test_an_interrupt_is_passed_on_to_the_genuine_command(cell_with_genuine, tmp_path, request, before):
    request.addfinalizer(functools.partial(signal.signal, signal.SIGINT, signal.signal(signal.SIGINT, before)))

    def interrupt():
        # The cell has shown what the command printed before: starting it is over, and an interrupt is for the command.
        wait_until(lambda: 'domain' in getattr(sys.stderr, 'getvalue', str)() and (tmp_path / 'ready').exists(),
                   'the command to wait', timeout_sec=30)
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=interrupt)
    thread.start()
    try:
        stdout, _, status = cell_with_genuine('%ros2 wait')
    finally:
        thread.join()
    assert stdout == 'genuine wait\ninterrupted\n'
    assert status == 7


def test_python_packages_of_the_sourced_ros_are_found_again(fake_ros2, tmp_path, monkeypatch):
    packages = fake_ros2.parents[1] / 'lib' / 'python3.12' / 'site-packages'
    packages.mkdir(parents=True)
    monkeypatch.setenv('PYTHONPATH', '/ours')
    monkeypatch.setenv('LD_LIBRARY_PATH', '/ours')
    assert genuine.environment()['PYTHONPATH'] == str(packages)
    # As `colcon build --symlink-install` leaves it.
    listed = fake_ros2.parents[1] / 'share' / 'lift' / 'package.dsv'
    hook = tmp_path / 'build' / 'lift' / 'share' / 'lift' / 'hook' / 'pythonpath_develop.dsv'
    for path in (listed, hook):
        path.parent.mkdir(parents=True)
    listed.write_text('source;share/lift/hook/ament_prefix_path.dsv\n'
                      'source;../build/lift/share/lift/hook/pythonpath_develop.dsv\n')
    hook.write_text('prepend-non-duplicate;PYTHONPATH;/ws/build/lift')
    assert genuine.environment()['PYTHONPATH'] == f'/ws/build/lift{os.pathsep}{packages}'
    monkeypatch.delenv('AMENT_PREFIX_PATH')
    assert not {'PYTHONPATH', 'LD_LIBRARY_PATH'} & genuine.environment().keys()


# -- a terminal beside the notebook ----------------------------------------------------------------------------


@pytest.mark.slow
def test_the_line_for_a_terminal_makes_it_see_the_nodes(node, cell):
    line = magics.terminal_line()
    plain = {name: value for name, value in os.environ.items() if not name.startswith(('ROS_', 'FAST'))}
    done = subprocess.run(['bash', '-O', 'expand_aliases', '-c', f'{line}\nros2 node list'], env=plain,
                          capture_output=True, text=True)
    assert (done.stdout, done.stderr) == ('/simple_param_node\n', '')


def test_the_hint_shows_the_line_and_is_the_same_in_every_stored_output(shell, cell, fake_ros2, monkeypatch):
    hint = shell.run_line_magic('ros2_terminal', '')
    assert f'ROS_DOMAIN_ID={domain.choose()}' in hint.value
    assert str(domain.choose()) not in repr(hint)
    monkeypatch.delenv('PARAM_TOOLS_ROS2')
    assert 'alias' not in magics.terminal_line()


def test_the_first_cell_may_be_run_again(shell):
    for _ in range(2):
        with capture_output() as captured:
            shell.run_cell('%load_ext param_tutorial')
        assert (captured.stdout, captured.stderr) == ('', '')
    shell.run_cell('%reload_ext param_tutorial')
    assert shell.events.callbacks['pre_run_cell'].count(magics._before_cell) == 1


def test_loading_again_keeps_no_second_copy_and_brings_the_magic_back(shell):
    shell.register_magic_function(lambda line: 'not ours', magic_name='ros2')
    for _ in range(3):
        shell.run_cell('%load_ext param_tutorial')
    ours = [each for each in shell.configurables if isinstance(each, magics.Ros2Magics)]
    assert len(ours) == 1
    assert shell.find_line_magic('ros2') == ours[0].line


def test_unloaded_it_gives_exit_and_quit_back(shell):
    shell.run_cell('%unload_ext param_tutorial')
    try:
        assert shell.user_ns['exit'] is shell.user_ns['quit'] is shell.exiter
    finally:
        shell.run_cell('%load_ext param_tutorial')
    assert shell.user_ns['exit'] is not shell.exiter


def test_a_cell_reads_only_what_was_logged_since_it_began(shell, ros):
    node = ros.add(SimpleParamNode)
    node.get_logger().info('before the cell')
    shell.user_ns.update(ros=ros, node=node)
    with capture_output() as captured:
        shell.run_cell("node.get_logger().info('in the cell')\nprint(ros.node_log.read(until='in the cell'))")
    assert captured.stdout == '[INFO] [simple_param_node]: in the cell\n'
