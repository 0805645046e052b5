"""Parameters that a node has although neither its program nor its schema names them. No ROS, no Jupyter."""

from collections.abc import Mapping
from typing import Any

from param_tools import values
from param_tools.descriptor import Descriptor
from param_tools.files.descriptions import DescribedParameter, NodeDescription
from param_tools.values import ParameterType


def _described(name: str, parameter_type: ParameterType, default: Any, *, read_only: bool = False) -> tuple[
        str, DescribedParameter]:
    return name, DescribedParameter(Descriptor(name, parameter_type, read_only=read_only), default)


OF_EVERY_NODE = dict((
    _described('use_sim_time', values.BOOL, False),
    _described('start_type_description_service', values.BOOL, True, read_only=True)))
"""What rclpy and rclcpp declare in every node; they also declare some that begin with ``qos_overrides.``."""

_OF_CONTROLLERS = dict((
    # controller_interface::ControllerInterfaceBase::init declares these.
    _described('update_rate', values.INTEGER, None), _described('is_async', values.BOOL, False),
    _described('thread_priority', values.INTEGER, -100),
    # The spawner of controller_manager reads these from the controller's block; nobody declares them.
    _described('type', values.STRING, None), _described('fallback_controllers', values.STRING_ARRAY, None)))
# AsyncFunctionHandlerParams of realtime_tools declares these for a controller.
_ASYNC = 'async_parameters.'


def find(name: str, description: NodeDescription, given: Mapping[str, Any], types: Mapping[str, Any]
         ) -> DescribedParameter | None:
    """Return what is known of a parameter that a description does not name; None if a node has none of that name.

    :param given: The values that files give to the node.
    :param types: The values of all parameters in the files that are called ``NAME.type``, by these names.
    """
    if name in OF_EVERY_NODE:
        return OF_EVERY_NODE[name]
    if (name in _OF_CONTROLLERS or name.startswith(_ASYNC)) and _is_controller(description, given, types):
        return _OF_CONTROLLERS.get(name) or _described(name, values.NOT_SET, None)[1]
    return None


def _is_controller(description: NodeDescription, given: Mapping[str, Any], types: Mapping[str, Any]) -> bool:
    """True if a node is a controller of ros2_control: what files say of it is a class of a plugin, or its schema is
    called like one. A description of a running node, in which all that it declares stands, has what they all have."""
    if not description.schema:
        return {'update_rate', 'is_async'} <= description.parameters.keys()
    name = description.node.rpartition('/')[2]
    plugin = given.get('type', types.get(f'{name}.type'))
    return (isinstance(plugin, str) and '/' in plugin) or any(
        word.endswith(('controller', 'broadcaster')) for word in (name, *description.schema.split()))
