"""The learner's copy of the start page: at each chapter ✓ if it is solved, 1/3 if a part is."""

import contextlib
import re
from collections.abc import Collection, Mapping
from pathlib import Path

from param_tutorial.learner.storage import write_whole

PAGE = 'index.md'
# The number of a chapter, our mark if there is one, and the link to the chapter.
_ROW = re.compile(r'^\| ([\d.]+)(?: (?:✓|\d+/\d+))? \| (?=\[[^\]]*\]\((\w+)\.ipynb\))', re.MULTILINE)


def without_ticks(text: str) -> str:
    """Return the start page as the course has it."""
    return _ROW.sub(r'| \1 | ', text)


def with_ticks(text: str, exercises: Mapping[str, Collection[str]], solved: Collection[str]) -> str:
    """Return the start page with a mark in each row of a chapter that is begun.

    :param exercises: The numbers of each chapter's exercises, by the name of its notebook.
    :param solved: The numbers of those that are solved.
    """
    def marked(row: re.Match[str]) -> str:
        number, chapter = row.groups()
        wanted = exercises.get(chapter, ())
        count = len({*wanted} & {*solved})
        mark = '' if not count else ' ✓' if count == len(wanted) else f' {count}/{len(wanted)}'
        return f'| {number}{mark} | '
    return _ROW.sub(marked, text)


def tick(folder: Path, exercises: Mapping[str, Collection[str]], solved: Collection[str]) -> None:
    """Bring the marks on the start page in a folder up to date; a page that can't be written stays as it is."""
    page = folder / PAGE
    with contextlib.suppress(OSError, UnicodeDecodeError):
        text = page.read_text(encoding='utf-8')
        ticked = with_ticks(text, exercises, solved)
        if ticked != text:
            write_whole(page, ticked.encode())
