"""Pictures that play by themselves what happens to a node's parameters.

What they look like is in the room ``pictures``; here is what they follow. Something is sent to the page only when
something has happened: the browser moves the rest.
"""

import contextlib
import html
from collections.abc import Callable
from typing import Any, TypeGuard

from rcl_interfaces.msg import ParameterEvent
from rclpy.exceptions import InvalidHandle
from rclpy.node import Node

from param_tools import values
from param_tools.descriptor import Descriptor
from param_tools.errors import CallbackError, ExecutorError, NodeNotFoundError
from param_tools.node.client import ParameterClient, node_name
from param_tools.node.live import LiveParameters
from param_tools.panel.view import FollowingView, nothing
from param_tools.ros.executor import BackgroundExecutor
from param_tools.ros.services import TIMEOUT_SEC
from param_tools.ros.waiting import wait_until
from param_tutorial.pictures import motion
from param_tutorial.pictures.ladder import Climb
from param_tutorial.pictures.messages import MessageTraffic
from param_tutorial.pictures.number_line import NumberLine, Request, Scale
from param_tutorial.views.events import changes_in
from param_tutorial.views.recording import RecordedSet, follow_sets
from param_tutorial.views.reel import ReelView
from param_tutorial.views.ros_graph import ends_of_parameter_events


class MotionView(ReelView, FollowingView):
    """A picture that plays anew whenever something happens, until it is closed."""

    def __init__(self, subject: str, executor: BackgroundExecutor | None) -> None:
        """
        :param subject: The node, or what the view is of in the place of one.
        :param executor: None for whichever runs in the background, also after a stop and a new start.
        """
        self._subject = subject
        self._text = ''
        # What is shown, if it is to stay.
        self._held = ''
        super().__init__()
        self._begin(executor)

    def __repr__(self) -> str:
        return f'<{type(self).__name__}: {self._held or self._subject}{", closed" if self._closed else ""}>'

    @property
    def text(self) -> str:
        """What the picture shows, in words, as a screen reader tells it."""
        return self._text

    @property
    def node(self) -> str:
        """The fully qualified name of the node, or what it says in the place of one."""
        return self._subject

    def snapshot(self) -> dict[str, object]:
        """Return what a page without a kernel needs: the picture plays there once, and again when it is told to."""
        self._job.call_now(1.0)
        return super().snapshot()

    def _play(self, text: str, picture: Callable[[motion.Reel], str], *, is_still: bool = False) -> None:
        """Put a picture onto the page; it moves from now on."""
        self._text = text
        self._put(picture, is_still=is_still)

    def _say(self, words: str) -> None:
        """Put a sentence in the place of the picture."""
        self._text = words
        self._drawn.value = (f'<div class="motion"><div class="motion-head"><span class="motion-name">'
                             f'{html.escape(self._subject)}</span><span>{html.escape(words)}</span></div></div>')

    def _step(self) -> float | None:
        with self._drawing:
            return None if self._held else super()._step()

    def _hold(self, sentence: str) -> None:
        """Let the picture stay as it is from now on, whatever happens.

        :param sentence: What it shows.
        """
        self._job.call_now(1.0)
        with self._drawing:
            self._held = sentence
        self._stop()


class SetView(MotionView):
    """A picture that plays each set of one node's parameters, also one that the node rejects."""

    def __init__(self, node: str | Node | ParameterClient, executor: BackgroundExecutor | None) -> None:
        """
        :param node: The node, or its name; it has to be spun in this process, now or later.
        :param executor: As for MotionView.
        """
        self._followed: Node | None = None
        self._stop_sets: Callable[[], None] = nothing
        self._latest: RecordedSet | None = None
        super().__init__(node_name(node), executor)

    def _wants(self, record: RecordedSet) -> bool:
        """True if a set is to be shown."""
        raise NotImplementedError

    def _subscribe(self, executor: BackgroundExecutor) -> Callable[[], None]:
        stop_listening = executor.on_graph_change(self._on_graph_change)
        with contextlib.suppress(ExecutorError):
            executor.run(self._follow, f'follow {self._subject}')
        return stop_listening

    def _lose(self) -> None:
        self._followed, self._stop_sets = None, nothing

    def _on_graph_change(self) -> None:
        self._follow()
        self._job.wake()

    def _follow(self) -> None:
        """Follow the node that has the name now: in the executor's thread, so that no set of a new node is missed."""
        executor = self._executor
        if self._closed or executor is None:
            return
        node = next((each for each in executor.nodes if _name_of(each) == self._subject), None)
        if node is not self._followed:
            self._stop_sets()
            self._followed, self._stop_sets = node, nothing
            if node is not None:
                self._stop_sets = follow_sets(node, self._on_set, executor=executor)

    def _on_set(self, record: RecordedSet) -> None:
        if self._wants(record):
            self._latest = record
            self._job.wake()

    def _ask(self, name: str, value: Any) -> RecordedSet:
        """Ask the node for a value, and return what came of it.

        :raises NodeNotFoundError: it is not running in this process.
        :raises InvalidValueError: no parameter can hold this value.
        """
        if self._followed is None:
            raise NodeNotFoundError(self._subject, [_name_of(each) for each in self._executor.nodes]
                                    if self._executor is not None else [])
        self._latest = None
        with contextlib.suppress(CallbackError):
            ParameterClient(self._subject, executor=self._executor).set_parameter(name, value)
        record: RecordedSet | None = self._latest
        if record is None:
            raise ExecutorError(f'{self._subject} has answered, and nobody has asked it for {name}')
        return record

    def _stop(self) -> None:
        super()._stop()
        self._stop_sets()


class LadderView(SetView):
    """A value that climbs the ladder of callbacks, or falls from it, whenever somebody sets a parameter of a node.

    Show it as the last line of a cell.
    """

    def __init__(self, node: str | Node | ParameterClient, name: str | None = None, value: Any = ..., *,
                 executor: BackgroundExecutor | None = None) -> None:
        """
        :param node: The node, or its name; it has to be spun in this process, now or later.
        :param name: Only this parameter; by default whichever is set.
        :param value: Ask the node for this value, and show what comes of it and nothing after it; by default the view
            asks for nothing, and follows the node.
        :param executor: Spins it; by default the one that runs in the background, also after a stop and a new start.
        :raises NodeNotFoundError: a value is given, and the node is not running in this process.
        """
        self._name = name
        self._shown: object = self
        super().__init__(node, executor)
        if name is not None and value is not ...:
            self._hold(_climb(self._ask(name, value)).sentence)

    def _wants(self, record: RecordedSet) -> bool:
        return self._name in (None, record.timeline.name)

    def _show(self) -> None:
        is_there, record = self._followed is not None, self._latest
        shown = is_there if record is None else record
        if shown is self._shown:
            return
        self._shown = shown
        if record is not None:
            climb = _climb(record)
            self._play(climb.text, climb.html)
        elif is_there:
            self._say(f'Set {self._name or "a parameter"}, and see how far the value climbs.')
        else:
            self._say('This node is not running in this process. The picture follows it when it does.')


class NumberLineView(SetView):
    """A parameter that holds a number, on a line with its range and steps; a rejected value springs back.

    Show it as the last line of a cell.
    """

    def __init__(self, node: str | Node | ParameterClient, name: str, value: Any = ..., *,
                 executor: BackgroundExecutor | None = None, timeout_sec: float = TIMEOUT_SEC) -> None:
        """
        :param node: The node, or its name. What it rejects is seen only if it is spun in this process.
        :param name: The parameter.
        :param value: As for LadderView.
        :param executor: As for LadderView.
        :param timeout_sec: How long the node may take for each answer.
        :raises NodeNotFoundError: a value is given, and the node is not running in this process.
        """
        self._name = name
        self._sentence = ''
        self._live: LiveParameters | None = None
        self._shown: tuple[Descriptor, float, RecordedSet | None] | None = None
        super().__init__(node, executor)
        self._live = LiveParameters(self._subject, self._job.wake, names=[name], executor=executor,
                                    timeout_sec=timeout_sec)
        self._live.first_look()
        self._job.call_now(1.0)
        if value is not ...:
            self._ask(name, value)
            self._job.call_now(1.0)
            self._hold(self._sentence)

    def __repr__(self) -> str:
        shown = self._held or f'{self._name} of {self._subject}'
        return f'<NumberLineView: {shown}{", closed" if self._closed else ""}>'

    def settle(self, timeout_sec: float = 10.0) -> None:
        """Wait until the view shows what the node has now.

        :raises WaitTimeoutError: it took too long.
        """
        if self._live is not None:
            self._live.settle(timeout_sec)
        self._job.call_now(timeout_sec)

    def _wants(self, record: RecordedSet) -> bool:
        return record.timeline.name == self._name

    def _show(self) -> None:
        node, record = self._followed, self._latest
        if self._live is None:
            return
        parameter = self._live.parameters.get(self._name)
        if self._live.status or parameter is None:
            self._shown = None
            self._say(self._live.status or f'The node has no parameter {self._name} now.')
            return
        # What the node itself says is never older than the events.
        stored = parameter.value if node is None or not node.has_parameter(self._name) \
            else node.get_parameter_or(self._name).value
        descriptor = parameter.descriptor
        if not _is_number(stored):
            self._shown = None
            self._say(f'{self._name} is not a number.')
            return
        shown = descriptor, stored, record
        if shown == self._shown:
            return
        before = None if self._shown is None else self._shown[1]
        is_new = record is not None and (self._shown is None or record is not self._shown[2])
        self._shown = shown
        request = None
        if record is not None and is_new:
            request = Request(record.value if _is_number(record.value) else None, values.format_value(record.value),
                              record.objection)
        elif before is not None and before != stored:
            request = Request(stored, values.format_value(stored))
        asked = None if request is None else request.value
        scale = Scale.around(*(each for each in (stored, before, asked) if each is not None))
        if descriptor.range:
            scale = Scale(descriptor.range.from_value, descriptor.range.to_value, descriptor.range.step)
        line = NumberLine(self._subject, self._name, scale, stored, before=before, request=request,
                          is_locked=descriptor.read_only)
        self._sentence = line.sentence
        self._play(line.text, line.html)

    def _stop(self) -> None:
        super()._stop()
        if self._live is not None:
            self._live.close()


class MessageView(MotionView):
    """Messages on /parameter_events that travel from the node that has changed to each that listens.

    Show it as the last line of a cell.
    """

    def __init__(self, node: str | Node | ParameterClient | None = None, name: str = '', value: Any = ..., *,
                 executor: BackgroundExecutor | None = None) -> None:
        """
        :param node: Only its messages; by default those of all nodes.
        :param name: With a value, the parameter.
        :param value: Ask the node for this value, and show the message that it publishes, and nothing after it; by
            default the view asks for nothing, and follows.
        :param executor: As for LadderView.
        """
        self._event: ParameterEvent | None = None
        self._shown: object = self
        self._node = None if node is None else node_name(node)
        super().__init__(self._node or 'all nodes', executor)
        if self._node is not None and value is not ...:
            result = ParameterClient(self._node, executor=self._executor).set_parameter(name, value)
            if result.successful:
                wait_until(lambda: self._event, 'the message on /parameter_events')
            self._job.call_now(1.0)
            self._hold(f'{result}')

    def _subscribe(self, executor: BackgroundExecutor) -> Callable[[], None]:
        stops = [executor.on_parameter_event(self._on_event), executor.on_graph_change(self._job.wake)]

        def stop() -> None:
            for each in stops:
                each()
        return stop

    def _on_event(self, event: ParameterEvent) -> None:
        # Of a node that starts, the graph tells; a message for each of its declarations would hide the rest.
        is_wanted = event.node == self._node or (self._node is None and '/_' not in event.node)
        if is_wanted and (event.changed_parameters or event.deleted_parameters):
            self._event = event
            self._job.wake()

    def _show(self) -> None:
        if self._executor is None or not self._executor.is_running:
            self._shown = None
            self._say('The stage is stopped.')
            return
        tells, listens = ends_of_parameter_events(self._executor.tool_node)
        event = self._event
        shown = tells, listens, event
        if shown == self._shown:
            return
        # The same message is not sent again because somebody came or went.
        is_new = event is not None and not (isinstance(self._shown, tuple) and self._shown[2] is event)
        self._shown = shown
        told = [] if event is None else [
            f'{each.kind} {each.name}' + ('' if each.kind == 'deleted' else f' = {values.format_value(each.value, 40)}')
            for each in changes_in(event)]
        traffic = MessageTraffic(tells, listens, event.node if event else '', told)
        self._play(traffic.text, traffic.html, is_still=not is_new)


def _is_number(value: object) -> TypeGuard[float]:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _climb(record: RecordedSet) -> Climb:
    return Climb(record.timeline.node, record.timeline.name, record.timeline.steps, record.objection)


def _name_of(node: Node) -> str:
    try:
        return str(node.get_fully_qualified_name())
    except InvalidHandle:  # destroyed after the list of nodes was made
        return ''
