"""parameter_sets: what differs, what restoring does about it, and what it says where it cannot."""

import math

import hypothesis
import hypothesis.strategies as st
import pytest
from rcl_interfaces.msg import IntegerRange, ParameterDescriptor, SetParametersResult
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools import ParameterHistory, ParameterSet, Rules, compare, restore, values
from param_tools.errors import InvalidValueError, ParameterFileError
from param_tutorial import ParameterClient
from tests.support.strategies import VALUES

SETS = st.dictionaries(st.sampled_from('abcdef'), st.none() | VALUES | st.just([]))
NAMES = ('a', 'b', 'c')
FULL_SETS = st.fixed_dictionaries(dict.fromkeys(NAMES, VALUES))


def kinds(difference):
    return {change.name: change.kind for change in difference}


@pytest.mark.slow
@hypothesis.given(SETS)
def test_a_set_does_not_differ_from_itself(parameters):
    copy = {name: list(value) if isinstance(value, list) else value for name, value in parameters.items()}
    assert not compare(parameters, copy)
    assert compare(parameters, copy).equal == len(parameters)
    assert ParameterSet(parameters) == copy


@pytest.mark.slow
@hypothesis.given(SETS, SETS)
def test_a_difference_tells_each_name_once_and_turns_round(first, second):
    difference, back = compare(first, second), compare(second, first)
    assert {change.name for change in difference} == {change.name for change in back}
    turned = {'added': 'removed', 'removed': 'added'}
    assert {name: turned.get(kind, kind) for name, kind in kinds(difference).items()} == kinds(back)
    assert len(difference) + difference.equal == len({*first, *second})
    assert (ParameterSet(first) == second) is (len(difference) == 0)
    for change in difference:
        assert repr(difference).count(f'\n{change.name} ') == 1


@pytest.mark.slow
@hypothesis.given(SETS, SETS)
def test_a_difference_leads_from_the_first_to_the_second(first, second):
    built = dict(first)
    for change in compare(first, second):
        if change.kind == 'removed':
            del built[change.name]
        else:
            built[change.name] = change.after
    assert not compare(built, second)


@pytest.mark.parametrize(('before', 'after', 'kind'), [
    (1, 1.0, 'changed type'), (1, True, 'changed type'), (1.0, True, 'changed type'), ('1', 1, 'changed type'),
    ([1], [1.0], 'changed type'), ([1], 1, 'changed type'), ([], 1, 'changed type'), ([], [1], 'changed value'),
    (0.0, -0.0, 'changed value'), (1, 2, 'changed value'), (None, 1, 'changed value'), ([1], [1, 2], 'changed value'),
    (math.nan, 0.0, 'changed value'), (math.nan, math.nan, None), ([math.nan], [math.nan], None), ([], [], None),
    (None, None, None), ((1, 2), [1, 2], None)])
def test_the_kinds_of_change(before, after, kind):
    assert kinds(compare({'x': before}, {'x': after})).get('x') == kind


def test_a_difference_as_text_and_as_a_table():
    difference = compare(ParameterSet({'a': 1, 'b': 2, 'gone': '<b>', 'same': 0, 'unset': None}, 'then'),
                         ParameterSet({'a': 1.0, 'b': 3, 'same': 0, 'new': [], 'unset': 5}, 'now'))
    assert repr(difference) == '''then → now: 5 differences, 1 the same

parameter  difference     then         now
a          changed type   1 (integer)  1.0 (double)
b          changed value  2            3
gone       removed        '<b>'        -
unset      changed value  not set      5
new        added          -            []'''
    page = difference._repr_html_()
    assert '<caption>then → now: 5 differences, 1 the same</caption>' in page
    assert '<tr><th scope="row">gone</th><td>removed</td><td>&#x27;&lt;b&gt;&#x27;</td><td>-</td></tr>' in page
    assert difference['b'].after == 3
    with pytest.raises(KeyError):
        difference['same']
    assert repr(compare({'a': 1}, {'a': 1})) == 'before → after: 0 differences, 1 the same'
    assert 'thead' not in compare({}, {})._repr_html_()


def test_a_table_of_huge_arrays_stays_small():
    difference = compare({'map': [0] * 10_000}, {'map': [1] * 10_000})
    assert '… (10000 elements)' in repr(difference)
    assert len(repr(difference)) < 2000 and len(difference._repr_html_()) < 3000


def test_one_element_of_a_long_array_that_differs_is_seen():
    weights = [0.5] * 1000
    difference = repr(compare({'weights': weights}, {'weights': [*weights[:700], 0.75, *weights[701:]]}))
    assert '[…, 0.5, …] (from index 700' in difference
    assert '[…, 0.75, …] (from index 700' in difference


@pytest.mark.parametrize('nonsense', [3, None, Node])
def test_what_is_neither_set_nor_node_raises_an_error(nonsense):
    with pytest.raises(TypeError, match='is not a node: give its name'):
        compare(nonsense, {})


def test_a_set_cannot_be_changed_and_holds_parameters_only():
    numbers = [1, 2]
    kept = ParameterSet({'a': numbers}, 'kept')
    numbers.append(3)
    kept['a'].append(4)
    assert kept['a'] == [1, 2]
    assert repr(kept) == '<ParameterSet: kept, 1 parameter>'
    with pytest.raises(TypeError):
        kept['a'] = 1
    with pytest.raises(InvalidValueError, match=r'kept: a cannot be a parameter: \{\} is a dict'):
        ParameterSet({'a': {}}, 'kept')
    with pytest.raises(InvalidValueError, match='kept: 3 is not a parameter name'):
        ParameterSet({3: 1}, 'kept')
    assert ParameterSet({'a': 1}) != {'a': True}


class Robot(Node):
    def __init__(self, name='robot'):
        super().__init__(name)
        self.declare_parameter('speed', 100, ParameterDescriptor(
            integer_range=[IntegerRange(from_value=0, to_value=300, step=1)]))
        self.declare_parameter('low_c', 18)
        self.declare_parameter('high_c', 22)
        self.declare_parameter('numbers', [1, 2])
        self.declare_parameter('serial', 'S1', ParameterDescriptor(read_only=True))
        self.declare_parameter('unset', Parameter.Type.DOUBLE)
        self.declare_parameter('any', 'free', ParameterDescriptor(dynamic_typing=True))
        Rules(self).check(['low_c', 'high_c'], lambda low, high: low < high, 'low_c must be below high_c')


@pytest.fixture
def client(ros):
    return ParameterClient(ros.add(Robot))


def test_node_with_node_with_file_with_defaults_with_then(ros, client, tmp_path):
    then = ParameterSet.of(client, 'then')
    ros.add(Robot, 'twin')
    assert not compare('/robot', '/twin')
    client.set_parameters({'speed': 50, 'any': 1})
    assert kinds(compare('/twin', client)) == {'speed': 'changed value', 'any': 'changed type'}
    defaults = ParameterSet.defaults(Robot)
    assert defaults == then
    assert {node.get_fully_qualified_name() for node in ros.nodes} == {'/robot', '/twin'}
    assert repr(compare(defaults, client, names=['speed', 'serial', 'nowhere'])) == (
        'defaults of Robot → /robot: 1 difference, 1 the same\n\n'
        'parameter  difference     defaults of Robot  /robot\nspeed      changed value  100                50')
    (tmp_path / 'robot.yaml').write_text('/**: {ros__parameters: {speed: 50, low_c: 20, extra: 1}}')
    file = ParameterSet.from_file(tmp_path / 'robot.yaml', client)
    assert file.label == 'robot.yaml'
    assert kinds(compare(client, file, names=file)) == {'low_c': 'changed value', 'extra': 'added'}
    assert not compare(then, defaults)
    with pytest.raises(ParameterFileError):
        ParameterSet.from_file(tmp_path / 'none.yaml', client)


def test_defaults_are_not_those_of_the_node_on_the_stage(ros):
    node = ros.add(Robot, ros_args=['-p', 'speed:=7'])
    assert ParameterSet.defaults(Robot)['speed'] == 100
    assert ParameterSet.of(node)['speed'] == 7
    assert ros.nodes == (node,)


def test_restore_sets_what_differs_in_one_request(client):
    then = ParameterSet.of(client, 'then')
    client.set_parameters_atomically({'low_c': 30, 'high_c': 40, 'numbers': [], 'any': 2.5})
    restored = restore(client, then)
    assert restored.complete
    assert repr(restored) == '''/robot from then: complete, 4 parameters set

parameter  wanted  outcome  reason
low_c      18      set
high_c     22      set
numbers    [1, 2]  set
any        'free'  set'''
    assert not compare(then, client)
    assert repr(restore(client, then)) == '/robot from then: nothing to do, all values are there'


def test_what_no_request_can_change_is_reported_and_the_rest_is_set(client):
    client.set_parameter('unset', 1.5)
    restored = restore(client, {'serial': 'S2', 'speed': 1.0, 'unset': None, 'nowhere': 1, 'low_c': 19, 'numbers': []})
    assert not restored.complete
    assert {each.name: each.word for each in restored} == {
        'serial': 'read only', 'speed': 'wrong type', 'unset': 'no value', 'nowhere': 'not declared', 'low_c': 'set',
        'numbers': 'set'}
    assert restored['speed'].reason == 'it is of type integer, not double'
    assert repr(restored).startswith('/robot from given values: NOT COMPLETE, 2 of 6 parameters set\n')
    assert client.get_parameters(['serial', 'speed', 'unset', 'low_c', 'numbers']) == {
        'serial': 'S1', 'speed': 100, 'unset': 1.5, 'low_c': 19, 'numbers': []}


def test_a_reason_of_several_lines_stays_in_its_row(ros, client):
    node = ros.nodes[0]
    node.add_on_set_parameters_callback(lambda _: SetParametersResult(successful=False, reason='no\nand no'))
    restored = restore(client, {'speed': 50})
    assert len(repr(restored).splitlines()) == 4


def test_one_rejection_leaves_everything_as_it_was(client):
    before = ParameterSet.of(client)
    restored = restore(client, {'speed': 301, 'low_c': 19})
    assert not compare(before, client)
    assert [(each.name, each.word) for each in restored] == [('speed', 'left'), ('low_c', 'left')]
    assert all('the node rejected them together: Parameter speed out of range' in each.reason for each in restored)
    assert repr(restored).startswith('/robot from given values: NOT RESTORED, nothing was changed\n')
    assert restore(client, {'speed': 301})['speed'].word == 'rejected'


def test_one_by_one_sets_what_it_can_in_whatever_order_it_takes(client):
    restored = restore(client, {'low_c': 50, 'high_c': 60, 'speed': 301}, one_by_one=True)
    assert {each.name: each.word for each in restored} == {'low_c': 'set', 'high_c': 'set', 'speed': 'rejected'}
    assert 'out of range' in restored['speed'].reason
    assert client.get_parameters(['low_c', 'high_c']) == {'low_c': 50, 'high_c': 60}


def test_a_node_that_stores_something_else_is_told_of(ros, client):
    ros.nodes[0].add_pre_set_parameters_callback(lambda parameters: [
        Parameter(each.name, value=min(each.value, 200)) if each.name == 'speed' else each for each in parameters])
    restored = restore(client, {'speed': 250})
    assert (restored.complete, restored['speed'].word) == (False, 'not kept')
    assert restored['speed'].reason == 'the node holds 200'
    assert 'NOT COMPLETE, 0 of 1 parameter set' in repr(restored)
    assert restore(client, {'speed': 150}).complete


class Open(Node):
    """A node that accepts anything."""

    def __init__(self):
        super().__init__('open')
        for name in NAMES:
            self.declare_parameter(name, 0, ParameterDescriptor(dynamic_typing=True))


@pytest.mark.slow
@hypothesis.settings(suppress_health_check=[hypothesis.HealthCheck.function_scoped_fixture], deadline=None,
                     max_examples=50)
@hypothesis.given(FULL_SETS, FULL_SETS)
def test_restoring_makes_equal_whatever_the_values(ros, first, second):
    if not ros.nodes:
        ros.add(Open)
    assert restore('/open', first).complete
    then = ParameterSet.of('/open')
    restored = restore('/open', second)
    assert restored.complete
    assert {each.name for each in restored} == {change.name for change in compare(first, second)}
    assert not compare(second, '/open', names=NAMES)
    restore('/open', then)
    assert all(values.same(ParameterSet.of('/open')[name], first[name]) for name in NAMES)


@pytest.mark.slow
def test_undo_and_redo(client):
    history = ParameterHistory(client)
    for speed in (110, 120):
        client.set_parameter('speed', speed)
        history.keep()
    history.keep()  # nothing has changed
    client.set_parameter('speed', 130)  # not kept, and not lost
    seen = [client.get_parameter('speed') for _ in range(3) if history.undo().complete]
    assert seen == [120, 110, 100]
    with pytest.raises(LookupError, match='nothing to undo for /robot'):
        history.undo()
    assert [client.get_parameter('speed') for _ in range(3) if history.redo().complete] == [110, 120, 130]
    with pytest.raises(LookupError, match='nothing to redo'):
        history.redo()
    assert repr(history) == '<ParameterHistory: /robot, snapshot 4 of 4>'


def test_a_change_after_an_undo_begins_anew(client):
    history = ParameterHistory(client)
    client.set_parameter('speed', 110)
    history.undo()
    client.set_parameter('speed', 7)
    with pytest.raises(LookupError):
        history.redo()
    history.undo()
    assert client.get_parameter('speed') == 100


def test_an_undo_that_is_rejected_says_so_and_loses_nothing(ros, client):
    history = ParameterHistory(client)
    for speed in (110, 120):
        client.set_parameter('speed', speed)
        history.keep()
    history.undo()
    Rules(ros.nodes[0]).check('speed', lambda speed: speed > 100, 'must be above 100')
    assert history.undo()['speed'].word == 'rejected'
    assert client.get_parameter('speed') == 110
    assert history.redo().complete
    assert client.get_parameter('speed') == 120


def test_a_parameter_that_came_later_does_not_stop_an_undo(ros, client):
    history = ParameterHistory(client)
    for speed in (110, 120):
        client.set_parameter('speed', speed)
        history.keep()
    ros.run(lambda: ros.nodes[0].declare_parameter('new', 1), 'declare')
    history.undo()
    history.undo()
    assert client.get_parameter('speed') == 100
