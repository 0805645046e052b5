"""The ten types of a ROS parameter, and the values that they hold. No ROS, no Jupyter.

One table, TYPES, says for each type its number on the wire, its names, its field in the message
rcl_interfaces/msg/ParameterValue, and which Python values fit. Everything else here reads that table.
"""

import array
import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import yaml

from param_tools.errors import InvalidValueError

INT64_MIN, INT64_MAX = -2**63, 2**63 - 1


@dataclass(frozen=True)
class ParameterType:
    """One of the ten types."""

    number: int
    """Its value in rcl_interfaces/msg/ParameterType."""
    name: str
    """Its name in rclpy's Parameter.Type, e.g. 'INTEGER_ARRAY'."""
    label: str
    """What the ``ros2`` command calls it, e.g. 'integer array'."""
    field: str | None
    """The field of a ParameterValue message that holds the value; None for NOT_SET."""
    item: type | None = None
    """The Python type of the value, or of one element of an array."""

    @cached_property
    def is_array(self) -> bool:
        """True if it holds a list of values."""
        return self.name.endswith('_ARRAY')

    def fits(self, value: Any) -> bool:
        """True if this Python value fits as the value, or as one element of an array."""
        if self.item is None or isinstance(value, bool):  # to Python, True is an integer
            return self.item is bool
        return isinstance(value, self.item) and (not isinstance(value, bytes) or len(value) == 1)

    def accepts(self, value: Any) -> bool:
        """True if this Python value can be stored without any conversion."""
        if self.is_array:
            return isinstance(value, (list, tuple, array.array)) and all(map(self.fits, value))
        return value is None if self.field is None else self.fits(value)

    def __hash__(self) -> int:
        return self.number  # that of all the fields takes longer than what is looked up with it

    def __repr__(self) -> str:
        return f'<{self.label}>'


TYPES = (
    ParameterType(0, 'NOT_SET', 'not set', None),
    ParameterType(1, 'BOOL', 'boolean', 'bool_value', bool),
    ParameterType(2, 'INTEGER', 'integer', 'integer_value', int),
    ParameterType(3, 'DOUBLE', 'double', 'double_value', float),
    ParameterType(4, 'STRING', 'string', 'string_value', str),
    ParameterType(5, 'BYTE_ARRAY', 'byte array', 'byte_array_value', bytes),
    ParameterType(6, 'BOOL_ARRAY', 'boolean array', 'bool_array_value', bool),
    ParameterType(7, 'INTEGER_ARRAY', 'integer array', 'integer_array_value', int),
    ParameterType(8, 'DOUBLE_ARRAY', 'double array', 'double_array_value', float),
    ParameterType(9, 'STRING_ARRAY', 'string array', 'string_array_value', str),
)
NOT_SET, BOOL, INTEGER, DOUBLE, STRING, BYTE_ARRAY, BOOL_ARRAY, INTEGER_ARRAY, DOUBLE_ARRAY, STRING_ARRAY = TYPES
# The order in which an untyped value is tried; rclpy's Parameter.Type.from_parameter_value has the same.
_GUESSES = (BOOL, INTEGER, DOUBLE, STRING, BYTE_ARRAY, BOOL_ARRAY, INTEGER_ARRAY, DOUBLE_ARRAY, STRING_ARRAY)
# Most values are one of these, and a dump of a large node asks for the type of each: their class tells it at once.
_SCALARS = {bool: BOOL, int: INTEGER, float: DOUBLE, str: STRING}


def is_empty_array(value: Any) -> bool:
    """True if it is a list or tuple without elements, which alone does not tell its type."""
    return isinstance(value, (list, tuple, array.array)) and len(value) == 0


def normalize(value: Any) -> Any:
    """Return the plain Python value for what numpy, array and tuple hold; anything else unchanged.

    numpy is not needed for this: whatever has ``tolist()`` (arrays and numpy's scalars) is asked for it.

    :return: bool, int, float, str, bytes, None, or a list of them.
    """
    if hasattr(value, 'tolist'):
        value = value.tolist()
    if isinstance(value, (bytes, bytearray)):
        return [bytes([byte]) for byte in value]
    if isinstance(value, (tuple, list)):
        return [item.tolist() if hasattr(item, 'tolist') else item for item in value]
    return value


def type_of(value: Any) -> ParameterType:
    """Return the type that a (normalized) Python value has as a ROS parameter.

    :raises InvalidValueError: it has none; the message says why.
    """
    if value is None:
        return NOT_SET
    parameter_type = _SCALARS.get(type(value)) or next((each for each in _GUESSES if each.accepts(value)), None)
    if parameter_type is not None:
        _check_content(value)
        return parameter_type
    if isinstance(value, list):
        kinds = sorted({type(item).__name__ for item in value})
        raise InvalidValueError(f'the elements of a parameter array must all be of one type, not {" and ".join(kinds)}'
                                if len(kinds) > 1 else
                                f'an array of {kinds[0]} cannot be a parameter: elements must be bool, int, float, '
                                f'str or single bytes')
    raise InvalidValueError(f'{value!r} is a {type(value).__name__}, which cannot be a parameter: use bool, int, '
                            f'float, str, or a list of one of them')


def describe_type(value: Any) -> str:
    """Return the type of a value with its article, such as 'an integer'."""
    label = type_of(value).label
    return f'an {label}' if label[0] in 'aeiou' else f'a {label}'


def _check_content(value: Any) -> None:
    """Raise InvalidValueError for what the type allows and the message cannot carry."""
    for item in value if isinstance(value, list) else (value,):
        if isinstance(item, int) and not INT64_MIN <= item <= INT64_MAX:
            raise InvalidValueError(f'{item} does not fit into the 64 bits of a ROS integer '
                                    f'({INT64_MIN} to {INT64_MAX})')
        if isinstance(item, str) and '\0' in item:
            raise InvalidValueError('a ROS string ends at its first NUL character, so it cannot hold one')
        if isinstance(item, str):
            try:
                item.encode()
            except UnicodeEncodeError:
                raise InvalidValueError(f'{item!r} holds half of a surrogate pair, which UTF-8 cannot carry') from None


def to_python(message: Any) -> Any:
    """Return the plain Python value of a ParameterValue message (None for NOT_SET).

    :raises InvalidValueError: the message's type number is none of the ten.
    """
    if not 0 <= message.type < len(TYPES):
        raise InvalidValueError(f'{message.type} is not the number of a parameter type (0 to 9)')
    parameter_type = TYPES[message.type]
    if parameter_type.field is None:
        return None
    value = getattr(message, parameter_type.field)
    return list(value) if parameter_type.is_array else value


def to_python_or_none(message: Any) -> Any:
    """Return the plain Python value of a ParameterValue message, None if its type number is none of the ten.

    A node that publishes nonsense must not end what follows the parameter events of all nodes.
    """
    return to_python(message) if 0 <= message.type < len(TYPES) else None


def format_value(value: Any, letters: int = 200) -> str:
    """Return a value as text for people, as Python does; of a long one the beginning, and how long it is.

    :param letters: How many of its text stand at most before the rest is cut off.
    """
    text = repr(value)
    if len(text) <= letters:
        return text
    unit = 'elements' if isinstance(value, list) else 'characters' if isinstance(value, str) else ''
    return f'{text[:letters]}…' + (f' ({len(value)} {unit})' if unit else '')


def format_change(before: Any, after: Any, letters: int = 200, *, nothing: str = 'not set') -> tuple[str, str]:
    """Return two values as text for people: of long ones that begin alike, the place where they begin to differ.

    :param nothing: What to return for None.
    """
    texts = (nothing if before is None else format_value(before, letters),
             nothing if after is None else format_value(after, letters))
    if texts[0] != texts[1] or not (isinstance(before, list | str) and type(before) is type(after)):
        return texts
    # Both are cut off, and equally long: format_value says how long they are.
    index = next((index for index, pair in enumerate(zip(before, after)) if not same(*pair)), None)
    if index is None:
        return texts
    where = f'(from index {index}, {len(before)} '
    if isinstance(before, list):
        first, second = format_change(before[index], after[index], letters)
        return f'[…, {first}, …] {where}elements)', f'[…, {second}, …] {where}elements)'
    first, second = (f'…{value[index:index + letters]!r}… {where}characters)' for value in (before, after))
    return first, second


def parse(text: str) -> Any:
    """Return the value that ``ros2 param set`` makes of a word on the command line: YAML 1.1, like ros2cli.

    Surprises included: ``off`` is False, ``1e5`` a string, ``12:30`` is 750, ``[true, 2]`` is [1, 2], and ``null`` the
    text that was typed. So is what YAML cannot read, or reads as something that is no parameter (a date, a mapping),
    where the genuine command ends in a traceback.
    """
    try:
        value = yaml.safe_load(text)
    # ValueError: YAML takes 2024-13-01 for a date and then finds that it is none.
    except (yaml.YAMLError, ValueError):
        return text
    if isinstance(value, list) and any(map(INTEGER.fits, value)) and all(isinstance(item, int) for item in value):
        value = list(map(int, value))  # [true, 1]: rclpy sees two integers, because to Python True is one
    try:
        return text if value is None or (type_of(value) is BYTE_ARRAY and value) else value
    except InvalidValueError:
        if INTEGER.fits(value):
            raise
        return text


def same(left: Any, right: Any) -> bool:
    """True if two parameter values are equal in type and value; nan is equal to nan, and 0.0 is not to -0.0."""
    if isinstance(left, list) and isinstance(right, list):
        return len(left) == len(right) and all(map(same, left, right))
    if type(left) is not type(right):
        return False
    if isinstance(left, float):
        if math.isnan(left):
            return math.isnan(right)
        return left == right and math.copysign(1, left) == math.copysign(1, right)
    return bool(left == right)


def holds(parameters: Mapping[str, Any], name: str, value: Any) -> bool:
    """True if there is a parameter of this name, and it has this value."""
    return name in parameters and same(parameters[name], value)
