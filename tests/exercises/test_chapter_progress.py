"""What learners see of their own progress in a chapter, none of it in the stored outputs."""


import pytest

from param_tutorial import exercises
from param_tutorial.exercises import CHAPTERS, EXERCISES
from param_tutorial.exercises.results import Finding, Result
from param_tutorial.learner.progress import VARIABLE, ProgressFile


@pytest.fixture
def file(monkeypatch, tmp_path):
    monkeypatch.setenv(VARIABLE, str(tmp_path / 'progress.json'))
    monkeypatch.setattr('param_tutorial.learner.progress._now', lambda: '2026-03-04T10:00:00')
    return ProgressFile(tmp_path / 'progress.json')


def test_what_is_solved_has_a_tick_and_a_date(file):
    file.add_solved('3b')
    file.add_prediction('3-1', 'an exception', right=True)
    file.add_prediction('3-2', 'It rejects it', right=False)
    found = exercises.progress('3')
    assert repr(found).splitlines()[0] == (
        'Chapter 3: 1 of 4 exercises solved, 2 of 6 predictions made, 1 of them right')
    assert '✓ 3b    Declare a rover  2026-03-04' in repr(found)
    assert '· 3c' in repr(found)
    assert '3-1 ✓ 3-2 ✗ 3-3' in repr(found)
    assert 'solved 2026-03-04' in found._repr_html_()
    assert CHAPTERS['3'].praise not in repr(found)


def test_a_solved_chapter_says_what_the_learner_can_do_now(file):
    for number in ('3a', '3b', '3c', '3d'):
        file.add_solved(number)
    assert CHAPTERS['3'].praise in repr(exercises.progress('3'))


def test_a_damaged_file_is_named(file):
    file.path.write_text('{')
    assert "progress.json can't be read" in repr(exercises.progress('3'))


@pytest.mark.parametrize(('done', 'solved'), [(True, ['3b']), (False, []), (None, [])])
def test_a_check_is_remembered_if_all_is_done(monkeypatch, file, done, solved):
    result = Result('3b', [Finding('it is so', done)], 1, 'A worked solution, to compare: solutions/3.ipynb')
    monkeypatch.setattr(EXERCISES['3b'], 'check', lambda *_: result)
    (file.path.parent / 'index.md').write_text('| 3 | [Declaring](03_declaring.ipynb) | … |\n')
    exercises.check('3b', object)
    assert list(file.read()[0].solved) == solved
    assert (file.path.parent / 'index.md').read_text().startswith('| 3 1/4 |' if done else '| 3 |')


def test_a_check_that_cannot_be_remembered_says_so(ros, file):
    file.path.mkdir()
    result = exercises.check('3b', None)
    assert not result.done and 'could not be remembered' in result.text
