"""All parameters of all nodes: what a snapshot holds, which nodes are missing, and how it is saved and read back."""


import pytest
from hypothesis import given
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools import all_parameters, values
from param_tools.errors import NoAnswerError, NodeNotFoundError, NoServiceError
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


OWN = {'use_sim_time': False, 'start_type_description_service': True}


def test_all_values_of_those_that_are_named_or_of_every_node_but_the_hidden_ones(ros):
    ros.add(Arm)
    ros.add(Node, 'plain')
    ros.add(Node, '_hidden')
    named = all_parameters(['/plain', 'left/arm'])
    assert named == {'/left/arm': {**OWN, 'tool': '', 'pid.kp': 0.0, 'target': None}, '/plain': OWN}
    assert list(named) == ['/left/arm', '/plain']
    assert named.unanswered == {}
    all_of_them = all_parameters()
    assert '/left/arm' in all_of_them
    assert not any('/_' in node for node in [*all_of_them, *all_of_them.unanswered])
    with pytest.raises(TypeError, match='3 is not a node'):
        all_parameters([3])


def test_who_does_not_answer_is_named_and_keeps_nobody(ros, silent):
    arm = ros.add(Arm)
    mute = ros.add(Node, 'mute', start_parameter_services=False)
    snapshot = all_parameters([arm, silent, mute, '/gone'], timeout_sec=1.0)
    assert list(snapshot) == ['/left/arm']
    assert {node: type(error) for node, error in snapshot.unanswered.items()} == {
        '/silent': NoAnswerError, '/gone': NodeNotFoundError, '/mute': NoServiceError}
    with pytest.raises(NoAnswerError):
        snapshot['/silent']
    with pytest.raises(NodeNotFoundError, match=r'no node /left/amr.*/left/arm\?'):
        snapshot['/left/amr']
    assert snapshot.get('/silent') is None


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
