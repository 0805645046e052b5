"""What can be heard on a topic, tried on real messages."""

from action_msgs.msg import GoalStatusArray
from rcl_interfaces.msg import Parameter, ParameterDescriptor, ParameterEvent, ParameterValue

from param_tools.ros.topics import getter, message_class, numeric_fields


def test_the_numbers_of_a_message_are_found_wherever_they_are():
    assert list(numeric_fields(ParameterDescriptor)) == [
        'type', 'read_only', 'dynamic_typing', 'floating_point_range[].from_value', 'floating_point_range[].to_value',
        'floating_point_range[].step', 'integer_range[].from_value', 'integer_range[].to_value', 'integer_range[].step']
    assert 'status_list[].goal_info.goal_id.uuid[]' in list(numeric_fields(GoalStatusArray))
    assert not [each for each in numeric_fields(Parameter) if 'string' in each or each == 'name']


def test_a_number_is_taken_out_of_a_message():
    event = ParameterEvent(changed_parameters=[Parameter(), Parameter(value=ParameterValue(
        double_array_value=[0.5, 1.5], byte_array_value=[b'\x07']))])
    assert getter('changed_parameters[1].value.double_array_value[1]')(event) == 1.5
    assert getter('changed_parameters[1].value.byte_array_value[0]')(event) == b'\x07'
    assert getter('stamp.sec')(event) == 0


def test_a_type_that_is_not_installed_is_none():
    assert message_class('rcl_interfaces/msg/Parameter') is Parameter
    assert message_class('rcl_interfaces/msg/Nothing') is None
    assert message_class('no_such_package/msg/Parameter') is None
