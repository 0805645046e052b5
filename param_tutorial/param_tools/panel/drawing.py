"""A parameter panel as HTML: each parameter's name, control and description.

``panel.js`` brings it to life, in JupyterLab and on a page of the website alike; without a script it still
shows what the node had.
"""

import html
import itertools
import re
from collections.abc import Iterable, Mapping, Sequence

from param_tools.markup.wording import format_count
from param_tools.panel.control import CHECK, LINES, PanelRow, RowState

HOUSEKEEPING = 'In every node'
"""The group of what every node has, which is seldom what one came for."""

# With so many parameters one searches, and each has one line.
_SEARCH_FROM = 20
# What has changed, to copy.
_COPIES = {'As a parameter file': 'yaml', 'As commands': 'sh'}


def arrange(rows: Iterable[PanelRow]) -> list[PanelRow]:
    """Return rows in the order of the page: what every node has comes last."""
    return sorted(rows, key=lambda row: row.is_quiet)


def panel_markup(node: str, rows: Sequence[PanelRow], states: Mapping[str, RowState], *, status: str = '',
                 tools: bool = True, is_open: bool = False) -> str:
    """Return a panel as HTML; its style sheet is ``panel.css``. Each id begins with what ``panel.js`` replaces.

    :param node: The node's fully qualified name.
    :param states: By the parameters' names.
    :param status: Why nothing can be changed now; empty if it can.
    :param tools: Whether its head shows more buttons than *Reset*.
    :param is_open: Whether what every node has is to be seen at once.
    """
    drawn = (_row(row, states[row.name], f'panel-NAME-{number}', is_locked=bool(status))
             for number, row in enumerate(rows, 1))
    body = ''
    for is_quiet, group in itertools.groupby(zip(rows, drawn), lambda each: each[0].is_quiet):
        parts = ''.join(markup for _, markup in group)
        body += (f'<details class="param-group"{" open" if is_open else ""}><summary><span role="heading" '
                 f'aria-level="4">{html.escape(HOUSEKEEPING)}</span></summary>{parts}</details>'
                 if is_quiet else parts)
    compact = ' param-compact' if len(rows) >= _SEARCH_FROM else ''
    return f'{_head(node, len(rows), status, tools=tools)}<div class="param-rows{compact}">{body}</div>'


def _head(node: str, count: int, status: str, *, tools: bool) -> str:
    undo = ('<button type="button" class="param-undo" disabled aria-label="Undo" title="Undo (Ctrl+Z)">\u21b6</button>'
            if tools else '')
    search = (f'<input type="search" class="param-search" placeholder="Search {count} parameters" '
              f'aria-label="Search the parameters of {html.escape(node)}" autocomplete="off" spellcheck="false">'
              if count >= _SEARCH_FROM else '')
    words = format_count(count, 'parameter')
    bad = ' param-status-bad' if status else ''
    return (f'<div class="param-head"><span role="status"><span class="param-node">{html.escape(node)}</span>'
            f'<span class="param-status{bad}" data-count="{words}">{html.escape(status) or words}</span></span>'
            f'<span class="param-tools" role="group" aria-label="Changes made here">{undo}'
            '<button type="button" class="param-reset" disabled '
            f'title="Bring every parameter back to its first value">Reset</button>{_copying(node) if tools else ""}'
            f'</span>{search}<span class="param-found" role="status"></span></div>')


def _copying(node: str) -> str:
    """Return a button, and what it opens: the changed values to copy."""
    forms = ''.join(
        f'<label for="panel-NAME-{kind}">{title}</label><textarea id="panel-NAME-{kind}" class="param-{kind}" rows="5" '
        f'readonly></textarea><button type="button" class="param-copy-{kind}">Copy</button>'
        for title, kind in _COPIES.items())
    return ('<button type="button" class="param-copy" popovertarget="panel-NAME-copies" disabled '
            'title="The changed values, as a parameter file or as commands">Copy\u2026</button>'
            f'<div popover class="param-copies" id="panel-NAME-copies" role="dialog" '
            f'aria-label="The changed values of {html.escape(node)}">{forms}</div>')


def _row(row: PanelRow, state: RowState, name: str, *, is_locked: bool) -> str:
    """Return one parameter's row.

    :param name: Begins the row's ids.
    """
    off = ' disabled' if row.is_read_only or state.is_locked or is_locked else ''
    common = f'id="{name}" class="param-box" aria-describedby="{name}-help {name}-said"{off}'
    kinds = ''.join(f' param-{kind}' for kind, so in (
        ('quiet', row.is_quiet), ('long', not row.is_number), ('changed', state.is_changed)) if so)
    label = html.escape(row.name)
    parts = re.sub('([_.])', r'\1<wbr>', label)
    slider = ('' if row.scale is None else
              f'<input type="range" class="param-slider" autocomplete="off" min="0" max="{row.scale.last}" '
              f'value="{state.position or 0}" data-fine="{0.1 if row.scale.is_fine else 1}" '
              f'title="{"Logarithmic. " * row.scale.is_logarithmic}Hold Shift for finer steps" '
              f'aria-label="{label}, slider" aria-valuetext="{html.escape(state.text)}"{off}>')
    back = '' if row.is_read_only else '<button type="button" class="param-back" hidden></button>'
    return (f'<div class="param-row{kinds}" data-name="{label}" data-editor="{row.editor}">'
            f'<div class="param-line"><label for="{name}" title="{html.escape(row.description)}">{parts}</label>'
            f'{_box(row, state, common)}{slider}{back}</div>'
            f'<div class="param-note param-help" id="{name}-help">{_help(row)}</div>'
            f'<div class="param-note" id="{name}-said" data-role="said">{_message(state)}</div></div>')


def _box(row: PanelRow, state: RowState, common: str) -> str:
    text = html.escape(state.text)
    if row.editor == CHECK:
        return f'<input type="checkbox" autocomplete="off" {common}{" checked" if state.text == "true" else ""}>'
    if row.editor == LINES:
        return f'<textarea rows="3" autocomplete="off" spellcheck="false" {common}>{text}</textarea>'
    empty = 'not set' if row.is_unset else 'empty text' if row.kind == 'string' else ''
    return f'<input type="text" autocomplete="off" spellcheck="false" value="{text}" placeholder="{empty}" {common}>'


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
