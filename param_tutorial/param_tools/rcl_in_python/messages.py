"""Messages by value: a copy is made when one is published and when one is taken, as its type says.

A copy is what C would have made of the message on its way: a text ends at its first NUL, a tuple arrives as a list, an
integer keeps as many bits as its type has. Each generated class says itself which fields it has (``SLOT_TYPES``).
"""

import array
import functools
import importlib
import operator
import struct
import sys
from collections.abc import Callable
from typing import Any

Copy = Callable[[Any], Any]

_INTEGERS = {f'{sign}int{bits}': (bits, sign == '') for sign in ('', 'u') for bits in (8, 16, 32, 64)} | {
    'char': (8, False), 'wchar': (16, False)}
# For the modules ``array`` and ``struct``.
NUMBER_CODES = {'int8': 'b', 'uint8': 'B', 'int16': 'h', 'uint16': 'H', 'int32': 'i', 'uint32': 'I', 'int64': 'q',
                'uint64': 'Q', 'float': 'f', 'double': 'd', 'char': 'B'}


class TooLongError(ValueError):
    """A sequence has more elements than its type allows."""


def copy(message: Any, message_type: Any) -> Any:
    """Return a new message of a type, with the values of another.

    :raises TypeError: a field holds something that its type does not take.
    """
    made: Any = message_type.__new__(message_type)
    made._check_fields = False
    for name, copy_value in _fields(message_type):
        setattr(made, name, copy_value(getattr(message, name)))
    return made


@functools.cache
def type_name(message_type: type) -> str:
    """Return what ROS calls a type of message or service, such as ``rcl_interfaces/msg/Log``."""
    package, kind = message_type.__module__.split('.')[:2]
    return f'{package}/{kind}/{message_type.__name__}'


@functools.cache
def dds_name(message_type: type) -> str:
    """Return what DDS calls a type of message, such as ``rcl_interfaces::msg::dds_::Log_``."""
    package, kind, name = type_name(message_type).split('/')
    return f'{package}::{kind}::dds_::{name}_'


@functools.cache
def _fields(message_type: Any) -> tuple[tuple[str, Copy], ...]:
    names = message_type.get_fields_and_field_types()
    return tuple((f'_{name}', _copy_of(slot)) for name, slot in zip(names, message_type.SLOT_TYPES))


def _copy_of(slot: Any) -> Copy:
    """Return the function that copies a value of a type, as rosidl_parser describes it."""
    kind = type(slot).__name__
    if kind == 'BasicType':
        return _copy_of_basic(slot.typename)
    if kind.endswith('String'):
        return _copy_text
    if kind == 'NamespacedType':
        # It is imported when it is needed: a service's event names the service's own module.
        path = (*slot.namespaces, slot.name)
        return lambda value: copy(value, nested_type(path))
    typename = getattr(slot.value_type, 'typename', '')
    if kind == 'Array':
        if typename in NUMBER_CODES and typename != 'char':
            return lambda value: value.copy()  # an array of numpy
        return _copy_of_sequence(_copy_of(slot.value_type), None, slot.size)
    maximum = getattr(slot, 'maximum_size', None)
    return _copy_of_sequence(_copy_of(slot.value_type), NUMBER_CODES.get(typename), maximum)


def _copy_of_sequence(copy_item: Copy, code: str | None, maximum: int | None) -> Copy:
    def copy_sequence(value: Any) -> Any:
        if maximum is not None and len(value) > maximum:
            raise TooLongError('cannot publish data')
        if code is not None:
            return array.array(code, value)
        if isinstance(value, bytes):
            value = [value[index:index + 1] for index in range(len(value))]
        return [copy_item(item) for item in value]
    return copy_sequence


@functools.cache
def nested_type(path: tuple[str, ...]) -> type:
    """Return the type of message of a field, such as that of ``('builtin_interfaces', 'msg', 'Time')``."""
    nested: type = getattr(importlib.import_module('.'.join(path[:-1])), path[-1])
    return nested


def _copy_text(value: Any) -> str:
    if not isinstance(value, str):
        raise TypeError('bad argument type for built-in operation')
    value.encode()  # raises for half of a surrogate pair
    return value.partition('\0')[0]


def _copy_of_basic(typename: str) -> Copy:
    if typename == 'boolean':
        return lambda value: value is True
    if typename == 'float':
        return lambda value: struct.unpack('f', struct.pack('f', value))[0]
    if typename in ('double', 'long double'):
        return _copy_double
    if typename == 'octet':
        return bytes
    bits, is_signed = _INTEGERS[typename]
    return functools.partial(_copy_integer, bits, is_signed)


def _copy_double(value: Any) -> float:
    """Read a number as C does: from where an object of Python's class float keeps its value. An integer keeps the count
    of its digits there, and so becomes a number that is hardly more than zero."""
    if not isinstance(value, int):
        return float(value)
    digits = -(-value.bit_length() // sys.int_info.bits_per_digit)
    tiny: float = struct.unpack('<d', struct.pack('<q', digits))[0]
    return tiny


def _copy_integer(bits: int, is_signed: bool, value: Any) -> int:
    number: int = operator.index(value)
    if bits == 64:
        if not (-2**63 <= number < 2**63 if is_signed else 0 <= number < 2**64):
            raise OverflowError(f'{number} does not fit into 64 bits')
        return number
    number &= 2**bits - 1
    return number - 2**bits if is_signed and number >> bits - 1 else number
