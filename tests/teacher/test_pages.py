"""What a teacher reads: wrong answers and unmet requirements of a class, and a plan for each lesson."""

import os
import re

import nbformat
import pytest

from param_tutorial import exercises
from param_tutorial.exercises import CHAPTERS, PREDICTIONS
from param_tutorial.learner.progress import VARIABLE, ProgressFile
from param_tutorial.teacher import command, misconceptions, plan
from param_tutorial.teacher.classroom import read_class
from tests.support.answers import blank, solution
from tests.support.paths import NOTEBOOKS

RIGHT, WRONG, OTHER = ('In the wall', 'Closer to the wall: it brakes later',
                       'Where it stopped before: the log would warn first')


@pytest.fixture
def answered(tmp_path):
    """Return a folder with four students: three answered a question, one has not begun."""
    for name, choice in (('Ada', RIGHT), ('Ben', OTHER), ('Cyd', WRONG), ('<Dee>', WRONG)):
        ProgressFile(tmp_path / name / 'progress.json').add_prediction('1-1', choice, right=choice == RIGHT)
    ProgressFile(tmp_path / 'Ada' / 'progress.json').add_prediction('1-3', '70 m', right=False)
    (tmp_path / 'Eve.json').write_text('{"version": 1, "solved": {}, "predicted": {}}')
    return tmp_path


def test_the_wrong_answer_that_most_gave_comes_first(answered):
    first, second = misconceptions.answers(read_class(answered)[0])
    assert (first.question.number, first.wrong, first.total) == ('1-1', 3, 4)
    assert [(choice.text, names) for choice, names in first.by_choice] == [
        (WRONG, ['<Dee>', 'Cyd']), (OTHER, ['Ben']), (RIGHT, ['Ada'])]
    (choice, _), = second.by_choice
    assert (choice.text, choice.sentence) == ('70 m', PREDICTIONS['1-3'].otherwise)


def test_an_answer_that_the_course_no_longer_has_is_shown_as_it_was_given(answered):
    ProgressFile(answered / 'Ben' / 'progress.json').add_prediction('3-1', 'a choice of long ago', right=False)
    asked, = (each for each in misconceptions.answers(read_class(answered)[0]) if each.question.number == '3-1')
    assert [(choice.text, names) for choice, names in asked.by_choice] == [('a choice of long ago', ['Ben'])]


@pytest.fixture
def check_as(tmp_path, monkeypatch, ros):
    """Return a function that checks an exercise as a student of a class."""
    def check(name, number, *works):
        monkeypatch.setenv(VARIABLE, str(tmp_path / name / 'progress.json'))
        for work in works:
            exercises.check(number, work)
    return check


def test_a_requirement_holds_up_whoever_misses_it_until_the_exercise_is_solved(check_as, tmp_path):
    no_wheels = solution('3b', ("'wheels', 6", "'wheels', '6'"))
    check_as('Ada', '3b', no_wheels)
    check_as('Ben', '3b', blank('3b'), no_wheels)
    check_as('Cyd', '3b', no_wheels, solution('3b'))
    # Only what ran with all other cells, twice.
    check_as('Dee', '3b', blank('3b'), blank('3b'))
    found, = misconceptions.stuck(read_class(tmp_path)[0])
    assert (found.number, found.names, found.solved) == ('3b', ['Ada', 'Ben'], 1)
    (_, by_student), *others = found.by_requirement
    assert not others and list(by_student) == ['Ada', 'Ben']
    assert 'string' in by_student['Ada']
    assert os.environ[VARIABLE].endswith('Dee/progress.json')


def test_the_page_names_who_has_not_begun_and_what_to_talk_about(answered, capsys):
    assert command.main(['class', str(answered)]) == 0
    assert str(answered / 'class.html') in capsys.readouterr().out
    page = (answered / 'class.html').read_text()
    assert 'Not begun: Eve.' in page
    assert re.search(r'<b>2 ✗</b> Closer to the wall: it brakes later <small>&lt;Dee&gt;, Cyd</small>', page)
    assert page.index('1-1 · 3 of 4 wrong') < page.index('1-3 · 1 of 1 wrong')


def test_a_page_that_cannot_be_written_is_named(answered, capsys):
    (answered / 'class.html').mkdir()
    assert command.main(['class', str(answered)]) == 1
    assert f'{answered / "class.html"} could not be written' in capsys.readouterr().err


@pytest.mark.parametrize('chapter', CHAPTERS.values(), ids=lambda each: each.number)
def test_a_plan_adds_up_and_names_all_that_is_asked(chapter):
    sections = plan.sections(nbformat.read(NOTEBOOKS / f'{chapter.name}.ipynb', as_version=4))
    stated = re.search(r'\*([\d +]+) minutes', (NOTEBOOKS / f'{chapter.name}.ipynb').read_text())[1]
    assert round(sum(each.minutes for each in sections), 6) == sum(map(int, stated.split('+')))
    asked = [number for each in sections for number in each.numbers]
    assert asked == [each.number for kind in (chapter.recalls, chapter.predictions, chapter.exercises)
                     for each in kind]


def test_the_plans_say_what_each_wrong_answer_means(tmp_path):
    assert command.main(['plans', str(tmp_path / 'build')]) == 0
    page = (tmp_path / 'build' / 'plans.html').read_text()
    assert page.count('class="lesson"') == len(CHAPTERS)
    assert 'Fifteen minutes more'.lower() in page.lower()
    assert 'Without it the robot does not brake at all, neither early nor late.' in page
