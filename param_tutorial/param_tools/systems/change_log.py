"""A log of all changes of parameters: a ChangeFollower notices them, a ChangeLogWriter keeps them in a file, and a
ChangeLog reads the file back.

A log is a text file with one JSON object in each line: time, node, parameter, kind, old and new value. Each line is on
the disk before the next is written. The reader passes over lines that it can't read, such as one torn by a crash.

The kinds of lines are ``begin`` when somebody begins to watch, ``seen`` for each value that a node has at that moment
or when it appears later, ``declared``, ``changed``, ``deleted``, and ``gone`` for a node that has left. So the values
at any time follow from the lines before it.
"""

import contextlib
import datetime
import json
import math
import os
import queue
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rcl_interfaces.msg import ParameterEvent
from rclpy.exceptions import InvalidHandle

from param_tools import values
from param_tools.errors import (
    ExecutorError,
    InvalidValueError,
    NodeGoneError,
    NodeNotFoundError,
    ParameterFileError,
    ParameterToolError,
)
from param_tools.files.parameter_files import as_path, read_bytes
from param_tools.files.parsing import matches
from param_tools.markup.wording import format_count
from param_tools.node.client import ParameterValues, Questions
from param_tools.ros import host, stage, waiting
from param_tools.ros.executor import TOOL_NODE_NAME, BackgroundExecutor
from param_tools.ros.graph import DISCOVERY_SEC
from param_tools.ros.services import TIMEOUT_SEC
from param_tools.systems.snapshot import Snapshot
from param_tools.systems.word_table import WordTable

KINDS = ('begin', 'seen', 'declared', 'changed', 'deleted', 'gone')
# How many letters of a value stand in the text of a change.
_LETTERS = 60
_CLOSE_TIMEOUT_SEC = 10.0
_LONGEST_WAIT_SEC = 3600.0
# A node is asked for its names and then for its values.
_QUESTIONS = 2


@dataclass(frozen=True)
class LoggedChange:
    """One line of a log."""

    time: datetime.datetime
    """When the follower noticed the change, with a time zone."""
    kind: str
    """One of KINDS."""
    node: str = ''
    """Fully qualified name; empty for ``begin``."""
    name: str = ''
    """The parameter; empty for ``begin`` and ``gone``."""
    old: Any = None
    """None if there was no value, or it is not known."""
    new: Any = None

    def as_line(self) -> str:
        """Return the change as a line of a log, without the line's end."""
        return json.dumps({'time': self.time.isoformat(), 'kind': self.kind, 'node': self.node, 'parameter': self.name,
                           'old': _encode(self.old), 'new': _encode(self.new)})

    @classmethod
    def from_line(cls, line: str) -> 'LoggedChange':
        """Read a line of a log.

        :raises ValueError: the text is not such a line.
        """
        try:
            found = json.loads(line)
            time = datetime.datetime.fromisoformat(found['time'])
            kind, node, name = found['kind'], found['node'], found['parameter']
            if time.tzinfo is None or kind not in KINDS or not (isinstance(node, str) and isinstance(name, str)):
                raise ValueError('it lacks a time zone, a kind or a name')
            return cls(time, kind, node, name, _decode(found['old']), _decode(found['new']))
        except (KeyError, TypeError, AttributeError, RecursionError) as error:
            raise ValueError(f'it is not a line of a log: {error}') from None

    def __str__(self) -> str:
        time = f'{self.time.astimezone():%H:%M:%S.%f}'[:-3]
        if self.kind == 'begin':
            return f'{time} began to watch'
        if self.kind == 'gone':
            return f'{time} {self.node} is gone'
        old, new = values.format_change(self.old, self.new, _LETTERS)
        what = {'changed': f'{old} → {new}', 'deleted': f'{old} → deleted'}.get(self.kind, f'{new} ({self.kind})')
        return f'{time} {self.node} {self.name}: {what}'


def _encode(value: Any) -> Any:
    """Return a value as JSON has it; a value that JSON has not, as a map from its type to a text or numbers."""
    if isinstance(value, float) and not math.isfinite(value):
        return {'double': repr(value)}
    if isinstance(value, list) and value and isinstance(value[0], bytes):
        return {'byte array': [byte[0] for byte in value]}
    if isinstance(value, list) and any(isinstance(item, float) and not math.isfinite(item) for item in value):
        return {'double array': [repr(item) for item in value]}
    return value


def _decode(found: Any) -> Any:
    if isinstance(found, dict):
        (label, content), = found.items()
        found = {'double': lambda: float(content), 'double array': lambda: [float(item) for item in content],
                 'byte array': lambda: [bytes([item]) for item in content]}[label]()
    values.type_of(found)
    return found


# -- writing --------------------------------------------------------------------------------------------------


class ChangeLogWriter:
    """Appends to a log. A context manager."""

    def __init__(self, path: str | Path):
        """
        :param path: The file; what is in it stays.
        :raises OSError: it cannot be written.
        """
        # Without a buffer: what found no room on a full disk would be written, and fail, once more in the end.
        self._file = as_path(path).open('ab', buffering=0)

    def __enter__(self) -> 'ChangeLogWriter':
        return self

    def __exit__(self, *_: object) -> None:
        self._file.close()

    def write(self, changes: Iterable[LoggedChange]) -> None:
        """Append lines, and return when they are on the disk.

        :raises OSError: they could not be written.
        """
        left = ''.join(f'{change.as_line()}\n' for change in changes).encode()
        while left:
            left = left[self._file.write(left):]
        # A pipe or a terminal has no disk.
        with contextlib.suppress(OSError):
            os.fsync(self._file.fileno())


# -- reading --------------------------------------------------------------------------------------------------


class ChangeLog(WordTable[LoggedChange]):
    """The changes that a log holds, in their order. Shown as a table."""

    columns = ('time', 'node', 'parameter', 'kind', 'old', 'new')

    def __init__(self, changes: Iterable[LoggedChange]):
        super().__init__(changes)
        self.heading = format_count(len(self), 'change')

    @classmethod
    def read(cls, path: str | Path) -> 'ChangeLog':
        """Read a log, as far as it can be read.

        :raises ParameterFileError: the file cannot be opened, or it is another kind of file.
        """
        lines = list(filter(None, map(bytes.strip, read_bytes(path).split(b'\n'))))
        changes = []
        for line in lines:
            with contextlib.suppress(ValueError):  # a UnicodeDecodeError and an InvalidValueError are ones, too
                changes.append(LoggedChange.from_line(line.decode()))
        if lines and not changes:
            raise ParameterFileError(f'{path}: this is no log of parameter changes')
        return cls(changes)

    def without(self, *kinds: str) -> 'ChangeLog':
        """Return only the changes that are of other kinds."""
        return ChangeLog(each for each in self if each.kind not in kinds)

    def at(self, time: datetime.datetime) -> Snapshot:
        """Return the parameters that the nodes had at a time.

        :param time: Without a time zone, a local time.
        """
        time = time.astimezone()
        state: dict[str, dict[str, Any]] = {}
        for each in self:
            if each.time > time:
                break
            if each.kind == 'begin':
                state.clear()
            elif each.kind == 'gone':
                state.pop(each.node, None)
            elif each.kind == 'deleted':
                state.setdefault(each.node, {}).pop(each.name, None)
            else:
                state.setdefault(each.node, {})[each.name] = each.new
        return Snapshot({node: ParameterValues(parameters) for node, parameters in sorted(state.items())}, {}, time)

    def parse_time(self, text: str) -> datetime.datetime:
        """Return the time that a person names: ``14:05``, ``14:05:30``, or a date and a time as in ISO 8601.

        A time of day is the last one that the log has reached; without a time zone, it is a local one.

        :raises InvalidValueError: it is not a time.
        """
        with contextlib.suppress(ValueError, OverflowError):
            day = datetime.time.fromisoformat(text)
            last = self.records[-1].time if self.records else datetime.datetime.now().astimezone()
            found = datetime.datetime.combine(last.astimezone(day.tzinfo), day).astimezone()
            first = self.records[0].time if self.records else last
            day_before = found - datetime.timedelta(days=1)
            return day_before if found > last and day_before >= first else found
        try:
            return datetime.datetime.fromisoformat(text).astimezone()
        except (ValueError, OverflowError):
            raise InvalidValueError(f'{text!r} is not a time: write 14:05, 14:05:30 or 2026-11-22T14:05') from None

    def words(self, record: LoggedChange) -> tuple[str, ...]:
        return (f'{record.time.astimezone():%Y-%m-%d %H:%M:%S.%f}'[:-3], record.node, record.name, record.kind,
                *values.format_change(record.old, record.new, _LETTERS, nothing=''))


# -- following ------------------------------------------------------------------------------------------------


class ChangeFollower:
    """Reports every change of every parameter, with the value before it. A context manager.

    Each node is read once, when it appears, and again after it has been restarted; from then on its events are enough.
    Events and answers are handled in the order in which they arrive. Of an answer, only those parameters are noted
    that no event has named yet, so that an answer that comes late puts no old value after a newer one.
    """

    def __init__(self, listener: Callable[[list[LoggedChange]], None], *, nodes: Iterable[str] = (),
                 trouble: Callable[[ParameterToolError], None] | None = None, timeout_sec: float = TIMEOUT_SEC,
                 executor: BackgroundExecutor | None = None):
        """Begin to follow. Before this returns, the listener is called with all values that the nodes have now.

        :param listener: Called with changes that have happened together, in their order; in a thread of its own, and
            never twice at once.
        :param nodes: Names of nodes, or patterns such as ``/robot1/**``; by default all but hidden ones.
        :param trouble: Called in the same way when a node has not answered, so that its values are not known.
        :param timeout_sec: How long a node may take for each answer.
        """
        self._listener = listener
        self._trouble = trouble
        self._patterns = list(nodes)
        self._timeout_sec = timeout_sec
        self._executor = executor or stage.current()
        self._known: dict[str, dict[str, Any]] = {}
        self._by_events: dict[str, set[str]] = {}
        """The parameters of each node that an event has named."""
        self._incarnations: dict[str, frozenset[bytes]] = {}
        self._unread: dict[str, object] = {}
        """The nodes that have been asked and whose answer has not arrived, each with a mark of its reading."""
        self._is_over = False
        self._arrived: queue.SimpleQueue[Callable[[], list[LoggedChange]] | None] = queue.SimpleQueue()
        self._stop_listening = [
            self._executor.on_parameter_event(self._on_event),
            self._executor.on_graph_change(lambda: self._arrived.put(self._update_nodes))]
        changes = [LoggedChange(_now(), 'begin'), *self._update_nodes()]
        end = waiting.deadline(DISCOVERY_SEC + _QUESTIONS * timeout_sec)
        while self._unread and waiting.wait_before(end, lambda: not self._arrived.empty()):
            changes += self._take(self._arrived.get())
        self._listener(changes)
        self._loop = host.host.loop(self._run_next, lambda: self._is_over, 'parameter changes', _LONGEST_WAIT_SEC)
        self._loop.start()

    def __enter__(self) -> 'ChangeFollower':
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Stop following, once the listener has all that has happened so far. Safe to call more than once."""
        for stop in self._stop_listening:
            with contextlib.suppress(ExecutorError):
                stop()
        self._arrived.put(None)
        if not self._loop.is_current():
            self._loop.join(_CLOSE_TIMEOUT_SEC)

    def _is_wanted(self, node: str) -> bool:
        if self._patterns:
            return any(matches(pattern, node) for pattern in self._patterns)
        return '/_' not in node

    # In the executor's thread: note, and return at once.

    def _on_event(self, event: ParameterEvent) -> None:
        if self._is_wanted(event.node):
            time = _now()
            self._arrived.put(lambda: self._changes_of(event, time))

    async def _read(self, node: str, reading: object) -> None:
        async def ask(service: str, request: Any) -> Any:
            return await self._executor.services.call_async(node, service, request, timeout_sec=self._timeout_sec)

        try:
            parameters = await Questions(node, ask).get_parameters()
        except ParameterToolError as failure:
            error = failure
            self._arrived.put(lambda: self._miss(node, reading, error))
        else:
            self._arrived.put(lambda: self._add_read(node, reading, parameters))

    # In the follower's own loop.

    def _run_next(self, wait_sec: float) -> bool:
        """Handle what has arrived next, within a time, and return whether there was anything."""
        try:
            arrived = self._arrived.get(timeout=wait_sec)
        except queue.Empty:
            return False
        self._is_over = arrived is None
        if changes := self._take(arrived):
            self._listener(changes)
        return True

    @staticmethod
    def _take(arrived: Callable[[], list[LoggedChange]] | None) -> list[LoggedChange]:
        # The executor has been stopped, maybe just now, and with it its node: nothing more will happen.
        with contextlib.suppress(ExecutorError, InvalidHandle):
            return arrived() if arrived is not None else []
        return []

    def _update_nodes(self) -> list[LoggedChange]:
        """Note the nodes that have left, and begin to read those that have appeared."""
        names = set(filter(self._is_wanted, self._executor.services.node_names(hidden=True))) - {f'/{TOOL_NODE_NAME}'}
        now = {node: self._executor.node_incarnations(node) for node in names}
        # News of what a node has may come later than its first answers; that is not a restart.
        came = [node for node, each in now.items()
                if node not in self._incarnations or self._incarnations[node] not in (each, frozenset())]
        at = _now()
        changes = [LoggedChange(at, 'gone', node) for node in self._incarnations if node not in now or node in came]
        for change in changes:
            self._known.pop(change.node, None)
            self._by_events.pop(change.node, None)
        self._incarnations = now
        self._unread = {node: reading for node, reading in self._unread.items() if node in now}
        for node in sorted(came):
            self._unread[node] = object()
            self._executor.create_task(self._read(node, self._unread[node]))
        return changes

    def _changes_of(self, event: ParameterEvent, time: datetime.datetime) -> list[LoggedChange]:
        known = self._known.setdefault(event.node, {})
        changes = []
        for kind, parameters in (('declared', event.new_parameters), ('changed', event.changed_parameters)):
            for each in parameters:
                new = values.to_python_or_none(each.value)
                if values.holds(known, each.name, new):
                    continue  # it was read after the event, or set to the value that it had
                old = known.get(each.name)
                if each.name in known:
                    kind_now = 'changed'
                else:  # what it was before will not be known
                    kind_now = 'seen' if kind == 'changed' and event.node in self._unread else kind
                changes.append(LoggedChange(time, kind_now, event.node, each.name, old, new))
                known[each.name] = new
        changes += [LoggedChange(time, 'deleted', event.node, each.name, known.pop(each.name, None))
                    for each in event.deleted_parameters]
        self._by_events.setdefault(event.node, set()).update(change.name for change in changes)
        return changes

    def _add_read(self, node: str, reading: object, parameters: Mapping[str, Any]) -> list[LoggedChange]:
        """Note what a node said that it has."""
        if self._unread.get(node) is not reading:
            return []  # it has left or was restarted meanwhile
        del self._unread[node]
        known, time = self._known.setdefault(node, {}), _now()
        new = {name: value for name, value in parameters.items() if name not in self._by_events.get(node, ())}
        known |= new
        return [LoggedChange(time, 'seen', node, name, None, value) for name, value in new.items()]

    def _miss(self, node: str, reading: object, error: ParameterToolError) -> list[LoggedChange]:
        if self._unread.get(node) is reading:
            del self._unread[node]
            # A node that has left meanwhile is reported as gone.
            if self._trouble is not None and not isinstance(error, (NodeGoneError, NodeNotFoundError)):
                self._trouble(error)
        return []


def _now() -> datetime.datetime:
    return datetime.datetime.now().astimezone()
