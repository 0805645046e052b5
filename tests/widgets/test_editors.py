"""The controls of a panel: which editor a parameter gets, what a person enters, what springs back.

What a person does in the browser arrives as a message; ``enter`` and ``slide`` send just that.
"""

import math

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from rclpy.node import Node

from param_tools import values
from param_tools.node.client import Descriptor, ParameterClient, Range
from param_tools.panel import control
from param_tools.panel.panel import ParameterPanel
from tests.support.nodes import INT64_MAX
from tests.support.strategies import INT64
from tests.support.widgets import enter, is_locked, says, shows, slide

NODE = '/arm'

# For each parameter its editor, the last position of its slider, and what it shows at first.
EDITORS = {
    'enabled': ('check', None, ('true',)), 'serial': ('text', None, ('4611686018427387905',)),
    'joints': ('text', 3, ('5', 1)), 'offset': ('text', None, ('0.5',)), 'reach': ('text', 199, ('0.5', 49)),
    'gains.kp': ('text', 4, ('0.3', 1)), 'gains.ki': ('text', None, ('0.0',)), 'tool': ('text', None, ('gripper',)),
    'notes': ('lines', None, ('one\ntwo',)), 'flags': ('text', None, ('[true, false]',)),
    'order': ('text', None, ('[3, 1, 2]',)), 'limits': ('text', None, ('[-1.5, inf]',)),
    'names': ('text', None, ('[base, "elbow, left"]',)), 'firmware': ('text', None, ('[0x00, 0xff]',)),
    'model': ('text', None, ('A1',)), 'payload': ('text', None, ('1.5',)), 'calibrated_at': ('text', None, ('',)),
    'endless': ('text', None, ('1.0',)), 'fixed': ('text', None, ('7',)), 'huge': ('text', None, ('0',)),
}


def test_every_parameter_gets_the_editor_of_its_type_and_range(arm):
    assert {name: (arm[name].row.editor, arm[name].scale and arm[name].scale.last, shows(arm, name))
            for name in EDITORS} == EDITORS
    assert arm._front.markup.count('placeholder="not set"') == 1


def test_an_empty_text_is_not_shown_as_not_set(arm):
    for name in ('tool', 'calibrated_at'):
        enter(arm, name, '')
    arm.settle()
    assert arm['calibrated_at'].value == ''
    assert [panel._front.markup.count('not set') for panel in (arm, ParameterPanel('/arm'))] == [0, 0]
    assert 'value="" placeholder="empty text"' in arm._front.markup


@pytest.mark.parametrize(('name', 'entered', 'stored', 'shown'), [
    ('enabled', 'false', False, ('false',)),
    ('serial', str(INT64_MAX), INT64_MAX, (str(INT64_MAX),)),
    ('serial', ' -0x10 ', -16, ('-16',)),
    ('offset', '3', 3.0, ('3.0',)),
    ('offset', '.nan', math.nan, ('nan',)),
    ('reach', '0.123456789', 0.123456789, ('0.123456789', 11.3)),
    ('tool', '  <b>ü 机械</b> "quoted" ', '  <b>ü 机械</b> "quoted" ', ('  <b>ü 机械</b> "quoted" ',)),
    ('tool', r'"a\u202eb"', 'a\u202eb', (r'"a\u202eb"',)),  # as it is, it would be seen in another order
    ('tool', r'"\"a\\u202eb\""', r'"a\u202eb"', (r'"\"a\\u202eb\""',)),  # which looks like that one
    ('notes', 'a\nb\n', 'a\nb\n', ('a\nb\n',)),
    ('flags', 'true, TRUE, false', [True, True, False], ('[true, true, false]',)),
    ('order', '', [], ('[]',)),
    ('names', '[a, "b, c", \'d\'\'e\', 007, true]', ['a', 'b, c', "d'e", '007', 'true'],
     ('[a, "b, c", "d\'e", 007, true]',)),
    ('firmware', '[0, 0x7f, 255]', [b'\x00', b'\x7f', b'\xff'], ('[0x00, 0x7f, 0xff]',)),
    ('payload', '[1.5, .nan]', [1.5, math.nan], ('[1.5, .nan]',)),
    ('payload', 'some words', 'some words', ('some words',)),
])
def test_what_is_entered_reaches_the_node_with_its_type(arm, name, entered, stored, shown):
    enter(arm, name, entered)
    arm.settle()
    assert values.same(ParameterClient(NODE).get_parameter(name), stored)
    assert arm[name].message == ''
    assert shows(arm, name) == shown


@pytest.mark.parametrize(('name', 'entered', 'reason'), [
    ('serial', '1.5', "'1.5' cannot be read: serial takes an integer, e.g. 42"),
    ('serial', str(2**63), '9223372036854775808 does not fit into the 64 bits of a ROS integer '
                           '(-9223372036854775808 to 9223372036854775807)'),
    ('offset', '1,5', "'1,5' cannot be read: offset takes a double, e.g. 0.5"),
    ('order', '[1, 2', "'[1, 2' cannot be read: order takes integers, e.g. [1, 2, 3]"),
    ('names', '["a]', '\'["a]\' cannot be read: names takes strings, e.g. [left, "right, far"]'),
    ('firmware', '[256]', "'[256]' cannot be read: firmware takes bytes, e.g. [0x00, 0xff]"),
    ('tool', 'a\0b', 'a ROS string ends at its first NUL character, so it cannot hold one'),
])
def test_what_is_no_value_springs_back_and_says_why(arm, name, entered, reason):
    before = shows(arm, name)
    enter(arm, name, entered)
    arm.settle()
    assert shows(arm, name) == before
    assert says(arm, name) == ('rejected', reason)


@pytest.mark.parametrize(('name', 'stored'), [
    ('joints', {2: 9, 3: 12, 0: 1}), ('reach', {29: 0.3, 29.1: 0.301, 199: 2.0, 0: 0.01}),
    ('gains.kp', {3: 0.9, 4: 1.0, 0: 0.0})])
def test_a_slider_reaches_round_numbers_and_both_ends(arm, name, stored):
    for position, value in stored.items():
        slide(arm, name, position)
        arm.settle()
        assert values.same(arm[name].value, value)
        assert arm[name].message == ''
        assert shows(arm, name) == (repr(value), position)


@pytest.mark.parametrize(('kind', 'limits', 'known'), [
    (values.DOUBLE, Range(1e-9, 1e6, 0.0), {0: 1e-9, 180: 1.0, 180.1: 1.01, 181: 1.1, 299: 890000.0, 300: 1e6}),
    (values.INTEGER, Range(1, 1_000_000, 0), {0: 1, 8: 9, 9: 10, 10: 11, 11: 13, 109: 1_000_000}),
    (values.DOUBLE, Range(0.5, 100_000.5, 0.25), {0: 0.5, 1: 0.75}),
    (values.INTEGER, Range(1, 10_000, 0), {1: 2, 9999: 10_000})])  # no more than four decades
def test_beyond_four_decades_a_slider_is_logarithmic(kind, limits, known):
    scale = control.scale_of(Descriptor('x', kind, '', '', False, False, limits), limits.from_value)
    assert {position: scale.value(position) for position in known} == known
    assert {scale.nearest(value): value for value in known.values()} == known
    assert scale.is_logarithmic == (limits.to_value > 10_000)


def test_a_locked_parameter_is_locked_and_the_node_has_the_last_word(arm):
    assert is_locked(arm, 'model')
    assert not is_locked(arm, 'tool')
    assert '<b>read only</b>' in arm._front.markup
    arm['model'].value = 'B2'
    arm.settle()
    assert 'read-only' in arm['model'].message
    assert shows(arm, 'model') == ('A1',)


# Where arithmetic with doubles goes wrong.
EDGES = st.sampled_from([0.0, -0.0, 5e-324, -5e-324, 2.2250738585072014e-308, 1.0, math.nextafter(1.0, 2.0), 1e16,
                         1e308, 1.7976931348623157e308, -1.7976931348623157e308, math.inf, -math.inf, math.nan])
DOUBLES = st.one_of(EDGES, st.floats())
INTEGERS = st.one_of(st.sampled_from([-2**63, -2**63 + 1, -2**53, -1, 0, 1, 2**53, 2**53 + 1, 2**63 - 1]), INT64)
STEPS = st.one_of(st.sampled_from([0, 1, 2**53, 2**63, 2**64 - 1]), st.integers(0, 2**64 - 1))


@given(st.one_of(st.tuples(st.just(values.DOUBLE), DOUBLES, DOUBLES, DOUBLES, DOUBLES),
                 st.tuples(st.just(values.INTEGER), INTEGERS, INTEGERS, INTEGERS, STEPS)))
@example((values.DOUBLE, 0.0, 0.0, 5e-324, 0.0))  # what a range declared with the integers 0 and 16 may arrive as
@example((values.DOUBLE, 0.5, 1.0, 0.0, 0.1))  # reversed
@example((values.DOUBLE, 0.5, 0.5, 0.5, 0.0))  # no width
@example((values.DOUBLE, 0.0, 0.0, 1.0, math.nan))
@example((values.DOUBLE, 0.0, 0.0, 1e308, 5e-324))
@example((values.DOUBLE, math.nan, 0.0, 1.0, 0.1))
@example((values.INTEGER, 0, -2**63, 2**63 - 1, 2**64 - 1))
@example((values.INTEGER, 0, 10, 0, 0))
def test_a_slider_of_whatever_range_a_node_describes_stays_in_it(described):
    kind, value, first, last, step = described
    descriptor = Descriptor('x', kind, '', '', False, False, Range(first, last, step))
    scale = control.scale_of(descriptor, value)
    if scale:
        assert all(first <= scale.value(position) <= last for position in (0, scale.last))
        assert not math.isfinite(value) or 0 <= scale.nearest(value) <= scale.last


NAMES = ['n' * 1000, '.', 'a..b', 'ends.', '.begins', 'with space', 'new\nline', 'tab\t', 'ümlaut.ß', '🤖', '"quoted"',
         "it's", '/**', '/arm', '-p', 'a:=b', 'ros__parameters', '*', '#', '{}', '[1]', 'null', 'true', '1', '<b>',
         '&amp;']


class Odd(Node):
    """Has parameters of names that no guideline allows, and rclpy does."""

    def __init__(self):
        super().__init__('odd')
        for number, name in enumerate(NAMES):
            self.declare_parameter(name, number)


def test_a_parameter_of_any_name_is_shown_and_changed(ros):
    client = ParameterClient(ros.add(Odd))
    panel = ParameterPanel('/odd')
    for number, name in enumerate(NAMES):
        enter(panel, name, str(number + 100))
    panel.settle()
    for number, name in enumerate(NAMES):
        assert client.get_parameter(name) == number + 100
        assert shows(panel, name) == (str(number + 100),)
