"""All parameters of all nodes: what a snapshot holds, which nodes are missing, and how it is saved and read back."""

import copy
import pickle
import threading
from xml.etree import ElementTree

import pytest
from hypothesis import given
from rcl_interfaces.srv import GetParameters
from rclpy.node import Node
from rclpy.parameter import Parameter

import param_tutorial
from param_tools import all_parameters, values
from param_tools.errors import (
    ExecutorError,
    InvalidValueError,
    NoAnswerError,
    NodeError,
    NodeNotFoundError,
    ParameterNotDeclaredError,
)
from param_tools.files.parameter_files import read_all
from param_tools.node.client import ParameterValues
from param_tools.systems.snapshot import Snapshot
from tests.systems.test_comparing import SYSTEMS


class Arm(Node):
    """One parameter has no value."""

    def __init__(self, **options):
        super().__init__('arm', namespace='/left', **options)
        self.declare_parameters('', [('tool', ''), ('pid.kp', 0.0)])
        self.declare_parameter('target', Parameter.Type.DOUBLE)


class Mute(Node):
    """Offers no parameter services."""

    def __init__(self):
        super().__init__('mute', start_parameter_services=False)


OWN = {'use_sim_time': False, 'start_type_description_service': True}


def test_all_values_of_all_nodes(ros):
    ros.add(Arm)
    ros.add(Node, 'plain')
    snapshot = all_parameters(['/plain', 'left/arm'])
    assert snapshot == {'/left/arm': {**OWN, 'tool': '', 'pid.kp': 0.0, 'target': None}, '/plain': OWN}
    assert list(snapshot) == ['/left/arm', '/plain']
    assert snapshot.unanswered == {}


def test_a_single_node_will_do_and_nonsense_raises_an_error(ros):
    node = ros.add(Node, 'plain')
    assert list(all_parameters('plain')) == list(all_parameters(node)) == ['/plain']
    with pytest.raises(TypeError, match='3 is not a node'):
        all_parameters([3])


def test_without_names_it_is_every_node_but_the_hidden_ones(ros):
    ros.add(Arm)
    ros.add(Node, '_hidden')
    snapshot = all_parameters()
    assert '/left/arm' in snapshot
    assert not any('/_' in node for node in [*snapshot, *snapshot.unanswered])


@pytest.mark.slow
def test_who_does_not_answer_is_named_and_keeps_nobody(ros, silent):
    arm = ros.add(Arm)
    snapshot = all_parameters([arm, silent, ros.add(Mute), '/gone'], timeout_sec=1.0)
    assert list(snapshot) == ['/left/arm']
    assert {node: type(error) for node, error in snapshot.unanswered.items()} == {
        '/silent': NoAnswerError, '/gone': NodeNotFoundError, '/mute': NodeError}
    with pytest.raises(NoAnswerError):
        snapshot['/silent']
    with pytest.raises(NodeNotFoundError, match=r'no node /left/amr.*/left/arm\?'):
        snapshot['/left/amr']
    assert snapshot.get('/silent') is None


def test_all_are_asked_at_the_same_time(ros, monkeypatch):
    """Each of three waits until all three have been asked."""
    together = threading.Barrier(3, timeout=10)
    real = param_tutorial.ParameterClient.get_parameters
    monkeypatch.setattr(param_tutorial.ParameterClient, 'get_parameters',
                        lambda self: together.wait() is not None and real(self))
    nodes = [ros.add(Node, name) for name in ('one', 'two', 'three')]
    assert len(all_parameters(nodes)) == 3


def test_it_raises_instead_of_waiting_in_a_callback(ros):
    with pytest.raises(ExecutorError, match='a callback cannot wait'):
        ros.run(all_parameters, 'ask in a callback')


# claims A153, A154
@pytest.mark.parametrize(('options', 'names', 'types'), [
    ({}, [], []), ({}, ['wings', 'tool', 'pid.kp'], []), ({}, ['tool', 'wings', 'pid.kp'], []),
    ({}, ['tool', 'pid.kp', 'wings'], []), ({}, ['tool', 'target'], []), ({}, ['tool', 'pid.kp'], [4, 3]),
    ({'allow_undeclared_parameters': True}, ['tool', 'wings'], [4, 0]),
    ({'allow_undeclared_parameters': True}, ['tool', 'target'], []),
])
def test_what_empties_an_answer_of_rclpy(ros, options, names, types):
    ros.add(Arm, **options)
    answer = ros.services.call('/left/arm', 'get_parameters', GetParameters.Request(names=names))
    assert [value.type for value in answer.values] == types


SHOWN = Snapshot({'/arm': ParameterValues(tool='<b>', count=0), '/bare': ParameterValues()},
                 {'/dozing': NodeError('/dozing', 'it sleeps')})


def test_it_is_shown_in_lines():
    assert repr(SHOWN).splitlines() == [
        '/arm', "  tool   '<b>'", '  count  0', '/bare', '  (no parameters)', '/dozing', '  no answer: it sleeps']
    assert repr(Snapshot({}, {})) == '(no nodes)'


def test_it_is_shown_as_a_table():
    markup = SHOWN._repr_html_()
    table = ElementTree.fromstring(markup[markup.index('<div'):]).find('table')
    rows = [[cell.text for cell in row] for row in table.iter('tr')]
    assert rows == [['node', 'parameter', 'value'], ['/arm', 'tool', "'<b>'"], ['count', '0'],
                    ['/bare', 'no parameters', None], ['/dozing', 'no answer', 'it sleeps']]
    assert 'no nodes' in Snapshot({}, {})._repr_html_()


@pytest.mark.slow
@given(SYSTEMS)
def test_a_snapshot_comes_back_but_for_what_it_names(tmp_path, system):
    path = tmp_path / 'snapshot.yaml'
    dump = Snapshot({node: ParameterValues(each) for node, each in system.items()}, {}).dump()
    dump.save(path)
    again = read_all(path)
    assert list(again) == list(system)
    for node, parameters in system.items():
        expected = {name: value for name, value in parameters.items() if f'{node}: {name}' not in dump.left_out}
        assert again[node].keys() == expected.keys()
        assert all(values.same(again[node][name], value) for name, value in expected.items())


@pytest.mark.parametrize('copied', [copy.copy, copy.deepcopy, lambda each: pickle.loads(pickle.dumps(each))],
                         ids=['copy', 'deepcopy', 'pickle'])
@pytest.mark.parametrize('error', [
    NodeNotFoundError('/arm', ['/leg']),
    ParameterNotDeclaredError('/arm', 'speed', ['speeds']),
    InvalidValueError('no value'),
], ids=lambda error: type(error).__name__)
def test_a_copy_of_an_error_says_the_same(error, copied):
    other = copied(error)
    assert type(other) is type(error)
    assert str(other) == str(error)
    assert vars(other) == vars(error)
