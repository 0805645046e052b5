"""client and services: every verb, and every way to fail, on real nodes."""

import math
import subprocess
import sys
import textwrap
import threading

import hypothesis
import pytest
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor, SetParametersResult
from rcl_interfaces.srv import GetParameters, ListParameters
from rclpy.node import Node
from rclpy.parameter import Parameter

import param_tutorial
from param_tools import values
from param_tools.errors import (
    CallbackError,
    InvalidValueError,
    NoAnswerError,
    NodeGoneError,
    ParameterNotDeclaredError,
    ParameterRejectedError,
)
from param_tools.ros.graph import DISCOVERY_SEC
from param_tutorial import ParameterClient
from tests.support.nodes import Counter
from tests.support.processes import standing_still
from tests.support.strategies import VALUES


class Everything(Node):
    """A parameter for every way to answer."""

    def __init__(self):
        super().__init__('everything', namespace='/lab')
        self.declare_parameter('count', 3, ParameterDescriptor(
            integer_range=[IntegerRange(from_value=0, to_value=10, step=3)]))
        self.declare_parameter('gain', 0.5, ParameterDescriptor(
            description='A gain.', additional_constraints='even',
            floating_point_range=[FloatingPointRange(from_value=2.0, to_value=0.0, step=0.5)]))
        self.declare_parameter('serial', 'S1', ParameterDescriptor(read_only=True))
        self.declare_parameter('any', 'free', ParameterDescriptor(dynamic_typing=True))
        self.declare_parameter('numbers', [1, 2])
        self.declare_parameter('unset', Parameter.Type.DOUBLE)
        self.declare_parameter('limits.low', 1)
        self.declare_parameter('limits.high', 5)
        self.add_on_set_parameters_callback(self.validate)

    def validate(self, parameters):
        for parameter in parameters:
            if parameter.name == 'limits.low' and parameter.value > 5:
                return SetParametersResult(successful=False, reason='low is too high')
            if parameter.name == 'limits.high' and parameter.value == 13:
                raise RuntimeError('thirteen')
        return SetParametersResult(successful=True)


@pytest.fixture
def client(ros):
    return ParameterClient(ros.add(Everything))


def process(source, *arguments):
    """Start a script in its own process, in this process's ROS domain."""
    return subprocess.Popen([sys.executable, '-c', textwrap.dedent(source), *arguments],
                            stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)


def test_a_client_with_time_waits_for_a_node_that_starts_late(ros):
    starts = threading.Timer(DISCOVERY_SEC + 0.5, ros.add, [Everything])
    starts.start()
    try:
        assert ParameterClient('/lab/everything', timeout_sec=30.0).get_parameter('count') == 3
    finally:
        starts.join()


# rclpy answers with nothing at all if one of the names is unknown or has no value (claims A154).
def test_get_all_in_spite_of_one_without_a_value(client):
    everything = client.get_parameters()
    assert list(everything) == client.list_parameters()
    assert everything['unset'] is None
    assert everything['count'] == 3
    assert 'limits.high  ' in repr(everything)


def test_get_names_the_unknown_one(client):
    message = r"/lab/everything has no parameter 'cuont'\. Did you mean count"
    with pytest.raises(ParameterNotDeclaredError, match=message) as caught:
        client.get_parameters(['gain', 'cuont', 'serial'])
    assert (caught.value.node, caught.value.name) == ('/lab/everything', 'cuont')
    assert isinstance(caught.value, LookupError)


def test_describe(client):
    gain = client.describe_parameter('gain')
    assert (gain.type, gain.range.from_value, gain.range.to_value, gain.range.step) == (values.DOUBLE, 0.0, 2.0, 0.5)
    assert repr(gain) == 'gain: double; 0.0 to 2.0 in steps of 0.5; even; A gain.'
    assert client.describe_parameter('serial').read_only
    assert client.describe_parameter('any').dynamic_typing
    assert list(client.describe_parameters()) == client.list_parameters()
    with pytest.raises(ParameterNotDeclaredError, match='gian'):
        client.describe_parameters(['count', 'gian'])


@pytest.mark.parametrize(('name', 'value', 'kind', 'words'), [
    ('count', 6, 'accepted', ''),
    ('count', 10, 'accepted', ''),
    ('count', 1.0, 'wrong type', 'INTEGER'),
    ('count', 11, 'out of range', 'Max: 10'),
    ('count', 4, 'off the step', 'step: 3'),
    ('gain', 0.7, 'off the step', 'step: 0.5'),
    ('gain', math.nan, 'out of range', 'nan'),
    ('gain', 1, 'wrong type', 'DOUBLE'),
    ('serial', 'S1', 'read only', 'read-only'),
    ('cuont', 1, 'undeclared', 'Did you mean count'),
    ('limits.low', 6, 'rejected by the node', 'low is too high'),
    ('any', [1.5], 'accepted', ''),
    ('unset', 2.5, 'accepted', ''),
    ('numbers', [], 'accepted', ''),
    ('numbers', (4, 5), 'accepted', ''),
])
def test_set(client, name, value, kind, words):
    before = client.get_parameters()
    result = client.set_parameter(name, value)
    assert result.kind == kind
    assert result.successful == (kind == 'accepted')
    assert words in str(result)
    for part in ('/lab/everything', name):
        assert part in str(result)
    after = client.get_parameters()
    if result.successful:
        assert values.same(after[name], values.normalize(value))
        assert result.raise_for_reason() is result
    else:
        assert repr(after) == repr(before)
        with pytest.raises(ParameterRejectedError, match=kind) as caught:
            result.raise_for_reason()
        assert caught.value.result is result


def test_a_value_that_cannot_be_sent_stops_the_whole_request(client):
    for wrong in (2**63, {'a': 1}, [1, 'a'], 'a\0b'):
        with pytest.raises(InvalidValueError, match='cannot set gain of /lab/everything'):
            client.set_parameters({'count': 9, 'gain': wrong})
    for name in ('', 5):
        with pytest.raises(InvalidValueError, match='name'):
            client.set_parameters({name: 1})
    assert client.get_parameter('count') == 3


def test_descriptors_and_values_are_of_the_same_parameters_though_one_is_deleted_meanwhile(ros):
    class Volatile(Node):
        def __init__(self):
            super().__init__('volatile')
            for number in range(20):
                self.declare_parameter(f'p{number}', number, ParameterDescriptor(dynamic_typing=True))

    class Unlucky(ParameterClient):
        """When it has read which parameters there are, one is deleted."""

        async def _answer(self, service, request):
            answer = await super()._answer(service, request)
            if service == 'list_parameters' and not deleted:
                deleted.append('p0')
                assert self.delete_parameter('p0').successful
            return answer

    deleted = []
    client = Unlucky(ros.add(Volatile))
    descriptors, present = client.describe_and_get()
    assert list(descriptors) == list(present) == client.list_parameters()
    assert deleted and 'p0' not in present
    assert list(client.describe_and_get(['p9', 'gone', 'p8'])[1].items()) == [('p9', 9), ('p8', 8)]


@hypothesis.given(VALUES)
def test_any_value_arrives_and_comes_back_unchanged(ros, value):
    if not ros.nodes:
        ros.add(Everything)
    client = ParameterClient('/lab/everything')
    client.set_parameter('any', value).raise_for_reason()
    assert values.same(client.get_parameter('any'), value)


def test_a_callback_that_raises_answers_at_once_with_its_exception(client, capfd):
    with pytest.raises(CallbackError, match='RuntimeError while it served set_parameters: thirteen') as caught:
        client.set_parameter('limits.high', 13)
    assert isinstance(caught.value.__cause__, RuntimeError)
    assert caught.value.__cause__.__traceback__ is not None
    assert capfd.readouterr().err == ''
    assert client.set_parameter('limits.high', 7).successful


# Of the exceptions in a callback, rclpy catches this one.
def test_a_callback_that_reads_an_undeclared_parameter_is_a_rejection(ros):
    class ReadsUndeclared(Node):
        def __init__(self):
            super().__init__('reads_undeclared')
            self.declare_parameter('speed', 100)
            self.add_on_set_parameters_callback(lambda _: self.get_parameter('nowhere'))

    client = ParameterClient(ros.add(ReadsUndeclared))
    result = client.set_parameter('speed', 150)
    assert (result.successful, result.reason) == (False, 'Invalid access to undeclared parameter(s): nowhere')
    assert client.get_parameter('speed') == 100


@pytest.mark.real_layer(reason='somebody in another process asks')
def test_a_callback_error_that_nobody_here_asked_for_is_printed(ros, capfd):
    ros.add(Everything)
    child = process('''
        import param_tutorial
        ros = param_tutorial.start()
        param_tutorial.wait_until(lambda: '/lab/everything' in ros.services.node_names(), 'the node', 30)
        # In the time limit of the call without an answer, neither the node nor its service need be found.
        patient = param_tutorial.ParameterClient('/lab/everything', timeout_sec=30)
        assert patient.set_parameter('limits.high', 12).successful
        try:
            param_tutorial.ParameterClient('/lab/everything', timeout_sec=1).set_parameter('limits.high', 13)
        except TimeoutError as error:
            print(error)
    ''')
    output, _ = child.communicate()
    assert '/lab/everything did not answer set_parameters within 1 s' in output
    printed = []

    def is_printed():  # which may be after the other process has given up, and ended
        printed.append(capfd.readouterr().err)
        return 'RuntimeError: thirteen' in ''.join(printed)

    param_tutorial.wait_until(is_printed, 'the error to be printed')
    ros.run(lambda: None, 'see the callback through')
    assert ''.join([*printed, capfd.readouterr().err]).count('RuntimeError: thirteen') == 1


def test_a_lost_answer_is_asked_for_again_and_a_set_is_sent_once(ros, monkeypatch):
    """A server that does not know yet where to answer drops its answer (see Services._carry)."""
    node = ros.add(Counter)
    lost = {'list_parameters': 1, 'set_parameters': 1}
    send = ros.services._send

    def send_and_lose_the_first(name, service, *details):
        future = send(name, service, *details)
        if lost.get(service, 0) > 0:
            lost[service] -= 1
            ros.services._client(name, service).remove_pending_request(future)
        return future

    monkeypatch.setattr(ros.services, '_send', send_and_lose_the_first)
    client = ParameterClient(node)
    assert 'x' in client.list_parameters()
    assert client.set_parameter('x', 2).successful
    assert lost == {'list_parameters': 0, 'set_parameters': 0}
    assert node.seen == [2]


@pytest.mark.real_layer(reason='the node is in another process')
def test_a_node_that_does_not_answer(ros, remote):
    child = remote('remote')
    ParameterClient('/remote', timeout_sec=30).list_parameters()
    client = ParameterClient('/remote', timeout_sec=0.3)
    with standing_still(child):
        with pytest.raises(NoAnswerError, match=r'/remote did not answer list_parameters within 0\.3 s'):
            client.list_parameters()
        late = ros.services.call_async('/remote', 'list_parameters', ListParameters.Request(), timeout_sec=0.1)
        param_tutorial.wait_until(late.done, 'the call to expire')
        assert isinstance(late.exception(), NoAnswerError)
    assert ParameterClient('/remote', timeout_sec=30).get_parameter('x') == 1
    assert ros.services._pending == {}


@pytest.mark.real_layer(reason='the node is in another process')
def test_a_node_that_leaves_in_mid_call(ros):
    child = process("""
        import rclpy
        from rclpy.node import Node
        class Leaving(Node):
            def __init__(self):
                super().__init__('leaving')
                self.declare_parameter('x', 1)
                self.add_on_set_parameters_callback(self.leave)
            def leave(self, parameters):
                raise KeyboardInterrupt
        rclpy.init(args=['--ros-args', '--disable-stdout-logs', '--disable-external-lib-logs'])
        try:
            rclpy.spin(Leaving())
        except KeyboardInterrupt:
            rclpy.shutdown()
    """)
    client = ParameterClient('/leaving', timeout_sec=60)
    param_tutorial.wait_until(lambda: ros.services.is_ready('/leaving'), 'the node', timeout_sec=30)
    with pytest.raises(NodeGoneError, match='not known'):
        client.set_parameter('x', 2)
    child.communicate()


def test_an_error_about_a_huge_value_is_short(ros):
    node = ros.add(Node, 'atlas')
    ros.run(lambda: node.declare_parameter('map', [0] * 10_000), 'declare')
    client = ParameterClient(node)
    for shown in (client.set_parameter('map', [1] * 10_000), client.get_parameters()):
        assert '… (10000 elements)' in repr(shown)
        assert len(repr(shown)) < 1000


def test_clients_are_forgotten_unless_they_wait_for_an_answer(ros):
    client = ParameterClient(ros.add(Everything))
    assert client.get_parameter('count') == 3

    def ask_and_forget():
        """In the executor's thread, so that no answer can come in between."""
        answer = ros.services.call_async('/lab/everything', 'get_parameters', GetParameters.Request(names=['count']))
        ros.services.forget('/lab')
        return answer, [each.srv_name for each in ros.tool_node.clients]

    answer, left = ros.run(ask_and_forget, 'ask')
    assert [name for name in left if name.startswith('/lab/')] == ['/lab/everything/get_parameters']
    param_tutorial.wait_until(answer.done, 'the answer')
    assert answer.result().values[0].integer_value == 3
    param_tutorial.wait_until(lambda: ros.services._pending == {}, 'the call to be forgotten')
    ros.run(lambda: ros.services.forget('/lab'), 'forget')
    assert not any(each.srv_name.startswith('/lab/') for each in ros.tool_node.clients)
    assert client.set_parameter('count', 6).successful
