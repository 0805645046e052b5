"""Exercises of chapter 11, the capstone: a warehouse cart, declared, judged, acting, saved, launched and tuned; and a
door in a package of its own.

The first three try what the learner has built. From the fourth on, the check uses the cart of the package, so that a
fault in an earlier step does not follow the learner.
"""

import contextlib
import functools
import math
import os
import re
import tempfile
from collections import Counter
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from rcl_interfaces.msg import SetParametersResult
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools.errors import NodeError, WaitTimeoutError
from param_tools.node.client import ParameterClient
from param_tools.ros import stage
from param_tools.ros.executor import BackgroundExecutor
from param_tools.ros.waiting import PATIENCE, wait_until
from param_tools.values import DOUBLE, STRING
from param_tutorial.exercises.exercise import FUNCTION, NODE_CLASS, TEXT, Exercise, Kind
from param_tutorial.exercises.expectations import (
    WithSecondJudge,
    client_for,
    derive,
    expect_accepted,
    expect_declared,
    expect_left_alone,
    expect_override,
    expect_range,
    expect_range_fields,
    expect_rejected,
    expect_result,
    expect_start_value,
    take_type_for_granted,
)
from param_tutorial.exercises.programs import require_ends, running
from param_tutorial.exercises.trial import NoStart, NotYet, NoUse, Trial, expect, overrides
from param_tutorial.nodes.cart_node import AISLE_M, CartNode
from param_tutorial.notebook.shell import NO_SHELL, Shell
from param_tutorial.notebook.terminal import Terminal
from param_tutorial.views.cart import cart_on_trip
from param_tutorial.views.drawing import driving

CHAPTER = '11_conclusion'
DECLARE = 'Declare'
ASK = 'Ask, and be answered'
JUDGE = 'Judge, and act'
SAVE = 'Save, and load'
START = 'Start, and launch'
TUNE = 'Tune'


def settings(speed_mps: float, acceleration_mps2: float) -> dict[str, float]:
    return {'max_speed_mps': speed_mps, 'max_acceleration_mps2': acceleration_mps2}


def show_trip(trial: Trial, cart: Node) -> None:
    """Show the drive that a cart makes, if it has what it needs for one."""
    values = [cart.get_parameter_or(name, Parameter(name)).value for name in settings(1.0, 0.5)]
    if all(isinstance(value, float) for value in values):
        trial.picture = driving.replay(cart_on_trip(f'/{cart.get_name()}', *values))


# -- 11a ----------------------------------------------------------------------------------------------------

declare = Exercise('11a', 'Declare the cart', CHAPTER, NODE_CLASS, node_name='cart_node', hints=(
    'One `self.declare_parameter(name, default, descriptor)` for each. The default decides the type, and the '
    'descriptor says the rest.',
    'A double takes its limits from `floating_point_range=[FloatingPointRange(from_value=..., to_value=...)]`, and '
    '`read_only=True` makes a parameter read-only.',
    'All of it goes into one descriptor: `ParameterDescriptor(description=..., read_only=True)`. Make a new one for '
    'each declaration.'))
NAMES = ('cart_id', 'max_speed_mps', 'max_acceleration_mps2')


@declare.require('each of the three has its own descriptor, with a description', see=DECLARE)
def described(trial: Trial) -> None:
    for name in NAMES:
        descriptor = client_for(trial, name).describe_parameter(name)
        if descriptor.name != name:
            raise NoUse(f'the descriptor of `{name}` names `{name}`',
                        f'it names `{descriptor.name}`: rclpy writes name and type into the descriptor that it is '
                        f'given, and the later declaration got the same one')
        expect(descriptor.description.strip(), f'`{name}` has a description',
               'it has none: anyone who opens a panel has to guess its unit')


@declare.require('`cart_id` is a string, starts as `CART-01`, and is read-only', see=DECLARE)
def cart_id(trial: Trial) -> None:
    expect_declared(trial, 'cart_id', STRING, 'CART-01')
    expect_result(client_for(trial, 'cart_id'), 'cart_id', 'CART-02', 'read only',
                  'The descriptor has a field for it, `read_only`')
    expect_override(trial, 'cart_id', 'CART-09', 'CART-09')


def expect_limits(trial: Trial, name: str, start: float) -> None:
    """Expect a double from 0.1 to 2.0."""
    expect_declared(trial, name, DOUBLE, start)
    node = trial.start()
    expect_range_fields(node, name)
    client = trial.client(node)
    for within in (0.1, 2.0, 1.234):
        expect_result(client, name, within, 'accepted')
    for beyond in (0.099, 2.001, -1.0, 3.0):
        expect_result(client, name, beyond, 'out of range', 'A double has its `floating_point_range`')
    expect_result(client, name, 1, 'wrong type', 'A parameter of a dynamic type takes anything')
    expect_override(trial, name, '1.5', 1.5)


@declare.require('`max_speed_mps` is a double, starts at 1.0, and has a range from 0.1 to 2.0', see=DECLARE)
def speed(trial: Trial) -> None:
    expect_limits(trial, 'max_speed_mps', 1.0)


@declare.require('`max_acceleration_mps2` is a double, starts at 0.5, and has a range from 0.1 to 2.0', see=DECLARE)
def acceleration(trial: Trial) -> None:
    expect_limits(trial, 'max_acceleration_mps2', 0.5)
    show_trip(trial, start_cart(trial))


# -- 11b ----------------------------------------------------------------------------------------------------

judge = Exercise('11b', 'Judge two parameters together', CHAPTER, NODE_CLASS, node_name='cart_node', hints=(
    'Write the rule once, as a method that takes a speed and an acceleration and returns the reason against them, or '
    'an empty string. The callback and the constructor both use it.',
    'The callback judges what would be stored: begin with the stored values, and let the proposed ones replace them. '
    '`{p.name: p.value for p in parameters}` is what is proposed.',
    'An on-set callback that is registered after the declarations never sees the start values. Call the rule in the '
    'constructor too, and `raise ValueError(reason)` if there is one.'))


def start_cart(trial: Trial, *values: float, node_class: type[Node] | None = None) -> Any:
    """Start the learner's cart, perhaps with other values than its own, and expect what was declared before.

    :raises NoStart: it does not start.
    :raises NoUse: it lacks a parameter.
    """
    cart = trial.start(node_class, ros_args=overrides(settings(*values)) if values else [])
    missing = [name for name in settings(1.0, 0.5) if not cart.has_parameter(name)]
    if missing:
        raise NoUse(f'a parameter `{missing[0]}`, from 11a', 'the node has none of that name')
    return cart


@judge.require('values with which the cart could not stop within 2 m are rejected, with a reason', see=JUDGE)
def sight(trial: Trial) -> None:
    cart = start_cart(trial)
    expect_accepted(trial, cart, {'max_speed_mps': 1.4}, '. 1.4 m/s and 0.5 m/s² make 1.96 m')
    for bad in ({'max_speed_mps': 2.0}, {'max_acceleration_mps2': 0.4}):
        expect_rejected(trial, cart, bad)
    # What is stored has moved, and the next request is judged from there.
    expect_accepted(trial, cart, {'max_acceleration_mps2': 1.5}, '. 1.4 m/s and 1.5 m/s² make 0.65 m')
    expect_accepted(trial, cart, {'max_speed_mps': 2.0}, '. 2.0 m/s and 1.5 m/s² make 1.33 m')
    expect_rejected(trial, cart, {'max_acceleration_mps2': 0.9})
    expect_accepted(trial, cart, {'use_sim_time': False}, '. It has nothing to do with the rule')


@judge.require('both in one request are judged together, in either order', see=JUDGE)
def together(trial: Trial) -> None:
    cart = start_cart(trial)
    expect_accepted(trial, cart, settings(2.0, 1.0),
                    '. The rule is about the proposed speed and the proposed acceleration, and 2.0 m is still allowed')
    expect_rejected(trial, cart, settings(2.0, 0.9))
    expect_accepted(trial, cart, {'max_acceleration_mps2': 0.2, 'max_speed_mps': 0.5}, '. They make 0.63 m')
    for bad in ({'max_acceleration_mps2': 0.5, 'max_speed_mps': 1.9}, settings(1.9, 0.5)):
        expect_rejected(trial, cart, bad)


@judge.require('a cart that is given such values at its start does not start', see=JUDGE)
def start_values(trial: Trial) -> None:
    cart = start_cart(trial, 1.5, 1.0)
    held = trial.client(cart).get_parameters([*settings(1.5, 1.0)])
    expect(dict(held) == settings(1.5, 1.0), 'a cart that is started with 1.5 m/s and 1.0 m/s² has them', f'{held}')
    show_trip(trial, cart)
    for bad in ((2.0, 0.5), (1.0, 0.2), (1.5, 0.5)):
        try:
            start_cart(trial, *bad)
        except NoStart:
            continue
        raise NotYet('a cart with {} m/s and {} m/s² ends in its constructor'.format(*bad),
                     'it has started. An on-set callback that is registered after the declarations never sees the '
                     'start values')


# -- 11c ----------------------------------------------------------------------------------------------------

act = Exercise('11c', 'Act on what is stored', CHAPTER, NODE_CLASS, node_name='cart_node', hints=(
    'Something has to happen when values are stored, and not before: which of the three callbacks is that?',
    'Register it with `add_post_set_parameters_callback`, and calculate `self.trip_sec` in it from `get_parameter`.',
    'The constructor calls the same method once, after `super().__init__()`: by then the start values are stored.'))


def expect_trip(trial: Trial, cart: Node, speed_mps: float, acceleration_mps2: float, when: str) -> None:
    """Expect `self.trip_sec` to be right, soon: it may come by an event."""
    trial.wait(lambda: has_trip(cart, speed_mps, acceleration_mps2),
               f'`self.trip_sec` is {trip_sec(speed_mps, acceleration_mps2):g} {when}',
               lambda: f'it is `{getattr(cart, "trip_sec", None)!r}`')


def trip_sec(speed_mps: float, acceleration_mps2: float) -> float:
    return AISLE_M / speed_mps + speed_mps / acceleration_mps2


def has_trip(cart: Node, speed_mps: float, acceleration_mps2: float) -> bool:
    """True if `self.trip_sec` is right."""
    found = getattr(cart, 'trip_sec', None)
    return isinstance(found, (int, float)) and math.isclose(found, trip_sec(speed_mps, acceleration_mps2))


@act.require('`self.trip_sec` is right from the start, whatever the cart starts with', see=JUDGE)
def from_the_start(trial: Trial) -> None:
    for start in ((), (1.5, 1.0)):
        cart, held = start_cart(trial, *start), start or (1.0, 0.5)
        expect(has_trip(cart, *held), '`self.trip_sec` is {:g} as soon as a cart with {} m/s and {} m/s² has started'
               .format(trip_sec(*held), *held), f'it is `{getattr(cart, "trip_sec", None)!r}`')
        show_trip(trial, cart)


@act.require('it follows what is stored', see=JUDGE)
def follows(trial: Trial) -> None:
    cart = start_cart(trial)
    for asked, stored in (({'max_speed_mps': 1.2}, (1.2, 0.5)), (settings(2.0, 1.0), (2.0, 1.0)),
                          ({'max_acceleration_mps2': 1.6}, (2.0, 1.6)), ({'max_speed_mps': 0.8}, (0.8, 1.6)),
                          ({'max_acceleration_mps2': 0.3, 'max_speed_mps': 0.6}, (0.6, 0.3)),
                          ({'use_sim_time': False}, (0.6, 0.3))):
        expect_accepted(trial, cart, asked)
        expect_trip(trial, cart, *stored, 'once {} m/s and {} m/s² are stored'.format(*stored))


@act.require('it stays as it is when a change is rejected in the end', see=JUDGE)
def acts_late(trial: Trial) -> None:
    cart = start_cart(trial, node_class=derive(WithSecondJudge, trial.work))
    expect_accepted(trial, cart, {'max_speed_mps': 1.2})
    expect_trip(trial, cart, 1.2, 0.5, 'once 1.2 m/s is stored')
    for rejected in ({'max_speed_mps': 0.6}, {'max_acceleration_mps2': 1.0}):
        expect_left_alone(trial, cart, 'trip_sec', rejected)


# -- 11d ----------------------------------------------------------------------------------------------------

save = Exercise('11d', 'Save, for the whole fleet', CHAPTER, FUNCTION, hints=(
    "Two things in a cart's dump are not for other carts: its key, and its `cart_id`.",
    'The key may be `/**:`, which is for every node. The file needs the two numbers and nothing else.',
    '`client.get_parameters([...])` returns the two, and `parameter_files.render(node, values)` turns them into '
    'the text of a file, which has a method `save(path)`.'))
# Once with numbers that lose their dot if nobody takes care of it.
TUNED = (settings(2.0, 1.0), settings(1.35, 0.875))
FILE = 'fleet.yaml'


def saved(trial: Trial, tuned: Mapping[str, float]) -> str:
    """Let the learner's function save the values of a tuned cart, and return what is in the file.

    :raises NoUse: there is no file.
    """
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / FILE
        source = trial.client(start_cart(trial, *tuned.values(), node_class=CartNode))
        trial.call('`save_for_all(client, path)`', trial.work, source, path)
        if not path.is_file():
            raise NoUse('a file at `path`', 'there is none')
        return path.read_text(encoding='utf-8')


def expect_from_file(trial: Trial, name: str, namespace: str) -> None:
    """Expect a cart of another name to have what the file says."""
    for tuned in TUNED:
        second = trial.start_with_files(
            CartNode, {FILE: saved(trial, tuned)}, '-r', f'__node:={name}', '-p', 'cart_id:=CART-02',
            '--params-file', FILE, namespace=namespace)
        show_trip(trial, second)
        held = dict(trial.client(second).get_parameters(tuned))
        because = '. A file is for the nodes that its key names' if held == settings(1.0, 0.5) else ''
        expect(held == tuned, f'in `{namespace}/{name}`: {_assignments(tuned)}', f'{_assignments(held)}{because}')


def _assignments(values: Mapping[str, Any]) -> str:
    return ', '.join(f'`{name} = {value!r}`' for name, value in values.items())


@save.require('a cart of another name, or in a namespace, that is started with the file has the values', see=SAVE)
def starts_with_it(trial: Trial) -> None:
    for name, namespace in (('second_cart', ''), ('tug', ''), ('cart_node', '/aisle_2')):
        expect_from_file(trial, name, namespace)


@save.require('and keeps its own `cart_id`', see=SAVE)
def keeps_its_id(trial: Trial) -> None:
    for tuned in TUNED:
        second = trial.client(trial.start_with_files(
            CartNode, {FILE: saved(trial, tuned)}, '-r', '__node:=second_cart', '-p', 'cart_id:=CART-02',
            '--params-file', FILE))
        found = second.get_parameter('cart_id')
        expect(found == 'CART-02', "`cart_id` is `'CART-02'`, as `-p` says before the file",
               f'it is `{found!r}`. At a start, a file gives values to read-only parameters, too')


# -- 11e ----------------------------------------------------------------------------------------------------

launch = Exercise('11e', 'Launch it, with an override', CHAPTER, TEXT, hints=(
    'The launch files in `param_tutorial/launch` show the frame: a function that returns a `LaunchDescription` with a '
    '`Node` in it. This one has a `namespace=` as well.',
    'The parameter file is `os.path.join(get_package_share_directory("param_tutorial"), "config", '
    '"cart_config.yaml")`. It is the first in the list `parameters`, and a dictionary comes after it.',
    'From 1.5 m/s the cart needs at least 0.57 m/s² to stop in time, and the file says 0.4. So the dictionary has two '
    'values: `{"max_speed_mps": 1.5, "max_acceleration_mps2": 0.6}`.'))
LAUNCHED = '/aisle_3/cart_node'
# How long the first node may take to come, and how long the cart after another one.
ARRIVAL_SEC, LATER_SEC = 8.0, 3.0
ANSWER_SEC = 30.0


@functools.lru_cache(maxsize=8)
def values_after_launch(text: str) -> dict[str, Any]:
    """Launch a text as a process of its own, and return the values of the cart that it starts in the aisle.

    The requirements ask for the same launch one after the other; one that went well need not be repeated.

    :raises NoUse: there came no such cart.
    """
    ros = stage.current()
    before = Counter(ros.services.node_names())

    def new() -> Counter[str]:
        """Return the nodes that were not there before."""
        return Counter(ros.services.node_names()) - before

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / 'cart_launch.py'
        path.write_text(text)
        with _in_folder(folder):  # a path that is relative to the learner's folder is not found in any other
            terminal = Terminal(f'ros2 launch {path}')
        try:
            wait_until(lambda: new() or not terminal.is_running, 'a node', ARRIVAL_SEC)
            # The launch starts all of them at once, and each takes much longer to show up.
            if (count := terminal.text.count(']: process started')) > 1:
                raise NoUse(f'a node `{LAUNCHED}`, and nothing else', f'the launch starts {count} processes')
            if new() and not any(name.endswith('/cart_node') for name in new()):
                with contextlib.suppress(WaitTimeoutError):
                    wait_until(lambda: LAUNCHED in new() or not terminal.is_running, LAUNCHED, LATER_SEC)
            if new() and LAUNCHED not in new():
                raise NoUse(f'a node `{LAUNCHED}`', f'there came a `{min(new())}`')
            wait_until(lambda: is_there(ros) or not terminal.is_running, LAUNCHED, ANSWER_SEC)
            if is_there(ros):
                return dict(ParameterClient(LAUNCHED, timeout_sec=ANSWER_SEC).get_parameters(
                    ['cart_id', *settings(1.5, 0.6)]))
        except (NodeError, WaitTimeoutError):
            pass  # it has never come, or has ended in its constructor
        finally:
            terminal.interrupt(ANSWER_SEC)
            wait_until(lambda: not new(), 'the cart to leave', ANSWER_SEC)
    lines = [line.replace(folder, '…') for line in terminal.text.splitlines()]
    reasons = [line for line in lines if 'Error' in line or 'Exception' in line]
    raise NoUse(f'a node `{LAUNCHED}`', 'none came' + ''.join(
        f'. The launch says: {line}' for line in [*lines, *reasons][-1:]))


@contextlib.contextmanager
def _in_folder(folder: str) -> Iterator[None]:
    """Let what is started in this block start in a folder."""
    before = Path.cwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)


def is_there(ros: BackgroundExecutor) -> bool:
    return ros.services.is_ready(LAUNCHED, 'get_parameters')


def expect_launched(trial: Trial) -> dict[str, Any]:
    """Launch the learner's text, and expect a cart in the aisle."""
    if 'def generate_launch_description' not in trial.work:
        raise NoUse('the text of a launch file', 'there is no function `generate_launch_description` in it yet')
    if is_there(trial.ros):
        raise NoUse('no cart of this name before the launch', f'there is a `{LAUNCHED}` already: end it first')
    return values_after_launch(trial.work)


@launch.require('`ros2 launch` starts the cart as `/aisle_3/cart_node`', see=START)
def in_the_aisle(trial: Trial) -> None:
    expect_launched(trial)


@launch.require('it drives at 1.5 m/s and accelerates at 0.6 m/s², whatever the file says', see=START)
def with_overrides(trial: Trial) -> None:
    found = expect_launched(trial)
    wanted = settings(1.5, 0.6)
    trial.picture = driving.replay(cart_on_trip(LAUNCHED, *(found[name] for name in wanted)))
    expect({name: found[name] for name in wanted} == wanted, '1.5 and 0.6',
           f'{found["max_speed_mps"]} and {found["max_acceleration_mps2"]}. Of two sources, which one wins?')


@launch.require('what the launch file does not say comes from `config/cart_config.yaml`', see=START)
def with_the_file(trial: Trial) -> None:
    found = expect_launched(trial)
    expect(found['cart_id'] == 'CART-07', "`cart_id` is `'CART-07'`, as in the file",
           f'it is `{found["cart_id"]!r}`: the file has not been loaded')
    # The same id, written into the launch file, would be that of this cart forever.
    expect('cart_config' in trial.work, 'the launch file names `cart_config.yaml`', 'it does not')


# -- 11f ----------------------------------------------------------------------------------------------------

tune = Exercise('11f', 'Tune it', CHAPTER, FUNCTION, hints=(
    'Solve `12 / v + v / a = 8` for `a`. Which `v` makes it smallest?',
    '`a = v² / (8 v − 12)`. It falls as `v` rises, up to 3 m/s, and the range of the speed ends before that.',
    'Both together or not at all: with the old acceleration the cart would reject the new speed. '
    '`client.set_parameters_atomically({...})` sends one request.'))
GOAL_SEC = 8.0
GENTLEST_MPS2, FASTEST_MPS = 1.0, 2.0


class Watched(CartNode):
    """Notes how many parameters each request holds."""

    def __init__(self) -> None:
        super().__init__()
        self.requests: list[int] = []

    def validate(self, parameters: list[Parameter]) -> SetParametersResult:
        # It is called for each parameter of set_parameters, and once for set_parameters_atomically.
        self.requests.append(len(parameters))
        return super().validate(parameters)


def tuned(trial: Trial, *start: float) -> Watched:
    """Let the learner's function tune a cart."""
    cart: Watched = start_cart(trial, *start, node_class=Watched)
    trial.call('`tune(client)`', trial.work, trial.client(cart))
    show_trip(trial, cart)
    return cart


@tune.require('the aisle takes at most 8 s', see=TUNE)
def in_time(trial: Trial) -> None:
    for start in ((), (0.5, 0.2)):
        cart = tuned(trial, *start)
        if cart.trip_sec > GOAL_SEC + 1e-6:
            digits = 2 if cart.trip_sec > GOAL_SEC + 0.005 else 6  # 8.00 s would not be too long
            has_changed = cart.settings() != (start or (1.0, 0.5))
            raise NoUse('at most 8 s', f'{cart.trip_sec:.{digits}f} s, with '
                        f'{" m/s and ".join(f"{each:g}" for each in cart.settings())} m/s²'
                        + ('' if has_changed else ', as before. Has the cart accepted a request?'))


@tune.require('with the gentlest acceleration that will do', see=TUNE)
def gently(trial: Trial) -> None:
    cart = tuned(trial)
    speed_mps, found = cart.settings()
    expect(found <= GENTLEST_MPS2 * 1.01, 'no acceleration is gentler and still in time',
           f'{found:g} m/s²; there is a gentler one, ' + ('with a higher speed' if speed_mps < FASTEST_MPS else
                                                         f'since {cart.trip_sec:.2f} s are less than {GOAL_SEC:g} s'))


@tune.require('both values change together, in one request', see=TUNE)
def at_once(trial: Trial) -> None:
    requests = tuned(trial, 0.5, 0.2).requests
    expect(all(each == 2 for each in requests), 'two parameters in each request',
           f'{len(requests)} requests, with {" and ".join(map(str, requests))}')


# -- 11g ----------------------------------------------------------------------------------------------------

DOOR = '11g · A door, in a package of its own'
FOLDER = Kind('the folder of your package, in quotes', lambda work: isinstance(work, (str, Path)) and str(work) != '',
              'my_package')
# colcon alone takes five seconds.
BUILD_SEC = 60.0
package = Exercise('11g', 'A door, in a package of its own', CHAPTER, FOLDER, node_name='door', hints=(
    '`%ros2 pkg create --build-type ament_python --node-name door_node warehouse` writes the package, with a '
    '`door_node.py` that only greets. That file is yours to write.',
    'A cell that begins with `%%writefile warehouse/warehouse/door_node.py` replaces it. The program has a class, a '
    '`main` and the two last lines; the entry point in `setup.py` calls `main`.',
    'The range is a `FloatingPointRange(from_value=1.0, to_value=60.0)` in the descriptor, and `main` spins the node '
    'in a `try:` that catches `KeyboardInterrupt` and `ExternalShutdownException`.'))


@functools.lru_cache(maxsize=1)
def build(files: frozenset[tuple[str, bytes]]) -> Shell:
    """Build a package in a workspace, and return a terminal in which it is sourced.

    :raises NoUse: it cannot be built.
    """
    shell = Shell()
    if not shell.can_run:
        raise NoUse('the package is built', NO_SHELL)
    for name, content in files:
        path = shell.home / 'ros2_ws' / 'src' / 'warehouse' / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    printed = shell.run('cd ~/ros2_ws && colcon build', BUILD_SEC * PATIENCE)
    failed = shell.status
    shell.run('source install/setup.bash')
    if failed or 'Finished <<< warehouse' not in printed:
        # The first one is about the package, and what follows about colcon.
        error = re.search(r'^ *(\w*[Ee]rror: .*)', printed, re.MULTILINE)
        raise NoUse('`colcon build` finishes the package `warehouse`', error[1] if error else
                    f'it finds no package of this name, and says: {printed.strip().splitlines()[-1]}')
    return shell


def built(trial: Trial) -> Shell:
    """Build the learner's package."""
    folder = Path(trial.work)
    if not folder.is_dir():
        raise NoUse(f'a folder `{folder}`', 'there is none beside this notebook yet')
    if not (folder / 'warehouse' / '__init__.py').is_file():
        raise NoUse(f'a module `{folder}/warehouse`, which Python can import',
                    f'there is no `{folder}/warehouse/__init__.py`, so nothing in that folder is installed')
    return build(frozenset((str(path.relative_to(folder)), path.read_bytes()) for path in folder.rglob('*')
                           if path.is_file() and '__pycache__' not in path.parts))


def run_door(trial: Trial, words: str) -> Terminal:
    """Start the learner's program.

    :raises NoUse: the package has none of this name where ``ros2 run`` looks for it.
    """
    shell = built(trial)
    install = shell.home / 'ros2_ws' / 'install' / 'warehouse'
    if not (install / 'lib' / 'warehouse' / 'door_node').exists():
        there = [f'`{path.relative_to(install)}`' for folder in ('bin', 'lib/warehouse')
                 for path in sorted((install / folder).glob('*'))]
        raise NoUse('`lib/warehouse/door_node`', f'in `install/warehouse` there is {", ".join(there) or "no program"}. '
                    'Do `setup.py` and `setup.cfg` name it, and its place?')
    return Terminal(f'ros2 run warehouse door_node {words}', shell)


@package.require('`colcon build` builds the package `warehouse`', see=DOOR)
def builds(trial: Trial) -> None:
    built(trial)


@package.require('`ros2 run warehouse door_node` starts a node that answers', see=DOOR)
def runs(trial: Trial) -> None:
    with running(trial, package, start=run_door):
        pass


@package.require('`open_sec` is a double, starts at 5.0, and has a range from 1.0 to 60.0', see=DECLARE)
def open_sec(trial: Trial) -> None:
    with running(trial, package, start=run_door) as door:
        client = trial.client(door.node)
        expect_start_value(client, 'open_sec', DOUBLE, 5.0)
        expect_range(client, 'open_sec', 1.0, 60.0)


@package.require('it logs how long it stays open when it starts', see=START)
def logs_open_sec(trial: Trial) -> None:
    with running(trial, package, start=run_door) as door:
        take_type_for_granted(trial.client(door.node), DOUBLE, 'open_sec')
    with running(trial, package, '-p open_sec:=7.5', start=run_door) as door:
        door.expect_line('7.5', 'after a start with `-p open_sec:=7.5`')


require_ends(package, DOOR, start=run_door)


EXERCISES = (declare, judge, act, save, launch, tune, package)
