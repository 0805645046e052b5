"""Exercises of chapter 10.2: put names to values, read all parameters of another node, and find a parameter in all
nodes."""

from textwrap import shorten
from typing import Any

from rcl_interfaces.srv import GetParameters
from rclpy.client import Client
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.task import Future

from param_tutorial.exercises.exercise import FUNCTION, NODE_CLASS, Exercise
from param_tutorial.exercises.expectations import WithoutDeadlock, derive, expect_service
from param_tutorial.exercises.trial import Trial, expect
from param_tutorial.parameters import values
from param_tutorial.parameters.snapshot import Snapshot, all_parameters

CHAPTER = '10_2_asking_another_node'
BY_NAME = 'Ask by name'
UNKNOWN = 'Break it: a name too many'
LIST_FIRST = 'Build it: first the names, then the values'
ALL = 'All parameters of all nodes'


class Rover(Node):
    """The robot that is inspected, with values that are easily missed."""

    def __init__(self) -> None:
        super().__init__('rover')
        self.declare_parameters('', [
            ('speed', 0), ('offset', 0.0), ('label', ''), ('enabled', False), ('gains', [0.5, 0.0])])


class Sleigh(Node):
    """Has the same name as the rover, and other parameters."""

    def __init__(self) -> None:
        super().__init__('rover')
        self.declare_parameters('', [('reindeer', 9), ('bells.count', 12)])


class Uncalibrated(Node):
    """A rover with a parameter that has no value."""

    def __init__(self) -> None:
        super().__init__('rover')
        self.declare_parameter('speed', 3)
        self.declare_parameter('calibration', Parameter.Type.DOUBLE)


inspect = Exercise('10.2a', 'Inspect a rover', CHAPTER, NODE_CLASS, node_name='inspector', hints=(
    'Two clients, made in the constructor, and two questions: `list_parameters` for the names, and when they are '
    'there, `get_parameters` for the values. `ParamQueryNode` does it.',
    '`call_async` gives a future, and `future.add_done_callback(self.on_names)` has your method called with it. The '
    'names are in `future.result().result.names`; `zip` puts names and values together.',
    'An answer without values means that one of the names has none: ask again, for each name alone.'))


class NotingQuestions(Node):
    """A mixin: keeps the futures of all that the node asks, so that one can tell when it has done its work."""

    questions: tuple[Future, ...] = ()

    def create_client(self, *args: Any, **options: Any) -> Client:
        client = super().create_client(*args, **options)
        call_async = client.call_async

        def note(request: Any) -> Future:
            self.questions = (*self.questions, call_async(request))
            return self.questions[-1]

        client.call_async = note  # type: ignore[method-assign]  # for this one client
        return client


def is_done(trial: Trial, inspector: NotingQuestions) -> bool:
    """True if all questions are answered, all answers heard, and nothing more was asked because of them."""
    questions = inspector.questions
    if not all(future.done() for future in questions):
        return False
    # The executor has set the last future when the first is over, and has called what waited for it after the second.
    for _ in range(2):
        trial.ros.run(lambda: None, 'let the executor come round')
    return len(questions) == len(inspector.questions)


def found_in(trial: Trial, rover_class: type[Node], *, left_out: tuple[str, ...] = ()) -> None:
    """Put a rover and the learner's inspector on the stage, let it inspect, and expect it to find everything.

    :param left_out: Names that may be there, with the value None, or not.
    """
    rover = trial.start(rover_class)
    inspector: Any = trial.start(derive(NotingQuestions, derive(WithoutDeadlock, trial.work)))
    expect(list(inspector.clients), 'the inspector has clients for services of `/rover`', 'it has none')
    for client in inspector.clients:
        expect_service(trial, client)
    wanted = {name: value for name, value in trial.client(rover).get_parameters().items() if name not in left_out}
    trial.press('`inspect()`', inspector.inspect)

    trial.wait(lambda: is_done(trial, inspector), 'all questions are answered', lambda: 'one is not')
    found = {name: values.normalize(value) for name, value in dict(inspector.found).items()
             if not (name in left_out and value is None)}
    expect(found.keys() == wanted.keys() and all(values.same(found[name], wanted[name]) for name in wanted),
           f'`self.found` is `{dict(wanted)!r}`', f'it is `{inspector.found!r}`')


@inspect.require('`self.found` holds every parameter with its value, and `inspect()` does not wait', see=BY_NAME)
def everything(trial: Trial) -> None:
    found_in(trial, Rover)


@inspect.require('whatever the parameters are called', see=LIST_FIRST)
def any_names(trial: Trial) -> None:
    found_in(trial, Sleigh)


@inspect.require('one parameter without a value does not hide the others', see=UNKNOWN)
def unset(trial: Trial) -> None:
    found_in(trial, Uncalibrated, left_out=('calibration',))


who = Exercise('10.2b', 'Who has it?', CHAPTER, FUNCTION, hints=(
    'A snapshot is a dictionary: `for node, parameters in snapshot.items()`. And `parameters` is one, too.',
    '`name in parameters` asks whether the node has the parameter; its value may be 0, and it is still there.',
    'Gather the answer in a dictionary, `found[node] = parameters[name]`, and return it behind the loop.'))


class Gripper(Node):
    """Has a speed as well."""

    def __init__(self) -> None:
        super().__init__('gripper')
        self.declare_parameters('', [('speed', 4), ('grip', True)])


def census(trial: Trial, name: str) -> None:
    """Take a snapshot of two nodes, and expect the learner's function to find a parameter in it."""
    snapshot: Snapshot = all_parameters([trial.start(Rover), trial.start(Gripper)], executor=trial.ros)
    wanted = {node: parameters[name] for node, parameters in snapshot.items() if name in parameters}
    given = trial.call('the function', trial.work, snapshot, name)
    expect(isinstance(given, dict) and given.keys() == wanted.keys()
           and all(values.same(given[node], wanted[node]) for node in wanted),
           f'for `{name}`: `{wanted!r}`', f'the function gave `{given!r}`')


@who.require('a parameter that one node has', see=ALL)
def one(trial: Trial) -> None:
    census(trial, 'grip')


@who.require('a parameter that both have, one of them with the value 0', see=ALL)
def both(trial: Trial) -> None:
    census(trial, 'speed')


@who.require('a parameter that nobody has: an empty dictionary', see=ALL)
def nobody(trial: Trial) -> None:
    census(trial, 'wings')


fill = Exercise('10.2c', 'Fill three gaps', CHAPTER, FUNCTION, hints=(
    'The values come in the order of the names, and `zip` takes the first of both, then the second of both, and so on.',
    'Each value is a message with a field for each type. `parameter_value_to_python` makes of it what Python has.'))


def pairs(trial: Trial, *names: str) -> None:
    """Ask a rover for some values, and expect the learner's function to give each its name."""
    rover = trial.start(Rover)
    request = GetParameters.Request(names=list(names))
    answer = trial.ros.services.call(rover.get_fully_qualified_name(), 'get_parameters', request).values
    given = trial.call('the function', trial.work, list(names), list(answer))
    expect(isinstance(given, dict), 'a dictionary', f'it gives `{given!r}`')
    held = trial.client(rover).get_parameters(names)
    found = {name: values.normalize(value) for name, value in given.items()}
    expect(found.keys() == held.keys() and all(values.same(found[name], held[name]) for name in held),
           f'`{dict(held)!r}`', f'it gives `{shorten(repr(given), 120)}`')


@fill.require('one name and one value', see=BY_NAME)
def one_pair(trial: Trial) -> None:
    pairs(trial, 'speed')


@fill.require('several, in the order of the names, whatever that is', see=BY_NAME)
def several_pairs(trial: Trial) -> None:
    pairs(trial, 'speed', 'label')
    pairs(trial, 'label', 'speed')


@fill.require('values of each type, also 0.0, an empty text and a list', see=BY_NAME)
def typed_pairs(trial: Trial) -> None:
    pairs(trial, 'gains', 'offset', 'enabled', 'label')


EXERCISES = (fill, inspect, who)
