"""Every chapter in the kernel of a web page: what its cells print and its nodes answer, beside what the real ROS said.

The kernel runs in Node.js, which has the same WebAssembly as Chromium. pytest gives each class to one worker.
"""

import json
from pathlib import Path

import nbformat
import pytest
from nbformat.v4 import new_code_cell

from param_tutorial.site.live import running
from tests.support.paths import ROOT

pytestmark = [pytest.mark.slow, pytest.mark.thorough]

CHAPTERS = sorted((ROOT / 'notebooks').glob('[0-9]*.ipynb'))
# How many cells say why they can't run, and print what is stored of them.
WITHOUT_SHELL = {'02_workspace': 28, '05_3_from_another_node': 5, '07_2_launch_files': 19}
# What the nodes of the chapters answered on the real ROS, by chapter and cell: for each question the parameter, what a
# hand typed, and what it had typed into others before. A chapter whose node is another one now needs other answers.
ANSWERS = json.loads(Path(__file__).with_name('recorded_answers.json').read_text(encoding='utf-8'))
ASK = Path(__file__).with_name('asking.py').read_text(encoding='utf-8')


def pytest_generate_tests(metafunc):
    if metafunc.cls:
        chapters = CHAPTERS[metafunc.cls.part::Chapters.parts]
        if metafunc.function.__name__.endswith('on_the_real_ros'):
            chapters = [each for each in chapters if each.stem in ANSWERS]
        metafunc.parametrize('chapter', chapters, ids=[each.stem for each in chapters])


class Chapters:
    part, parts = 0, 4

    def test_its_cells_print_what_is_stored(self, run_in_a_page, chapter):
        ran = run_in_a_page(chapter)
        different = running.differing_cells(chapter, ran)
        expected = running.EXPLAINED.get(chapter.stem, {})
        unknown = [difference for cell, difference in different if not cell.cell.source.startswith(tuple(expected))]
        assert not unknown, unknown[0]
        assert len(different) == len(expected)
        assert sum(map(running.says_why_not, ran)) == WITHOUT_SHELL.get(chapter.stem, 0)

    def test_its_nodes_answer_as_on_the_real_ros(self, run_in_a_page, chapter, tmp_path):
        asked = ANSWERS[chapter.stem]
        notebook = nbformat.read(chapter, as_version=4)
        cells = []
        for cell in notebook.cells:
            cells.append(cell)
            if cell.id in asked:
                node, questions = asked[cell.id].values()
                cells.append(new_code_cell(
                    f'QUESTIONS = {node!r}, {[each[:3] for each in questions]!r}\n{ASK}\n'
                    f'import json\nprint(json.dumps(ANSWERS))', id=f'ask-{cell.id}'))
        notebook.cells = cells
        nbformat.write(notebook, tmp_path / chapter.name)
        said = {each['cell']: each['outputs'] for each in run_in_a_page(tmp_path / chapter.name)}
        different = [(cell, question, answer) for cell, (_, questions) in
                     ((cell, each.values()) for cell, each in asked.items())
                     for question, answer in zip(questions, answers_in(said[f'ask-{cell}']), strict=True)
                     if question[3] != answer]
        assert not different, f'{len(different)} answers differ, such as {different[:3]}'


def answers_in(outputs):
    """Return what a cell has printed, which is JSON; what else it put out says why it has not."""
    text = ''.join(each.get('text') or '\n'.join(each.get('traceback', ())) for each in outputs)
    assert text.startswith('['), text
    return json.loads(text)


class TestSomeChapters(Chapters):
    part = 0


class TestOtherChapters(Chapters):
    part = 1


class TestMoreChapters(Chapters):
    part = 2


class TestLastChapters(Chapters):
    part = 3
