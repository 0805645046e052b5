"""Exercises of chapter 5.4: let a callback wait without hanging, and say which callbacks hang."""

from collections.abc import Callable
from typing import Any

from rcl_interfaces.msg import SetParametersResult
from rcl_interfaces.srv import GetParameters
from rclpy.callback_groups import CallbackGroup, MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools.node.client import ParameterValues
from param_tools.ros.waiting import wait
from param_tutorial.exercises.exercise import DICTIONARY, NODE_CLASS, Exercise
from param_tutorial.exercises.expectations import awake, expect_no_wait, start_asking
from param_tutorial.exercises.trial import NotYet, NoUse, Trial, expect

CHAPTER = '05_4_waiting'
AWAIT = 'Await the answer'
GROUPS = 'Break it: without the group'
SECOND = 'Build it: a second callback group'
BLOCK = 'A callback that has to block'


class Driver(Node):
    """The driver to slow down. It notes which parameters it is asked for, and whether it stores any."""

    rejected: tuple[str, ...] = ()
    """The parameters of which it accepts no value."""
    words = ''
    """Why not."""

    def __init__(self) -> None:
        super().__init__('driver')
        self.declare_parameters('', [('max_speed_mps', 0.5), ('stop_distance_m', 0.5)])
        self.asked: set[str] = set()
        self.has_stored = False
        self.add_on_set_parameters_callback(self.judge)
        self.add_post_set_parameters_callback(self.note)

    def judge(self, parameters: list[Parameter]) -> SetParametersResult:
        names = {each.name for each in parameters}
        self.asked |= names
        is_rejected = not names.isdisjoint(self.rejected)
        return SetParametersResult(successful=not is_rejected, reason=self.words if is_rejected else '')

    def note(self, _: list[Parameter]) -> None:
        self.has_stored = True


class KeepsDistance(Driver):
    """Accepts a new speed only."""

    rejected, words = ('stop_distance_m',), 'not while I am climbing'


class KeepsSpeed(Driver):
    """Accepts a new distance only."""

    rejected, words = ('max_speed_mps',), 'the floor is wet'


OLD = ParameterValues(max_speed_mps=0.5, stop_distance_m=0.5)
NEW = ParameterValues(max_speed_mps=0.3, stop_distance_m=1.0)

supervise = Exercise('5.4a', 'A button that does not hang', CHAPTER, NODE_CLASS, node_name='supervisor', hints=(
    '`call` keeps the thread until the answer has come, and nobody else could bring it. `call_async` returns a future.',
    '`async def slow_down(self):`, and in it `answer = await self.client.call_async(request)`. What is awaited is the '
    'whole answer; its `result` is the one result of an atomic request.',
    'While `slow_down` is paused, its callback group counts as busy. So the client gets another one: '
    '`callback_group=MutuallyExclusiveCallbackGroup()` in `create_client`.'))


def slow_down(trial: Trial, driver_class: type[Driver]) -> tuple[Driver, Any]:
    """Put a driver and the learner's supervisor on the stage, and press the supervisor's button.

    :raises NoUse: it asks before that, or the button cannot be pressed, or does not get to its end.
    """
    driver = trial.start(driver_class)
    supervisor = start_asking(trial)
    if supervisor.questions_noted:
        raise NoUse('no request before `slow_down()` is called', 'the constructor has sent one')
    button = getattr(supervisor, 'slow_down', None)
    if not callable(button):
        raise NoUse('a method `slow_down`', 'the class has none')
    with awake():
        trial.press('`slow_down()`', supervisor, button)
    return driver, supervisor


@supervise.require('`slow_down()` sends both values, and neither blocks nor hangs', see=AWAIT)
def both(trial: Trial) -> None:
    driver, supervisor = slow_down(trial, Driver)
    client = trial.client(driver)
    try:
        trial.wait(lambda: client.get_parameters(NEW) == NEW, 'the driver holds 0.3 m/s and 1.0 m',
                   lambda: f'it holds {" and ".join(map(str, client.get_parameters(NEW).values()))}' + (
                       f', and `self.rejection` is `{supervisor.rejection!r}`' if supervisor.rejection else ''))
    except NotYet as error:  # what drivers reject can tell nothing about other values
        raise NoUse(error.expected, trial.raised() or error.happened) from None
    others = ' and '.join(f'`{name}`' for name in sorted(driver.asked - set(NEW)))
    expect(not others, 'the driver is asked for nothing else', f'it is asked for {others} too')
    expect_no_wait(trial, 'slow_down')


@supervise.require('`self.rejection` is the reason of a driver that rejects', see=AWAIT)
def reason(trial: Trial) -> None:
    for driver_class in (KeepsDistance, KeepsSpeed, Driver):
        expect_reason(trial, driver_class)


def expect_reason(trial: Trial, driver_class: type[Driver]) -> None:
    """Expect the supervisor to know why a driver rejects, and nothing if it doesn't."""
    driver, supervisor = slow_down(trial, driver_class)
    trial.wait(lambda: driver.asked, 'the driver is asked', lambda: 'it is not')
    for _ in range(3):
        trial.ros.run(lambda: None, 'let the answer through')
    if driver.rejected:
        trial.wait(lambda: supervisor.rejection == driver.words, f'`self.rejection` is `{driver.words!r}`',
                   lambda: f'it is `{supervisor.rejection!r}`')
    else:
        expect(not supervisor.rejection, '`self.rejection` stays empty when the driver accepts',
               f'it is `{supervisor.rejection!r}`')
    trial.ros.remove(supervisor)
    trial.ros.remove(driver)


@supervise.require('both are set or neither: a driver that rejects one keeps the other', see=AWAIT)
def neither(trial: Trial) -> None:
    for driver_class, kept in ((KeepsDistance, 'max_speed_mps'), (KeepsSpeed, 'stop_distance_m')):
        expect_kept(trial, driver_class, kept)


def expect_kept(trial: Trial, driver_class: type[Driver], name: str) -> None:
    """Expect a parameter to stay as it is in a driver that rejects the other one."""
    driver, supervisor = slow_down(trial, driver_class)
    trial.wait(lambda: driver.asked >= set(NEW), 'the driver is asked for both values',
               lambda: f'it was asked for {" and ".join(f"`{each}`" for each in sorted(driver.asked)) or "nothing"}')
    trial.ros.run(lambda: None, 'let the driver finish')
    expect(not driver.has_stored, f'a driver that rejects the other value keeps `{name} = {OLD[name]}`',
           'it stored the new one. `set_parameters` decides about each parameter separately')
    trial.ros.remove(supervisor)
    trial.ros.remove(driver)


judge = Exercise('5.4b', 'Answered or not?', CHAPTER, DICTIONARY, hints=(
    'Ask two questions each time. Who could take the answer from the network: is there a thread that is free? And may '
    'that thread start the callback of the client: is its group free?',
    'Under `rclpy.spin` there is one thread. A callback that blocks keeps it, whatever the groups are.',
    'A callback that is paused at `await` gives the thread back and keeps its group busy, unless the group is a '
    'reentrant one.'))
OUTCOMES = ('answered', 'hangs')


class Waiter(Node):
    """Asks the driver from a timer's callback, waits for the answer, and keeps it."""

    def __init__(self, blocks: bool, timer: CallbackGroup | None, client: CallbackGroup | None) -> None:
        super().__init__('waiter')
        self.answer: object = None
        self.client = self.create_client(GetParameters, 'driver/get_parameters', callback_group=client)
        self.timer = self.create_timer(0.01, self.block if blocks else self.pause, callback_group=timer)

    def block(self) -> None:
        if self.client.service_is_ready():
            self.timer.cancel()
            self.answer = self.client.call(GetParameters.Request(names=['max_speed_mps']), timeout_sec=0.5)

    async def pause(self) -> None:
        if self.client.service_is_ready():
            self.timer.cancel()
            self.answer = await self.client.call_async(GetParameters.Request(names=['max_speed_mps']))


def expect_outcome(question: str, see: str, blocks: bool,
                   groups: Callable[[], tuple[CallbackGroup | None, CallbackGroup | None]]) -> None:
    """Add a requirement: what becomes of a callback that waits, with two callback groups."""
    @judge.require_prediction(question, see=see, because={}, words=OUTCOMES)
    def find_out(trial: Trial) -> str:
        trial.start(Driver)

        class InGroups(Waiter):
            def __init__(self) -> None:
                super().__init__(blocks, *groups())

        waiter = trial.start(InGroups)
        return 'answered' if wait(lambda: waiter.answer, 2.0) else 'hangs'


def both_in(group: CallbackGroup) -> tuple[CallbackGroup, CallbackGroup]:
    """Return one group for timer and client."""
    return group, group


expect_outcome('call, both in the default group', AWAIT, True, lambda: (None, None))
expect_outcome('call, the timer in its own group', BLOCK, True, lambda: (MutuallyExclusiveCallbackGroup(), None))
expect_outcome('await, both in the default group', GROUPS, False, lambda: (None, None))
expect_outcome('await, the timer in its own group', SECOND, False, lambda: (MutuallyExclusiveCallbackGroup(), None))
expect_outcome('await, the client in its own group', SECOND, False, lambda: (None, MutuallyExclusiveCallbackGroup()))
expect_outcome('await, both in one more group', GROUPS, False, lambda: both_in(MutuallyExclusiveCallbackGroup()))
expect_outcome('await, both in one reentrant group', SECOND, False, lambda: both_in(ReentrantCallbackGroup()))


EXERCISES = (supervise, judge)
