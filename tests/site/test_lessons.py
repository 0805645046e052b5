"""The HTML lessons without a browser: links and the first page."""

import html
import re

import nbformat
import pytest
from nbformat.v4 import new_markdown_cell, new_notebook

from param_tutorial.exercises import EXERCISES, RECALLS, predicting
from param_tutorial.site.live.running import LiveChapter
from param_tutorial.site.pages import chapter, front_page, links, writing
from tests.support.paths import NOTEBOOKS

NOTHING_RAN = LiveChapter([], {})
FACTS = {'Python': '3.12.1', 'rclpy': '7.1.6', 'date': '2026-01-02', 'commit': 'abc1234', 'changed': ''}


def linked(folder, text, pages, **options):
    """Return what Sphinx reads of a chapter with a text; there are other notebooks beside it."""
    (folder / 'solutions').mkdir()
    for name in ('2_b', '9_z', 'solutions/3_solutions'):
        (folder / f'{name}.ipynb').touch()
    path = folder / '3_c.ipynb'
    nbformat.write(new_notebook(cells=[new_markdown_cell(f'# 3 · C\n{text}')]), path)
    return chapter.chapter_source(path, NOTHING_RAN, pages, **options).cells


LINKS = '[b](2_b.ipynb#Top) [z](9_z.ipynb) [s](solutions/3_solutions.ipynb) [w](https://example.org/x.md)'


def test_links_of_a_chapter(tmp_path):
    text = linked(tmp_path, LINKS, {'2_b', '3_c'})[0].source
    assert '[b](2_b.ipynb#Top) z <a href="notebooks/solutions/3_solutions.ipynb" download>s</a> [w](https:' in text


def test_links_of_a_chapter_alone(tmp_path):
    cells = linked(tmp_path, LINKS, {'3_c'}, alone=FACTS)
    assert 'b z s [w](https:' in cells[0].source
    assert 'as of 2026-01-02 (abc1234). It ran on Python 3.12.1' in cells[1].outputs[0].data['text/html']


def test_a_link_to_a_notebook_that_is_not_there_stops_the_build(tmp_path):
    with pytest.raises(writing.BuildError, match=r'^3_c\.ipynb links to 4_d\.ipynb, which is not there\.$'):
        linked(tmp_path, '[d](4_d.ipynb)', {'3_c', '4_d'})


@pytest.mark.parametrize('path', sorted(NOTEBOOKS.glob('[0-9]*.ipynb')), ids=lambda path: path.stem)
def test_what_a_check_says_to_look_at_is_a_link(path):
    notebook = nbformat.read(path, as_version=4)
    shown = links.Links(path, notebook, {path.stem})
    outputs = [shown.in_output(output.data['text/html']) for cell in notebook.cells if cell.id.startswith('check-')
               for output in cell.outputs]
    named = [each for output in outputs for each in re.findall('<dt>look at</dt><dd>(.*?)</dd>', output)]
    assert named and [each for each in named if not re.fullmatch('<a href="#[^"]+">“.*”</a>', each)] == []
    assert shown.in_check('to compare: solutions/x.ipynb') == 'to compare: solutions/x.ipynb'
    solved = next(each.solutions for each in EXERCISES.values() if each.chapter == path.stem)
    assert shown.in_check(f'to compare: {solved}') == f'to compare: <a href="notebooks/{solved}" download>{solved}</a>'


def test_the_first_page_lists_the_chapters_that_there_are_and_says_what_ran(tmp_path):
    index = tmp_path / 'index.md'
    for name in ('1_a', '2_b', '3_c'):
        (tmp_path / f'{name}.ipynb').touch()
    index.write_text('| 1 | [One](1_a.ipynb) | Why? | 20 |\n| 2 | [Two](2_b.ipynb) | How? | 30 |\n'
                     '| 3 | [Three](3_c.ipynb) | When? | 30 + 25 |\n')
    chapters = dict.fromkeys((tmp_path / '1_a.ipynb', tmp_path / '3_c.ipynb'), NOTHING_RAN)
    text = front_page.front_page_source(index, chapters, FACTS)
    assert 'href="1_a.html"' in text and 'Why?' in text and 'Two' not in text
    assert '20 minutes' in text and 'href="3_c.html"' in text and '30 + 25 minutes' in text
    assert re.search(r'2026-01-02 \(`abc1234`\), on Python 3\.12\.1\s+with rclpy 7\.1\.6', text)
    assert 'Move the slider' not in text and 'front-doors' not in text


def test_the_start_page_has_three_doors_and_no_commands():
    index = NOTEBOOKS / 'index.md'
    chapters = dict.fromkeys(sorted(NOTEBOOKS.glob('[0-9]*.ipynb')), NOTHING_RAN)
    text = front_page.front_page_source(index, chapters, FACTS, has_lab=True)
    doors = re.search(r'<ul class="front-doors">.*?</ul>', text, re.DOTALL)[0]
    assert re.findall(r'href="(\w+?)_\w+\.html"', doors) == ['01', '06', '07', '05', 'at']
    assert 'make' not in re.findall(r'`(\w+)', text)
    at_home = front_page.at_home_source(index, {path.stem for path in chapters})
    assert '`make lab`' in at_home and '| **a teacher** | ' in at_home and '[7.3 Overrides](07_3' in at_home
    assert '<details>' not in at_home


@pytest.mark.parametrize('number', RECALLS)
def test_the_verdict_on_a_recall_links_to_the_section_that_answers_it(number):
    notebooks = {path.stem: nbformat.read(path, as_version=4) for path in sorted(NOTEBOOKS.glob('[0-9]*.ipynb'))}
    path = next(NOTEBOOKS.glob('01_*.ipynb'))
    shown = links.Links(path, notebooks[path.stem], set(notebooks))
    recall = RECALLS[number]
    for choice in recall.choices:
        said = shown.in_verdict(predicting.verdict(recall, choice))
        (page, place), = re.findall(r'<a href="(\w+)\.html#([^"]+)">“', said)
        there = links.Links(NOTEBOOKS / f'{page}.ipynb', notebooks[page], set())
        assert html.unescape(place) in there.anchors
        assert notebooks[page].cells[0].source.startswith(f'# {recall.chapter} · ')
    nowhere = links.Links(path, notebooks[path.stem], {path.stem}, is_alone=True)
    assert '<a ' not in nowhere.in_verdict('You learned it in chapter 3, “Declare”.')
    assert shown.in_verdict('You learned it in chapter 99, “Declare”.') == 'You learned it in chapter 99, “Declare”.'
