"""The log of the nodes as a widget: the article's "first terminal"."""

import html
from collections.abc import Callable

import ipywidgets as widgets

from param_tutorial import background
from param_tutorial.cells import close_with_cell
from param_tutorial.errors import ExecutorError
from param_tutorial.node_log import LogLine, NodeLog
from param_tutorial.services import full_name
from param_tutorial.worker import Worker

# What fits on several screens; a browser that gets more on every update of a chatty node becomes slow.
CAPACITY = 300
_SHOW_PERIOD_SEC = 0.1

STYLE = """<style>
.param-log { border: 1px solid var(--jp-border-color2, #bdbdbd); border-radius: 6px; padding: 0;
  background: var(--jp-layout-color1, #fff); margin: 4px 0; }
.param-log .param-log-title { margin: 0; padding: 2px 10px; line-height: 20px;
  border-bottom: 1px solid var(--jp-border-color2, #bdbdbd); color: var(--jp-ui-font-color1, #212121); }
.param-log .param-log-lines { display: flex; flex-direction: column-reverse; overflow: auto; max-height: 16em;
  margin: 0; padding: 0; }
.param-log .param-log-lines .widget-html-content { display: block; width: 100%; }
.param-log pre { font-family: var(--jp-code-font-family, monospace); font-size: var(--jp-code-font-size, 13px);
  line-height: 1.4; margin: 0; padding: 6px 10px; color: var(--jp-content-font-color1, #212121);
  background: transparent; white-space: pre-wrap; overflow-wrap: anywhere; outline-offset: -2px; }
.param-log .param-log-quiet { color: var(--jp-ui-font-color2, #616161); }
.param-log .param-log-loud { font-weight: bold; }
</style>"""


class LogView(widgets.VBox):
    """A view of what the nodes log: newest line at the bottom, following the log until it is closed."""

    # Until it is built: ipywidgets closes even a widget whose constructor has raised an exception.
    _closed = True

    def __init__(self, node: str | None = None, *, executor: background.BackgroundExecutor | None = None):
        """
        :param node: Only what this node logs; by default what all do.
        :param executor: By default whichever runs in the background, also after a stop and a new start.
        """
        self._node = None if node is None else full_name(node)
        self._logger = None if node is None else self._node.strip('/').replace('/', '.')
        self._chosen_executor = executor
        self._log: NodeLog | None = None
        self._closed = False
        self._stop_listening: Callable[[], None] = lambda: None
        title = f'Log of {self._node or "all nodes"}'
        self._content = widgets.HTML()
        self._content.add_class('param-log-lines')
        heading = widgets.HTML(f'{STYLE}<b>{html.escape(title)}</b>')
        heading.add_class('param-log-title')
        self._title = title
        super().__init__([heading, self._content])
        self.add_class('param-log')
        self._worker = Worker(self._show, 'log view', _SHOW_PERIOD_SEC)
        self._stop_following = background.on_change(self._on_executor_change)
        self._listen()
        self._worker.call_now(1.0)
        close_with_cell(self)

    def __repr__(self) -> str:
        return f'<LogView: {self._node or "all nodes"}>'

    @property
    def lines(self) -> list[str]:
        """The lines that it holds, oldest first."""
        return list(map(str, self._recent()))

    def _recent(self) -> list[LogLine]:
        return self._log.recent(self._node, CAPACITY) if self._log is not None else []

    def close(self) -> None:
        """Stop following the log and remove the view from the page."""
        if self._closed:
            return
        self._closed = True
        self._stop_following()
        self._stop_listening()
        self._worker.end()
        # Emptied first: a browser cannot take a widget out of a box that is gone, and says so.
        parts, self.children = self.children, ()
        super().close()
        for each in parts:
            each.close()

    def _on_executor_change(self) -> None:
        if self._chosen_executor is None:
            self._listen()
            self._worker.wake()

    def _listen(self) -> None:
        self._stop_listening()
        try:
            self._log = (self._chosen_executor or background.current()).node_log
        except ExecutorError:  # stopped: what was logged before stays readable
            self._stop_listening = lambda: None
        else:
            self._stop_listening = self._log.on_line(self._on_line)

    def _on_line(self, line: LogLine) -> None:
        if self._logger in (None, line.logger):
            self._worker.wake()

    def _show(self) -> bool:
        if self._closed:
            return False
        text = '\n'.join(map(_markup, self._recent())) or '<span class="param-log-quiet">(nothing logged yet)</span>'
        self._content.value = (f'<pre role="log" tabindex="0" aria-label="{html.escape(self._title)}">'
                               f'{text}</pre>')
        return False


def _markup(line: LogLine) -> str:
    text = html.escape(str(line))
    return f'<span class="param-log-loud">{text}</span>' if line.level in ('WARN', 'ERROR', 'FATAL') else text
