"""What hands type into the control of a parameter: what the node is asked for."""

import contextlib
import itertools
import math
import re
from collections.abc import Iterable, Iterator
from decimal import Decimal
from typing import Any

from param_tools import values
from param_tools.descriptor import Descriptor
from param_tools.node.text import format_value, parse_value
from param_tools.panel.editors import Scale
from param_tutorial.site.recording.recorded import Row

_SAMPLES = 5
# A value in the lowest part of its range is taken for a gain.
_GAIN = 0.1
# Whole numbers without a range are tried up to here, in combination.
_NATURAL = 100
_FEW = 41

# What a class of thirty writes into a box, whatever it is for.
_WORDS = ['', ' ', 'hello', 'Hello', 'hi', 'hello world', 'Hello World', 'test', 'Test', 'fast', 'slow', 'on', 'off',
          'true', 'false', 'True', 'yes', 'no', 'abc', 'a', 'x', 'none', 'None', 'null', 'nothing', 'ten', 'five',
          'one', 'max', 'min', 'robot', 'stop', 'go', 'high', 'low', '5 rpm', '10 m', 'wide', 'narrow', 'open',
          'closed', 'big', 'small', 'much', 'heavy', 'warm', 'cold', 'hot', 'zero', 'full', 'empty', 'quick', 'now',
          'constructor', '-', '?']
_NAMES = ['Clawbot', 'clawbot', 'Rex', 'rex', 'REX', ' Rex', 'Rex ', ' Rex ', 'Max', 'Robot', 'Robbie', 'Robby', 'Bob',
          'Bobby', 'Alice', 'Anna', 'Ben', 'Charlie', 'Dave', 'Emma', 'Eva', 'Fred', 'Leo', 'Lea', 'Lisa', 'Luna',
          'Mia', 'Noah', 'Oscar', 'Paul', 'Sam', 'Tom', 'Tim', 'Zoe', 'John', 'Jane', 'Peter', 'Anton', 'Bella',
          'Buddy', 'Otto', 'Robo', 'Bot', 'Turbo', 'Flash', 'Speedy', 'Rover', 'Spot']

# A few of everything, and what no parameter of the type can be.
_TYPED = {
    values.INTEGER: [*map(str, range(-20, 201)), *map(str, range(-100, 401, 10)), '500', '600', '900', '999', '1000',
                     '-200', '-500', '-1000', '1500', '2000', '3000', '5000', '9999', '10000', '50000', '100000',
                     '1000000', '-0', '007', '+5', ' 5', '1.5', '0.5', '.5', '2.5', '12.5', '99.5', '100.0', '-1.5',
                     '1,5', '1e3', '0x10', '99999999999999999999', '2147483648', *_WORDS],
    values.DOUBLE: [*(f'{each / 20:.2f}'.removesuffix('0') for each in range(-20, 61)),
                    *(f'{each / 2:.1f}' for each in range(-20, 41)), *map(str, range(-10, 101)),
                    *(f'{each / 100:.2f}' for each in range(0, 101)), *(str(each) for each in range(100, 1001, 50)),
                    *(f'{each / 1000:.3f}' for each in range(1, 11)),
                    *(f'{each:.1f}' for each in range(20, 101, 5)),
                    '.5', '.1', '.25', '.2', '1.', '5.', '-.5', '-20.0', '-100.0', '-100', '200.0', '300.0',
                    '400.0', '500.0', '800.0', '900.0', '999.0', '999', '1000.0', '2000', '10000', '+1.0', 'nan',
                    '.nan', 'inf',
                    '.inf', '-inf', '-.inf', '1e3', '1e-3', '1e9', '1,5', '0,5', *_WORDS],
    values.STRING: [*_NAMES, *_WORDS, 'R2D2', 'R2-D2', 'C3PO', 'Wall-E', 'WALL-E', 'walle', 'Bender', 'Marvin', 'HAL',
                    'HAL 9000', 'Rex 2', 'My Robot', 'my robot', 'my_robot', 'MyRobot', 'robot_1', 'robot1', 'Robot 1',
                    'a robot', 'the robot', '0', '1', '2', '42', '-1', '123', '007', '1.5', '3.14', 'é', 'Zoë',
                    'ロボット', '🤖', '!', '?', '.', '-', '_', "'", '"', "''", '""', '\\', '/', '<b>', 'abc',
                    'ABC', 'abcd', 'xyz', 'asdf', 'qwerty', 'foo', 'bar', 'Clawbot2',
                    'Clawbot 2', 'CLAWBOT', 'SN-CLAW-002', 'AB1234',
                    'XY9999', 'ZZ0000', 'AB12', 'AB12345', 'ab1234', 'A1234', 'ABC123', '1234AB', '1234', 'AB1234x',
                    'AB-1234', 'a' * 30, 'a' * 100],
    values.BOOL: ['true', 'false', 'True', 'False', '1', '0', 'yes', 'no', ''],
    values.BYTE_ARRAY: ['[]', '[0x00]', '[0x00, 0xff]', '[0x100]', 'x', ''],
    values.BOOL_ARRAY: ['[]', '[true]', '[false]', '[true, false]', '[true, true]', '[false, false]', '[1]', 'x', ''],
    values.INTEGER_ARRAY: ['[]', '[0]', '[1]', '[1, 2]', '[1, 2, 3]', '[1, 2, 3, 4]', '[-1]', '[1.5]', '[a]',
                           '1, 2', ''],
    values.DOUBLE_ARRAY: ['[]', '[0.0]', '[1.0]', '[0.5, 1.0]', '[1, 2]', '[1.0, 2.0, 3.0]', '[-1.0]', '[a]', ''],
    values.STRING_ARRAY: ['[]', '[left]', '[left, right]', '[left, right, middle]', '[""]', '[1, 2]', ''],
    values.NOT_SET: [*_WORDS, *_NAMES, '0', '1', '2', '3', '5', '7', '10', '12', '42', '50', '99', '100', '1000', '-1',
                     '-5', '0.0', '0.5', '.5', '1.0', '1.5', '2.5', '3.14', '12.5', '-1.5', '1e3', 'true', 'false',
                     'True', 'False', 'yes', 'no', 'null', '~', 'text', 'a', 'b', 'a b', 'a: b', '{}', '[]', '[1, 2]',
                     '[1, 2, 3]', '[1.0, 2.0]', '[1, 2.5]', '[1, a]', '[a, b]', '[left, right]', '[true, false]',
                     '"5"', "'5'", 'new', 'old fingers', 'new finger', 'new fingers!', 'my note', 'a note', 'broken',
                     'repaired', 'OK', 'todo', 'left', 'right'],
}


def texts_to_try(row: Row, descriptor: Descriptor, value: Any, literals: Iterable[Any]) -> list[str]:
    """Return what a node is asked for, as hands type it.

    :param value: The value that the parameter has.
    :param literals: Values that the lesson speaks of; those of a fitting type are tried too.
    """
    if row['editor'] == 'check':
        return ['true', 'false']
    # Where any type goes, those of all types may be tried; the range's ends, and what lies just beyond them.
    texts = [row['text'], *row.get('positions', ()), *row['own'], *row['row']['choices'], *_near_the_ends(descriptor),
             *_TYPED[values.NOT_SET if descriptor.dynamic_typing else descriptor.type]]
    texts += [text for literal in literals if (text := _as_typed(descriptor, literal)) is not None]
    if isinstance(value, list) and value:
        texts += [format_value(descriptor, each) for each in (value[:-1], [*value, value[-1]], value[::-1])]
    return list(dict.fromkeys(texts))


def stops(scale: Scale, value: Any, own: Iterable[Any], at_most: int) -> list[Any]:
    """Return the values at which a page's slider can stand: all of its scale, or round ones among them.

    Where the value stands near the lower end of its range, as a gain does, small values lie closer together.

    :param value: What the parameter has; it and the ends are among them.
    :param own: Values that the lesson sets the parameter to; those on the scale are among them.
    :param at_most: So many, beside those that have to be.
    """
    if scale.last < at_most:
        return [scale.value(position) for position in range(scale.last + 1)]
    low, high = scale.value(0), scale.value(scale.last)
    is_gain = 0 <= low <= value <= _GAIN * high
    levels = (_preferred if is_gain else _multiples)(low, high)
    numbers = next(each for each in levels if len(each) <= at_most)
    # After steps of 2, those of 5 too: a hand tries 25 rather than 24.
    on_scale = {number for number in (*numbers, *next(levels, ()), *own)
                if scale.value(scale.nearest(number)) == number}
    return sorted(on_scale | {low, high, value})


def _multiples(low: float, high: float) -> Iterator[list[float]]:
    """Yield the multiples of round numbers between two numbers, fewer each time."""
    begin = math.floor(math.log10(high - low)) - 3
    for power in itertools.count(begin):
        for digit in (1, 2, 5):
            step = Decimal(digit).scaleb(power)
            first, last = math.ceil(Decimal(str(low)) / step), math.floor(Decimal(str(high)) / step)
            yield [_plain(step * number, low) for number in range(first, last + 1)]


def _preferred(low: float, high: float) -> Iterator[list[float]]:
    """Yield numbers of one or two digits from a twentieth of the upper end on, fewer each time."""
    for digits in (('1', '1.5', '2', '2.5', '3', '4', '5', '6', '8'), ('1', '1.5', '2', '3', '4', '5', '8'),
                   ('1', '2', '3', '5'), ('1', '3'), ()):
        numbers = [Decimal(digit).scaleb(power) for power in range(-9, 10) for digit in digits]
        yield [_plain(number, low) for number in numbers if max(low, high / 20) <= number <= high]


def _plain(number: Decimal, like: float) -> float:
    return int(number) if isinstance(like, int) else float(number)


def set_to(name: str, source: str) -> list[int | float]:
    """Return the numbers to which a lesson's code sets a parameter, by its name or the last part of it."""
    last = re.escape(name.rpartition('.')[2])
    between = r'[\'"\])]*(?:\.value)?(?:\s*(?:[=:,]|:=)\s*|\s+)'
    found = re.findall(rf'(?<!\w){last}{between}(-?\d+(?:\.\d+)?)(?![\w.])', source)
    return list(dict.fromkeys(float(each) if '.' in each else int(each) for each in found))


def is_value(descriptor: Descriptor, text: str) -> bool:
    """True if a text is how a control writes a value of the parameter."""
    try:
        return format_value(descriptor, parse_value(descriptor, text)) == text
    except ValueError:
        return False


def choices(row: Row) -> list[str]:
    """Return the texts that the mouse can choose: of a check box, or of a slider."""
    return ['true', 'false'] if row['editor'] == 'check' else row.get('positions') or list(row['row']['choices'])


def natural(row: Row) -> list[str]:
    """Return the texts that hands type first, and some of each kind that the node rejects."""
    whole = [text for text in row['answers'] if re.fullmatch(r'-?\d+', text)
             and (abs(int(text)) <= 10 or int(text) % 5 == 0) and abs(int(text)) <= _NATURAL]
    return list(dict.fromkeys([row['text'], *(row.get('positions') or whole or spread(list(row['answers']), _FEW)),
                               *row['own'], *samples(row)]))


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


def readings(descriptor: Descriptor, texts: Iterable[str]) -> dict[str, str]:
    """Return what texts are read as, where the control would write that in another way: '.5' and '0.50' are 0.5.

    :param texts: For other ways to write them, too.
    """
    found = {}
    for text in texts:
        others = [text]
        if re.fullmatch(r'-?\d+\.\d+', text):
            others += [text.replace('0.', '.', 1) if re.match('-?0\\.', text) else text, f'{text}0', f'{text}00',
                       text.removesuffix('.0'), text.removesuffix('0')]
        for other in others:
            with contextlib.suppress(ValueError):
                if (written := format_value(descriptor, parse_value(descriptor, other))) != other:
                    found[other] = written
    return found


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
    except Exception:  # whatever it is that the lesson speaks of, it is not a value
        return None
