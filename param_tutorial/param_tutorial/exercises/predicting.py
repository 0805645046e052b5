"""The widget in which a learner commits to a prediction, and then sees what became of it.

It never holds up a cell. What is right it says only after another cell has run, which is the one that decides; a
learner who has run that cell already is told at once, and so is one who recalls an earlier chapter.
"""

import threading
import weakref
from collections.abc import Callable
from typing import Any

import ipywidgets as widgets

from param_tools.markup.styles import style
from param_tools.markup.tables import with_code
from param_tools.panel.beside_cells import answer_beside_cells
from param_tools.panel.close_with_cell import close_looks, close_with_cell
from param_tutorial.exercises.prediction import ASK_AGAIN, MIME_TYPE, Choice, Prediction

STYLE = style('param_tutorial/exercises/prediction.css')
COMMIT, COMMITTED = 'Commit', 'Committed'

Remember = Callable[[str, str, bool], str]


class PredictionView(widgets.VBox):
    """A question, its choices or a box for a value, and a button that commits."""

    def __init__(self, prediction: Prediction, remember: Remember):
        """
        :param remember: Called once, with the number, the answer and whether it is right; returns what the learner
            should know if that could not be remembered.
        """
        self.prediction = prediction
        self._remember = remember
        # A cell that decides may end in one thread while the learner commits in another.
        self._deciding = threading.RLock()
        self._committed = False
        self._next_cell_has_run = not prediction.is_decided_by_a_cell
        self._note = ''
        question = widgets.HTML(f'{STYLE}<p class="param-predict-question"><b>{prediction.word}</b> · '
                                f'{with_code(prediction.question)}</p>')
        self.answer: Any = (
            widgets.Text(placeholder='your number', value='') if prediction.is_typed
            else widgets.RadioButtons(options=[each.text for each in prediction.choices], value=None))
        self.button = widgets.Button(description=COMMIT, disabled=True, tooltip='Commit to this answer')
        self.said = widgets.HTML()
        super().__init__([question, self.answer, self.button, self.said])
        self.add_class('param-predict')
        for widget in (self.answer, self.button):
            answer_beside_cells(widget)
        self.answer.observe(self._on_answer, 'value')
        self.button.on_click(lambda _: self.commit())
        if prediction.is_decided_by_a_cell:
            _watch.add(self)
            self._go_on()
        close_with_cell(self)

    def __repr__(self) -> str:
        return self.prediction.text

    def _repr_mimebundle_(self, **arguments: Any) -> Any:
        bundle = super()._repr_mimebundle_(**arguments)
        # ipywidgets shortens what stands in a widget's place.
        bundle['text/plain'] = repr(self)
        bundle[MIME_TYPE] = {'number': self.prediction.number}
        return bundle

    def close(self) -> None:
        """Close it with all its parts: ipywidgets keeps each that is not closed, in the kernel and in the browser."""
        for part in (*self.children, self):
            close_looks(part)
        for child in self.children:
            child.close()
        super().close()

    def commit(self) -> None:
        """Lock the answer in, and say what became of it as soon as it can be known; ask again for a number."""
        with self._deciding:
            if self._committed or not self._given:
                return
            if not self.prediction.can_read(self._given):
                self.said.value = f'<p role="status">{with_code(ASK_AGAIN)}</p>'
                return
            choice = self.prediction.choice(self._given)
            self._note = self._remember(self.prediction.number, choice.text, choice.is_right)
            self._lock()

    def next_cell_has_run(self) -> None:
        """Take notice that the cell that decides has run."""
        with self._deciding:
            if not self._next_cell_has_run:
                self._next_cell_has_run = True
                self._say()

    def _lock(self) -> None:
        self._committed = self.answer.disabled = True
        # Neither gone nor disabled: it has the focus, from which the learner goes on by keyboard.
        self.button.description = COMMITTED
        self._say()

    def _go_on(self) -> None:
        """Take over what an earlier view of the same prediction was committed to, if it is still undecided.

        After a click in a cell's output, Shift+Enter runs that cell again, and not the next one.
        """
        earlier = _latest.get(self.prediction.number)
        _latest[self.prediction.number] = self
        if earlier is not None and earlier._committed and not earlier._next_cell_has_run:
            self.answer.value, self._note = earlier.answer.value, earlier._note
            self._lock()

    @property
    def _given(self) -> str:
        return (self.answer.value or '').strip()

    def _on_answer(self, _: Any) -> None:
        self.button.disabled = self._committed or not self._given

    def _say(self) -> None:
        if not self._committed:
            return
        if not self._next_cell_has_run:
            said = 'Wait for the cell that is running.' if _watch.is_running_for(self) else 'Now run the next cell.'
            self.said.value = f'<p role="status">{said}</p>'
            return
        said = verdict(self.prediction, self.prediction.choice(self._given))
        self.said.value = f'<p role="status">{said} {with_code(self._note)}</p>'


def verdict(prediction: Prediction, choice: Choice) -> str:
    """Return what is said to an answer, as HTML."""
    css_class, word = ('param-predict-right', 'Right.') if choice.is_right else ('param-predict-wrong', 'Not so.')
    return f'<b class="{css_class}">{word}</b> {with_code(f"{choice.sentence} {prediction.pointer}".strip())}'


class _Watch:
    """Knows which predictions have been shown, and tells them when a later cell has run."""

    def __init__(self) -> None:
        self._shell: Any = None
        self._waiting: weakref.WeakSet[PredictionView] = weakref.WeakSet()
        # The views that were on the page when the running cell began; None if it shows a prediction itself.
        self._before: list[PredictionView] | None = None

    def add(self, view: PredictionView) -> None:
        """Tell a view when the next cell has run; at once where there are no cells."""
        from IPython import get_ipython

        shell = get_ipython()
        if shell is None:
            view.next_cell_has_run()
            return
        if shell is not self._shell:
            self._shell = shell
            shell.events.register('pre_run_cell', self._on_begin)
            shell.events.register('post_run_cell', self._on_end)
        self._before = None
        self._waiting.add(view)

    def is_running_for(self, view: PredictionView) -> bool:
        """True if a cell is running that was started when the view was on the page."""
        return view in (self._before or ())

    def _on_begin(self, _: Any) -> None:
        self._before = list(self._waiting)

    def _on_end(self, _: Any) -> None:
        for view in self._before or ():
            self._waiting.discard(view)
            view.next_cell_has_run()
        self._before = None


_watch = _Watch()
# By the numbers of the predictions.
_latest: dict[str, PredictionView] = {}
