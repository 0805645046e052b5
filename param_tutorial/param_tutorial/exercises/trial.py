"""A corner of the stage where a learner's work is tried out: nothing of it is left behind."""

import contextlib
import io
import linecache
import re
import tempfile
import time
import traceback
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from textwrap import shorten
from typing import Any, TypeVar, overload

import yaml
from rclpy.callback_groups import CallbackGroup
from rclpy.executors import await_or_execute
from rclpy.node import Node
from rclpy.serialization import serialize_message

from param_tools.cli import command
from param_tools.cli.session import Session
from param_tools.errors import (
    CallbackError,
    ExecutorError,
    NoAnswerError,
    ParameterToolError,
    StuckError,
    WaitTimeoutError,
    cause,
)
from param_tools.files.checking import check_files
from param_tools.files.parsing import LOADER
from param_tools.node.client import ParameterClient
from param_tools.ros import interrupts, stage
from param_tools.ros.executor import BackgroundExecutor, Failure
from param_tools.ros.service_types import SERVICE_TYPES
from param_tools.ros.waiting import deadline, wait, wait_until
from param_tutorial.package.loading import READERS

NodeT = TypeVar('NodeT', bound=Node)

# A node of the learner's own, of the same name, may be on the stage: ROS keeps the two apart by this namespace. It
# begins with an underscore, so tools do not list what is in it.
CORNER = '/_check'
# How long each constructor, function, answer or reaction may take.
TIME_LIMIT_SEC = 5.0
# How long a reaction may take after another one did not come: a check should not take minutes to say so. Ours take up
# to 1.5 s: a deadline that a timer notices at its second tick.
_SHORT_TIME_LIMIT_SEC = 2.0
# When a check as a whole should have come to its end. What comes close to it gets less and less,
# though never less than the short limit: a callback that sleeps is asked a dozen times.
_WHOLE_CHECK_SEC = 12.0

# What to think of when no answer comes.
STUCK = 'Does a callback wait, or loop forever?'
GROUP_IS_BUSY = ('Until it has finished, the executor starts nothing else in the callback group of the timer that '
                 'called it. Does the client have a group of its own?')
# What rclpy raises for a parameter file, with rcl's own words in it.
_NOT_A_PARAMETER_FILE = re.compile(r"Couldn't parse params file: .*? Error: (.*?), at \S+:\d+", re.DOTALL)
# The beginning of a node's name, or of a pattern. What begins with /** reaches the corner as it is, and /** itself must
# stay one block with that of `-p`; a dump of a node in the corner names it already.
_NODE_KEY = re.compile(rf'(["\']?)(?!/?\*\*|{CORNER}/)/?(?=[\w*])')


def overrides(start: Mapping[str, object]) -> list[str]:
    """Return the words after ``--ros-args`` with which a node starts with these values."""
    return [word for name, value in start.items() for word in ('-p', f'{name}:={value}')]


def moved_to(namespace: str) -> list[str]:
    """Return the rules that put a node into a namespace, and let it find the nodes there that an exercise names."""
    return [f'__ns:={namespace}', *(f'{name}:={namespace}{name}' for name in (
        '/cmd_vel', '/distance', *(f'{node}/{each}' for node in ('/rover', '/driver') for each in SERVICE_TYPES)))]


class NotYet(Exception):
    """A requirement is not met."""

    def __init__(self, expected: str, happened: str):
        super().__init__(f'expected: {expected}; happened: {happened}')
        self.expected = expected
        self.happened = happened


class NoUse(NotYet):
    """Neither this requirement nor any further one can be tried out."""


class NotTried(Exception):
    """An earlier requirement failed, and this one depends on it, so it is reported as not tried."""


class NoStart(NoUse):
    """A node does not get through its constructor."""


def take_for_granted(trial: 'Trial', *earlier: Callable[['Trial'], None]) -> None:
    """Raise NotTried unless earlier requirements, or parts of them, are met.

    :param earlier: The functions that try them out. Each is called once in a trial.
    """
    for examine in earlier:
        if examine not in trial.met:
            try:
                examine(trial)
                trial.met[examine] = True
            except (NoAnswerError, ExecutorError):
                raise
            except Exception:  # also what a callback has raised: it is told where it comes up first
                trial.met[examine] = False
        if not trial.met[examine]:
            raise NotTried


def expect(met: Any, expected: str, happened: str) -> None:
    """Raise NotYet unless it is met."""
    if not met:
        raise NotYet(expected, happened)


def describe_wrong_field(message: Any) -> str:
    """Return which field of a message, or of a message in it, has a value of the wrong type; empty if none has.

    rclpy checks the fields of a message only if it is made with ``check_fields=True``. Without the check, an integer in
    place of a double is sent as another number, which depends on the version of Python, and most other wrong values
    are not sent at all.
    """
    for name in message.get_fields_and_field_types():
        value = getattr(message, name)
        for each in value if isinstance(value, (list, tuple)) else ():
            if hasattr(each, 'get_fields_and_field_types') and (found := describe_wrong_field(each)):
                return found
        try:
            type(message)(**{name: value}, check_fields=True)
        except AssertionError as error:
            return f'{error}, and it is `{shorten(repr(value), 100)}`'
    return ''


def _expect_sendable(node: Node) -> None:
    """Expect a node to be able to send its descriptors: a client that asks for another one would wait forever.

    :raises NoUse: it is not.
    """
    for name in node.get_parameters_by_prefix(''):
        descriptor = node.describe_parameter(name)
        try:
            serialize_message(descriptor)
        except Exception as error:
            wrong = describe_wrong_field(descriptor) or describe_error(error)
            raise NoUse('descriptors that the node can send',
                        f'the descriptor of `{name}` cannot be sent: {wrong}') from None


class _TimeIsUp(BaseException):
    """Interrupts a learner's code. No Exception, lest the code's own ``except Exception`` catches it."""


class Trial:
    """What tries out a learner's work, one requirement after the other."""

    def __init__(self, ros: BackgroundExecutor, work: Any):
        self.ros = ros
        self.work = work
        self.names: set[str] = set()
        """The names of the nodes that were made of the work."""
        self.picture = ''
        """What the work made a robot do, as HTML, solved or not: a requirement that lets a robot drive puts it here."""
        self.met: dict[Callable[[Trial], None], bool] = {}
        """What has been tried out: whether the requirement is met that the function examines."""
        self._has_waited_in_vain = False
        self._should_end_at = deadline(_WHOLE_CHECK_SEC)
        self.begin()

    def begin(self) -> None:
        """Note which failures there are before a requirement is tried out."""
        self._times_shown_before = {id(failure): failure.times_shown for failure in list(self.ros.failures)}

    @overload
    def start(self, node_class: None = None, *, ros_args: Sequence[str] = (), namespace: str = '',
              all_services: bool = ...) -> Any: ...

    @overload
    def start(self, node_class: type[NodeT], *, ros_args: Sequence[str] = (), namespace: str = '',
              all_services: bool = ...) -> NodeT: ...

    def start(self, node_class: type[Node] | None = None, *, ros_args: Sequence[str] = (),
              namespace: str = '', all_services: bool = False) -> Any:
        """Put a node on the stage, in the corner.

        :param node_class: By default the learner's work, or derived from it.
        :param ros_args: As in BackgroundExecutor.add.
        :param namespace: Within the corner, with a slash in front.
        :param all_services: True if it matters that ``start_type_description_service`` has its default. rclpy 7.1.6
            leaves that service behind when a node is destroyed (ros2/rclpy#1711 tells why), and each one makes the next
            node slower to start.
        :raises NoStart: it does not start.
        :raises NoUse: it cannot send its descriptors.
        """
        node_class = node_class or self.work
        remapped = [word for rule in moved_to(f'{CORNER}{namespace}') for word in ('-r', rule)]
        # At the end, where it opens no block of parameters before others do.
        fewer = [] if all_services else ['-p', 'start_type_description_service:=false']
        began = time.monotonic()
        try:
            with _time_limit(self._limit_sec()):
                node = self.ros.add(node_class, ros_args=[*remapped, *ros_args, *fewer])
        except (Exception, SystemExit) as error:
            why = describe_error(error)
            # Another node, such as the one that the stage runs for the same file, may be in the way.
            kept_by = self.ros.culprit(began) if isinstance(error, WaitTimeoutError) else ''
            raise NoStart('a node that starts', kept_by or (
                f'its constructor did not finish. {why[0].upper()}{why[1:]}')) from None
        if isinstance(self.work, type) and issubclass(node_class, self.work):
            self.names.add(node.get_name())
            _expect_sendable(node)
        return node

    def start_with_files(self, node_class: type[NodeT], files: Mapping[str, str], *words: str,
                         namespace: str = '') -> NodeT:
        """Put a node on the stage, in the corner, with parameter files.

        :param files: The name of each, and its text. The names of nodes in it mean those in the corner.
        :param words: As ``ros_args``; the name of a file in them stands for its path.
        :raises NoStart: it does not start.
        :raises NoUse: rcl cannot read one of the files.
        """
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                Path(folder, name).write_text(_in_corner(text), encoding='utf-8')
            ros_args = [str(Path(folder, word)) if word in files else word for word in words]
            try:
                return self.start(node_class, ros_args=ros_args, namespace=namespace)
            except NoStart as error:
                if not (match := _NOT_A_PARAMETER_FILE.search(error.happened)):
                    raise
                for name, text in files.items():  # as the learner wrote it; rcl names no cause
                    Path(folder, name).write_text(text, encoding='utf-8')
                found = check_files([Path(folder, name) for name in files])
                why = next((f'{each.message} (line {each.line})' for each in found), match[1].strip())
                raise NoUse('a file that rcl can read', f'it cannot: {why}') from None

    def client(self, node: Node | str) -> ParameterClient:
        """Return a client for a node's parameters, with the time limit.

        :param node: The node, or the full name of one that a program has made.
        :raises NoUse: the node has no services for them; each request would wait until its time is over.
        """
        if isinstance(node, str):
            return ParameterClient(node, timeout_sec=TIME_LIMIT_SEC, executor=self.ros)
        if not any(service.srv_name.endswith('/set_parameters') for service in node.services):
            raise NoUse('a node that answers requests for its parameters',
                        'it has no services for them: was it created with `start_parameter_services=False`?')
        return ParameterClient(node, timeout_sec=self._limit_sec(), executor=self.ros)

    def _limit_sec(self) -> float:
        """Return how long a constructor, function or answer may take now."""
        left_sec = self._should_end_at - time.monotonic()
        return min(TIME_LIMIT_SEC, max(_SHORT_TIME_LIMIT_SEC, round(left_sec, 1)))

    def ros2(self, *words: str) -> str:
        """Type a command, as in a notebook, and return what it prints."""
        printed = io.StringIO()
        command.main(words, Session(printed, printed, lambda: self.ros, in_notebook=True))
        return printed.getvalue().strip()

    def call(self, what: str, function: Callable[..., Any], *args: Any) -> Any:
        """Call a function of the learner's in this thread.

        :param what: Names the call.
        :raises NotYet: the function raised an exception.
        :raises NoUse: it did not return.
        """
        try:
            with _time_limit(self._limit_sec()):
                return function(*args)
        except WaitTimeoutError as error:
            raise NoUse(f'{what} finishes', describe_error(error)) from None
        except (Exception, SystemExit) as error:
            raise NotYet(f'{what} finishes', describe_error(error)) from None

    def press(self, what: str, node: Node, function: Callable[[], Any], group: CallbackGroup | None = None, *,
              to_its_end: bool = True) -> None:
        """Have a timer of the learner's node call a function of theirs, once; it may be an ``async def``.

        :param group: The timer's callback group; by default the node's, so that what hangs there on a robot hangs here.
        :param to_its_end: False if it may wait for good at an ``await``, where it keeps no thread.
        :raises NoUse: the function raised an exception, or did not get to its end.
        """
        begun: list[bool] = []
        ends: list[BaseException | None] = []

        def begin() -> None:
            async def press_once() -> None:
                timer.cancel()
                begun.append(True)
                try:
                    await await_or_execute(function)
                    ends.append(None)
                except BaseException as error:  # also what the executor interrupts it with
                    ends.append(error)

            timer = node.create_timer(0.001, press_once, callback_group=group)

        self.ros.run(begin, what)
        limit_sec = self._limit_sec()
        if not (wait(lambda: ends or (begun and not to_its_end), limit_sec) and ends):
            with contextlib.suppress(StuckError):
                self.ros.run(lambda: None, what)  # interrupts a function that keeps the thread
        if not ends and not to_its_end:
            return
        if not ends:
            raise NoUse(f'{what} finishes',
                        f'it was still waiting at an `await` after {limit_sec:g} s. {GROUP_IS_BUSY}')
        error, = ends
        if isinstance(error, (Exception, SystemExit, KeyboardInterrupt)):
            raise NoUse(f'{what} finishes', describe_error(error)) from None
        if error is not None:
            raise NoUse(f'{what} does not wait', 'it was still running after some seconds, and kept the executor '
                        'busy that would have to bring what it waits for') from None

    def wait(self, condition: Callable[[], Any], expected: str, happened: Callable[[], str]) -> None:
        """Wait until a condition is true, or a callback raises an exception.

        :param happened: Returns what is the case instead.
        :raises NotYet: the condition is not true.
        """
        limit_sec = min(TIME_LIMIT_SEC, _SHORT_TIME_LIMIT_SEC) if self._has_waited_in_vain else TIME_LIMIT_SEC
        try:
            wait_until(lambda: condition() or self._failure(), expected, limit_sec)
        except WaitTimeoutError:
            self._has_waited_in_vain = True
            raise NotYet(expected, f'after {limit_sec:g} s, {happened()}') from None
        if not condition():  # looked at again: it may have come true before the failure
            raise NotYet(expected, happened())

    def raised(self) -> str:
        """Return what a callback has raised in this trial, with its name; nothing if none did.

        An exception that ended a service call does not count: the caller raises it.
        """
        if self.ros.is_running:
            self.ros.run(lambda: None, 'see the callbacks through')
        failure = self._failure()
        if failure is None:
            return ''
        if not isinstance(failure.error, (Exception, SystemExit)):  # the executor has interrupted it
            return f'{failure} did not return. {STUCK}'
        return f'{failure}{_describe_raised(failure.error)}'

    def _failure(self) -> Failure | None:
        return next((failure for failure in list(self.ros.failures)
                     if failure.times_shown > self._times_shown_before.get(id(failure), 0)
                     and (failure.callback is None or failure.callback.node_name.startswith(f'{CORNER}/'))), None)


def error_if_asked() -> ParameterToolError:
    """Return what input() raises during a check."""
    return ParameterToolError('nobody can type an answer to input() during a check: leave this line out, and let your '
                              'code take the value as an argument or a parameter')


def _error_if_stage_is_touched() -> ParameterToolError:
    """Return what start() and stop() of the stage raise during a check."""
    return ParameterToolError('during a check, param_tutorial.start() and stop() would take the check’s own nodes off '
                              'the stage: leave this line out')


@contextlib.contextmanager
def borrowed_stage() -> Iterator[BackgroundExecutor]:
    """Yield the executor in the background, or a temporary one, and clear it of what was added.

    :raises ExecutorError: no executor can be started.
    """
    try:
        ros, borrowed = stage.current(), True
    except ExecutorError:
        ros, borrowed = stage.start(), False
    try:
        with cleared(ros), stage.kept(_error_if_stage_is_touched):
            yield ros
        if ros.is_running:
            ros.run(lambda: ros.services.forget(CORNER), 'tidy up')
    finally:
        if not borrowed:
            stage.stop()


@contextlib.contextmanager
def cleared(ros: BackgroundExecutor) -> Iterator[None]:
    """Remove the nodes that are added in this block, unless a callback has stopped the executor for good."""
    before = ros.nodes
    try:
        yield
    finally:
        for node in reversed(ros.nodes):
            if ros.is_running and node not in before:
                ros.remove(node)


@contextlib.contextmanager
def _time_limit(limit_sec: float) -> Iterator[None]:
    """Interrupt the block after a time: in the main thread, and not on Windows.

    :raises WaitTimeoutError: the block was interrupted.
    """
    try:
        with interrupts.time_limit(limit_sec, _TimeIsUp):
            yield
    except _TimeIsUp:
        raise WaitTimeoutError(f'it was still running after {limit_sec:.2g} s') from None


def _in_corner(text: str) -> str:
    """Let a parameter file mean the nodes in the corner, in place of those of the same names."""
    try:
        top = yaml.compose(text, Loader=LOADER)
    except yaml.YAMLError:
        return text  # rcl says what is wrong with it
    if isinstance(top, yaml.MappingNode):
        for key, _ in reversed(top.value):
            if match := _NODE_KEY.match(text, key.start_mark.index):
                text = f'{text[:match.start()]}{match[1]}{CORNER}/{text[match.end():]}'
    return text


def _describe_raised(error: BaseException) -> str:
    """Return what a callback has raised, to follow its name."""
    return f'{": " if isinstance(error, ParameterToolError) else " raised "}{describe_error(error)}'


def describe_error(error: BaseException) -> str:
    """Return an exception as a sentence, with the line of the learner's code that it comes from."""
    if isinstance(error, CallbackError) and error.__cause__:
        return f'a callback{_describe_raised(error.__cause__)}'
    if isinstance(error, ParameterToolError):
        return str(error)
    said = str(error).rstrip('.')  # the line may follow
    words = f'{type(error).__name__}: {said}' if said else type(error).__name__
    line = ''
    for frame, number in traceback.walk_tb(error.__traceback__):
        if frame.f_globals.get('__name__') == '__main__' or READERS in frame.f_globals:
            line = linecache.getline(frame.f_code.co_filename, number, frame.f_globals).strip() or line
    return words + (f', in the line `{line}`' if line else '') + (f'. {why}' if (why := cause(error)) else '')
