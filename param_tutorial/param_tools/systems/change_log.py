"""A log of all changes of parameters: a ChangeFollower hears of them, a ChangeLogWriter keeps them in a file, and a
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
import re
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rcl_interfaces.msg import ParameterEvent
from rclpy.exceptions import InvalidHandle

from param_tools import values
from param_tools.errors import (
    ExecutorError,
    InvalidValueError,
    NodeError,
    NodeGoneError,
    NodeNotFoundError,
    ParameterFileError,
)
from param_tools.files.parameter_files import as_path, read_bytes
from param_tools.files.parsing import matches
from param_tools.markup.wording import format_count
from param_tools.node.client import ParameterClient, ParameterValues
from param_tools.ros import host, stage
from param_tools.ros.executor import TOOL_NODE_NAME, BackgroundExecutor
from param_tools.ros.services import TIMEOUT_SEC
from param_tools.systems.snapshot import Snapshot, ask_all
from param_tools.systems.word_table import WordTable

KINDS = ('begin', 'seen', 'declared', 'changed', 'deleted', 'gone')
# How many letters of a value stand in the text of a change.
_LETTERS = 60
_CLOSE_TIMEOUT_SEC = 10.0
_LONGEST_WAIT_SEC = 3600.0
# How long to wait before each of the readings that follow the first one of a new node. Events may be missed meanwhile:
# on a busy machine the node's publisher may discover this reader only at a heartbeat of Fast DDS, every three seconds.
_READ_AGAIN_SEC = (0.5, 1.0, 2.0, 4.0)
# How long to wait before each new question to a node that has not answered; the last wait is repeated. The waits grow
# because all changes of other nodes have to wait while one is asked.
_ASK_AGAIN_SEC = (1.0, 2.0, 5.0, 10.0, 30.0)


@dataclass(frozen=True)
class LoggedChange:
    """One line of a log."""

    time: datetime.datetime
    """When the follower heard of the change, with a time zone."""
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
        self._file = as_path(path).open('ab+', buffering=0)
        self._is_torn = False
        if self._file.seekable() and self._file.seek(0, os.SEEK_END):
            self._file.seek(-1, os.SEEK_END)
            self._is_torn = self._file.read(1) != b'\n'  # by a crash

    def __enter__(self) -> 'ChangeLogWriter':
        return self

    def __exit__(self, *_: object) -> None:
        self._file.close()

    def write(self, changes: Iterable[LoggedChange]) -> None:
        """Append lines, and return when they are on the disk.

        :raises OSError: they could not be written.
        """
        lines = ''.join(f'{change.as_line()}\n' for change in changes)
        left = (f'\n{lines}' if self._is_torn else lines).encode()
        self._is_torn = True
        while left:
            left = left[self._file.write(left):]
        self._is_torn = False
        # A pipe or a terminal has no disk.
        with contextlib.suppress(OSError):
            os.fsync(self._file.fileno())


# -- reading --------------------------------------------------------------------------------------------------


class ChangeLog(WordTable[LoggedChange]):
    """The changes that a log holds, in their order. Shown as a table."""

    columns = ('time', 'node', 'parameter', 'kind', 'old', 'new')

    def __init__(self, changes: Iterable[LoggedChange], damaged: Iterable[int] = ()):
        """:param damaged: The numbers of the lines that could not be read."""
        super().__init__(changes)
        self.damaged = tuple(damaged)
        self.heading = format_count(len(self), 'change')
        if self.damaged:
            self.heading += f'; unreadable: line {", ".join(map(str, self.damaged))}'

    @classmethod
    def read(cls, path: str | Path) -> 'ChangeLog':
        """Read a log, as far as it can be read.

        :raises ParameterFileError: the file cannot be opened, or it is another kind of file.
        """
        lines = read_bytes(path).split(b'\n')
        changes, damaged = [], []
        for number, line in enumerate(lines, 1):
            if not line.strip():
                continue
            try:
                changes.append(LoggedChange.from_line(line.decode()))
            except ValueError:  # a UnicodeDecodeError and an InvalidValueError are ones, too
                damaged.append(number)
        if damaged and not changes:
            raise ParameterFileError(f'{path}, line {damaged[0]}: this is no log of parameter changes')
        return cls(changes, damaged)

    def select(self, *, nodes: Iterable[str] = (), names: str = '', kinds: Iterable[str] = (),
               since: datetime.datetime | None = None, until: datetime.datetime | None = None) -> 'ChangeLog':
        """Return only some of the changes.

        :param nodes: Names of nodes, or patterns such as ``/robot1/**``; by default all.
        :param names: A regular expression that is searched in the parameter's name.
        :param kinds: Some of KINDS; by default all.
        :param since: Without a time zone, a local time, like ``until``.
        :raises re.error: names is no regular expression.
        """
        wanted, patterns, kinds = re.compile(names), list(nodes), set(kinds)
        since, until = since and since.astimezone(), until and until.astimezone()
        return ChangeLog((each for each in self
                          if (not patterns or any(matches(pattern, each.node) for pattern in patterns))
                          and (not names or (each.name and wanted.search(each.name)))
                          and (not kinds or each.kind in kinds)
                          and (since is None or each.time >= since) and (until is None or each.time <= until)),
                         self.damaged)

    def at(self, time: datetime.datetime | None = None) -> Snapshot:
        """Return the parameters that the nodes had at a time; by default at the end of the log.

        :param time: Without a time zone, a local time.
        """
        if time is not None:
            time = time.astimezone()
        elif self.records:
            time = self.records[-1].time
        state: dict[str, dict[str, Any]] = {}
        for each in self:
            if time is not None and each.time > time:
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
    """Hears of every change of every parameter, and knows the value before it. A context manager.

    An event holds only the new value, and a node may have sent events before it was discovered. So the follower reads
    each node when it first sees it, and again after it has been restarted.
    """

    def __init__(self, listener: Callable[[list[LoggedChange]], None], *, nodes: Iterable[str] = (),
                 trouble: Callable[[NodeError], None] | None = None, timeout_sec: float = TIMEOUT_SEC,
                 executor: BackgroundExecutor | None = None):
        """Begin to follow. Before this returns, the listener is called with all values that the nodes have now.

        :param listener: Called with changes that have happened together, in their order; in a thread of its own, and
            never twice at once.
        :param nodes: Names of nodes, or patterns such as ``/robot1/**``; by default all but hidden ones.
        :param trouble: Called in the same way when a node has not answered, so that its values are not known. The node
            is asked again from time to time.
        :param timeout_sec: How long a node may take for each answer.
        """
        self._listener = listener
        self._trouble = trouble
        self._patterns = list(nodes)
        self._timeout_sec = timeout_sec
        self._executor = executor or stage.current()
        self._known: dict[str, dict[str, Any]] = {}
        self._incarnations: dict[str, frozenset[bytes]] = {}
        self._new: dict[str, tuple[float, Sequence[float]]] = {}
        """When each new node is to be read again, and how long to wait before each reading after that."""
        self._read: dict[str, Mapping[str, Any]] = {}
        """What each node had when it was last read."""
        self._silent: dict[str, list[float]] = {}
        """How long to wait before each new question to a node that has not answered."""
        self._look_again_at: float | None = None
        self._is_over = False
        self._happened: queue.SimpleQueue[Callable[[], list[LoggedChange]] | None] = queue.SimpleQueue()
        self._stop_listening = [self._executor.on_parameter_event(self._on_event),
                                self._executor.on_graph_change(self._on_graph_change)]
        began = LoggedChange(_now(), 'begin')
        self._listener([began, *self._look()])
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
        self._happened.put(None)
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
            self._happened.put(lambda: self._changes_of(event, time))

    def _on_graph_change(self) -> None:
        self._happened.put(self._look)

    # In the follower's own loop.

    def _run_next(self, wait_sec: float) -> bool:
        """Do what is next, within a time, and return whether there was anything."""
        happened = self._next(wait_sec)
        if happened is None:
            return False
        # The executor has been stopped, maybe just now, and with it its node: nothing more will happen.
        with contextlib.suppress(ExecutorError, InvalidHandle):
            if changes := happened():
                self._listener(changes)
        return True

    def _next(self, wait_sec: float) -> Callable[[], list[LoggedChange]] | None:
        """Return what to do next. Wait for it at most until a node is to be read again, or asked again."""
        dues = [due for due, _ in self._new.values()]
        due = min(dues if self._look_again_at is None else [*dues, self._look_again_at], default=math.inf)
        if due <= time.monotonic():  # however much happens
            return self._read_again
        try:
            happened = self._happened.get(timeout=max(0.0, min(wait_sec, due - time.monotonic())))
        except queue.Empty:
            return None
        self._is_over = happened is None
        return happened

    def _read_again(self) -> list[LoggedChange]:
        """Read the new nodes again: a node's first events are lost if its publisher doesn't know this reader yet."""
        now = time.monotonic()
        if self._look_again_at is not None and self._look_again_at <= now:
            return self._look()
        waits = {node: later for node, (due, later) in self._new.items() if due <= now}
        self._new = {node: each for node, each in self._new.items() if node not in waits}
        answers, _ = ask_all(sorted(self._known.keys() & waits), ParameterClient.get_parameters,
                             timeout_sec=self._timeout_sec, executor=self._executor)
        # A node that did not answer isn't asked again, because all other changes would have to wait.
        self._read_later({node: each for node, each in waits.items() if each and node in answers})
        return [change for node, parameters in answers.items() for change in self._seen(node, parameters)]

    def _changes_of(self, event: ParameterEvent, time: datetime.datetime) -> list[LoggedChange]:
        known = self._known.setdefault(event.node, {})
        changes = []
        for kind, parameters in (('declared', event.new_parameters), ('changed', event.changed_parameters)):
            for each in parameters:
                new = values.to_python_or_none(each.value)
                if values.holds(known, each.name, new):
                    continue  # it was read after the event, or set to the value that it had
                old = known.get(each.name)
                kind_now = 'changed' if each.name in known else kind
                changes.append(LoggedChange(time, kind_now, event.node, each.name, old, new))
                known[each.name] = new
        changes += [LoggedChange(time, 'deleted', event.node, each.name, known.pop(each.name, None))
                    for each in event.deleted_parameters]
        return changes

    def _look(self) -> list[LoggedChange]:
        """Read the nodes that have appeared, and note those that have left."""
        names = set(filter(self._is_wanted, self._executor.services.node_names(hidden=True))) - {f'/{TOOL_NODE_NAME}'}
        now = {node: self._executor.node_incarnations(node) for node in names}
        came = [node for node in now if self._incarnations.get(node) != now[node]]
        at = _now()
        changes = [LoggedChange(at, 'gone', node) for node in self._known
                   if node not in now or (node in came and self._incarnations.get(node))]
        for change in changes:
            self._known.pop(change.node, None)
            self._read.pop(change.node, None)
        answers, unanswered = ask_all(came, ParameterClient.get_parameters, timeout_sec=self._timeout_sec,
                                      executor=self._executor) if came else ({}, {})
        for node, parameters in answers.items():
            changes += self._seen(node, parameters)
        self._read_later(dict.fromkeys(answers, _READ_AGAIN_SEC))
        self._incarnations = {node: each for node, each in now.items() if node not in unanswered}
        self._note_silence(unanswered)
        return changes

    def _read_later(self, waits: Mapping[str, Sequence[float]]) -> None:
        now = time.monotonic()
        self._new |= {node: (now + first, later) for node, (first, *later) in waits.items()}

    def _note_silence(self, unanswered: Mapping[str, NodeError]) -> None:
        """Report the nodes that have not answered, each once, and plan when to ask them again."""
        for node, error in unanswered.items():
            # A node that has left meanwhile is reported as gone.
            has_left = isinstance(error, (NodeGoneError, NodeNotFoundError))
            if self._trouble is not None and node not in self._silent and not has_left:
                self._trouble(error)
        waits = {node: self._silent.get(node, list(_ASK_AGAIN_SEC)) for node in unanswered}
        self._look_again_at = time.monotonic() + min(each[0] for each in waits.values()) if waits else None
        self._silent = {node: each[1:] or each for node, each in waits.items()}

    def _seen(self, node: str, parameters: Mapping[str, Any]) -> list[LoggedChange]:
        """Return what a reading of a node tells that is not known.

        A known value that differs has changed, and its event, with those before it, is usually still to come. So it is
        believed only if the reading before has found it, too.
        """
        known, time = self._known.setdefault(node, {}), _now()
        before, self._read[node] = self._read.get(node, {}), parameters
        changes = []
        for name, value in parameters.items():
            if name not in known or (not values.same(known[name], value) and values.holds(before, name, value)):
                kind = 'changed' if name in known else 'seen'
                changes.append(LoggedChange(time, kind, node, name, known.get(name), value))
                known[name] = value
        return changes


def _now() -> datetime.datetime:
    return datetime.datetime.now().astimezone()
