"""Bring a changed chapter into a learner's copy of it. Notebooks in, a notebook out; no files.

Three notebooks take part: the *base*, which the learner was given; the learner's *copy*, made from it; and the
*chapter* as it is now. Whatever the learner wrote is in the result.
"""

import difflib
import uuid
from collections import defaultdict
from collections.abc import Iterable

import nbformat
from nbformat.notebooknode import NotebookNode

NOTE = ('*The course has changed the cell above since you edited it. Your text stays as it is. '
        'This is the new one:*\n\n')
# Two cells at least this much alike, of 1, are taken for two versions of one cell. The same id counts for as much: the
# chapters number their cells, so one more cell gives a new id to each that follows.
_ALIKE = 0.5


def merge(base: NotebookNode, copy: NotebookNode, chapter: NotebookNode) -> NotebookNode:
    """Return the chapter with the learner's work in it.

    A cell that only the chapter changed, or removed, follows the chapter. One that only the learner changed, or
    removed, stays as the learner has it. Where both changed a cell, the learner's stays and the new text follows in a
    note. The learner's own cells stay after the cell that they followed.
    """
    copied, revised = pair(base.cells, copy.cells), pair(base.cells, chapter.cells)
    own = _own_cells(base, copy, copied, revised)
    first_version = {number: first for first, number in revised.items()}
    cells = own[-1]
    for number, new in enumerate(chapter.cells):
        first = first_version.get(number, -1)
        old = base.cells[first] if first >= 0 else None
        cells += _versions(old, copy.cells[copied[first]] if first in copied else None, new) + own[number]
    return NotebookNode(chapter, metadata=copy.metadata | chapter.metadata, cells=_with_one_id_each(cells))


def pair(old: list[NotebookNode], new: list[NotebookNode]) -> dict[int, int]:
    """Return which of the new cells each of the old ones has become; cells are given by their numbers."""
    blocks = difflib.SequenceMatcher(None, [*map(_text, old)], [*map(_text, new)], autojunk=False)
    pairs = {block.a + i: block.b + i for block in blocks.get_matching_blocks() for i in range(block.size)}
    left, right = set(range(len(old))) - pairs.keys(), set(range(len(new))) - {*pairs.values()}
    candidates = ((_likeness(old[a], new[b]), a, b) for a in left for b in right)
    for likeness, a, b in sorted(candidates, key=lambda each: (-each[0], each[1:])):
        if likeness >= _ALIKE and a in left and b in right:
            pairs[a] = b
            left.remove(a)
            right.remove(b)
    return pairs


def _own_cells(base: NotebookNode, copy: NotebookNode, copied: dict[int, int],
               revised: dict[int, int]) -> defaultdict[int, list[NotebookNode]]:
    """Return the cells that are now the learner's alone, by the number of the chapter's cell that they follow."""
    given = {number: first for first, number in copied.items()}
    own, follows = defaultdict(list), -1
    for number, cell in enumerate(copy.cells):
        first = given.get(number)
        if first in revised:
            follows = revised[first]
        elif first is None or not _same(cell, base.cells[first]):
            own[follows].append(cell)
    return own


def _versions(old: NotebookNode | None, mine: NotebookNode | None, new: NotebookNode) -> list[NotebookNode]:
    """Return what one cell of the chapter becomes in the learner's copy."""
    if mine is None:
        # The chapter has added the cell, or the learner has removed it.
        return [] if old is not None and _same(old, new) else [new]
    if _same(mine, new):
        kept = {key: mine[key] for key in ('outputs', 'execution_count', 'attachments') if key in mine}
        return [NotebookNode(new, **kept, metadata=mine.metadata | new.metadata)]
    if old is not None and _same(mine, old):
        return [new]
    kept_cell = NotebookNode(mine, id=new.id)
    return [kept_cell] if old is not None and _same(old, new) else [kept_cell, _note(new)]


def _note(new: NotebookNode) -> NotebookNode:
    """Return the new text of a cell, to read and not to run: the learner's text is the one that counts."""
    text = new.source if new.cell_type == 'markdown' else f'~~~~python\n{new.source}\n~~~~'
    note: NotebookNode = nbformat.v4.new_markdown_cell(NOTE + text)
    return note


def _text(cell: NotebookNode) -> tuple[str, ...]:
    """Return the type of a cell and its lines, whichever characters end them."""
    return cell.cell_type, *cell.source.splitlines()


def _same(one: NotebookNode, other: NotebookNode) -> bool:
    return _text(one) == _text(other)


def _likeness(old: NotebookNode, new: NotebookNode) -> float:
    if old.cell_type != new.cell_type:
        return 0.0
    words = difflib.SequenceMatcher(None, old.source.split(), new.source.split(), autojunk=False).ratio()
    return words + (_ALIKE if old.get('id') == new.get('id') else 0.0)


def _with_one_id_each(cells: Iterable[NotebookNode]) -> list[NotebookNode]:
    """Return the cells with a new id for each that has none, or one that an earlier cell has."""
    seen: set[str] = set()
    found = []
    for cell in cells:
        if 'id' not in cell or cell.id in seen:
            cell = NotebookNode(cell, id=uuid.uuid4().hex[:8])  # noqa: PLW2901
        seen.add(cell.id)
        found.append(cell)
    return found
