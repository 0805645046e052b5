"""The one lock of the layer, and how a wait set waits for what changes under it.

Whatever makes something ready (a message, a request, a guard condition, a clock that jumps) does so while it holds
``changed``, and notifies. A host without threads changes how every condition waits (``ros/turns.py``), this one too.
"""

import itertools
import threading
import time
import weakref
from collections.abc import Callable, Sequence
from typing import Any, Protocol

from param_tools.rcl_in_python.exceptions import InvalidHandle, RCLError

_lock = threading.RLock()
changed = threading.Condition(_lock)


def wait_until(condition: Callable[[], bool], deadline_ns: Callable[[], int | None]) -> None:
    """Wait until a condition is true, or a point of time is reached.

    :param deadline_ns: Returns it, in ns of the steady clock, as things are now; None if there is none.
    """
    with changed:
        while not condition():
            deadline = deadline_ns()
            remaining = None if deadline is None else (deadline - time.monotonic_ns()) / 1e9
            if remaining is not None and remaining <= 0:
                return
            changed.wait(remaining)


# All handles that there are in this process.
handles: 'weakref.WeakSet[Destroyable]' = weakref.WeakSet()


class Destroyable:
    """A handle, which ``with`` keeps alive while it is in use.

    It counts as there from its ``__init__`` on: a constructor that may fail calls that when nothing can fail any more.
    """

    _pointers = itertools.count(0x1000, 0x10)

    def __init__(self) -> None:
        self.pointer = next(self._pointers)
        self._users = 0
        self._is_to_go = False
        self.is_gone = False
        handles.add(self)

    def __enter__(self) -> None:
        with _lock:
            if self._is_to_go:
                raise InvalidHandle('cannot use Destroyable because destruction was requested')
            self._users += 1

    def __exit__(self, *_: object) -> None:
        with _lock:
            if not self._users:
                raise RuntimeError('Internal error: Destroyable use_count would be negative')
            self._users -= 1
            if self._is_to_go and not self._users:
                self.end()

    def destroy_when_not_in_use(self) -> None:
        """Destroy what this stands for now, or at the end of the last ``with``."""
        with changed:
            self._is_to_go = True
            if not self._users:
                self.end()

    def end(self) -> None:
        """Destroy what this stands for now, even if it is in use."""
        if not self.is_gone:
            self.is_gone = True
            self._destroy()

    def _destroy(self) -> None:
        """Take what this stands for out of the graph; called once, with ``changed`` held."""

    def __del__(self) -> None:
        # Nobody has destroyed it, and nobody can use it any more.
        if not self.__dict__.get('is_gone', True):
            with changed:
                self.end()


class _Context(Protocol):
    def ok(self) -> bool:
        """True between init and shutdown."""


_NOT_VALID = 'the given context is not valid, either rcl_init() was not called or rcl_shutdown() was called.'


def check_context(context: _Context, what: str) -> None:
    """:raises RCLError: the context has been shut down."""
    if not context.ok():
        raise RCLError(f'{what}: {_NOT_VALID}')


class GuardCondition(Destroyable):
    """Something that a wait set wakes for when anybody triggers it."""

    def __init__(self, context: _Context):
        super().__init__()
        check_context(context, 'failed to create guard_condition')
        self._is_triggered = False

    def trigger_guard_condition(self) -> None:
        with changed:
            self._is_triggered = True
            changed.notify_all()

    def is_ready(self) -> bool:
        return self._is_triggered

    def take(self) -> None:
        """Make it ready no longer."""
        self._is_triggered = False


class Waitable(Protocol):
    """What a wait set waits for."""

    pointer: int

    def is_ready(self) -> bool:
        """True if there is something to take or to call."""


class WaitSet(Destroyable):
    """What an executor waits for, once."""

    def __init__(self, subscriptions: int, guard_conditions: int, timers: int, clients: int, services: int,
                 events: int, context: _Context):
        super().__init__()
        check_context(context, 'failed to initialize wait set')
        self._sizes = {'subscription': subscriptions, 'guard_condition': guard_conditions, 'timer': timers,
                       'client': clients, 'service': services, 'event': events}
        self.clear_entities()

    def clear_entities(self) -> None:
        self._entities: dict[str, list[Any]] = {kind: [] for kind in self._sizes}
        # None until it has waited: then all that was added counts as ready, as in C.
        self._ready: dict[str, list[bool]] | None = None

    def _add(self, kind: str, entity: Waitable, what: str = '') -> int:
        entities = self._entities[kind]
        if len(entities) >= self._sizes[kind]:
            raise RCLError(f'failed to add {what or kind.replace("_", " ")} to wait set: {kind}s set is full')
        entities.append(entity)
        return len(entities) - 1

    def add_service(self, service: Waitable) -> int:
        return self._add('service', service)

    def add_subscription(self, subscription: Waitable) -> int:
        return self._add('subscription', subscription)

    def add_client(self, client: Waitable) -> int:
        return self._add('client', client)

    def add_guard_condition(self, guard: Waitable) -> int:
        return self._add('guard_condition', guard)

    def add_timer(self, timer: Waitable) -> int:
        return self._add('timer', timer, 'client')

    def add_event(self, event: Waitable) -> int:
        return self._add('event', event)

    def is_ready(self, kind: str, index: int) -> bool:
        if kind not in self._sizes:
            raise RuntimeError(f"'{kind}' is not a known entity")
        if not self._sizes[kind]:
            raise RuntimeError(f"wait set '{kind}' isn't allocated")
        if index >= self._sizes[kind]:
            raise IndexError('wait set index too big')
        if index >= len(self._entities[kind]):
            return False
        return self._ready is None or self._ready[kind][index]

    def get_ready_entities(self, kind: str) -> list[int]:
        """Return the pointers of those that are ready."""
        if kind not in self._sizes or kind == 'event':
            raise RuntimeError(f"'{kind}' is not a known entity")
        entities = self._entities[kind]
        ready = [True] * len(entities) if self._ready is None else self._ready[kind]
        return [entity.pointer for entity, is_ready in zip(entities, ready) if is_ready]

    def wait(self, timeout_ns: int) -> None:
        """Wait until something is ready; for ever if the timeout is negative, and not at all if it is 0."""
        if not any(self._sizes.values()):
            raise RCLError('failed to wait on wait set: wait set is empty')
        end = None if timeout_ns < 0 else time.monotonic_ns() + timeout_ns
        with changed:
            wait_until(self._update_ready, lambda: _earliest([end, *(each.due_ns() for kind in ('timer', 'event')
                                                             for each in self._entities[kind])]))
            # What came last may be a timer's time.
            self._update_ready()
            for guard, is_ready in zip(self._entities['guard_condition'], (self._ready or {})['guard_condition']):
                if is_ready:
                    guard.take()

    def _update_ready(self) -> bool:
        """Note what is ready, and return whether anything is."""
        self._ready = {kind: [entity.is_ready() for entity in entities] for kind, entities in self._entities.items()}
        return any(map(any, self._ready.values()))


def _earliest(times: Sequence[int | None]) -> int | None:
    known = [each for each in times if each is not None]
    return min(known) if known else None
