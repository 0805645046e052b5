"""What comes in on /parameter_events as a live table: whose parameter, what became of it, its value."""

import html
import threading
from collections import deque
from collections.abc import Callable
from typing import Any, NamedTuple

from rcl_interfaces.msg import ParameterEvent

from param_tutorial.parameters import values
from param_tutorial.pictures.markup import cells, head_row
from param_tutorial.runtime.executor import BackgroundExecutor
from param_tutorial.widgets.recordable import EVENTS, html_of
from param_tutorial.widgets.view import FeedView

# What fits on a few screens; older ones are forgotten.
CAPACITY = 200

_STYLE = """<style>
.param-events { border: 1px solid var(--jp-border-color2, #bdbdbd); border-radius: 6px; padding: 0; margin: 4px 0;
  max-width: 56em; background: var(--jp-layout-color1, #fff); color: var(--jp-ui-font-color1, #212121); }
.param-events .param-events-title { margin: 0; padding: 2px 10px; line-height: 20px;
  border-bottom: 1px solid var(--jp-border-color2, #bdbdbd); }
.param-events .param-events-rows { overflow: auto; max-height: 16em; margin: 0; padding: 0 10px; }
.param-events table { border-collapse: collapse; width: 100%; font-size: var(--jp-code-font-size, 13px); }
.param-events table th, .param-events table td { text-align: left !important; padding: 3px 12px 3px 0;
  vertical-align: top; }
.param-events table td { font-family: var(--jp-code-font-family, monospace); overflow-wrap: anywhere;
  border-top: 1px solid var(--jp-border-color3, #e0e0e0); }
</style>"""


class Change(NamedTuple):
    """What an event tells of one parameter."""

    node: str
    kind: str
    """'new', 'changed' or 'deleted'."""
    name: str
    value: Any
    """None if it was deleted."""


def told_by(event: ParameterEvent) -> list[Change]:
    """Give what an event tells of, in the order of the message."""
    return [Change(event.node, kind, each.name, values.to_python(each.value))
            for kind, parameters in (('new', event.new_parameters), ('changed', event.changed_parameters),
                                     ('deleted', event.deleted_parameters))
            for each in parameters]


class EventView(FeedView):
    """A table of what is told on /parameter_events from now on, the newest on top, until it is closed."""

    follows = frozenset({EVENTS})

    def __init__(self, node: str | None = None, *, executor: BackgroundExecutor | None = None):
        """
        :param node: Only the events of this node; by default those of all but the ones whose name begins with an
            underscore.
        :param executor: By default whichever runs in the background, also after a stop and a new start.
        """
        self._lock = threading.Lock()
        self._changes: deque[Change] = deque(maxlen=CAPACITY)
        super().__init__(node, executor, subject='Changes', css_class='param-events',
                         content_class='param-events-rows', style=_STYLE)

    @property
    def changes(self) -> list[Change]:
        """What the table holds, oldest first."""
        with self._lock:
            return list(self._changes)

    def _subscribe(self, executor: BackgroundExecutor) -> Callable[[], None]:
        return executor.on_parameter_event(self._on_event)

    def _on_event(self, event: ParameterEvent) -> None:
        if event.node == self._node or (self._node is None and '/_' not in event.node):
            with self._lock:
                self._changes.extend(told_by(event))
            self._worker.wake()

    def _markup(self) -> str:
        rows = ''.join(_row(change) for change in reversed(self.changes))
        head = head_row(('node', 'what', 'parameter', 'value'))
        return (f'<div role="log" tabindex="0" aria-label="{html.escape(self._title)}">'
                f'<table><thead>{head}</thead><tbody>{rows}</tbody></table></div>')

    def snapshot(self) -> dict[str, Any]:
        """Return what a page without a kernel needs to draw the table as it stands."""
        return {'kind': 'events', 'node': self.node, 'html': html_of(self)}


def _row(change: Change) -> str:
    value = '' if change.kind == 'deleted' else values.format_value(change.value)
    return f'<tr>{cells((change.node, change.kind, change.name, value))}</tr>'
