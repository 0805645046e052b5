"""background: life and death of the executor, its nodes and its thread."""

import subprocess
import sys
import textwrap
import threading
from pathlib import Path

import pytest
import rclpy
from rclpy.node import Node
from rclpy.signals import SignalHandlerOptions, get_current_signal_handlers_options

import param_tutorial
from param_tools.errors import ExecutorError
from param_tools.ros import stage
from param_tutorial import ParameterClient
from tests.support.processes import environment_without_domain


class Speed(Node):
    """One parameter."""

    def __init__(self, name='speed'):
        super().__init__(name)
        self.declare_parameter('rpm', 1)


def run_python(source, **options):
    """Run a script in its own process and ROS domain: in this domain, killed nodes may linger."""
    environment = environment_without_domain()
    return subprocess.run([sys.executable, '-c', textwrap.dedent(source)], capture_output=True, text=True,
                          check=False, **{'env': environment, **options})


def test_a_second_node_of_the_same_class_replaces_the_first(ros):
    first = ros.add(Speed)
    second = ros.add(Speed)
    assert ros.nodes == (second,)
    assert first is not second
    assert ros.services.node_names() == ['/speed']
    assert ParameterClient(second).set_parameter('rpm', 2).successful
    second.get_logger().info('here I am')
    assert ros.node_log.read(until='here') == '[INFO] [speed]: here I am'


def test_remapped_and_namespaced_nodes_are_known_by_their_real_names(ros):
    ros.add(Speed, ros_args=['-r', '__node:=fast', '-r', '__ns:=/left'])
    # Rules for one node, and of two for the same thing the first one counts.
    ros.add(Speed, ros_args=['-r', 'speed:__node:=fast', '-r', '__node:=other', '--remap', 'fast:__ns:=/left'])
    ros.add(Speed, 'slow')
    assert len(ros.nodes) == 2
    assert ros.services.node_names() == ['/left/fast', '/slow']


def test_a_constructor_that_fails_leaves_nothing_behind(ros):
    class Broken(Speed):
        def __init__(self):
            super().__init__('broken')
            raise ValueError('broken on purpose')

    class BrokenAtOnce(Node):
        def __init__(self):
            raise ValueError('before there is a node')

    for broken in (Broken, BrokenAtOnce):
        with pytest.raises(ValueError):
            ros.add(broken)
    assert ros.nodes == ()
    assert ros.services.node_names() == []
    # rclpy leaves this one behind, with 0.1 MiB.
    param_tutorial.wait_until(lambda: not ros.tool_node.get_subscriptions_info_by_topic(
        'rq/broken/get_type_descriptionRequest', no_mangle=True), 'its last service to go')


def test_start_again_clears_the_stage(ros):
    ros.add(Speed)
    again = param_tutorial.start()
    assert again is ros
    assert again.nodes == ()
    assert again.node_log.lines() == []
    assert list(again.errors) == []
    assert again.services.node_names() == []


def test_stop_start_stop(ros):
    threads = set(threading.enumerate()) - {ros._loop._thread}
    ros.add(Speed)
    param_tutorial.stop()
    param_tutorial.stop()
    assert not rclpy.ok()
    assert not ros.is_running
    assert set(threading.enumerate()) <= threads
    with pytest.raises(ExecutorError, match='start'):
        stage.current()
    with pytest.raises(ExecutorError, match='start'):
        ros.add(Speed)
    fresh = param_tutorial.start()
    assert fresh is not ros
    assert ParameterClient(fresh.add(Speed)).get_parameter('rpm') == 1


def test_an_rclpy_that_somebody_else_initialised_is_left_alone():
    param_tutorial.stop()
    rclpy.init()
    try:
        with pytest.raises(ExecutorError, match=r'rclpy\.shutdown'):
            param_tutorial.start()
        param_tutorial.stop()
        assert rclpy.ok()
        assert get_current_signal_handlers_options() == SignalHandlerOptions.ALL
    finally:
        rclpy.shutdown()


def test_only_classes_of_nodes_are_added(ros):
    for wrong in ('speed', dict, Speed.__init__):
        with pytest.raises(ExecutorError, match='class derived from'):
            ros.add(wrong)


def test_run_gives_the_result_or_the_exception(ros):
    assert ros.run(threading.current_thread, 'look') is not threading.current_thread()
    with pytest.raises(KeyError, match='x'):
        ros.run(lambda: {}['x'], 'look up')
    assert ros.run(lambda: ros.run(lambda: 5, 'nest'), 'nest') == 5


def test_many_restarts_do_not_pile_up(ros):
    for round_number in range(30):
        client = ParameterClient(ros.add(Speed))
        assert client.set_parameter('rpm', round_number).successful
    threads, files = threading.active_count(), len(list(Path('/proc/self/fd').iterdir()))
    for round_number in range(30):
        client = ParameterClient(ros.add(Speed))
        assert client.set_parameter('rpm', round_number).successful
    # What an earlier test has left may go meanwhile.
    assert threading.active_count() <= threads
    assert len(list(Path('/proc/self/fd').iterdir())) <= files
    assert ros.services.node_names() == ['/speed']


# A thread that spins while the interpreter ends aborts the process with status 134 (claims.md, 2g).
@pytest.mark.parametrize('ending', ['', 'param_tutorial.stop()'])
def test_the_interpreter_ends_well_with_a_busy_node(ending):
    done = run_python(f'''
        import sys, rclpy, param_tutorial
        from rclpy.node import Node
        class Busy(Node):
            def __init__(self):
                super().__init__('busy')
                self.count = 0
                self.create_timer(0.001, self.tick)
            def tick(self):
                self.count += 1
        ros = param_tutorial.start()
        node = ros.add(Busy)
        param_tutorial.wait_until(lambda: node.count > 20, 'a busy node')
        {ending}
    ''')
    assert (done.returncode, done.stdout, done.stderr) == (0, '', '')


def test_a_node_that_is_destroyed_leaves_the_stage(ros):
    other, node = ros.add(Speed, 'other'), ros.add(Speed)
    node.destroy_node()
    assert ros.nodes == (other,)
    param_tutorial.wait_until(lambda: ros.services.node_names() == ['/other'], 'the node to be gone')
    assert ParameterClient(other).set_parameter('rpm', 2).successful
    again = ros.add(Speed)
    assert ParameterClient(again).set_parameter('rpm', 2).successful


class Failing(Speed):
    """Raises the same exception again and again."""

    def __init__(self):
        super().__init__('failing')
        self.count = 0
        self.create_timer(0.001, self.tick)

    def tick(self):
        self.count += 1
        raise ValueError(f'tick {self.count}')


def test_an_exception_that_repeats_is_shown_once_with_its_node_and_counted(ros, capfd):
    node = ros.add(Failing)
    param_tutorial.wait_until(lambda: ros.failures and ros.failures[0].times > 20, 'the timer to go on')
    ros.remove(node)
    error = capfd.readouterr().err
    assert error.startswith('The timer callback tick of /failing raised an exception')
    assert error.count('Traceback') == 1
    assert 'ValueError: tick 1\n' in error
    assert error.count('From now on, repeats are only counted') == 1
    assert error.count('\n') < 15
    failure, = ros.failures
    assert 20 < failure.times <= node.count
    assert [str(each) for each in ros.errors] == ['tick 1']


def test_a_request_that_an_endless_loop_has_made_late_is_answered_nevertheless(ros):
    class Looping(Node):
        def __init__(self):
            super().__init__('looping')
            self.entered = threading.Event()
            self.timer = self.create_timer(0.0, self.loop, autostart=False)

        def loop(self):
            self.timer.cancel()
            self.entered.set()
            while True:
                pass

    looping, client = ros.add(Looping), ParameterClient(ros.add(Speed))
    client.set_parameter('rpm', 2)  # so that the next request is sent at once
    ros.run(looping.timer.reset, 'begin to loop')
    assert looping.entered.wait(30)
    assert client.set_parameter('rpm', 3).successful


# Asleep in a lock, or awake and catching everything.
@pytest.mark.parametrize('blocks', ['threading.Event().wait()', 'catch_everything()'])
def test_a_stage_whose_callback_never_returns_says_so_and_begins_anew_and_the_interpreter_ends_well(blocks):
    done = run_python(f'''
        import sys, threading, time, param_tutorial
        from rclpy.node import Node
        from param_tools.errors import ExecutorError
        from param_tools.ros import executor
        executor.STOP_TIMEOUT_SEC = executor.INTERRUPT_TIMEOUT_SEC = 0.3
        added, entered = threading.Event(), threading.Event()
        def catch_everything():
            while True:
                try:
                    time.sleep(0.001)
                except BaseException:
                    pass
        class Stuck(Node):
            def __init__(self):
                super().__init__('stuck')
                self.create_timer(0.01, self.tick)
            def tick(self):
                if added.is_set():  # add() itself needs the executor's thread
                    entered.set()
                    {blocks}
        ros = param_tutorial.start()
        ros.add(Stuck)
        added.set()
        entered.wait()
        try:
            ros.run(lambda: None, 'work', timeout_sec=0.3)
        except ExecutorError as error:
            print(error)
        fresh = param_tutorial.start()
        print(fresh is ros, fresh.services.node_names())
        sys.exit(3)
    ''')
    assert (done.returncode, done.stderr) == (3, '')
    assert done.stdout == (
        'cannot work: The timer callback tick of /stuck does not return and cannot be interrupted. '
        'Call start() again: it begins anew, without any node\nFalse []\n')
