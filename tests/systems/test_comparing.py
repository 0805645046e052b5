"""Sets of parameters and whole systems compared: what differs, how that is shown, and what it is compared with."""

import math

import hypothesis.strategies as st
import pytest
from hypothesis import given

from param_tools import ParameterSet, compare
from param_tools.errors import InvalidValueError
from param_tools.systems.sets import compare_systems
from tests.files.test_parameter_files import NAMES
from tests.support.strategies import VALUES

SETS = st.dictionaries(st.sampled_from('abcdef'), st.none() | VALUES | st.just([]))
SYSTEMS = st.dictionaries(st.sampled_from(['/arm', '/left/arm', '/camera_1', '/a/b/c']),
                          st.dictionaries(NAMES, VALUES, max_size=4), max_size=3)


def kinds(difference):
    return {changed.name: changed.kind for changed in difference}


@given(SETS, SETS)
def test_a_difference_tells_each_name_once_and_turns_round(first, second):
    difference, back = compare(first, second), compare(second, first)
    turned = {'added': 'removed', 'removed': 'added'}
    assert {name: turned.get(kind, kind) for name, kind in kinds(difference).items()} == kinds(back)
    assert len(difference) + difference.equal == len({*first, *second})
    assert (ParameterSet(first) == second) is (len(difference) == 0)
    assert all(repr(difference).count(f'\n{changed.name} ') == 1 for changed in difference)
    copy = {name: list(value) if isinstance(value, list) else value for name, value in first.items()}
    assert ParameterSet(first) == copy
    assert (compare(first, copy).equal, len(compare(first, copy))) == (len(first), 0)


@pytest.mark.parametrize(('before', 'after', 'kind'), [
    (1, 1.0, 'changed type'), (1, True, 'changed type'), (1.0, True, 'changed type'), ('1', 1, 'changed type'),
    ([1], [1.0], 'changed type'), ([1], 1, 'changed type'), ([], 1, 'changed type'), ([], [1], 'changed value'),
    (0.0, -0.0, 'changed value'), (1, 2, 'changed value'), (None, 1, 'changed value'), ([1], [1, 2], 'changed value'),
    (math.nan, 0.0, 'changed value'), (math.nan, math.nan, None), ([math.nan], [math.nan], None), ([], [], None),
    (None, None, None), ((1, 2), [1, 2], None)])
def test_the_kinds_of_difference(before, after, kind):
    assert kinds(compare({'x': before}, {'x': after})).get('x') == kind


def test_a_difference_as_text_and_as_a_table():
    weights = [0.5] * 999
    difference = compare(
        ParameterSet({'a': 1, 'b': 2, 'gone': '<b>', 'same': 0, 'unset': None, 'w': [*weights, 1.0]}, 'then'),
        ParameterSet({'a': 1.0, 'b': 3, 'same': 0, 'new': [], 'unset': 5, 'w': [*weights, 2.0]}, 'now'))
    assert repr(difference) == '''then → now: 6 differences, 1 the same

parameter  difference     then                                         now
a          changed type   1 (integer)                                  1.0 (double)
b          changed value  2                                            3
gone       removed        '<b>'                                        -
unset      changed value  not set                                      5
w          changed value  […, 1.0, …] (from index 999, 1000 elements)  […, 2.0, …] (from index 999, 1000 elements)
new        added          -                                            []'''
    assert '<td>removed</td><td>&#x27;&lt;b&gt;&#x27;</td>' in difference._repr_html_()
    assert difference['b'].after == 3
    with pytest.raises(KeyError):
        difference['same']


def test_a_difference_of_systems_names_the_nodes_that_only_one_has():
    difference = compare_systems(
        {'/arm': {'speed': 0.5, 'name': '<b>'}, '/gone': {}, '/same': {'a': 1}},
        {'/arm': {'speed': 0.75, 'name': '&'}, '/new': {}, '/same': {'a': 1}}, labels=('monday.yaml', 'now'))
    assert repr(difference) == '''\
monday.yaml → now: 2 differences in 1 node, 1 node the same, 1 node only in monday.yaml, 1 node only in now

node   parameter  difference           before  after
/gone             only in monday.yaml
/new              only in now
/arm   speed      changed value        0.5     0.75
/arm   name       changed value        '<b>'   '&\''''


def test_a_set_cannot_be_changed_and_holds_parameters_only():
    numbers = [1, 2]
    kept = ParameterSet({'a': numbers}, 'kept')
    numbers.append(3)
    kept['a'].append(4)
    assert kept['a'] == [1, 2]
    with pytest.raises(InvalidValueError, match=r'kept: a cannot be a parameter: \{\} is a dict'):
        ParameterSet({'a': {}}, 'kept')
