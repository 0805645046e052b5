"""Exercises of chapter 10.2: put names to values, read all parameters of another node, and find a parameter in all
nodes."""

from collections.abc import Mapping
from textwrap import shorten

from rcl_interfaces.srv import GetParameters
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools import values
from param_tools.errors import NoAnswerError
from param_tools.node.client import ParameterValues
from param_tools.systems.snapshot import Snapshot
from param_tutorial.exercises.exercise import FUNCTION, NODE_CLASS, Exercise
from param_tutorial.exercises.expectations import NotesQuestions, expect_no_gap, expect_no_wait, start_asking
from param_tutorial.exercises.trial import NotYet, NoUse, Trial, expect

CHAPTER = '10_2_asking_another_node'
BY_NAME = 'Ask by name'
UNKNOWN = 'Break it: a name too many'
LIST_FIRST = 'Build it: first the names, then the values'
ALL = 'All parameters of all nodes'


class Rover(Node):
    """The robot to inspect, with values that are easily missed."""

    def __init__(self) -> None:
        super().__init__('rover')
        self.declare_parameters('', [
            ('speed', 0), ('offset', 0.0), ('label', ''), ('enabled', False), ('gains', [0.5, 0.0]),
            ('legs', ['left', '']), ('steps', [3, 0])])


class Sleigh(Node):
    """Has the same name as the rover, and other parameters.

    A client of default QoS keeps ten answers. There are more parameters, so an inspector that sends all its questions
    at once would miss some if this node were in another process.
    """

    def __init__(self) -> None:
        super().__init__('rover')
        self.declare_parameters('', [('reindeer', 9), ('bells.count', 12), ('bells.of.brass', True), ('a', 0.5)])
        for number in range(30):
            self.declare_parameter(f'gifts.number_{number}', number)


class Uncalibrated(Node):
    """A rover with parameters that are not set, between others."""

    def __init__(self) -> None:
        super().__init__('rover')
        for name in ('calibration', 'wear.left'):
            self.declare_parameter(name, Parameter.Type.DOUBLE)
            self.declare_parameter(f'{name}_count', 3)


inspect = Exercise('10.2b', 'Inspect a rover', CHAPTER, NODE_CLASS, node_name='inspector', hints=(
    'Create two clients in the constructor, and ask two questions: `list_parameters` for the names and, once they are '
    'there, `get_parameters` for the values. `ParamQueryNode` and `Reader` both do it.',
    '`call_async` returns a future. Await it in an `async def inspect`, or use '
    '`future.add_done_callback(self.on_names)`, which calls your method with the future. The names are in '
    '`future.result().result.names`; `zip` pairs names and values.',
    'An answer without values means that one of the parameters is not set: ask again, for each name separately.'))


def _asks_no_more(trial: Trial, inspector: NotesQuestions) -> bool:
    """True if a node does not go on asking because of what it has heard."""
    count = len(inspector.questions_noted)
    # The executor has set the last future when the first is over, has called what waited for it after the second, and
    # has gone on with what awaited it after the third.
    for _ in range(3):
        trial.ros.run(lambda: None, 'let the executor come round')
    return len(inspector.questions_noted) == count


def _lost(inspector: NotesQuestions) -> str:
    """Say how many questions have no answer, for a sentence; nothing if all have one."""
    count = inspector.count_unanswered()
    return f', and {count} of {len(inspector.questions_noted)} questions have no answer' if count else ''


def found_in(trial: Trial, rover_class: type[Node]) -> None:
    """Put a rover and the learner's inspector on the stage, let it inspect, and expect it to find everything."""
    rover = trial.start(rover_class)
    inspector = start_asking(trial)
    button = getattr(inspector, 'inspect', None)
    if not callable(button):
        raise NoUse('a method `inspect`', 'the class has none')
    held = trial.client(rover).get_parameters()
    wanted = {name: value for name, value in held.items() if value is not None}

    def has_found_all() -> bool:
        if not isinstance(inspector.found, Mapping):
            return False
        # A parameter that is not set may be there with None, or not.
        found = {name: values.normalize(value) for name, value in inspector.found.items()
                 if not (value is None and name in held)}
        return found.keys() == wanted.keys() and all(values.same(found[name], wanted[name]) for name in wanted)

    # In a group of its own, as the timer of the chapter's `Reader`.
    trial.press('`inspect()`', inspector, button, MutuallyExclusiveCallbackGroup())
    trial.wait(lambda: not inspector.count_unanswered() and _asks_no_more(trial, inspector) and has_found_all(),
               f'`self.found` is `{shorten(repr(wanted), 400)}`',
               lambda: f'it is `{shorten(repr(inspector.found), 400)}`{_lost(inspector)}')
    count, depth = inspector.most_open
    expect(count <= depth, f'at most {depth} questions are without an answer at once',
           f'{count} were, and the client keeps the last {depth} answers. With a rover in another process the others '
           f'are lost')
    if raised := trial.raised():  # under rclpy.spin it would be the node's end
        raise NoUse('no callback raises an exception', raised)


@inspect.require('`self.found` holds every parameter with its value, and `inspect()` does not block', see=BY_NAME)
def everything(trial: Trial) -> None:
    found_in(trial, Rover)
    expect_no_wait(trial, 'inspect')


@inspect.require('whatever the parameters are called, and however many there are', see=LIST_FIRST)
def any_names(trial: Trial) -> None:
    found_in(trial, Sleigh)


@inspect.require('parameters that are not set do not hide the others', see=UNKNOWN)
def unset(trial: Trial) -> None:
    found_in(trial, Uncalibrated)


who = Exercise('10.2c', 'Who has it?', CHAPTER, FUNCTION, hints=(
    'A snapshot is a dictionary: `for node, parameters in snapshot.items()`. And `parameters` is one, too.',
    '`name in parameters` asks whether the node has the parameter. Its value may be 0 or `None`, but it is there.',
    'Collect the answer in a dictionary, `found[node] = parameters[name]`, and return it after the loop.'))


def snapshot() -> Snapshot:
    """Return a snapshot with values and names that are easily confused, and a node that did not answer."""
    return Snapshot({
        '/arm/gripper': ParameterValues({'grip': True, 'label': '', 'speed_limit': 9}),
        '/camera': ParameterValues({'exposure_ms': None, 'label': 'front', 'pid.speed': 2.5}),
        '/gripper': ParameterValues({'speed': 4, 'gains': [0.5, 0.0]}),
        '/mast': ParameterValues({'speed': 4}),
        '/rover': ParameterValues({'speed': 0, 'enabled': False, 'wings': [], 'exposure_ms': 5.0}),
        '/scale': ParameterValues(),
    }, {'/dozing': NoAnswerError('/dozing', 'list_parameters', 0.5)})


def census(trial: Trial, *names: str) -> None:
    """Expect the learner's function to find parameters in a snapshot."""
    for name in names:
        wanted = {node: parameters[name] for node, parameters in snapshot().items() if name in parameters}
        try:
            given = trial.call('the function', trial.work, handed := snapshot(), name)
        except NotYet as error:
            raise NoUse(f'for `{name}`: `{wanted!r}`', error.happened) from None
        if handed != snapshot():
            raise NoUse('the snapshot stays as it is', 'the function has changed it, for the next one who looks')
        expect(isinstance(given, dict) and given.keys() == wanted.keys()
               and all(values.same(given[node], wanted[node]) for node in wanted),
               f'for `{name}`: `{wanted!r}`', f'the function returned `{shorten(repr(given), 200)}`')


@who.require('a parameter that one node has', see=ALL)
def one(trial: Trial) -> None:
    census(trial, 'grip', 'gains')


@who.require('a parameter that several nodes have, also with the value 0, or not set', see=ALL)
def both(trial: Trial) -> None:
    census(trial, 'speed', 'label', 'exposure_ms')


@who.require('a parameter that no node has: an empty dictionary', see=ALL)
def nobody(trial: Trial) -> None:
    census(trial, 'pid', 'Speed')


fill = Exercise('10.2a', 'Fill three gaps', CHAPTER, FUNCTION, hints=(
    'The values come in the order of the names, and `zip` takes the first of both, then the second of both, and so on.',
    'Each value is a message with a field for each type. `parameter_value_to_python` returns the Python value.'))


def pairs(trial: Trial, *names: str) -> None:
    """Ask a rover for some values, and expect the learner's function to give each its name."""
    rover = trial.start(Rover)
    request = GetParameters.Request(names=list(names))
    answer = trial.ros.services.call(rover.get_fully_qualified_name(), 'get_parameters', request).values
    try:
        given = trial.call('the function', trial.work, list(names), list(answer))
    except NotYet as error:
        expect_no_gap(error.happened)
        raise NoUse(error.expected, error.happened) from None
    expect(isinstance(given, dict), 'a dictionary', f'it returned `{shorten(repr(given), 120)}`')
    held = trial.client(rover).get_parameters(names)
    found = {name: values.normalize(value) for name, value in given.items()}
    expect(found.keys() == held.keys() and all(values.same(found[name], held[name]) for name in held),
           f'`{dict(held)!r}`', f'it returned `{shorten(repr(given), 120)}`')


@fill.require('one name and one value', see=BY_NAME)
def one_pair(trial: Trial) -> None:
    pairs(trial, 'speed')


@fill.require('several, in the order of the names, whatever that is', see=BY_NAME)
def several_pairs(trial: Trial) -> None:
    pairs(trial, 'speed', 'label')
    pairs(trial, 'label', 'speed')


@fill.require('values of each type, also 0.0, an empty string and lists', see=BY_NAME)
def typed_pairs(trial: Trial) -> None:
    pairs(trial, 'gains', 'offset', 'enabled', 'label', 'legs', 'steps')


EXERCISES = (fill, inspect, who)
