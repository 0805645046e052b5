"""The widget in which a learner commits to a prediction, and then sees what became of it.

It never holds up a cell. What is right it says only after another cell has run, which is the one that decides; a
learner who has run that cell already is told at once, and so is one who recalls an earlier chapter. What gives the
answer away is veiled by ``notebook.veil`` until then.
"""

import html
import weakref
from collections.abc import Callable
from typing import Any

import traitlets

from param_tools.markup.scripts import bundle
from param_tools.markup.styles import sheet, style
from param_tools.markup.tables import with_code
from param_tools.panel.beside_cells import answer_beside_cells
from param_tools.panel.close_with_cell import close_looks, close_with_cell, this_cell
from param_tools.panel.front import Front
from param_tutorial.exercises.prediction import ASK_AGAIN, MIME_TYPE, Choice, Prediction
from param_tutorial.notebook import veil

STYLE = style('param_tutorial/exercises/prediction.css')

Remember = Callable[[str, str, bool], str]


class PredictionView(Front):
    """A question, its choices or a box for a value, and a button that commits."""

    _esm = bundle('param_tutorial/exercises/prediction_widget.js')
    _css = sheet('param_tutorial/exercises/prediction.css')
    markup = traitlets.Unicode().tag(sync=True)
    answer = traitlets.Unicode().tag(sync=True)
    """The choice, or what is typed."""
    is_committed = traitlets.Bool().tag(sync=True)
    said = traitlets.Unicode().tag(sync=True)
    """What became of the answer, as HTML."""
    right = traitlets.Unicode().tag(sync=True)
    """The text of the right choice; empty until the verdict."""

    def __init__(self, prediction: Prediction, remember: Remember):
        """
        :param remember: Called once, with the number, the answer and whether it is right; returns what the learner
            should know if that could not be remembered.
        """
        self.prediction = prediction
        self._remember = remember
        self._note = ''
        self._next_cell_has_run = not prediction.is_decided_by_a_cell
        self._decided_by: str | None = None
        super().__init__(markup=draw_form(prediction))
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

    def commit(self) -> None:
        """Lock the answer in, and say what became of it as soon as it can be known; ask again for a number."""
        # A cell that decides may end in one thread while the learner commits in another.
        with self.drawing:
            if self.is_committed or not self.answer.strip():
                return
            if not self.prediction.can_read(self.answer):
                self.said = with_code(ASK_AGAIN)
                return
            choice = self.prediction.choice(self.answer)
            self._note = self._remember(self.prediction.number, choice.text, choice.is_right)
            self._lock()

    def skip(self) -> None:
        """Show what is veiled; the learner may still commit."""
        veil.lift(self.prediction.number)

    def on_cell_end(self, cell: str | None) -> dict[str, str]:
        """Take notice that a later cell has run.

        :param cell: Its id; None where it has none.
        :return: What to show below its output, where the learner looks: the verdict, if this cell decides it.
        """
        with self.drawing:
            if not self._next_cell_has_run:
                self._next_cell_has_run, self._decided_by = True, cell
                self._say()
            elif cell is None or cell != self._decided_by:
                return {}
            if not self.is_committed:
                return {}
            choice = self.prediction.choice(self.answer)
            return {'text/html': f'{STYLE}<div class="param-predict"><p>You predicted: '
                                 f'<q>{with_code(self.answer)}</q></p><p>{verdict(self.prediction, choice)}</p></div>',
                    'text/plain': f'You predicted: {self.answer}\n{choice.word} {choice.sentence}'}

    def _on_message(self, _widget: object, content: dict[str, Any], _buffers: object) -> None:
        if content.get('do') == 'commit':
            self.answer = str(content.get('answer', ''))
            self.commit()
        elif content.get('do') == 'skip':
            self.skip()

    def _lock(self) -> None:
        self.is_committed = True
        veil.lift(self.prediction.number)
        self._say()

    def _go_on(self) -> None:
        """Take over what an earlier view of the same prediction was committed to, if it is still undecided.

        After a click in a cell's output, Shift+Enter runs that cell again, and not the next one.
        """
        earlier = _latest.get(self.prediction.number)
        _latest[self.prediction.number] = self
        if earlier is not None and earlier.is_committed and not earlier._next_cell_has_run:
            self.answer, self._note = earlier.answer, earlier._note
            self._lock()

    def _say(self) -> None:
        if not self.is_committed:
            return
        if not self._next_cell_has_run:
            is_running = _watch.is_running_for(self)
            self.said = 'Wait for the cell that is running.' if is_running else 'Now run the next cell.'
            return
        with self.hold_sync():
            self.right = next(each.text for each in self.prediction.choices if each.is_right)
            self.said = f'{verdict(self.prediction, self.prediction.choice(self.answer))} {with_code(self._note)}'


def draw_form(prediction: Prediction) -> str:
    """Return the HTML of a question with its choices, or a box for a value, and a button."""
    return (f'<form class="param-predict" autocomplete="off">{draw_question(prediction)}'
            f'<p class="param-predict-buttons"><button type="submit" class="param-predict-commit">Commit</button>'
            f'<button type="button" class="param-predict-skip">Skip</button></p>'
            f'<p class="param-predict-says" role="status"></p></form>')


def draw_question(prediction: Prediction) -> str:
    """Return the HTML of a question with its choices, or a box for a value: what stands in a form."""
    # Or JupyterLab takes the arrow keys for itself, and selects another cell.
    common = 'name="answer" autocomplete="off" data-lm-suppress-shortcuts="true"'
    if prediction.is_typed:
        answers = f'<input type="text" {common} placeholder="your number" aria-label="Your number">'
    else:
        answers = ''.join(f'<label><input type="radio" {common} value="{html.escape(each.text)}">'
                          f'<span>{with_code(each.text)}</span></label>' for each in prediction.choices)
    return (f'<fieldset><legend class="param-predict-question"><b>{prediction.word}</b> · '
            f'{with_code(prediction.question)}</legend>{answers}</fieldset>')


def verdict(prediction: Prediction, choice: Choice) -> str:
    """Return what is said to an answer, as HTML."""
    css_class = 'param-predict-right' if choice.is_right else 'param-predict-wrong'
    return f'<b class="{css_class}">{choice.word}</b> {with_code(f"{choice.sentence} {prediction.pointer}".strip())}'


class _Watch:
    """Knows which predictions have been shown, and tells them when a later cell has run."""

    def __init__(self) -> None:
        self._shell: Any = None
        self._views: weakref.WeakSet[PredictionView] = weakref.WeakSet()
        # The views that were on the page when the running cell began; None if it shows a prediction itself.
        self._before: list[PredictionView] | None = None

    def add(self, view: PredictionView) -> None:
        """Tell a view when the next cell has run; at once where there are no cells."""
        from IPython import get_ipython

        shell = get_ipython()
        if shell is None:
            view.on_cell_end(None)
            return
        if shell is not self._shell:
            self._shell = shell
            shell.events.register('pre_run_cell', self._on_begin)
            shell.events.register('post_run_cell', self._on_end)
        self._before = None
        self._views.add(view)

    def is_running_for(self, view: PredictionView) -> bool:
        """True if a cell is running that was started when the view was on the page."""
        return view in (self._before or ())

    def _on_begin(self, _: Any) -> None:
        self._before = [each for each in self._views if each.comm is not None]

    def _on_end(self, _: Any) -> None:
        cell, _ = this_cell()
        for view in self._before or ():
            if shown := view.on_cell_end(cell):
                self._shell.display_pub.publish(shown)
        self._before = None


_watch = _Watch()
# By the numbers of the predictions.
_latest: dict[str, PredictionView] = {}
