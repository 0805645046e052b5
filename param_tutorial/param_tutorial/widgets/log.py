"""The log of the nodes as a widget: the article's "first terminal"."""

import html
from collections.abc import Callable
from typing import Any

from param_tutorial.runtime.executor import BackgroundExecutor
from param_tutorial.runtime.node_log import LogLine, NodeLog
from param_tutorial.runtime.services import full_name
from param_tutorial.widgets.recordable import LOG
from param_tutorial.widgets.view import FeedView

# What fits on several screens; a browser that gets more on every update of a chatty node becomes slow.
CAPACITY = 300

_STYLE = """<style>
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
_NOTHING_YET = '<span class="param-log-quiet">(nothing logged yet)</span>'


class LogView(FeedView):
    """A view of what the nodes log: newest line at the bottom, following the log until it is closed."""

    follows = frozenset({LOG})

    def __init__(self, node: str | None = None, *, executor: BackgroundExecutor | None = None):
        """
        :param node: Only what this node logs; by default what all do.
        :param executor: By default whichever runs in the background, also after a stop and a new start.
        """
        self._logger = None if node is None else full_name(node).strip('/').replace('/', '.')
        self._log: NodeLog | None = None
        super().__init__(node, executor, subject='Log', css_class='param-log', content_class='param-log-lines',
                         style=_STYLE)

    @property
    def lines(self) -> list[str]:
        """The lines that it holds, oldest first."""
        return list(map(str, self._recent()))

    def _recent(self) -> list[LogLine]:
        return self._log.recent(self._node, CAPACITY) if self._log is not None else []

    def _subscribe(self, executor: BackgroundExecutor) -> Callable[[], None]:
        self._log = executor.node_log
        return self._log.on_line(self._on_line)

    def _on_line(self, line: LogLine) -> None:
        if self._logger in (None, line.logger):
            self._worker.wake()

    def _markup(self) -> str:
        text = '\n'.join(map(_line_markup, self._recent()))
        return (f'<pre role="log" tabindex="0" aria-label="{html.escape(self._title)}">'
                f'{text or _NOTHING_YET}</pre>')

    def snapshot(self) -> dict[str, Any]:
        """Return what a page without a kernel needs to draw the log as it stands."""
        return {'kind': 'log', 'node': self.node, 'lines': self.lines}


def _line_markup(line: LogLine) -> str:
    text = html.escape(str(line))
    return f'<span class="param-log-loud">{text}</span>' if line.level in ('WARN', 'ERROR', 'FATAL') else text
