"""What nodes publish on /parameter_events as a live table: whose parameter, what became of it, its value."""

import html
import threading
from collections import deque
from collections.abc import Callable
from typing import Any, NamedTuple

import ipywidgets as widgets
from rcl_interfaces.msg import ParameterEvent

from param_tools import values
from param_tools.markup.styles import style
from param_tools.markup.tables import table
from param_tools.panel.view import FollowingView
from param_tools.ros.executor import BackgroundExecutor
from param_tools.ros.services import full_name

# As many as fit on a few screens; older ones are dropped.
CAPACITY = 200

_STYLE = style('param_tutorial/views/events.css')


class EventRow(NamedTuple):
    """What became of one parameter, as an event reports it."""

    node: str
    kind: str
    """'new', 'changed' or 'deleted'."""
    name: str
    value: Any
    """None if it was deleted."""


class EventView(FollowingView):
    """A table of what is published on /parameter_events from now on, newest first, until it is closed."""

    def __init__(self, node: str | None = None) -> None:
        """
        :param node: Only the events of this node; by default those of all nodes whose names do not begin with an
            underscore.
        """
        self._lock = threading.Lock()
        self._changes: deque[EventRow] = deque(maxlen=CAPACITY)
        self._node = None if node is None else full_name(node)
        self._content = widgets.HTML()
        self._content.add_class('param-events-rows')
        self._title = html.escape(f'Changes of {self.node}')
        heading = widgets.HTML(f'{_STYLE}<b>{self._title}</b>')
        heading.add_class('param-events-title')
        super().__init__([heading, self._content], 'param-events')
        self._begin()

    def __repr__(self) -> str:
        return f'<EventView: {self.node}>'

    @property
    def node(self) -> str:
        """The fully qualified name of the node that it listens to, or 'all nodes'."""
        return self._node or 'all nodes'

    @property
    def changes(self) -> list[EventRow]:
        """The changes in the table, oldest first."""
        with self._lock:
            return list(self._changes)

    def _subscribe(self, executor: BackgroundExecutor) -> Callable[[], None]:
        return executor.on_parameter_event(self._on_event)

    def _on_event(self, event: ParameterEvent) -> None:
        if event.node == self._node or (self._node is None and '/_' not in event.node):
            changes = [EventRow(event.node, kind, each.name, values.to_python(each.value))
                       for kind, parameters in (('new', event.new_parameters), ('changed', event.changed_parameters),
                                                ('deleted', event.deleted_parameters))
                       for each in parameters]
            with self._lock:
                self._changes.extend(changes)
            self._job.wake()

    def _show(self) -> None:
        rows = [(each.node, each.kind, each.name, '' if each.kind == 'deleted' else values.format_value(each.value))
                for each in reversed(self.changes)]
        self._content.value = (f'<div role="log" tabindex="0" aria-label="{self._title}">'
                               f'{table(("node", "what", "parameter", "value"), rows)}</div>')
