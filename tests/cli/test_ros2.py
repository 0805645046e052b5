"""The embedded ros2 where no recording goes: mistakes, nodes that are late, busy, gone or double, and run."""

import os
import signal
import subprocess
import sys
import threading

import psutil
import pytest
from rcl_interfaces.msg import ParameterDescriptor
from rcl_interfaces.srv import GetParameters
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.parameter_service import ParameterService

from param_tools.cli import param, session
from param_tools.cli.run import node_programs
from param_tools.ros import executor, graph
from param_tutorial import wait_until
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from param_tutorial.notebook.interrupts import interruptible
from tests.support.commands import run, source_package
from tests.support.processes import environment_without_domain

EMBEDDED = [sys.executable, '-m', 'param_tools']


@pytest.fixture
def start_process(ros):
    """Start processes that are ended with the test, and leave no trace in the graph."""
    started = []

    def start(*words, **options):
        with interruptible():  # whatever has started the tests
            started.append(subprocess.Popen(
                [str(word) for word in words], text=True, start_new_session=True, **options))
        return started[-1]

    yield start
    for process in started:
        # A process that is asked to end says goodbye to the others. A killed one would count as present for a while.
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGINT)
        try:
            process.communicate(timeout=20)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.communicate()
    ros.remove_all()
    wait_until(lambda: ros.services.node_names(hidden=True) == [f'/{executor.TOOL_NODE_NAME}'],
               'the processes to leave the graph', 30)


# -- usage ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(('words', 'complaint'), [
    (['param', 'shout'], "invalid choice: 'shout'"), (['topic', 'echo', '/rosout'], 'The genuine ros2 has more'),
    (['launch', 'param_tutorial', 'x_launch.py', '--debug'], 'The genuine ros2 has more'),
    (['param', 'set', '/n', 'a'], 'the following arguments are required: value'),
    (['param', 'get', '/n', 'a', 'b'], 'unrecognized arguments: b'),
    (['param', 'get', '--timeout', '0.5', '/n', 'a'], "argument --timeout: invalid int value: '0.5'"),
    (['run', 'param_tutorial'], 'the following arguments are required: executable_name'),
])
def test_a_usage_error_says_what_is_wrong_and_starts_nothing(words, complaint):
    stdout, stderr, status = run(*words, get_executor=lambda: pytest.fail('ROS was started'))
    assert (stdout, status) == ('', 2)
    assert stderr.startswith('usage: ros2')
    assert complaint in stderr


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


# -- nodes of other kinds --------------------------------------------------------------------------------------


class Odd(Node):
    """Has a parameter that can go away, and one without a value."""

    def __init__(self, name='odd', **options):
        super().__init__(name, **options)
        self.declare_parameter('anything', 1, ParameterDescriptor(dynamic_typing=True))
        self.declare_parameter('unset', None, ParameterDescriptor(dynamic_typing=True))


def test_delete_and_values_that_are_not_set(ros):
    ros.add(Odd)
    assert run('param', 'get', '/odd', 'unset') == ('Parameter not set.\n', '', 0)
    assert run('param', 'get', '--hide-type', '/odd', 'unset') == ('None\n', '', 0)
    assert run('param', 'delete', '/odd', 'anything') == ('Deleted parameter successfully\n', '', 0)
    assert run('param', 'get', '/odd', 'anything') == ('', 'Parameter not set\n', 1)


def test_a_dump_survives_a_parameter_that_is_also_a_prefix(ros):
    node = ros.add(Odd)
    node.set_parameters([Parameter('unset', value=0)])
    for name in ('a', 'a.b', 'c.d', 'c.e'):
        node.declare_parameter(name, 1)
    assert '    a: 1\n    a.b: 1\n' in run('param', 'dump', '/odd')[0]
    assert '    c:\n      d: 1\n      e: 1\n' in run('param', 'dump', '/odd')[0]


def test_a_node_without_parameter_services_is_named_as_the_genuine_command_does(ros, monkeypatch):
    monkeypatch.setattr(session, 'SERVICE_TIMEOUT_SEC', 0.3)
    ros.add(Odd)
    ros.add(Odd, 'mute', start_parameter_services=False)
    sentence = 'Wait for service timed out waiting for parameter services for node'
    listed = f"{sentence} NodeName(name='mute', namespace='/', full_name='/mute')\n"
    assert run('param', 'list', '/mute') == (listed, '', 0)
    stdout, stderr, status = run('param', 'list')
    assert stdout.startswith(f'{listed}/odd:\n  anything\n')
    assert (stderr, status) == ('', 0)
    for words in (['get', '/mute', 'x'], ['set', '/mute', 'x', '1'], ['delete', '/mute', 'x'],
                  ['describe', '/mute', 'x']):
        assert run('param', *words) == ('', f'{sentence} /mute\n', 1)
    assert run('param', 'dump', '/mute') == ('', f'{sentence} /mute\n', 0)


def test_services_that_come_later_than_their_node_are_waited_for(ros):
    node = ros.add(Odd, 'late', start_parameter_services=False)
    timer = threading.Timer(graph.DISCOVERY_SEC + 0.5, ParameterService, [node])
    timer.start()
    assert run('param', 'get', '/late', 'use_sim_time') == ('Boolean value is: False\n', '', 0)
    timer.join()


def test_a_busy_node_is_given_up_after_a_while(silent, monkeypatch):
    for module in (session, param):
        monkeypatch.setattr(module, 'SERVICE_TIMEOUT_SEC', 0.3)
    stdout, stderr, status = run('param', 'get', '/silent', 'use_sim_time')
    assert (stdout, status) == ('', 1)
    assert '/silent did not answer get_parameters within 0.3 s' in stderr
    stdout, stderr, status = run('param', 'list', '/silent')
    assert (stdout, status) == ('', 0)
    assert "Exception while calling service of node '/silent'" in stderr


# -- discovery ----------------------------------------------------------------------------------------------


# Prints a line when its node is there, and ends when it is asked to.
LATE = '''
import signal
import rclpy
from rclpy.node import Node
rclpy.init(signal_handler_options=rclpy.signals.SignalHandlerOptions.NO)
node = Node('late')
ended = []
signal.signal(signal.SIGINT, lambda *_: ended.append(1))
print('ready', flush=True)
while not ended:
    rclpy.spin_once(node, timeout_sec=0.1)
node.destroy_node()
rclpy.shutdown()
'''


def test_a_node_that_has_just_been_started_is_found_at_once(ros, start_process):
    late = start_process(sys.executable, '-c', LATE, stdout=subprocess.PIPE)
    assert late.stdout.readline() == 'ready\n'  # its participant exists, and nothing has been waited for
    assert run('param', 'get', '/late', 'use_sim_time') == ('Boolean value is: False\n', '', 0)


def test_an_unknown_node_is_waited_for_as_long_as_asked(ros):
    threading.Timer(0.3, lambda: ros.add(Odd, 'late')).start()
    assert run('param', 'get', '--timeout', '30', '/late', 'anything') == ('Integer value is: 1\n', '', 0)


# -- run ------------------------------------------------------------------------------------------------------


@pytest.mark.thorough
@pytest.mark.parametrize('program', node_programs('param_tutorial'))
def test_ctrl_c_ends_a_running_node_without_a_word(program, start_process):
    process = start_process(*EMBEDDED, 'run', 'param_tutorial', program, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    # It answers, so its constructor is done.
    node = {'base_node': '/base', 'driver_node': '/driver'}.get(program, f'/{program}')
    assert run('param', 'get', '--timeout', '30', node, 'use_sim_time')[2] == 0
    os.killpg(process.pid, signal.SIGINT)  # as a terminal does
    stdout, stderr = process.communicate()
    assert process.returncode == 0
    assert 'Traceback' not in stderr
    assert '[ros2run]' not in stdout


@pytest.mark.parametrize(('number', 'until'), [
    (signal.SIGINT, 'robot_serial_number'), (signal.SIGTERM, 'has been started')],
    ids=['spinning', 'in its constructor'])
def test_a_signal_ends_the_command_and_its_node_well(number, until, start_process):
    process = start_process(*EMBEDDED, 'run', 'param_tutorial', 'simple_param_node', stderr=subprocess.PIPE)
    text = next(line for line in process.stderr if until in line)
    child, = psutil.Process(process.pid).children()
    # Ctrl+C reaches the command and its node alike; SIGTERM is passed on.
    os.killpg(process.pid, number) if number == signal.SIGINT else process.send_signal(number)
    _, rest = process.communicate()
    assert process.returncode == 0
    assert 'Traceback' not in text + rest
    assert not child.is_running()


@pytest.mark.parametrize(('words', 'complaint'), [
    (['param_tutorial', 'no_such_node'], 'No executable found'),
    (['param_tutorial', '__init__'], 'No executable found'),
    (['no_such_package', 'x'], "Package 'no_such_package' not found"),
])
def test_run_names_what_it_cannot_find(words, complaint):
    assert run('run', *words) == ('', f'{complaint}\n', 1)


@pytest.fixture
def workspace(tmp_path, monkeypatch):
    """Source an install space with one package, ``mine``; gives a function that puts programs into it."""
    source_package('mine', tmp_path, monkeypatch)

    def add(name, text=''):
        path = tmp_path / 'lib/mine' / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(f'#!/bin/sh\n{text}\n')
        path.chmod(0o755)
        return path

    return add


@pytest.mark.parametrize(('last', 'said', 'status'), [
    ('exit 3', '[ros2run]: Process exited with failure 3\n', 3),
    ('kill -SEGV $$', '[ros2run]: Segmentation fault\n', 256 - signal.SIGSEGV)])
def test_run_starts_programs_of_a_sourced_workspace_and_says_how_they_failed(workspace, last, said, status):
    workspace('hello', f'echo hello $1\n{last}')
    done = subprocess.run([*EMBEDDED, 'run', 'mine', 'hello', 'you'], capture_output=True, text=True)
    assert (done.stdout, done.stderr, done.returncode) == (f'hello you\n{said}', '', status)


def test_run_finds_a_program_in_a_sub_folder_and_there_must_be_one(workspace):
    only, first, second = workspace('tools/only'), workspace('twice'), workspace('tools/twice')
    workspace('.hidden/secret')
    (only.parent / 'notes').write_text('not a program')
    stderr = run('run', 'mine', 'only')[1]
    assert 'Type it in a terminal: ros2 run mine only' in stderr
    assert run('run', 'mine', 'twice') == ('', f'Multiple executables found:\n- {first}\n- {second}\n', 1)
    for name in ('notes', 'secret', 'bye'):
        assert run('run', 'mine', name) == ('', 'No executable found\n', 1)


# -- as a process ---------------------------------------------------------------------------------------------


def test_a_process_without_a_domain_is_where_everybody_is():
    environment = environment_without_domain()
    program = ('import os, sys; sys.argv[1:] = ["-h"]; import param_tools.__main__ as m; m.main(); '
               'print(os.environ["ROS_DOMAIN_ID"])')
    done = subprocess.run([sys.executable, '-c', program], env=environment, capture_output=True, text=True)
    assert done.stdout.splitlines()[-1] == '0'


def test_a_second_ctrl_c_while_a_command_tidies_up_says_nothing():
    program = ('import atexit, os, sys; atexit.register(lambda: os.kill(os.getpid(), 2)); '
               'sys.argv[1:] = ["-h"]; import param_tools.__main__ as m; sys.exit(m.main())')
    done = subprocess.run([sys.executable, '-c', program], capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, '')
    assert done.stdout.startswith('usage: ros2')


def test_ctrl_c_ends_a_command_that_waits(ros, start_process):
    node = ros.add(Node, 'silent_node', start_parameter_services=False)
    is_asked, may_answer = threading.Event(), threading.Event()

    def answer(_, response):
        is_asked.set()
        may_answer.wait(60)
        return response

    node.create_service(GetParameters, 'silent_node/get_parameters', answer)
    process = start_process(*EMBEDDED, 'param', 'get', '--timeout', '600', '/silent_node', 'x',
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert is_asked.wait(60)
    os.killpg(process.pid, signal.SIGINT)
    assert process.communicate() == ('', '')
    assert process.returncode == 2
    may_answer.set()
