"""The unit of a parameter, read from its description, its constraints or its name. In doubt it has none."""

import re

from param_tools import values
from param_tools.descriptor import Descriptor

_NUMBERS = (values.INTEGER, values.DOUBLE, values.INTEGER_ARRAY, values.DOUBLE_ARRAY)

# The units in a text, and how each is shown. A capital letter alone isn't one: it is too often the name of a thing.
_SYMBOLS = {each: each for each in (
    'm', 'mm', 'cm', 'km', 'm/s', 'mm/s', 'cm/s', 'km/h', 'm/s²', 'rad', 'rad/s', 'rad/s²', 'deg', 'deg/s', 's', 'ms',
    'Hz', 'kHz', 'rpm', '°C', 'mV', 'mA', 'Nm', 'N/m', 'kg', 'Pa', '%', '1/s', '1/m',
    'N m/rad', 'N m s/rad', 'N m s²/rad', 'kg m²')} | {
    'm/s^2': 'm/s²', 'm/s2': 'm/s²', 'm/s/s': 'm/s²', 'rad/s^2': 'rad/s²', 'rad/s2': 'rad/s²', 'N*m': 'Nm', 'N m': 'Nm',
    'RPM': 'rpm', 'sec': 's', 'hz': 'Hz', '°': 'deg', 'µs': 'µs', 'us': 'µs'}
_WORDS = {
    'meters': 'm', 'metres': 'm', 'centimeters': 'cm', 'millimeters': 'mm', 'meters per second': 'm/s',
    'metres per second': 'm/s', 'radians': 'rad', 'radians per second': 'rad/s', 'degrees': 'deg',
    'degrees per second': 'deg/s', 'degrees celsius': '°C', 'seconds': 's', 'milliseconds': 'ms', 'hertz': 'Hz',
    'revolutions per minute': 'rpm', 'volts': 'V', 'amperes': 'A', 'watts': 'W', 'newtons': 'N', 'kilograms': 'kg',
    'percent': '%'}
# The units at the end of a name. `_c`, `_m` and `_ms` alone may mean many things.
_ENDINGS = {
    '_mps': 'm/s', '_mps2': 'm/s²', '_meters': 'm', '_rpm': 'rpm', '_hz': 'Hz', '_sec': 's', '_secs': 's',
    '_seconds': 's', '_rad': 'rad', '_radps': 'rad/s', '_deg': 'deg', '_kg': 'kg', '_percent': '%',
    'temperature_c': '°C', 'temp_c': '°C'}


def _any_of(words: dict[str, str]) -> str:
    return '|'.join(map(re.escape, sorted(words, key=len, reverse=True)))


# A symbol counts in brackets after a blank ("joint(s)" has no unit), or after "in" at the end of a part of a sentence
# ("in m steps" has none).
_IN_BRACKETS = re.compile(rf'(?<!\S)[\[(]\s*(?:in )?({_any_of(_SYMBOLS | _WORDS)})\s*[\])]')
_AFTER_IN = re.compile(rf'\bin ({_any_of(_SYMBOLS | _WORDS)})(?=[.,;:)]?(?:\s*$|[.,;:)]\s))')
_WORD_AFTER_IN = re.compile(rf'\bin ({_any_of(_WORDS)})\b(?! per\b|/)', re.IGNORECASE)


def unit_of(descriptor: Descriptor) -> str:
    """Return the unit of a number or of an array of numbers, e.g. ``'m/s'``; empty if it is not certain.

    The texts of the descriptor come before the end of the name. If they name two different units, there is none.
    """
    if descriptor.type not in _NUMBERS:
        return ''
    text = f'{descriptor.description}\n{descriptor.additional_constraints}'
    known = _SYMBOLS | _WORDS
    found = {known[match[1]] for pattern in (_IN_BRACKETS, _AFTER_IN)
             for line in text.splitlines() for match in pattern.finditer(line)}
    found |= {_WORDS[match[1].lower()] for match in _WORD_AFTER_IN.finditer(text)}
    if found:
        return found.pop() if len(found) == 1 else ''
    ends = {unit for ending, unit in _ENDINGS.items() if descriptor.name.lower().endswith(ending)}
    return ends.pop() if len(ends) == 1 else ''
