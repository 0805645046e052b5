"""CallsView: service calls of this notebook, each with its request and what came of it."""

from collections.abc import Iterable, Mapping
from typing import Any

from rclpy.node import Node

from param_tools import values
from param_tools.errors import NodeError, NodeNotFoundError
from param_tools.node.client import SetResult, to_message
from param_tools.ros import stage
from param_tools.ros.service_types import SERVICE_TYPES
from param_tools.ros.services import TIMEOUT_SEC, full_name
from param_tutorial.views.base import PictureView
from param_tutorial.views.drawing.calls import Call, Line, draw_calls


class CallsView(PictureView):
    """Service calls of this notebook, each with its request and what came of it. Show it as the last line of a cell."""

    def __init__(self, *, timeout_sec: float = TIMEOUT_SEC) -> None:
        """:param timeout_sec: How long a node may take to be found, and then to answer."""
        self._timeout_sec = timeout_sec
        self._calls: list[Call] = []
        super().__init__(draw_calls(_NOTEBOOK, []))

    def call(self, node: str | Node, service: str, carries: Mapping[str, Any] | Iterable[str] = ()) -> None:
        """Call a parameter service once, and add what came of it; the picture plays anew with it.

        :param node: The node, or its name.
        :param service: ``'get_parameters'``, ``'list_parameters'``, ``'set_parameters'``, or
            ``'set_parameters_atomically'``.
        :param carries: What the request holds: names for the first, prefixes for the second, values by name for the
            others.
        :raises ValueError: it is none of these services.
        :raises InvalidValueError: no parameter can hold a value.
        :raises ExecutorError: no executor is running.
        """
        if service not in _REQUEST_FIELDS:
            raise ValueError(f'a CallsView calls {", ".join(_REQUEST_FIELDS)}, not {service!r}')
        name, field = full_name(node), _REQUEST_FIELDS[service]
        lines = tuple(f'{each} = {values.format_value(value, 24)}' for each, value in carries.items()) \
            if isinstance(carries, Mapping) else tuple(carries)
        content = [to_message(each, values.normalize(value)) for each, value in carries.items()] \
            if isinstance(carries, Mapping) else list(lines)
        services = stage.current().services
        try:
            answer = services.call(name, service, SERVICE_TYPES[service].Request(**{field: content}),
                                   timeout_sec=self._timeout_sec)
        except NodeNotFoundError as error:
            self._add(Call(name, service, lines, problem=str(error), is_delivered=False))
        except NodeError as error:
            self._add(Call(name, service, lines, problem=str(error)))
        else:
            self._add(Call(name, service, lines, tuple(_lines_of(answer, name, carries))))

    def _add(self, call: Call) -> None:
        self._calls.append(call)
        self._replace(draw_calls(_NOTEBOOK, self._calls))


_NOTEBOOK = 'this notebook'
_REQUEST_FIELDS = {'get_parameters': 'names', 'list_parameters': 'prefixes', 'set_parameters': 'parameters',
                   'set_parameters_atomically': 'parameters'}


def _lines_of(answer: Any, node: str, asked: Mapping[str, Any] | Iterable[str]) -> list[Line]:
    """Return what an answer holds; of names no more than it has itself."""
    if hasattr(answer, 'values'):
        lines = [Line(values.format_value(values.to_python(each), 30)) for each in answer.values]
        return lines or [Line('no values at all')]
    if isinstance(asked, Mapping):
        results = [answer.result] if hasattr(answer, 'result') else answer.results
        pairs = zip(asked.items(), results, strict=False)
        return [_judged(SetResult(node, *pair, each.successful, each.reason)) for pair, each in pairs]
    return [Line(each) for each in answer.result.names] or [Line('no names at all')]


def _judged(result: SetResult) -> Line:
    if result.successful:
        return Line('accepted', True)
    return Line('rejected' if result.kind.startswith('rejected') else f'rejected: {result.kind}', False)
