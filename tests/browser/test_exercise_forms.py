"""The forms in which a page's readers answer exercises: what they say is what the exercise's check says."""

import ast
import functools
import html

import nbformat
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from playwright.sync_api import expect

from param_tools.markup.scripts import bundle
from param_tutorial.exercises import EXERCISES
from param_tutorial.exercises.forms import Blanks, Combination, Order
from param_tutorial.exercises.results import markup
from param_tutorial.site.pages import forms
from param_tutorial.site.recording import answers
from tests.support.paths import NOTEBOOKS

pytestmark = [
    pytest.mark.slow, pytest.mark.thorough, pytest.mark.usefixtures('ros'),
    pytest.mark.timeout(600),  # 1a and 10.3a are checked with all their settings
]

WITH_FORM = [number for number, exercise in EXERCISES.items() if exercise.form]
PREDICTIONS = [number for number in WITH_FORM if isinstance(EXERCISES[number].form, Blanks)
               and not EXERCISES[number].form.choices and not EXERCISES[number].form.is_text]


def source(number, kind):
    """Return a cell of an exercise: 'exercise' or 'solution'."""
    path = NOTEBOOKS / ('solutions' if kind == 'solution' else '') / f'{EXERCISES[number].chapter}.ipynb'
    return next(cell.source for cell in nbformat.read(path, as_version=4).cells
                if cell.id == f'{kind}-{number.replace(".", "-")}')


@functools.cache
def recorded(number):
    return answers.record(number, source(number, 'exercise'), source(number, 'solution'))


@pytest.fixture
def page_of(browser, tmp_path):
    """Return a function that opens a page with an exercise's form alone, and the scripts of the lessons."""
    context = browser.new_context()
    complaints = []

    def open_page(number, recording=None):
        script = f'<script type="module">{bundle("param_tutorial/site/scripts/main.js")}</script>'
        path = tmp_path / f'{number}.html'
        form = forms.draw(recording or recorded(number), EXERCISES[number].title)
        path.write_text(f'<!doctype html><meta charset="utf-8"><title>A form</title>{form}{script}', encoding='utf-8')
        page = context.new_page()
        page.on('pageerror', lambda error: complaints.append(str(error)))
        page.goto(path.as_uri())
        page.wait_for_function("document.documentElement.dataset.lesson === 'ready'")
        return page

    yield open_page
    context.close()
    assert complaints == []


def check(page):
    """Press Check, and return the score and what is said to each requirement, as HTML."""
    page.get_by_role('button', name='Check', exact=True).click()
    return page.locator('.rec-score').inner_text(), page.locator('.param-findings > li').evaluate_all(
        'items => items.map(each => each.outerHTML)')


def in_browser(page, text):
    """Return HTML as the browser writes it."""
    return page.evaluate('''text => {
        const list = document.createElement('ul');
        list.innerHTML = text;
        return [...list.children].map(each => each.outerHTML) }''', text)


def fill_in_solution(page, number):
    form = EXERCISES[number].form
    if isinstance(form, Combination):
        right = RIGHT_SETTINGS.get(number) or answers.assigned(source(number, 'solution'))
        for box, value in zip(page.get_by_role('combobox').all(), (right[name] for name in form.choices), strict=True):
            box.select_option(str(value))
        return
    if isinstance(form, Order):
        right, shown = (answers.assigned(source(number, kind)) for kind in ('solution', 'exercise'))
        if form.letters:
            shown, right = list(form.letters), list(right)
        elif isinstance(shown, str):
            shown, right = (text.strip('\n').splitlines() for text in (shown, right))
        for at, line in enumerate(right):
            up = page.locator(f'.rec-lines [data-line="{shown.index(line)}"]').get_by_role('button', name='Up:')
            while page.locator('.rec-lines li').nth(at).get_attribute('data-line') != str(shown.index(line)):
                up.click()
        return
    right = answers.assigned(source(number, 'solution'))
    if isinstance(right, str):
        right = dict(zip(form.guesses, right.strip('\n').splitlines(), strict=True))
    for control, name in zip(page.locator('.rec-field :is(input, select)').all(), form.guesses, strict=True):
        if form.choices:
            control.select_option(str(right[name]))
        else:
            control.fill(right[name] if form.is_text else repr(right[name]))


# Of an exercise whose solution is a function.
RIGHT_SETTINGS = {'11f': {'max_speed_mps': 2.0, 'max_acceleration_mps2': 1.0, 'How are they sent?': 'in one request'}}


@pytest.mark.parametrize('number', WITH_FORM)
def test_a_form_is_not_content_at_first_and_is_with_the_solution(page_of, number):
    page = page_of(number)
    count = len(EXERCISES[number].requirements)
    score, said = check(page)
    assert score.startswith(f'Exercise {number}: not yet, ') and len(said) == count
    fill_in_solution(page, number)
    expect(page.locator('.rec-verdict')).to_be_hidden()
    assert check(page)[0] == f'Exercise {number}: done, {count} of {count} done'


@pytest.mark.parametrize('number', PREDICTIONS)
def test_what_is_said_to_a_value_that_nobody_tried_is_what_the_check_says(page_of, number):
    page, exercise = page_of(number), EXERCISES[number]
    names = list(exercise.form.guesses)
    for value in (7, -3, 12.75, 'nonsense', "it's", '<b>', ['a', 'b'], [1.5], True, None, []):
        for box in page.get_by_role('textbox').all():
            box.fill(repr(value))
        expected = ''.join(markup(each) for each in exercise.check(dict.fromkeys(names, value)).findings)
        assert check(page)[1] == in_browser(page, expected), value


@pytest.fixture(scope='module')
def read_value(browser):
    """Return a function that reads a text as the page's script does: the value as Python shows it, and its type."""
    page = browser.new_page()
    script = f'{bundle("param_tutorial/site/scripts/python_value.js")}\nwindow.readPythonValue = readPythonValue;'
    page.add_script_tag(type='module', content=script)
    yield functools.partial(page.evaluate, 'text => readPythonValue(text)')
    page.close()


def test_python_values_are_read_as_python_reads_them(read_value):
    doubles = st.floats(-1e9, 1e9).map(lambda number: round(number, 3))
    plain = st.one_of(st.integers(), doubles, st.booleans(), st.none())
    letters = st.characters(codec='utf-8', exclude_characters='\\"', exclude_categories=['C', 'Z']) | st.just(' ')

    @settings(deadline=None, suppress_health_check=list(HealthCheck))
    @given(st.one_of(plain, st.text(letters), st.lists(plain, max_size=3)))
    def read(value):
        found = read_value(f' {value!r} ')
        assert (found['text'], found['type']) == (repr(value), type(value).__name__)

    read()


@pytest.mark.parametrize(('typed', 'shown'), [
    ('.5', '0.5'), ('5.', '5.0'), ('1e2', '100.0'), ('+7', '7'), ('1_000', '1000'), ('-0.50', '-0.5'), ("''", "''"),
    ('"old"', "'old'"), ("['dock',]", "['dock']"), ('("a", "b")', "['a', 'b']"), ('[1,2.0 ]', '[1, 2.0]'),
    ('( )', '[]')])
def test_other_ways_to_write_a_value(read_value, typed, shown):
    means = ast.literal_eval(typed)
    assert repr(list(means) if isinstance(means, tuple) else means) == shown
    assert read_value(typed)['text'] == shown


@pytest.mark.parametrize('typed', ['dead', '007', "'dead", '1,5', '[1, x]', '5 m', "it's", '[[1], x]', '{}', '1__0'])
def test_what_is_no_value_is_said_to_be_none(page_of, typed):
    page = page_of('7.2c')
    page.get_by_role('textbox').first.fill(typed)
    _, said = check(page)
    assert html.unescape(said[0]).endswith(
        f"<dd>“{typed}” is no Python value that this form knows. Words stand in quotes, as in 'old'.</dd></dl></li>")


def test_a_text_that_nobody_tried_is_said_to_be_unknown(page_of):
    page = page_of('5.1a')
    page.get_by_role('textbox').first.fill('"a rare one"')
    score, said = check(page)
    assert 'not tried' in said[0] and 'Run the notebook to try it.' in said[0]
    assert score == 'Exercise 5.1a: not yet, 0 of 6 done'


def test_an_answer_in_another_window_appears_in_this_one(page_of):
    recording = recorded('7.3a')
    here, there = page_of('7.3a', recording), page_of('7.3a', recording)
    fill_in_solution(there, '7.3a')
    check(there)
    expect(here.locator('.rec-score')).to_have_text('Exercise 7.3a: done, 2 of 2 done')
    # What was right once stays so.
    there.get_by_role('button', name='Down:').first.click()
    assert 'not yet' in check(there)[0]
    there.reload()
    expect(there.locator('.rec-score')).to_have_text('Exercise 7.3a: done, 2 of 2 done')


def test_every_letter_of_an_order_means_what_the_chapter_says():
    path = NOTEBOOKS / f'{EXERCISES["5.2c"].chapter}.ipynb'
    text = ''.join(cell.source for cell in nbformat.read(path, as_version=4).cells)
    for letter, happens in EXERCISES['5.2c'].form.letters.items():
        assert f'\n- {letter}: {happens}\n' in text
