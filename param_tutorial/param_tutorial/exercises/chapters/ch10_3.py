"""Exercises of chapter 10.3: tune a PID controller, change two gains at once, and write the parameter file of two
controllers."""

import contextlib
import tempfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from rcl_interfaces.msg import ParameterDescriptor, SetParametersResult
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools import values
from param_tools.errors import InvalidValueError, ParameterFileError
from param_tools.files import parameter_files
from param_tutorial.exercises.exercise import DICTIONARY, TEXT, Exercise
from param_tutorial.exercises.expectations import ClientInCorner, expect_no_gap, run_lines
from param_tutorial.exercises.trial import CORNER, NoStart, NotYet, NoUse, Trial, expect
from param_tutorial.nodes.pid_controller_node import Figures, PidControllerNode, StepResponse
from param_tutorial.views.drawing.step_response import plot_responses
from param_tutorial.views.step_response import goal_band

CHAPTER = '10_3_ros2_control'
GAINS = 'What each gain does'
FILE = 'The file of ros2_control'
TOGETHER = 'Three gains, one change'

TUNED = [f'gains.wheel_joint.{name}' for name in 'pid']
tune = Exercise('10.3a', 'Tune a wheel', CHAPTER, DICTIONARY, hints=(
    'Begin with P alone, and raise it until the wheel is fast. It will ring; that is what D is for.',
    'With `d` at 0.03 you can raise `p` far beyond 0.4, and the wheel rings less than before.',
    'The integral has little left to do when `p` is large. A small one, below 0.5, removes the error and hardly '
    'overshoots.'))


def show_response(trial: Trial, controller: PidControllerNode) -> StepResponse:
    """Show how the wheel gets up to speed with the gains that a controller has, and return that."""
    response = controller.response()
    trial.picture = plot_responses({'your gains': response}, band=goal_band(response.reference))._repr_html_()
    return response


def tuned(trial: Trial) -> Figures:
    """Set the learner's gains on a fresh controller, all together, and return the figures of its wheel.

    :raises NoUse: the controller rejects them, or the wheel comes to no steady speed, without which nothing can be
        said of it.
    """
    for name in TUNED:
        if name not in trial.work:
            raise NoUse(f'a value for `{name}`', 'there is none')
    others = sorted(set(map(str, trial.work)) - set(TUNED))
    if others:
        raise NoUse('the three gains, and nothing else', f'there is also `{"`, `".join(others)}`')
    expect_no_gap(names=[f'`{name}`' for name in TUNED if trial.work[name] is ...])
    controller = trial.start(PidControllerNode)
    try:
        results = trial.client(controller).set_parameters_atomically(trial.work)
    except InvalidValueError as error:
        raise NoUse('three gains that the controller accepts', str(error)) from None
    if not results.successful:
        raise NoUse('three gains that the controller accepts', f'it says: {results[0].reason}')
    figures = show_response(trial, controller).figures
    if figures.settling_sec is None:
        raise NoUse('a wheel that settles', f'{figures}')
    return figures


@tune.require('the speed at the end is within 0.1 rad/s of the reference', see=GAINS)
def exact(trial: Trial) -> None:
    figures = tuned(trial)
    alone = '' if trial.work[TUNED[1]] else '. Without an integral, some error always remains'
    expect(abs(figures.steady_state_error) <= 0.1, 'a steady-state error of at most 0.1 rad/s', f'{figures}{alone}')


@tune.require('it overshoots by less than 5 %', see=GAINS)
def calm(trial: Trial) -> None:
    figures = tuned(trial)
    expect(figures.overshoot_percent is not None and figures.overshoot_percent < 5,
           'an overshoot below 5 %', f'{figures}')


@tune.require('it settles in less than 0.4 s', see=GAINS)
def fast(trial: Trial) -> None:
    figures = tuned(trial)
    expect(figures.settling_sec is not None and figures.settling_sec < 0.4, 'a settling time below 0.4 s', f'{figures}')


write = Exercise('10.3c', 'Write the file of two controllers', CHAPTER, TEXT, hints=(
    'Three blocks: one for the manager, one for each controller. Each begins with the name of a node and '
    '`ros__parameters:` below it.',
    'The manager holds `update_rate` and, for each controller, a name with a `type` below it. Look at the file of the '
    'Clawbot in the section “The file of ros2_control”.',
    'A name without a slash means the root namespace alone. `/**/left_controller:` means any namespace.'))

MANAGER = 'controller_manager'
JOINTS = {'left_controller': 'left_joint', 'right_controller': 'right_joint'}
KIND = 'pid_controller/PidController'
# The empty one, and two that no file names.
NAMESPACES = ('', '/robot', '/lab/robot')
# What pid_controller of ros2_controllers 4.42.1 declares for the controller, and again for each joint: the names of its
# schema and their defaults, the names that every controller has, and `saturation` of control_toolbox 4.11.0. An array
# has no default, so that it has a type.
OF_THE_CONTROLLER: Mapping[str, Any] = {
    'type': '', 'update_rate': 100, 'is_async': False, 'thread_priority': 50,
    'dof_names': Parameter.Type.STRING_ARRAY, 'reference_and_state_dof_names': Parameter.Type.STRING_ARRAY,
    'command_interface': '', 'reference_and_state_interfaces': Parameter.Type.STRING_ARRAY,
    'set_current_state_as_first_setpoint': True, 'use_external_measured_states': False, 'enable_feedforward': False}
OF_A_JOINT: Mapping[str, Any] = {
    'p': 0.0, 'i': 0.0, 'd': 0.0, 'u_clamp_max': float('inf'), 'u_clamp_min': float('-inf'),
    'antiwindup': False, 'i_clamp_max': float('inf'), 'i_clamp_min': float('-inf'), 'antiwindup_strategy': 'legacy',
    'tracking_time_constant': 0.0, 'error_deadband': 1e-16, 'saturation': False, 'feedforward_gain': 0.0,
    'angle_wraparound': False, 'save_i_term': True, 'activate_state_publisher': False}
# Blocks of names that the controllers of ros2_control read as they find them.
OPEN_BLOCKS = ('async_parameters.', 'remap.')
# Without these the real controller does not load.
REQUIRED = ('dof_names', 'command_interface', 'reference_and_state_interfaces')


class RealController(Node):
    """Declares what pid_controller of Jazzy declares."""

    def __init__(self) -> None:
        super().__init__('real_controller')
        for name, default in OF_THE_CONTROLLER.items():
            self.declare_parameter(name, default)
        for joint in self.get_parameter_or('dof_names').value or []:
            for name, default in OF_A_JOINT.items():
                self.declare_parameter(f'gains.{joint}.{name}', default)


class RealManager(Node):
    """Declares what its file holds, as ros2_control's controller manager does, and the rate of its loop."""

    def __init__(self) -> None:
        super().__init__(MANAGER, automatically_declare_parameters_from_overrides=True)
        if not self.has_parameter('update_rate'):
            self.declare_parameter('update_rate', 100, ParameterDescriptor(read_only=True))


def held_for(trial: Trial, name: str, namespace: str) -> Mapping[str, Any]:
    """Return what the learner's file holds for a node, as rcl reads it; nothing if it does not reach the node.

    :raises NoUse: rcl cannot read the file.
    """
    with _file(trial.work) as path:
        try:
            return parameter_files.read(path, f'{namespace}/{name}')
        except ParameterFileError as error:
            words = str(error).replace(str(path), 'the file')
            if 'holds nothing for' in words:
                return {}
            raise NoUse('a file that rcl can read', words) from None


def held(trial: Trial, name: str) -> Mapping[str, Any]:
    """Return what the file holds for a node in the first namespace in which it reaches it."""
    return next(filter(None, (held_for(trial, name, namespace) for namespace in NAMESPACES)), {})


@contextlib.contextmanager
def _file(text: str) -> Iterator[Path]:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / 'controllers.yaml'
        path.write_text(text, encoding='utf-8')
        yield path


def start(trial: Trial, node_class: type[Node], name: str) -> Mapping[str, Any]:
    """Start a node under a name with what the file holds for it, and return the parameters that it has then."""
    parameters = held(trial, name)
    expect(parameters, f'a block for `{name}`', 'there is none')
    with _file(str(parameter_files.render(f'{CORNER}/{name}', parameters))) as path:
        try:
            node = trial.start(node_class, ros_args=['-r', f'__node:={name}', '--params-file', str(path)])
        except NoStart as error:
            raise NotYet(f'`{name}` starts', str(error.__context__)) from None
    return trial.client(node).get_parameters()


def expect_values(trial: Trial, name: str, parameters: Mapping[str, Any], wanted: Mapping[str, Any]) -> None:
    """Expect parameters to hold values of the same types. If not, a name that nobody declares may be the reason."""
    written = held(trial, name)
    for each, value in wanted.items():
        if each in parameters and values.same(parameters[each], value):
            continue
        happened = f'it is `{parameters[each]!r}`' if each in written else 'the file does not set it'
        if each not in written and each in REQUIRED:
            happened += ', and without it the controller does not load'
        unknown = sorted(other for other in written if other not in parameters and not other.startswith(OPEN_BLOCKS))
        if unknown:
            happened += f'. It sets `{"`, `".join(unknown)}`, which the node does not declare'
        raise NotYet(f'`{each}` is `{value!r}`', happened)


@write.require('the manager runs at 50 Hz', see=FILE)
def rate(trial: Trial) -> None:
    if not any(held(trial, name) for name in (MANAGER, *JOINTS)):
        raise NoUse(f'blocks for `{MANAGER}`, `{"` and `".join(JOINTS)}`', 'there are none')
    expect_values(trial, MANAGER, start(trial, RealManager, MANAGER), {'update_rate': 50})


@write.require('it knows both controllers, each of the type `pid_controller/PidController`', see=FILE)
def types(trial: Trial) -> None:
    for name in JOINTS:
        # The spawner sets the manager's parameter to the `type` in the controller's own block.
        found = held(trial, name).get('type', held(trial, MANAGER).get(f'{name}.type'))
        expect(found is not None, f'a `type` for `{name}`', 'there is none')
        expect(values.same(found, KIND), f'the type of `{name}` is `{KIND!r}`', f'it is `{found!r}`')


def require_controller(name: str, joint: str, p: float) -> None:
    """Add the requirement that a controller starts with its joint and its gains."""
    wanted: dict[str, Any] = {
        'dof_names': [joint], 'command_interface': 'effort', 'reference_and_state_interfaces': ['velocity']}
    gains: dict[str, Any] = {
        'p': p, 'i': 0.4, 'u_clamp_max': 1.0, 'u_clamp_min': -1.0, 'antiwindup_strategy': 'conditional_integration'}
    wanted |= {f'gains.{joint}.{gain}': value for gain, value in gains.items()}

    @write.require(f'`{name}` starts with `{joint}` and its gains', see=FILE)
    def starts(trial: Trial) -> None:
        expect_values(trial, name, start(trial, RealController, name), wanted)


require_controller('left_controller', JOINTS['left_controller'], 0.2)
require_controller('right_controller', JOINTS['right_controller'], 0.25)


@write.require('each block reaches its node in any namespace', see=FILE)
def anywhere(trial: Trial) -> None:
    for name in (MANAGER, *JOINTS):
        known = held(trial, name)
        expect(known, f'a block for `{name}`', 'there is none')
        for namespace in NAMESPACES:
            found = held_for(trial, name, namespace)
            expect(found.keys() == known.keys() and all(values.same(found[each], known[each]) for each in known),
                   f'the same parameters for `{namespace}/{name}`',
                   'it gets others' if found else 'the file does not reach it')


change = Exercise('10.3b', 'Change two gains at once', CHAPTER, TEXT, hints=(
    'The gains of a joint have long names: `gains.wheel_joint.p`. Which request takes several parameters as one?',
    "`client = ParameterClient('/wheel_controller')`, and then `client.set_parameters_atomically({...})`."))


class Noting(PidControllerNode):
    """A controller that notes the names in each request that keeps to its ranges."""

    def __init__(self) -> None:
        super().__init__()
        self.requests: list[set[str]] = []
        self.add_on_set_parameters_callback(self.note)

    def note(self, parameters: list[Parameter]) -> SetParametersResult:
        self.requests.append({each.name for each in parameters})
        return SetParametersResult(successful=True)


def changed(trial: Trial) -> Noting:
    """Run the learner's lines beside a controller.

    :raises NoUse: they do not run to their end, or change nothing.
    """
    controller = trial.start(Noting, ros_args=['-r', '__node:=wheel_controller'])
    run_lines(trial, ParameterClient=ClientInCorner)
    if not controller.requests:
        raise NoUse('a request that the controller accepts', 'there is none')
    show_response(trial, controller)
    return controller


def require_gain(letter: str, value: float) -> None:
    """Add the requirement that the controller holds a gain."""
    @change.require(f'the controller holds a gain `{letter}` of {value}', see=TOGETHER)
    def holds(trial: Trial) -> None:
        found = changed(trial).get_parameter(f'gains.wheel_joint.{letter}').value
        expect(values.same(found, value), f'`{value}`', f'it is `{found!r}`')


require_gain('p', 0.3)
require_gain('d', 0.02)


@change.require('all gains came in one request', see=TOGETHER)
def together(trial: Trial) -> None:
    count = len(changed(trial).requests)
    expect(count == 1, 'one request', f'there were {count}')


EXERCISES = (tune, change, write)
