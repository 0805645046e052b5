"""README.md, the start page and the chapters tell the same story, and every public name is real."""

import re
from pathlib import Path

import nbformat
import pytest

import param_tutorial

ROOT = Path(__file__).parents[1]
CHAPTERS = {path.name: nbformat.read(path, as_version=4) for path in sorted((ROOT / 'notebooks').glob('[0-9]*.ipynb'))}
ROW = re.compile(r'\[([^]]+)\]\((?:notebooks/)?([0-9]\w*\.ipynb)\) *\| *([^|]+?) *\| *(\d+) *\|')


def rows(path):
    """Give the chapter table of a Markdown page: {file: (title, question, minutes)}."""
    return {name: (title, question, int(minutes)) for title, name, question, minutes in ROW.findall(path.read_text())}


def opening(name):
    """Give the first cell of a chapter."""
    return CHAPTERS[name].cells[0].source


@pytest.mark.parametrize('page', ['README.md', 'notebooks/index.md'])
def test_the_table_lists_every_chapter_with_its_minutes(page):
    table = rows(ROOT / page)
    assert list(table) == list(CHAPTERS)
    for name, (_, _, minutes) in table.items():
        assert f'*{minutes} minutes.' in opening(name), name


def test_readme_and_start_page_ask_the_same_questions():
    readme, index = rows(ROOT / 'README.md'), rows(ROOT / 'notebooks/index.md')
    assert {name: row[1:] for name, row in readme.items()} == {name: row[1:] for name, row in index.items()}


@pytest.mark.parametrize('name', CHAPTERS)
def test_a_chapter_has_the_shape_of_all(name):
    text = opening(name)
    assert re.match(r'# \d+(\.\d+)? · ', text)
    assert re.search(r'^\*\*.*\?\*\*$', text, re.MULTILINE | re.DOTALL), 'the question in bold'
    objectives = re.findall(r'^- ', text, re.MULTILINE)
    assert 1 <= len(objectives) <= 4
    prose = '\n'.join(cell.source for cell in CHAPTERS[name].cells if cell.cell_type == 'markdown')
    assert '## What you can do now' in prose
    glossary = re.search(r'\| word \| meaning \|\n\| --- \| --- \|\n((?:\|.*\n)+)', prose)
    assert 4 <= len(glossary.group(1).splitlines()) <= 8
    assert re.search(r'^Next: \[', prose, re.MULTILINE)
    assert CHAPTERS[name].cells[-1].source == 'param_tutorial.stop()'


@pytest.mark.parametrize('name', CHAPTERS)
def test_a_chapter_has_a_live_node_and_a_panel(name):
    code = '\n'.join(cell.source for cell in CHAPTERS[name].cells if cell.cell_type == 'code')
    assert 'ros.add(' in code
    assert 'ParameterPanel(' in code


def test_links_in_the_readme_lead_somewhere():
    for target in re.findall(r'\]\((?!http)([^)#]+)\)', (ROOT / 'README.md').read_text()):
        assert (ROOT / target).exists(), target


@pytest.mark.parametrize('name', param_tutorial.__all__)
def test_public_names_exist_and_are_documented(name):
    assert getattr(param_tutorial, name).__doc__


def test_the_packages_own_picture_of_its_layers_names_every_module():
    package = Path(param_tutorial.__file__).parent
    modules = {path.stem for path in package.glob('[a-z]*.py')} | {
        path.parent.name for path in package.glob('[a-z]*/__init__.py')}
    readme = (ROOT / 'README.md').read_text()
    assert {module for module in modules if not re.search(rf'\b{module}\b', readme)} == set()
