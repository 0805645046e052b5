"""What a descriptor holds that its message has no room for."""

from textwrap import shorten
from typing import Any


def describe_wrong_field(message: Any) -> str:
    """Return which field of a message, or of a message in it, has a value of the wrong type; empty if none has.

    rclpy checks the fields of a message only if it is made with ``check_fields=True``. Without the check, an integer in
    place of a double is sent as another number, which depends on the version of Python, and most other wrong values
    are not sent at all.
    """
    for name in message.get_fields_and_field_types():
        value = getattr(message, name)
        for each in value if isinstance(value, (list, tuple)) else ():
            if hasattr(each, 'get_fields_and_field_types') and (found := describe_wrong_field(each)):
                return found
        try:
            type(message)(**{name: value}, check_fields=True)
        except AssertionError as error:
            return f'{error}, and it is `{shorten(repr(value), 100)}`'
    return ''
