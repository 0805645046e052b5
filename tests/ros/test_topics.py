"""What can be heard on a topic."""

from rcl_interfaces.msg import Parameter

from param_tools.ros.topics import message_class


def test_a_type_that_is_not_installed_is_none():
    assert message_class('rcl_interfaces/msg/Parameter') is Parameter
    assert message_class('rcl_interfaces/msg/Nothing') is None
    assert message_class('no_such_package/msg/Parameter') is None
