"""What the site's search knows: the sections of all pages, with their words.

Sphinx's own index knows which words are on which page. A reader looks for a section and wants to see the sentence, also
on a disk, where a page may not fetch another one: so the index is a script, and holds the texts.
"""

import json
import re
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from typing import Any

from bs4 import BeautifulSoup
from docutils import nodes  # type: ignore[import-untyped]

FILE_NAME = 'searchindex.js'
# What gives an answer away or is a wrong one, what stands on each page, and pictures, beside which there are words.
_UNSAID = '.lesson-help, .lesson-prediction label, .lesson-download, .param-progress, noscript, svg, button'
# They are most of a page, so they are gone before the rest is parsed.
_PACKED = re.compile(r'<(script|style)\b.*?</\1>', re.DOTALL)
_OUTPUTS = ('text/html', 'text/plain')


@dataclass
class Section:
    """The words of one section, without those of the sections in it."""

    anchor: str
    """By which a link finds it on its page; empty for the top of the page."""
    heading: str
    prose: str
    code: str
    """Code, and what it puts out."""


def sections_of(document: nodes.document) -> list[Section]:
    """Return the sections of a page, as Sphinx has read it, in their order; the first one begins with the page."""
    found: list[Section] = []
    for node in document.findall(nodes.section):
        texts = {False: list[str](), True: list[str]()}
        for is_code, text in _texts(node):
            texts[is_code].append(text)
        found.append(Section(node['ids'][0] if found else '', node[0].astext(), _joined(texts[False]),
                             _joined(texts[True])))
    return found


def index_script(lessons: dict[str, nodes.document], others: dict[str, nodes.document]) -> str:
    """Return the script that holds the index: for each page its name, its title and its sections.

    :param others: Pages that are no lessons, and of less interest.
    """
    index: list[dict[str, Any]] = []
    for name, document in (lessons | others).items():
        sections = sections_of(document)
        index.append({'page': name, 'title': sections[0].heading, 'lesson': name in lessons,
                      'sections': [asdict(each) for each in sections]})
    return f'globalThis.LESSONS_INDEX = {json.dumps(index, ensure_ascii=False, separators=(",", ":"))};\n'


def _texts(node: nodes.Element, *, in_cell: bool = False) -> Iterator[tuple[bool, str]]:
    """Yield the texts of a section, and whether each is code or output; those of sections in it are not its own."""
    for child in node.children:
        if isinstance(child, (nodes.section, nodes.title)):
            continue
        if isinstance(child, nodes.container) and child.get('nb_element') == 'mime_bundle':
            by_kind = {each['mime_type']: each for each in child.findall(nodes.container) if 'mime_type' in each}
            if kind := next((each for each in _OUTPUTS if each in by_kind), None):
                yield from _texts(by_kind[kind], in_cell=True)
        elif isinstance(child, nodes.raw):
            yield in_cell, _text_of_html(child.astext())
        elif isinstance(child, nodes.literal_block):
            yield True, child.astext()
        elif isinstance(child, (nodes.TextElement, nodes.Text)):
            # Between words, HTML is the tags alone.
            yield in_cell, ''.join(each.astext() for each in child.findall(nodes.Text)
                                   if not isinstance(each.parent, nodes.raw))
        elif isinstance(child, nodes.Element):
            yield from _texts(child, in_cell=in_cell or child.get('nb_element') == 'cell_code')


def _text_of_html(text: str) -> str:
    soup = BeautifulSoup(_PACKED.sub('', text), 'html.parser')
    for each in soup.select(_UNSAID):
        each.decompose()
    return soup.get_text(' ')


def _joined(texts: list[str]) -> str:
    return re.sub(r'\s+', ' ', ' '.join(texts)).strip()
