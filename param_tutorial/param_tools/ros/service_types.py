"""The six parameter services of every ROS 2 node, by the last part of their names."""

from rcl_interfaces.srv import (
    DescribeParameters,
    GetParameters,
    GetParameterTypes,
    ListParameters,
    SetParameters,
    SetParametersAtomically,
)

SERVICE_TYPES = {
    'describe_parameters': DescribeParameters,
    'get_parameters': GetParameters,
    'get_parameter_types': GetParameterTypes,
    'list_parameters': ListParameters,
    'set_parameters': SetParameters,
    'set_parameters_atomically': SetParametersAtomically,
}
