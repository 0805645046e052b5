"""Asks the node behind a view's controls what a reader of a page without a kernel could ask it."""

import math
from collections.abc import Mapping
from typing import Any

from param_tools.node.text import fit, format_value
from param_tools.panel.recordable import ControlFacts, Portrait
from param_tutorial.site.recording import questions
from param_tutorial.site.recording.album import TOGETHER, Album
from param_tutorial.site.recording.asking import Asker, CannotRestoreError
from param_tutorial.site.recording.dependence import find_dependence
from param_tutorial.site.recording.recorded import Page, Recording, Row

# At how many values a slider can stand, fewer each time.
_STOPS = (201, 101, 51, 41, 31, 26, 21, 16, 14, 11, 8, 6)
_ALONE, _OF_SEVERAL, _OF_MANY, _OF_MANY_PICTURED = 201, 41, 26, 14
_MANY_SLIDERS = 4
# Of a panel with many parameters not all are asked for: who depends on whom takes all pairs, and each question reads
# all values. So many at most, and so many times the number of rows.
_MOST_ASKED, _MOST_READ = 30, 3000


def interview(node: str, controls: Mapping[str, ControlFacts], page: Page, *, events: bool = False,
              portrait: Portrait | None = None) -> Recording:
    """Ask a node for everything, and return the answers.

    :param controls: What a hand can change, by the parameters' names; nothing is asked where all are locked.
    :param page: What its lesson speaks of is asked for too.
    :param events: Record also what the node publishes on /parameter_events.
    :param portrait: A view of the node, of which the page wants a picture for each answer.
    :return: 'rows', and what was seen; 'incomplete' if the node did not take back what it had.
    """
    rows = _rows(controls, page['source'], is_pictured=portrait is not None)
    recording: Recording = {'rows': rows}
    loud = [row for row in rows if not row['locked']]
    count = min(_MOST_ASKED, _MOST_READ // len(rows))
    for row in loud[count:]:
        row['locked'] = row['unasked'] = True
    del loud[count:]
    if not loud:
        return recording
    if portrait:
        portrait.rest()
    asker = Asker(node, {name: each.descriptor for name, each in controls.items()}, events=events)
    try:
        recording |= _ask_all(asker, loud, page, portrait)
    except CannotRestoreError:
        recording['incomplete'] = True
    finally:
        asker.flush()
        asker.close()
    recording['asked'] = asker.count
    return recording


def _ask_all(asker: Asker, rows: list[Row], page: Page, portrait: Portrait | None) -> dict[str, Any]:
    """Ask for everything, and return the pictures that were taken."""
    for row in rows:
        name, row['answers'] = row['name'], {}
        for text in questions.texts_to_try(row, asker.descriptors[name], asker.shown[name], page['literals']):
            row['answers'][text] = asker.ask(name, text, asker.shown)
        row['readings'] = questions.readings(asker.descriptors[name], row['answers'])
    find_dependence(asker, rows)
    return Album(portrait, asker).fill(rows, page['albums']) if portrait else {}


def _rows(controls: Mapping[str, ControlFacts], source: str, *, is_pictured: bool) -> list[Row]:
    rows = {name: _row(name, each, source) for name, each in controls.items()}
    sliders = [name for name, each in controls.items() if each.scale]
    are_many = len(sliders) > _MANY_SLIDERS
    if are_many:
        count = _OF_MANY_PICTURED if is_pictured else _OF_MANY
    else:
        count = _OF_SEVERAL if len(sliders) > 1 else _ALONE
    at_most = dict.fromkeys(sliders, count)
    switches = sum(row['editor'] == 'check' and not row['locked'] and not row['quiet'] for row in rows.values())
    while True:
        for name in sliders:
            rows[name]['positions'] = _stops(controls[name], source, at_most[name])
        lengths = {name: len(rows[name]['positions']) for name in sliders if not rows[name]['locked']}
        if not is_pictured or are_many or math.prod(lengths.values()) * 2**switches <= TOGETHER:
            return list(rows.values())
        # Every combination is to be pictured: the slider with the most stops can best do with fewer.
        longest = max(lengths, key=lambda name: (lengths[name], at_most[name]))
        at_most[longest] = next(each for each in _STOPS if each < at_most[longest])


def _stops(control: ControlFacts, source: str, at_most: int) -> list[str]:
    assert control.scale is not None
    own = questions.set_to(control.descriptor.name, source)
    return [format_value(control.descriptor, each)
            for each in questions.stops(control.scale, control.value, own, at_most)]


def _row(name: str, control: ControlFacts, source: str) -> Row:
    descriptor, state = control.descriptor, control.state
    message = state.message[1] if state.message and state.message[0] in ('rejected', 'failed') else ''
    own = [format_value(descriptor, fit(descriptor, each)) for each in questions.set_to(name, source)]
    return {'name': name, 'text': state.text, 'message': message, 'locked': state.is_locked,
            'quiet': control.row.is_quiet, 'editor': control.row.editor, 'own': own,
            'row': {**vars(control.row), 'facts': list(control.row.facts), 'choices': list(control.row.choices)}}
