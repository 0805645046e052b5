"""The exceptions that rclpy's C layer raises: same names, same bases."""

import builtins


class RCUtilsError(RuntimeError):
    """An error of ROS's C utilities."""


class RMWError(RuntimeError):
    """An error of the middleware."""


class RCLError(RuntimeError):
    """An error of ROS's client library."""


class RCLInvalidROSArgsError(RCLError):
    """The arguments after ``--ros-args`` cannot be parsed."""


class UnknownROSArgsError(RuntimeError):
    """There are arguments after ``--ros-args`` that ROS does not know."""


class NodeNameNonExistentError(RCLError):
    """There is no node of that name."""


class UnsupportedEventTypeError(RCLError):
    """There are no events of this kind."""


class NotImplementedError(builtins.NotImplementedError):
    """Part of ROS, and not of this layer."""


class InvalidHandle(RuntimeError):
    """What the handle stands for has been destroyed."""
