"""The words of the course that a page explains where they stand; ``site/scripts/glossary.js`` marks them."""

import json
import re

from param_tools.markup.tables import with_code
from param_tutorial.notebook.glossary import Glossary, GlossaryEntry

# The text has them in their everyday sense, too.
_EVERYDAY = frozenset((
    'alias', 'block', 'clamp', 'client', 'constant', 'convert', 'deadline', 'depth', 'difference', 'dump', 'fleet',
    'future', 'gain', 'graph', 'group', 'history', 'left', 'load', 'log', 'marker', 'master', 'mirror', 'node',
    'parameter', 'range', 'reference', 'reject', 'restore', 'rule', 'scene', 'source', 'stale', 'start value', 'step',
    'tolerance', 'tune', 'type', 'value'))


def terms_script(glossary: Glossary, chapter: str) -> str:
    """Return a script that holds the words with their meanings, as a chapter uses them.

    :param chapter: Its number, e.g. '5.2'. Of several meanings of a word it has its own or the latest before it.
    """
    meant: dict[str, GlossaryEntry] = {}
    for entry in glossary.entries:
        for word in re.sub(r'\bto ', '', entry.plain_word).split(', '):
            if word not in _EVERYDAY and (word not in meant or _place(entry.chapter) <= _place(chapter)):
                meant[word] = entry
    terms = [{'word': word, 'code': '`' in entry.word,
              'meaning': f'<b>{with_code(entry.word)}</b> · {with_code(entry.meaning)} (chapter {entry.chapter})'}
             for word, entry in meant.items()]
    text = json.dumps(terms, ensure_ascii=False, separators=(',', ':')).replace('</', r'<\/')
    return f'<script type="text/plain" class="lesson-glossary">{text}</script>' if terms else ''


def _place(chapter: str) -> tuple[int, ...]:
    return tuple(int(part) for part in re.findall(r'\d+', chapter))
