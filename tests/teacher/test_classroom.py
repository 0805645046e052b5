"""A class as one table."""

import csv

import pytest

from param_tutorial.exercises import CHAPTERS, EXERCISES, PREDICTIONS, RECALLS
from param_tutorial.learner.progress import ProgressFile
from param_tutorial.teacher import command


@pytest.fixture
def folder(tmp_path):
    """Return a folder with the files of three students, in the three ways in which they come, and two bad ones."""
    ada = ProgressFile(tmp_path / 'ada.json')
    for number in ('3a', '3b', '3c', '5.2a'):
        ada.add_solved(number)
    ada.add_prediction('3-1', 'None', right=False)
    ada.add_prediction('3-2', 'It rejects it', right=True)
    ProgressFile(tmp_path / 'Bob' / 'progress.json').add_solved('11f')
    ProgressFile(tmp_path / 'group 2' / 'cyd' / 'my_lessons' / 'progress.json').add_solved('not of this course')
    (tmp_path / 'broken.json').write_text('{')
    (tmp_path / 'Bob' / '.ipynb_checkpoints').mkdir()
    (tmp_path / 'Bob' / '.ipynb_checkpoints' / 'progress.json').write_text('{')
    return tmp_path


def test_one_row_for_each_student_and_bad_files_are_named(folder, capsys):
    assert command.main(['class', str(folder)]) == 0
    printed, complained = capsys.readouterr()
    header, *rows = [line.split() for line in printed.partition('\n\n')[0].splitlines()]
    assert header == ['student', *CHAPTERS, 'all', 'predicted', 'right']
    assert [row[0] for row in rows] == ['ada', 'Bob', 'group']
    ada = dict(zip(header, rows[0]))
    assert (ada['3'], ada['5.2'], ada['6.1']) == ('3/4', '1/4', '0/3')
    questions = len(PREDICTIONS) + len(RECALLS)
    assert (ada['all'], ada['predicted'], ada['right']) == (f'4/{len(EXERCISES)}', f'2/{questions}', '1')
    assert dict(zip(header, rows[1]))['11'] == '1/7'
    assert rows[2][-3] == f'0/{len(EXERCISES)}'
    assert len({len(line) for line in printed.partition('\n\n')[0].splitlines()}) == 1
    assert len(complained.splitlines()) == 1 and 'broken.json' in complained


def test_as_csv(folder, capsys):
    assert command.main(['class', str(folder), '--csv']) == 0
    rows = {row['student']: row for row in csv.DictReader(capsys.readouterr().out.splitlines())}
    assert list(rows) == ['ada', 'Bob', 'group 2/cyd']
    assert (rows['ada']['3'], rows['ada']['all'], rows['ada']['right']) == ('3', '4', '1')


def test_a_folder_without_files(tmp_path, capsys):
    assert command.main(['class', str(tmp_path)]) == 1
    assert 'There is no progress file' in capsys.readouterr().err


@pytest.mark.parametrize('arguments', [[], ['class'], ['plans'], ['06', 'folder']])
def test_words_that_do_not_belong_together(arguments, capsys):
    with pytest.raises(SystemExit):
        command.main(arguments)
    assert 'usage' in capsys.readouterr().err
