"""Why rcl rejects a file, as its author would name it, and what to write. No ROS, no Jupyter."""

import difflib
import html
import re
import unicodedata
from collections.abc import Sequence

from param_tools.files.parsing import KEY, BlockStart, Place, Rejected

LIST_BELOW = f'a list stands below {KEY}, where names have to stand: remove the dashes'
# Blanks that indent nothing in YAML.
_BLANK = re.compile('^ *([\xa0\u2000-\u200b\u202f\u2060\u3000\ufeff])')
_TEMPLATE = re.compile(r'\{\{.*?\}\}+|\{%.*?%\}|<%.*?%>')
_TAG = re.compile(r'(?:^|[:,\[-] +)(![^\s!]+)')
_EQUALS = re.compile(r'\s*([\w./]+)\s*=\s*(\S.*)')
_WIDE_COLON = '\uff1a'
_ENTITY = re.compile(r'&(?:amp|lt|gt|quot|apos|nbsp|#\d+);')


def named_sign(sign: str) -> str:
    """Return a character that looks like another, by its name and number, with its article."""
    name = unicodedata.name(sign)
    return f'{"an" if name[0] in "AEIO" else "a"} {name} (U+{ord(sign):04X})'


def looks_like_header(name: str) -> bool:
    """True if a key is ``ros__parameters`` with a typo; ``dh_parameters`` and ``robot_parameters`` are other words."""
    word = name.lower()
    return (name != KEY and difflib.SequenceMatcher(None, word, KEY).ratio() > 0.75
            and not re.match('robot|(?!ro)[a-z]+_+parameters', word))


def cause_of(rejected: Rejected, starts: Sequence[BlockStart], lines: Sequence[str]) -> tuple[Place, str, str]:
    """Return where the cause of a rejection stands, what it is, with a remedy, and the kind of the finding.

    :param starts: The blocks of the file that begin before it.
    :param lines: Those of the file.
    """
    number = rejected.place.line
    for near in (number, number + 1, *(place.line for _, place in rejected.keys)):
        if near <= len(lines) and (blank := _BLANK.match(lines[near - 1])):
            reason = f'{named_sign(blank[1])} indents nothing in YAML: indent this line with plain spaces'
            return Place(near, blank.start(1) + 1), reason, 'unreadable'
    if number <= len(lines) and (found := _in_line(lines[number - 1], str(rejected))):
        return Place(number, found[0]), found[1], 'unreadable'
    dash = starts[-1].list_place if starts else None
    if dash and (not rejected.keys or rejected.keys[0][1].column > dash.column):
        return dash, LIST_BELOW, 'unreadable'
    if not rejected.keys:
        return rejected.place, str(rejected), 'unreadable'
    for name, place in rejected.keys:
        if looks_like_header(name):
            return place, f'{name!r} should be {KEY!r}: rcl rejects the file', 'no header'
    if starts:
        # What stands after the header, in its column and in the same map.
        end = starts[-1].end
        name, place = next(((name, place) for name, place in rejected.keys if place.start > end.start), ('', Place()))
        if name and place.column == end.column:
            return (place, f'{name} stands beside {KEY!r}, not below it: rcl rejects the file. Indent this line',
                    'no header')
    return rejected.place, str(rejected), 'no header'


def _in_line(line: str, reason: str) -> tuple[int, str] | None:
    """Return what in a line itself is the cause, and its column; None if that isn't known."""
    if template := _TEMPLATE.search(line):
        return template.start() + 1, f'{template[0]} is a template that nobody has filled in: write the value'
    if line.startswith('%'):
        return 1, f'a parameter file needs no line {line.strip()}, and rcl may read none: remove it'
    if _WIDE_COLON in line:
        return line.index(_WIDE_COLON) + 1, f'{named_sign(_WIDE_COLON)} is no colon: write a plain one and a space'
    if 'not YAML' in reason:
        if entity := _ENTITY.search(line):
            return entity.start() + 1, (f'{entity[0]} is how a web page writes {html.unescape(entity[0])}: write that, '
                                        f'in quotes')
    elif 'value' in reason:
        if tag := _TAG.search(line.partition(' #')[0]):
            return tag.start(1) + 1, (f'rcl fills in no {tag[1]}: write here what it stands for'
                                      f'{", or give that file as well" * ("include" in tag[1])}')
        if 'before' in reason and (equals := _EQUALS.match(line)):
            return equals.start(1) + 1, (f'there is no colon: a name ends with a colon and a space, so write '
                                         f'{equals[1]}: {equals[2].strip()}')
    return None
