"""What a panel must bear: many hands at once, messages from programs that make mistakes, and names at every limit."""

import threading

import pytest
from rcl_interfaces.msg import Parameter as ParameterMessage
from rcl_interfaces.msg import ParameterEvent, ParameterValue
from rclpy.node import Node
from rclpy.qos import qos_profile_parameter_events

from param_tools import values
from param_tools.node.client import ParameterClient
from param_tools.panel.panel import ParameterPanel
from param_tools.ros.waiting import wait_until
from tests.support.nodes import Counter
from tests.support.widgets import enter, shows, wait_for_value

pytestmark = pytest.mark.slow

INT64 = 2**63


def test_two_panels_and_three_clients_at_once(ros):
    node = ros.add(Counter)
    panels = ParameterPanel('/counter'), ParameterPanel('/counter')
    errors: list[BaseException] = []

    def hurry(number: int) -> None:
        try:
            client = ParameterClient('/counter', timeout_sec=60)
            for each in range(30):
                client.set_parameter('x', 100 * number + each).raise_for_reason()
        except BaseException as error:
            errors.append(error)

    hands = [threading.Thread(target=hurry, args=[number]) for number in (1, 2, 3)]
    for hand in hands:
        hand.start()
    for each in range(30):
        enter(panels[each % 2], 'x', str(1000 + each))
    for hand in hands:
        hand.join()
    for panel in panels:
        panel.settle()
    assert errors == []
    for number in (1, 2, 3):  # none is lost or doubled, and each in its own order
        assert [value for value in node.seen if value // 100 == number] == [100 * number + each for each in range(30)]
    typed = [value for value in node.seen if value >= 1000]
    for parity in (0, 1):
        own = [value for value in typed if value % 2 == parity]
        assert own == sorted(set(own)) and own[-1] == 1028 + parity
    last = ParameterClient('/counter').get_parameter('x')
    assert last == node.seen[-1]
    for panel in panels:
        wait_for_value(panel, 'x', last)
        assert shows(panel, 'x') == (str(last),)


def test_what_a_faulty_program_publishes_neither_ends_nor_misleads_a_panel(arm, ros):
    faulty = ros.add(Node, 'faulty')
    publisher = faulty.create_publisher(ParameterEvent, '/parameter_events', qos_profile_parameter_events)
    heard = []
    ros.on_parameter_event(heard.append)

    def changed(name, **value):
        return [ParameterMessage(name=name, value=ParameterValue(**value))]

    events = [
        ParameterEvent(),
        ParameterEvent(node='no name at all'),
        ParameterEvent(node='/nobody', changed_parameters=changed('x', type=2, integer_value=1)),
        ParameterEvent(node='/arm', changed_parameters=changed('', type=2)),
        ParameterEvent(node='/arm', changed_parameters=changed('no.such', type=4, string_value='?')),
        ParameterEvent(node='/arm', changed_parameters=changed('offset', type=77)),
        ParameterEvent(node='/arm', changed_parameters=changed('offset', type=4, string_value='far')),
        ParameterEvent(node='/arm', new_parameters=changed('offset', type=3, double_value=99.0)),
        ParameterEvent(node='/arm', deleted_parameters=changed('offset', type=0)),
    ]
    for event in events:
        publisher.publish(event)
    wait_until(lambda: len(heard) >= len(events), 'the events')
    arm.settle()
    assert shows(arm, 'offset') == ('0.5',)
    enter(arm, 'offset', '0.75')
    arm.settle()
    assert shows(arm, 'offset') == ('0.75',)
    assert ParameterClient('/arm').get_parameter('offset') == 0.75
    assert ros.failures == type(ros.failures)()


NAMES = ['n' * 1000, '.', 'a..b', 'ends.', '.begins', 'with space', 'new\nline', 'tab\t', 'ümlaut.ß', '🤖', '"quoted"',
         "it's", '/**', '/arm', '-p', 'a:=b', 'ros__parameters', '*', '#', '{}', '[1]', 'null', 'true', '1', '<b>',
         '&amp;']


class Odd(Node):
    """Has parameters of names that no guideline allows, and rclpy does."""

    def __init__(self):
        super().__init__('odd')
        for number, name in enumerate(NAMES):
            self.declare_parameter(name, number)


@pytest.fixture
def odd(ros):
    """Return a client of Odd."""
    ros.add(Odd)
    return ParameterClient('/odd')


def test_any_name_is_read_set_and_shown(odd):
    assert set(NAMES) <= set(odd.list_parameters())
    panel = ParameterPanel('/odd')
    for number, name in enumerate(NAMES):
        assert odd.set_parameter(name, -1).successful
        assert odd.describe_parameter(name).name == name
        enter(panel, name, str(number + 100))
    panel.settle()
    for number, name in enumerate(NAMES):
        assert odd.get_parameter(name) == number + 100
        assert shows(panel, name) == (str(number + 100),)


def test_of_any_name_a_file_holds_the_value_or_says_why_not(odd, tmp_path):
    before = odd.get_parameters()
    dump = odd.dump()
    dump.save(tmp_path / 'odd.yaml')
    odd.set_parameters(dict.fromkeys(NAMES, -1))
    odd.load(tmp_path / 'odd.yaml')
    after = odd.get_parameters()
    assert {name for name in NAMES if after[name] != before[name]} == set(dump.left_out)


@pytest.mark.parametrize('value', [
    -INT64, INT64 - 1, 5e-324, -0.0, float('inf'), float('-inf'), float('nan'), 1.7976931348623157e308, '', ' ',
    'x' * 2**20, '\x7f\u200b\U0010ffff', [False] * 10_000, [-INT64, INT64 - 1], [float('nan'), 5e-324], [''] * 1000,
    [b'\x00', b'\xff']], ids=lambda value: repr(value)[:20])
def test_any_value_at_a_limit_is_set_read_saved_and_loaded(ros, tmp_path, value):
    node = ros.add(Node, 'limits', allow_undeclared_parameters=True)
    client = ParameterClient(node)
    assert client.set_parameter('x', value).successful
    assert values.same(client.get_parameter('x'), value)
    panel = ParameterPanel('/limits')
    assert values.same(panel['x'].value, value)
    dump = client.dump()
    dump.save(tmp_path / 'limits.yaml')
    client.delete_parameter('x')
    if 'x' not in dump.left_out:
        client.load(tmp_path / 'limits.yaml')
        assert values.same(client.get_parameter('x'), value)


@pytest.mark.parametrize('value', [INT64, -INT64 - 1, 'a\x00b', '\ud800', [1, 'a'], [[1]], {}, object()],
                         ids=lambda value: ascii(value)[:20])
def test_a_value_beyond_any_limit_is_a_word_with_the_name_and_changes_nothing(ros, value):
    node = ros.add(Node, 'limits', allow_undeclared_parameters=True)
    client = ParameterClient(node)
    client.set_parameter('x', 1).raise_for_reason()
    with pytest.raises(Exception, match='x') as raised:
        client.set_parameter('x', value)
    assert type(raised.value).__module__ == 'param_tools.errors'
    assert client.get_parameter('x') == 1
