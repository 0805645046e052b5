"""Draws recordings as HTML: native controls with labels, words beside every picture, and nothing to load.

What was recorded stands in the page, packed, beside the controls; the scripts in ``site/scripts`` unpack it and answer
with it. Without a script the page still shows everything as it stood.
"""

import base64
import contextlib
import html
import itertools
import json
import re
import zlib
from collections.abc import Callable, Iterable
from decimal import Decimal
from typing import Any

from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import get_lexer_by_name

from param_tools.markup.tables import with_code
from param_tools.panel.drawing import LINES, TEXT, PanelRow, RowState, panel_markup
from param_tutorial.exercises.predicting import STYLE as PREDICTION_STYLE
from param_tutorial.exercises.predicting import verdict
from param_tutorial.exercises.prediction import Prediction, plain_answer
from param_tutorial.site.recording.album import TURN_SEC
from param_tutorial.site.recording.recorded import Recording, Row
from param_tutorial.views.drawing import driving

RUN_IT = 'run the notebook'
# So many numbers in a row are worth telling.
_RUN = 10
_STYLE = re.compile(r'<style>.*?</style>', re.DOTALL)


class Drawer:
    """Draws the recordings of one page; ids count up, so that building twice gives the same page."""

    def __init__(self, page: str, recordings: Iterable[Recording] = ()):
        """
        :param page: Begins each id, for the sake of a page that shows parts of two chapters.
        :param recordings: All of the chapter: what several of them share is in one of them, and on the page once.
        """
        self._page = re.sub(r'\W+', '-', page)
        self._numbers = itertools.count(1)
        self._albums = {name: packed for each in recordings for part in each.get('parts', [each])
                        for name, packed in part.get('albums', {}).items()}

    def draw(self, recording: Recording) -> str:
        """Return the HTML of one recorded view."""
        draw = {'panel': self._panel, 'robot': self._robot, 'log': self._log, 'steps': self._steps,
                'events': self._events, 'side by side': self._side_by_side, 'still': self._still}
        return draw[recording['kind']](recording, f'{self._page}-{next(self._numbers)}')

    def draw_prediction(self, prediction: Prediction, linked: Callable[[str], str] = str) -> str:
        """Return the HTML of a prediction: a form that says what became of the answer, as soon as there is one.

        :param linked: Returns a verdict with the page's links in it.
        """
        name = f'{self._page}-{next(self._numbers)}'
        if prediction.is_typed:
            answers = '<input type="text" name="answer" autocomplete="off" aria-label="Your value">'
        else:
            answers = ''.join(f'<label><input type="radio" autocomplete="off" name="answer" '
                              f'value="{html.escape(each.text)}">'
                              f'<span>{html.escape(each.text)}</span></label>' for each in prediction.choices)
        # A typed value may be none of the choices; the page's script compares it as the notebook does.
        facts = {'choices': {plain_answer(each.text): linked(verdict(prediction, each.text))
                             for each in prediction.choices},
                 'otherwise': linked(verdict(prediction, '')) if prediction.is_typed else ''}
        return (f'{PREDICTION_STYLE}<form class="rec-prediction param-predict" autocomplete="off" id="{name}" '
                f'data-number="{prediction.number}"{" data-decided" if prediction.is_decided_by_a_cell else ""}>'
                f'<fieldset>'
                f'<legend class="param-predict-question"><b>{prediction.word}</b> · '
                f'{with_code(prediction.question)}</legend>'
                f'{answers}<button type="submit" class="rec-commit" disabled>Commit</button></fieldset>'
                f'<p class="rec-says" role="status"></p>'
                f'<button type="button" class="rec-again" hidden>Answer again</button>{packed(facts)}</form>')

    def _panel(self, recording: Recording, name: str) -> str:
        rows = [_panel_row(row) for row in recording['rows']]
        markup = panel_markup(recording['node'], rows, {row['name']: _state(row) for row in recording['rows']},
                              status=recording['status'], in_order=recording['in_order'], tools=False,
                              mark='recorded', prefix=name)
        facts = {
            'node': recording['node'],
            'rows': [{key: row[key] for key in ('name', 'text', 'editor', 'positions', 'answers', 'readings', 'depends',
                                                'contexts', 'log_depends') if key in row}
                     for row in recording['rows'] if not row['locked']],
            'names': recording.get('names', []),
            'films': recording.get('films', ''),
            'turns': recording.get('turns', ''),
            'turn_sec': TURN_SEC,
        }
        looks = _script('rec-looks', recording['looks']) if 'looks' in recording else ''
        albums = ''.join(_script(f'rec-album" data-album="{album}', self._albums.pop(album))
                         for album in (facts['films'], facts['turns']) if album in self._albums)
        node = html.escape(recording['node'])
        return (
            f'<div role="group" class="rec rec-panel" id="{name}" data-node="{node}" aria-label="Parameters of {node}">'
            f'<noscript><p class="rec-note">The controls answer only where the page may run its script.</p></noscript>'
            f'<div class="param-panel">{markup}</div>'
            f'<div class="rec-foot"><button type="button" class="rec-reset" disabled>Back to the start</button>'
            f'<button type="button" class="rec-link" disabled>Copy a link to these settings</button>'
            f'<p class="rec-note">{_explanation(recording)}</p>'
            f'<p class="rec-note rec-from-link" role="status"></p></div>{packed(facts)}{looks}{albums}</div>')

    def _robot(self, recording: Recording, name: str) -> str:
        look, node = recording['look'], html.escape(recording['node'])
        sentence = driving.Scene(*look['scene']).sentence
        return (
            f'<div role="group" class="rec rec-robot robot-view" id="{name}" data-node="{node}" '
            f'aria-label="{node} on its track">'
            f'{driving.view_markup(look["picture"], sentence)}{packed({"films": recording["films"]})}</div>')

    def _log(self, recording: Recording, name: str) -> str:
        title = html.escape(f'Log of {recording["node"]}')
        lines = ''.join(f'{html.escape(line)}\n' for line in recording['lines'])
        return (f'<div role="group" class="rec rec-log" id="{name}" data-node="{html.escape(recording["node"])}" '
                f'aria-label="{title}"><p class="rec-head"><b>{title}</b><span class="rec-mark">recorded</span></p>'
                f'<pre role="log" tabindex="0" aria-label="{title}">{lines}</pre></div>')

    def _steps(self, recording: Recording, name: str) -> str:
        node = html.escape(recording['node'])
        # The picture is replaced, and its style has to stay.
        style = ''.join(_STYLE.findall(recording['html']))
        return (f'<div role="group" class="rec rec-steps" id="{name}" data-node="{node}" '
                f'aria-label="Step response of {node}">{style}'
                f'<div class="rec-picture">{_STYLE.sub("", recording["html"])}</div>'
                f'<div class="rec-says" role="status"></div></div>')

    def _events(self, recording: Recording, name: str) -> str:
        node = html.escape(recording['node'])
        return (f'<div role="group" class="rec rec-events" id="{name}" data-node="{node}" '
                f'aria-label="Events of {node}">{recording["html"]}'
                f'<p class="rec-note">Empty as the lesson shows it. What a panel above changes stands here as the node '
                f'told it when the page was made.</p></div>')

    def _side_by_side(self, recording: Recording, name: str) -> str:
        parts = ''.join(map(self.draw, recording['parts']))
        return f'<div class="side-by-side" id="{name}"><div class="side-by-side-parts">{parts}</div></div>'

    def _still(self, recording: Recording, name: str) -> str:
        shown = recording['html'] or f'<p>{html.escape(recording["text"])}</p>'
        note = 'As it stood when the lesson ran; it is alive' if recording['html'] else 'It stands'
        return (f'<div role="group" class="rec rec-still" id="{name}" aria-label="A view of the notebook">{shown}'
                f'<p class="rec-note">{note} in the notebook.</p></div>')


def _explanation(recording: Recording) -> str:
    if recording['status']:
        return 'The node was not there, so it could not be asked.'
    told = (f'No node runs in this page. These are answers that the real node gave when the page was made: it was '
            f'asked {recording.get("asked", 0):,} times. The panel begins as this cell left it, and what you change '
            f'here stays here. For what the node was not asked, {RUN_IT}.')
    if recording.get('incomplete'):
        told += ' It did not take one value back, and was not asked any further.'
    return told


def _panel_row(row: Row) -> PanelRow:
    """Return a recorded row as the panel draws it; its slider stands at the recorded positions only."""
    last = len(row['positions']) - 1 if 'positions' in row else None
    return PanelRow(**{**row['row'], 'facts': tuple(row['row']['facts']), 'choices': tuple(row['row']['choices']),
                       'last': last, 'note': _where_recorded(row)})


def _where_recorded(row: Row) -> str:
    """Return what the node was asked for, so that nobody has to find out; empty for a check box, which has it all."""
    if row.get('unasked'):
        return f'Not recorded: {RUN_IT} to change it.'
    if row['locked'] or row['editor'] not in (TEXT, LINES) or 'answers' not in row:
        return ''
    numbers: dict[Decimal, None] = {}
    for text, answer in row['answers'].items():
        with contextlib.suppress(ArithmeticError):
            if 'value' in answer and (number := Decimal(text)).is_finite():
                numbers[number] = None
    run = _longest_run(sorted(numbers))
    others = len(row['answers']) - len(run)
    if len(run) < _RUN:
        return f'Recorded: {len(row["answers"])} texts. The box suggests some.'
    step = (run[1] - run[0]).normalize()
    together = ' Together with other changes: where the slider stands.' if 'positions' in row else ''
    return f'Recorded: {run[0]} to {run[-1]} in steps of {step:f}, and {others} others.{together}'


def _longest_run(numbers: list[Decimal]) -> list[Decimal]:
    """Return the longest run of numbers with one distance."""
    known = set(numbers)
    best: list[Decimal] = []
    for step in map(Decimal, ('0.001', '0.005', '0.01', '0.05', '0.1', '0.5', '1', '5', '10')):
        for first in numbers:
            if first - step not in known:
                run = list(itertools.takewhile(known.__contains__, (first + step * each for each in itertools.count())))
                best = max(best, run, key=len)
    return best


def _state(row: Row) -> RowState:
    """Return how a recorded row stands; it is locked until the script is there to answer."""
    position = row['positions'].index(row['text']) if 'positions' in row else None
    return RowState(row['text'], position, is_locked=True,
                    message=('rejected', row['message']) if row['message'] else None)


def packed(facts: dict[str, Any]) -> str:
    data = zlib.compress(json.dumps(facts, ensure_ascii=False, separators=(',', ':')).encode(), 9)
    return _script('rec-data', base64.b64encode(data).decode())


def _script(css_class: str, packed: str) -> str:
    return f'<script type="text/plain" class="{css_class}">{packed}</script>'


def code(source: str) -> str:
    """Return Python code as HTML, in the colors of the page."""
    html: str = highlight(source, get_lexer_by_name('ipython3'), HtmlFormatter(cssclass='highlight'))
    return html.replace('<pre>', '<pre tabindex="0">', 1)


def details(summary: str, content: str) -> str:
    """Return something that a reader opens and closes."""
    return f'<details class="rec-details"><summary>{html.escape(summary)}</summary><div>{content}</div></details>'


def inline(text: str) -> str:
    """Return HTML of a text in which backquotes stand around code."""
    return re.sub(r'`([^`]+)`', r'<code>\1</code>', html.escape(text, quote=False))
