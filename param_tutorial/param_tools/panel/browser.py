"""The list of nodes: which there are, a search over all their parameters, and the panels of those that are opened."""

from collections.abc import Callable
from typing import Any

import ipywidgets as widgets
import traitlets

from param_tools.markup.scripts import bundle
from param_tools.markup.styles import sheet
from param_tools.markup.wording import format_count
from param_tools.node.live import LiveParameters
from param_tools.node.text import format_value
from param_tools.panel.front import Front
from param_tools.panel.view import FollowingView, View
from param_tools.ros.executor import BackgroundExecutor
from param_tools.ros.services import TIMEOUT_SEC

# Of a node in which a search finds more, these are shown; its panel shows all.
_HITS = 8


class _Front(Front):
    """The list of nodes in the browser."""

    _esm = bundle('param_tools/panel/browser.js')
    _css = sheet('param_tools/panel/panel.css') + sheet('param_tools/panel/browser.css')
    state = traitlets.Dict().tag(sync=True)


class ParameterBrowser(FollowingView):
    """The nodes of a robot as they come and go, a search over all their parameters, and panels of what is opened.

    Show it as the last line of a cell; ``ParameterPanel()`` makes one. ``browser['/node']`` is a node's ParameterPanel.
    """

    def __init__(self, make_panel: Callable[..., View], *, timeout_sec: float = TIMEOUT_SEC, open_first: bool = False):
        """
        :param make_panel: ParameterPanel, whose file imports this one.
        :param timeout_sec: How long a node may take for each answer.
        :param open_first: Whether the first node that there is is opened at once.
        """
        self._make_panel, self._timeout_sec, self._open_first = make_panel, timeout_sec, open_first
        self._nodes: dict[str, LiveParameters] = {}
        """Those that are there, in the order of the alphabet. Replaced as a whole, so that any thread may iterate."""
        self._search = ''
        self._panels: dict[str, View] = {}
        self._front = _Front(state={'nodes': [], 'status': ''})
        self._front.add_class('param-panel')
        self._front.add_class('param-nodes')
        self._front.on_msg(self._on_message)
        self._box = widgets.Box()
        self._box.add_class('node-panels')
        super().__init__([self._front, self._box], 'param-browser')
        self._begin()

    def __repr__(self) -> str:
        return f'<ParameterBrowser{": closed" if self._closed else ""}>'

    def __getitem__(self, node: str) -> View:
        """Return the panel of a node that is open.

        :raises KeyError: it is not open.
        """
        return self._panels[node]

    @property
    def node(self) -> str:
        """What it shows, in the place of one node's name."""
        return 'all nodes'

    @property
    def nodes(self) -> list[str]:
        """The fully qualified names of the nodes that are there."""
        return list(self._nodes)

    def find(self, text: str) -> dict[str, list[str]]:
        """Find parameters in whose node, name, description or value all words of a text stand.

        :return: The parameters' names by node. A node that is found by its own name is there in any case.
        """
        words = text.lower().split()
        found: dict[str, list[str]] = {}
        for name, live in self._nodes.items():
            hits = [each for each, parameter in live.parameters.items() if _has_all(
                words, f'{name} {each} {parameter.descriptor.description} '
                       f'{format_value(parameter.descriptor, parameter.value)}')]
            if hits or _has_all(words, name):
                found[name] = hits
        return found

    def show(self, node: str, *, search: str = '') -> View:
        """Open the panel of a node, without waiting for its answers.

        :param search: What the panel's search field begins with.
        """
        with self._drawing:
            if node in self._panels and search:
                self.hide(node)
            if node not in self._panels:
                self._panels[node] = self._make_panel(node, search=search, timeout_sec=self._timeout_sec,
                                                      patience_sec=0.0)
                self._box.children = tuple(self._panels.values())
        self._job.wake()
        return self._panels[node]

    def hide(self, node: str) -> None:
        """Close the panel of a node, if it is open."""
        with self._drawing:
            if panel := self._panels.pop(node, None):
                self._box.children = tuple(self._panels.values())
                panel.close()
        self._job.wake()

    def _on_message(self, _: Any, content: dict[str, Any], __: Any) -> None:
        """Do what a person did in the browser; called by ipywidgets."""
        if content['do'] == 'find':
            self._search = content['text']
            self._job.wake()
        elif content['do'] == 'toggle' and content['node'] in self._panels:
            self.hide(content['node'])
        else:
            self.show(content['node'], search=content.get('search', ''))

    def _subscribe(self, executor: BackgroundExecutor) -> Callable[[], object]:
        return executor.on_graph_change(self._job.wake)

    def _follow_nodes(self) -> None:
        """Follow the parameters of nodes that have come, and no longer those of nodes that have gone."""
        present = [] if self._executor is None else self._executor.services.node_names()
        before, self._nodes = self._nodes, {name: self._nodes.get(name) or LiveParameters(
            name, self._job.wake, timeout_sec=self._timeout_sec) for name in present}
        for name, live in self._nodes.items():
            if name not in before:
                live.first_look(0)
        for name, live in before.items():
            if name not in self._nodes:
                live.close()

    def _show(self) -> None:
        self._follow_nodes()
        if self._open_first and self._nodes:
            self._open_first = False
            self.show(next(iter(self._nodes)))
        is_searching = bool(self._search.strip())
        found = self.find(self._search) if is_searching else {name: [] for name in self._nodes}
        lines = {name: self._line(name, found.get(name, [])) for name in {*found, *self._panels}}
        status = 'no executor is running' if self._executor is None else format_count(len(self._nodes), 'node')
        if is_searching:
            count = sum(map(len, found.values()))
            status += f', {format_count(count, "parameter")} found in {len(found)}'
        self._front.state = {'status': status, 'nodes': [lines[name] for name in sorted(lines)]}

    def _line(self, name: str, hits: list[str]) -> dict[str, Any]:
        """Return what the list shows of a node."""
        line = {'name': name, 'is_open': name in self._panels}
        live = self._nodes.get(name)
        if live is None:
            # A panel outlives its node, and should still be closed where it was opened. The node may also be there: one
            # that was stopped for longer than DDS waits answers again, but ROS lists it no more.
            return {**line, 'is_bad': True, 'says': 'not in the graph', 'hits': []}
        parameters = live.parameters
        says = live.status or (format_count(len(parameters), 'parameter') if parameters else 'asking …')
        return {**line, 'is_bad': bool(live.status), 'says': says,
                'hits': [[hit, format_value(parameters[hit].descriptor, parameters[hit].value)]
                         for hit in hits[:_HITS] if hit in parameters]}

    def _end(self) -> None:
        super()._end()
        for live in self._nodes.values():
            live.close()
        for node in list(self._panels):
            self._panels.pop(node).close()


def _has_all(words: list[str], text: str) -> bool:
    lower = text.lower()
    return all(word in lower for word in words)
