"""A changed chapter comes into a learner's copy: cell by cell, and nothing of the learner's is lost."""

from collections import Counter
from collections.abc import Sequence

import nbformat
import pytest
from hypothesis import given
from hypothesis import strategies as st
from nbformat.notebooknode import NotebookNode

from param_tutorial.learner.merging import NOTE, merge

# An id, a text; the text of a Markdown cell begins with #.
Cell = tuple[str, str]
BASE = (('a', '# Title'), ('b', 'speed = 1'), ('c', '# Now change it:'), ('d', 'robot.drive(speed)'))


def notebook(cells: Sequence[Cell]) -> NotebookNode:
    return nbformat.v4.new_notebook(cells=[
        (nbformat.v4.new_markdown_cell if text.startswith('#') else nbformat.v4.new_code_cell)(text, id=each)
        for each, text in cells])


def merged(base: Sequence[Cell], copy: Sequence[Cell], chapter: Sequence[Cell]) -> list[Cell]:
    result = merge(notebook(base), notebook(copy), notebook(chapter))
    nbformat.validate(result)
    return [(cell.id, cell.source) for cell in result.cells]


def texts(cells: Sequence[Cell]) -> list[str]:
    return [text for _, text in cells]


def changed(cells: Sequence[Cell], **new: str | None) -> list[Cell]:
    """Return cells with other texts for these ids, and without those whose text is None."""
    return [(each, new.get(each, text)) for each, text in cells if new.get(each, text) is not None]


def test_a_cell_that_the_learner_left_alone_follows_the_chapter():
    assert merged(BASE, BASE, changed(BASE, b='speed = 2', c=None)) == changed(BASE, b='speed = 2', c=None)


def test_a_cell_that_the_chapter_left_alone_stays_as_the_learner_has_it():
    assert merged(BASE, changed(BASE, b='speed = 99', c=None), BASE) == changed(BASE, b='speed = 99', c=None)


def test_each_change_stands_in_its_own_cell():
    copy, chapter = changed(BASE, b='speed = 99'), changed(BASE, d='robot.drive(speed, lights=True)')
    assert merged(BASE, copy, chapter) == changed(chapter, b='speed = 99')


@pytest.mark.parametrize(('cell', 'mine', 'new', 'told'), [
    ('b', 'speed = 99', 'speed = 2', '~~~~python\nspeed = 2\n~~~~'),
    ('c', '# I have changed it', '# Now change it twice:', '# Now change it twice:'),
])
def test_where_both_changed_a_cell_the_new_text_follows_in_a_note(cell, mine, new, told):
    result = merged(BASE, changed(BASE, **{cell: mine}), changed(BASE, **{cell: new}))
    number = result.index((cell, mine))
    assert result.pop(number + 1)[1] == NOTE + told
    assert result == changed(BASE, **{cell: mine})


def test_a_note_is_made_once():
    copy, chapter = changed(BASE, b='speed = 99'), changed(BASE, b='speed = 2')
    first = merged(BASE, copy, chapter)
    assert merged(chapter, first, changed(chapter, d='stop()')) == changed(first, d='stop()')


def test_the_same_change_on_both_sides_is_one():
    both = changed(BASE, b='speed = 2')
    assert merged(BASE, both, both) == both


def test_a_changed_cell_stays_when_the_chapter_drops_it():
    result = merged(BASE, changed(BASE, b='speed = 99'), changed(BASE, b=None))
    assert texts(result) == ['# Title', 'speed = 99', '# Now change it:', 'robot.drive(speed)']


def test_a_removed_cell_comes_back_when_the_chapter_changes_it():
    chapter = changed(BASE, b='speed = 2')
    assert merged(BASE, changed(BASE, b=None), chapter) == chapter


def test_the_learners_own_cells_stay_after_those_that_they_followed():
    copy = [('mine-1', 'first'), *BASE[:2], ('mine-2', 'second'), *BASE[2:], ('mine-3', 'last')]
    chapter = [('new-1', '# Before all'), *BASE[:2], ('new-2', 'also_new()'), *BASE[2:]]
    assert texts(merged(BASE, copy, chapter)) == [
        'first', '# Before all', '# Title', 'speed = 1', 'second', 'also_new()', '# Now change it:',
        'robot.drive(speed)', 'last']


def test_an_own_cell_after_a_dropped_one_stays_in_its_place():
    copy = [*BASE[:2], ('mine', 'print(speed)'), *BASE[2:]]
    assert texts(merged(BASE, copy, changed(BASE, b=None))) == [
        '# Title', 'print(speed)', '# Now change it:', 'robot.drive(speed)']


def numbered(all_texts: Sequence[str]) -> list[Cell]:
    """Return cells with the ids that the chapters give them: their numbers."""
    return [(f'cell-{number:02}', text) for number, text in enumerate(all_texts)]


def test_one_more_cell_gives_new_ids_to_all_that_follow_and_is_still_one_more_cell():
    base = numbered(texts(BASE))
    copy = [*base[:1], ('cell-01', 'speed = 99'), *base[2:], ('mine', 'own()')]
    chapter = numbered(['# Title', 'import robot', *texts(BASE)[1:]])
    assert merged(base, copy, chapter) == [*chapter[:2], ('cell-02', 'speed = 99'), *chapter[3:], ('mine', 'own()')]


def test_an_editor_that_gives_new_ids_to_all_cells_does_no_harm():
    copy = [(f'other-{each}', text) for each, text in changed(BASE, b='speed = 99')]
    chapter = changed(BASE, d='robot.drive(speed, lights=True)')
    assert merged(BASE, copy, chapter) == changed(chapter, b='speed = 99')


def test_line_ends_alone_are_no_change():
    base = [('a', '# Title'), ('b', 'speed = 1\nturn = 2')]
    copy = [('a', '# Title'), ('b', 'speed = 1\r\nturn = 2\r\n')]
    assert merged(base, copy, changed(base, b='speed = 2')) == changed(base, b='speed = 2')


def test_outputs_stay_with_a_cell_that_has_not_changed_and_go_with_one_that_has():
    base, copy, chapter = notebook(BASE), notebook(BASE), notebook(changed(BASE, d='stop()'))
    for number, cell in enumerate(cell for cell in copy.cells if cell.cell_type == 'code'):
        cell.execution_count, cell.outputs = number + 1, [nbformat.v4.new_output('stream', text='drove')]
    result = merge(base, copy, chapter)
    assert [(cell.execution_count, len(cell.outputs)) for cell in result.cells if cell.cell_type == 'code'] == [
        (1, 1), (None, 0)]


# So few texts that the same one often occurs twice, and so alike that cells are often taken for one another.
some_texts = st.lists(st.sampled_from(['', '# one', '# one two', 'one', 'one two', 'one two three', 'four five']),
                      max_size=6)


@st.composite
def edited(draw: st.DrawFn, cells: list[Cell], words: str, new_id: str) -> list[Cell]:
    """Change, remove, move and add cells."""
    result = list(cells)
    for number in range(draw(st.integers(0, 5))):
        where = draw(st.integers(0, len(result)))
        what = draw(st.sampled_from(['add', 'change', 'remove', 'move']))
        text = draw(st.sampled_from(['', '# '])) + draw(st.sampled_from(['one', 'one two', ''])) + f' {words}{number}'
        if what == 'add' or not cells or where == len(result):
            result.insert(where, (f'{new_id}-{number}', text))
        elif what == 'change':
            result[where] = result[where][0], text
        elif what == 'remove':
            del result[where]
        else:
            result.insert(0, result.pop(where))
    return result


@st.composite
def histories(draw: st.DrawFn) -> tuple[list[Cell], list[Cell], list[Cell]]:
    base = numbered(draw(some_texts))
    copy = draw(edited(base, 'mine', 'mine'))
    chapter = draw(edited(base, draw(st.sampled_from(['theirs', 'mine'])), 'new'))
    return base, copy, numbered(texts(chapter)) if draw(st.booleans()) else chapter


@pytest.mark.slow
@given(histories())
def test_nothing_of_the_learners_is_lost_and_nothing_new_is_missing(history):
    base, copy, chapter = history
    result = merged(base, copy, chapter)
    work = Counter(text for text in texts(copy) if text not in texts(base))
    assert work <= Counter(texts(result))
    for text in texts(chapter):
        assert text in texts(base) or any(text in each for each in texts(result))
    assert len({each for each, _ in result}) == len(result)


@pytest.mark.slow
@given(histories())
def test_where_one_side_did_nothing_the_other_one_is_the_result(history):
    base, copy, chapter = history
    assert merged(base, base, chapter) == chapter
    assert Counter(texts(merged(base, copy, base))) == Counter(texts(copy))


@pytest.mark.slow
@given(histories())
def test_a_chapter_that_is_in_the_copy_already_changes_it_no_more(history):
    base, copy, chapter = history
    once = merged(base, copy, chapter)
    assert Counter(texts(merged(chapter, once, chapter))) == Counter(texts(once))
