"""Messages as bytes, as DDS sends them (CDR): what ``rclpy.serialization`` and raw subscriptions give.

Each value stands at a multiple of its size, counted from after the four bytes of the header; texts and sequences have
their length before them.
"""

import array
import functools
import struct
from typing import Any, NamedTuple

from param_tools.rcl_in_python import messages
from param_tools.rcl_in_python.exceptions import RMWError

_LITTLE_ENDIAN = b'\0\1\0\0'
_CODES = {**messages.NUMBER_CODES, 'boolean': '?', 'octet': 'c', 'wchar': 'I'}


class _Bytes(NamedTuple):
    """What has been written, or how far it has been read."""

    data: bytearray
    position: list[int]

    def align(self, size: int) -> None:
        self.position[0] += -self.position[0] % size

    def write(self, code: str, *values: Any) -> None:
        packed = struct.pack(f'<{len(values)}{code}', *values)
        if values:
            self.align(struct.calcsize(code))
        self.data.extend(bytes(self.position[0] - len(self.data)) + packed)
        self.position[0] = len(self.data)

    def read(self, code: str, count: int = 1) -> tuple[Any, ...]:
        if count:
            self.align(struct.calcsize(code))
        found = struct.unpack_from(f'<{count}{code}', self.data, self.position[0])
        self.position[0] += struct.calcsize(f'<{count}{code}')
        return found


class _Type:
    """A type of values that a field of a message may have, as rosidl_parser describes it."""

    def __init__(self, slot: Any):
        kind = type(slot).__name__
        self.code = _CODES.get(getattr(slot, 'typename', ''), '')
        self.is_wide = kind.endswith('WString')
        self.is_text = kind.endswith('String') and not self.is_wide
        self.nested = (*slot.namespaces, slot.name) if kind == 'NamespacedType' else None
        self.item = _Type(slot.value_type) if hasattr(slot, 'value_type') else None
        self.size: int | None = slot.size if kind == 'Array' else None

    def write(self, out: _Bytes, value: Any) -> None:
        if self.code:
            out.write(self.code, value)
        elif self.is_text:
            text = value.encode() + b'\0'
            out.write('I', len(text))
            out.write('B', *text)
        elif self.is_wide:
            units = array.array('H', value.encode('utf-16-le'))
            out.write('I', len(units), *units)
        elif self.nested:
            _write_fields(out, value, messages.nested_type(self.nested))
        elif self.item is not None:
            if self.size is None:
                out.write('I', len(value))
            if self.item.code:
                out.write(self.item.code, *value)
            else:
                for each in value:
                    self.item.write(out, each)

    def read(self, source: _Bytes) -> Any:
        if self.code:
            return source.read(self.code)[0]
        if self.is_text:
            return bytes(source.read('B', source.read('I')[0])).partition(b'\0')[0].decode()
        if self.is_wide:
            return array.array('H', source.read('I', source.read('I')[0])).tobytes().decode('utf-16-le')
        if self.nested:
            return _read_fields(source, messages.nested_type(self.nested))
        assert self.item is not None
        count = source.read('I')[0] if self.size is None else self.size
        return (list(source.read(self.item.code, count)) if self.item.code else
                [self.item.read(source) for _ in range(count)])


@functools.cache
def _types(message_type: Any) -> tuple[tuple[str, _Type], ...]:
    return tuple((name, _Type(slot)) for name, slot in zip(
        message_type.get_fields_and_field_types(), message_type.SLOT_TYPES))


def _write_fields(out: _Bytes, message: Any, message_type: Any) -> None:
    for name, field_type in _types(message_type):
        field_type.write(out, getattr(message, name))
    if not _types(message_type):
        out.write('B', 0)  # a structure has at least one member


def _read_fields(source: _Bytes, message_type: Any) -> Any:
    message = message_type()
    for name, field_type in _types(message_type):
        value, before = field_type.read(source), getattr(message, name)
        if isinstance(before, array.array):
            value = array.array(before.typecode, value)
        elif hasattr(before, 'dtype'):  # an array of numpy
            before[:] = value
            value = before
        setattr(message, name, value)
    if not _types(message_type):
        source.read('B')
    return message


def rclpy_serialize(message: Any, message_type: Any) -> bytes:
    """Return a message as bytes.

    :raises TypeError: a field holds something that its type does not take.
    """
    out = _Bytes(bytearray(), [0])
    _write_fields(out, messages.copy(message, message_type), message_type)
    return _LITTLE_ENDIAN + bytes(out.data)


def rclpy_deserialize(data: bytes, message_type: Any) -> Any:
    """Return the message that some bytes are.

    :raises RMWError: they are none of this type.
    """
    try:
        if data[:4] != _LITTLE_ENDIAN:
            raise ValueError('not in the order of bytes that this machine has')
        return _read_fields(_Bytes(bytearray(data[4:]), [0]), message_type)
    except (struct.error, ValueError) as error:
        raise RMWError(f'failed to deserialize ROS message: {error}') from None
