"""Exercises of chapter 9: a node of ROS 1 and its parameter file come into the package, and a server of
dynamic_reconfigure is replaced."""

from typing import Any

from rclpy.node import Node

from param_tools import values
from param_tools.descriptor import is_housekeeping
from param_tutorial.exercises.exercise import NODE_CLASS, Exercise
from param_tutorial.exercises.expectations import (
    expect_accepted,
    expect_declared,
    expect_follows,
    expect_left_alone,
    expect_range,
    expect_range_fields,
    expect_rejected,
    format_found,
)
from param_tutorial.exercises.steps import (
    DRIVER,
    PACKAGE,
    class_of,
    expect_entry_points,
    expect_installed,
    file_of,
    text_of,
)
from param_tutorial.exercises.trial import NoUse, Trial, expect, take_for_granted

CHAPTER = '09_from_ros1'
GRIPPER = "A colleague's gripper"
FILE = 'Its file'
GUARDS = 'Who guards it'

translate = Exercise('9a', 'Translate the node', CHAPTER,
                     DRIVER._replace(open=lambda work: class_of(file_of(work, 'gripper_node.py'))),
                     node_name='gripper', hints=(
    'What ROS 1 calls `~gains` is two parameters, `gains.kp` and `gains.kd`. `/base_frame` becomes one of the node: '
    "`self.declare_parameter('base_frame', 'base')`.",
    'The default settles the type. A force is a double, so its default is `10.0`.',
    'Register a method with `self.add_post_set_parameters_callback` that reads `force_n` and `base_frame` into '
    '`self.force_n` and `self.frame`. Call it once at the end of the constructor, too.'))
DEFAULTS = {'force_n': 10.0, 'gains.kp': 1.0, 'gains.kd': 0.2, 'base_frame': 'base'}


@translate.require('it declares the four parameters, with the types and defaults of the old code', see=GRIPPER)
def gripper_declared(trial: Trial) -> None:
    found = trial.client(trial.start()).list_parameters()
    for name, value in DEFAULTS.items():
        slashed = name.replace('.', '/')
        old = [f'`{each}`' for each in (f'~{slashed}', slashed, f'/{name}') if each in found and each != name]
        expect(name in found, f'a parameter `{name}`',
               f'there is {old[0]}, as ROS 1 writes it' if old else 'the node has none of that name')
        expect_declared(trial, name, values.type_of(value), value)


@translate.require('`self.force_n` and `self.frame` are right from the start on, with an override too', see=GRIPPER)
def gripper_starts(trial: Trial) -> None:
    take_for_granted(trial, gripper_declared)
    for words, force_n, frame in (([], 10.0, 'base'), (['-p', 'force_n:=12.5', '-p', 'base_frame:=lab'], 12.5, 'lab')):
        expect_attributes(trial.start(ros_args=words), force_n=force_n, frame=frame)


@translate.require('they follow what is stored, and only that', see=GRIPPER)
def gripper_follows(trial: Trial) -> None:
    take_for_granted(trial, gripper_declared, gripper_starts)
    gripper = expect_follows(trial, 'force_n', [({'force_n': 12.5}, 12.5), ({'base_frame': 'lab'}, 12.5),
                                                ({'base_frame': 'hall', 'force_n': 20.0}, 20.0)])
    expect_attributes(gripper, frame='hall')
    expect_left_alone(trial, gripper, 'force_n', {'force_n': 30.0, 'base_frame': 'lab'})
    expect_attributes(gripper, frame='hall')


def expect_attributes(gripper: Node, **wanted: object) -> None:
    """Expect attributes of the node to hold these values."""
    for name, value in wanted.items():
        found = getattr(gripper, name, None)
        expect(values.same(found, value), f'`self.{name}` is `{value!r}`', f'it is {format_found(found)}')


move = Exercise('9b', 'Translate the file', CHAPTER, PACKAGE, node_name='gripper', hints=(
    'A file of ROS 2 has one level more: the node, then `ros__parameters`, then its values. The key `/**/gripper` '
    'means a gripper in any namespace.',
    'Write each value as the type that was declared: `kp: 2.0`. `base_frame` stands in the same block, or in one of '
    '`/**`.',
    "`setup.py` has a line that installs `config/my_robot.yaml`. Its list takes a second name, "
    "`'config/gripper.yaml'`."))
FROM_FILE = {'force_n': 12.5, 'gains.kp': 2.0, 'gains.kd': 0.1, 'base_frame': 'base_link'}


class Gripper(Node):
    """The node that takes the file."""

    def __init__(self) -> None:
        super().__init__('gripper')
        for name, value in DEFAULTS.items():
            self.declare_parameter(name, value)


def gripper_with_file(trial: Trial, namespace: str = '') -> Any:
    """Start the gripper with the learner's file.

    :raises NoUse: there is none, or rcl cannot read it.
    """
    text = text_of(trial.work, 'config/gripper.yaml')
    return trial.start_with_files(Gripper, {'gripper.yaml': text}, '--params-file', 'gripper.yaml', namespace=namespace)


@move.require('a gripper starts with it, and has the four values', see=FILE)
def has_values(trial: Trial) -> None:
    expect_held(trial, gripper_with_file(trial), 'a start with `config/gripper.yaml`', FROM_FILE)


@move.require('so does one in a namespace', see=FILE)
def has_values_anywhere(trial: Trial) -> None:
    take_for_granted(trial, has_values)
    expect_held(trial, gripper_with_file(trial, '/left'), 'a start in the namespace `/left`', FROM_FILE)


@move.require('`setup.py` installs it, and names the executable `gripper_node`', see=FILE)
def is_installed(trial: Trial) -> None:
    expect_installed(trial, 'config/gripper.yaml')
    expect_entry_points(trial, trial.work.root, 'driver_node', 'tuner_node', 'gripper_node')


def expect_held(trial: Trial, node: Node, after: str, wanted: dict[str, Any]) -> None:
    """Expect a node to hold these values."""
    held = trial.client(node).get_parameters(wanted)
    for name, value in wanted.items():
        expect(values.same(held[name], value), f'`{name}` is `{value!r}` after {after}', f'it is `{held[name]!r}`')


replace = Exercise('9c', 'Replace `dynamic_reconfigure`', CHAPTER, NODE_CLASS, node_name='fan', hints=(
    'Each `cfg.add` becomes one `declare_parameter`: `double_t` asks for a default with a dot, the last two numbers '
    'for a `FloatingPointRange` in the descriptor, and the sentence for its description.',
    "What the server's callback did goes into a post-set callback, which reads both parameters with `get_parameter`.",
    'Call that method once at the end of the constructor too, for what an override has brought.'))
DESCRIPTIONS = {'speed': 'A fraction of full speed, 3000 rpm.', 'boost': 'Doubles the speed for a moment.'}


@replace.require('`speed` is a double, 0.5 at the start, and `boost` a boolean, false at the start', see=GUARDS)
def fan_declared(trial: Trial) -> None:
    found = trial.client(trial.start()).list_parameters()
    if missing := [f'`{name}`' for name in DESCRIPTIONS if name not in found]:
        raise NoUse('both parameters', f'the node has no {" and no ".join(missing)}')
    others = [f'`{name}`' for name in found if name not in DESCRIPTIONS and not is_housekeeping(name)]
    expect(not others, 'the same two parameters', f'there is also {", ".join(others)}')
    expect_declared(trial, 'speed', values.DOUBLE, 0.5)
    expect_declared(trial, 'boost', values.BOOL, False)


@replace.require('a range rejects a speed below 0.0 or above 1.0, and both are described', see=GUARDS)
def fan_described(trial: Trial) -> None:
    fan = trial.start()
    client = trial.client(fan)
    expect_range_fields(fan, 'speed')
    for good in (0.0, 1.0, 0.125):
        expect_accepted(trial, fan, {'speed': good})
    for bad in (-0.5, 1.5):
        expect_rejected(trial, fan, {'speed': bad})
        expect_held(trial, fan, f'`speed = {bad}`', {'speed': 0.125})
    expect_range(client, 'speed', 0.0, 1.0)
    told = client.describe_parameters(DESCRIPTIONS)
    for name, wanted in DESCRIPTIONS.items():
        description = told[name].description
        expect(description.strip().rstrip('.') == wanted.rstrip('.'), f'`{name}` is described as in the `.cfg`',
               f'its description is `{description}`' if description.strip() else 'it has no description')


@replace.require('`self.motor_rpm` is right at the start, with an override too', see=GUARDS)
def fan_starts(trial: Trial) -> None:
    take_for_granted(trial, fan_declared)
    for ros_args, wanted in (([], 1500), (['-p', 'speed:=0.25'], 750), (['-p', 'boost:=true'], 3000),
                             (['-p', 'boost:=true', '-p', 'speed:=0.125'], 750)):
        fan = trial.start(ros_args=ros_args)
        motor = getattr(fan, 'motor_rpm', None)
        how = f'with `{" ".join(ros_args)}`' if ros_args else 'without an override'
        expect(motor == wanted, f'`self.motor_rpm` is {wanted} after a start {how}', f'it is {format_found(motor)}')


@replace.require('`self.motor_rpm` follows what is stored, and only that', see=GUARDS)
def fan_follows(trial: Trial) -> None:
    take_for_granted(trial, fan_declared, fan_starts)
    fan = expect_follows(trial, 'motor_rpm', [
        ({'speed': 0.0625}, 187.5), ({'speed': 0.25}, 750), ({'boost': True}, 1500), ({'speed': 0.5}, 3000),
        ({'boost': False, 'speed': 1.0}, 3000),
        ({'speed': 0.125, 'boost': True}, 750), ({'boost': False}, 375)])
    expect_left_alone(trial, fan, 'motor_rpm', {'speed': 0.75, 'boost': True})


EXERCISES = (translate, move, replace)
