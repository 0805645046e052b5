"""Exercises of chapter 4: the driver reads each time and stops before the wall; an array, and a slider of one's own."""

from typing import Any

import ipywidgets as widgets
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor
from rclpy.node import Node

from param_tools import values
from param_tools.node.client import ParameterClient
from param_tools.ros.waiting import wait
from param_tools.values import DOUBLE
from param_tutorial.exercises.exercise import FUNCTION, Exercise
from param_tutorial.exercises.expectations import (
    WithSecondJudge,
    derive,
    expect_declared,
    expect_range,
    expect_range_fields,
)
from param_tutorial.exercises.steps import (
    DRIVER,
    FAR,
    Bench,
    expect_commands,
    expect_speed,
    expect_start_speeds,
    start_on_bench,
)
from param_tutorial.exercises.trial import NotTried, NotYet, NoUse, Trial, cleared, expect, take_for_granted

CHAPTER = '04_retrieving'
NOTICE = 'When does a node notice?'
START = 'Which value does a node start with?'
LISTEN = 'Listen to the sensor'
ARRAYS = 'Arrays'
PANEL = 'A panel of your own'

reads = Exercise('4a', 'Read each time', CHAPTER, DRIVER, node_name='driver', hints=(
    'The constructor keeps a copy, and `drive` uses it. Which of the two methods runs again and again?',
    'Move `self.get_parameter(...).value` into `drive`, in the place of `self.speed_mps`. Nothing needs the line in '
    'the constructor any more.'))


@reads.require('it publishes a `Twist` on `cmd_vel`, again and again', see=NOTICE)
def publishes(trial: Trial) -> None:
    _, bench = start_on_bench(trial)
    expect_commands(trial, bench)


@reads.require('it commands the speed with which the node has started', see=START)
def commands_speed(trial: Trial) -> None:
    take_for_granted(trial, publishes)
    expect_start_speeds(trial)


@reads.require('when a client sets `max_speed_mps`, the commands follow', see=NOTICE)
def follows(trial: Trial) -> None:
    take_for_granted(trial, commands_speed)
    node, bench = start_on_bench(trial, *FAR)
    expect_follows(trial, node, bench, 1.0, 0.25, 0.75)
    expect_no_copy(trial, 0.6875)


def expect_no_copy(trial: Trial, start_mps: float) -> None:
    """Expect no attribute of the driver to keep the speed of its start, which no other attribute has."""
    node = trial.start(ros_args=[*FAR, '-p', f'max_speed_mps:={start_mps}'])
    trial.client(node).set_parameter('max_speed_mps', 1.0).raise_for_reason()
    copies = [f'`self.{name}`' for name, value in vars(node).items() if isinstance(value, float) and value == start_mps]
    expect(not copies, 'no copy is left', f'{" and ".join(copies)} still holds the speed of the start, {start_mps}')


def expect_follows(trial: Trial, node: Node, bench: Bench, *speeds_mps: float) -> None:
    """Expect the driver to command each speed once a client has set it."""
    client = trial.client(node)
    for speed_mps in speeds_mps:
        before = client.get_parameter('max_speed_mps')
        client.set_parameter('max_speed_mps', speed_mps).raise_for_reason()
        expect_speed(trial, bench, speed_mps, f'after a client has set `max_speed_mps = {speed_mps}`', {
            before: f'The node accepted {speed_mps}, and `drive` still uses a copy that was made before'})


@reads.require('a value that is rejected changes nothing', see=NOTICE)
def ignores_rejected(trial: Trial) -> None:
    take_for_granted(trial, commands_speed)
    bench = trial.start(Bench)
    node = trial.start(derive(WithSecondJudge, trial.work))
    node.rejects = True
    trial.client(node).set_parameter('max_speed_mps', 1.25)
    expect_speed(trial, bench, 0.5, 'after `max_speed_mps = 1.25` has been rejected', {
        1.25: 'That value was rejected in the end, and the parameter never held it'})


stops = Exercise('4b', 'Stop before the wall', CHAPTER, DRIVER, node_name='driver', hints=(
    'The constructor gets three more things: the declaration, `self.distance_m = None`, and a subscription that calls '
    'a method. That method has one line: it keeps the `range` of the message.',
    'A new `Twist` has a `linear.x` of 0.0 already. So `drive` needs one `if`, and sets `linear.x` only if the robot '
    'may drive.',
    'The condition has two halves, in this order: `self.distance_m is not None and self.distance_m > ...`. Python '
    'cannot compare `None` with a number, and it does not look at the second half if the first is false.'))


@stops.require('`stop_distance_m` is a double, 0.5 at the start, with a range from 0.1 to 5.0', see=LISTEN)
def declares_distance(trial: Trial) -> None:
    expect_declared(trial, 'stop_distance_m', DOUBLE, 0.5)
    # At this speed, the driver of chapter 5.2 takes any distance.
    node = trial.start(ros_args=['-p', 'max_speed_mps:=0.0'])
    expect_range_fields(node, 'stop_distance_m')
    expect_range(trial.client(node), 'stop_distance_m', 0.1, 5.0, 0.0)


@stops.require('as long as it knows no distance, it commands 0.0', see=LISTEN)
def waits_for_distance(trial: Trial) -> None:
    bench = trial.start(Bench)
    bench.measure(None)
    trial.start()
    expect_speed(trial, bench, 0.0, 'before the first message', {
        0.5: 'A node that does not know where the wall is stands still'})


@stops.require('it drives if the wall is farther away than `stop_distance_m`, and commands 0.0 if not', see=LISTEN)
def stops_at_wall(trial: Trial) -> None:
    node, bench = start_on_bench(trial)
    topics = {each.topic_name.rpartition('/')[2] for each in node.subscriptions} - {'parameter_events'}
    expect('distance' in topics, 'a subscription to `distance`', 'the node subscribes to ' + (
        ', '.join(f'`{each}`' for each in sorted(topics)) or 'nothing'))
    for distance_m, speed_mps, remark in (
            (3.0, 0.5, 'It stands still although the wall is far. Which way around does it compare?'),
            (0.4, 0.0, 'Does `drive` compare the distance with `stop_distance_m`?'),
            (0.51, 0.5, 'It has stopped once. The wall is farther away now, so it may drive again'),
            (0.5, 0.0, 'That is not greater than `stop_distance_m`')):
        bench.measure(distance_m)
        has_heard = wait(lambda: getattr(node, 'distance_m', 0.0) is not None, 1.0)
        expect_speed(trial, bench, speed_mps, f'at a distance of {distance_m} m', {
            0.5 - speed_mps: remark if has_heard else '`self.distance_m` is still `None`. Does the method that gets '
                                                      'the message set it, with `self.`?'})


@stops.require('both parameters count as soon as a client has set them', see=NOTICE)
def reads_both(trial: Trial) -> None:
    take_for_granted(trial, stops_at_wall)
    node, bench = start_on_bench(trial)
    bench.measure(1.0)
    expect_speed(trial, bench, 0.5, 'at a distance of 1.0 m')
    trial.client(node).set_parameter('stop_distance_m', 2.0).raise_for_reason()
    expect_speed(trial, bench, 0.0, 'at a distance of 1.0 m and with `stop_distance_m = 2.0`', {
        0.5: 'Does `drive` read `stop_distance_m` each time?'})
    trial.client(node).set_parameter('stop_distance_m', 0.75).raise_for_reason()
    expect_follows(trial, node, bench, 1.0, 0.25)


arrays = Exercise('4c', 'The next stop', CHAPTER, FUNCTION, hints=(
    'The function takes a stop off the list that the node holds. What would it have to do first?',
    '`list(...)` makes a list of whatever holds several values, and always a new one.'))


class Route(Node):
    """A node with stops on its way."""

    def __init__(self) -> None:
        super().__init__('courier')
        self.declare_parameter('stops', [1, 2, 3])


def expect_stops(trial: Trial, node: Node, *goal: int) -> None:
    """Expect the learner's function to return the first stop and the others.

    :raises NoUse: it does not return, or something else, as it would in the other requirements.
    """
    try:
        given = trial.call('`next_stop(node)`', trial.work, node)
    except NotYet as error:
        raise NoUse(error.expected, error.happened) from None
    if not isinstance(given, (tuple, list)) or len(given) != 2:
        raise NoUse('two values, a stop and a list', f'it returns `{given!r}`')
    first, others = given
    expect(values.same(goal[0], first), f'the first stop is `{goal[0]}`', f'it is `{first!r}`')
    expect(others == list(goal[1:]), f'the others are `{list(goal[1:])}`',
           f'they are `{others!r}`' + ('' if isinstance(others, list) else ', which equals no list'))


@arrays.require('it returns the first stop, and a list of the others', see=ARRAYS)
def returns_stops(trial: Trial) -> None:
    expect_stops(trial, trial.start(Route), 1, 2, 3)
    expect_stops(trial, trial.start(Route, ros_args=['-p', 'stops:=[5]']), 5)


@arrays.require('the node keeps all its stops', see=ARRAYS)
def leaves_stops(trial: Trial) -> None:
    take_for_granted(trial, returns_stops)
    node = trial.start(Route)
    expect_stops(trial, node, 1, 2, 3)
    now = trial.client(node).get_parameter('stops')
    expect(now == [1, 2, 3], 'a client gets `[1, 2, 3]`',
           f'it gets `{now!r}`. Your function has changed the list that the node itself holds')


@arrays.require('it does the same after a client has set the stops', see=ARRAYS)
def returns_stops_set(trial: Trial) -> None:
    node = trial.start(Route)
    for stops in ([3, 4], [7, 8, 9]):
        client = trial.client(node)
        client.set_parameter('stops', stops).raise_for_reason()
        expect_stops(trial, node, *stops)
        now = client.get_parameter('stops')
        expect(now == stops, f'a client gets `{stops!r}`, as it has set them',
               f'it gets `{now!r}`. Your function has changed what the node itself holds')


slides = Exercise('4d', 'A slider that shows what the node holds', CHAPTER, FUNCTION, hints=(
    'It is the slider of the section, in a function: make a `FloatSlider`, define `ask(change)`, call `observe`, and '
    'return the slider. `ask` needs one line more.',
    'The client asks the node with `client.get_parameter(name)`: once for the `value` that the slider starts with, and '
    'again at the end of each `ask`.',
    'The last line of `ask` is `slider.value = client.get_parameter(...)`. It moves the slider, so `ask` is called '
    'once more, with a value that the node holds already.'))


class Cruiser(WithSecondJudge):
    """What the slider is for: a node with the speed of the reader's driver, which a test can let reject more."""

    def __init__(self) -> None:
        super().__init__('driver')
        self.declare_parameter('max_speed_mps', 0.5, ParameterDescriptor(
            floating_point_range=[FloatingPointRange(from_value=0.0, to_value=2.0)]))


def make_slider(trial: Trial, speed_mps: float = 0.5) -> tuple[Cruiser, ParameterClient, Any]:
    """Start a node that holds a speed, and have the learner's function make a slider for it.

    :raises NoUse: it makes none, as it would in the other requirements.
    """
    node = trial.start(Cruiser, ros_args=['-p', f'max_speed_mps:={speed_mps}'])
    try:
        slider = trial.call('`speed_slider(node)`', trial.work, node)
    except NotYet as error:
        raise NoUse(error.expected, error.happened) from None
    if not isinstance(slider, widgets.FloatSlider):
        raise NoUse('a `FloatSlider`', 'it returns ' + (
            f'a `{type(slider).__name__}`' if isinstance(slider, widgets.Widget) else f'`{slider!r:.60}`'))
    return node, trial.client(node), slider


def move(trial: Trial, slider: widgets.FloatSlider, speed_mps: float) -> None:
    """Move a slider, in the way in which a browser tells that a hand did."""
    try:
        trial.call(f'moving the slider to {speed_mps}', slider.set_state, {'value': speed_mps})
    except NotYet as error:
        remark = '. A slider that is moved by `ask` calls `ask` again' if 'RecursionError' in error.happened else ''
        raise NotYet(error.expected, error.happened + remark) from None


@slides.require('it goes from 0.0 to 3.0, and begins with what the node holds', see=PANEL)
def begins(trial: Trial) -> None:
    for speed_mps in (0.5, 1.25):
        with cleared(trial.ros):
            _, _, slider = make_slider(trial, speed_mps)
            expect((slider.min, slider.max) == (0.0, 3.0), 'a slider from 0.0 to 3.0',
                   f'it goes from {slider.min} to {slider.max}')
            expect(slider.value == speed_mps, f'it shows {speed_mps}, if the node holds that',
                   f'it shows {slider.value}')


@slides.require('when it is moved, the node gets the new value', see=PANEL)
def sets(trial: Trial) -> None:
    _, client, slider = make_slider(trial)
    for speed_mps in (1.2, 0.3, 2.0):
        move(trial, slider, speed_mps)
        held = client.get_parameter('max_speed_mps')
        expect(held == speed_mps, f'the node holds {speed_mps} when the slider has been moved there',
               f'it holds {held}. Does `observe` have a function that sets the parameter of `node`?')
        expect(slider.value == speed_mps, f'the slider stays at {speed_mps}, which the node has accepted',
               f'it shows {slider.value}')


@slides.require('when the node rejects the value, the slider shows what the node holds', see=PANEL)
def shows_held(trial: Trial) -> None:
    take_for_granted(trial, sets)
    node, client, slider = make_slider(trial)
    if slider.max < 3.0:
        raise NotTried
    move(trial, slider, 1.2)
    move(trial, slider, 3.0)
    expect(slider.value == 1.2, 'it shows 1.2 again after the node has rejected 3.0', f'it shows {slider.value}')
    client.set_parameter('max_speed_mps', 0.8).raise_for_reason()
    move(trial, slider, 3.0)
    expect(slider.value == 0.8, 'it shows 0.8 if another client has set that, and the node then rejects 3.0',
           f'it shows {slider.value}. What does the node say if you ask it?')
    node.rejects = True
    move(trial, slider, 1.5)
    expect(slider.value == 0.8, 'it shows 0.8 again if a callback of the node rejects 1.5', f'it shows {slider.value}')


EXERCISES = (reads, stops, arrays, slides)
