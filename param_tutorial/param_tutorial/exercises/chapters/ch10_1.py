"""Exercises of chapter 10.1: read an event, keep a journal of another node's parameters, and predict how many
events there are."""

from collections.abc import Callable, Mapping, Sequence
from textwrap import shorten
from typing import Any

from rcl_interfaces.msg import ParameterDescriptor, ParameterEvent
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.qos import qos_profile_parameter_events
from rclpy.subscription import Subscription

from param_tutorial.exercises.exercise import DICTIONARY, FUNCTION, NODE_CLASS, Exercise
from param_tutorial.exercises.expectations import derive
from param_tutorial.exercises.trial import CORNER, NoUse, Trial, expect
from param_tutorial.parameters import values
from param_tutorial.runtime.managed import function_name
from param_tutorial.runtime.waiting import wait_until

CHAPTER = '10_1_parameter_events'
LISTENER = 'Build it: a listener'
WHAT_IS_TOLD = 'Change it: what is told, and how often'
BURST = 'Break it: a burst'
TOPIC = '/parameter_events'
BURST_LENGTH = 200


class Rover(Node):
    """The robot that is listened to; `last` is set to mark the end of an experiment."""

    def __init__(self) -> None:
        super().__init__('rover')
        self.declare_parameters('', [
            ('speed', 1), ('offset', 0.5), ('label', 'rover'), ('enabled', True), ('gains', [1.0, 2.0]), ('last', 0)])


class Gripper(Node):
    """Another node, which has nothing to do with it."""

    def __init__(self) -> None:
        super().__init__('gripper')
        self.declare_parameter('speed', 1)


class InTheCorner(Node):
    """A mixin: hears of the nodes in the corner only, under the names that they have for the learner."""

    events_heard: tuple[ParameterEvent, ...] = ()

    def create_subscription(self, msg_type: Any, topic: str, callback: Callable[[Any], object], *args: Any,
                            **options: Any) -> Subscription:
        def hear(message: Any) -> None:
            if not isinstance(message, ParameterEvent):
                callback(message)
            elif message.node.startswith(f'{CORNER}/'):
                message.node = message.node.removeprefix(CORNER)
                try:
                    callback(message)
                finally:
                    self.events_heard = (*self.events_heard, message)

        hear.__name__ = function_name(callback)
        return super().create_subscription(msg_type, topic, hear, *args, **options)


keep = Exercise('10.1a', 'Keep a journal', CHAPTER, NODE_CLASS, node_name='journal', hints=(
    'Subscribe in the constructor, as the node of the package does, and look at `event.node` in the callback.',
    'Go through the three lists of the message one after the other. `parameter_value_to_python(parameter.value)` '
    'is the value, also where it is 0.',
    'For the burst, the last argument of `create_subscription` has to be `qos_profile_parameter_events`.'))


def begin(trial: Trial) -> tuple[Rover, Any]:
    """Put a rover and the learner's journal on the stage."""
    rover = trial.start(Rover)
    journal: Any = trial.start(derive(InTheCorner, trial.work))
    if TOPIC not in [subscription.topic_name for subscription in journal.subscriptions]:
        raise NoUse(f'the journal subscribes to `{TOPIC}`', 'it does not')
    return rover, journal


def pages_after(trial: Trial, rover: Rover, journal: Any, action: Callable[[], object]) -> list[Any]:
    """Let something happen, and return what the journal has written down when it has heard of the end of it."""
    before = len(journal.pages)
    action()
    trial.client(rover).set_parameter('last', 1)
    trial.wait(lambda: 'last' in [each.name for event in journal.events_heard
                                  for each in event.changed_parameters],
               'the events reach the journal', lambda: 'they do not')
    return [page for page in journal.pages[before:] if not (isinstance(page, tuple) and page[1:2] == ('last',))]


def expect_pages(pages: Sequence[Any], wanted: Sequence[tuple[str, str, Any]]) -> None:
    """Expect these pages, each value of the right type; numbers of pages first."""
    for page in wanted:
        alike = [each for each in pages if isinstance(each, tuple) and len(each) == 3 and each[:2] == page[:2]]
        expect(any(values.same(values.normalize(each[2]), page[2]) for each in alike),
               f'a page `{page!r}`', f'there is `{alike[0]!r}`' if alike else f'the pages are `{pages!r}`')
    expect(len(pages) == len(wanted), f'{len(wanted)} pages', f'there are {len(pages)}')


@keep.require('every changed value is written down as it is', see=LISTENER)
def changed(trial: Trial) -> None:
    rover, journal = begin(trial)
    new = {'speed': 7, 'offset': 0.0, 'label': '', 'gains': [0.5, 0.0], 'enabled': False}
    pages = pages_after(trial, rover, journal, lambda: trial.client(rover).set_parameters_atomically(new))
    expect_pages(pages, [('changed', name, value) for name, value in new.items()])


@keep.require('new and deleted parameters are told from changed ones', see=WHAT_IS_TOLD)
def kinds(trial: Trial) -> None:
    rover, journal = begin(trial)

    def come_and_go() -> None:
        lamp = ParameterDescriptor(dynamic_typing=True)
        trial.ros.run(lambda: rover.declare_parameter('lamp', 0, lamp), 'declare a parameter')
        trial.client(rover).delete_parameter('lamp')

    expect_pages(pages_after(trial, rover, journal, come_and_go),
                 [('new', 'lamp', 0), ('deleted', 'lamp', None)])


@keep.require('only the rover is in it', see=LISTENER)
def rover_only(trial: Trial) -> None:
    rover, journal = begin(trial)
    gripper = trial.start(Gripper)

    def both() -> None:
        trial.client(gripper).set_parameter('speed', 3)
        trial.client(rover).set_parameter('speed', 5)

    pages = pages_after(trial, rover, journal, both)
    expect(('changed', 'speed', 5) in pages, "a page `('changed', 'speed', 5)` of the rover",
           f'the pages are `{pages!r}`')
    expect(len(pages) == 1, 'no page of the gripper', f'the pages are `{pages!r}`')


@keep.require(f'a burst of {BURST_LENGTH} changes is complete', see=BURST)
def burst(trial: Trial) -> None:
    rover, journal = begin(trial)

    def hurry() -> None:
        for speed in range(1, BURST_LENGTH + 1):
            rover.set_parameters([Parameter('speed', value=speed)])

    pages = pages_after(trial, rover, journal, lambda: trial.ros.run(hurry, 'set the speed in a burst'))
    speeds = {page[2] for page in pages if isinstance(page, tuple) and len(page) == 3 and page[1] == 'speed'}
    expect(speeds.issuperset(range(1, BURST_LENGTH + 1)), f'{BURST_LENGTH} pages',
           f'{len(speeds)} of the speeds are in it')


count = Exercise('10.1b', 'How many messages?', CHAPTER, DICTIONARY, hints=(
    'An event tells of what was stored at one go. `set_parameters` stores its parameters one by one.',
    'What is rejected is not stored. Which part of a request is rejected along with one parameter of it?',
    'The table in the section “Change it: what is told, and how often” has most of the numbers.'))


def require_count(what: str, action: Callable[[Trial, Rover], object], because: Mapping[int, str]) -> None:
    """Add the requirement to know how many events there are when something is done to a rover."""
    @count.require_prediction(what, see=WHAT_IS_TOLD, because=because)
    def counted(trial: Trial) -> Any:
        rover = trial.start(Rover)
        heard: list[ParameterEvent] = []
        stop_listening = trial.ros.on_parameter_event(
            lambda event: heard.append(event) if event.node == rover.get_fully_qualified_name() else None)
        try:
            trial.client(rover).set_parameter('last', 1)
            _wait_for_last(heard, 1)
            action(trial, rover)
            trial.client(rover).set_parameter('last', 2)
            return _wait_for_last(heard, 2)
        finally:
            stop_listening()


def _wait_for_last(heard: list[ParameterEvent], value: int) -> int:
    """Wait for the mark at the end, and return how many events have come since the mark before."""
    def marks() -> list[int]:
        return [index for index, event in enumerate(heard) if event.changed_parameters
                and event.changed_parameters[0].name == 'last']
    wait_until(lambda: len(marks()) >= value, 'the last event')
    return marks()[-1] - marks()[-2] - 1 if value > 1 else 0


TWO = {'speed': 3, 'label': 3}
THREE = {'speed': 3, 'offset': 0.25, 'enabled': False}

require_count('set_parameters with three parameters', lambda trial, rover: trial.client(rover).set_parameters(THREE),
              {1: 'It stores one after the other, and tells of each'})
require_count('set_parameters_atomically with three parameters',
              lambda trial, rover: trial.client(rover).set_parameters_atomically(THREE),
              {3: 'It stores them at one go, and tells of them at one go'})
require_count('set_parameters with two, of which one is rejected',
              lambda trial, rover: trial.client(rover).set_parameters(TWO),
              {0: 'Each is decided for itself: the other one is stored', 2: 'What is rejected is not told'})
require_count('set_parameters_atomically with two, of which one is rejected',
              lambda trial, rover: trial.client(rover).set_parameters_atomically(TWO),
              {1: 'All or nothing: no parameter of the request is stored'})
require_count('the value that it has already', lambda trial, rover: trial.client(rover).set_parameter('speed', 1),
              {0: 'A node does not compare: what is stored is told'})
require_count('declare_parameters with two parameters',
              lambda trial, rover: trial.ros.run(
                  lambda: rover.declare_parameters('', [('x', 1), ('y', 2)]), 'declare two parameters'),
              {0: 'A declaration stores a value too', 1: 'It declares one after the other'})
require_count('undeclare_parameter',
              lambda trial, rover: trial.ros.run(lambda: rover.undeclare_parameter('label'), 'undeclare'),
              {1: 'Nobody is told that a parameter is gone, but for a dynamic one that is set to nothing'})


fill = Exercise('10.1c', 'Fill two gaps', CHAPTER, FUNCTION, hints=(
    'An event has three lists: `new_parameters`, `changed_parameters` and `deleted_parameters`.',
    'Each element has a `name` and a `value`. The value is a message with a field for each type, and '
    '`parameter_value_to_python` finds the right one.'))


class Listener(Node):
    """Hears all events, and does nothing with them."""

    def __init__(self) -> None:
        super().__init__('listener')
        self.create_subscription(ParameterEvent, TOPIC, lambda _: None, qos_profile_parameter_events)


def changes_after(trial: Trial, action: Callable[[Rover], object]) -> list[Any]:
    """Let something happen to a rover, and return what the learner's function makes of each event of it."""
    rover = trial.start(Rover)
    listener = trial.start(derive(InTheCorner, Listener))
    action(rover)
    trial.client(rover).set_parameter('last', 1)

    def is_over() -> bool:
        return any(each.name == 'last' for event in listener.events_heard for each in event.changed_parameters)

    trial.wait(is_over, 'the events are heard', lambda: 'they are not')
    given = [trial.call('the function', trial.work, event) for event in listener.events_heard
             if event.node == '/rover' and not any(each.name in START for each in event.new_parameters)]
    for each in given:
        expect(isinstance(each, dict), 'a dictionary', f'it gives `{each!r}`')
    return given


START = ('speed', 'offset', 'label', 'enabled', 'gains', 'last', 'use_sim_time', 'start_type_description_service')


def expect_changes(given: Sequence[Any], wanted: Sequence[Mapping[str, Any]]) -> None:
    """Expect dictionaries, each value of the right type."""
    found = [{name: values.normalize(value) for name, value in each.items()} for each in given]
    expect(len(found) == len(wanted) and all(
        each.keys() == right.keys() and all(values.same(each[name], right[name]) for name in right)
        for each, right in zip(found, wanted)), f'`{wanted[0]!r}`', f'it gives `{shorten(repr(given[0]), 120)}`')


@fill.require('one change: its name and its value', see=LISTENER)
def one_change(trial: Trial) -> None:
    given = changes_after(trial, lambda rover: trial.client(rover).set_parameter('speed', 7))
    expect_changes(given, [{'speed': 7}, {'last': 1}])


@fill.require('several changes in one event, also to 0.0, an empty text and a list', see=LISTENER)
def all_types(trial: Trial) -> None:
    new = {'speed': 7, 'offset': 0.0, 'label': '', 'gains': [0.5, 0.0], 'enabled': False}
    given = changes_after(trial, lambda rover: trial.client(rover).set_parameters_atomically(new))
    expect_changes(given, [new, {'last': 1}])


@fill.require('what is new is not a change', see=WHAT_IS_TOLD)
def not_new(trial: Trial) -> None:
    one_change(trial)  # a function that finds nothing earns nothing
    given = changes_after(trial, lambda rover: trial.ros.run(
        lambda: rover.declare_parameter('lamp', 0), 'declare a parameter'))
    expect_changes(given, [{}, {'last': 1}])


EXERCISES = (fill, keep, count)
