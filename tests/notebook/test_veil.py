"""The veil knows what to hide: all but what the learner has committed to or skipped. Tests in browsers see it."""

import json

import pytest

from param_tutorial import exercises
from param_tutorial.learner.progress import VARIABLE, own_progress
from param_tutorial.notebook import veil


@pytest.fixture(autouse=True)
def _no_veil(monkeypatch, tmp_path):
    monkeypatch.setattr(veil, '_veil', None)
    monkeypatch.delenv(veil.VARIABLE, raising=False)
    monkeypatch.setenv(VARIABLE, str(tmp_path / 'progress.json'))


def begun():
    veil.begin()
    return veil._veil


def test_what_was_committed_to_earlier_is_shown_from_the_start():
    own_progress().add_prediction('1-1', 'In the wall', right=True)
    shown = begun()
    assert shown.lifted == ['1-1']
    veil.begin()  # a first cell may run again
    assert veil._veil is shown


def test_a_commit_and_a_skip_show_what_is_hidden_and_a_skip_is_not_remembered(tmp_path):
    shown = begun()
    first, second = (exercises.predict(f'6.1-{number}') for number in (1, 2))
    first.commit(first.prediction.choices[0].text)
    second._on_message(second, {'do': 'skip'}, [])
    assert shown.lifted == ['6.1-1', '6.1-2']
    assert list(json.loads((tmp_path / 'progress.json').read_text())['predicted']) == ['6.1-1']
    assert second.answer == ''


def test_a_teacher_turns_it_off(monkeypatch):
    monkeypatch.setenv(veil.VARIABLE, 'off')
    assert begun() is None
    veil.lift('6.1-1')
