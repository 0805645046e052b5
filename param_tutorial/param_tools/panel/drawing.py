"""A parameter panel as HTML: each parameter's name, control and description, in groups that fold.

``panel.js`` brings it to life, in JupyterLab and on a page of the website alike; without a script it still
shows what the node had.
"""

import html
import itertools
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from param_tools.markup.tables import table
from param_tools.markup.wording import format_count

HOUSEKEEPING = 'In every node'
"""The group of what every node has, which is seldom what one came for."""

CHECK, TEXT, LINES, CHOICE = 'check', 'text', 'lines', 'choice'

# With so many parameters one searches; with so many housekeeping ones, they are folded away.
_SEARCH_FROM = 13
_FOLD_HOUSEKEEPING_FROM = 7

_BAR = ('<div class="param-bar" hidden><span class="param-gathered" role="status"></span>'
        '<button type="button" class="param-apply">Apply together</button>'
        '<button type="button" class="param-discard">Discard</button></div>')


@dataclass(frozen=True)
class PanelRow:
    """One parameter of a panel, but for what changes with its value."""

    name: str
    editor: str
    """CHECK for a check box, TEXT for one line, LINES for several, CHOICE for a list to choose from."""
    kind: str
    """The name of its type, e.g. ``'double'``."""
    description: str = ''
    constraints: str = ''
    facts: tuple[str, ...] = ()
    """What its descriptor says beside the type, e.g. its range."""
    choices: tuple[str, ...] = ()
    takes_others: bool = False
    """True if the choices are only a suggestion, and another text can be typed."""
    last: int | None = None
    """The last position of its slider, counted from 0; None if it has none."""
    is_read_only: bool = False
    is_quiet: bool = False
    """True for what every node has."""
    unit: str = ''
    """The unit of its numbers, where that is known."""

    @property
    def is_number(self) -> bool:
        """True if a short box is wide enough for it."""
        return self.kind in ('integer', 'double')


@dataclass
class RowState:
    """What a panel shows of a parameter's value."""

    text: str
    position: int | None = None
    """Where its slider stands."""
    is_locked: bool = False
    is_busy: bool = False
    """True while the node has been asked for another value; the control shows what was entered until then."""
    message: tuple[str, str] | None = None
    """What to say beside the control: 'rejected', 'failed', 'waiting', 'adjusted' or 'locked', and the words."""
    first: str | None = None
    """What it had at first, if that is something else."""
    is_gathered: bool = False
    """True if the text is what the node will be asked for together with other changes."""
    items: list[str] | None = None
    """The elements of an array that can be edited one by one; None for anything else."""

    def as_json(self) -> dict[str, Any]:
        """Return it as the script takes it: with what is other than usual."""
        usual = vars(RowState(self.text))
        return {'text': self.text} | {name: value for name, value in vars(self).items() if value != usual[name]}


@dataclass
class _Group:
    rows: list[PanelRow] = field(default_factory=list)
    groups: dict[str, '_Group'] = field(default_factory=dict)

    def flat(self) -> list[PanelRow]:
        """Return all rows as they stand on the page."""
        return self.rows + [row for group in self.groups.values() for row in group.flat()]


def _tree(rows: Iterable[PanelRow]) -> _Group:
    """Put rows into groups by what stands before the dots of their names, and what every node has last."""
    root, last = _Group(), _Group()
    for row in rows:
        group = last if row.is_quiet else root
        for part in () if row.is_quiet else row.name.split('.')[:-1]:
            group = group.groups.setdefault(part, _Group())
        group.rows.append(row)
    if last.rows:
        # No parameter's name has a blank in it.
        root.groups[HOUSEKEEPING] = last
    return root


def arrange(rows: Iterable[PanelRow]) -> list[PanelRow]:
    """Return rows in the order of the page: groups after what is in none, and what every node has last."""
    return _tree(rows).flat()


def panel_markup(node: str, rows: Sequence[PanelRow], states: Mapping[str, RowState], *, status: str = '',
                 in_order: bool = False, tools: bool = True) -> str:
    """Return a panel as HTML; its style sheet is ``panel.css``. Each id begins with what ``panel_widget.js`` replaces.

    :param node: The node's fully qualified name.
    :param states: By the parameters' names.
    :param status: Why nothing can be changed now; empty if it can.
    :param in_order: True if the rows stay as they stand, with a heading wherever another group begins.
    :param tools: Whether its head shows more buttons than *Reset*.
    """
    draw = _Drawing(states, is_locked=bool(status), has_units=any(row.unit for row in rows))
    body = draw.runs(rows) if in_order else draw.content(_tree(rows), '')
    # All sliders begin where that of the longest unit does.
    unit = max((len(row.unit) for row in rows), default=0)
    return (f'{_head(node, len(rows), status, tools=tools)}'
            f'<div class="param-rows" style="--unit:{unit}ch">{body}</div>')


def _head(node: str, count: int, status: str, *, tools: bool) -> str:
    off = '' if tools else ' hidden'
    search = (f'<input type="search" class="param-search" placeholder="Search {count} parameters" '
              f'aria-label="Search the parameters of {html.escape(node)}" autocomplete="off" spellcheck="false">'
              if count >= _SEARCH_FROM else '')
    buttons = ('<span class="param-tools" role="group" aria-label="Changes made here">'
               f'<button type="button" class="param-gather"{off} aria-pressed="false" disabled '
               'title="Gather changes, and apply them together as one request that the node accepts or rejects '
               'as a whole">Gather</button>'
               f'<button type="button" class="param-undo" disabled{off}>Undo</button>'
               f'<button type="button" class="param-redo" disabled{off}>Redo</button>'
               '<button type="button" class="param-reset" disabled '
               'title="Bring every parameter back to its first value">Reset</button></span>'
               f'<span class="param-tools" role="group" aria-label="Parameter file"{off}>'
               '<button type="button" class="param-save" aria-expanded="false">Save…</button>'
               '<button type="button" class="param-load" aria-expanded="false">Load…</button></span>')
    told = format_count(count, 'parameter')
    bad = ' param-status-bad' if status else ''
    return (f'<div class="param-head"><span role="status"><span class="param-node">{html.escape(node)}</span>'
            f'<span class="param-status{bad}" data-count="{told}">{html.escape(status) or told}</span></span>'
            f'{buttons}{search}<span class="param-found" role="status"></span>{_BAR}</div>')


def file_markup(summary: str, notes: Sequence[str] = (), columns: Sequence[str] = (),
                rows: Sequence[Sequence[str]] = (), *, is_bad: bool = False) -> str:
    """Return what the form for a parameter file says, as HTML.

    :param notes: Sentences below the summary, each on a line of its own.
    :param columns: Headings of the table below them.
    :param rows: The table's words, the verdict in the fourth column; none for no table.
    :param is_bad: True if nothing can be done with the file.
    """
    told = f'<p class="param-message{" param-rejected" if is_bad else ""}">{html.escape(summary)}</p>'
    listed = ''.join(f'<li>{html.escape(note)}</li>' for note in notes)
    tabled = table(columns, rows, row_headers=True) if rows else ''
    # Who has no mouse must be able to scroll it.
    scrolled = (f'<div class="param-file-rows" tabindex="0" role="region" aria-label="What would change">{tabled}'
                '</div>' if tabled else '')
    return told + (f'<ul>{listed}</ul>' if listed else '') + scrolled


class _Drawing:
    """Draws rows and groups, and counts the ids."""

    def __init__(self, states: Mapping[str, RowState], *, is_locked: bool, has_units: bool):
        self._states, self._is_locked, self._has_units = states, is_locked, has_units
        self._count = 0

    def runs(self, rows: Iterable[PanelRow]) -> str:
        """Return rows as they stand, those that follow each other in one group under its heading."""
        parts = []
        for title, run in itertools.groupby(
                rows, lambda row: HOUSEKEEPING if row.is_quiet else row.name.rpartition('.')[0]):
            path = f'{title}.' if title else ''
            content = ''.join(self.row(row, row.name.removeprefix(path)) for row in run)
            parts.append(self.folder(title, content) if title else content)
        return ''.join(parts)

    def content(self, group: _Group, path: str) -> str:
        """Return a group's rows and the groups in it. One that has nothing but one group has no level of its own."""
        parts = [self.row(row, row.name.removeprefix(path)) for row in group.rows]
        for name, each in group.groups.items():
            title, inner = name, each
            while not inner.rows and len(inner.groups) == 1:
                (deeper, inner), = inner.groups.items()
                title = f'{title}.{deeper}'
            is_folded = name == HOUSEKEEPING and len(inner.rows) >= _FOLD_HOUSEKEEPING_FROM
            parts.append(self.folder(title, self.content(inner, f'{path}{title}.'), is_open=not is_folded))
        return ''.join(parts)

    def folder(self, title: str, content: str, *, is_open: bool = True) -> str:
        """Return something that folds, under a heading."""
        return (f'<details class="param-group"{" open" if is_open else ""}><summary>'
                f'<span role="heading" aria-level="4">{html.escape(title)}</span></summary>{content}</details>')

    def row(self, row: PanelRow, label: str) -> str:
        """Return one parameter's row."""
        self._count += 1
        name, state = f'panel-NAME-{self._count}', self._states[row.name]
        off = ' disabled' if row.is_read_only or state.is_locked or self._is_locked else ''
        common = f'id="{name}" class="param-box" aria-describedby="{name}-help {name}-said"{off}'
        kinds = ''.join(f' param-{kind}' for kind, so in (
            ('quiet', row.is_quiet), ('read-only', row.is_read_only), ('long', not row.is_number),
            ('changed', state.first is not None)) if so)
        slider = ('' if row.last is None else
                  f'<input type="range" class="param-slider" autocomplete="off" min="0" max="{row.last}" '
                  f'value="{state.position or 0}" '
                  f'aria-label="{html.escape(label)}, slider" aria-valuetext="{html.escape(state.text)}"{off}>')
        # Where others have a unit, there is room for one, so that the sliders stand one below the other.
        has_room = slider and self._has_units
        unit = f'<span class="param-unit">{html.escape(row.unit)}</span>' if row.unit or has_room else ''
        items = ('' if state.items is None else
                 f'<button type="button" class="param-items" aria-expanded="false" hidden '
                 f'aria-label="Elements of {html.escape(label)}">Elements</button>')
        back = '' if row.is_read_only else '<button type="button" class="param-back" hidden></button>'
        return (f'<div class="param-row{kinds}" data-name="{html.escape(row.name)}" data-editor="{row.editor}">'
                f'<div class="param-line"><label for="{name}" title="{html.escape(row.description)}">'
                f'{html.escape(label)}</label>'
                f'{_box(row, state, common)}{unit}{items}{slider}{back}</div>'
                f'<div class="param-note param-help" id="{name}-help">{_help(row)}</div>'
                f'<div class="param-note" id="{name}-said" data-role="said">{_message(state)}</div></div>')


def _box(row: PanelRow, state: RowState, common: str) -> str:
    text = html.escape(state.text)
    if row.editor == CHECK:
        return f'<input type="checkbox" autocomplete="off" {common}{" checked" if state.text == "true" else ""}>'
    if row.editor == LINES:
        return f'<textarea rows="3" autocomplete="off" spellcheck="false" {common}>{text}</textarea>'
    if row.editor == CHOICE:
        options = ''.join(f'<option{" selected" if each == state.text else ""}>{html.escape(each)}</option>'
                          for each in dict.fromkeys((*row.choices, state.text)))
        if row.takes_others:
            options += '<option data-other>Other…</option>'
        return f'<select autocomplete="off" {common}>{options}</select>'
    unset = '' if state.text else ' placeholder="not set"'
    return f'<input type="text" autocomplete="off" spellcheck="false" value="{text}"{unset} {common}>'


def _help(row: PanelRow) -> str:
    texts = [html.escape(text) for text in (row.description, row.constraints) if text]
    facts = ', '.join((row.kind, *map(html.escape, row.facts), *['<b>read only</b>'] * row.is_read_only))
    return f'{" ".join(texts)} <span class="param-facts">({facts})</span>'


def _message(state: RowState) -> str:
    """Return what stands beside a control at first; from then on the script says what is new."""
    if not state.message:
        return ''
    kind, words = state.message
    word = '<b>Rejected:</b> ' if kind == 'rejected' else ''
    return f'<span class="param-message param-{kind}">{word}{html.escape(words)}</span>'
