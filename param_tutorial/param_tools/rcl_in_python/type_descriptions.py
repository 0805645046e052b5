"""The service ``get_type_description`` of each node, which has nothing to tell: descriptions of types are compiled."""

from typing import Any

from param_tools.rcl_in_python.nodes import Node
from param_tools.rcl_in_python.services import Service
from param_tools.rcl_in_python.waiting import Destroyable


class TypeDescriptionService(Destroyable):
    """The service; ``impl`` is what rclpy's own Service stands on."""

    def __init__(self, node: Node):
        from type_description_interfaces.srv import GetTypeDescription

        super().__init__()
        self.impl = Service(node, GetTypeDescription, '~/get_type_description', None)

    def handle_request(self, request: Any, response_type: Any, _: Node) -> Any:
        return response_type(successful=False, failure_reason=(
            f'{request.type_name}: types are not described by rclpy in Python'))

    def _destroy(self) -> None:
        self.impl.destroy_when_not_in_use()
