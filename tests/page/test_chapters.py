"""Every chapter in the kernel of a web page: what its cells print there, beside what the real ROS printed.

The kernel runs in Node.js, which has the same WebAssembly as Chromium. pytest gives each class to one worker.
"""

import nbformat
import pytest

from param_tutorial.notebook.shell import NO_SHELL
from param_tutorial.site.recording.comparison import cells_of
from tests.support.paths import ROOT

pytestmark = [pytest.mark.slow, pytest.mark.thorough]

CHAPTERS = sorted((ROOT / 'notebooks').glob('[0-9]*.ipynb'))
WHY = f'{NO_SHELL[0].upper()}{NO_SHELL[1:]}, so this cell does not run here.'
# By a chapter's number: the first line of a cell whose output differs, and why it does.
DIFFERENT = {
    '02_workspace': {
        "ParameterPanel('/simple_param_node')": 'the node is one that only colcon could build',
        "exercises.check('2c', lines)": 'its check builds a package, and says why it cannot',
        "exercises.check('2a', setup)": 'its check builds a package, and says why it cannot',
    },
    '05_1_from_the_command_line': {'%ros2_terminal': 'no terminal finds the nodes of a page, and the cell says so'},
    '07_1_saving': {
        '%ros2 param dump /simple_param_node > config/': 'a missing file has error number 44 in WebAssembly, and not 2',
    },
    '08_best_practices': {'%ros2 param dump /untidy > untidy.yaml': "rcl's error names its own C files"},
    '09_1_moving_from_ros1': {"Path('ros1.yaml').write_text(": "rcl's error names its own C files"},
    '09_2_ros1_and_ros2': {"Path('saved.yaml').write_text(": "rcl's error names its own C files"},
}
# How many cells say why they can't run, and print what is stored of them.
WITHOUT_SHELL = {'02_workspace': 28, '05_3_from_another_node': 5, '07_2_launch_files': 19}


def pytest_generate_tests(metafunc):
    if metafunc.cls:
        chapters = CHAPTERS[metafunc.cls.part::Chapters.parts]
        metafunc.parametrize('chapter', chapters, ids=[each.stem for each in chapters])


class Chapters:
    part, parts = 0, 4

    def test_its_cells_print_what_is_stored(self, outputs_in_a_page, chapter):
        different, without_shell = [], 0
        new = outputs_in_a_page(chapter)
        for cell, outputs in zip(cells_of(chapter), new, strict=True):
            if outputs and outputs[0].get('text', '').startswith(WHY):
                without_shell += 1
            elif not cell.is_skipped:
                difference = cell.difference([nbformat.from_dict(each) for each in outputs])
                different += [(cell.cell.source, difference)] if difference else []
        expected = DIFFERENT.get(chapter.stem, {})
        assert [source for source, _ in different if source.startswith(tuple(expected))] == [
            source for source, _ in different], different
        assert len(different) == len(expected)
        assert without_shell == WITHOUT_SHELL.get(chapter.stem, 0)


class TestSomeChapters(Chapters):
    part = 0


class TestOtherChapters(Chapters):
    part = 1


class TestMoreChapters(Chapters):
    part = 2


class TestLastChapters(Chapters):
    part = 3
