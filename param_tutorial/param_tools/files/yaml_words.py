"""How YAML reads a word that has no quotes: as version 1.1 has it, and as version 1.2. No ROS, no Jupyter.

rcl reads neither. PyYAML, and with it ``ros2 param load``, reads 1.1 with some differences of its own; newer programs,
and people, read 1.2.
"""

import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import yaml

from param_tools import values

_KINDS = {bool: 'the boolean', int: 'the integer', float: 'the double', str: 'the text'}


@dataclass(frozen=True)
class Reading:
    """What a word is taken for."""

    value: Any
    """None for null, and for what is no value at all; a date is none of a parameter either."""
    words: str
    """The same, for people."""

    def is_same(self, value: Any) -> bool:
        """True if a parameter's value is the same, also in its type; for null, none is."""
        return self.value is not None and values.same(self.value, value)


def read_1_1(text: str, tag: str | None = None) -> Reading:
    """Return what PyYAML makes of a word, or of a text with a tag such as ``!!float``, written out."""
    loader = yaml.SafeLoader('')
    try:
        tag = tag or loader.resolve(yaml.ScalarNode, text, (True, False))
        value = loader.construct_object(yaml.ScalarNode(tag, text))
    # ValueError: it looks like a date and is none, or is an integer of thousands of digits.
    except (yaml.YAMLError, ValueError, OverflowError):
        return Reading(None, 'something that cannot be read')
    finally:
        loader.dispose()
    if value is None or type(value) in _KINDS:
        return Reading(value, _words(value))
    return Reading(None, f'a {type(value).__name__}')


# The core schema of YAML 1.2.2, chapter 10.3.
_CORE_SCHEMA: tuple[tuple[str, Callable[[str], Any]], ...] = (
    (r'|~|null|Null|NULL', lambda _: None),
    (r'true|True|TRUE|false|False|FALSE', lambda text: text[0] in 'tT'),
    (r'[-+]?[0-9]+', int),
    (r'0o[0-7]+', lambda text: int(text, 8)),
    (r'0x[0-9a-fA-F]+', lambda text: int(text, 16)),
    (r'[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?', float),
    (r'[-+]?\.(inf|Inf|INF)|\.(nan|NaN|NAN)', lambda text: float(text.replace('.', ''))),
)
_LONGEST = 4000  # Python reads no longer integers


def read_1_2(text: str) -> Reading:
    """Return what YAML 1.2 makes of a word."""
    convert = next((each for pattern, each in _CORE_SCHEMA if re.fullmatch(pattern, text)), str)
    value = text if len(text) > _LONGEST else convert(text)
    return Reading(value, _words(value))


def _words(value: Any) -> str:
    return 'null' if value is None else f'{_KINDS[type(value)]} {values.format_value(value, 60)}'
