"""What several chapters expect of a learner's work, each with words for work that does something else."""

import contextlib
import linecache
import re
import sys
import textwrap
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from rcl_interfaces.msg import ParameterDescriptor, SetParametersResult
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.client import Client
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.task import Future

from param_tools import values
from param_tools.errors import NodeNotFoundError
from param_tools.node.client import ParameterClient
from param_tools.ros import stage
from param_tools.ros.waiting import wait
from param_tools.values import ParameterType
from param_tutorial.exercises.trial import (
    CORNER,
    TIME_LIMIT_SEC,
    NodeT,
    NoStart,
    NotTried,
    NotYet,
    NoUse,
    Trial,
    describe_wrong_field,
    expect,
)


def client_for(trial: Trial, name: str) -> ParameterClient:
    """Start the learner's node, and expect it to have a parameter."""
    client = trial.client(trial.start())
    expect(name in client.list_parameters(), f'a parameter `{name}`', 'the node has none of that name')
    return client


def expect_declared(trial: Trial, name: str, wanted: ParameterType, value: object) -> None:
    """Expect the learner's node to have a parameter of a type, with a value to start with."""
    expect_start_value(trial.client(trial.start()), name, wanted, value)


def expect_start_value(client: ParameterClient, name: str, wanted: ParameterType, value: object) -> None:
    """Expect a node that has just started to have a parameter of a type, with a value; as above."""
    expect(name in client.list_parameters(), f'a parameter `{name}`', 'the node has none of that name')
    found, start = client.describe_parameter(name).type, client.get_parameter(name)
    # A descriptor that two declarations share may name another type than the value has.
    expect(found is wanted and values.same(start, value), _facts(wanted, value), _facts(found, start))


def take_type_for_granted(client: ParameterClient, wanted: ParameterType, *names: str) -> None:
    """Raise NotTried unless the node has parameters of a type, as an earlier requirement says."""
    if any(name not in client.list_parameters() or client.describe_parameter(name).type is not wanted
           for name in names):
        raise NotTried


def expect_fixed_type(client: ParameterClient, name: str) -> None:
    """Expect a parameter to take values of its own type alone."""
    expect(not client.describe_parameter(name).dynamic_typing, f'`{name}` keeps its type',
           'with `dynamic_typing`, it takes values of any type')


def _facts(parameter_type: ParameterType, value: object) -> str:
    return f'type {parameter_type.label}, ' + ('no value' if value is None else f'value `{value!r}`')


def expect_result(client: ParameterClient, name: str, value: object, kind: str, because: str = '') -> None:
    """Expect a node's answer to a value to be of a kind.

    :param kind: As in SetResult.kind.
    :param because: What to think of when it accepts what it should not.
    """
    result = client.set_parameter(name, value)
    expect(result.kind == kind, f'`{name} = {value!r}` is {"" if kind == "accepted" else "rejected: "}{kind}',
           f'{result}' + (f'. {because}' if because and result.successful else ''))


def expect_answers(client: ParameterClient, name: str, kind: str, *new: object, because: str = '') -> None:
    """Expect the node's answer to each of some values, set one after the other, to be of a kind; as above."""
    for value in new:
        expect_result(client, name, value, kind, because)


# rclpy's words if an on-set callback returns something else than a SetParametersResult.
_INVALID_TYPE = 'Callback returned an invalid type'
# What an exception in the learner's lines names in place of a file.
_LINES = '<your lines>'


def run_lines(trial: Trial, **names: object) -> dict[str, Any]:
    """Run the learner's text as a cell of a notebook, and return all names that there are afterwards.

    :param names: What is there before.
    :raises NoUse: there is nothing to run, or it does not get to its end.
    """
    text = textwrap.dedent(trial.work)  # a notebook takes a cell that is indented as a whole
    if not text.strip():
        raise NoUse('some lines', 'there is none')
    space: dict[str, Any] = {'__name__': '__main__', **names}
    # So that the line which raises can be shown.
    linecache.cache[_LINES] = len(text), None, text.splitlines(keepends=True), _LINES
    try:
        trial.call('the last line', lambda: exec(compile(text, _LINES, 'exec'), space))
    except NotYet as error:
        raise NoUse('the lines run to their end', error.happened) from None
    return space


class ClientInCorner(ParameterClient):
    """What ParameterClient is for the learner, whose nodes are in the corner during a check."""

    def __init__(self, node: Node | str, *arguments: Any, **options: Any):
        if isinstance(node, str) and not node.startswith(f'{CORNER}/'):  # a node's own full name is right already
            node = f'{CORNER}/{node.lstrip("/")}'
        super().__init__(node, *arguments, **options)

    def _call(self, service: str, request: Any) -> Any:
        # Others may be on their way; those in the corner are in this process. A search that takes as long as discovery
        # may take would be ended by the time limit, which does not know that a name is wrong.
        if self.node not in (each.get_fully_qualified_name() for each in self.executor.nodes):
            raise NodeNotFoundError(self.node, self.executor.services.node_names())
        return super()._call(service, request)


# An AttributeError, for one, names the class as the learner knows it.
ClientInCorner.__name__ = ParameterClient.__name__


def derive(mixin: type[NodeT], node_class: type[Node]) -> type[NodeT]:
    """Return a class of nodes like another one, and of its name, with the methods of a mixin in front."""
    return type(node_class.__name__, (mixin, node_class), {})


class WithSecondJudge(Node):
    """A mixin: one more on-set callback, which is asked last, and rejects when it is told to."""

    has_second_judge = False
    rejects = False

    def declare_parameters(self, *args: Any, **options: Any) -> list[Parameter]:
        self.add_second_judge()  # here too, for a node that judges nothing itself
        return super().declare_parameters(*args, **options)

    def add_on_set_parameters_callback(self, callback: Callable[[list[Parameter]], SetParametersResult]) -> None:
        self.add_second_judge()
        super().add_on_set_parameters_callback(callback)

    def add_second_judge(self) -> None:
        if not self.has_second_judge:  # the oldest is asked last
            self.has_second_judge = True
            super().add_on_set_parameters_callback(self.second_judge)

    def second_judge(self, _: list[Parameter]) -> SetParametersResult:
        return SetParametersResult(successful=not self.rejects, reason='a second judge rejects')


class Question(NamedTuple):
    """A request that a node has sent."""

    client: Client
    answer: Future


class NotesQuestions(Node):
    """A mixin: notes the requests that the clients of a node send, and raises an exception where one would deadlock."""

    questions_noted: tuple[Question, ...] = ()
    most_open: tuple[int, int] = (0, 0)
    """The most questions that were without an answer at once, and how many answers their client keeps."""

    def create_client(self, *args: Any, **options: Any) -> Client:
        client = super().create_client(*args, **options)
        call, call_async = client.call, client.call_async  # the first goes through the second

        def note(request: Any) -> Future:
            answer = call_async(request)
            self.questions_noted = (*self.questions_noted, Question(client, answer))
            count = sum(each.client is client and not each.answer.done() for each in self.questions_noted)
            self.most_open = max(self.most_open, (count, client.qos_profile.depth))
            return answer

        def call_elsewhere(*args: Any, **options: Any) -> Any:
            if stage.current().in_thread():
                raise RuntimeError('call() blocks until the answer has come, which only the executor can bring, and '
                                   'this callback keeps it busy. Use call_async()')
            return call(*args, **options)

        # For this one client.
        client.call, client.call_async = call_elsewhere, note  # type: ignore[method-assign]
        return client

    def count_unanswered(self) -> int:
        """Return how many questions have no answer, whether or not one will come."""
        return sum(not each.answer.done() for each in self.questions_noted)


def start_asking(trial: Trial) -> Any:
    """Start the learner's node, which is to ask another one, and expect its clients to find their services.

    :return: The node, whose class is now derived from NotesQuestions.
    :raises NoUse: it creates no client, or one for a service that there is not.
    """
    try:
        node: Any = trial.start(derive(NotesQuestions, trial.work))
    except NoStart as error:
        if match := re.search(r'topic name r[qr]/(\S+)Re(quest|ply) with incompatible type', error.happened):
            raise NoUse('the client finds its service',
                        f'the service `/{match[1]}` is of another type than the client') from None
        raise
    clients = list(node.clients)
    if not clients:
        raise NoUse('the constructor creates a client', 'it creates none')
    for client in clients:
        _expect_service(trial, client)
    return node


@contextlib.contextmanager
def awake() -> Iterator[None]:
    """Let ``time.sleep`` raise an exception in the executor's thread: a short sleep blocks it too."""
    sleep = time.sleep

    def sleep_elsewhere(seconds: Any) -> None:
        if stage.current().in_thread():
            raise RuntimeError('time.sleep() blocks the thread, and no answer comes while it does. So does whatever '
                               'sleeps inside, as wait_for_service() does')
        sleep(seconds)

    time.sleep = sleep_elsewhere
    try:
        yield
    finally:
        time.sleep = sleep


def expect_no_wait(trial: Trial, method: str) -> None:
    """Expect a method of the learner's node to keep no thread while no rover is there that would answer."""
    for each in trial.ros.nodes:
        if each.get_namespace() == CORNER:
            trial.ros.remove(each)
    try:
        node: Any = trial.start(derive(NotesQuestions, trial.work))
        wait(lambda: not any(each.service_is_ready() for each in node.clients), TIME_LIMIT_SEC)
        with awake():
            trial.press(f'`{method}()`, without a rover,', node, getattr(node, method),
                        MutuallyExclusiveCallbackGroup(), to_its_end=False)
    except NoUse as error:
        raise NotYet(error.expected, error.happened) from None
    wait(lambda: node.questions_noted, 1.0)  # by a thread that would ask a node that has gone


def _expect_service(trial: Trial, client: Client) -> None:
    try:
        trial.wait(client.service_is_ready, 'the client finds its service',
                   lambda: f'there is no service `{client.srv_name}` of that type')
    except NotYet as error:
        raise NoUse(error.expected, error.happened) from None


def expect_rejected(trial: Trial, node: Node | str, new: Mapping[str, object], because: str = '') -> None:
    """Expect a request, as a whole, to be rejected with a reason.

    :param because: What to think of if it is accepted.
    """
    result = trial.client(node).set_parameters_atomically(new)[0]
    asked = ', '.join(f'`{name} = {value!r}`' for name, value in new.items())
    expect(not result.successful, f'{asked} is rejected', f'it was accepted{because}')
    expect(result.reason.strip(), f'{asked} is rejected with a reason', 'it was rejected, and the reason is empty')
    expect(result.reason != _INVALID_TYPE, f'{asked} is rejected with a reason',
           f'it was rejected, but the reason is rclpy’s own, “{_INVALID_TYPE}”: an on-set callback has to return a '
           '`SetParametersResult`')


def expect_accepted(trial: Trial, node: Node | str, new: Mapping[str, object], because: str = '') -> None:
    """Expect a request, as a whole, to be accepted.

    :raises NoUse: an on-set callback returns something else than a result, as it would in the other requirements.
    """
    result = trial.client(node).set_parameters_atomically(new)[0]
    asked = ', '.join(f'`{name} = {value!r}`' for name, value in new.items())
    if result.reason == _INVALID_TYPE:
        raise NoUse(f'{asked} is accepted', f'it was rejected: {_INVALID_TYPE}. An on-set callback has to return a '
                    '`SetParametersResult`, whatever happens in it')
    expect(result.successful, f'{asked} is accepted',
           (f'it was rejected: {result.reason}' if result.reason else 'it was rejected without a reason') + because)


def format_found(value: object) -> str:
    """Return what an attribute holds, for a sentence; a parameter object in its place is a common mistake."""
    return 'a `Parameter` and not its value' if isinstance(value, Parameter) else f'`{value!r}`'


def expect_follows(trial: Trial, attribute: str, steps: Sequence[tuple[Mapping[str, object], object]]
                   ) -> WithSecondJudge:
    """Expect an attribute of the node to have a value as soon as a change is accepted.

    A node hears of its event before a client has the answer. Only in the executor's thread is nothing between the two.
    """
    node = trial.start(derive(WithSecondJudge, trial.work))
    for new, wanted in steps:
        expect_accepted(trial, node, new)
        _expect_attribute(attribute, wanted, new, getattr(node, attribute, None))
    node = trial.start(derive(WithSecondJudge, trial.work))
    for new, wanted in steps:
        parameters = [Parameter(name, value=value) for name, value in new.items()]
        found = trial.ros.run(lambda parameters=parameters: (  # type: ignore[misc]
            node.set_parameters_atomically(parameters), getattr(node, attribute))[1], 'set a parameter')
        _expect_attribute(attribute, wanted, new, found, ' in the call that stores it, and follows later. rclpy calls '
                          'post-set callbacks in that call')
    return node


def _expect_attribute(name: str, wanted: object, new: Mapping[str, object], found: object, when: str = '') -> None:
    asked = ', '.join(f'`{name} = {value!r}`' for name, value in new.items())
    expect(found == wanted, f'`self.{name}` is `{wanted!r}` once {asked} is stored',
           f'it is {format_found(found)}{when}')


def expect_left_alone(trial: Trial, node: WithSecondJudge, attribute: str, new: Mapping[str, object]) -> None:
    """Expect an attribute of the node to stay when another callback rejects a change."""
    before = getattr(node, attribute)
    node.rejects = True
    trial.client(node).set_parameters_atomically(new)
    after = getattr(node, attribute)
    asked = ', '.join(f'`{name} = {value!r}`' for name, value in new.items())
    expect(after == before, f'`self.{attribute}` stays `{before!r}` when a second judge rejects {asked}',
           f'it became `{after!r}`: that is a side effect of an on-set callback, which has only a proposal')


def expect_text(trial: Trial) -> None:
    """Expect the learner to have written something into a parameter file.

    :raises NoUse: nothing is there.
    """
    if not trial.work.strip():
        raise NoUse('the text of a parameter file', 'there is nothing in it yet')


def expect_range(client: ParameterClient, name: str, lowest: float, highest: float, step: float | None = None) -> None:
    """Expect the descriptor of a parameter to have a range, with its ends in either order.

    :param step: 0 for any value between the ends, None for any step.
    """
    steps = '' if step is None else f' in steps of {step!r}' if step else ', in any steps'
    wanted = f'the descriptor of `{name}` has a range from {lowest!r} to {highest!r}{steps}'
    limits = client.describe_parameter(name).range
    if limits is None:
        raise NotYet(wanted, 'it has none for its type: a callback may reject, but no panel can know')
    fields = sorted(((limits.from_value, 'from_value'), (limits.to_value, 'to_value')))
    for (found, field), end in zip(fields, (lowest, highest), strict=True):
        # The smallest of all floats is what the bits of an integer make.
        expect(found == end, wanted, f'its `{field}` is {found!r}' + (
            '. A float has a dot, as in `0.0`' if 0.0 < found < sys.float_info.min else ''))
    expect(step is None or limits.step == step, wanted, f'its `step` is {limits.step!r}')


def expect_range_fields(node: Node, name: str) -> None:
    """Expect the fields of a parameter's range to be of their types, whatever this version of Python makes of them."""
    descriptor = node.describe_parameter(name)
    wrong = describe_wrong_field(ParameterDescriptor(integer_range=descriptor.integer_range,
                                                     floating_point_range=descriptor.floating_point_range))
    expect(not wrong, f'the range of `{name}` has fields of the right types', f'with `check_fields=True`, Python says: '
           f'{wrong}' + ('. A float has a dot, as in `0.0`' if "type 'float'" in wrong else ''))


def expect_no_start(trial: Trial, words: Sequence[str], expected: str, happened: str) -> None:
    """Expect the learner's node not to start with words after ``--ros-args``."""
    try:
        trial.start(ros_args=words)
    except NoStart:
        return
    raise NotYet(expected, happened)


def expect_override(trial: Trial, name: str, word: str, value: object) -> None:
    """Expect a parameter of the learner's node to have a value after a start with an override.

    :param word: The value in the command line.
    """
    found = trial.client(trial.start(ros_args=['-p', f'{name}:={word}'])).get_parameter(name)
    expect(values.same(found, value), f'`{name}` is `{value!r}` after a start with `-p {name}:="{word}"`',
           f'it is `{found!r}`')


def expect_no_gap(shown: str = '', names: Sequence[str] = ()) -> None:
    """Expect each `...` of the learner's work to be filled in.

    :param shown: An exception or a message as text. Python calls the three dots an ellipsis.
    :param names: Of what still has a gap, if they are known.
    :raises NoUse: a gap is left, so that nothing else would say more.
    """
    if names or 'ellipsis' in shown.casefold():
        raise NoUse('something in place of each `...`',
                    'a `...` is still there' + (f', for {", ".join(names)}' if names else ''))
