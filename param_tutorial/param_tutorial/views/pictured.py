"""Pictures that play what was measured before they are shown. They follow nothing; the browser moves them.

What they look like is in the room ``pictures``. Those that follow a node are in ``motion``.
"""

import itertools
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Protocol

from rclpy.node import Node

from param_tools import values
from param_tools.errors import InvalidValueError, NodeError, NodeNotFoundError, ParameterNotDeclaredError
from param_tools.node.client import ParameterClient, SetResult, to_message
from param_tools.node.declarations import record_declarations
from param_tools.panel.close_with_cell import close_with_cell
from param_tools.ros import stage
from param_tools.ros.executor import BackgroundExecutor
from param_tools.ros.service_types import SERVICE_TYPES
from param_tools.ros.services import TIMEOUT_SEC, full_name
from param_tutorial.pictures import motion
from param_tutorial.pictures.calls import Call, Calls, Line
from param_tutorial.pictures.checks import Checks
from param_tutorial.pictures.layers import Layers
from param_tutorial.pictures.lifts import Lifts
from param_tutorial.pictures.plane import Plane, Point
from param_tutorial.pictures.requests import Request, Requests
from param_tutorial.pictures.trail import Trail
from param_tutorial.pictures.worlds import Worlds
from param_tutorial.views.reel import ReelView


class Picture(Protocol):
    """What a picture can tell of itself."""

    @property
    def subject(self) -> str:
        """What it is of."""

    @property
    def sentence(self) -> str:
        """What it shows, in short."""

    @property
    def text(self) -> str:
        """The whole of it in words, as a screen reader tells it."""

    def html(self, reel: motion.Reel) -> str:
        """Return it as HTML."""


class PictureView(ReelView):
    """A picture on the page, until it is closed."""

    def __init__(self, picture: Picture) -> None:
        self._picture = picture
        super().__init__()
        self._draw()
        close_with_cell(self)

    def __repr__(self) -> str:
        return f'<{type(self).__name__}: {self._picture.sentence}{", closed" if self._closed else ""}>'

    @property
    def text(self) -> str:
        """What the picture shows, in words, as a screen reader tells it."""
        return self._picture.text

    @property
    def node(self) -> str:
        """What the view is of; no node is asked."""
        return self._picture.subject

    def _draw(self) -> None:
        with self._drawing:
            if not self._closed:
                self._put(self._picture.html)

    def _end(self) -> None:
        pass


class LayersView(PictureView):
    """The sources of one parameter's value, as layers that cover each other. Show it as the last line of a cell."""

    def __init__(self, name: str, sources: Iterable[tuple[str, Any] | tuple[str, str, Any]], *, has: Any = ...) -> None:
        """
        :param name: The parameter.
        :param sources: In the order in which they are given to the node: a source and its value, or a source, the
            name of the layer into which it goes, and its value. A layer that is there already is changed where it
            lies; a new one, and a source without such a name, comes on top.
        :param has: What the node has in the end, if it was asked.
        :raises ValueError: there is no source.
        """
        super().__init__(Layers(name, sources, has=has))


class TrailView(PictureView):
    """Places that hold values, moment by moment, and what travels between them. Show it as the last line of a cell."""

    def __init__(self, subject: str, places: Sequence[str]) -> None:
        """
        :param subject: What the picture is of, e.g. a node's name or a file's.
        :param places: Their names, from the left to the right; each stands in the heading of a column.
        :raises ValueError: there is no place, or two have one name.
        """
        self._trail = Trail(subject, places)
        super().__init__(self._trail)

    def add(self, words: str, values: Sequence[Any], *moves: tuple[str, str] | tuple[str, str, Any, str],
            note: str = '') -> None:
        """Add a moment; the picture plays anew with it.

        :param words: What happens, e.g. ``'colcon build'``.
        :param values: What each place holds when it is over, as it was measured; ``...`` for nothing.
        :param moves: What travels: from which place ('' for from outside) and to which. For what the second place
            does not take, also the value, and why.
        :param note: What is worth seeing in this moment.
        :raises ValueError: there are not as many values as places, or no such place, or a value arrives where there
            is none afterwards.
        """
        self._trail.add(words, values, *moves, note=note)
        self._draw()


class LiftsView(PictureView):
    """Lifts that rise beside each other at the speeds of their nodes. Show it as the last line of a cell."""

    def __init__(self, heights: Mapping[str, Sequence[tuple[float, float]]],
                 marks: Mapping[float, str] | None = None) -> None:
        """
        :param heights: By lift, points in time in s and its height there in m; in between it rises evenly.
        :param marks: What happens, by the time in s.
        :raises ValueError: there is no lift, or one without two points, or no time passes.
        """
        super().__init__(Lifts(heights, marks))


class WorldsView(PictureView):
    """Who keeps a parameter's values in one world and in another. Show it as the last line of a cell."""

    def __init__(self, name: str) -> None:
        """Begin without a world.

        :param name: The parameter.
        """
        self._worlds = Worlds(name)
        super().__init__(self._worlds)

    def add(self, title: str, values: Mapping[str, Any], *, killed: str, successor: Any, server: str = '') -> None:
        """Add a world; the picture plays anew with it.

        :param values: What each node has set the parameter to, as it was measured.
        :param killed: The node that is killed and started again.
        :param successor: What the new node of that name begins with.
        :param server: Who keeps the values of all nodes; empty if each node keeps its own.
        :raises ValueError: there are two worlds already, or no value belongs to the node that is killed, or there is
            another one below a server.
        """
        self._worlds.add(title, values, killed=killed, successor=successor, server=server)
        self._draw()


class ChecksView(PictureView):
    """Requests on their way through a node's checks, to the one that stops them. Show it as the last line of a cell.

    The node is asked once for each, and keeps what it accepts.
    """

    def __init__(self, node: str | Node | ParameterClient, requests: Iterable[tuple[str, Any]], *,
                 executor: BackgroundExecutor | None = None) -> None:
        """
        :param node: The node, or its name.
        :param requests: Names and values, one request for each; None deletes a parameter.
        :param executor: Carries the requests; by default the one that runs in the background.
        :raises ValueError: there is no request.
        :raises InvalidValueError: no parameter can hold a value.
        :raises NodeNotFoundError: there is no such node.
        """
        client = node if isinstance(node, ParameterClient) else ParameterClient(node, executor=executor)
        super().__init__(Checks(client.node, [
            (name, values.format_value(value), client.set_parameter(name, value).kind) for name, value in requests]))


class RequestsView(PictureView):
    """Requests that are sent in two ways, or in two worlds, beside each other. Show it as the last line of a cell."""

    def __init__(self, subject: str, *, executor: BackgroundExecutor | None = None) -> None:
        """Begin without a side.

        :param subject: What the picture is of; a parameter of that name is not named again in each request.
        :param executor: Carries the requests; by default the one that runs in the background.
        """
        self._executor = executor
        self._requests = Requests(subject)
        super().__init__(self._requests)

    def send(self, title: str, node: str | Node | ParameterClient,
             requests: Mapping[str, Any] | Iterable[tuple[str, Any]], *, atomically: bool = False) -> None:
        """Send requests to a node, and add a side with what came of them; the node keeps what it accepts.

        :param title: Stands above the side.
        :param node: The node, or its name.
        :param requests: Names and values; of pairs, a name may be there more than once.
        :param atomically: Whether all go as one request, in which each name is there once.
        :raises ValueError: there are two sides already, or there is no request.
        :raises InvalidValueError: no parameter can hold a value of an atomic request. A single request of that kind
            is shown as rejected.
        :raises NodeNotFoundError: there is no such node.
        """
        self._requests.require_room()
        client = node if isinstance(node, ParameterClient) else ParameterClient(node, executor=self._executor)
        pairs = list(requests.items() if isinstance(requests, Mapping) else requests)
        before = {name: values.format_value(value) for name, value in client.get_parameters().items()}
        told = _sent_as_one(client, dict(pairs)) if atomically else [_sent(client, *pair) for pair in pairs]
        self._requests.add(title, client.node, before, told, is_one=atomically)
        self._draw()

    def add_lenient(self, title: str, node: str, has: Mapping[str, Any], requests: Iterable[tuple[str, Any]], *,
                    server: str) -> None:
        """Add a side of a world in which nothing is rejected; nothing is sent.

        :param title: Stands above the side.
        :param node: The node that gets the values in the end.
        :param has: What is kept at first.
        :param requests: Names and values.
        :param server: Who keeps the values for the node.
        :raises ValueError: there are two sides already, or there is no request.
        """
        told = [Request(name, shown, shown) for name, shown in
                ((name, values.format_value(value)) for name, value in requests)]
        self._requests.add(title, node, {name: values.format_value(value) for name, value in has.items()}, told,
                           server=server)
        self._draw()

    def conclude(self, note: str) -> None:
        """Say below the last side what it comes to.

        :raises ValueError: there is no side yet.
        """
        self._requests.conclude(note)
        self._draw()


def _sent(client: ParameterClient, name: str, value: Any) -> Request:
    try:
        objection = _objection(client.set_parameter(name, value))
    except InvalidValueError:
        # It fits no message, so it never leaves.
        objection = 'no type for it'
    return Request(name, values.format_value(value), _stored(client, name), objection)


def _sent_as_one(client: ParameterClient, wanted: Mapping[str, Any]) -> list[Request]:
    results = client.set_parameters_atomically(dict(wanted))
    return [Request(each.name, values.format_value(each.value), _stored(client, each.name), _objection(each))
            for each in results]


def _objection(result: SetResult) -> str:
    return '' if result.successful else result.kind


def _stored(client: ParameterClient, name: str) -> str:
    """Return what the node has, as text, or a word in its place."""
    try:
        return values.format_value(client.get_parameter(name))
    except ParameterNotDeclaredError:
        return 'nothing'


class PlaneView(PictureView):
    """Which pairs of values a node takes, and how requests get from one to another. Show it as the last line of a cell.

    The node is asked for each pair, and then has again what it had before.
    """

    def __init__(self, node: str | Node | ParameterClient, values: Mapping[str, Iterable[float]], *,
                 executor: BackgroundExecutor | None = None) -> None:
        """
        :param node: The node, or its name.
        :param values: Two parameters by name, to the right and upward, and the values to ask for.
        :param executor: Carries the requests; by default the one that runs in the background.
        :raises ValueError: there are not two parameters, or one has not two values.
        :raises NodeNotFoundError: there is no such node.
        """
        if len(values) != 2:
            raise ValueError(f'a PlaneView takes two parameters, not {list(values)}')
        self._client = node if isinstance(node, ParameterClient) else ParameterClient(node, executor=executor)
        self._names = list(values)
        before = self._pair()
        right, up = values.values()
        answers = {pair: self._ask(dict(zip(self._names, pair, strict=True))) for pair in itertools.product(right, up)}
        self._ask(dict(zip(self._names, before, strict=True)))
        self._plane = Plane((self._names[0], self._names[1]), answers)
        super().__init__(self._plane)

    def go(self, name: str, start: Mapping[str, float], *requests: Mapping[str, float]) -> None:
        """Bring the node to a pair, and send it requests; the picture plays the way that they go.

        :param name: What the way is called.
        :param start: Both values with which it begins.
        :param requests: Each is one atomic change of one value or both.
        :raises ValueError: the node does not take the start, or there is no request.
        """
        before = self._pair()
        if not self._ask(start):
            raise ValueError(f'the node does not take the start {dict(start)}')
        begin, steps = self._pair(), []
        for request in requests:
            has = dict(zip(self._names, self._pair(), strict=True))
            wanted = tuple(request.get(each, has[each]) for each in self._names)
            self._ask(request)
            words = ', '.join(f'{each} = {value:g}' for each, value in request.items())
            steps.append((words, (wanted[0], wanted[1]), self._pair()))
        self._ask(dict(zip(self._names, before, strict=True)))
        self._plane.add_way(name, begin, steps)
        self._draw()

    def _ask(self, request: Mapping[str, float]) -> bool:
        return all(result.successful for result in self._client.set_parameters_atomically(dict(request)))

    def _pair(self) -> Point:
        has = self._client.get_parameters(self._names)
        return has[self._names[0]], has[self._names[1]]


class DeclarationsView(TrailView):
    """A node's parameters as they come to be, with what comes from outside. Show it as the last line of a cell."""

    _OUTSIDE, _DECLARED, _HAS = 'from outside', 'declare_parameter', 'the node has'

    def __init__(self, node_class: type[Node], overrides: Mapping[str, Any] | None = None, *,
                 executor: BackgroundExecutor | None = None) -> None:
        """Start a node on the stage, and record what it declares.

        :param node_class: As for ``ros.add()``; its constructor takes no arguments.
        :param overrides: Values from outside, by name, as after ``-p``.
        :param executor: Spins the node; by default the one that runs in the background.
        :raises ExecutorError: no executor is running, or node_class is not a class of nodes.
        """
        overrides = overrides or {}
        node, declarations = record_declarations(node_class, overrides, executor=executor)
        self._client = ParameterClient(node, executor=executor)
        super().__init__(self._client.node, (self._OUTSIDE, self._DECLARED, self._HAS))
        for each in declarations:
            moves = [] if each.value is None else [
                (self._OUTSIDE if each.name in overrides else self._DECLARED, self._HAS)]
            self.add(each.name, (_or_nothing(overrides.get(each.name)), _or_nothing(each.default),
                                 _or_nothing(each.value)), *moves,
                     note='an override' if each.name in overrides else '')
        declared = {each.name for each in declarations}
        for name in (each for each in overrides if each not in declared):
            asked = values.format_value(overrides[name])
            self.add(name, (asked, ..., ...), (self._OUTSIDE, self._HAS, asked, 'ignored'),
                     note='an override, never declared')

    def set_parameter(self, name: str, value: Any) -> None:
        """Set a parameter of the node from outside, and add what comes of it.

        :raises NodeNotFoundError: the node has been removed.
        """
        result, asked = self._client.set_parameter(name, value), values.format_value(value)
        if result.successful:
            stored = values.format_value(self._client.get_parameter(name))
            self.add(f'set {name}', (asked, ..., stored), (self._OUTSIDE, self._HAS))
        else:
            self.add(f'set {name}', (asked, ..., ...), (self._OUTSIDE, self._HAS, asked, 'rejected'),
                     note=result.kind)


class CallsView(PictureView):
    """Service calls of this notebook, each with its request and what came of it. Show it as the last line of a cell."""

    def __init__(self, *, executor: BackgroundExecutor | None = None, timeout_sec: float = TIMEOUT_SEC) -> None:
        """
        :param executor: Carries the calls; by default the one that runs in the background.
        :param timeout_sec: How long a node may take to be found, and then to answer.
        """
        self._executor, self._timeout_sec = executor, timeout_sec
        self._calls = Calls('this notebook')
        super().__init__(self._calls)

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
        told = tuple(f'{each} = {values.format_value(value, 24)}' for each, value in carries.items()) \
            if isinstance(carries, Mapping) else tuple(carries)
        content = [to_message(each, values.normalize(value)) for each, value in carries.items()] \
            if isinstance(carries, Mapping) else list(told)
        services = (self._executor or stage.current()).services
        try:
            answer = services.call(name, service, SERVICE_TYPES[service].Request(**{field: content}),
                                   timeout_sec=self._timeout_sec)
        except NodeNotFoundError as error:
            self._add(Call(name, service, told, problem=str(error), is_delivered=False))
        except NodeError as error:
            self._add(Call(name, service, told, problem=str(error)))
        else:
            self._add(Call(name, service, told, tuple(_lines_of(answer, name, carries))))

    def _add(self, call: Call) -> None:
        self._calls.add(call)
        self._draw()


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


def _or_nothing(value: Any) -> Any:
    return ... if value is None else values.format_value(value)
