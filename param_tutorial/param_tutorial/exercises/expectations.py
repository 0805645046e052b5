"""What several chapters expect of a learner's node, each with words for the node that does something else."""

from rcl_interfaces.msg import SetParametersResult
from rclpy.node import Node

from param_tutorial.exercises.trial import Trial, expect
from param_tutorial.parameters.client import ParameterClient
from param_tutorial.parameters.values import ParameterType


def client_for(trial: Trial, name: str) -> ParameterClient:
    """Start the learner's node, and expect it to have a parameter."""
    client = trial.client(trial.start())
    expect(name in client.list_parameters(), f'a parameter `{name}`', 'the node has none of that name')
    return client


def expect_declared(trial: Trial, name: str, wanted: ParameterType, value: object) -> None:
    """Expect a parameter of a type, with a value to start with."""
    client = client_for(trial, name)
    found, start = client.describe_parameter(name).type, client.get_parameter(name)
    expect(found is wanted and start == value, _facts(wanted, value), _facts(found, start))


def _facts(parameter_type: ParameterType, value: object) -> str:
    return f'type {parameter_type.label}, ' + ('no value' if value is None else f'value `{value!r}`')


def expect_answer(trial: Trial, name: str, value: object, kind: str, because: str = '') -> None:
    """Expect the node's answer to a value to be of a kind.

    :param kind: As in SetResult.kind.
    :param because: What to think of when it accepts what it should not.
    """
    expect_result(client_for(trial, name), name, value, kind, because)


def expect_result(client: ParameterClient, name: str, value: object, kind: str, because: str = '') -> None:
    """Expect the answer of a node that is there already; as above."""
    result = client.set_parameter(name, value)
    expect(result.kind == kind, f'`{name} = {value!r}` is {"" if kind == "accepted" else "refused: "}{kind}',
           f'{result}' + (f'. {because}' if result.successful else ''))


def with_second_judge(node_class: type[Node]) -> type[Node]:
    """Derive a class of nodes with one more on-set callback, which is asked last, and refuses when it is told to."""
    class WithSecondJudge(node_class):
        has_second_judge = False
        refuses = False

        def add_on_set_parameters_callback(self, callback):
            if not self.has_second_judge:  # the oldest is asked last
                self.has_second_judge = True
                super().add_on_set_parameters_callback(self.second_judge)
            super().add_on_set_parameters_callback(callback)

        def second_judge(self, _):
            return SetParametersResult(successful=not self.refuses, reason='a second judge refuses')

    return WithSecondJudge


def expect_refused(trial: Trial, node: Node, new: dict[str, object]) -> None:
    """Expect a request, as a whole, to be refused with a reason."""
    result = trial.client(node).set_parameters_atomically(new)[0]
    asked = ', '.join(f'`{name} = {value!r}`' for name, value in new.items())
    expect(not result.successful, f'{asked} is refused', 'it was accepted')
    expect(result.reason.strip(), f'{asked} is refused with a reason', 'it was refused, and the reason is empty')


def expect_accepted(trial: Trial, node: Node, new: dict[str, object], because: str = '') -> None:
    """Expect a request, as a whole, to be accepted."""
    result = trial.client(node).set_parameters_atomically(new)[0]
    if result.reason == 'Callback returned an invalid type':  # rclpy's words for whatever else is returned
        because = '. An on-set callback has to return a `SetParametersResult`, whatever happens in it'
    asked = ', '.join(f'`{name} = {value!r}`' for name, value in new.items())
    expect(result.successful, f'{asked} is accepted', f'it was refused: {result.reason}{because}')


def expect_follows(trial: Trial, attribute: str, steps: list[tuple[dict[str, object], object]]) -> Node:
    """Expect an attribute of the node to have a value after each accepted change."""
    node = trial.start(with_second_judge(trial.work))
    for new, wanted in steps:
        expect_accepted(trial, node, new)
        found = getattr(node, attribute, None)
        asked = ', '.join(f'`{name} = {value!r}`' for name, value in new.items())
        expect(found == wanted, f'`self.{attribute}` is `{wanted!r}` once {asked} is stored', f'it is `{found!r}`')
    return node


def expect_left_alone(trial: Trial, node: Node, attribute: str, new: dict[str, object]) -> None:
    """Expect an attribute of the node to stay when another callback refuses a change."""
    before = getattr(node, attribute)
    node.refuses = True
    trial.client(node).set_parameters_atomically(new)
    after = getattr(node, attribute)
    asked = ', '.join(f'`{name} = {value!r}`' for name, value in new.items())
    expect(after == before, f'`self.{attribute}` stays `{before!r}` when a second judge refuses {asked}',
           f'it became `{after!r}`: that is a side effect of an on-set callback, which has only a proposal')


def without_deadlock(node_class: type[Node]) -> type[Node]:
    """Derive a class whose clients refuse to wait in a callback, where nothing could end the waiting any more."""
    class WithoutDeadlock(node_class):
        def create_client(self, *args, **options):
            client = super().create_client(*args, **options)
            client.call = self.call_and_wait
            return client

        def call_and_wait(self, request, timeout_sec=None):
            raise RuntimeError('call() waits for an answer that only the executor can bring, and this callback keeps '
                               'the executor busy. Use call_async()')

    return WithoutDeadlock
