"""aliases: an old name does what the new one does, at the start and later, and says that it is old."""

import pytest
from rcl_interfaces.msg import IntegerRange, ParameterDescriptor
from rclpy.exceptions import InvalidParameterValueException
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools import Aliases
from param_tools.errors import AliasError
from param_tools.node.client import changes
from param_tutorial import ParameterClient, wait_until


class Robot(Node):
    def __init__(self, **options):
        super().__init__('robot')
        self.aliases = Aliases(self, {'speed': 'max_speed', 'v': 'max_speed', 'sn': 'serial', 'free': 'any',
                                      'start': 'unset'}, **options)
        self.at_start = self.declare_parameter('max_speed', 100, ParameterDescriptor(
            description='Top speed.', integer_range=[IntegerRange(from_value=0, to_value=300, step=1)])).value
        self.declare_parameter('serial', 'S1', ParameterDescriptor(read_only=True))
        self.declare_parameter('any', None, ParameterDescriptor(dynamic_typing=True))
        self.declare_parameter('unset', Parameter.Type.DOUBLE_ARRAY)
        self.declare_parameter('other', 1)


@pytest.fixture
def client(ros):
    return ParameterClient(ros.add(Robot))


def warnings(ros, node, *wanted):
    """Expect a node's warnings; its name must be new, since a late log line of an earlier test may still come."""
    wait_until(lambda: len(ros.node_log.lines(f'/{node}')) >= len(wanted), 'the warnings')
    assert ros.node_log.lines(f'/{node}') == [
        f'[WARN] [{node}]: {old} is deprecated: set {new} instead' for old, new in wanted]


SPEEDS = ['max_speed', 'speed', 'v']


@pytest.mark.parametrize('name', SPEEDS)
@pytest.mark.parametrize('verb', ['set_parameters', 'set_parameters_atomically'])
def test_every_name_sets_all_of_them(client, name, verb):
    assert getattr(client, verb)({name: 50, 'other': 7}).successful
    assert client.get_parameters([*SPEEDS, 'other']) == {'max_speed': 50, 'speed': 50, 'v': 50, 'other': 7}


def test_one_change_is_one_event_with_all_names(ros, client):
    events = []
    stop = ros.on_parameter_event(lambda event: events.append(dict(changes(event))))
    client.set_parameter('v', 50)
    wait_until(lambda: {'max_speed': 50, 'speed': 50, 'v': 50} in events, 'the event')
    stop()
    assert [event for event in events if 50 in event.values()] == [{'max_speed': 50, 'speed': 50, 'v': 50}]


def test_two_names_with_two_values_are_rejected_and_with_one_value_are_one(client):
    rejected = client.set_parameters_atomically({'speed': 1, 'max_speed': 2, 'other': 3})
    assert rejected[0].reason == 'speed = 1 and max_speed = 2 are one parameter: set max_speed only'
    rejected = client.set_parameters_atomically({'speed': 1, 'v': 2})
    assert rejected[0].reason == 'speed = 1 and v = 2 are one parameter: set max_speed only'
    assert client.get_parameters([*SPEEDS, 'other']) == {'max_speed': 100, 'speed': 100, 'v': 100, 'other': 1}
    assert client.set_parameters_atomically({'v': 2, 'max_speed': 2}).successful
    assert client.get_parameter('speed') == 2
    # One by one they are two changes.
    assert client.set_parameters({'v': 3, 'max_speed': 4}).successful
    assert client.get_parameters(SPEEDS) == dict.fromkeys(SPEEDS, 4)


def test_parameters_without_a_value_and_of_any_type_follow_too(client):
    assert client.get_parameters(['any', 'free', 'unset', 'start']) == dict.fromkeys(['any', 'free', 'unset', 'start'])
    client.set_parameter('start', [1.5])
    client.set_parameter('any', 'x')
    assert client.get_parameters(['unset', 'start', 'free']) == {'unset': [1.5], 'start': [1.5], 'free': 'x'}
    client.set_parameter('free', 2.5)
    assert client.get_parameter('any') == 2.5
    client.delete_parameter('free')
    assert not {'any', 'free'} & set(client.list_parameters())


@pytest.mark.parametrize('name', SPEEDS)
def test_an_override_of_any_name_reaches_the_declaration(ros, name):
    node = ros.add(Robot, ros_args=['-r', f'__node:=starts_with_{name}', '-p', f'{name}:=200'])
    assert node.at_start == 200
    assert ParameterClient(node).get_parameters(SPEEDS) == dict.fromkeys(SPEEDS, 200)
    warnings(ros, f'starts_with_{name}', *([(name, 'max_speed')] if name != 'max_speed' else []))


def test_a_dump_starts_the_node_again_and_loads(ros, client, tmp_path):
    client.set_parameter('max_speed', 50)
    client.dump(tmp_path / 'dump.yaml')
    # A file of old names reaches read-only parameters, too.
    (tmp_path / 'old.yaml').write_text('/robot: {ros__parameters: {sn: S9, speed: 30}}')
    client = ParameterClient(ros.add(Robot, ros_args=['--params-file', str(tmp_path / 'old.yaml')]))
    assert client.get_parameters(['serial', 'sn', 'v']) == {'serial': 'S9', 'sn': 'S9', 'v': 30}
    client = ParameterClient(ros.add(Robot, ros_args=['--params-file', str(tmp_path / 'dump.yaml')]))
    assert client.get_parameter('v') == 50
    client.set_parameter('max_speed', 60)
    assert client.load(tmp_path / 'dump.yaml', atomically=True).successful
    assert client.get_parameter('v') == 50


def test_overrides_that_disagree_keep_the_node_from_starting(ros):
    with pytest.raises(AliasError, match='speed and max_speed are one parameter of /robot, and at its start one was '
                                         'given 1 and the other 2: remove the one for speed'):
        ros.add(Robot, ros_args=['-p', 'speed:=1', '-p', 'max_speed:=2'])
    with pytest.raises(AliasError, match='v and max_speed are one'):
        ros.add(Robot, ros_args=['-p', 'speed:=1', '-p', 'v:=2'])
    assert not ros.nodes


@pytest.mark.parametrize(('names', 'words'), [
    ({'a': 'a'}, 'a cannot stand for itself'),
    ({'a': 'b', 'b': 'c'}, 'a cannot stand for b, which is an old name itself: name the newest one'),
    ({'a': 'b', 'b': 'a'}, 'an old name itself'),
    ({'': 'a'}, "'' cannot stand for 'a'"), ({'a': None}, "'a' cannot stand for None"),
    ({'use_sim_time': 'a'}, '/robot has declared use_sim_time already'),
])
def test_nonsense_is_rejected_at_once(ros, names, words):
    node = ros.add(Node, 'robot')
    with pytest.raises(AliasError) as raised:
        Aliases(node, names)
    assert words in str(raised.value)
    Aliases(node, {'a': 'b'})  # nothing was left behind


@pytest.mark.parametrize('name', ['speed', 'v'])
def test_an_old_name_cannot_be_declared(ros, name):
    class Forgetful(Robot):
        def __init__(self):
            super().__init__()
            self.undeclare_parameter(name)
            self.declare_parameter(name, 1)

    with pytest.raises(InvalidParameterValueException, match='is an old name of max_speed, which declares it'):
        ros.add(Forgetful)


def test_the_nodes_own_pre_set_callback_sees_new_names_only(ros):
    seen = []

    def halve(parameters):
        seen.extend(parameter.name for parameter in parameters)
        return [Parameter('max_speed', value=parameter.value // 2) if parameter.name == 'max_speed' else parameter
                for parameter in parameters]

    client = ParameterClient(ros.add(Robot, pre_set=halve))
    assert client.set_parameters_atomically({'speed': 100, 'other': 5}).successful
    assert seen == ['max_speed', 'other']
    assert client.get_parameters([*SPEEDS, 'other']) == {'max_speed': 50, 'speed': 50, 'v': 50, 'other': 5}


def test_a_second_pre_set_callback_is_reported(ros, client):
    ros.nodes[0].add_pre_set_parameters_callback(lambda parameters: parameters)
    reason = 'is there twice in one change. If the request named it once, the node has another pre-set callback'
    for name in SPEEDS:
        assert reason in client.set_parameter(name, 50).reason
    assert client.set_parameter('other', 2).successful
    assert client.get_parameters(SPEEDS) == dict.fromkeys(SPEEDS, 100)
