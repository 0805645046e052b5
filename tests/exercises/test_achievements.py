"""What learners see of their own progress: ticks, a picture, and a certificate, none of it in the stored outputs."""


import nbformat
import pytest

from param_tutorial import exercises
from param_tutorial.exercises import CHAPTERS, EXERCISES, achievements
from param_tutorial.exercises.results import Finding, Result
from param_tutorial.learner.progress import VARIABLE, ProgressFile
from tests.support.paths import NOTEBOOKS


@pytest.fixture
def file(monkeypatch, tmp_path):
    monkeypatch.setenv(VARIABLE, str(tmp_path / 'progress.json'))
    monkeypatch.setattr('param_tutorial.learner.progress._now', lambda: '2026-03-04T10:00:00')
    return ProgressFile(tmp_path / 'progress.json')


@pytest.fixture
def no_file(monkeypatch):
    monkeypatch.delenv(VARIABLE, raising=False)


@pytest.mark.parametrize('chapter', CHAPTERS.values(), ids=lambda each: each.number)
def test_each_chapter_ends_with_its_progress_and_the_stored_one_has_no_ticks(chapter, no_file):
    cells = nbformat.read(NOTEBOOKS / f'{chapter.name}.ipynb', as_version=4).cells
    cell, = (each for each in cells if each.id == 'progress')
    assert cell.source == f"exercises.progress('{chapter.number}')"
    last_check = max(index for index, each in enumerate(cells) if each.id.startswith('check-'))
    assert cells.index(cell) > last_check
    stored = cell.outputs[0].data['text/plain']
    assert stored == repr(exercises.progress(chapter.number))
    assert '✓' not in stored and 'solved 20' not in stored


def test_what_is_solved_has_a_tick_and_a_date(file):
    file.add_solved('3b')
    file.add_prediction('3-1', 'an exception', right=True)
    file.add_prediction('3-2', 'It rejects it', right=False)
    found = exercises.progress('3')
    assert found.text == ''
    assert repr(found).splitlines()[0] == (
        'Chapter 3: 1 of 4 exercises solved, 2 of 7 predictions made, 1 of them right')
    assert '✓ 3b    Declare a rover  2026-03-04' in repr(found)
    assert '· 3c' in repr(found)
    assert '3-1 ✓ 3-2 ✗ 3-3' in repr(found)
    assert 'solved 2026-03-04' in found._repr_html_() and 'The robot stands' not in found._repr_html_()


def test_a_solved_chapter_is_a_small_pleasure(file):
    for number in ('3a', '3b', '3c', '3d'):
        file.add_solved(number)
    found = exercises.progress('3')
    assert CHAPTERS['3'].praise in repr(found)
    assert 'aria-label="The robot stands at the flag of chapter 3"' in found._repr_html_()


def test_a_damaged_file_is_named(file):
    file.path.write_text('{')
    assert "progress.json can't be read" in repr(exercises.progress('3'))


def test_the_whole_course_has_a_row_for_each_chapter(file):
    for number in ('3a', '3b', '3c', '3d', '5.2a'):
        file.add_solved(number)
    rows = repr(exercises.progress()).splitlines()
    assert len(rows) == len(CHAPTERS)
    assert '✓ 3     exercises 4/4   predictions 0/7' in rows
    assert '· 5.2   exercises 1/4   predictions 0/9' in rows


def test_the_whole_course_without_a_file(no_file):
    assert 'make lab' in repr(exercises.progress()) and '✓' not in repr(exercises.progress())


def finding(done):
    return Result('3b', [Finding('it is so', done)], 1, 'A worked solution, to compare: solutions/3.ipynb')


@pytest.mark.parametrize(('done', 'solved'), [(True, ['3b']), (False, []), (None, [])])
def test_a_check_is_remembered_if_all_is_done(monkeypatch, file, done, solved):
    monkeypatch.setattr(EXERCISES['3b'], 'check', lambda _: finding(done))
    (file.path.parent / 'index.md').write_text('| 3 | [Declaring](03_declaring.ipynb) | … |\n')
    exercises.check('3b', object)
    assert list(file.read()[0].solved) == solved
    assert (file.path.parent / 'index.md').read_text().startswith('| 3 1/4 |' if done else '| 3 |')


def test_a_check_that_cannot_be_remembered_says_so(monkeypatch, file):
    monkeypatch.setattr(EXERCISES['3b'], 'check', lambda _: finding(True))
    file.path.mkdir()
    result = exercises.check('3b', object)
    assert result.done and 'could not be remembered' in result.text


def test_without_the_variable_a_certificate_says_how_to_get_one(no_file, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    assert 'make lab' in repr(exercises.certificate())
    assert list(tmp_path.iterdir()) == []


def test_a_certificate_needs_something_to_certify(file):
    assert 'nothing to certify yet' in repr(exercises.certificate())
    assert not (file.path.parent / achievements.CERTIFICATE).exists()


def test_a_certificate_without_a_name_is_not_written(file):
    file.add_solved('3b')
    assert 'give it your name' in ' '.join(repr(exercises.certificate()).split())
    assert not (file.path.parent / achievements.CERTIFICATE).exists()


def test_a_certificate_lists_what_was_proved_with_dates(file):
    file.add_solved('3b')
    file.add_solved('10.4b')
    found = exercises.certificate('Ada <Lovelace>')
    page = (file.path.parent / achievements.CERTIFICATE).read_text()
    assert repr(found).startswith(f'2 of {len(EXERCISES)} exercises proved.')
    assert 'Ada &lt;Lovelace&gt;' in page and 'Ada <Lovelace>' not in page
    assert '<th scope="row">3b</th><td>Declare a rover</td><td>2026-03-04</td>' in page
    assert '<th scope="row">10.4b</th>' in page and '3c' not in page
    assert page.startswith('<!DOCTYPE html>')


def test_a_certificate_of_all_says_so(file):
    for number in EXERCISES:
        file.add_solved(number)
    assert f'has solved all of {len(EXERCISES)} exercises' in exercises.certificate('Ada')._repr_html_()
