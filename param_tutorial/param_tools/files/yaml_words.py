"""How YAML reads a word that has no quotes: as version 1.1 has it, and as version 1.2. No ROS, no Jupyter.

rcl reads neither. PyYAML, and with it ``ros2 param load``, reads 1.1 with some differences of its own; newer programs,
and people, read 1.2.
"""

import math
import re
from dataclasses import dataclass
from typing import Any

import yaml

from param_tools import values


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
    if type(value) in (bool, int, float, str):
        return Reading(value, _words(value))
    return Reading(None, 'null' if value is None else f'a {type(value).__name__}')


# The core schema of YAML 1.2.2, chapter 10.3.
_INTEGER = re.compile(r'[-+]?[0-9]+')
_OCTAL = re.compile(r'0o([0-7]+)')
_HEXADECIMAL = re.compile(r'0x([0-9a-fA-F]+)')
_REAL = re.compile(r'[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?')
_INFINITE = re.compile(r'([-+]?)(\.inf|\.Inf|\.INF)')
_LONGEST = 4000  # Python reads no longer integers


def read_1_2(text: str) -> Reading:
    """Return what YAML 1.2 makes of a word."""
    if text in ('', '~', 'null', 'Null', 'NULL'):
        return Reading(None, 'null')
    value: Any = text
    if text in ('true', 'True', 'TRUE', 'false', 'False', 'FALSE'):
        value = text[0] in 'tT'
    elif len(text) > _LONGEST:
        pass
    elif _INTEGER.fullmatch(text):
        value = int(text)
    elif match := _OCTAL.fullmatch(text):
        value = int(match[1], 8)
    elif match := _HEXADECIMAL.fullmatch(text):
        value = int(match[1], 16)
    elif _REAL.fullmatch(text):
        value = float(text)
    elif match := _INFINITE.fullmatch(text):
        value = float(f'{match[1]}inf')
    elif text in ('.nan', '.NaN', '.NAN'):
        value = math.nan
    return Reading(value, _words(value))


def _words(value: Any) -> str:
    kind = {bool: 'the boolean', int: 'the integer', float: 'the double', str: 'the text'}[type(value)]
    return f'{kind} {values.format_value(value, 60)}'
