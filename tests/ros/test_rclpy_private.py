"""What the tools assume of rclpy beyond its documentation: one test for each assumption, named like it.

If one of these fails with a new rclpy, mend the function in rclpy_private that it calls.
"""

import ast
import re
import signal
import threading

import pytest
import rclpy
from rcl_interfaces.msg import ParameterDescriptor, SetParametersResult
from rcl_interfaces.srv import GetParameters
from rclpy import utilities
from rclpy.exceptions import InvalidHandle
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.signals import SignalHandlerOptions, get_current_signal_handlers_options

import param_tutorial
from param_tools.ros import rclpy_private
from param_tutorial import ParameterClient, wait_until
from tests.support.paths import PACKAGE, TOOLS


class Lamp(Node):
    """One parameter, and a callback of each kind."""

    def __init__(self):
        super().__init__('lamp')
        self.declare_parameter('watts', 5)
        self.seen = []
        self.add_pre_set_parameters_callback(self.pre)
        self.add_on_set_parameters_callback(self.judge)
        self.add_post_set_parameters_callback(self.post)

    def pre(self, parameters):
        self.seen.append('pre')
        return parameters

    def judge(self, parameters):
        self.seen.append('judge')
        return SetParametersResult(successful=True)

    def post(self, parameters):
        self.seen.append('post')


@pytest.fixture
def lamp(ros):
    return ros.add(Lamp)


@pytest.fixture
def other_context():
    """A context and nodes apart from the stage."""
    context = rclpy.Context()
    rclpy.init(context=context)
    yield context
    rclpy.shutdown(context=context)


def forbid_in_this_thread():
    this = threading.current_thread()
    return rclpy_private.forbid_waiting(
        lambda: ZeroDivisionError('waits') if threading.current_thread() is this else None)


def assert_serves_a_timer(executor, context, period_sec, timeout_sec):
    node = Node('ticking', context=context)
    ticks = []
    node.create_timer(period_sec, lambda: ticks.append(1))
    executor.add_node(node)
    wait_until(lambda: executor.spin_once(timeout_sec=timeout_sec) or len(ticks) > 2, 'the timer')
    executor.shutdown()
    node.destroy_node()


def test_the_events_executor_serves_what_is_ready_when_spin_once_is_called_in_a_loop(other_context):
    executor = rclpy_private.new_executor(other_context)
    assert_serves_a_timer(executor, other_context, period_sec=0.001, timeout_sec=0.01)


@pytest.mark.parametrize('executor_class', [SingleThreadedExecutor, MultiThreadedExecutor])
def test_rclpys_own_executors_wait_in_wait_for_ready_callbacks_only(other_context, executor_class):
    executor = executor_class(context=other_context)
    future = rclpy.task.Future()
    allow = forbid_in_this_thread()
    try:
        for spin in (executor.spin_once, executor.spin, lambda: executor.spin_until_future_complete(future),
                     lambda: executor.spin_once_until_future_complete(future)):
            with pytest.raises(ZeroDivisionError, match='waits'):
                spin()
    finally:
        allow()
    executor.spin_once(timeout_sec=0.0)
    executor.shutdown()


def test_a_client_waits_for_an_answer_in_call_only(other_context):
    node = Node('asking', context=other_context)
    client = node.create_client(GetParameters, '/nobody/get_parameters')
    allow = forbid_in_this_thread()
    try:
        with pytest.raises(ZeroDivisionError, match='waits'):
            client.call(GetParameters.Request())
        client.call_async(GetParameters.Request()).cancel()
    finally:
        allow()
    with pytest.raises(TypeError):
        client.call('nonsense')
    node.destroy_node()


def limit_in_this_thread(seconds=0.3):
    this = threading.current_thread()
    return rclpy_private.forbid_waiting(lambda: None, rclpy_private.WaitLimit(
        lambda: threading.current_thread() is this, seconds,
        lambda nodes: ZeroDivisionError(f'spins {[node.get_name() for node in nodes]} forever'),
        lambda what, seconds: ZeroDivisionError(f'{what}: timed out after {seconds} s')))


@pytest.fixture
def limited():
    """Waits in this thread have a time limit."""
    allow = limit_in_this_thread()
    yield
    allow()


@pytest.mark.slow
@pytest.mark.parametrize('executor_class', [SingleThreadedExecutor, MultiThreadedExecutor])
def test_rclpys_own_executors_take_a_time_limit_in_place_of_none(other_context, limited, executor_class):
    executor = executor_class(context=other_context)
    node = Node('idle', context=other_context, enable_rosout=False, start_parameter_services=False)
    executor.add_node(node)
    future = rclpy.task.Future()
    for endless in (executor.spin, lambda: rclpy.spin(node, executor)):
        with pytest.raises(ZeroDivisionError, match=re.escape("spins ['idle'] forever")):
            endless()
    for wait in (executor.spin_once, lambda: rclpy.spin_once(node, executor=executor),
                 lambda: executor.spin_once(timeout_sec=-1),
                 lambda: executor.spin_once_until_future_complete(future)):
        with pytest.raises(ZeroDivisionError, match='something to do: timed out'):
            wait()
    with pytest.raises(ZeroDivisionError, match='the future: timed out'):
        executor.spin_until_future_complete(future)
    executor.spin_until_future_complete(future, timeout_sec=0.2)
    executor.spin_once(timeout_sec=0.2)
    future.set_result(1)
    executor.spin_until_future_complete(future)
    executor.shutdown()
    node.destroy_node()


@pytest.mark.slow
@pytest.mark.parametrize('executor_class', [SingleThreadedExecutor, MultiThreadedExecutor])
def test_rclpys_own_executors_serve_what_comes_while_they_wait_a_little_at_a_time(
        other_context, limited, executor_class):
    executor = executor_class(context=other_context)
    assert_serves_a_timer(executor, other_context, period_sec=0.25, timeout_sec=60.0)


@pytest.mark.slow
def test_a_signal_is_handled_while_an_executor_waits(other_context, limited):
    def ring(number, frame):
        raise KeyboardInterrupt('on purpose')

    executor = SingleThreadedExecutor(context=other_context)
    before = signal.signal(signal.SIGALRM, ring)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.2)
        with pytest.raises(KeyboardInterrupt, match='on purpose'):
            executor.spin_once(timeout_sec=600.0)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    executor.shutdown()


@pytest.mark.slow
def test_a_client_returns_none_when_no_answer_comes_in_time(other_context, limited):
    node = Node('asking', context=other_context)
    client = node.create_client(GetParameters, '/nobody/get_parameters')
    with pytest.raises(ZeroDivisionError, match='an answer from /nobody/get_parameters: timed out'):
        client.call(GetParameters.Request())
    assert client.call(GetParameters.Request(), timeout_sec=0.01) is None
    node.destroy_node()


@pytest.fixture
def default_context():
    """Rclpy as in a program that has called rclpy.init()."""
    param_tutorial.stop()
    rclpy.init(signal_handler_options=SignalHandlerOptions.NO)
    yield utilities.get_default_context()
    rclpy.try_shutdown()


@pytest.mark.parametrize('shutdown', [
    rclpy.shutdown, rclpy.try_shutdown, utilities.shutdown, utilities.try_shutdown,
    lambda: utilities.get_default_context().shutdown(), lambda: rclpy.shutdown(context=utilities.get_default_context()),
])
def test_every_way_to_shut_the_default_context_down_goes_through_its_own_methods(default_context, shutdown):
    told = []
    let_go = rclpy_private.keep_context(default_context, told.append)
    for _ in range(2):
        shutdown()
        assert rclpy.ok()
        assert utilities.get_default_context() is default_context
    assert told == ['shutdown'] * 2
    let_go()
    shutdown()
    assert not rclpy.ok()
    assert len(told) == 2


def test_init_goes_through_the_context_and_installs_handlers_by_a_name_in_rclpy(default_context):
    told = []
    install = rclpy.install_signal_handlers
    let_go = rclpy_private.keep_context(default_context, told.append)
    rclpy.init(args=[], domain_id=7)
    other = rclpy.Context()
    rclpy.init(context=other, signal_handler_options=SignalHandlerOptions.ALL)
    assert told == ['init']
    assert get_current_signal_handlers_options() == SignalHandlerOptions.NO
    rclpy.shutdown(context=other)
    let_go()
    assert rclpy.install_signal_handlers is install
    with pytest.raises(RuntimeError, match='must only be called once'):
        rclpy.init()


@pytest.mark.slow
def test_a_second_executor_takes_nodes_over_from_one_that_never_runs_again(other_context):
    """The first one sleeps in a callback forever: if it were destroyed, it would look for the handles."""
    node, stuck = Node('held', context=other_context), Node('stuck', context=other_context)
    observer = Node('observer', context=other_context)
    ticks = []
    asleep = threading.Event()
    node.create_timer(0.01, lambda: ticks.append(1))
    stuck.create_timer(0.2, lambda: asleep.set() or threading.Event().wait())
    client = node.create_client(GetParameters, '/held/get_parameters')
    first, second = (rclpy_private.new_executor(other_context) for _ in range(2))
    first.add_node(node)
    first.add_node(stuck)

    def spin():
        while True:
            first.spin_once(timeout_sec=1.0)

    threading.Thread(target=spin, daemon=True).start()
    assert asleep.wait(30)
    assert ticks
    rclpy_private.destroy_by_force(stuck)
    rclpy_private.take_from_dead_executor(node)
    second.add_node(node)
    ticks.clear()
    wait_until(lambda: second.spin_once(timeout_sec=0.01) or ticks, 'the timer in the other executor')
    future = client.call_async(GetParameters.Request(names=['use_sim_time']))
    wait_until(lambda: second.spin_once(timeout_sec=0.01) or future.done(), 'the answer')
    second.remove_node(node)
    node.destroy_node()
    wait_until(lambda: second.spin_once(timeout_sec=0.01) or 'held' not in observer.get_node_names(),
               'the node to be gone')
    observer.destroy_node()
    second.shutdown()


class CallsNodeByName(Node):
    def __init__(self, **options):
        Node.__init__(self, 'named', **options)


class CallsSuper(Node):
    def __init__(self, **options):
        super().__init__('named', **options)


@pytest.mark.parametrize('node_class', [CallsNodeByName, CallsSuper])
def test_every_class_of_nodes_gets_to_one_constructor_and_passes_its_arguments_by_name(other_context, node_class):
    def turn(node, node_name, options):
        calls.append((type(node), node_name))
        options['cli_args'] = ['--ros-args', '-r', '__node:=turned']

    calls = []
    leave = rclpy_private.call_before_node_init(turn)
    node = node_class(context=other_context)
    leave()
    after = node_class(context=other_context)
    assert calls == [(node_class, 'named')]
    assert (node.get_name(), after.get_name()) == ('turned', 'named')
    node.destroy_node()
    after.destroy_node()


def test_a_node_that_never_came_to_be_is_no_trouble_to_destroy():
    rclpy_private.destroy_unfinished(Node.__new__(Node))


def test_a_handle_is_destroyed_when_its_last_user_has_left(other_context):
    """Here a ``with`` block that does not end stands for the executor that never runs again."""
    node = Node('held', context=other_context)
    observer = Node('observer', context=other_context)
    service = next(node.services)
    service.handle.__enter__()
    wait_until(lambda: 'held' in observer.get_node_names(), 'the node')
    rclpy_private.destroy_by_force(node)
    wait_until(lambda: 'held' not in observer.get_node_names(), 'the node to be gone')
    observer.destroy_node()


def test_the_service_get_type_description_outlives_its_node_until_rcl_ends_it(ros):
    def is_there():
        return bool(ros.tool_node.get_subscriptions_info_by_topic(
            'rq/forgotten/get_type_descriptionRequest', no_mangle=True))

    node = Node('forgotten')
    end = rclpy_private.keep_type_description_service(node)
    node.destroy_node()
    # If this fails, rclpy now does it by itself, and the function can be removed.
    assert is_there()
    end()
    wait_until(lambda: not is_there(), 'the service to go')


def test_answers_are_sent_through_an_attribute_of_the_service(ros, lamp):
    service = next(each for each in lamp.services if each.service_name == '/lamp/get_parameters')
    errors = []
    sent = service.send_response

    def fail_once(response, header):
        service.send_response = sent
        raise InvalidHandle('on purpose')

    service.send_response = fail_once
    rclpy_private.watch_answers(service, errors.append)
    ros.services.call_async('/lamp', 'get_parameters', GetParameters.Request(names=['watts']), lambda _: None)
    wait_until(lambda: errors, 'the answer that fails')
    assert str(errors[0]) == 'on purpose'


def test_a_declaration_takes_its_override_from_the_nodes_own_dictionary(ros):
    node = ros.add(Node, 'empty', ros_args=['-p', 'old:=7'])
    overrides = rclpy_private.pending_overrides(node)
    overrides['new'] = Parameter('new', value=overrides.pop('old').value)
    assert ros.run(lambda: [node.declare_parameter(name, 1).value for name in ('new', 'old')], 'declare') == [7, 1]


def test_what_is_written_into_the_own_descriptor_is_described(ros):
    node = ros.add(Node, 'empty')
    ros.run(lambda: node.declare_parameter('serial', 'A', ParameterDescriptor(read_only=True)), 'declare')
    rclpy_private.own_descriptor(node, 'serial').additional_constraints = 'one letter'
    assert ParameterClient(node).describe_parameter('serial').additional_constraints == 'one letter'


def test_parameter_callbacks_are_called_by_going_through_three_lists(ros, lamp):
    calls = []

    def call_instead(kind, callback, parameters):
        calls.append((kind, callback))
        return callback(parameters)

    stop = ros.run(lambda: rclpy_private.observe_changes(lamp, call_instead, lambda publish, event: publish(event)),
                   'observe')
    ParameterClient(lamp).set_parameter('watts', 6)
    ros.run(stop, 'stop observing')
    ParameterClient(lamp).set_parameter('watts', 7)
    assert [call for call in calls if getattr(call[1], '__self__', None) is lamp] == [
        ('pre-set', lamp.pre), ('on-set', lamp.judge), ('post-set', lamp.post)]
    assert lamp.seen == ['pre', 'judge', 'post'] * 2


def test_parameter_callbacks_are_removed_while_they_are_observed_as_ever(ros, lamp):
    stop = ros.run(lambda: rclpy_private.observe_changes(
        lamp, lambda kind, callback, parameters: callback(parameters), lambda publish, event: publish(event)),
        'observe')
    lamp.remove_on_set_parameters_callback(lamp.judge)
    ros.run(stop, 'stop observing')
    ParameterClient(lamp).set_parameter('watts', 6)
    assert lamp.seen == ['pre', 'post']


def test_a_parameter_event_is_published_through_the_nodes_own_publisher(ros, lamp):
    events = []
    stop = ros.run(lambda: rclpy_private.observe_changes(
        lamp, lambda kind, callback, parameters: callback(parameters), lambda publish, event: events.append(event)),
        'observe')
    ParameterClient(lamp).set_parameter('watts', 6)
    ros.run(stop, 'stop observing')
    ParameterClient(lamp).set_parameter('watts', 7)
    assert [event.changed_parameters[0].value.integer_value for event in events] == [6]


def test_every_set_goes_through_one_method_of_the_node_and_no_declaration_does(ros, lamp):
    asked = []

    def set_instead(set_parameters, parameters):
        asked.append([each.value for each in parameters])
        return set_parameters(parameters)

    stop = ros.run(lambda: rclpy_private.observe_changes(
        lamp, lambda kind, callback, parameters: callback(parameters), lambda publish, event: publish(event),
        set_instead), 'observe')
    ParameterClient(lamp).set_parameter('watts', 6)
    ParameterClient(lamp).set_parameters_atomically({'watts': 7})
    ros.run(lambda: lamp.set_parameters([Parameter('watts', value=8)]), 'set')
    ros.run(lambda: lamp.declare_parameter('volts', 230), 'declare')
    ros.run(stop, 'stop observing')
    ParameterClient(lamp).set_parameter('watts', 9)
    assert asked == [[6], [7], [8]]


@pytest.mark.slow
def test_no_other_file_uses_private_names_of_rclpy(ros, lamp):
    client = lamp.create_client(GetParameters, '/nobody/get_parameters')
    private = {name for thing in (lamp, client, lamp._parameter_service, rclpy.task.Future(), *lamp.services)
               for name in dir(thing) if re.match('_[^_]', name)}
    private.remove('_lock')  # a name that classes of ours use as well
    assert {'_parameters', '_pending_requests', '_get_node'} <= private
    found = []
    for path in [*PACKAGE.rglob('*.py'), *TOOLS.rglob('*.py')]:
        if path.name == 'rclpy_private.py':
            continue
        for step in ast.walk(ast.parse(path.read_text())):
            # What a class keeps in self belongs to it.
            if (isinstance(step, ast.Attribute) and step.attr in private
                    and ast.unparse(step.value) not in ('self', 'cls')):
                found.append(f'{path.name}: {ast.unparse(step)}')
            elif isinstance(step, ast.Constant) and step.value in private:
                found.append(f'{path.name}: {step.value!r}')
            elif isinstance(step, ast.ImportFrom) and 'rclpy.experimental' in (step.module or ''):
                found.append(f'{path.name}: {step.module}')
    assert found == []
