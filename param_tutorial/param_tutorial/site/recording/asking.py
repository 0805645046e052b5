"""One question to a node: set a parameter to what a hand typed, write down what happens, and take it back."""

from collections.abc import Mapping
from typing import Any

from param_tools import values
from param_tools.descriptor import Descriptor
from param_tools.errors import ParameterToolError, describe_error
from param_tools.node.client import ParameterClient
from param_tools.node.text import format_value, parse_value
from param_tutorial.site.recording.recorded import RecordedAnswer
from param_tutorial.site.recording.taps import EventTap, NodeLogTap, node_here

# The values that a node has, by the parameters' names.
State = dict[str, Any]


class CannotRestoreError(Exception):
    """A node does not take back a value that it had."""


class Asker:
    """Asks one node, always from the state in which it was first found, unless told otherwise."""

    def __init__(self, node: str, descriptors: Mapping[str, Descriptor], *, events: bool):
        """
        :param descriptors: Of the parameters that are asked for.
        :param events: Write down also what the node publishes on /parameter_events.
        """
        self.descriptors = descriptors
        self.node = node
        self.count = 0
        self._client = ParameterClient(node)
        node_in_process = node_here(node)
        self._log = NodeLogTap(node_in_process) if node_in_process else None
        self._events = EventTap(node) if events else None
        self._all_names = self._client.list_parameters()
        self.shown = self.read()
        self._unlogged: list[tuple[RecordedAnswer, int]] = []
        # What ``show`` has changed.
        self._moved: set[str] = set()
        self._discard(0)

    def close(self) -> None:
        """Stop listening to the node."""
        for tap in (self._log, self._events):
            if tap:
                tap.stop()

    def ask(self, name: str, text: str, state: State) -> RecordedAnswer:
        """Ask for what a hand would have typed, and give the node back what it had.

        What the node logged is in the answer after ``flush``.

        :param state: The values that the node has.
        :raises CannotRestoreError: the node does not take back what it had.
        """
        self.count += 1
        try:
            value = parse_value(self.descriptors[name], text)
        except ValueError as error:
            return {'reason': str(error), 'log': []}
        reason = self._set(name, value)
        after = self.read()
        answer: RecordedAnswer = (
            {'reason': reason} if reason else {'value': format_value(self.descriptors[name], after[name])})
        also = {other: format_value(descriptor, after[other]) for other, descriptor in self.descriptors.items()
                if (other != name or reason) and not values.same(state[other], after[other])}
        if also:
            answer['also'] = also
        answer['log'] = None
        if self._log:
            self._unlogged.append((answer, self._log.cut()))
        if self._events:
            answer['events'] = self._events.rows(0 if reason else 1)
        self._restore(state, after)
        return answer

    def flush(self) -> None:
        """Wait for what the node has logged, and put it into the answers.

        :raises RuntimeError: it does not arrive.
        """
        for answer, number in self._unlogged:
            assert self._log is not None
            answer['log'] = self._log.batch(number)
        self._unlogged.clear()

    def show(self, changed: Mapping[str, str]) -> bool:
        """Bring the node, in one request, from wherever it is to its first state with some changes.

        Much faster than ``enter`` and ``leave``; ``end_show`` brings it back for good.

        :return: False if the node rejects it; it stays as it was then.
        """
        wanted = {name: parse_value(self.descriptors[name], text) for name, text in changed.items()}
        wanted |= {name: self.shown[name] for name in self._moved - wanted.keys()}
        if not wanted:
            return True
        try:
            accepted = all(each.successful for each in self._client.set_parameters_atomically(wanted))
        except ParameterToolError:
            return False
        if accepted:
            self._moved |= changed.keys()
        return accepted

    def end_show(self) -> None:
        """Bring the node back from ``show``.

        :raises CannotRestoreError: the node does not take back what it had.
        """
        self._moved.clear()
        self._restore(self.shown, self.read())

    def enter(self, changed: Mapping[str, str]) -> State:
        """Bring the node into another state, and return it; ``leave`` goes back."""
        for name, text in changed.items():
            self._client.set_parameter(name, parse_value(self.descriptors[name], text))
        self._discard(len(changed))
        return self.read()

    def leave(self, state: State) -> None:
        """Bring the node back into the state in which it was first found.

        :raises CannotRestoreError: the node does not take back what it had.
        """
        self._restore(self.shown, state)

    def _set(self, name: str, value: Any) -> str:
        """Set a parameter, and return why the node rejected that; an empty text if it did not."""
        try:
            result = self._client.set_parameter(name, value)
        except ParameterToolError as error:
            return describe_error(error)
        return '' if result.successful else result.reason or 'The node gave no reason.'

    def read(self) -> State:
        """Return the values that the node has."""
        return dict(self._client.get_parameters(self._all_names))

    def _restore(self, wanted: State, now: State) -> None:
        for together in (False, True):
            different = {name: value for name, value in wanted.items() if not values.same(now[name], value)}
            if not different:
                return
            (self._client.set_parameters_atomically if together else self._client.set_parameters)(different)
            now = self.read()
            self._discard(1 if together else len(different))
        if any(not values.same(now[name], value) for name, value in wanted.items()):
            raise CannotRestoreError

    def _discard(self, messages: int) -> None:
        """Forget what the node says of changes that nobody typed."""
        if self._events:
            self._events.rows(messages)
        if self._log:
            self._log.cut()
