"""What hands type into the control of a parameter: what the node is asked for."""

import itertools
import math
from collections.abc import Iterable, Iterator
from typing import Any

from param_tutorial.lessons.recording.recorded import Row
from param_tutorial.parameters import values
from param_tutorial.parameters.client import Descriptor
from param_tutorial.parameters.text import format_value
from param_tutorial.widgets.recordable import Scale

_SAMPLES = 5

# A few of everything, and what no parameter of the type can be.
_TYPED = {
    values.INTEGER: [*map(str, range(-20, 201)), *map(str, range(-100, 401, 10)), '500', '600', '900', '999', '1000',
                     '2000', '5000', '10000', '', 'fast', '1.5', '0x10', '99999999999999999999'],
    values.DOUBLE: [*(f'{each / 20:.2f}'.removesuffix('0') for each in range(-20, 61)),
                    *(f'{each / 2:.1f}' for each in range(-20, 41)), *map(str, range(-10, 101)),
                    '-20.0', '-100.0', '1000.0', 'nan', 'inf', '-inf', '1e3', '1,5', '', 'fast'],
    values.STRING: ['', ' ', 'Clawbot', 'clawbot', 'Rex', 'Max', 'Robot', 'R2D2', 'test', 'hello', 'fast', 'slow',
                    'off', 'on', 'true', '0', '1', '42'],
    values.BOOL: ['true', 'false', '1', '0', 'yes', ''],
    values.BYTE_ARRAY: ['[]', '[0x00]', '[0x00, 0xff]', '[0x100]', 'x', ''],
    values.BOOL_ARRAY: ['[]', '[true]', '[false]', '[true, false]', '[true, true]', '[false, false]', '[1]', 'x', ''],
    values.INTEGER_ARRAY: ['[]', '[0]', '[1]', '[1, 2]', '[1, 2, 3]', '[1, 2, 3, 4]', '[-1]', '[1.5]', '[a]',
                           '1, 2', ''],
    values.DOUBLE_ARRAY: ['[]', '[0.0]', '[1.0]', '[0.5, 1.0]', '[1, 2]', '[1.0, 2.0, 3.0]', '[-1.0]', '[a]', ''],
    values.STRING_ARRAY: ['[]', '[left]', '[left, right]', '[left, right, middle]', '[""]', '[1, 2]', ''],
    values.NOT_SET: ['', '1', '1.5', 'true', 'text', '[1, 2]', '[a, b]'],
}


def texts_to_try(row: Row, descriptor: Descriptor, value: Any, literals: Iterable[Any]) -> list[str]:
    """Return what a node is asked for, as hands type it.

    :param value: The value that the parameter has.
    :param literals: Values that the lesson speaks of; those of a fitting type are tried too.
    """
    if row['editor'] == 'check':
        return ['true', 'false']
    # Where any type goes, those of all types may be tried; the range's ends, and what lies just beyond them.
    texts = [row['text'], *row.get('positions', ()), *row['row']['choices'], *_near_the_ends(descriptor),
             *_TYPED[values.NOT_SET if descriptor.dynamic_typing else descriptor.type]]
    texts += [text for literal in literals if (text := _as_typed(descriptor, literal)) is not None]
    if isinstance(value, list) and value:
        texts += [format_value(descriptor, each) for each in (value[:-1], [*value, value[-1]], value[::-1])]
    return list(dict.fromkeys(texts))


def positions(scale: Scale, value: Any, at_most: int) -> list[Any]:
    """Return the values at which a page's slider can stand: all of its scale, or a spread of them."""
    # Whole strides, so that the values stay round; the end and the value shown are always among them.
    stride = max(1, math.ceil(scale.last / (at_most - 1)))
    stride = next(each for each in _round_numbers() if each >= stride)
    return sorted({scale.value(position) for position in [*range(0, scale.last + 1, stride), scale.last]} | {value})


def choices(row: Row) -> list[str]:
    """Return the texts that the mouse can choose: of a check box, or of a slider."""
    return ['true', 'false'] if row['editor'] == 'check' else row.get('positions') or list(row['row']['choices'])


def accepted(row: Row) -> list[str]:
    """Return the texts that the node accepted and that change something."""
    return [text for text, answer in row['answers'].items() if answer.get('value', row['text']) != row['text']]


def spread(texts: list[str], count: int) -> list[str]:
    """Return so many of the texts, evenly spread, with both ends; all if they are not more."""
    if len(texts) <= count:
        return list(texts)
    return [texts[round(index * (len(texts) - 1) / (count - 1))] for index in range(count)]


def samples(row: Row) -> list[str]:
    """Return texts with all kinds of answers."""
    rejected: dict[str, str] = {}
    for text, answer in row['answers'].items():
        if reason := answer.get('reason'):
            # One for each wording: reasons that differ in numbers are alike.
            rejected.setdefault(''.join(each for each in reason if each.isalpha() or each == ' '), text)
    return [row['text'], *spread(accepted(row), _SAMPLES), *spread(list(rejected.values()), _SAMPLES)]


def _round_numbers() -> Iterator[int]:
    for power in itertools.count():
        yield from (10**power, 2 * 10**power, 5 * 10**power)


def _near_the_ends(descriptor: Descriptor) -> list[str]:
    limits = descriptor.range
    if limits is None:
        return []
    step = limits.step or (1 if descriptor.type is values.INTEGER else 0.01)
    near = [end + sign * distance for end in (limits.from_value, limits.to_value) for sign in (-1, 1)
            for distance in (0, step, step / 2)]
    if descriptor.type is values.INTEGER:
        near = [math.floor(each) for each in near]
    else:
        near = [round(float(each), 9) for each in near]
    return [format_value(descriptor, each) for each in near]


def _as_typed(descriptor: Descriptor, literal: Any) -> str | None:
    """Write a value of the lesson's as a hand would, if the parameter could have it."""
    if descriptor.type is values.DOUBLE and type(literal) is int:
        literal = float(literal)
    try:
        normal = values.normalize(literal)
        if values.type_of(normal) is not descriptor.type and not descriptor.dynamic_typing:
            return None
        return format_value(descriptor, normal)
    except Exception:  # whatever it is that the lesson speaks of, it is no value
        return None
