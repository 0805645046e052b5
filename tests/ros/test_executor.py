"""background: life and death of the executor, its nodes and its thread."""

import gc
import subprocess
import sys
import textwrap
import threading
import weakref
from pathlib import Path

import pytest
import rclpy
from rcl_interfaces.srv import GetParameters
from rclpy.client import Client
from rclpy.exceptions import InvalidParameterTypeException
from rclpy.executors import Executor, MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.signals import SignalHandlerOptions, get_current_signal_handlers_options

import param_tutorial
from param_tools.errors import ExecutorError, NoAnswerError, WaitTimeoutError
from param_tools.ros import domain, executor, rclpy_private, stage, tutorial_lines
from param_tutorial import ParameterClient


class Speed(Node):
    """One parameter."""

    def __init__(self, name='speed'):
        super().__init__(name)
        self.declare_parameter('rpm', 1)


def run_python(source, **options):
    """Run a script in its own process and ROS domain: in this domain, killed nodes may linger."""
    environment = domain.environment_without_domain()
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
    ros.add(Speed, ros_args=['-r', '__node:=fast', '-r', '__ns:=/left'])
    ros.add(Speed, 'slow')
    assert ros.services.node_names() == ['/left/fast', '/slow']


class CallsNodeByName(Node):
    def __init__(self):
        Node.__init__(self, 'by_name')
        self.rpm = self.declare_parameter('max_speed_rpm', 100).value


def test_a_class_may_call_the_constructor_of_node_by_its_name(ros):
    first = ros.add(CallsNodeByName)
    second = ros.add(CallsNodeByName, ros_args=['-p', 'max_speed_rpm:=150'])
    assert (first.rpm, second.rpm) == (100, 150)
    assert ros.nodes == (second,)


@pytest.mark.parametrize('parameter', ['use_sim_time', 'start_type_description_service'])
def test_a_constructor_that_fails_in_rclpy_says_why_and_leaves_nothing_behind(ros, parameter):
    with pytest.raises(InvalidParameterTypeException, match=f"'{parameter}' to '7' of type 'INTEGER'"):
        ros.add(Speed, ros_args=['-p', f'{parameter}:=7'])
    assert ros.nodes == ()
    assert ros.services.node_names() == []


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


def test_start_heals_after_somebody_shut_the_context_down(ros):
    ros.add(Speed)
    rclpy.Context.shutdown(ros.context)  # not as anybody would: rclpy.shutdown() leaves the stage alone
    with pytest.raises(ExecutorError, match='start'):
        ros.add(Speed)
    fresh = param_tutorial.start()
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


@pytest.mark.parametrize(('owner', 'name'), [
    (executor, '_WatchedExecutor'), (executor, 'Services'), (tutorial_lines, 'replace')])
def test_a_start_that_fails_leaves_rclpy_to_the_next(monkeypatch, owner, name):
    def fail(*_, **__):
        raise OSError('Too many open files')

    param_tutorial.stop()
    before = Node.__init__, rclpy.init
    with monkeypatch.context() as patched:
        patched.setattr(owner, name, fail)
        with pytest.raises(OSError, match='Too many open files'):
            param_tutorial.start()
    assert (Node.__init__, rclpy.init) == before
    assert not rclpy.ok()
    assert param_tutorial.start().services.node_names() == []


def test_only_classes_of_nodes_are_added(ros):
    for wrong in ('speed', dict, Speed.__init__):
        with pytest.raises(ExecutorError, match='class derived from'):
            ros.add(wrong)


@pytest.mark.slow
@pytest.mark.filterwarnings('ignore:Exception ignored in:pytest.PytestUnraisableExceptionWarning')
def test_an_interruption_that_python_only_prints_comes_again(ros, capfd):
    """As in ``RcutilsLogger.__del__`` of rclpy."""
    entered, let_go = threading.Event(), threading.Event()

    def wait():
        entered.set()
        while not let_go.wait(0.01):
            pass

    class Swallows:
        def __del__(self):
            wait()

    def act(node):
        swallows = Swallows()
        del swallows
        wait()

    node = ros.add(Asking, act)
    assert entered.wait(30)
    ros.run(lambda: None, 'do nothing', timeout_sec=0.3)
    assert not let_go.is_set()
    assert ros.nodes == (node,)
    assert 'did not return, so it was interrupted' in capfd.readouterr().err
    assert ParameterClient(node).set_parameter('rpm', 2).successful


def test_the_stage_runs_on_after_an_interrupt_while_somebody_asks_whether_it_runs():
    """Thread.is_alive() of CPython 3.11 says of a thread that was asked just then that it has ended, for good."""
    done = run_python('''
        import signal, threading
        import param_tutorial
        ros = param_tutorial.start()
        main = threading.main_thread().ident
        for _ in range(100):
            asking = threading.Event()
            presser = threading.Thread(target=lambda: asking.wait() and signal.pthread_kill(main, signal.SIGINT))
            presser.start()
            try:
                asking.set()
                while True:
                    ros.is_running
            except KeyboardInterrupt:
                presser.join()
        print(ros.is_running)
    ''')
    assert done.stdout == 'True\n', done.stderr
    assert done.returncode == 0


def test_run_gives_the_result_or_the_exception(ros):
    assert ros.run(threading.current_thread, 'look') is not threading.current_thread()
    with pytest.raises(KeyError, match='x'):
        ros.run(lambda: {}['x'], 'look up')
    assert ros.run(lambda: ros.run(lambda: 5, 'nest'), 'nest') == 5


def test_a_node_without_parameter_services_publishes_its_changes_too(ros):
    events = []
    stop_events = ros.on_parameter_event(events.append)
    node = ros.add(Node, 'without_services', start_parameter_services=False)
    ros.run(lambda: node.declare_parameter('rpm', 5), 'declare a parameter')
    param_tutorial.wait_until(
        lambda: any(e.node == '/without_services' and e.new_parameters[0].name == 'rpm' for e in events), 'the event')
    stop_events()


def test_listeners_hear_of_events_and_of_nodes_until_they_stop(ros):
    events, changes = [], []
    stop_events = ros.on_parameter_event(events.append)
    stop_changes = ros.on_graph_change(lambda: changes.append(ros.services.node_names()))
    client = ParameterClient(ros.add(Speed))
    incarnation = ros.node_incarnations('/speed')
    assert len(incarnation) == 1
    ros.add(Speed)
    assert ros.node_incarnations('/speed').isdisjoint(incarnation)
    assert ['/speed'] in changes
    client.set_parameter('rpm', 5)
    param_tutorial.wait_until(
        lambda: any(e.node == '/speed' and e.changed_parameters for e in events), 'the event')
    stop_events()
    stop_changes()
    stop_changes()
    seen = len(events), len(changes)
    client.set_parameter('rpm', 6)
    ros.remove('/speed')
    assert (len(events), len(changes)) == seen


@pytest.mark.slow
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


@pytest.mark.slow
def test_a_class_whose_node_has_gone_is_not_kept(ros):
    """A cell that runs again creates its class again: a lesson that is run often would keep hundreds."""
    class Passing(Node):
        def __init__(self):
            super().__init__('passing')
    gone = weakref.ref(Passing)
    assert type(ros.add(Passing)) is type(ros.add(Passing))
    ros.remove_all()
    del Passing

    def is_gone():
        gc.collect()
        return gone() is None
    param_tutorial.wait_until(is_gone, 'the class to be collected')


def test_a_node_that_is_destroyed_leaves_no_service_behind(ros):
    # It needs its own name: after a test whose callback never returns, the service of its node stays.
    def services():
        return len(ros.tool_node.get_subscriptions_info_by_topic(
            'rq/leaver/get_type_descriptionRequest', no_mangle=True))

    for _ in range(5):
        node = ros.add(Speed, 'leaver')
    param_tutorial.wait_until(lambda: services() == 1, 'those of the earlier nodes to go')
    node.destroy_node()
    param_tutorial.wait_until(lambda: services() == 0, 'the last one to go')
    # A node without the service can be removed, too.
    ros.add(Speed, 'leaver', ros_args=['-p', 'start_type_description_service:=false'])
    assert ros.remove('/leaver')
    assert ros.services.node_names() == []


# A thread that spins while the interpreter ends aborts the process with status 134 (claims.md, 2g).
@pytest.mark.slow
@pytest.mark.parametrize('ending', [
    '', 'sys.exit(0)', 'param_tutorial.stop()', 'rclpy.Context.shutdown(ros.context)', 'del ros, node'])
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


class Asking(Speed):
    """Calls a function once, in a timer callback, and keeps what it returned or raised."""

    def __init__(self, act):
        super().__init__('asking')
        self.act = act
        self.outcome = None
        self.client = self.create_client(GetParameters, '/asking/get_parameters')
        self.timer = self.create_timer(0.001, self.tick)

    def tick(self):
        self.timer.cancel()
        try:
            self.outcome = self.act(self)
        except Exception as error:
            self.outcome = error


def ask(node):
    return node.client.call_async(GetParameters.Request(names=['rpm']))


def spin_a_helper(node):
    helper = rclpy.create_node('helper')
    try:
        rclpy.spin_once(helper)
    finally:
        helper.destroy_node()  # and not when its garbage is collected, in a later test


# The most common ways to wait for an answer in a callback.
WAITS = {
    'spin_until_future_complete': lambda node: rclpy.spin_until_future_complete(node, ask(node)),
    'spin_once': rclpy.spin_once,
    'spin': rclpy.spin,
    'executor': lambda node: SingleThreadedExecutor().spin_until_future_complete(ask(node)),
    'executor of a helper': spin_a_helper,
    'call': lambda node: node.client.call(GetParameters.Request(names=['rpm'])),
}


@pytest.mark.parametrize('wait', WAITS.values(), ids=WAITS)
def test_a_callback_that_waits_for_its_own_executor_gets_an_error_at_once(ros, wait):
    node = ros.add(Asking, wait)
    param_tutorial.wait_until(lambda: node.outcome is not None, 'the callback')
    assert isinstance(node.outcome, ExecutorError)
    assert 'runs inside the executor that it waits for' in str(node.outcome)
    assert 'add_done_callback' in str(node.outcome)
    assert ParameterClient(node).set_parameter('rpm', 2).successful


def test_a_callback_may_wait_for_an_answer_with_a_time_limit_in_vain(ros):
    node = ros.add(Asking, lambda node: [node.client.call(GetParameters.Request(), timeout_sec=0.01)])
    param_tutorial.wait_until(lambda: node.outcome is not None, 'the callback')
    assert node.outcome == [None]


@pytest.mark.parametrize('spin', [rclpy.spin, rclpy.spin_once], ids=['spin', 'spin_once'])
def test_a_cell_cannot_take_a_node_away_from_the_stage(ros, spin):
    node = ros.add(Speed)
    for _ in range(2):
        with pytest.raises(ExecutorError, match=r'/speed is spun in the background already.*wait_until'):
            spin(node)
    assert ParameterClient(node).set_parameter('rpm', 2).successful


def test_an_executor_of_ones_own_spins_in_any_other_thread(ros):
    context = rclpy.Context()
    rclpy.init(context=context)
    executor = SingleThreadedExecutor(context=context)
    node = Node('own', context=context)
    ticks = []
    node.create_timer(0.001, lambda: ticks.append(1))
    executor.add_node(node)
    param_tutorial.wait_until(lambda: executor.spin_once(timeout_sec=0.01) or len(ticks) > 2, 'the timer')
    executor.shutdown()
    node.destroy_node()
    rclpy.shutdown(context=context)


def test_a_call_that_the_end_overtakes_ends_without_a_word():
    done = run_python('''
        import threading, time
        from rcl_interfaces.srv import ListParameters
        import param_tools
        from param_tools.errors import ExecutorError

        ros, called = param_tools.start(), threading.Event()
        def call_as_the_stage_ends():
            ros.services.call_async('/nobody', 'list_parameters', ListParameters.Request())
            called.set()
            while ros.is_running:
                time.sleep(0.001)
        ros.create_task(call_as_the_stage_ends)
        called.wait()
        param_tools.stop()
        try:
            ros.services.call_async('/nobody', 'list_parameters', ListParameters.Request())
        except ExecutorError as error:
            print(error)
        ''')
    assert (done.stdout, done.stderr) == ('this executor is stopped: call start() for a new one\n', '')


def test_stop_leaves_all_of_rclpy_as_it_was():
    param_tutorial.stop()
    places = {rclpy: ('spin', 'spin_once', 'spin_until_future_complete', 'init', 'shutdown', 'try_shutdown'),
              Executor: ('spin', 'add_node'), Client: ('call',), Node: ('__init__',)}
    before = [vars(owner)[name] for owner, names in places.items() for name in names]
    param_tutorial.start()
    assert [vars(owner)[name] for owner, names in places.items() for name in names] != before
    param_tutorial.stop()
    assert [vars(owner)[name] for owner, names in places.items() for name in names] == before
    rclpy.init()
    rclpy.shutdown()


def test_the_stage_outlives_shutdown_and_init_and_says_so(ros, capfd):
    client = ParameterClient(ros.add(Speed))
    for _ in range(2):
        rclpy.shutdown()
        rclpy.init()
    assert ros.is_running
    assert client.set_parameter('rpm', 2).successful
    said = capfd.readouterr().err
    assert said.count('rclpy.shutdown() has nothing to do here') == 2
    assert said.count('rclpy.init() has nothing to do here') == 2


def test_a_node_that_is_destroyed_leaves_the_stage(ros):
    other, node = ros.add(Speed, 'other'), ros.add(Speed)
    node.destroy_node()
    assert ros.nodes == (other,)
    param_tutorial.wait_until(lambda: ros.services.node_names() == ['/other'], 'the node to be gone')
    assert ParameterClient(other).set_parameter('rpm', 2).successful
    again = ros.add(Speed)
    assert ParameterClient(again).set_parameter('rpm', 2).successful


@pytest.mark.real_layer(reason='rclpy in Python ends this service with its node')
def test_listeners_to_the_graph_hear_of_a_node_whose_name_goes_late(ros, monkeypatch):
    # The name stays until the node's last service ends; the executor may look at the graph before.
    ends, keep = [], rclpy_private.keep_type_description_service
    monkeypatch.setattr(rclpy_private, 'keep_type_description_service',
                        lambda node: ends.append(keep(node)) or (lambda: None))
    heard = []
    ros.on_graph_change(lambda: heard.append(ros.services.node_names()))
    ros.add(Speed, 'late')
    assert heard[-1] == ['/late']
    ros.remove('/late')
    assert heard[-1] == ros.services.node_names() == ['/late']
    for end in ends:
        ros.run(end, 'end its last service')
    param_tutorial.wait_until(lambda: heard[-1] == [], 'the listener to hear of it')


def test_a_node_that_destroys_itself_in_its_callback_leaves_the_stage(ros):
    # A name of its own: the services of one that was stuck, in another test, stay until the process ends.
    ros.add(Asking, lambda node: node.destroy_node(), ros_args=['-r', '__node:=leaving'])
    param_tutorial.wait_until(lambda: ros.nodes == (), 'the node to be gone')
    ros.run(lambda: None, 'see its callback through')
    assert ros.services.node_names() == []
    param_tutorial.wait_until(lambda: not ros.tool_node.get_subscriptions_info_by_topic(
        'rq/leaving/get_type_descriptionRequest', no_mangle=True), 'its last service to go')
    assert ParameterClient(ros.add(Speed)).set_parameter('rpm', 2).successful


@pytest.mark.parametrize('error', [SystemExit, KeyboardInterrupt, GeneratorExit])
def test_what_ends_a_program_does_not_end_the_stage(ros, capfd, error):
    def end(node):
        raise error

    node = ros.add(Asking, end)
    param_tutorial.wait_until(lambda: ros.failures, 'the end of the callback')
    assert ParameterClient(node).set_parameter('rpm', 2).successful
    assert f'{error.__name__}' in capfd.readouterr().err


def spin_by_name(node):
    rclpy.spin(node)


@pytest.mark.slow
@pytest.mark.parametrize('spin', [
    spin_by_name,
    lambda node: spin_with(SingleThreadedExecutor(), node),
    lambda node: spin_with(MultiThreadedExecutor(2), node),
])
def test_a_node_made_by_hand_is_not_spun_forever(ros, spin):
    node = Speed('by_hand')
    with pytest.raises((ExecutorError, WaitTimeoutError), match=r'ros\.add\('):
        spin(node)
    node.destroy_node()
    assert ros.is_running


def spin_with(executor, node):
    executor.add_node(node)
    try:
        executor.spin()
    finally:
        executor.shutdown()


def test_a_constructor_that_spins_is_told_to_leave_that_out(ros):
    class Spins(Speed):
        def __init__(self):
            super().__init__()
            rclpy.spin(self)

    with pytest.raises(ExecutorError, match='leave this line out'):
        ros.add(Spins)
    assert ros.nodes == ()


class Failing(Speed):
    """Raises the same exception again and again."""

    def __init__(self):
        super().__init__('failing')
        self.count = 0
        self.create_timer(0.001, self.tick)

    def tick(self):
        self.count += 1
        raise ValueError(f'tick {self.count}')


@pytest.mark.slow
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


def test_the_same_mistake_in_a_new_node_is_shown_again(ros, capfd):
    for _ in range(2):
        node = ros.add(Failing)
        param_tutorial.wait_until(lambda: node.count > 2, 'the timer to go on')  # noqa: B023
        ros.remove(node)
    assert capfd.readouterr().err.count('Traceback') == 2


# What blocks a thread forever: asleep in a lock, or awake and catching everything.
STUCK = '''
    import sys, threading, time, param_tutorial
    from rclpy.node import Node
    from param_tutorial import ParameterClient
    from param_tools.errors import ExecutorError
    from param_tutorial.nodes.simple_param_node import SimpleParamNode
    from param_tools.ros import executor
    executor.STOP_TIMEOUT_SEC = executor.INTERRUPT_TIMEOUT_SEC = 0.3
    may_begin, entered = threading.Event(), threading.Event()
    class Stuck(Node):
        def __init__(self):
            super().__init__('simple_param_node')
            self.timer = self.create_timer(0.01, self.tick)
        def tick(self):
            if not may_begin.is_set():
                return
            entered.set()
            if {asleep}:
                threading.Event().wait()
            while True:
                try:
                    time.sleep(0.001)
                except BaseException:
                    pass
    ros = param_tutorial.start()
    ros.add(Stuck)
    may_begin.set()
    entered.wait()
'''


@pytest.mark.slow
@pytest.mark.parametrize('asleep', [True, False])
def test_a_stage_whose_callback_never_returns_says_so_and_begins_anew(asleep):
    done = run_python(STUCK.format(asleep=asleep) + '''
    for _ in range(2):
        try:
            ros.run(lambda: None, 'work', timeout_sec=0.3)
        except ExecutorError as error:
            print(error)
    fresh = param_tutorial.start()
    print(fresh is ros, fresh.services.node_names())
    print(ParameterClient(fresh.add(SimpleParamNode)).set_parameter('max_speed_rpm', 3))
    ''')
    sentence = ('cannot work: The timer callback tick of /simple_param_node does not return and cannot be interrupted'
                '. Call start() again: it begins anew, without any node')
    assert done.stdout.splitlines() == [
        sentence, sentence, 'False []', '/simple_param_node accepted max_speed_rpm = 3'], done.stderr


@pytest.mark.slow
def test_a_callback_that_sleeps_for_long_is_named_and_waited_for(ros, capfd):
    may_sleep, sleeps, may_return = threading.Event(), threading.Event(), threading.Event()

    class Sleeper(Speed):
        def __init__(self):
            super().__init__('sleeper')
            self.timer = self.create_timer(0.01, self.tick)

        def tick(self):
            if may_sleep.is_set():
                sleeps.set()
                may_return.wait()

    ros.add(Sleeper)
    client = ParameterClient(ros.add(Speed, 'bystander'))
    may_sleep.set()
    assert sleeps.wait(60)
    with pytest.raises(NoAnswerError):
        client.get_parameter('rpm')
    assert 'The timer callback tick of /sleeper does not return' in capfd.readouterr().err
    may_return.set()
    assert client.get_parameter('rpm') == 1


@pytest.mark.slow
def test_a_request_ends_an_endless_loop_in_a_callback(ros, capfd):
    entered = threading.Event()

    def loop(node):
        entered.set()
        while True:
            pass

    client = ParameterClient(ros.add(Speed))
    bystander = ros.add(Speed, 'bystander')
    ros.add(Asking, loop)
    assert entered.wait(30)
    assert client.get_parameter('rpm') == 1
    assert bystander in ros.nodes
    assert ParameterClient(bystander).set_parameter('rpm', 5).successful
    assert 'did not return' in capfd.readouterr().err


@pytest.mark.slow
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


@pytest.mark.slow
@pytest.mark.parametrize('asleep', [True, False])
@pytest.mark.parametrize(('ending', 'status'), [('', 0), ('sys.exit(3)', 3), ('param_tutorial.stop()', 0)])
def test_the_interpreter_ends_well_with_a_callback_that_never_returns(asleep, ending, status):
    done = run_python(STUCK.format(asleep=asleep) + f'    {ending}')
    assert (done.returncode, done.stdout, done.stderr) == (status, '', '')
