"""Asks the node behind a view's controls what a reader of a page without a kernel could ask it."""

import functools
from collections.abc import Iterable, Mapping
from typing import Any

from param_tutorial.lessons.recording import questions
from param_tutorial.lessons.recording.album import Album
from param_tutorial.lessons.recording.asking import Asker, CannotRestoreError, nothing
from param_tutorial.lessons.recording.dependence import find_dependence
from param_tutorial.lessons.recording.recorded import Answer, Recording, Row
from param_tutorial.parameters.text import format_value
from param_tutorial.widgets.recordable import ControlFacts, Portrait

# How many positions of a slider are asked for; beyond that, a spread with both ends.
_POSITIONS = 201
_POSITIONS_OF_MANY = 51
_MANY_SLIDERS = 4


def interview(node: str, controls: Mapping[str, ControlFacts], literals: Iterable[Any], *, events: bool = False,
              portrait: Portrait | None = None) -> Recording:
    """Ask a node for everything, and return the answers.

    :param controls: What a hand can change, by the parameters' names; nothing is asked where all are locked.
    :param literals: Values that the lesson speaks of; a parameter of a fitting type is asked for them too.
    :param events: Record also what the node publishes on /parameter_events.
    :param portrait: A view of the node, of which the page wants a picture for each answer.
    :return: 'rows', and what was seen; 'incomplete' if the node did not take back what it had.
    """
    rows = _rows(controls)
    recording: Recording = {'rows': rows}
    if all(row['locked'] for row in rows):
        return recording
    if portrait:
        portrait.rest()
    asker = Asker(node, {name: each.descriptor for name, each in controls.items()}, events=events)
    try:
        recording |= _ask_all(asker, [row for row in rows if not row['locked']], list(literals), portrait)
    except CannotRestoreError:
        recording['incomplete'] = True
    finally:
        asker.close()
    recording['asked'] = asker.count
    return recording


def _take_picture(album: Album, name: str, answer: Answer) -> None:
    album.take({name: answer['value']})


def _ask_all(asker: Asker, rows: list[Row], literals: list[Any], portrait: Portrait | None) -> dict[str, Any]:
    """Ask for everything, and return the pictures that were taken."""
    album = Album(portrait) if portrait else None

    for row in rows:
        name, row['answers'] = row['name'], {}
        look = functools.partial(_take_picture, album, name) if album else nothing
        for text in questions.texts_to_try(row, asker.descriptors[name], asker.shown[name], literals):
            row['answers'][text] = asker.ask(name, text, asker.shown, while_accepted=look)
    find_dependence(asker, rows)
    return album.fill(asker, rows) if album else {}


def _rows(controls: Mapping[str, ControlFacts]) -> list[Row]:
    many = sum(each.descriptor.range is not None for each in controls.values()) > _MANY_SLIDERS
    return [_row(name, each, _POSITIONS_OF_MANY if many else _POSITIONS) for name, each in controls.items()]


def _row(name: str, control: ControlFacts, positions: int) -> Row:
    descriptor, state = control.descriptor, control.state
    message = state.message[1] if state.message and state.message[0] == 'rejected' else ''
    row: Row = {'name': name, 'text': state.text, 'message': message, 'locked': state.is_locked,
                'quiet': control.row.is_quiet, 'editor': control.row.editor,
                'row': {**vars(control.row), 'facts': list(control.row.facts), 'choices': list(control.row.choices)}}
    if control.scale:
        row['positions'] = [format_value(descriptor, each)
                            for each in questions.positions(control.scale, control.value, positions)]
    return row
