"""What a node declares when it starts, recorded, and what a declaration makes of its descriptor."""

import pytest
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor, ParameterType
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools import check_declarations
from param_tools.errors import DeclarationError
from param_tools.node.declarations import Declaration, record_declarations
from param_tutorial import ParameterClient


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.declare_parameter('speed', 100)
        self.declare_parameter('name', 'Clawbot', ParameterDescriptor(description='On the plate.'))
        self.declare_parameters('gains', [('kp', 1.5), ('ki', 0.0)])
        self.declare_parameter('calibration', Parameter.Type.DOUBLE)


def test_declarations_come_in_their_order_with_default_and_value(ros):
    _, declared = record_declarations(Robot, {'speed': 150, 'name': 'a: b', 'unknown': True})
    assert declared == [
        Declaration('speed', 100, 150), Declaration('name', 'Clawbot', 'a: b'), Declaration('gains.kp', 1.5, 1.5),
        Declaration('gains.ki', 0.0, 0.0), Declaration('calibration', None, None)]
    assert record_declarations(Robot, {'calibration': 0.5})[1][-1] == Declaration('calibration', None, 0.5)
    node, = ros.nodes
    assert type(node).__name__ == 'Robot' and isinstance(node, Robot)


INTEGERS, DOUBLES = [IntegerRange(from_value=0, to_value=5)], [FloatingPointRange(from_value=0.0, to_value=5.0)]
LEAVE_TYPE_OUT = 'Leave `type` out: the value decides'


@pytest.mark.parametrize(('default', 'fields', 'words', 'accepted_nevertheless'), [
    (10, {'type': ParameterType.PARAMETER_STRING},
     f'its descriptor says type string, and it is declared as integer. {LEAVE_TYPE_OUT}', 99),
    (Parameter.Type.INTEGER, {'type': ParameterType.PARAMETER_DOUBLE},
     f'its descriptor says type double, and it is declared as integer. {LEAVE_TYPE_OUT}', 99),
    (10, {'name': 'other'}, 'its descriptor says name other. Leave `name` out', 99),
    (1.0, {'integer_range': INTEGERS}, 'it has an integer_range and is declared as double, so it has no limits. '
     'Give it the range of its own type', 99.0),
    (1, {'floating_point_range': DOUBLES}, 'it has a floating_point_range and is declared as integer, so it has no '
     'limits. Give it the range of its own type', 99),
    ([1, 2], {'integer_range': INTEGERS}, 'it has an integer_range and is declared as integer array, so it has no '
     'limits. Judge the elements in an on-set callback', [99]),
    (1.0, {'floating_point_range': [FloatingPointRange(from_value=0, to_value=5.0)]}, "its descriptor holds what its "
     "message has no room for: The 'from_value' field must be of type 'float', and it is `0`", 5.0),
    ('x', {'integer_range': INTEGERS}, 'it has an integer_range and is declared as string, so it has no limits. '
     'Leave it out', 'anything')])
def test_what_a_descriptor_says_in_vain_is_an_error(ros, default, fields, words, accepted_nevertheless):
    class Contradicts(Node):
        def __init__(self):
            super().__init__('contradicts')
            self.declare_parameter('x', default, ParameterDescriptor(**fields))

    with pytest.raises(DeclarationError) as raised:
        check_declarations(Contradicts)
    assert str(raised.value) == f'Contradicts declares what rclpy ignores:\nx: {words}'
    assert ros.nodes == ()
    assert ParameterClient(ros.add(Contradicts)).set_parameter('x', accepted_nevertheless).successful


def test_what_contradicts_nothing_is_no_error(ros):
    class Sound(Robot):
        def __init__(self):
            super().__init__()
            self.declare_parameter('a', 1, ParameterDescriptor(
                name='a', type=ParameterType.PARAMETER_INTEGER, integer_range=INTEGERS))
            self.declare_parameter('b', 1.0, ParameterDescriptor(floating_point_range=DOUBLES))
            self.declare_parameter('c', 'any', ParameterDescriptor(dynamic_typing=True, integer_range=INTEGERS))

    check_declarations(Sound)
    assert ros.nodes == ()


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
