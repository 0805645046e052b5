"""Each wrong answer that people give gets a finding that fits, and each unusual right one passes.

The answers are made from the solutions by replacing a few words. pytest gives each class to one worker, and checks
mostly wait, so there are several classes.
"""

import pytest

from param_tutorial import exercises
from param_tutorial.exercises import EXERCISES, trial
from tests.exercises.wrong_answers import RIGHT, WRONG
from tests.support.answers import not_yet, solution

# Here the answer is a program that runs in a process, again and again: some twenty seconds each.
PROGRAMS = ('1c', '3d', '5.3b')
# In these, a requirement waits for something that never comes.
WAITING = ('5.3a', '5.3b', '5.4a', '10.2b')


def pytest_generate_tests(metafunc):
    """Try the answers to the chapters of a class: the first ones each time, and the others now and then."""
    if metafunc.cls is None:
        return
    is_wrong = 'word' in metafunc.fixturenames
    params = []
    for number, exercise in EXERCISES.items():
        if metafunc.cls.first <= int(exercise.chapter[:2]) <= metafunc.cls.last:
            # The solution itself where there is no other right answer.
            answers = WRONG[number] if is_wrong else [(each,) for each in RIGHT.get(number, [()])]
            daily = len(exercise.requirements) if is_wrong else 1
            if number in PROGRAMS:  # the notebook of solutions checks the program itself
                daily = int(is_wrong)
            params += [pytest.param(number, *each, id=f'{number}-{position}',
                                    marks=() if position < daily else pytest.mark.rare)
                       for position, each in enumerate(answers)]
    metafunc.parametrize(('number', 'replacements', 'met', 'word') if is_wrong else ('number', 'replacements'), params)


class Answers:
    first, last = 0, 0
    """The first and the last chapter whose answers are tried."""

    @pytest.mark.filterwarnings('ignore:Callback returned an invalid type')
    def test_a_wrong_answer_gets_a_finding_that_fits(self, ros, monkeypatch, number, replacements, met, word):
        if number in WAITING:
            monkeypatch.setattr(trial, 'TIME_LIMIT_SEC', 2.5)
        work = solution(number, *replacements)
        nodes = ros.nodes
        result = exercises.check(number, work)
        assert not result.done
        assert result.count == met
        assert word in ' '.join(not_yet(result).values())
        assert not (word.startswith('SyntaxError') and any(each.see for each in result.findings))
        assert ros.nodes == nodes

    def test_a_right_answer_is_done(self, ros, number, replacements):
        work = solution(number, *replacements)
        nodes = ros.nodes
        result = exercises.check(number, work)
        assert result.done, result
        assert ros.nodes == nodes


class TestChapters1To4(Answers):
    first, last = 1, 4


class TestChapter5(Answers):
    first, last = 5, 5


class TestChapters6To9(Answers):
    first, last = 6, 9


class TestChapters10And11(Answers):
    first, last = 10, 11


@pytest.mark.rare
@pytest.mark.filterwarnings('ignore:Callback returned an invalid type')
@pytest.mark.parametrize(('number', 'replacements'), [
    ('7.2c', [("'params_file'", "'param_file'")]),
    ('7.3c', [('20', '2')]),
    ('9c', [("'speed', 0.5", "'speed', 0.0")]),
    ('9c', [('add_post_set', 'add_on_set')]),
])
def test_one_cause_is_reported_once(ros, number, replacements):
    result = exercises.check(number, solution(number, *replacements))
    assert [finding.done for finding in result.findings].count(False) == 1, result
