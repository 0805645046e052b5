"""Plots in a panel: parameters and fields of topics over the last 30 s, with a mark wherever a parameter changed.

Messages are sampled in the executor's thread, with the time at which they arrived by this machine's clock. A job of
``schedule`` sends what is new to the browser, where ``plots.js`` draws it. A parameter's curve is what its panel shows,
and a ``ChangeFollower`` hears what changed on any node. While no plot is open, nothing is heard or sent.
"""

import contextlib
import functools
import math
import re
import time
from collections import deque
from collections.abc import Callable, Mapping
from typing import Any

import traitlets
from rclpy.subscription import Subscription
from rclpy.topic_or_service_is_hidden import topic_or_service_is_hidden

from param_tools import values
from param_tools.errors import ExecutorError, ParameterToolError, describe_error, nearest
from param_tools.panel.front import Front
from param_tools.panel.view import nothing
from param_tools.ros import host, stage
from param_tools.ros.executor import BackgroundExecutor
from param_tools.ros.schedule import Job
from param_tools.ros.topics import getter, matching_qos, message_class, numeric_fields
from param_tools.systems.change_log import LoggedChange, follow_soon

_SHOWN_SEC = 30.0
_SEND_PERIOD_SEC = 0.1
# The browser takes longer silence for a kernel that has ended.
_HEARTBEAT_SEC = 1.0
# A hundred samples a second are kept; of a faster topic, some are left out.
_SAMPLE_PERIOD_SEC = 0.0095
_SAMPLES = round(_SHOWN_SEC * 100)
_MARKS = 500
# A change so soon after this process has asked for one was made here.
_OWN_SEC = 2.0
_LETTERS = 40

Sample = tuple[float, float | None]


class PlotFront(Front):
    """A view in the browser that has plots."""

    plots = traitlets.Dict().tag(sync=True)


class Curve:
    """A number over time: a parameter of the panel's node, or a field of a topic's messages."""

    def __init__(self, name: str):
        """:param name: The parameter's, or topic and field as in ``/odom.pose.pose.position.x``."""
        self.name = name
        self.topic, _, field = name.partition('.') if name.startswith('/') else ('', '', '')
        self._get = getter(field)
        self.word = ''
        """Why nothing new comes; empty if it does."""
        self.samples: deque[Sample] = deque(maxlen=_SAMPLES)
        self.fresh: deque[Sample] = deque(maxlen=_SAMPLES)
        """What has not been sent yet."""

    def add(self, at: float, value: Any) -> None:
        """Add a sample; one that is not finite is a gap, like None."""
        number = _finite(value)
        self.samples.append((at, number))
        self.fresh.append((at, number))

    def end(self, word: str) -> None:
        """Take note that nothing more comes, and why."""
        self.word = word
        if self.samples and self.samples[-1][1] is not None:
            self.add(time.time(), None)

    def hear(self, message: Any) -> None:
        """Sample a message."""
        now = time.time()
        if self.samples and now - self.samples[-1][0] < _SAMPLE_PERIOD_SEC:
            return
        try:
            value = self._get(message)
            self.add(now, value[0] if isinstance(value, bytes) else value)  # rclpy returns a byte as bytes
            self.word = ''
        except IndexError:
            self.end('its last message had fewer elements')
        except (AttributeError, TypeError):
            self.end(f'no number of this name in {type(message).__name__}')


def is_number(value: Any) -> bool:
    """True if a parameter's value can be drawn."""
    return isinstance(value, int | float) and not isinstance(value, bool)


class Plots:
    """The open plots of a panel, by the row that each stands below; '' for one that stands below the head."""

    def __init__(self, front: PlotFront, present: Callable[[], tuple[Mapping[str, Any], str]] = lambda: ({}, '')):
        """
        :param present: Returns what the panel's node has confirmed, by the parameters' names, and why nothing is known
            of it now; empty if all is well. Called with the front's lock held.
        """
        self._front, self._present = front, present
        # Guarded by the front's lock, as all that is written to it.
        self._open: dict[str, list[str]] = {}
        self._curves: dict[str, Curve] = {}
        self._by_topic: dict[str, list[Curve]] = {}
        self._subscriptions: dict[str, Subscription] = {}
        self._executor: BackgroundExecutor | None = None
        self._stop_noting: Callable[[], object] = nothing
        self._stop_following: Callable[[], object] = nothing
        self._asked: dict[tuple[str, str], float] = {}
        self._marks: deque[list[Any]] = deque(maxlen=_MARKS)
        self._fresh_marks: deque[list[Any]] = deque(maxlen=_MARKS)
        self._look_at = 0.0
        self._job = Job(self._step, _SEND_PERIOD_SEC)

    @property
    def numbers(self) -> list[str]:
        """The numeric parameters that the panel's node has now."""
        with self._front.drawing:
            return [name for name, value in self._present()[0].items() if is_number(value)]

    # -- what a person, or code, wants ------------------------------------------------------------------

    def open(self, row: str, *names: str) -> None:
        """Open a plot with curves, or add them to it.

        :raises ParameterToolError: there is no such number; nothing was opened.
        """
        names = tuple(self._require(name) for name in names)
        with self._front.drawing:
            curves = self._open.setdefault(row, [])
            curves += [name for name in dict.fromkeys(names) if name not in curves]
            self._change()

    def remove(self, row: str, name: str) -> None:
        """Remove a curve from a plot."""
        with self._front.drawing:
            if name in self._open.get(row, ()):
                self._open[row].remove(name)
                self._change()

    def close(self, row: str) -> None:
        """Close a plot, if it is open."""
        with self._front.drawing:
            if self._open.pop(row, None) is not None:
                self._change()

    def end(self) -> None:
        """Close all plots; the panel is about to go."""
        self._open.clear()
        self._curves, self._by_topic = {}, {}
        self._job.end()
        self._let_go()

    def follow(self) -> None:
        """Sample the parameters that are plotted, with the front's lock held."""
        curves = [each for each in self._curves.values() if not each.topic]
        present, status = self._present() if curves else ({}, '')
        for curve in curves:
            value = present.get(curve.name)
            if status:
                curve.end(status.partition('. ')[0])
            elif value is None or not is_number(value):
                curve.end('not a number now' if curve.name in present else 'there is no such parameter now')
            else:
                curve.word = ''
                if not curve.samples or curve.samples[-1][1] != _finite(value):
                    curve.add(time.time(), value)
            if curve.fresh:
                self._job.wake()

    def serve(self, content: Mapping[str, Any]) -> None:
        """Do what a person did in the browser, without waiting for fields to be found."""
        row, curve = content.get('row', ''), content.get('curve', '')
        if content['act'] == 'offer':
            host.host.run(lambda: self._send({'plot': 'offer', 'client': content['client'], **self._offer()}),
                          'fields to plot')
        elif content['act'] == 'add':
            host.host.run(functools.partial(self._add, content), 'a field to plot')
        elif content['act'] == 'all':
            with self._front.drawing:
                self._send({'client': content['client'], **self._data(
                    {each.name: each.samples for each in self._curves.values()}, self._marks)})
        elif content['act'] == 'open':
            self.open(row, *([row] if row in self.numbers else []))
        elif content['act'] == 'remove':
            self.remove(row, curve)
        else:
            self.close(row)

    def _add(self, content: Mapping[str, Any]) -> None:
        said = ''
        try:
            self.open(content['row'], content['curve'])
        except ParameterToolError as error:
            said = str(error)
        self._send({'plot': 'said', 'client': content['client'], 'row': content['row'], 'said': said})

    def _require(self, text: str) -> str:
        """Return the name of a curve.

        :raises ParameterToolError: nothing of this name can be drawn; the message says why.
        """
        name = text.strip().replace('[]', '[0]')
        if not name.startswith('/'):
            if name not in self.numbers:
                raise ParameterToolError(f'there is no numeric parameter {name!r} here; the field of a topic begins '
                                         f'with a slash, as in /odom.pose.pose.position.x')
            return name
        topic, _, field = name.partition('.')
        kinds = dict(stage.current().tool_node.get_topic_names_and_types()).get(topic)
        if not kinds and not field:
            raise ParameterToolError(f'nobody publishes {topic} now; to wait for it, name a field, as in {topic}.data')
        if not kinds:
            return name
        message = message_class(kinds[0])
        if message is None:
            raise ParameterToolError(_not_installed(topic, kinds[0]))
        fields = list(numeric_fields(message))
        if not fields:
            raise ParameterToolError(f'messages on {topic} are of type {kinds[0]}, which holds no number')
        if not field:
            raise ParameterToolError(f'choose one of the numbers in {topic}, such as {topic}.{fields[0]}')
        if (generic := re.sub(r'\[\d+\]', '[]', field)) not in fields:
            raise ParameterToolError(f'{topic} has no number {field!r}{nearest(generic, fields, "")}')
        return name

    def _offer(self) -> dict[str, Any]:
        """Return what can be plotted: parameters, topics with the names of their types, and fields of each type.

        A type that is not installed has None in the place of its fields.
        """
        try:
            listed = stage.current().tool_node.get_topic_names_and_types()
        except ExecutorError:
            listed = []
        topics = {name: kinds[0] for name, kinds in listed if kinds and not topic_or_service_is_hidden(name)}
        fields: dict[str, list[str] | None] = {}
        for kind in set(topics.values()):
            message = message_class(kind)
            # The time in a header is a number, too, and seldom what one looks for.
            fields[kind] = message and sorted(numeric_fields(message), key=lambda each: 'stamp.' in each)
        return {'parameters': self.numbers, 'topics': sorted(topics.items()), 'fields': fields}

    def _change(self) -> None:
        """Draw other curves from now on, with the lock held."""
        names = dict.fromkeys(name for curves in self._open.values() for name in curves)
        self._curves = {name: self._curves.get(name) or Curve(name) for name in names}
        by_topic: dict[str, list[Curve]] = {}
        for curve in self._curves.values():
            if curve.topic:
                by_topic.setdefault(curve.topic, []).append(curve)
        self._by_topic = by_topic
        self._look_at = 0.0
        self.follow()
        self._show()
        if self._open:
            self._job.wake()
        else:
            self._let_go()

    # -- the browser ------------------------------------------------------------------------------------

    def _step(self) -> float | None:
        """Send what is new; called by the schedule."""
        with self._front.drawing:
            if not self._open:
                return None
            self._follow_executor()
            if self._executor is not None and time.monotonic() >= self._look_at:
                self._look_at = time.monotonic() + _HEARTBEAT_SEC
                with contextlib.suppress(ExecutorError):  # it is being stopped
                    self._executor.create_task(functools.partial(self._look, self._executor))
            self._show()
            self._send(self._data({name: _taken(curve.fresh) for name, curve in self._curves.items() if curve.fresh},
                                  _taken(self._fresh_marks)))
        return _SEND_PERIOD_SEC if self._by_topic else _HEARTBEAT_SEC

    def _show(self) -> None:
        shown = {'open': [{'row': row, 'curves': list(curves)} for row, curves in self._open.items()],
                 'words': {name: curve.word for name, curve in self._curves.items() if curve.word}}
        if shown != self._front.plots:
            self._front.plots = shown

    def _send(self, message: dict[str, Any]) -> None:
        with self._front.drawing:
            self._front.send(message)

    def _data(self, samples: Mapping[str, Any], marks: Any) -> dict[str, Any]:
        return {'plot': 'data', 'now': round(time.time(), 3), 'marks': list(marks), 'curves': {
            name: [[round(at, 3) for at, _ in each], [value for _, value in each]] for name, each in samples.items()}}

    # -- ROS --------------------------------------------------------------------------------------------

    def _follow_executor(self) -> None:
        """Listen to the executor that runs in the background now, with the lock held."""
        try:
            executor = stage.current()
        except ExecutorError:
            executor = None
            for curve in self._curves.values():
                curve.end('no executor is running')
        if executor is self._executor:
            return
        self._let_go()
        self._executor = executor
        if executor is not None:
            self._stop_noting = executor.services.on_set(self._note_set)
            self._stop_following = follow_soon(self._on_changes, executor)

    def _let_go(self) -> None:
        """Hear nothing more."""
        executor, self._executor = self._executor, None
        ended, self._subscriptions = self._subscriptions, {}
        self._stop_noting()
        self._stop_following()
        self._stop_noting = self._stop_following = nothing
        if executor is not None and executor.is_running:  # else they have gone with its node
            # In its thread, where a look that is under way may have added one by then.
            executor.create_task(lambda: [executor.tool_node.destroy_subscription(each) for each in ended.values()])

    def _note_set(self, node: str, names: list[str]) -> None:
        self._asked |= dict.fromkeys(((node, name) for name in names), time.time())

    def _on_changes(self, changes: list[LoggedChange]) -> None:
        """Mark what has changed; called in the follower's loop, never in the executor's thread."""
        for each in changes:
            if each.kind not in ('changed', 'deleted', 'gone'):
                continue
            at = each.time.timestamp()
            is_own = 0.0 <= at - self._asked.get((each.node, each.name), 0.0) <= _OWN_SEC
            old, new = values.format_change(each.old, each.new, _LETTERS)
            mark = [round(at, 3), each.node, each.name, old, 'deleted' if each.kind == 'deleted' else new, is_own]
            self._marks.append(mark)
            self._fresh_marks.append(mark)
        if self._fresh_marks:
            self._job.wake()

    def _look(self, executor: BackgroundExecutor) -> None:
        """Hear the topics that are plotted, and say of which nobody publishes anything; in the executor's thread."""
        if executor is not self._executor:
            return
        node, heard = executor.tool_node, self._subscriptions
        for topic in [each for each in heard if each not in self._by_topic or not node.count_publishers(each)]:
            node.destroy_subscription(heard.pop(topic))
        kinds = dict(node.get_topic_names_and_types())
        for topic, curves in self._by_topic.items():
            if topic in heard:
                continue
            word = 'no message yet'
            message = message_class(kinds[topic][0]) if topic in kinds else None
            if not node.count_publishers(topic):
                word = 'nobody publishes it now'
            elif message is None:
                word = _not_installed(topic, kinds[topic][0])
            else:
                try:
                    heard[topic] = node.create_subscription(
                        message, topic, functools.partial(self._hear, topic), matching_qos(node, topic))
                except Exception as error:  # whatever it is: a person should see it, and this is asked again
                    word = f'cannot be heard: {describe_error(error)}'
            for curve in curves:
                curve.end(word)

    def _hear(self, topic: str, message: Any) -> None:
        for curve in self._by_topic.get(topic, ()):
            curve.hear(message)


def _finite(value: Any) -> float | None:
    return float(value) if value is not None and math.isfinite(value) else None


def _not_installed(topic: str, kind: str) -> str:
    return (f'messages on {topic} are of type {kind}, and {kind.partition("/")[0]} is not installed here: install it, '
            f'or source its workspace, and start again')


def _taken(fresh: deque[Any]) -> list[Any]:
    """Take out all that there is now; another thread may add to it meanwhile."""
    return [fresh.popleft() for _ in range(len(fresh))]
