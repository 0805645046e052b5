"""The widget of a prediction keeps an answer, and gives the verdict only after the next cell has run."""

import pytest
from ipywidgets.widgets.widget import _instances as widget_registry

from param_tutorial import exercises
from param_tutorial.exercises import RECALLS
from param_tutorial.exercises.predicting import PredictionView
from param_tutorial.exercises.prediction import MIME_TYPE, Prediction, Scale, right, wrong
from param_tutorial.notebook import veil

CHOICE = Prediction('1-1', 'What is `1`?', (wrong('a text', 'It is a `number`.'), right('a number', 'So it is.')))
TYPED = Prediction('1-2', 'How many?', (right('150', 'Yes.'), wrong('100', 'More.')), otherwise='It is 150.')
MARKED = Prediction('1-3', 'How far?', (right('0', 'Yes.'), wrong('5', 'Less.')), otherwise='It is 0.',
                    scale=Scale(0, 10, 0.1, 'm', tolerance=0.1))


@pytest.fixture
def remembered():
    """Return a list of what a prediction has remembered, each as (number, answer, is_right)."""
    return []


@pytest.fixture
def ask(remembered):
    """Return a function that shows a prediction."""
    return lambda prediction=CHOICE: PredictionView(
        prediction, lambda *answer: remembered.append(answer) or 'The disk is full.')


@pytest.mark.parametrize('prediction', [CHOICE, TYPED])
def test_the_text_in_its_place_does_not_give_the_answer_away(ask, prediction):
    view = ask(prediction)
    before, _ = view._repr_mimebundle_()
    view.commit(prediction.choices[0].text)
    after, _ = view._repr_mimebundle_()
    assert before['text/plain'] == after['text/plain'] == repr(view)
    assert not any(each.sentence in before['text/plain'] for each in prediction.choices)
    assert before[MIME_TYPE] == {'number': prediction.number}


def test_a_closed_question_leaves_nothing_with_ipywidgets(ask):
    before = set(widget_registry)
    view = ask()
    assert set(widget_registry) > before
    view.close()
    assert set(widget_registry) == before


@pytest.mark.parametrize(('prediction', 'answer', 'is_right'), [
    (CHOICE, 'a number', True), (CHOICE, 'a text', False), (TYPED, '150', True), (TYPED, '99 rpm', False)])
def test_an_answer_is_locked_and_remembered(ask, remembered, prediction, answer, is_right):
    view = ask(prediction)
    view.commit(answer)
    view.commit(prediction.choices[0].text)
    assert remembered == [(prediction.number, answer, is_right)]
    assert view.answer == answer and view.note == 'The disk is full.'
    assert view.is_decided  # at once, where there are no cells


def test_a_marker_near_a_choice_means_that_choice_and_is_told_as_it_was_put(ask, remembered, bare_ipython, capsys):
    bare_ipython.user_ns['ask'] = ask
    bare_ipython.user_ns['view'] = view = ask(MARKED)
    assert '(put a marker between 0 and 10 m)' in repr(view)
    view.commit('0.1', '0')
    bare_ipython.run_cell('1')
    assert remembered == [('1-3', '0', True)]
    assert capsys.readouterr().out.endswith('You predicted: 0.1 m\n✓ Right. Yes.\n')


def test_a_wrong_answer_is_told_the_right_one_unless_its_sentence_says_it():
    told = [MARKED.words_for(MARKED.choice(each)) for each in ('0', '5', '7')]
    assert told == ['Yes.', 'Less. The answer is “0 m”.', 'It is 0.']


def test_a_recall_is_decided_at_once(bare_ipython):
    assert exercises.recall(next(iter(RECALLS))).is_decided
    assert not exercises.predict('6.1-1').is_decided


def test_verdict_and_veil_wait_for_the_next_cell_and_one_stands_below_its_output(
        ask, bare_ipython, capsys, monkeypatch):
    bare_ipython.user_ns['ask'] = ask
    bare_ipython.run_cell('view = ask()')
    view = bare_ipython.user_ns['view']
    lifted = []
    monkeypatch.setattr(veil, 'lift', lifted.append)
    view.commit('a text')
    assert (view.is_decided, lifted) == (False, [])
    capsys.readouterr()
    bare_ipython.run_cell('print("the output")')
    assert (view.is_decided, view.is_told_below, lifted) == (True, True, ['1-1'])
    assert capsys.readouterr().out == ('the output\nYou predicted: a text\n'
                                       '✗ Not so. It is a `number`. The answer is “a number”.\n')
    bare_ipython.run_cell('print("another")')
    assert capsys.readouterr().out == 'another\n'


def test_one_committed_while_a_cell_runs_is_decided_when_that_cell_ends(ask, bare_ipython):
    bare_ipython.user_ns['view'] = view = ask()
    bare_ipython.run_cell("view.commit('a number'); decided = view.is_decided")
    assert (bare_ipython.user_ns['decided'], view.is_decided) == (False, True)
    # A cell that ended earlier does not count for the next prediction.
    assert not ask(TYPED).is_decided


def test_a_cell_that_shows_another_prediction_decides_nothing(ask, bare_ipython):
    bare_ipython.user_ns['ask'] = lambda: ask(TYPED)
    first = ask()
    bare_ipython.run_cell('another = ask()')
    assert not first.is_decided
    bare_ipython.run_cell('1 / 0')
    assert first.is_decided and bare_ipython.user_ns['another'].is_decided


def test_a_cell_that_runs_again_goes_on_with_what_was_committed(ask, remembered, bare_ipython):
    bare_ipython.user_ns['ask'] = ask
    bare_ipython.run_cell('view = ask()')
    bare_ipython.user_ns['view'].commit('a number')
    bare_ipython.run_cell('view = ask()')
    again = bare_ipython.user_ns['view']
    assert (again.answer, again.note, again.is_decided) == ('a number', 'The disk is full.', False)
    bare_ipython.run_cell('1')
    assert again.is_decided and len(remembered) == 1
    # A prediction that has been answered can be tried again.
    bare_ipython.run_cell('view = ask()')
    assert bare_ipython.user_ns['view'].answer == ''
