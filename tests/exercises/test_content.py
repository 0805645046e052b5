"""The chapters and the data of their exercises and questions agree."""

import ast
import functools
import inspect
import itertools
import re

import nbformat
import pytest

from param_tutorial.exercises import CHAPTERS, EXERCISES, PREDICTIONS, RECALLS
from param_tutorial.exercises.chapters import ch06_2
from param_tutorial.exercises.prediction import MIME_TYPE
from tests.support.answers import blank, notebook
from tests.support.paths import NOTEBOOKS


@functools.cache
def cells_of(chapter):
    return nbformat.read(NOTEBOOKS / f'{chapter.name}.ipynb', as_version=4).cells


def headings(chapter):
    texts = '\n'.join(cell.source for cell in cells_of(chapter) if cell.cell_type == 'markdown')
    return re.findall(r'^#+ (.*)$', texts, re.MULTILINE)


def of_each_chapter(test):
    return pytest.mark.parametrize('chapter', CHAPTERS.values(), ids=lambda each: each.number)(test)


@of_each_chapter
def test_exercises_have_the_titles_of_the_chapter_and_lead_to_its_sections(chapter):
    found = headings(chapter)
    assert [each for each in found if re.match(r'[\d.]+[a-z] · ', each)] == [
        f'{each.number} · {each.title}' for each in chapter.exercises]
    for exercise in chapter.exercises:
        assert {requirement.see for requirement in exercise.requirements} <= {*found}
        assert len(exercise.hints) >= 2


@of_each_chapter
def test_each_prediction_stands_before_a_cell_that_decides_it(chapter):
    found = []
    for cell, after in itertools.pairwise(cells_of(chapter)):
        for output in cell.get('outputs', ()):
            if MIME_TYPE in output.get('data', {}) and 'exercises.recall(' not in cell.source:
                found.append(output.data[MIME_TYPE]['number'])
                assert cell.source.endswith(f"exercises.predict('{found[-1]}')")
                assert after.cell_type == 'code', f'nothing decides {found[-1]}'
    assert found == [each.number for each in chapter.predictions]
    assert found == [f'{chapter.number}-{position}' for position in range(1, len(found) + 1)]


@of_each_chapter
def test_from_chapter_4_on_two_questions_are_about_earlier_ones(chapter):
    order = list(CHAPTERS)
    assert len(chapter.recalls) == (2 if order.index(chapter.number) >= order.index('4') else 0)
    asked = re.findall(r"exercises\.recall\('(.*?)'\)", '\n'.join(each.source for each in cells_of(chapter)))
    assert asked == [each.number for each in chapter.recalls]
    for each in chapter.recalls:
        assert order.index(each.chapter) < order.index(chapter.number)
        assert each.section in headings(CHAPTERS[each.chapter])


@of_each_chapter
def test_each_chapter_ends_with_its_progress(chapter):
    cells = cells_of(chapter)
    cell, = (each for each in cells if each.id == 'progress')
    assert cell.source == f"exercises.progress('{chapter.number}')"
    assert cells.index(cell) > max(index for index, each in enumerate(cells) if each.id.startswith('check-'))


def test_each_question_has_one_right_answer_and_a_sentence_for_each():
    for question in (*PREDICTIONS.values(), *RECALLS.values()):
        texts = [each.text for each in question.choices]
        assert sum(each.is_right for each in question.choices) == 1, question.number
        assert len({*texts}) == len(texts) >= 2, question.number
        assert all(each.sentence.endswith(('.', '?')) for each in question.choices), question.number


def test_no_option_carries_a_reason():
    reason = re.compile(r': | because |, (?:since|so) ')
    assert not [f'{each.number}: {choice.text}' for each in (*PREDICTIONS.values(), *RECALLS.values())
                for choice in each.choices if reason.search(choice.text)]


# What a reader can pick by without thinking: the option in which this is the smallest, given its place and its text.
LOOKS = {
    'the shortest': lambda _, text: len(text), 'the longest': lambda _, text: -len(text),
    'the one without a comma': lambda _, text: ',' in text, 'the first': lambda place, _: place,
    'the second': lambda place, _: place != 1, 'the last': lambda place, _: -place}


@pytest.mark.parametrize('look', LOOKS)
def test_the_look_of_an_option_wins_at_most_ten_points_more_than_chance(look):
    gains, leads = [], {}
    for question in (each for each in (*PREDICTIONS.values(), *RECALLS.values()) if not each.is_number):
        by_look = [LOOKS[look](place, each.text) for place, each in enumerate(question.choices)]
        right, = (key for key, each in zip(by_look, question.choices, strict=True) if each.is_right)
        gains.append((right == min(by_look)) / by_look.count(right) - 1 / len(by_look))
        if gains[-1] > 0:
            leads[question.number] = min(key for key in by_look if key > right) - right
    points = 100 * sum(gains) / len(gains)
    plainest = sorted(leads, key=leads.get, reverse=True)[:12]
    assert points <= 10, f'{look} wins {points:.0f} points more than chance, most plainly in {", ".join(plainest)}'


def test_a_prediction_is_asked_for_in_the_words_of_the_check():
    for number in ('5.4b', '6.2c'):
        assert [f'`{question}`' for question in blank(number)] == [
            requirement.sentence for requirement in EXERCISES[number].requirements]


def test_the_oven_in_the_chapter_is_the_one_that_the_check_asks():
    shown = [each.source for each in notebook('6.2c') if each.source.startswith('class Oven')]
    assert [without_annotations(each) for each in shown] == [without_annotations(inspect.getsource(ch06_2.Oven))]


def without_annotations(source):
    """Return source code as a chapter has it, where nothing is annotated."""
    tree = ast.parse(source)
    for each in ast.walk(tree):
        if isinstance(each, ast.FunctionDef):
            each.returns = None
        elif isinstance(each, ast.arg):
            each.annotation = None
    return ast.unparse(tree)
