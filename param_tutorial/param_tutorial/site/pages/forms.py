"""Draws the form in which a reader answers an exercise on a page; ``site/scripts/exercises.js`` answers with what the
exercise's check said to it when the page was made.
"""

import html
from collections.abc import Callable
from typing import Any

from param_tools.markup.tables import with_code
from param_tutorial.exercises.results import STYLE
from param_tutorial.site.pages.drawing import RUN_IT, packed
from param_tutorial.site.recording.recorded import Recording

_HOW = {
    'values': 'Write Python values, such as `150`, `12.0`, `True`, `"old"`, `[]` or `None`.',
    'texts': 'Write what you would type, quotes included.',
    'choices': 'Choose an answer for each.',
    'order': 'Move the lines with the arrows beside them.',
    'settings': 'The check was run with every combination of these values.',
}


def draw(recording: Recording, title: str, linked: Callable[[str], str] = str) -> str:
    """Return the HTML of an exercise's form.

    :param title: Of the exercise.
    :param linked: Returns what a check says with the page's links in it.
    """
    number = recording['number']
    name = f'exercise-form-{number.replace(".", "-")}'
    fields = _lines(recording, name) if recording['form'] == 'order' else ''.join(
        _field(recording, field, f'{name}-{position}') for position, field in enumerate(recording['fields']))
    facts = {key: value for key, value in recording.items() if key not in ('kind', 'number', 'asked')}
    facts['items'] = [[word, linked(item)] for word, item in recording['items']]
    return (
        f'{STYLE}<form class="rec rec-exercise" id="{name}" data-number="{number}" autocomplete="off" '
        f'aria-label="Exercise {number}: {html.escape(title)}">'
        f'<p class="rec-head"><span><b>Exercise {number}</b> · {with_code(title)}</span>'
        f'<span class="rec-mark">recorded</span></p>'
        f'<noscript><p class="rec-note">The form answers only where the page may run its script.</p></noscript>'
        f'<fieldset disabled>{fields}<button type="submit">Check</button></fieldset>'
        f'<p class="rec-note">{_explanation(recording)}</p>'
        f'<div class="param-check rec-verdict" hidden><p class="rec-score" role="status"></p>'
        f'<div class="rec-picture"></div><ul class="param-findings"></ul><p class="rec-next"></p></div>'
        f'{packed(facts)}</form>')


def _explanation(recording: Recording) -> str:
    how = recording['form']
    if how == 'blanks':
        how = 'choices' if recording['choices'] else 'texts' if recording['is_text'] else 'values'
    unknown = f' For what it was not asked, {RUN_IT}.' if how == 'texts' else ''
    return with_code(f'{_HOW[how]} No node runs in this page: it tells what the exercise’s check said to '
                     f'{recording["asked"]:,} sets of answers, on real nodes, when the page was made.{unknown}')


def _field(recording: Recording, field: dict[str, Any], name: str) -> str:
    note = f'<span class="rec-hint">{html.escape(field["note"])}</span>' if field.get('note') else ''
    choices = field['choices'] if recording['form'] == 'settings' else recording['choices']
    if choices:
        start = field.get('start')
        first = '' if start is not None else '<option value="">choose</option>'
        options = ''.join(f'<option value="{html.escape(str(value))}"{" selected" if at == start else ""}>'
                          f'{html.escape(str(value))}</option>' for at, value in enumerate(choices))
        control = f'<select id="{name}">{first}{options}</select>'
    else:
        shown = f' value="{html.escape(field["shown"])}"' if field['shown'] else ''
        control = f'<input type="text" id="{name}"{shown} spellcheck="false" autocapitalize="off">'
    width = ' rec-long' if field.get('shown') else ''
    return f'<p class="rec-field{width}"><label for="{name}">{_label(field["name"])}{note}</label>{control}</p>'


def _label(name: str) -> str:
    """Return what a field is about, as HTML: code, unless it is a sentence."""
    return with_code(name if name.endswith(('.', '?')) else f'`{name}`')


def _lines(recording: Recording, name: str) -> str:
    items = []
    for number, line in enumerate(recording['lines']):
        shown = html.escape(line)
        words = f'<code>{shown}</code>' if recording['is_code'] else f'<span>{shown}</span>'
        arrows = ''.join(
            f'<button type="button" data-by="{by}" aria-label="{way}: {shown.strip()}">{sign}</button>'
            for way, by, sign in (('Up', -1, '↑'), ('Down', 1, '↓')))
        items.append(f'<li data-line="{number}">{words}<span class="rec-arrows">{arrows}</span></li>')
    return f'<ol class="rec-lines" id="{name}-lines">{"".join(items)}</ol>'
