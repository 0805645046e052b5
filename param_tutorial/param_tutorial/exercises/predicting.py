"""The widget in which a learner commits to a prediction, and then sees the verdict.

``prediction.js`` is the form, here and on the website: it reads the answer and shows the verdict. The widget keeps the
answer, and tells the form when another cell has run, which is the one that decides; it never holds up a cell. Until
then ``notebook.veil`` hides what gives the answer away.
"""

import html
import json
import weakref
from collections.abc import Callable
from dataclasses import asdict
from typing import Any

import traitlets

from param_tools.markup.scripts import bundle
from param_tools.markup.styles import sheet, style
from param_tools.markup.tables import with_code
from param_tools.panel.close_with_cell import close_looks, close_with_cell
from param_tools.panel.front import Front, answer_beside_cells
from param_tutorial.exercises.prediction import MIME_TYPE, Choice, Prediction, Scale, wrong
from param_tutorial.notebook import veil

STYLE = style('param_tutorial/exercises/prediction.css')

Remember = Callable[[str, str, bool], str]


class PredictionView(Front):
    """A question, its choices or a box for a value, and a button that commits."""

    _esm = bundle('param_tutorial/exercises/prediction_widget.js')
    _css = sheet('param_tutorial/exercises/prediction.css')
    markup = traitlets.Unicode().tag(sync=True)
    answer = traitlets.Unicode().tag(sync=True)
    """What the learner has committed to: a choice's text, or a number as it was given."""
    is_decided = traitlets.Bool().tag(sync=True)
    """True if the form may show the verdict."""
    is_told_below = traitlets.Bool().tag(sync=True)
    """True if the verdict stands below the cell that decided."""
    note = traitlets.Unicode().tag(sync=True)
    """What the learner should know if the answer could not be remembered, as HTML."""

    def __init__(self, prediction: Prediction, remember: Remember):
        """
        :param remember: Called once, with the number, the answer and whether it is right; returns what the learner
            should know if that could not be remembered.
        """
        self.prediction = prediction
        self._remember = remember
        self._meant = ''
        super().__init__(markup=draw_form(prediction), is_decided=not prediction.is_decided_by_a_cell)
        answer_beside_cells(self)
        self.on_msg(self._on_message)
        if prediction.is_decided_by_a_cell:
            _watch.add(self)
            self._go_on()
        close_with_cell(self)

    def __repr__(self) -> str:
        return self.prediction.text

    def _repr_mimebundle_(self, **arguments: Any) -> Any:
        bundle: Any = super()._repr_mimebundle_(**arguments)
        data, metadata = bundle
        return {**data, 'text/plain': repr(self), MIME_TYPE: {'number': self.prediction.number}}, metadata

    def close(self) -> None:
        """Close it with its layout, which ipywidgets keeps otherwise, in the kernel and in the browser."""
        close_looks(self)
        super().close()

    def commit(self, answer: str, meant: str = '') -> None:
        """Lock an answer in: a choice's text, or a number as it was given.

        :param meant: The text of the choice that the answer means, if it is another.
        """
        # A cell that decides may end in one thread while the learner commits in another.
        with self.drawing, self.hold_sync():
            if self.answer:
                return
            choice = self.prediction.choice(meant or answer)
            self.note = with_code(self._remember(self.prediction.number, choice.text, choice.is_right))
            self.answer, self._meant = answer, choice.text
            if self.is_decided:
                veil.lift(self.prediction.number)

    def decide(self) -> dict[str, str]:
        """Let the form show the verdict: a later cell has run.

        :return: The verdict, to show below that cell's output, where the learner looks; nothing without an answer.
        """
        with self.drawing:
            self.is_decided = True
            if not self.answer:
                return {}
            self.is_told_below = True
            veil.lift(self.prediction.number)
            choice, scale = self.prediction.choice(self._meant), self.prediction.scale
            answer = f'{self.answer} {scale.unit}'.strip() if scale else self.answer
            return {'text/html': f'{STYLE}<div class="param-predict"><p>You predicted: '
                                 f'<q>{with_code(answer)}</q></p><p>{verdict(self.prediction, choice)}</p></div>',
                    'text/plain': f'You predicted: {answer}\n{choice.word} {self.prediction.words_for(choice)}'}

    def _on_message(self, _widget: object, content: dict[str, Any], _buffers: object) -> None:
        if content.get('do') == 'commit':
            self.commit(str(content['answer']), str(content['meant']))
        elif content.get('do') == 'skip':
            veil.lift(self.prediction.number)

    def _go_on(self) -> None:
        """Take over what an earlier view of the same prediction was committed to, if it is still undecided.

        After a click in a cell's output, Shift+Enter runs that cell again, and not the next one.
        """
        earlier = _latest.get(self.prediction.number)
        _latest[self.prediction.number] = self
        if earlier is not None and not earlier.is_decided:
            self.answer, self._meant, self.note = earlier.answer, earlier._meant, earlier.note


def draw_form(prediction: Prediction, linked: Callable[[str], str] = str) -> str:
    """Return the HTML of a question, with what its form has to know.

    :param linked: Returns a verdict with links in it.
    """
    scale = prediction.scale
    facts = {'verdicts': {each.text: linked(verdict(prediction, each)) for each in prediction.choices},
             'right': prediction.right,
             'otherwise': (linked(verdict(prediction, wrong('', prediction.otherwise)))
                           if prediction.is_number else None),
             'scale': scale and asdict(scale)}
    # Or JupyterLab takes the arrow keys for itself, and selects another cell.
    common = 'name="answer" autocomplete="off" data-lm-suppress-shortcuts="true"'
    if scale:
        answers = _draw_scale(scale, common)
    elif prediction.is_number:
        answers = f'<input type="text" {common} placeholder="your number" aria-label="Your number">'
    else:
        answers = ''.join(f'<label><input type="radio" {common} value="{html.escape(each.text)}">'
                          f'<span>{with_code(each.text)}</span></label>' for each in prediction.choices)
    return (f'<form class="param-predict" autocomplete="off" '
            f'data-facts="{html.escape(json.dumps(facts, ensure_ascii=False))}">'
            f'<fieldset><legend class="param-predict-question"><b>{prediction.word}</b> · '
            f'{with_code(prediction.question)}</legend>{answers}</fieldset>'
            f'<p class="param-predict-buttons"><button type="submit" class="param-predict-commit" disabled>Commit'
            f'</button><button type="button" class="param-predict-skip">Skip</button></p>'
            f'<p class="param-predict-says" role="status"></p></form>')


_ROBOT = ('<svg class="param-predict-robot" viewBox="-59 -37 59 38" aria-hidden="true"><path d="M-59 -26h55v17h-55z'
          'M-46 -18a9 9 0 1 0 .1 0M-17 -18a9 9 0 1 0 .1 0M-15 -26v-7h6"/></svg>')


def _draw_scale(scale: Scale, common: str) -> str:
    """Return a line with a marker on it; the wall is at its right end."""
    middle = scale.low + scale.step * round((scale.high - scale.low) / scale.step / 2)
    ends = [f'{each:g}' for each in (scale.low, scale.high)]
    ends = ['start', 'wall'] if scale.is_track else ends
    return ('<div class="param-predict-scale"><b class="param-predict-number" aria-hidden="true">?</b>'
            '<span class="param-predict-line">'
            f'<input type="range" {common} min="{scale.low:g}" max="{scale.high:g}" step="{scale.step:g}" '
            f'value="{middle:g}"{" dir=rtl" if scale.is_track else ""} aria-label="Your prediction, in {scale.unit}">'
            f'{_ROBOT if scale.is_track else ""}<i class="param-predict-truth" hidden></i></span>'
            f'<span class="param-predict-ends" aria-hidden="true"><span>{ends[0]}</span><span>{ends[1]}</span></span>'
            f'</div>')


def verdict(prediction: Prediction, choice: Choice) -> str:
    """Return what is said to an answer, as HTML."""
    css_class = 'param-predict-right' if choice.is_right else 'param-predict-wrong'
    return f'<b class="{css_class}">{choice.word}</b> {with_code(prediction.words_for(choice))}'


class _Watch:
    """Knows which predictions wait for a cell, and decides them when one that began later has run."""

    def __init__(self) -> None:
        self._shell: Any = None
        self._views: weakref.WeakSet[PredictionView] = weakref.WeakSet()
        # Those that were on the page when the running cell began; none if it shows a prediction itself.
        self._before: list[PredictionView] = []

    def add(self, view: PredictionView) -> None:
        """Decide a view when the next cell has run; at once where there are no cells."""
        from IPython import get_ipython

        shell = get_ipython()
        if shell is None:
            view.decide()
            return
        if shell is not self._shell:
            self._shell = shell
            shell.events.register('pre_run_cell', self._on_begin)
            shell.events.register('post_run_cell', self._on_end)
        self._before = []
        self._views.add(view)

    def _on_begin(self, _: Any) -> None:
        self._before = [each for each in self._views if each.comm is not None]

    def _on_end(self, _: Any) -> None:
        for view in self._before:
            self._views.discard(view)
            if shown := view.decide():
                self._shell.display_pub.publish(shown)
        self._before = []


_watch = _Watch()
# By the numbers of the predictions.
_latest: dict[str, PredictionView] = {}
