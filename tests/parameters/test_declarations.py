"""What a node declares when it starts, recorded, and what a declaration makes of its descriptor."""

import pytest
from rcl_interfaces.msg import ParameterDescriptor, ParameterType
from rclpy.exceptions import InvalidParameterTypeException
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tutorial.errors import ExecutorError
from param_tutorial.parameters.declarations import Declaration, record_declarations


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.declare_parameter('speed', 100)
        self.declare_parameter('name', 'Clawbot', ParameterDescriptor(description='On the plate.'))
        self.declare_parameters('gains', [('kp', 1.5), ('ki', 0.0)])
        self.declare_parameter('calibration', Parameter.Type.DOUBLE)


def test_declarations_come_in_their_order_with_default_and_value(ros):
    node, declared = record_declarations(Robot, {'speed': 150, 'name': 'a: b', 'unknown': True})
    assert declared == [
        Declaration('speed', 100, 150), Declaration('name', 'Clawbot', 'a: b'), Declaration('gains.kp', 1.5, 1.5),
        Declaration('gains.ki', 0.0, 0.0), Declaration('calibration', None, None)]
    assert ros.nodes == (node,) and type(node).__name__ == 'Robot' and isinstance(node, Robot)


def test_an_override_may_be_the_only_value(ros):
    assert record_declarations(Robot, {'calibration': 0.5})[1][-1] == Declaration('calibration', None, 0.5)


def test_an_override_of_the_wrong_type_is_the_nodes_own_error(ros):
    with pytest.raises(InvalidParameterTypeException):
        record_declarations(Robot, {'speed': 'fast'})
    assert ros.nodes == ()


def test_what_is_no_node_is_rejected(ros):
    with pytest.raises(ExecutorError, match='class derived'):
        record_declarations(dict)


# Chapter 6.1 says so of every declaration.
@pytest.mark.parametrize(('default', 'options', 'type_'), [
    (5, {}, ParameterType.PARAMETER_INTEGER),
    (Parameter.Type.DOUBLE, {}, ParameterType.PARAMETER_DOUBLE),
    ([True], {'read_only': True}, ParameterType.PARAMETER_BOOL_ARRAY),
    (5, {'dynamic_typing': True}, ParameterType.PARAMETER_INTEGER),
    (None, {'dynamic_typing': True}, ParameterType.PARAMETER_NOT_SET),
])
@pytest.mark.parametrize('together', [False, True])
def test_a_declaration_overwrites_name_and_type_in_its_descriptor(ros, default, options, type_, together):
    node = ros.add(Node, 'declares')
    descriptor = ParameterDescriptor(name='other', type=ParameterType.PARAMETER_STRING, **options)
    ros.run(lambda: node.declare_parameters('', [('new', default, descriptor)]) if together
            else node.declare_parameter('new', default, descriptor), 'declare')
    assert (descriptor.name, descriptor.type) == ('new', type_)
    assert node.describe_parameter('new') == descriptor
