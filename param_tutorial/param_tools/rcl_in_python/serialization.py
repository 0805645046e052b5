"""Messages as bytes: what ``rclpy.serialization`` and raw subscriptions give.

DDS sends CDR. No bytes leave this process, so they are Python's own.
"""

import pickle
from typing import Any

from param_tools.rcl_in_python import messages
from param_tools.rcl_in_python.exceptions import RMWError


def rclpy_serialize(message: Any, message_type: Any) -> bytes:
    """Return a message as bytes.

    :raises TypeError: a field holds something that its type does not take.
    """
    return pickle.dumps(messages.copy(message, message_type))


def rclpy_deserialize(data: bytes, message_type: Any) -> Any:
    """Return the message that some bytes are.

    :raises RMWError: they are none of this type.
    """
    try:
        return messages.copy(pickle.loads(data), message_type)
    except (pickle.UnpicklingError, AttributeError, EOFError) as error:
        raise RMWError(f'failed to deserialize ROS message: {error}') from None
