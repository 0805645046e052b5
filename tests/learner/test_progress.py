"""The file that remembers: whole or not at all, nothing lost between two processes, damage set aside and named."""

import multiprocessing
from pathlib import Path

import pytest

from param_tools.errors import ParameterToolError
from param_tutorial.learner import storage
from param_tutorial.learner.progress import VARIABLE, ProgressFile, own_progress, parse

EACH = 20


@pytest.fixture
def file(tmp_path: Path) -> ProgressFile:
    return ProgressFile(tmp_path / 'my_lessons' / 'progress.json')


def names(file: ProgressFile) -> list[str]:
    return sorted(path.name for path in file.path.parent.iterdir())


def test_the_variable_names_the_file_and_without_it_there_is_none(monkeypatch, tmp_path):
    monkeypatch.setenv(VARIABLE, str(tmp_path / 'here.json'))
    assert own_progress().path == tmp_path / 'here.json'
    monkeypatch.delenv(VARIABLE)
    assert own_progress() is None


def test_what_was_added_is_read_by_another_process_s_object(file):
    assert file.add_solved('3b') == ''
    assert file.add_prediction('3-1', 'None', right=False) == ''
    progress, note = ProgressFile(file.path).read()
    assert note == ''
    assert list(progress.solved) == ['3b']
    assert (progress.predicted['3-1'].choice, progress.predicted['3-1'].right) == ('None', False)
    assert names(file) == ['progress.json']


def test_what_a_check_missed_is_kept_until_the_exercise_is_solved(file):
    for missed in ({'it stops': 'it drove on'}, {'it stops': 'it drove on'}, {'it stops': 'it never moved'}):
        assert file.add_tried('3b', 2, missed) == ''
    tried = file.read()[0].tried['3b']
    assert (tried.met, tried.missed, tried.times) == (2, {'it stops': 'it never moved'}, 2)
    file.add_solved('3b')
    file.add_tried('3b', 0, {'it stops': 'it drove on'})
    progress, _ = file.read()
    assert (list(progress.solved), progress.tried) == (['3b'], {})


def add_many(path: Path, name: str) -> None:
    for number in range(EACH):
        ProgressFile(path).add_solved(f'{name}{number}')


def test_two_kernels_at_once_lose_nothing(file):
    context = multiprocessing.get_context('spawn')
    kernels = [context.Process(target=add_many, args=(file.path, name)) for name in 'ab']
    for each in kernels:
        each.start()
    for each in kernels:
        each.join()
    assert len(file.read()[0].solved) == 2 * EACH


@pytest.mark.parametrize('content', [b'{"solved": {"3b": "20', b'[]', b'{"version": 2, "solved": {}, "predicted": {}}'])
def test_a_damaged_file_is_set_aside_and_named(file, content):
    file.path.parent.mkdir()
    file.path.write_bytes(content)
    with pytest.raises(ParameterToolError):
        parse(content)
    progress, note = file.read()
    assert progress.solved == {} and file.path.name in note
    said = file.add_solved('3b')
    kept, = (name for name in names(file) if name != 'progress.json')
    assert kept in said and said.endswith('.')
    assert (file.path.parent / kept).read_bytes() == content
    assert list(file.read()[0].solved) == ['3b']


def test_a_write_that_fails_leaves_the_file_as_it_was(file, monkeypatch):
    file.add_solved('3b')
    before = file.path.read_bytes()

    def full(_: int) -> None:
        raise OSError(28, 'No space left on device')
    monkeypatch.setattr(storage.os, 'fsync', full)
    assert file.add_solved('3c') == 'This could not be remembered in progress.json: No space left on device.'
    assert file.path.read_bytes() == before
    assert names(file) == ['progress.json']
