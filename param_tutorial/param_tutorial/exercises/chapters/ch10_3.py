"""Exercises of chapter 10.3: order a change of gains, tune a PID controller, and write the parameter file of two
controllers."""

import tempfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from rcl_interfaces.msg import SetParametersResult
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tutorial.errors import InvalidValueError, ParameterFileError
from param_tutorial.exercises.exercise import DICTIONARY, TEXT, Exercise
from param_tutorial.exercises.expectations import client_in_corner, run_lines
from param_tutorial.exercises.trial import CORNER, NotYet, Trial, expect
from param_tutorial.nodes.pid_controller_node import Figures, PidControllerNode
from param_tutorial.parameters import files, values

CHAPTER = '10_3_ros2_control'
INTEGRAL = 'Change it: an integral'
DERIVATIVE = 'Change it: a derivative'
FILE = 'The file of ros2_control'
WHERE = 'Which controllers does a section reach?'
TOGETHER = 'Change it: three gains, one change'

tune = Exercise('10.3a', 'Tune a wheel', CHAPTER, DICTIONARY, hints=(
    'Begin with P alone, and raise it until the wheel is fast. It will ring; that is what D is for.',
    'With `d` at 0.03 you can raise `p` far beyond 0.4, and the wheel rings less than before.',
    'The integral has little left to do when `p` is large. A small one, below 0.5, removes the error and hardly '
    'overshoots.'))

TUNED = [f'gains.wheel_joint.{name}' for name in 'pid']


def tuned(trial: Trial) -> Figures:
    """Set the learner's gains on a fresh controller, all together, and return the figures of its wheel."""
    others = sorted(set(map(str, trial.work)) - set(TUNED))
    expect(not others, 'the three gains, and nothing else', f'there is also `{"`, `".join(others)}`')
    for name in TUNED:
        expect(name in trial.work, f'a value for `{name}`', 'there is none')
    controller = trial.start(PidControllerNode)
    try:
        results = trial.client(controller).set_parameters_atomically(trial.work)
    except InvalidValueError as error:
        raise NotYet('three gains that the controller takes together', str(error)) from None
    expect(results.successful, 'three gains that the controller takes together', f'it says: {results[0].reason}')
    return controller.response().figures


def expect_steady(figures: Figures) -> None:
    """Expect the wheel to come to a steady speed, without which nothing else can be said."""
    expect(figures.settling_sec is not None, 'a wheel that settles', f'{figures}')


@tune.require('the speed at the end is within 0.1 rad/s of the reference', see=INTEGRAL)
def exact(trial: Trial) -> None:
    figures = tuned(trial)
    expect_steady(figures)
    expect(abs(figures.steady_state_error) < 0.1, 'a steady-state error below 0.1 rad/s',
           f'{figures}. P alone always leaves one')


@tune.require('it overshoots by less than 5 %', see=DERIVATIVE)
def calm(trial: Trial) -> None:
    figures = tuned(trial)
    expect_steady(figures)
    exact(trial)
    expect(figures.overshoot_percent is not None and figures.overshoot_percent < 5,
           'an overshoot below 5 %', f'{figures}')


@tune.require('it has settled after less than 0.4 s', see=DERIVATIVE)
def fast(trial: Trial) -> None:
    figures = tuned(trial)
    expect_steady(figures)
    exact(trial)
    expect(figures.settling_sec is not None and figures.settling_sec < 0.4, 'a settling time below 0.4 s', f'{figures}')


write = Exercise('10.3b', 'Write the file of two controllers', CHAPTER, TEXT, hints=(
    'Three blocks: one for the manager, one for each controller. Each begins with the name of a node and '
    '`ros__parameters:` below it.',
    'The manager holds `update_rate` and, for each controller, a name with a `type` below it. Look at the file of the '
    'Clawbot in the section “The file of ros2_control”.',
    'A name without a slash is for the root namespace alone. `/**/left_controller:` is for any.'))

MANAGER = 'controller_manager'
LEFT, RIGHT = 'left_controller', 'right_controller'
KIND = 'pid_controller/PidController'


class ControllerManager(Node):
    """Declares what its file holds, as ros2_control's controller manager does."""

    def __init__(self) -> None:
        super().__init__(MANAGER, allow_undeclared_parameters=True,
                         automatically_declare_parameters_from_overrides=True)


@contextmanager
def started(trial: Trial, node_class: type[Node], name: str) -> Iterator[tuple[Node, Mapping[str, Any]]]:
    """Start a node under a name with the learner's file, and yield it with the parameters that it has."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / 'controllers.yaml'
        path.write_text(trial.work, encoding='utf-8')
        try:
            held = files.read(path, f'{CORNER}/{name}')
        except ParameterFileError as error:
            words = str(error).replace(str(path), 'the file').replace(CORNER, '/robot')
            raise NotYet(f'the file reaches `/robot/{name}`', words) from None
        node = trial.start(node_class, ros_args=['-r', f'__node:={name}', '--params-file', str(path)])
        parameters = trial.client(node).get_parameters()
        unknown = sorted(held.keys() - parameters.keys())
        expect(not unknown, f'only names that `{name}` knows', f'it has no parameter `{"`, `".join(unknown)}`, and '
                                                               f'nobody takes it')
        yield node, parameters


def expect_value(parameters: Mapping[str, Any], name: str, value: Any) -> None:
    """Expect a parameter to hold a value of the same type."""
    expect(name in parameters, f'`{name}` is `{value!r}`', 'there is none of that name')
    expect(values.same(parameters[name], value), f'`{name}` is `{value!r}`', f'it is `{parameters[name]!r}`')


@write.require('the manager runs at 50 Hz', see=FILE)
def rate(trial: Trial) -> None:
    with started(trial, ControllerManager, MANAGER) as (_, parameters):
        expect_value(parameters, 'update_rate', 50)


@write.require('it knows both controllers, each of the type `pid_controller/PidController`', see=FILE)
def types(trial: Trial) -> None:
    with started(trial, ControllerManager, MANAGER) as (_, parameters):
        for name in (LEFT, RIGHT):
            expect_value(parameters, f'{name}.type', KIND)


def require_controller(name: str, joint: str, p: float) -> None:
    """Add the requirement that a controller starts with its joint and its gains."""
    @write.require(f'`{name}` starts with `{joint}` and its gains, in any namespace', see=WHERE)
    def starts(trial: Trial) -> None:
        with started(trial, PidControllerNode, name) as (_, parameters):
            expect_value(parameters, 'dof_names', [joint])
            for gain, value in (('p', p), ('i', 0.4), ('u_clamp_max', 1.0), ('u_clamp_min', -1.0)):
                expect_value(parameters, f'gains.{joint}.{gain}', value)


require_controller(LEFT, 'left_joint', 0.2)
require_controller(RIGHT, 'right_joint', 0.25)


order = Exercise('10.3c', 'Put a change in order', CHAPTER, TEXT, hints=(
    'A name has to be there before a line can use it. Which two lines use no name of another line?',
    'The dictionary needs `group`, and the last line needs the client and the dictionary.'))


class Noting(PidControllerNode):
    """A controller that notes the names of each request."""

    def __init__(self) -> None:
        super().__init__()
        self.requests: list[set[str]] = []
        self.add_on_set_parameters_callback(self.note)

    def note(self, parameters: list[Parameter]) -> SetParametersResult:
        self.requests.append({each.name for each in parameters})
        return SetParametersResult(successful=True)


def ordered(trial: Trial) -> Noting:
    """Run the learner's lines beside a controller."""
    controller = trial.start(Noting, ros_args=['-r', '__node:=wheel_controller'])
    run_lines(trial, ParameterClient=client_in_corner)
    return controller


def require_gain(letter: str, value: float) -> None:
    """Add the requirement that the controller holds a gain."""
    @order.require(f'the controller holds a gain `{letter}` of {value}', see=TOGETHER)
    def holds(trial: Trial) -> None:
        found = ordered(trial).get_parameter(f'gains.wheel_joint.{letter}').value
        expect(found == value, f'`{value}`', f'it is `{found!r}`')


require_gain('p', 0.3)
require_gain('d', 0.02)


@order.require('both came in one request', see=TOGETHER)
def together(trial: Trial) -> None:
    requests = ordered(trial).requests
    wanted = {'gains.wheel_joint.p', 'gains.wheel_joint.d'}
    expect(any(wanted <= each for each in requests), 'one request with both gains',
           'there is no such request')


EXERCISES = (order, tune, write)
