"""Exercises of chapter 10.1: the tuner listens to the driver's events; how many events there are; and a journal of
another node's parameters."""

import contextlib
import inspect
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from textwrap import shorten
from typing import Any

from rcl_interfaces.msg import ParameterDescriptor, ParameterEvent, SetParametersResult
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.qos import qos_profile_parameter_events
from rclpy.subscription import Subscription

from param_tools import values
from param_tools.errors import NoAnswerError, WaitTimeoutError
from param_tools.ros.executor import function_name
from param_tools.ros.waiting import wait_until
from param_tutorial.exercises.exercise import DICTIONARY, NODE_CLASS, Exercise
from param_tutorial.exercises.expectations import derive
from param_tutorial.exercises.steps import TUNER
from param_tutorial.exercises.trial import CORNER, NotYet, NoUse, Trial, cleared, expect, take_for_granted

CHAPTER = '10_1_parameter_events'
LISTENER = 'A listener'
WHAT_IS_PUBLISHED = 'What is published, and how often'
BURST = 'Too many at once'
TOPIC = '/parameter_events'
BURST_LENGTH = 200


class Rover(Node):
    """The robot that is listened to; `last` is set to mark the end of an experiment."""

    def __init__(self, name: str = 'rover') -> None:
        super().__init__(name)
        self.declare_parameters('', [
            ('speed', 1), ('offset', 0.5), ('label', 'rover'), ('enabled', True), ('gains', [1.0, 2.0]), ('last', 0)])
        self.declare_parameter('target', Parameter.Type.DOUBLE)


class RoverArm(Rover):
    """Another node, whose name begins like the rover's."""

    def __init__(self) -> None:
        super().__init__('rover_arm')


class InTheCorner(Node):
    """A mixin: hears only the nodes in the corner, under the names that they have for the learner."""

    events_heard: tuple[ParameterEvent, ...] = ()
    """Once for each subscription."""
    subscription_count = 0
    raised = False
    busy_sec = 0.0
    """For how long its callbacks have run, in all."""

    def create_subscription(self, msg_type: Any, topic: str, callback: Callable[[Any], object], *args: Any,
                            **options: Any) -> Subscription:
        def hear(message: Any) -> None:
            with self._noted(message) as is_heard:
                if is_heard and inspect.iscoroutine(begun := callback(message)):
                    # A journal has nothing to await, so the coroutine runs to its end at once.
                    with contextlib.suppress(StopIteration):
                        begun.send(None)

        hear.__name__ = function_name(callback)
        if topic == TOPIC.removeprefix('/'):  # relative to the root namespace, where a learner's node stands
            topic = TOPIC
        self.subscription_count += topic == TOPIC
        return super().create_subscription(msg_type, topic, hear, *args, **options)

    @contextlib.contextmanager
    def _noted(self, message: Any) -> Iterator[bool]:
        """Note that a message was heard, and yield whether the learner's callback hears it too."""
        if not isinstance(message, ParameterEvent) or not message.node.startswith(f'{CORNER}/'):
            yield not isinstance(message, ParameterEvent)
            return
        message.node = message.node.removeprefix(CORNER)
        began = time.monotonic()
        try:
            # What it raises once it would raise at each event of a burst, and so it is with waiting.
            yield not self.raised and self.busy_sec < _BUSY_SEC
        except BaseException:  # an endless loop is interrupted with more than an Exception
            self.raised = True
            raise
        finally:
            self.busy_sec += time.monotonic() - began
            self.events_heard = (*self.events_heard, message)


keep = Exercise('10.1c', 'Keep a journal', CHAPTER, NODE_CLASS, node_name='journal', hints=(
    'Subscribe in the constructor, as your tuner does, and look at `event.node` in the callback.',
    'Go through the three lists of the message one after the other. `parameter_value_to_python(parameter.value)` '
    'returns the value, even if it is 0.',
    'For the burst, the last argument of `create_subscription` has to be `qos_profile_parameter_events`.'))

# A callback that does not wait is done with a burst in a hundredth of this time.
_BUSY_SEC = 2.0
# How long a journal may take to write down what it has heard: it need not do so in the callback.
_WRITING_SEC = 0.5


def begin(trial: Trial) -> tuple[Rover, Any]:
    """Put a rover and the learner's journal on the stage."""
    rover = trial.start(Rover)
    journal: Any = trial.start(derive(InTheCorner, trial.work))
    if not journal.subscription_count:
        raise NoUse(f'the journal subscribes to `{TOPIC}`', 'it does not')
    if not hasattr(journal, 'pages'):
        raise NoUse('the journal has a list `self.pages`', 'it has none')
    return rover, journal


def pages_after(trial: Trial, rover: Rover, journal: Any, action: Callable[[], object]) -> list[Any]:
    """Let something happen, and return what the journal has written down about it.

    :raises NoUse: the journal does not hear of it, or raises an exception when it does.
    """
    before = len(journal.pages)
    waits = NoUse('a callback that returns at once', 'it waits, and keeps the executor busy meanwhile')
    try:
        action()
        trial.client(rover).set_parameter('last', 1)
    except NoAnswerError:
        running = trial.ros.running
        if running is not None and running.node is journal:
            raise waits from None
        raise
    try:
        trial.wait(lambda: _has_heard(journal, 'last', 1), 'the events reach the journal', lambda: 'they do not')
    except NotYet as error:
        raise NoUse(error.expected, trial.raised() or error.happened) from None
    with contextlib.suppress(WaitTimeoutError):
        wait_until(lambda: journal.raised or any(_is_last(page) for page in list(journal.pages)[before:]),
                   'the last page', _WRITING_SEC)
    if raised := trial.raised():
        raise NoUse('a callback that does not raise', raised)
    if journal.busy_sec >= _BUSY_SEC:
        raise waits
    return [page for page in list(journal.pages)[before:] if not _is_last(page)]


def _has_heard(journal: InTheCorner, name: str, value: object) -> bool:
    """Return whether each subscription has heard that a parameter changed to a value."""
    heard = [event for event in journal.events_heard for each in event.changed_parameters
             if each.name == name and values.same(values.to_python(each.value), value)]
    return len(heard) >= journal.subscription_count


def _is_last(page: Any) -> bool:
    return isinstance(page, (tuple, list)) and 'last' in page


def expect_pages(pages: Sequence[Any], wanted: Sequence[tuple[str, str, Any]], shown: Sequence[Any]) -> None:
    """Expect these pages in this order, each value of the right type, and no others.

    :param shown: All pages, for the words.
    """
    for page in wanted:
        alike = [each for each in pages if isinstance(each, tuple) and len(each) == 3 and each[:2] == page[:2]]
        expect(any(_same_value(each[2], page[2]) for each in alike),
               f'a page `{page!r}`', f'there is `{shorten(repr(alike[0]), 200)}`' if alike else _describe(shown))
    expect(len(pages) == len(wanted), f'{len(wanted)} pages', f'there are {len(pages)}: {_describe(shown)}')
    expect([page[:2] for page in pages] == [page[:2] for page in wanted],
           'the pages in the order of the events', _describe(shown))


def _same_value(found: Any, wanted: Any) -> bool:
    return values.same(values.normalize(found), wanted)


def _describe(pages: Sequence[Any]) -> str:
    return f'the pages are `{shorten(repr(pages), 200)}`'


def _about(name: str, pages: Sequence[Any]) -> list[Any]:
    """Return the pages about a parameter, whatever else is in them: what is wrong with that is said elsewhere."""
    return [page for page in pages if isinstance(page, (tuple, list)) and name in page]


@keep.require('every value is written down as it is', see=LISTENER)
def as_it_is(trial: Trial) -> None:
    rover, journal = begin(trial)
    new = {'speed': 7, 'offset': 0.0, 'label': '', 'gains': [0.5, 0.0], 'enabled': False}

    def set_all_and_declare() -> None:
        trial.client(rover).set_parameters_atomically(new)
        trial.ros.run(lambda: rover.declare_parameter('lamp', 0), 'declare a parameter')

    pages = pages_after(trial, rover, journal, set_all_and_declare)
    if not pages:
        raise NoUse('pages about `/rover`', 'there are none, although the journal has heard its events')
    of_lamp = _about('lamp', pages)
    expect_pages([page for page in pages if page not in of_lamp],
                 [('changed', name, value) for name, value in new.items()], pages)
    if of_lamp:
        expect_pages(of_lamp, [('new', 'lamp', 0)], pages)


@keep.require('new, changed and deleted parameters are told apart', see=WHAT_IS_PUBLISHED)
def kinds(trial: Trial) -> None:
    rover, journal = begin(trial)

    def come_and_go() -> None:
        lamp = ParameterDescriptor(dynamic_typing=True)
        trial.ros.run(lambda: rover.declare_parameter('lamp', 2, lamp), 'declare a parameter')
        for _ in range(2):  # an event that changes nothing is one, too
            trial.client(rover).set_parameter('lamp', 3)
        trial.client(rover).delete_parameter('lamp')
        trial.client(rover).set_parameter('target', 2.5)

    pages = pages_after(trial, rover, journal, come_and_go)
    wanted = [('new', 'lamp'), *2 * [('changed', 'lamp')], ('deleted', 'lamp'), ('new', 'target')]
    found = [tuple(page[:2]) for page in pages if isinstance(page, (tuple, list))]
    expect(found == wanted, f'pages that begin with `{wanted!r}`, for a lamp that is set to 3 twice', _describe(pages))
    expect(pages[3][2:] == (None,), "a page `('deleted', 'lamp', None)`", f'there is `{pages[3]!r}`')


@keep.require('no other node is in it', see=LISTENER)
def rover_only(trial: Trial) -> None:
    rover, journal = begin(trial)
    others = [trial.start(RoverArm), trial.start(Rover, namespace='/lab')]

    def all_three() -> None:
        for speed, other in enumerate(others, 3):
            trial.client(other).set_parameter('speed', speed)
        trial.client(rover).set_parameter('speed', 5)

    pages = _about('speed', pages_after(trial, rover, journal, all_three))
    expect(pages, "a page `('changed', 'speed', 5)`", 'there is none about `speed`')
    expect(len(pages) == 1, 'no page about `/rover_arm` or `/lab/rover`', _describe(pages))


@keep.require(f'a burst of {BURST_LENGTH} changes is complete', see=BURST)
def burst(trial: Trial) -> None:
    rover, journal = begin(trial)

    def hurry() -> None:
        for speed in range(1, BURST_LENGTH + 1):
            rover.set_parameters([Parameter('speed', value=speed)])

    def hurry_and_wait() -> None:
        trial.ros.run(hurry, 'set the speed in a burst')
        # The mark at the end is no part of the burst, and takes no place in the queue.
        trial.wait(lambda: _has_heard(journal, 'speed', BURST_LENGTH), 'the burst reaches the journal',
                   lambda: 'it does not')

    pages = _about('speed', pages_after(trial, rover, journal, hurry_and_wait))
    expect(len(pages) == BURST_LENGTH, f'{BURST_LENGTH} pages about `speed`', f'there are {len(pages)}')
    expect(len({repr(page) for page in pages}) == BURST_LENGTH, f'{BURST_LENGTH} different speeds',
           f'the pages begin with `{shorten(repr(pages[:3]), 200)}`')


count = Exercise('10.1b', 'How many messages?', CHAPTER, DICTIONARY, hints=(
    'An event reports what was stored in one go. `set_parameters` stores its parameters one by one.',
    'A rejected value is not stored. If one value in a request is rejected, what happens to the others?',
    'Most of the numbers are in the output of the section “What is published, and how often”.'))


def require_count(what: str, action: Callable[[Trial, Rover], object], because: Mapping[int, str]) -> None:
    """Add the requirement to know how many events an action on a rover causes."""
    @count.require_prediction(what, see=WHAT_IS_PUBLISHED, because=because)
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
              {1: 'It stores one after the other, and publishes each'})
require_count('set_parameters_atomically with three parameters',
              lambda trial, rover: trial.client(rover).set_parameters_atomically(THREE),
              {3: 'It stores them in one go, and publishes them in one go'})
require_count('set_parameters with two, of which one is rejected',
              lambda trial, rover: trial.client(rover).set_parameters(TWO),
              {0: 'The node decides about each by itself: it stores the other one',
               2: 'A rejected value is not published'})
require_count('set_parameters_atomically with two, of which one is rejected',
              lambda trial, rover: trial.client(rover).set_parameters_atomically(TWO),
              {1: 'All or nothing: the node stores no parameter of the request'})
require_count('the value that it has already', lambda trial, rover: trial.client(rover).set_parameter('speed', 1),
              {0: 'A node does not compare: it publishes what it stores'})
require_count('declare_parameters with two parameters',
              lambda trial, rover: trial.ros.run(
                  lambda: rover.declare_parameters('', [('x', 1), ('y', 2)]), 'declare two parameters'),
              {0: 'A declaration stores a value too', 1: 'It declares one after the other'})
require_count('undeclare_parameter',
              lambda trial, rover: trial.ros.run(lambda: rover.undeclare_parameter('label'), 'undeclare'),
              {1: 'The only deletion that is published is that of a dynamic parameter that is set to nothing'})


tells = Exercise('10.1a', 'Your tuner listens', CHAPTER, TUNER, node_name='tuner', hints=(
    "In the constructor: `self.create_subscription(ParameterEvent, '/parameter_events', self.on_event, "
    'qos_profile_parameter_events)`.',
    "`on_event(self, event)` begins with `if event.node == '/driver':`, and goes through `event.new_parameters` and "
    '`event.changed_parameters`.',
    'The value is `parameter_value_to_python(parameter.value)`. What is done about a speed that is too high stands '
    'in `on_speed` already: move it to a method of its own, and call that from both.'))


class Driver(Node):
    """A driver that is asked in vain: to each question it answers that it is slow. Its events tell the truth."""

    def __init__(self, name: str = 'driver') -> None:
        self.asked: list[Parameter] = []
        super().__init__(name)
        self.declare_parameters('', [('max_speed_mps', 0.2), ('stop_distance_m', 0.5), ('last', 0)])
        self.add_on_set_parameters_callback(self.judge)

    def get_parameter(self, name: str) -> Parameter:
        return Parameter(name, value=0.1) if name == 'max_speed_mps' else super().get_parameter(name)

    def held(self) -> Any:
        """Return the speed that is stored."""
        return super().get_parameter('max_speed_mps').value

    def judge(self, parameters: list[Parameter]) -> SetParametersResult:
        self.asked += [each for each in parameters if each.name == 'max_speed_mps']
        return SetParametersResult(successful=True)


class FastArm(Driver):
    """Another node, with a parameter of the same name."""

    def __init__(self) -> None:
        super().__init__('driver_arm')


def start_listening(trial: Trial, *words: str) -> tuple[Driver, Any]:
    """Put a driver and the learner's tuner on the stage, and wait until they know each other."""
    driver = trial.start(Driver)
    tuner: Any = trial.start(derive(InTheCorner, trial.work), ros_args=words)
    if not tuner.subscription_count:
        raise NoUse(f'the tuner subscribes to `{TOPIC}`', 'it does not')
    expect_heard(trial, driver, tuner, 1)
    return driver, tuner


def expect_heard(trial: Trial, driver: Driver, tuner: Any, mark: int) -> None:
    """Let a driver publish a mark, and expect the tuner to have heard it, and all before it."""
    trial.client(driver).set_parameter('last', mark)
    trial.wait(lambda: _has_heard(tuner, 'last', mark), 'the events reach the tuner', lambda: 'they do not')


def expect_limited(trial: Trial, driver: Driver, limit_mps: float, when: str) -> None:
    """Expect a tuner to set its limit."""
    trial.wait(lambda: driver.held() == limit_mps, f'the driver holds {limit_mps} {when}', lambda: (
        trial.raised() or f'it holds {driver.held()}'))


@tells.require('an event of `/driver` with a speed above the limit is enough: the tuner sets the limit', see=LISTENER)
def limits(trial: Trial) -> None:
    for words, limit_mps in (((), 0.3), (('-p', 'limit_mps:=0.25'), 0.25)):
        with cleared(trial.ros):
            driver, _ = start_listening(trial, *words)
            for speed_mps in (0.9, 1.5):
                trial.client(driver).set_parameter('max_speed_mps', speed_mps)
                expect_limited(trial, driver, limit_mps, f'soon after an event with {speed_mps}')


@tells.require('so is the event of a driver that starts', see=WHAT_IS_PUBLISHED)
def limits_start(trial: Trial) -> None:
    take_for_granted(trial, limits)
    driver, _ = start_listening(trial)
    trial.ros.run(lambda: (driver.undeclare_parameter('max_speed_mps'), driver.declare_parameter('max_speed_mps', 0.9)),
                  'declare the speed again')
    expect_limited(trial, driver, 0.3, 'soon after it has declared `max_speed_mps` with 0.9')


@tells.require('it leaves alone a slower driver, other parameters, and other nodes', see=LISTENER)
def leaves_alone(trial: Trial) -> None:
    take_for_granted(trial, limits)
    driver, tuner = start_listening(trial)
    arm = trial.start(FastArm)
    expect_heard(trial, arm, tuner, 2)
    trial.client(arm).set_parameter('max_speed_mps', 1.5)
    trial.client(driver).set_parameter('stop_distance_m', 2.0)
    ours = [0.3, 0.0]
    for speed_mps in ours:
        trial.client(driver).set_parameter('max_speed_mps', speed_mps)
    for mark in (3, 4):  # whatever the tuner asks for has come before the second one
        expect_heard(trial, driver, tuner, mark)
    extra = [each.value for each in driver.asked][:3]
    expect(len(driver.asked) == len(ours), 'the tuner asks the driver for nothing',
           f'after our {ours}, the driver has been asked for {extra}')


@tells.require('its queue is as long as that of the nodes', see=BURST)
def has_queue(trial: Trial) -> None:
    _, tuner = start_listening(trial)
    depths = [each.qos_profile.depth for each in tuner.subscriptions if each.topic_name == TOPIC]
    wanted = qos_profile_parameter_events.depth
    expect(min(depths) >= wanted, f'a depth of {wanted}, that of `qos_profile_parameter_events`',
           f'it is {min(depths)}')


EXERCISES = (tells, count, keep)
