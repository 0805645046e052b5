"""The words of the course, gathered from the tables at the ends of the chapters, so that both always say the same.

No ROS. Notebooks are read as plain JSON.
"""

import html
import json
import re
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

from param_tools.markup.styles import style
from param_tools.markup.tables import Markup, table, with_code

_STYLE = style('param_tutorial/notebook/glossary.css')
_TITLE = re.compile(r'^# (\S+) · ', re.MULTILINE)
_TABLE = re.compile(r'^\| word \| meaning \|\n\|[ |:-]+\|\n((?:\|.*(?:\n|$))+)', re.MULTILINE)


class GlossaryEntry(NamedTuple):
    """What one chapter says about a word."""

    word: str
    """In Markdown, as is the meaning: code stands between backquotes."""
    meaning: str
    chapter: str
    """Its number, e.g. '5.2'."""
    notebook: str
    """The name of its file."""

    @property
    def plain_word(self) -> str:
        return self.word.replace('`', '')


class Glossary:
    """Words with their meanings, in alphabetical order; a word has a line for each chapter that explains it."""

    def __init__(self, entries: Iterable[GlossaryEntry]) -> None:
        # Within one word the order of the chapters stays.
        self.entries = sorted(entries, key=lambda entry: re.sub('^(to |--)', '', entry.plain_word).lower())

    @classmethod
    def of(cls, folder: str | Path) -> 'Glossary':
        """Gather the glossary of all chapters in a folder.

        :param folder: Where the notebooks are; those whose names begin with a digit are chapters.
        :raises FileNotFoundError: there is no chapter.
        """
        paths = sorted(Path(folder).glob('[0-9]*.ipynb'))
        if not paths:
            raise FileNotFoundError(f'there is no chapter in {str(folder)!r}: give the folder with the notebooks')
        return cls(entry for path in paths for entry in _entries(path))

    def __repr__(self) -> str:
        width = max(len(entry.plain_word) for entry in self.entries)
        return '\n'.join(f'{entry.plain_word:{width}}  {entry.meaning.replace("`", "")} ({entry.chapter})'
                         for entry in self.entries)

    def _repr_html_(self) -> str:
        return _STYLE + table(('word', 'meaning', 'chapter'), map(_row, self.entries), css_class='param-glossary',
                              row_headers=True)


def _row(entry: GlossaryEntry) -> tuple[str, str, str]:
    link = Markup(f'<a href="{html.escape(entry.notebook)}">{entry.chapter}</a>')
    return with_code(entry.word), with_code(entry.meaning), link


def _entries(path: Path) -> Iterable[GlossaryEntry]:
    cells = json.loads(path.read_text(encoding='utf-8'))['cells']
    prose = '\n\n'.join(''.join(cell['source']) for cell in cells if cell['cell_type'] == 'markdown')
    title = _TITLE.search(prose)
    for words in _TABLE.finditer(prose):
        for line in words[1].splitlines():
            word, meaning = (each.strip() for each in line.strip().strip('|').split(' | ', 1))
            yield GlossaryEntry(word, meaning, title[1] if title else path.stem, path.name)
