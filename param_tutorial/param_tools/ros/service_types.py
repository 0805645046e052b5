"""The six parameter services of every ROS 2 node, by the last part of their names."""

from rcl_interfaces import srv

SERVICE_TYPES = {
    'describe_parameters': srv.DescribeParameters,
    'get_parameters': srv.GetParameters,
    'get_parameter_types': srv.GetParameterTypes,
    'list_parameters': srv.ListParameters,
    'set_parameters': srv.SetParameters,
    'set_parameters_atomically': srv.SetParametersAtomically,
}
