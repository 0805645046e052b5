"""Progress that is forgotten on demand, and what the chapters hold."""

from param_tutorial.exercises import CHAPTERS
from param_tutorial.learner import command
from param_tutorial.learner.copies import Copies
from param_tutorial.learner.syllabus import read_syllabus
from tests.support.paths import NOTEBOOKS


def test_the_chapters_name_the_exercises_that_there_are():
    assert list(read_syllabus(NOTEBOOKS).items()) == [
        (each.name, [exercise.number for exercise in each.exercises]) for each in CHAPTERS.values()]


def test_progress_is_forgotten_and_kept(tmp_path, capsys):
    (tmp_path / 'notebooks').mkdir()
    (tmp_path / 'notebooks' / '03_x.ipynb').write_text(
        '{"cells": [{"cell_type": "code", "id": "check-3a", "metadata": {}, "source": "", "outputs": [],'
        ' "execution_count": null}], "metadata": {}, "nbformat": 4, "nbformat_minor": 5}')
    (tmp_path / 'notebooks' / 'index.md').write_text('| 3 | [x](03_x.ipynb) | |\n')
    copies = Copies(tmp_path)
    copies.deliver()
    copies.progress.add_solved('3a')
    assert copies.deliver() == []
    page = copies.folder / 'index.md'
    assert page.read_text() == '| 3 ✓ | [x](03_x.ipynb) | |\n'
    # Our own marks are no change of the learner's.
    (tmp_path / 'notebooks' / 'index.md').write_text('| 3 | [better](03_x.ipynb) | |\n')
    assert copies.deliver() == []
    assert page.read_text() == '| 3 ✓ | [better](03_x.ipynb) | |\n'
    assert command.main(['reset-progress', '--course', str(tmp_path)]) == 0
    assert 'is kept in' in capsys.readouterr().out
    assert page.read_text() == '| 3 | [better](03_x.ipynb) | |\n'
    assert len(list(copies.folder.glob('progress-before-reset-*.json'))) == 1
    assert command.main(['reset-progress', '--course', str(tmp_path)]) == 0
    assert 'nothing to forget' in capsys.readouterr().out
