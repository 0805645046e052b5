"""The start page and the chapters tell the same story, links lead somewhere, and every public name is real."""

import re
import subprocess
import sys
import textwrap
from pathlib import Path

import nbformat

from tests.support.paths import ROOT

PAGES = ['README.md', 'notebooks/index.md', 'environment/README.md', 'environment/dependencies.md', 'tests/README.md',
         '.github/CONTRIBUTING.md', 'param_tutorial/README.md', 'param_tutorial/param_tools/README.md']
NOTEBOOKS = sorted((ROOT / 'notebooks').rglob('*.ipynb'))
CHAPTERS = {path.name: nbformat.read(path, as_version=4) for path in sorted((ROOT / 'notebooks').glob('[0-9]*.ipynb'))}
ROW = re.compile(r'\[([^]]+)\]\(([0-9]\w*\.ipynb)\) *\| *([^|]+?) *\| *(\d+(?: \+ \d+)?) *'
                 r'\|(?: *([^|\n]+?) *\|)?')
DEEPER = {path.name: nbformat.read(path, as_version=4) for path in (ROOT / 'notebooks/deeper').glob('*.ipynb')}
# Longer questions break on a page of usual width, and the table is no longer read at a glance.
QUESTION_CHARACTERS = 72


def rows(path):
    """Return the chapters in the tables of a Markdown page: {file: (title, question, minutes, objectives or '')}."""
    return {name: (title, question, minutes, objectives)
            for title, name, question, minutes, objectives in ROW.findall(path.read_text())}


def opening(name):
    """Return the first cell of a chapter."""
    return CHAPTERS[name].cells[0].source


def test_the_table_lists_every_chapter_with_its_minutes():
    page = ROOT / 'notebooks/index.md'
    table = rows(page)
    assert list(table) == list(CHAPTERS)
    first = re.findall(r'^\| \[.+\]\((\w+\.ipynb)\) \| (\d+) \|', page.read_text(), re.MULTILINE)
    assert len(first) == 5 and all(table[name][2] == minutes for name, minutes in first)
    for name, (_, question, minutes, _) in table.items():
        assert f'*{minutes} minutes.' in opening(name), name
        assert question.endswith('?')
        assert len(question) <= QUESTION_CHARACTERS, question


def test_the_start_page_promises_what_the_chapter_promises():
    for name, (_, _, _, promised) in rows(ROOT / 'notebooks/index.md').items():
        objectives = re.findall(r'^- (.+)$', opening(name), re.MULTILINE)
        assert len(promised.split('; ')) == 2
        for promise in promised.split('; '):
            assert any(re.match(rf'{re.escape(promise)}(?!\w)', objective) for objective in objectives), promise


def test_a_chapter_has_the_shape_of_all():
    for name, chapter in CHAPTERS.items():
        text = opening(name)
        assert re.match(r'# \d+(\.\d+)? · ', text), name
        assert re.search(r'^\*\*.*\?\*\*$', text, re.MULTILINE | re.DOTALL), f'{name}: the question in bold'
        assert 1 <= len(re.findall(r'^- ', text, re.MULTILINE)) <= 4, name
        prose = '\n'.join(cell.source for cell in chapter.cells if cell.cell_type == 'markdown')
        assert '## What you can do now' in prose, name
        glossary = re.search(r'\| word \| meaning \|\n\| --- \| --- \|\n((?:\|.*\n)+)', prose)
        assert 4 <= len(glossary.group(1).splitlines()) <= 8, name
        assert re.search(r'^Next: \[', prose, re.MULTILINE), name
        # *Run All* leaves a page to play with: no cell ends the stage, or takes the files away that others need.
        code = '\n'.join(cell.source for cell in chapter.cells if cell.cell_type == 'code')
        assert not re.search(r'param_tutorial\.stop\(\)|cleanup\(\)', code), name


def test_a_chapter_is_short_and_the_reader_types_early():
    for name, chapter in CHAPTERS.items():
        cells = chapter.cells
        assert words_of(chapter) <= 1500, f'{name}: words'
        assert len(cells) <= 60, f'{name}: cells'
        turn = next(at for at, cell in enumerate(cells) if cell.id.startswith('check-'))
        assert turn <= 0.4 * len(cells), f'{name}: the first turn of the reader'
        shown = [cell.source for cell in cells if cell.cell_type == 'code' and not cell.id.startswith('exercise-')]
        assert len(re.findall('^class ', '\n'.join(shown), re.MULTILINE)) <= 3, f'{name}: classes to throw away'


def words_of(notebook):
    """Count the words of a notebook's text, without code, HTML, and where links lead."""
    prose = '\n'.join(cell.source for cell in notebook.cells if cell.cell_type == 'markdown')
    prose = re.sub(r'```.*?```|<[^>]+>|\]\([^)]*\)', '', prose, flags=re.DOTALL)
    return sum(bool(re.search(r'\w', word)) for word in prose.split())


def test_what_goes_deeper_is_one_short_notebook_a_subject():
    page = (ROOT / 'notebooks/index.md').read_text()
    assert sorted(re.findall(r'\(deeper/(\w+\.ipynb)\)', page)) == sorted(DEEPER)
    assert len(DEEPER) <= 12 and sum(map(words_of, DEEPER.values())) <= 10_000
    links = {target for chapter in CHAPTERS.values() for cell in chapter.cells if cell.cell_type == 'markdown'
             for target in re.findall(r'\(deeper/(\w+\.ipynb)', cell.source)}
    assert links == set(DEEPER)
    for name, notebook in DEEPER.items():
        assert notebook.cells[-1].source.splitlines()[-1].startswith('Back to [chapter '), name


def test_links_lead_somewhere():
    for page in PAGES:
        targets = re.findall(r'\]\((?!http)([^)#]+)(?:#[^)]*)?\)', (ROOT / page).read_text())
        assert [target for target in targets if not ((ROOT / page).parent / target).exists()] == [], page


def test_what_check_prints_in_the_readme_is_what_it_prints(tmp_path):
    readme = (ROOT / 'param_tutorial' / 'param_tools' / 'README.md').read_text()
    shown = re.search(r'```yaml\n([^`]+)```\n\n    \S+ -m param_tools (.+)\n((?:    .+\n)+)', readme)
    content, words, said = shown.groups()
    (tmp_path / 'robot.yaml').write_text(content)
    done = subprocess.run([sys.executable, '-m', 'param_tools', *words.split()], cwd=tmp_path, capture_output=True,
                          text=True)
    assert done.stdout == textwrap.dedent(said)


def test_a_link_to_a_chapter_leads_to_that_chapter():
    numbers = {name: re.match(r'# (\d+(\.\d+)?) · ', opening(name))[1] for name in CHAPTERS}
    for path in NOTEBOOKS:
        cells = nbformat.read(path, as_version=4).cells
        prose = '\n'.join(cell.source for cell in cells if cell.cell_type == 'markdown')
        for number, target in re.findall(r'\[[Cc]hapter (\d+(?:\.\d+)?)\b[^]]*\]\(([^)#]+)', prose):
            assert numbers.get(Path(target).name) == number, f'{path.name}: chapter {number} leads to {target}'
            assert (path.parent / target).exists()
