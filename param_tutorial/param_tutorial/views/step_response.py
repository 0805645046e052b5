"""The step response of a controller, drawn again whenever somebody changes its gains.

The view asks the node for nothing but its parameters and simulates the wheel itself. So it works as well on a
controller in another process, and what it shows is what the node has confirmed.
"""

import html
import time
from collections.abc import Iterator
from typing import Any

import ipywidgets as widgets
from rclpy.node import Node

from param_tools.markup.styles import style
from param_tools.node.client import ParameterClient, node_name
from param_tools.node.live import LiveParameters
from param_tools.panel.view import ParameterView
from param_tutorial.nodes.pid_controller_node import SETTLING_BAND, Figures, StepResponse, response_of
from param_tutorial.views.drawing.plots import Band
from param_tutorial.views.drawing.step_response import Wheel, plot_responses

_STYLE = style('param_tutorial/views/step_response.css')
# Changes that follow each other sooner are one drag: the curve of before is the one from before all of it.
_PAUSE_SEC = 1.0


# What exercise 10.3b asks for: the steady-state error is at most this in either direction, and the others are less.
_ERROR, _OVERSHOOT_PERCENT, _SETTLING_SEC = 0.1, 5.0, 0.4


def goal_band(reference: float) -> Band:
    """Return where the speed is to be in the end: what settles in time, near enough, stays in it."""
    room = _ERROR + SETTLING_BAND * reference
    return Band(_SETTLING_SEC, round(reference - room, 6), round(reference + room, 6))


def verdicts(figures: Figures) -> Iterator[tuple[str, bool | None, str]]:
    """Yield each figure in words, whether it meets its goal (None if it has none), and the goal in words."""
    parts = str(figures).split(', ')
    if figures.settling_sec is None or figures.overshoot_percent is None:
        yield parts[0], False, 'a steady speed'
        yield ', '.join(parts[1:]), None, ''
        return
    rise, overshoot, settling, error = parts
    yield rise, None, ''
    yield overshoot, figures.overshoot_percent < _OVERSHOOT_PERCENT, f'below {_OVERSHOOT_PERCENT:g} %'
    yield settling, figures.settling_sec < _SETTLING_SEC, f'below {_SETTLING_SEC:g} s'
    yield error, abs(figures.steady_state_error) <= _ERROR, f'within {_ERROR:g} rad/s'


class StepResponseView(ParameterView):
    """The step response of a controller's first joint, drawn again whenever a parameter changes, until it is closed.

    Show it as the last line of a cell.
    """

    def __init__(self, node: str | Node | ParameterClient) -> None:
        """:param node: The node or its name; it may run in another process, and it may be absent now."""
        self._shown: tuple[str, dict[str, Any]] | None = None
        self._text = ''
        # What is drawn, and what stood there before the last drag.
        self._response: StepResponse | None = None
        self._before: StepResponse | None = None
        self._drawn_sec = 0.0
        self._picture, self._figures = widgets.HTML(), widgets.HTML()
        self._live = LiveParameters(node_name(node), self._show)
        super().__init__([widgets.HTML(_STYLE), self._picture, self._figures], 'step-view')
        self._begin()

    @property
    def text(self) -> str:
        """What the view shows, in words, as a screen reader tells it."""
        return self._text

    def _show(self) -> None:
        with self._drawing:
            if self._closed:
                return
            parameters = {name: each.value for name, each in self._live.parameters.items() if each.value is not None}
            shown = self._live.status, parameters
            if shown == self._shown:
                return
            self._shown = shown
            if self._live.status:
                self._say(self._live.status)
                return
            try:
                joint = parameters['dof_names'][0]
                response = response_of(parameters, joint)
                figures, wheel = str(response.figures), Wheel(response.points).html()
            except KeyError as missing:
                self._say(f'{self.node} has no parameter {missing.args[0]}, so there is nothing to simulate.')
                return
            except Exception as error:
                # Somebody else's controller may hold whatever its author lets it.
                self._say(f'{self.node} holds values with which nothing can be simulated: '
                          f'{type(error).__name__}: {error}')
                return
            gains = ', '.join(f'{name} = {parameters[f"gains.{joint}.{name}"]:g}' for name in 'pid')
            self._text = f'{joint} with {gains}: {figures}'
            self._draw(joint, gains, response, wheel)

    def _draw(self, joint: str, gains: str, response: StepResponse, wheel: str) -> None:
        now = time.monotonic()
        if now - self._drawn_sec > _PAUSE_SEC:
            self._before = self._response
        self._response, self._drawn_sec = response, now
        plot = plot_responses({joint: response}, before=self._before, band=goal_band(response.reference))
        self._picture.value = (f'{_head(self.node, f"{joint}: {gains}")}'
                               f'<div class="step-scene">{plot._repr_html_()}{wheel}</div>')
        parts = ''.join(f'<span>{html.escape(words)}{_mark(met, goal)}</span>'
                        for words, met, goal in verdicts(response.figures))
        self._figures.value = f'<div class="step-figures" role="status">{parts}</div>'

    def _say(self, words: str) -> None:
        self._text = words
        self._picture.value = _head(self.node, '')
        self._response = self._before = None
        self._figures.value = f'<div class="step-figures" role="status">{html.escape(words)}</div>'


def _head(node: str, words: str) -> str:
    return (f'<div class="step-head"><span class="step-node">{html.escape(node)}</span>'
            f'<span>{html.escape(words)}</span></div>')


def _mark(met: bool | None, goal: str) -> str:
    if met is None:
        return ''
    shape, words, css_class = ('✓', 'goal met', 'step-met') if met else ('✗', 'not yet', 'step-missed')
    return f' <b class="{css_class}">{shape} {words}: {html.escape(goal)}</b>'
