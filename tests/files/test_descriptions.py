"""Descriptions of nodes: what a node says is saved and comes back; nonsense is named."""

import hypothesis.strategies as st
import pytest
import yaml
from hypothesis import example, given
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor
from rclpy.node import Node

from param_tools import values
from param_tools.descriptor import Descriptor, Range
from param_tools.errors import NoAnswerError, ParameterFileError
from param_tools.files.descriptions import DescribedParameter, Descriptions, NodeDescription, read
from param_tools.systems.snapshot import describe
from param_tutorial import ParameterClient
from tests.support.nodes import Arm
from tests.support.strategies import TEXT, VALUES


class Picky(Node):
    """Judges by rclpy's own ranges."""

    def __init__(self):
        super().__init__('picky')
        describe = ParameterDescriptor
        self.declare_parameter('whole', 10, describe(integer_range=[IntegerRange(from_value=1, to_value=12, step=3)]))
        self.declare_parameter('real', 0.3, describe(
            floating_point_range=[FloatingPointRange(from_value=0.0, to_value=1.0, step=0.3)]))
        self.declare_parameter('shifted', 0.75, describe(
            floating_point_range=[FloatingPointRange(from_value=0.35, to_value=2.0, step=0.2)]))
        self.declare_parameter('backwards', 3, describe(integer_range=[IntegerRange(from_value=5, to_value=1, step=0)]))
        self.declare_parameter('text', 'a')
        self.declare_parameter('texts', ['a'])
        self.declare_parameter('free', 1, describe(dynamic_typing=True))


def test_a_running_node_is_described_saved_and_read_back(ros, tmp_path):
    ros.add(Arm)
    found = describe('/arm')
    path = tmp_path / 'arm.yaml'
    found.dump().save(path)
    again = read(path)
    assert again['/arm'] == found['/arm']
    assert again['/arm'].parameters['gains.kp'].descriptor.range == Range(0.0, 1.0, 0.3)
    assert again['/arm'].parameters['firmware'].default == [b'\x00', b'\xff']
    assert again['/arm'].parameters['calibrated_at'].default is None
    assert not again.complete


def test_all_nodes_are_described_and_one_that_hangs_is_named(ros, silent):
    ros.add(Arm)
    found = describe(timeout_sec=0.5)
    assert list(found) == ['/arm']
    assert not found.complete
    assert isinstance(found.unanswered['/silent'], NoAnswerError)
    assert '# /silent is missing: ' in found.dump().text
    silent.destroy_node()
    assert describe().complete


@pytest.mark.parametrize(('name', 'value'), [
    *(('whole', value) for value in (0, 1, 2, 4, 10, 12, 13, -5, 1.0, True, '1')),
    *(('real', value) for value in (0.0, 0.3, 0.6, 0.9, 0.91, 0.3 + 1e-9, 1.0, 1.1, -0.1, float('nan'), 1)),
    *(('shifted', value) for value in (0.35, 0.55, 0.6, 0.4, 1.95, 2.0)),
    *(('backwards', value) for value in (1, 3, 5, 0, 6)), ('text', 'b'), ('text', 1), ('texts', ['b', 'c']),
    ('texts', [1]), ('texts', 'b'), ('free', 'x'), ('free', [1.5]),
])
def test_a_description_judges_as_the_node_does(ros, name, value):
    node = ros.add(Picky)
    objection = describe('/picky')['/picky'].parameters[name].objection(value)
    answer = ParameterClient(node).set_parameter(name, value)
    assert (objection is None) == answer.successful
    assert objection is None or objection.kind == answer.kind


@given(st.dictionaries(TEXT.filter(bool), VALUES, max_size=5), TEXT)
def test_any_default_and_text_comes_back(tmp_path, parameters, text):
    described = {name: DescribedParameter(Descriptor(name, values.type_of(value), text, text, True, True, None), value)
                 for name, value in parameters.items()}
    path = tmp_path / 'any.yaml'
    Descriptions([NodeDescription('/n', described)], complete=True).dump().save(path)
    again = read(path)
    assert again.complete
    assert again['/n'].parameters.keys() == parameters.keys()
    for name, each in again['/n'].parameters.items():
        assert values.same(each.default, parameters[name])
        assert each.descriptor == described[name].descriptor


# -- nonsense -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(('content', 'complaint'), [
    ('/n:\n  ros__parameters:\n    a: 1\n', 'it is no saved description, whose first line is'),
    ('a: [', 'line 1: this is not YAML'),
    ('a: 2024-13-01', 'cannot read: month must be in'),
    ('parameter_descriptions: 2\nnodes: {}', 'in version 2 of the format'),
    ('parameter_descriptions: 1\nnodes: 5', 'nodes should be a map, and is 5'),
    ('parameter_descriptions: 1\nnodes: {/n: {parameters: {a: {type: float}}}}', "a has the type 'float'"),
    ('parameter_descriptions: 1\nnodes: {/n: {parameters: {a: {type: int, range: {from: x}}}}}', 'must have numbers'),
    ('parameter_descriptions: 1\nnodes: {/n: {parameters: {a: {type: int, default_value: x}}}}', 'not a integer'),
    ('parameter_descriptions: 1\nnodes: {/n: {parameters: {a: 5}}}', '/n: a should be a map, and is 5'),
])
def test_what_is_no_description_gets_a_sentence(write, content, complaint):
    path = write(content, 'bad.yaml')
    with pytest.raises(ParameterFileError, match=r'bad\.yaml') as rejection:
        read(path)
    assert complaint in str(rejection.value)


JSON = st.recursive(
    st.one_of(st.none(), st.booleans(), st.integers(), st.floats(), st.text(max_size=5), st.just('double_array')),
    lambda inner: st.one_of(st.lists(inner, max_size=3), st.dictionaries(st.sampled_from([
        'type', 'default_value', 'range', 'from', 'nodes', '/n', 'parameters', 'parameter_descriptions', 'a']), inner,
        max_size=4)), max_leaves=12)


@given(st.one_of(JSON.map(yaml.safe_dump), JSON.map(lambda tree: yaml.safe_dump(
    {'parameter_descriptions': 1, 'nodes': {'/n': {'parameters': tree}}})), st.text(), st.binary(max_size=50)))
@example('parameter_descriptions: 1\nnodes: {/n: {parameters: {a: {type: []}}}}')
def test_any_file_is_read_or_rejected_with_a_sentence(write, content):
    path = write(content, 'any.yaml')
    try:
        found = read(path)
    except ParameterFileError as error:
        assert 'any.yaml' in str(error)
        return
    for description in found.values():
        for described in description.parameters.values():
            for value in (1, 1.5, True, 'x', [1], ['x'], [0.5]):
                described.objection(value)
