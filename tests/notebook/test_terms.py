"""The words that are explained where they stand. Tests in JavaScript choose a meaning, and tests in browsers see it."""

import pytest

from param_tutorial.notebook import terms
from param_tutorial.notebook.glossary import Glossary, GlossaryEntry
from tests.support.paths import NOTEBOOKS


def test_words_have_a_meaning_for_each_chapter_and_everyday_ones_have_none():
    words = terms.words_of(Glossary(GlossaryEntry(*each, 'x.ipynb') for each in (
        ('snapshot', 'an early one', '2'), ('snapshot', 'its own', '10.2'), ('to declare', 'to create', '3'),
        ('`await`', 'wait', '5.3'), ('left', 'not changed', '1'))))
    assert words.keys() == {'snapshot', 'declare', 'await'}
    assert words['snapshot'] == [
        {'chapter': '2', 'code': False, 'meaning': '<b>snapshot</b> · an early one (chapter 2)'},
        {'chapter': '10.2', 'code': False, 'meaning': '<b>snapshot</b> · its own (chapter 10.2)'}]
    assert words['await'] == [
        {'chapter': '5.3', 'code': True, 'meaning': '<b><code>await</code></b> · wait (chapter 5.3)'}]


@pytest.mark.parametrize(('folder', 'is_explained'), [(NOTEBOOKS, True), (NOTEBOOKS / 'images', False)])
def test_a_notebook_among_the_chapters_has_them(monkeypatch, folder, is_explained):
    monkeypatch.setattr(terms, '_terms', None)
    monkeypatch.chdir(folder)
    terms.begin()
    assert (terms._terms is not None) is is_explained
