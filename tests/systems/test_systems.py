"""Whole systems: saved and read back, compared in every combination, previewed before they are restored."""

import json
import math
from xml.etree import ElementTree

import hypothesis.strategies as st
import pytest
from hypothesis import HealthCheck, given, settings
from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node

from param_tools import all_parameters, values
from param_tools.errors import NoAnswerError, NodeGoneError, NodeNotFoundError, ParameterFileError
from param_tools.node.client import ParameterClient, ParameterValues
from param_tools.systems.describe import describe
from param_tools.systems.sets import MAY_BE_TAKEN, Outcome, ParameterSet, Restored, preview, restore
from param_tools.systems.snapshot import Snapshot
from param_tools.systems.systems import SystemRestored, compare_systems, defaults_of, of_robot
from tests.files.test_parameter_files import NAMES
from tests.support.nodes import Arm
from tests.support.strategies import VALUES

NODES = st.sampled_from(['/arm', '/left/arm', '/camera_1', '/a/b/c'])
SYSTEMS = st.dictionaries(NODES, st.dictionaries(NAMES, VALUES, max_size=4), max_size=3)


@pytest.mark.slow
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(SYSTEMS)
def test_a_snapshot_comes_back_but_for_what_it_names(tmp_path, system):
    path = tmp_path / 'snapshot.yaml'
    dump = Snapshot({node: ParameterValues(each) for node, each in system.items()}, {}).dump()
    dump.save(path)
    again = Snapshot.from_file(path)
    assert list(again) == list(system)
    for node, parameters in system.items():
        expected = {name: value for name, value in parameters.items() if f'{node}: {name}' not in dump.left_out
                    or (name and values.is_empty_array(value) and '\0' not in name)}
        assert again[node].keys() == expected.keys()
        assert all(values.same(again[node][name], value) for name, value in expected.items())


def test_the_head_names_what_was_empty_and_a_value_written_since_counts(tmp_path):
    path = tmp_path / 'snapshot.yaml'
    dump = Snapshot({'/arm': ParameterValues({'texts': [], 'a': 1}), '/bare': ParameterValues({'x.y': []})}, {}).dump()
    assert dump.left_out == {key: 'an empty array in a parameter file has no type; only restore and diff know it, from '
                                  'the head of the snapshot' for key in ('/arm: texts', '/bare: x.y')}
    dump.save(path)
    assert Snapshot.from_file(path) == {'/arm': {'a': 1, 'texts': []}, '/bare': {'x.y': []}}
    path.write_text(dump.text.replace('    a: 1', '    texts: [b]'))
    assert Snapshot.from_file(path) == {'/arm': {'texts': ['b']}, '/bare': {'x.y': []}}
    # A node whose block was taken out is not in it any more.
    path.write_text(dump.text[:dump.text.index('/bare:')])
    assert Snapshot.from_file(path) == {'/arm': {'a': 1, 'texts': []}}
    # In a file that is none of ours, a comment is a comment.
    path.write_text(dump.text.replace('# Snapshot of', '# A snapshot of'))
    assert Snapshot.from_file(path) == {'/arm': {'a': 1}, '/bare': {}}


@pytest.mark.parametrize('words', ['', '{', '[]', '{"/arm": "texts"}', '{"/arm": [1]}', '{"/arm": [""]}', '[' * 99999])
def test_a_head_that_names_no_arrays_is_an_error(tmp_path, words):
    path = tmp_path / 'snapshot.yaml'
    path.write_text(f'# Snapshot of 1 node\n# Empty arrays: {words}\n/arm: {{ros__parameters: {{a: 1}}}}\n')
    with pytest.raises(ParameterFileError, match='line 2: this comment must name the arrays that are empty, as in'):
        Snapshot.from_file(path)


@pytest.mark.slow
@given(SYSTEMS, SYSTEMS)
def test_a_difference_leads_from_one_system_to_the_other(first, second):
    difference = compare_systems(first, second)
    built = {node: dict(parameters) for node, parameters in first.items() if node not in difference.only_before}
    built |= {node: dict(second[node]) for node in difference.only_after}
    for each in difference:
        if each.change.kind == 'removed':
            del built[each.node][each.change.name]
        else:
            built[each.node][each.change.name] = each.change.after
    assert not compare_systems(built, second)
    assert len(json.loads(difference.as_json())) == len(difference) == len(difference.rows())


def test_a_difference_as_text_and_as_a_table():
    difference = compare_systems(
        {'/arm': {'speed': 0.5, 'name': '<b>'}, '/gone': {}, '/same': {'a': 1}},
        {'/arm': {'speed': 0.75, 'name': '&'}, '/new': {}, '/same': {'a': 1}}, labels=('monday.yaml', 'now'))
    assert repr(difference) == '''\
monday.yaml → now: 2 differences in 1 node, 1 the same, 1 node only in monday.yaml, 1 node only in now

node   parameter  difference           before  after
/gone             only in monday.yaml
/new              only in now
/arm   speed      changed value        0.5     0.75
/arm   name       changed value        '<b>'   '&\''''
    html = difference._repr_html_()
    assert '&lt;b&gt;' in html
    ElementTree.fromstring(html[html.index('<table'):])
    assert difference['/arm']['speed'].after == 0.75
    assert json.loads(compare_systems({'/a': {'x': 1.0}}, {'/a': {'x': math.nan}}).as_json())[0]['after'] == 'nan'


def test_robots_are_compared_by_the_names_below_their_namespaces():
    system = {'/robot1/arm': {'a': 1}, '/robot2/arm': {'a': 2}, '/robot10/arm': {}, '/robot1/base': {}}
    difference = compare_systems(of_robot(system, '/robot1'), of_robot(system, 'robot2/'))
    assert [(each.node, each.change.name) for each in difference] == [('/arm', 'a')]
    assert difference.only_before == ('/base',)


def test_running_nodes_are_compared_with_a_file_and_with_their_defaults(ros, tmp_path):
    ros.add(Arm)
    before, described = all_parameters(), describe()
    path = tmp_path / 'before.yaml'
    before.dump().save(path)
    assert not compare_systems(Snapshot.from_file(path), all_parameters(), partial=True)
    restore('/arm', {'offset': 0.75})
    changed = compare_systems(Snapshot.from_file(path), all_parameters(), partial=True)
    assert [(each.node, each.change.name, each.change.after) for each in changed] == [('/arm', 'offset', 0.75)]
    assert [each.change.name for each in compare_systems(defaults_of(described), all_parameters(), partial=True)] == [
        'offset']


@pytest.mark.parametrize(('content', 'complaint'), [
    ('a: 1', 'line 1: there is a value before'), ('/n: {ros__parameters: {a: }}', 'a has no value')])
def test_what_is_no_snapshot_gets_a_sentence(tmp_path, content, complaint):
    path = tmp_path / 'bad.yaml'
    path.write_text(content)
    with pytest.raises(ParameterFileError, match=r'bad\.yaml.*' + complaint):
        Snapshot.from_file(path)


# -- restoring ------------------------------------------------------------------------------------------------


def test_a_preview_says_what_restoring_would_do_and_does_nothing(ros):
    ros.add(Arm)
    before = all_parameters()
    wanted = {'joints': 9, 'reach': 5.0, 'gains.kp': 0.31, 'model': 'B2', 'tool': 3, 'nothing': 1, 'offset': 0.5}
    expected = preview('/arm', wanted)
    assert {each.name: each.word for each in expected} == {
        'joints': 'would be set', 'reach': 'out of range', 'gains.kp': 'off the step', 'model': 'read only',
        'tool': 'wrong type', 'nothing': 'not declared'}
    assert 'reach' in repr(expected)
    assert not compare_systems(before, all_parameters())
    done = restore('/arm', wanted, one_by_one=True)
    assert {each.name for each in done if each.word == 'set'} == {
        each.name for each in expected if each.word == 'would be set'}


def test_a_preview_does_not_claim_that_a_node_would_reject_what_it_has_not_declared(ros):
    ros.add(Node, 'open', allow_undeclared_parameters=True)
    row, = preview('/open', {'anything': 1})
    assert (row.word, row.reason) == ('not declared', MAY_BE_TAKEN)
    assert ParameterClient('/open').set_parameter('anything', 1).successful


@pytest.mark.parametrize('skip', [True, False])
def test_read_only_values_are_reported_or_passed_over(ros, skip):
    class Locked(Node):
        def __init__(self):
            super().__init__('locked')
            self.declare_parameter('serial', 'A', ParameterDescriptor(read_only=True))
            self.declare_parameter('speed', 1)

    ros.add(Locked)
    restored = restore('/locked', {'serial': 'B', 'speed': 2}, skip_read_only=skip)
    assert restored.complete is skip
    assert [each.name for each in restored] == (['speed'] if skip else ['serial', 'speed'])


def test_what_became_of_many_nodes_is_one_table():
    wanted = ParameterSet({'a': 1, 'b': 2}, 'monday.yaml')
    done = Restored('/arm', wanted, [Outcome('a', 1, 'set'), Outcome('b', 2, 'rejected', 'too large')])
    unanswered = {'/left': NodeGoneError('/left', 'set_parameters'), '/right': NodeNotFoundError('/right', []),
                  '/lift': NoAnswerError('/lift', 'set_parameters', 1)}
    assert repr(SystemRestored('monday.yaml', {'/arm': done}, unanswered)) == '''\
4 nodes from monday.yaml: NOT COMPLETE, 1 of 2 parameters set, 3 without an answer

node    parameter  wanted  outcome    reason
/arm    a          1       set
/arm    b          2       rejected   too large
/left                      gone
/right                     not there
/lift                      no answer'''


@pytest.mark.parametrize(('words', 'is_complete', 'expected'), [
    ([], True, 'nothing to do, all values are there'), (['set'], True, 'complete, 1 parameter set'),
    (['rejected'], False, 'NOT RESTORED, nothing was changed'),
    (['not kept'], False, 'NOT COMPLETE, 0 of 1 parameter set'),
])
def test_the_heading_of_that_table_says_how_it_ended(words, is_complete, expected):
    wanted = ParameterSet({'a': 1}, 'monday.yaml')
    result = SystemRestored('monday.yaml', {'/arm': Restored('/arm', wanted, [Outcome('a', 1, each) for each in words]),
                                            '/lift': Restored('/lift', wanted, [])}, {})
    assert (result.complete, result.heading) == (is_complete, f'2 nodes from monday.yaml: {expected}')
