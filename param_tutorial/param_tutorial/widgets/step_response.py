"""Step responses as pictures: of some that are at hand, and live, of a controller whose gains are being changed.

The view asks the node for nothing but its parameters and simulates the wheel itself. So it works as well on a
controller in another process, and what it shows is what the node has confirmed.
"""

import html
import math
import re
from collections.abc import Mapping
from typing import Any

import ipywidgets as widgets
from rclpy.node import Node

from param_tutorial.nodes.pid_controller_node import StepResponse, response_of
from param_tutorial.parameters.client import ParameterClient
from param_tutorial.parameters.live import LiveParameters
from param_tutorial.pictures.plots import LinePlot
from param_tutorial.runtime.executor import BackgroundExecutor
from param_tutorial.runtime.services import TIMEOUT_SEC, full_name
from param_tutorial.widgets.cells import close_with_cell
from param_tutorial.widgets.recordable import html_of
from param_tutorial.widgets.view import View

# More points than this would fall upon one another.
_MAX_POINTS = 200
# The axis has room for this overshoot, so that it does not change with every move of a hand.
_ROOM = 1.5

_STYLE = """<style>
.step-view { box-sizing: border-box; max-width: 56em; margin: 4px 0; padding: 0; overflow: hidden;
  border: 1px solid var(--jp-border-color2, #bdbdbd); border-radius: 6px;
  background: var(--jp-layout-color1, #fff); color: var(--jp-ui-font-color1, #212121); }
.step-view .widget-html, .step-view .widget-html-content { line-height: 1.4; height: auto; margin: 0; min-height: 0;
  width: auto; overflow: visible; color: inherit; }
.step-view .step-head { display: flex; flex-wrap: wrap; align-items: baseline; gap: 2px 18px; padding: 6px 14px;
  border-bottom: 1px solid var(--jp-border-color2, #bdbdbd); background: var(--jp-layout-color2, #eee);
  font-variant-numeric: tabular-nums; }
.step-view .step-node { font-family: var(--jp-code-font-family, monospace); font-weight: 600; }
.step-view svg { display: block; margin: 8px auto 0; }
.step-view .step-figures { display: flex; flex-wrap: wrap; gap: 2px 22px; padding: 6px 14px 8px;
  font-variant-numeric: tabular-nums; }
</style>"""


def plot_responses(responses: Mapping[str, StepResponse]) -> LinePlot:
    """Draw step responses over one another, with the reference of the first.

    :param responses: One to three, by name.
    :raises ValueError: there is none, or there are more.
    :raises TypeError: they are no step responses.
    """
    if not isinstance(responses, Mapping) or not all(isinstance(each, StepResponse) for each in responses.values()):
        raise TypeError(f'plot_responses takes a dictionary of step responses, such as '
                        f'{{"p = 0.4": node.response()}}; got {responses!r}')
    if not 1 <= len(responses) <= 3:
        raise ValueError(f'plot_responses takes one to three responses; got {len(responses)}')
    first = next(iter(responses.values()))
    reference = [(0.0, first.reference), (first.points[-1][0], first.reference)]
    words = [f'reference: {first.reference:g} rad/s',
             *(f'{name}: {response.figures}' for name, response in responses.items())]
    return LinePlot({'reference': reference, **{name: _thinned(each.points) for name, each in responses.items()}},
                    x='time in s', y='speed in rad/s', y_reaches=_ROOM * first.reference, text='. '.join(words))


def _thinned(points: list[tuple[float, float]]) -> list[tuple[float, float]]:
    every = math.ceil(len(points) / _MAX_POINTS)
    return [*points[:-1:every], points[-1]]


class StepResponseView(View):
    """The step response of a PidControllerNode, drawn anew whenever its parameters change, until it is closed.

    Show it as the last line of a cell.
    """

    def __init__(self, node: str | Node | ParameterClient, *, joint: str | None = None,
                 executor: BackgroundExecutor | None = None, timeout_sec: float = TIMEOUT_SEC):
        """
        :param node: The node or its name; it may run in another process, and it may be absent now.
        :param joint: Which of its joints; by default the first.
        :param executor: Carries the requests; by default whichever runs in the background.
        :param timeout_sec: How long the node may take for each answer.
        """
        self._node = node.node if isinstance(node, ParameterClient) else full_name(node)
        self._joint = joint
        self._shown: tuple[str, dict[str, Any]] | None = None
        self._text = ''
        self._picture, self._figures = widgets.HTML(), widgets.HTML()
        super().__init__([widgets.HTML(_STYLE), self._picture, self._figures], 'step-view')
        self._live = LiveParameters(self._node, self._show, executor=executor, timeout_sec=timeout_sec)
        self._live.first_look()
        close_with_cell(self)

    def __repr__(self) -> str:
        return f'<StepResponseView: {self._node}{", closed" if self._closed else ""}>'

    @property
    def text(self) -> str:
        """What the view shows, in words, as a screen reader tells it."""
        return self._text

    def settle(self, timeout_sec: float = 10.0) -> None:
        """Wait until the view shows what the node has now.

        :raises WaitTimeoutError: it took too long.
        """
        self._live.settle(timeout_sec)

    def _end(self) -> None:
        self._live.close()

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
                joint = self._joint or parameters['dof_names'][0]
                response = response_of(parameters, joint)
                figures = str(response.figures)
            except KeyError as missing:
                self._say(f'{self._node} has no parameter {missing.args[0]}, so there is nothing to simulate.')
                return
            except Exception as error:
                # Somebody else's controller may hold whatever its author lets it.
                self._say(f'{self._node} holds values with which nothing can be simulated: '
                          f'{type(error).__name__}: {error}')
                return
            gains = ', '.join(f'{name} = {parameters[f"gains.{joint}.{name}"]:g}' for name in 'pid')
            self._text = f'{joint} with {gains}: {figures}'
            self._picture.value = (
                f'{_head(self._node, f"{joint}: {gains}")}{plot_responses({joint: response})._repr_html_()}')
            parts = ''.join(f'<span>{part}</span>' for part in figures.split(', '))
            self._figures.value = f'<div class="step-figures" role="status">{parts}</div>'

    def _say(self, words: str) -> None:
        self._text = words
        self._picture.value = _head(self._node, '')
        self._figures.value = f'<div class="step-figures" role="status">{html.escape(words)}</div>'

    # -- recording: see ``recordable`` -------------------------------------------------------------------

    in_motion = False

    @property
    def node(self) -> str:
        """The fully qualified name of the node."""
        return self._node

    def rest(self) -> None:
        """Wait until the view shows what the node has now."""
        self.settle()

    def snapshot(self) -> dict[str, Any]:
        """Return what a page without a kernel needs to draw it as it stands."""
        return {'kind': 'steps', 'node': self.node, 'html': html_of(self)}

    def look(self) -> str:
        """Return the picture of what the node has now, without the style sheet."""
        self.settle()
        return re.sub(r'<style>.*?</style>', '', html_of(self), flags=re.DOTALL)

    def film(self) -> None:
        """Return nothing: the picture stands still."""


def _head(node: str, words: str) -> str:
    return (f'<div class="step-head"><span class="step-node">{html.escape(node)}</span>'
            f'<span>{html.escape(words)}</span></div>')
