"""The learner's copy of the start page: where the learner is, and at each chapter ✓ if solved, 1/3 if a part is."""

import contextlib
import re
from collections.abc import Collection, Mapping
from pathlib import Path

from param_tutorial.learner.storage import write_whole

PAGE = 'index.md'
# The number of a chapter, our mark if there is one, and the link to the chapter.
_ROW = re.compile(r'^\| ([\d.]+)(?: (?:✓|\d+/\d+))? \| (?=\[([^\]]*)\]\((\w+)\.ipynb\))', re.MULTILINE)
# A line above this heading says where the learner is.
_START = '## Where to start\n'
_PLACE = re.compile(rf'^You have solved .*\n\n(?={_START})', re.MULTILINE)


def without_ticks(text: str) -> str:
    """Return the start page as the course has it."""
    return _PLACE.sub('', _ROW.sub(r'| \1 | ', text))


def with_ticks(text: str, exercises: Mapping[str, Collection[str]], solved: Mapping[str, str]) -> str:
    """Return the start page with where the learner is, and a mark in each row of a chapter that is begun.

    :param exercises: The numbers of each chapter's exercises, by the name of its notebook.
    :param solved: When each was solved, by its number.
    """
    known = [number for numbers in exercises.values() for number in numbers]
    done = [number for number in known if number in solved]
    latest = max(done, key=lambda number: solved[number], default='')
    place = ''

    def marked(row: re.Match[str]) -> str:
        nonlocal place
        number, title, chapter = row.groups()
        wanted = exercises.get(chapter, ())
        if latest in wanted:
            place = (f'You have solved {len(done)} of {len(known)} exercises, the latest in '
                     f'[chapter {number}, {title}]({chapter}.ipynb).\n\n')
        count = len({*wanted} & {*done})
        mark = '' if not count else ' ✓' if count == len(wanted) else f' {count}/{len(wanted)}'
        return f'| {number}{mark} | '
    return _ROW.sub(marked, without_ticks(text)).replace(_START, place + _START)


def tick(folder: Path, exercises: Mapping[str, Collection[str]], solved: Mapping[str, str]) -> None:
    """Bring the marks on the start page in a folder up to date; a page that can't be written stays as it is."""
    page = folder / PAGE
    with contextlib.suppress(OSError, UnicodeDecodeError):
        text = page.read_text(encoding='utf-8')
        ticked = with_ticks(text, exercises, solved)
        if ticked != text:
            write_whole(page, ticked.encode())
