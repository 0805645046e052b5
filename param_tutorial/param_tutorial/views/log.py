"""The log of the nodes as a widget: the article's "first terminal"."""

import html
from collections.abc import Callable

from param_tools.markup.styles import style
from param_tools.panel.view import FeedView
from param_tools.ros.executor import BackgroundExecutor
from param_tools.ros.node_log import LogLine, NodeLog
from param_tools.ros.services import full_name

# As many as fit on several screens. More, sent again with each line of a chatty node, would slow a browser down.
CAPACITY = 300

_STYLE = style('param_tutorial/views/log.css')
_NOTHING_YET = '<span class="param-log-quiet">(nothing logged yet)</span>'


class LogView(FeedView):
    """A view of what the nodes log: newest line at the bottom, following the log until it is closed."""

    def __init__(self, node: str | None = None) -> None:
        """:param node: Only what this node logs; by default what all nodes log."""
        self._logger = None if node is None else full_name(node).strip('/').replace('/', '.')
        self._log: NodeLog | None = None
        super().__init__(node, subject='Log', css_class='param-log', content_class='param-log-lines',
                         style=_STYLE)

    @property
    def lines(self) -> list[str]:
        """The lines in the view, oldest first."""
        return list(map(str, self._recent()))

    def _recent(self) -> list[LogLine]:
        return self._log.recent(self._node, CAPACITY) if self._log is not None else []

    def _subscribe(self, executor: BackgroundExecutor) -> Callable[[], None]:
        self._log = executor.node_log
        return self._log.on_line(self._on_line)

    def _on_line(self, line: LogLine) -> None:
        if self._logger in (None, line.logger):
            self._job.wake()

    def _markup(self) -> str:
        text = '\n'.join(map(_line_markup, self._recent()))
        return (f'<pre role="log" tabindex="0" aria-label="{html.escape(self._title)}">'
                f'{text or _NOTHING_YET}</pre>')


def _line_markup(line: LogLine) -> str:
    text = html.escape(str(line))
    return f'<span class="param-log-loud">{text}</span>' if line.level in ('WARN', 'ERROR', 'FATAL') else text
