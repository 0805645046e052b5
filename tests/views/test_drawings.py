"""Each drawing is as it was approved, drawn and spoken; what every drawing must be, whatever it shows.

A file in ``approved`` is the picture of an example, a page to open in a browser. When a picture is to change, look at
the new one, and approve it: ``APPROVE=1 python -m pytest tests/views/test_drawings.py``.
"""

import os
import re
from pathlib import Path
from xml.etree import ElementTree

import pytest

from param_tutorial.views.drawing import svg
from tests.views.examples import DIAGRAMS, EXAMPLES

FOLDER = Path(__file__).parent / 'approved'
HEAD = ''.join(f'<link rel="stylesheet" href="../../../param_tutorial/param_tutorial/views/drawing/{name}.css">\n'
               for name in ('svg', 'track')) + '<meta charset="utf-8">'


@pytest.mark.parametrize('name', EXAMPLES)
def test_it_is_drawn_and_told_as_it_was_approved(name):
    file, picture = FOLDER / f'{name}.html', HEAD + re.sub(r'(?=<[a-z]|@keyframes)', '\n', EXAMPLES[name])
    if 'APPROVE' in os.environ:
        file.write_text(picture, encoding='utf-8')
    assert file.read_text(encoding='utf-8') == picture


def test_nothing_is_approved_that_is_not_drawn():
    assert {path.stem for path in FOLDER.iterdir()} <= EXAMPLES.keys()


def test_names_and_values_are_text():
    pictures = {name: ElementTree.fromstring(f'<div>{picture}</div>') for name, picture in EXAMPLES.items()}
    assert [name for name, picture in pictures.items() if picture.find('.//b') is not None] == []


def test_each_part_of_a_diagram_has_a_style_in_the_sheet_and_all_colors_follow_the_theme():
    pictures = ''.join(diagram.html('one') for diagram in DIAGRAMS.values())
    classes = {each for names in re.findall(r'class="([^"]*)"', pictures) for each in names.split()}
    assert classes - {'motion-words'} <= {'motion', *re.findall(r'\.(motion-[\w-]+)', svg.STYLE)}
    assert not re.search(r'(?<!, )#[0-9a-f]{3,6}\b', svg.STYLE)


def test_nothing_moves_for_a_reader_who_wants_no_motion():
    rule = svg.STYLE[svg.STYLE.index('prefers-reduced-motion'):]
    assert rule.startswith('prefers-reduced-motion: reduce) { .motion * { animation: none !important; }')
