"""The embedded ros2 where no recording goes: mistakes, nodes that are late, busy, gone or double, and run."""

import io
import os
import re
import signal
import socket
import subprocess
import sys
import threading

import pytest
from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tutorial import wait_until
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from param_tutorial.notebook.interrupts import interruptible
from param_tutorial.ros2 import command, session
from param_tutorial.ros2.run import node_programs
from param_tutorial.runtime import domain, executor, graph, stage

EMBEDDED = [sys.executable, '-m', 'param_tutorial']


def run(*words, in_notebook=True, get_executor=stage.current):
    """Run a command in this process: standard output, standard error, exit status."""
    stdout, stderr = io.StringIO(), io.StringIO()
    status = command.main([str(word) for word in words], stdout=stdout, stderr=stderr, get_executor=get_executor,
                       in_notebook=in_notebook)
    return stdout.getvalue(), stderr.getvalue(), status


@pytest.fixture
def start_process(ros):
    """Start processes that are ended with the test, and leave no trace in the graph."""
    started = []

    def start(*words, **options):
        with interruptible():  # whatever has started the tests
            started.append(subprocess.Popen([str(word) for word in words], text=True, **options))
        return started[-1]

    yield start
    for process in started:
        # Asked politely, a process takes leave of the others; killed, it would count as present for a while.
        process.send_signal(signal.SIGINT)
        process.send_signal(signal.SIGCONT)
        try:
            process.communicate(timeout=20)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
    ros.remove_all()
    wait_until(lambda: ros.services.node_names(hidden=True) == [f'/{executor.TOOL_NODE_NAME}'],
               'the processes to leave the graph', 30)


def program_of(name):
    """Return the command line of a program with one node, which says when it is ready and ends when it is told to."""
    return sys.executable, '-c', f'''
import signal, rclpy
from rclpy.node import Node
rclpy.init(signal_handler_options=rclpy.signals.SignalHandlerOptions.NO)
node = Node({name!r})
told = []
signal.signal(signal.SIGINT, lambda *_: told.append(1))
print('ready', flush=True)
while not told:
    rclpy.spin_once(node, timeout_sec=0.1)
node.destroy_node()
rclpy.shutdown()
'''


def ready(process):
    """Wait for the line in which a program says that it is ready."""
    assert process.stdout.readline() == 'ready\n'


# -- usage ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(('words', 'complaint'), [
    (['topic', 'list'], "invalid choice: 'topic'"),
    (['param', 'shout'], "invalid choice: 'shout'"),
    (['param', 'get', '/n'], 'the following arguments are required: parameter_name'),
    (['param', 'set', '/n', 'a'], 'the following arguments are required: value'),
    (['param', 'get', '/n', 'a', 'b'], 'unrecognized arguments: b'),
    (['param', 'get', '--timeout', 'soon', '/n', 'a'], "invalid float value: 'soon'"),
    (['run', 'param_tutorial'], 'the following arguments are required: executable_name'),
])
def test_a_usage_error_says_what_is_wrong_and_starts_nothing(words, complaint):
    stdout, stderr, status = run(*words, get_executor=lambda: pytest.fail('ROS was started'))
    assert (stdout, status) == ('', 2)
    assert stderr.startswith('usage: ros2')
    assert complaint in stderr


@pytest.mark.parametrize('words', [[], ['--help'], ['param'], ['node'], ['param', 'set', '-h'], ['run', '-h']])
def test_help_goes_to_standard_output(words):
    stdout, stderr, status = run(*words, get_executor=lambda: pytest.fail('ROS was started'))
    assert stdout.startswith('usage: ros2')
    assert (stderr, status) == ('', 0)


@pytest.mark.parametrize(('words', 'complaint'), [
    (['param', 'list', '--filter', '(', '/simple_param_node'], "'(' is not a regular expression"),
    (['param', 'set', '/simple_param_node', 'max_speed_rpm', '9' * 20], 'does not fit into the 64 bits'),
    (['param', 'get', '/not a name', 'x'], 'Node not found'),
    (['param', 'get', '/', 'x'], 'Node not found'),
    (['param', 'load', '/simple_param_node', '.'], 'cannot read .: Is a directory'),
])
def test_nonsense_gets_one_sentence(ros, words, complaint):
    ros.add(SimpleParamNode)
    stdout, stderr, status = run(*words)
    assert (stdout, status) == ('', 1)
    assert complaint in stderr
    assert stderr.count('\n') == 1


@pytest.mark.parametrize('content', ['[1, 2', '- a', 'a', '', '/n: 1', '/n: {ros__parameters: {a: 2024-01-01}}',
                                     '/n: {ros__parameters: {a: "@x"}}', b'\xff\xfe\x00'])
def test_a_file_that_is_none_gets_a_sentence_and_no_traceback(ros, tmp_path, content):
    ros.add(SimpleParamNode)
    (tmp_path / 'bad.yaml').write_bytes(content if isinstance(content, bytes) else content.encode())
    stdout, stderr, status = run('param', 'load', '/simple_param_node', tmp_path / 'bad.yaml')
    assert (stdout, status) == ('', 1)
    assert stderr
    assert 'Traceback' not in stderr


@pytest.mark.parametrize('option', [['--spin-time', '0.1'], ['-s'], ['--use-sim-time'], ['--no-daemon'],
                                    ['--timeout', '2'], ['--include-hidden-nodes']])
def test_options_without_effect_here_are_accepted(ros, option):
    ros.add(SimpleParamNode)
    assert run('param', 'get', *option, '/simple_param_node', 'robot_name') == ('String value is: Clawbot\n', '', 0)


# -- nodes of other kinds --------------------------------------------------------------------------------------


class Odd(Node):
    """A hidden node with a parameter that can go away, and one without a value."""

    def __init__(self, name='_odd', namespace='/', **options):
        super().__init__(name, namespace=namespace, **options)
        self.declare_parameter('anything', 1, ParameterDescriptor(dynamic_typing=True))
        self.declare_parameter('unset', None, ParameterDescriptor(dynamic_typing=True))


def test_hidden_nodes_are_shown_on_request(ros):
    ros.add(SimpleParamNode)
    ros.add(Odd)
    assert run('node', 'list') == ('/simple_param_node\n', '', 0)
    assert run('node', 'list', '-c') == ('1\n', '', 0)
    assert '/_odd\n' in run('node', 'list', '-a')[0]
    assert run('param', 'get', '/_odd', 'anything') == ('', 'Node not found\n', 1)
    assert run('param', 'get', '--include-hidden-nodes', '/_odd', 'anything') == ('Integer value is: 1\n', '', 0)
    assert '/_odd' not in run('param', 'list')[0]
    assert run('param', 'list', '--include-hidden-nodes')[0].startswith('/_odd:\n  anything\n')


def test_delete_and_values_that_are_not_set(ros):
    ros.add(Odd, 'odd')
    assert run('param', 'get', '/odd', 'unset') == ('Parameter not set.\n', '', 0)
    assert run('param', 'get', '--hide-type', '/odd', 'unset') == ('None\n', '', 0)
    assert run('param', 'delete', '/odd', 'anything') == ('Deleted parameter successfully\n', '', 0)
    assert run('param', 'get', '/odd', 'anything') == ('', 'Parameter not set\n', 1)


def test_an_empty_list_is_one_of_booleans_as_for_the_genuine_command(ros):
    node = ros.add(Odd, 'odd')
    assert run('param', 'set', '/odd', 'anything', '[]')[2] == 0
    assert node.get_parameter('anything').type_ is Parameter.Type.BOOL_ARRAY


def test_a_dump_survives_a_parameter_that_is_also_a_prefix(ros):
    node = ros.add(Odd, 'odd')
    node.set_parameters([Parameter('unset', value=0)])
    for name in ('a', 'a.b', 'c.d', 'c.e'):
        node.declare_parameter(name, 1)
    assert '    a: 1\n    a.b: 1\n' in run('param', 'dump', '/odd')[0]
    assert '    c:\n      d: 1\n      e: 1\n' in run('param', 'dump', '/odd')[0]


def test_a_node_without_parameter_services_is_passed_over_and_named_when_asked(ros, monkeypatch):
    monkeypatch.setattr(session, 'SERVICE_TIMEOUT_SEC', 0.3)
    monkeypatch.setattr(graph, 'SERVICES_SEC', 0.3)
    ros.add(SimpleParamNode)
    ros.add(Odd, 'mute', start_parameter_services=False)
    assert run('param', 'list')[0].count(':\n') == 1
    stdout, stderr, status = run('param', 'get', '/mute', 'anything')
    assert (stdout, status) == ('', 1)
    assert 'start_parameter_services=False' in stderr


@pytest.mark.slow
def test_a_busy_node_is_given_up_after_a_while(ros, monkeypatch, start_process):
    monkeypatch.setattr(session, 'SERVICE_TIMEOUT_SEC', 0.3)
    stopped = start_process(*program_of('sleeper'), stdout=subprocess.PIPE)
    ready(stopped)
    for service in ('get_parameters', 'list_parameters'):
        wait_until(lambda: ros.services.is_ready('/sleeper', service), service, 30)  # noqa: B023
    stopped.send_signal(signal.SIGSTOP)
    stdout, stderr, status = run('param', 'get', '/sleeper', 'use_sim_time')
    assert (stdout, status) == ('', 1)
    assert '/sleeper did not answer get_parameters within 0.3 s' in stderr
    stdout, stderr, status = run('param', 'list', '/sleeper')
    assert (stdout, status) == ('', 0)
    assert "Exception while calling service of node '/sleeper'" in stderr


def test_a_callback_that_raises_is_told(ros):
    node = ros.add(SimpleParamNode)
    node.add_on_set_parameters_callback(lambda parameters: 1 / 0)
    stdout, stderr, status = run('param', 'set', '/simple_param_node', 'max_speed_rpm', '7')
    assert (stdout, status) == ('', 1)
    assert 'ZeroDivisionError' in stderr
    assert run('param', 'get', '/simple_param_node', 'max_speed_rpm') == ('Integer value is: 100\n', '', 0)


@pytest.mark.slow
def test_two_nodes_of_one_name_are_warned_of(ros, start_process):
    ros.add(SimpleParamNode)
    start_process(*EMBEDDED, 'run', 'param_tutorial', 'simple_param_node',
                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    wait_until(lambda: len(ros.node_incarnations('/simple_param_node')) == 2, 'the second node', 30)
    stdout, stderr, status = run('node', 'list')
    assert (stdout, status) == ('/simple_param_node\n' * 2, 0)
    assert stderr == ('WARNING: Be aware that there are nodes in the graph that share an exact name, '
                      'which can have unintended side effects.\n')
    assert run('param', 'list', '/simple_param_node')[0].count('robot_name') == 1


# -- discovery ----------------------------------------------------------------------------------------------


@pytest.mark.slow
def test_a_node_that_has_just_been_started_is_found_at_once(ros, start_process):
    late = start_process(*program_of('late'), stdout=subprocess.PIPE)
    ready(late)  # its participant exists, and nothing has been waited for
    assert run('param', 'get', '/late', 'use_sim_time') == ('Boolean value is: False\n', '', 0)


def test_an_unknown_node_is_waited_for_as_long_as_asked(ros):
    threading.Timer(0.3, lambda: ros.add(Odd, 'late')).start()
    assert run('param', 'get', '--timeout', '30', '/late', 'anything') == ('Integer value is: 1\n', '', 0)


def test_a_port_that_never_answers_is_not_waited_for_for_ever(ros, monkeypatch):
    ros.add(SimpleParamNode)
    assert run('param', 'get', '/nobody', 'x') == ('', 'Node not found\n', 1)
    wait_until(lambda: graph.is_complete(ros.tool_node), 'the graph', 30)
    monkeypatch.setattr(graph, 'PATIENCE_SEC', 0.2)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as silent:
        silent.bind(('127.0.0.1', 7400 + 250 * ros.domain_id + 10 + 2 * 100))
        assert not graph.is_complete(ros.tool_node)
        assert run('param', 'get', '/nobody', 'x') == ('', 'Node not found\n', 1)
    assert graph.is_complete(ros.tool_node)


# -- run ------------------------------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize('program', node_programs())
def test_ctrl_c_ends_a_running_node_without_a_word(program, start_process):
    process = start_process(*EMBEDDED, 'run', 'param_tutorial', program, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    # It answers, so its constructor is done.
    assert run('param', 'get', '--timeout', '30', f'/{program}', 'use_sim_time')[2] == 0
    process.send_signal(signal.SIGINT)
    _, stderr = process.communicate(timeout=60)
    assert process.returncode == 0
    assert 'Traceback' not in stderr


@pytest.mark.slow
def test_run_hands_arguments_on(ros, start_process):
    process = start_process(
        *EMBEDDED, 'run', 'param_tutorial', 'simple_param_node',
        '--ros-args', '-r', '__ns:=/left', '-p', 'max_speed_rpm:=7',
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    assert run('param', 'get', '--timeout', '30', '/left/simple_param_node', 'max_speed_rpm') == (
        'Integer value is: 7\n', '', 0)
    assert process.poll() is None


@pytest.mark.slow
def test_run_gives_the_exit_status_and_takes_a_prefix():
    done = subprocess.run(
        [*EMBEDDED, 'run', 'param_tutorial', 'simple_param_node', '--ros-args', '--params-file', '/nowhere'],
        capture_output=True, text=True, timeout=60)
    assert done.returncode == 1
    done = subprocess.run([*EMBEDDED, 'run', '--prefix', 'echo -n', 'param_tutorial', 'simple_param_node', 'x'],
                          capture_output=True, text=True, timeout=60)
    assert done.stdout.endswith('param_tutorial.nodes.simple_param_node x')


@pytest.mark.parametrize(('words', 'complaint'), [
    (['param_tutorial', 'no_such_node'], 'No executable found'),
    (['param_tutorial', '__init__'], 'No executable found'),
    (['no_such_package', 'x'], "Package 'no_such_package' not found"),
])
def test_run_names_what_it_cannot_find(words, complaint):
    assert run('run', *words) == ('', f'{complaint}\n', 1)


def test_run_starts_programs_of_a_sourced_workspace(tmp_path, monkeypatch):
    marker = tmp_path / 'share/ament_index/resource_index/packages/mine'
    program = tmp_path / 'lib/mine/hello'
    for path in (marker, program):
        path.parent.mkdir(parents=True)
    marker.touch()
    program.write_text('#!/bin/sh\necho hello $1\nexit 3\n')
    program.chmod(0o755)
    monkeypatch.setenv('AMENT_PREFIX_PATH', str(tmp_path))
    done = subprocess.run([*EMBEDDED, 'run', 'mine', 'hello', 'you'], capture_output=True, text=True, timeout=60)
    assert (done.stdout, done.stderr, done.returncode) == ('hello you\n', '', 3)
    assert run('run', 'mine', 'bye') == ('', 'No executable found\n', 1)


def test_the_programs_that_colcon_installs_are_the_same(request):
    setup = (request.config.rootpath / 'param_tutorial/setup.py').read_text()
    assert sorted(re.findall(r"'(\w+) = [\w.]+:main'", setup)) == node_programs()


# -- as a process ---------------------------------------------------------------------------------------------


def test_a_process_without_a_domain_is_where_everybody_is():
    environment = domain.environment_without_domain()
    program = ('import os, sys; sys.argv[1:] = ["-h"]; import param_tutorial.__main__ as m; m.main(); '
               'print(os.environ["ROS_DOMAIN_ID"])')
    done = subprocess.run([sys.executable, '-c', program], env=environment, capture_output=True, text=True, timeout=60)
    assert done.stdout.splitlines()[-1] == '0'


@pytest.mark.parametrize('unbuffered', ['', '1'])
def test_a_reader_that_goes_away_causes_no_traceback(ros, unbuffered):
    ros.add(SimpleParamNode)
    done = subprocess.run(['bash', '-c', f'"{sys.executable}" -m param_tutorial param dump /simple_param_node | true'],
                          capture_output=True, text=True, timeout=60,
                          env={**os.environ, 'PYTHONUNBUFFERED': unbuffered})
    assert 'Traceback' not in done.stderr
    assert 'Exception' not in done.stderr


@pytest.mark.slow
def test_ctrl_c_ends_a_command_that_waits(ros, start_process):
    def count():
        return ros.tool_node.get_node_names().count(executor.TOOL_NODE_NAME)

    wait_until(lambda: count() == 1, 'the commands of earlier tests to be gone', 30)
    process = start_process(*EMBEDDED, 'param', 'get', '--timeout', '600', '/nobody', 'x',
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    wait_until(lambda: count() == 2, 'the command to join', 30)
    process.send_signal(signal.SIGINT)
    assert process.communicate(timeout=60) == ('', '')
    assert process.returncode == 2
