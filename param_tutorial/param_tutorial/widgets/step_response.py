"""The step response of a controller, drawn again whenever somebody changes its gains.

The view asks the node for nothing but its parameters and simulates the wheel itself. So it works as well on a
controller in another process, and what it shows is what the node has confirmed.
"""

import html
import re
from typing import Any

import ipywidgets as widgets
from rclpy.node import Node

from param_tutorial.nodes.pid_controller_node import response_of
from param_tutorial.parameters.client import ParameterClient
from param_tutorial.parameters.live import LiveParameters
from param_tutorial.pictures.plots import plot_responses
from param_tutorial.pictures.styles import style
from param_tutorial.runtime.executor import BackgroundExecutor
from param_tutorial.runtime.services import TIMEOUT_SEC, full_name
from param_tutorial.widgets.cells import close_with_cell
from param_tutorial.widgets.recordable import html_of
from param_tutorial.widgets.view import View

_STYLE = style('widgets/step_response.css')


class StepResponseView(View):
    """The step response of a PidControllerNode, drawn again whenever its parameters change, until it is closed.

    Show it as the last line of a cell.
    """

    def __init__(self, node: str | Node | ParameterClient, *, joint: str | None = None,
                 executor: BackgroundExecutor | None = None, timeout_sec: float = TIMEOUT_SEC) -> None:
        """
        :param node: The node or its name; it may run in another process, and it may be absent now.
        :param joint: Which of its joints; by default the first.
        :param executor: Carries the requests; by default the one that runs in the background.
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
