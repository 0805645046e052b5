"""What a declaration makes of its descriptor."""

import pytest
from rcl_interfaces.msg import ParameterDescriptor, ParameterType
from rclpy.node import Node
from rclpy.parameter import Parameter


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
