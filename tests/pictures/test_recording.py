"""A change is recorded as rclpy makes it, the recorder leaves no trace, and the graph is the real one."""

import pytest
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor, ParameterEvent, SetParametersResult
from rclpy.node import Node
from rclpy.parameter import Parameter

import param_tutorial
from param_tools.errors import CallbackError, ExecutorError, InvalidValueError, NodeGoneError
from param_tools.node.client import changes
from param_tutorial import ParameterClient
from param_tutorial.nodes.param_event_monitor import ParamEventMonitor
from param_tutorial.nodes.param_query_node import ParamQueryNode
from param_tutorial.views import node_graph, record_change
from param_tutorial.views.recording import follow_sets


class Ladder(Node):
    """Has a callback of each kind."""

    def __init__(self, name='ladder'):
        super().__init__(name)
        self.declare_parameter('speed', 100)
        self.declare_parameter('limit', 300)
        self.declare_parameter('gain', 0.5, ParameterDescriptor(
            floating_point_range=[FloatingPointRange(from_value=0.0, to_value=1.0)]))
        self.declare_parameter('note', 'dynamic', ParameterDescriptor(dynamic_typing=True))
        self.reacted = []
        self.add_pre_set_parameters_callback(self.trim)
        self.add_on_set_parameters_callback(self.judge)
        self.add_post_set_parameters_callback(self.react)

    def trim(self, parameters):
        return [Parameter(p.name, value=min(p.value, 300)) if p.name == 'speed' else p for p in parameters]

    def judge(self, parameters):
        return SetParametersResult(successful=parameters[0].value != -1, reason='minus one')

    def react(self, parameters):
        self.reacted += [p.value for p in parameters]


@pytest.fixture
def ladder(ros):
    return ros.add(Ladder)


def rows(timeline):
    return [(step.what, step.happened, step.stored) for step in timeline.steps]


# What chapter 5.2 calls the ladder; claims.md, section 2 (a).
def test_a_change_is_recorded_rung_by_rung(ladder):
    assert rows(record_change(ladder, 'speed', 900)) == [
        ('asked', 'set speed to 900', '100'),
        ('pre-set', 'trim sees 900, gives 300', '100'),
        ('on-set', 'judge sees 300, accepts', '100'),
        ('on-set', "rclpy's TimeSource sees 300, accepts", '100'),
        ('stored', 'the value is written', '300'),
        ('event', 'speed = 300', '300'),
        ('post-set', 'react sees 300', '300'),
        ('answer', 'successful', '300')]


def test_a_recorded_change_is_published_to_every_node(ros, ladder):
    heard = []
    stop_listening = ros.on_parameter_event(lambda event: heard.append(changes(event)))
    record_change(ladder, 'speed', 250)
    param_tutorial.wait_until(lambda: {'speed': 250} in heard, 'the event')
    stop_listening()


@pytest.mark.parametrize(('name', 'value', 'last_callback', 'answer'), [
    ('speed', -1, 'on-set', 'rejected: minus one'),
    ('gain', 2.0, 'pre-set', 'rejected: Parameter gain out of range Min: 0.0, Max: 1.0, value: 2.0'),
    ('wings', 2, 'pre-set', 'rejected: Invalid access to undeclared parameter(s): []'),
])
def test_a_rejection_ends_where_it_happens(ladder, name, value, last_callback, answer):
    steps = record_change(ladder, name, value).steps
    assert [steps[-2].what, steps[-1].what, steps[-1].happened] == [last_callback, 'answer', answer]
    assert len({step.stored for step in steps}) == 1


def test_a_deleted_parameter_is_stored_no_more(ladder):
    ladder.remove_pre_set_parameters_callback(ladder.trim)
    steps = {step.what: step for step in record_change(ladder, 'note', None).steps}
    assert (steps['event'].happened, steps['event'].stored) == ('note = None', 'nothing')


def test_an_exception_in_a_callback_is_drawn(ladder):
    steps = record_change(ladder, 'speed', 'fast').steps
    assert [(step.what, step.happened) for step in steps[1:]] == [
        ('pre-set', "trim sees 'fast', raises TypeError"), ('no answer', 'the caller would wait forever')]


@pytest.mark.parametrize('answer', [None, [3]])
def test_a_pre_set_callback_that_answers_nonsense_is_drawn_and_fails_as_without_a_recorder(ros, ladder, answer):
    ladder.add_pre_set_parameters_callback(lambda _: answer)
    with pytest.raises(CallbackError) as bare:
        ParameterClient(ladder).set_parameter('speed', 150)
    timeline = record_change(ladder, 'speed', 150)
    assert f'gives {answer!r}, which is not a list of parameters' in timeline.text
    assert str(ros.errors[-1]) == str(bare.value.__cause__)


@pytest.mark.slow
def test_a_node_that_leaves_while_it_is_recorded_is_reported(ros, ladder):
    ladder.add_post_set_parameters_callback(lambda _: ros.remove(ladder))
    with pytest.raises(NodeGoneError, match='/ladder went away before it answered set_parameters'):
        record_change(ladder, 'speed', 150)


def test_a_huge_value_is_drawn_small(ros):
    node = ros.add(Node, 'atlas')
    ros.run(lambda: node.declare_parameter('map', [0] * 10_000), 'declare')
    timeline = record_change(node, 'map', [1] * 10_000)
    assert len(repr(timeline)) < 10_000 and len(timeline._repr_html_()) < 20_000


def test_the_recorder_leaves_no_trace(ros, ladder):
    def insides():
        return (ladder._pre_set_parameters_callbacks[:], ladder._on_set_parameters_callbacks[:],
                ladder._post_set_parameters_callbacks[:], ladder._parameter_event_publisher)

    before = insides()
    for value in (150, -1, 'fast'):
        record_change(ladder, 'speed', value)
    assert insides() == before
    assert [type(each).__name__ for each in insides()[1]] == ['method', 'method']
    assert ladder.reacted == [150]


class Once(Node):
    """Its callback registers another one and removes itself while it runs, as a callback may."""

    def __init__(self):
        super().__init__('once')
        self.declare_parameter('speed', 1)
        self.add_post_set_parameters_callback(self.first)

    def first(self, _):
        self.remove_post_set_parameters_callback(self.first)
        self.add_post_set_parameters_callback(self.later)

    def later(self, _):
        pass


def test_a_callback_that_replaces_itself_stays_replaced(ros):
    once = ros.add(Once)
    assert 'first sees 2' in repr(record_change(once, 'speed', 2))
    assert once._post_set_parameters_callbacks == [once.later]
    assert 'later sees 3' in repr(record_change(once, 'speed', 3))


def test_the_event_has_left_before_post_set_is_called(ros):
    """Not only in the picture: it can be taken from a subscription while post-set has not returned."""
    heard = []

    class Patient(Node):
        def __init__(self):
            super().__init__('patient')
            self.declare_parameter('speed', 1)
            self.add_post_set_parameters_callback(self.wait)

        def wait(self, _):
            # The executor is busy with this callback, so the message is taken by hand.
            param_tutorial.wait_until(lambda: heard.append(ear.handle.take_message(ear.msg_type, False)) or heard[-1],
                                      'the event')

    patient = ros.add(Patient)
    listener = Node('listener')
    try:
        ear = listener.create_subscription(ParameterEvent, '/parameter_events', lambda event: None, 10)
        param_tutorial.wait_until(ear.get_publisher_count, 'the publisher')
        assert ParameterClient(patient).set_parameter('speed', 2).successful
    finally:
        listener.destroy_node()
    assert heard[-1][0].changed_parameters[0].value.integer_value == 2


def test_only_a_node_on_the_stage_can_be_recorded(ros, ladder):
    ros.remove(ladder)
    with pytest.raises(ExecutorError, match=r'ros\.add'):
        record_change(ladder, 'speed', 1)


def test_a_value_that_no_parameter_can_hold_raises_and_nothing_stays_wrapped(ladder):
    with pytest.raises(InvalidValueError):
        record_change(ladder, 'speed', {1: 2})
    assert ladder._pre_set_parameters_callbacks == [ladder.trim]
    assert type(ladder._pre_set_parameters_callbacks[0]).__name__ == 'method'


def test_who_follows_a_node_hears_of_each_set_and_of_what_the_node_rejects(ros, ladder):
    heard = []
    stop_following = follow_sets(ladder, lambda record: heard.append((record.value, record.stored, record.objection)))
    client = ParameterClient(ladder)
    for value in (900, -1):
        client.set_parameter('speed', value)
    client.set_parameter('gain', 2.0)
    client.set_parameter('wings', 2)
    ros.run(lambda: ladder.set_parameters([Parameter('speed', value=7)]), 'set')
    with pytest.raises(CallbackError):
        client.set_parameter('speed', 'fast')
    stop_following()
    stop_following()
    client.set_parameter('speed', 8)
    assert heard == [
        (900, 300, ''), (-1, 300, 'minus one'),
        (2.0, 0.5, 'Parameter gain out of range Min: 0.0, Max: 1.0, value: 2.0'),
        (2, None, 'Invalid access to undeclared parameter(s): []'), (7, 7, ''),
        ('fast', 7, "TypeError: '<' not supported between instances of 'int' and 'str'")]


def test_several_follow_one_node_and_leave_in_any_order(ladder):
    first, second = [], []
    stop_first, stop_second = follow_sets(ladder, first.append), follow_sets(ladder, second.append)
    ParameterClient(ladder).set_parameter('speed', 1)
    stop_first()
    ParameterClient(ladder).set_parameter('speed', 2)
    stop_second()
    assert ([each.value for each in first], [each.value for each in second]) == ([1], [1, 2])
    assert ladder._pre_set_parameters_callbacks == [ladder.trim]
    assert type(ladder._pre_set_parameters_callbacks[0]).__name__ == 'method'


def test_a_callback_that_sets_another_parameter_is_recorded_by_itself(ros, ladder):
    heard = []

    def set_limit(parameters):
        if parameters[0].name == 'speed':
            ladder.set_parameters([Parameter('limit', value=parameters[0].value)])

    ladder.add_post_set_parameters_callback(set_limit)
    stop_following = follow_sets(ladder, lambda record: heard.append((record.timeline.name, record.stored)))
    ParameterClient(ladder).set_parameter('speed', 5)
    stop_following()
    assert heard == [('limit', 5), ('speed', 5)]


def test_the_graph_is_what_is_connected(ros, ladder):
    ros.add(ParamEventMonitor)
    query = ros.add(ParamQueryNode)
    ParameterClient(ladder).list_parameters()
    graph = node_graph()
    assert {'/ladder', '/param_event_monitor', '/param_query_node'} <= set(graph.serves)
    assert {'/param_event_monitor', 'this notebook'} <= set(graph.listens)
    assert {('this notebook', '/ladder'), ('/param_query_node', '/simple_param_node')} <= set(graph.asks)
    assert '/simple_param_node' in graph.missing
    ros.remove(query)
    assert '/param_query_node' not in node_graph().askers


def test_a_hidden_node_is_not_missed_either(ros, ladder):
    ros.add(Node, '_corner')
    ParameterClient('/_corner').list_parameters()
    assert '_corner' not in repr(node_graph())
