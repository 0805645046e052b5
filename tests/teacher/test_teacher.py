"""What a teacher reads: a class as one table, its wrong answers, and the requirements at which it is stuck."""

import pytest

from param_tutorial import exercises
from param_tutorial.exercises import CHAPTERS, EXERCISES, PREDICTIONS, RECALLS
from param_tutorial.learner.progress import VARIABLE, ProgressFile
from param_tutorial.teacher.__main__ import main
from tests.support.answers import blank, solution

RIGHT, WRONG = (next(each.text for each in PREDICTIONS['1-1'].choices if each.is_right is is_right)
                for is_right in (True, False))


@pytest.fixture
def told(tmp_path, capsys):
    """Return a function that returns what the command prints about the class in the test's folder."""
    def run():
        assert main([str(tmp_path)]) == 0
        return capsys.readouterr()
    return run


def test_one_row_for_each_student_and_bad_files_are_named(tmp_path, told):
    """The files of three students, in the three ways in which they come, and two bad ones."""
    ada = ProgressFile(tmp_path / 'ada.json')
    for number in ('3a', '3b', '3c', '5.2a'):
        ada.add_solved(number)
    ada.add_prediction('3-1', 'None', right=False)
    ada.add_prediction('3-2', 'It rejects it', right=True)
    ProgressFile(tmp_path / 'Bob' / 'progress.json').add_solved('11b')
    ProgressFile(tmp_path / 'group 2' / 'cyd' / 'my_lessons' / 'progress.json').add_solved('not of this course')
    (tmp_path / 'broken.json').write_text('{')
    (tmp_path / 'Bob' / '.ipynb_checkpoints').mkdir()
    (tmp_path / 'Bob' / '.ipynb_checkpoints' / 'progress.json').write_text('{')
    printed, complained = told()
    lines = printed.partition('\n\n')[0].splitlines()
    assert len(set(map(len, lines))) == 1
    header, *rows = [line.split() for line in lines]
    assert header == ['student', *CHAPTERS, 'all', 'predicted', 'right']
    assert [row[0] for row in rows] == ['ada', 'Bob', 'group']
    row = dict(zip(header, rows[0]))
    assert (row['3'], row['5.2'], row['6.1']) == ('3/4', '1/3', '0/3')
    questions = len(PREDICTIONS) + len(RECALLS)
    assert (row['all'], row['predicted'], row['right']) == (f'4/{len(EXERCISES)}', f'2/{questions}', '1')
    assert dict(zip(header, rows[1]))['11'] == '1/3'
    assert rows[2][-3] == f'0/{len(EXERCISES)}'
    assert len(complained.splitlines()) == 1 and 'broken.json' in complained


def test_a_folder_without_files(tmp_path, capsys):
    assert main([str(tmp_path)]) == 1
    assert 'There is no progress file' in capsys.readouterr().err


def test_the_wrong_answer_that_most_gave_comes_first(tmp_path, told):
    for name, choice in (('Ada', RIGHT), ('Ben', 'a choice of long ago'), ('Cyd', WRONG), ('Dee', WRONG)):
        ProgressFile(tmp_path / f'{name}.json').add_prediction('1-1', choice, right=choice == RIGHT)
    ProgressFile(tmp_path / 'Ada.json').add_prediction('1-3', '70 m', right=False)
    printed, _ = told()
    first, second = (printed.index(each) for each in ('1-1 · 3 of 4 wrong: ', '1-3 · 1 of 1 wrong: '))
    assert [line for line in printed[first:second].splitlines()[1:] if not line.startswith(' ' * 8)] == [
        f'    2 ✗ {WRONG} (Cyd, Dee)', '    1 ✗ a choice of long ago (Ben)', f'    1 ✓ {RIGHT} (Ada)', '']
    assert f'    1 ✗ 70 m (Ada)\n        {PREDICTIONS["1-3"].otherwise}\n' in printed


def test_a_requirement_holds_up_whoever_misses_it_until_the_exercise_is_solved(ros, tmp_path, monkeypatch, told):
    no_wheels = solution('3b', ("'wheels', 6", "'wheels', '6'"))
    # Dee has run all cells twice, and nothing else.
    for name, works in {'Ada': [no_wheels], 'Ben': [blank('3b'), no_wheels], 'Cyd': [no_wheels, solution('3b')],
                        'Dee': [blank('3b')] * 2}.items():
        monkeypatch.setenv(VARIABLE, str(tmp_path / f'{name}.json'))
        for work in works:
            exercises.check('3b', work)
    printed, _ = told()
    found = printed.partition('Exercises that hold somebody up\n\n')[2].splitlines()
    assert found[0] == f'3b · {EXERCISES["3b"].title}: 2 tried it and have not solved it; 1 solved it'
    assert found[1].startswith('    2 ✗ ')
    assert [line.partition(':')[0] for line in found[2:]] == ['        Ada', '        Ben']
    assert 'string' in found[2]
