"""Exercises of chapter 8: tests of the reader's own, the driver's limits as one object, and what users can't change.

The reader's tests run as a program: by pytest, or, in a page, which has none, as pytest calls them. They have to pass
on the reader's package, and to fail on packages that are broken on purpose.
"""

import dataclasses
import re
import shutil
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any
from weakref import WeakKeyDictionary

from rclpy.node import Node

from param_tools.ros import interrupts
from param_tools.ros.waiting import wait
from param_tutorial.exercises.exercise import NODE_CLASS, Exercise
from param_tutorial.exercises.expectations import (
    WithSecondJudge,
    derive,
    expect_accepted,
    expect_rejected,
    format_found,
)
from param_tutorial.exercises.steps import PACKAGE, Bench, class_of, expect_speed, file_of
from param_tutorial.exercises.trial import CORNER, NotYet, NoUse, Trial, expect, overrides, take_for_granted
from param_tutorial.learner.package_files import PackageFiles, ours
from param_tutorial.notebook.terminal import Terminal

CHAPTER = '08_best_practices'
NOTICES = 'A test that notices'
WHOLE = 'One object, replaced as a whole'
NOT_ONE = 'What is not a parameter'
TWICE = 'Declared twice'
FILE, DRIVER, CONFIG = 'test/test_parameters.py', 'my_robot/driver_node.py', 'config/my_robot.yaml'
SPEED, STOP, BRAKING = 'max_speed_mps', 'stop_distance_m', 'braking_mps2'

# What runs the tests of several packages: a line for each test, and one in front of each package.
_RUN = '''
import importlib.util
import os
import re
import runpy
import sys

os.environ['PY_COLORS'] = '0'  # pytest would color its words, as JupyterLab's kernel asks each program to


def note(name, error):
    words = ' '.join(str(error).split()) or type(error).__name__
    print('FAILED' if error else 'PASSED', name.replace(' ', '_'), words if error else '', flush=True)


class Notes:
    def pytest_runtest_logreport(self, report):
        if report.when == 'call' or report.failed:
            crash = getattr(report.longrepr, 'reprcrash', None)
            words = (crash.message if crash else report.longrepr) if report.failed else ''
            note(report.nodeid.rpartition('::')[2], words)

    def pytest_collectreport(self, report):
        if report.failed:
            *before, last = str(report.longrepr).strip().splitlines()
            lines = re.findall('test_parameters[.]py(?:", line |:)([0-9]+)', ' '.join(before))
            note('the_file', last.removeprefix('E   ') + f' (line {lines[-1]})' * bool(lines))


def call_each(path):
    try:
        tests = runpy.run_path(path)
    except Exception as error:
        note('the_file', f'{type(error).__name__}: {error}')
        return
    for name, test in tests.items():
        if name.startswith('test_') and callable(test):
            try:
                test()
                note(name, '')
            except Exception as error:
                note(name, f'{type(error).__name__}: {error}')


folder, *roots = sys.argv[1:]
for root in roots:
    print('PACKAGE', flush=True)
    for name, module in list(sys.modules.items()):
        if name.partition('.')[0] == 'my_robot' or str(getattr(module, '__file__', '')).startswith(folder):
            del sys.modules[name]
    sys.path.insert(0, root)
    path = f'{root}/test/test_parameters.py'
    if importlib.util.find_spec('pytest'):
        import pytest
        pytest.main([path, '-c', f'{root}/setup.cfg', '--rootdir', root, '--import-mode', 'importlib', '-p',
                     'no:cacheprovider', '-p', 'no:terminal'], plugins=[Notes()])
    else:
        call_each(path)
    sys.path.remove(root)
'''
# How long all of it may take; importing rclpy takes seconds on a slow machine.
_LIMIT_SEC = 30.0

# What breaks a driver; it stands after its file, with the name of its class.
JUDGES_NOTHING = '{0}.add_on_set_parameters_callback = lambda *_: None'
ACTS_NEVER = '{0}.add_post_set_parameters_callback = lambda *_: None'
ACTS_AT_ONCE = '''
def _init(node, init={0}.__init__):
    import dataclasses

    from rcl_interfaces.msg import SetParametersResult

    def act(parameters):
        new = {{each.name: each.value for each in parameters if hasattr(node.limits, each.name)}}
        node.limits = dataclasses.replace(node.limits, **new)
        return SetParametersResult(successful=True)

    init(node)
    node.add_on_set_parameters_callback(act)


{0}.__init__ = _init
'''


class _TimeIsUp(BaseException):
    """Ends tests that don't end. No Exception, lest a test catches it."""


def run_tests(trial: Trial, *changes: Mapping[str, str]) -> list[dict[str, str]]:
    """Run the learner's tests on copies of their package.

    :param changes: For each copy, the files that are others in it, with their texts.
    :return: For each copy, what each test said; nothing if it passed.
    :raises NoUse: there are none, or they don't end.
    """
    files: PackageFiles = trial.work
    file_of(files, FILE)
    with tempfile.TemporaryDirectory() as folder:
        roots = []
        for number, changed in enumerate(changes):
            root = Path(folder, str(number), files.root.name)
            shutil.copytree(files.root, root, ignore=shutil.ignore_patterns('__pycache__', '.*'))
            for name, text in changed.items():
                (root / name).write_text(text, encoding='utf-8')
            roots.append(str(root))
        program = Path(folder, 'run.py')
        program.write_text(_RUN, encoding='utf-8')
        # A plugin of somebody's installation has no say, and no other node is to be found. In a page it has ended when
        # this returns: the limit ends a test that spins.
        with interrupts.time_limit(_LIMIT_SEC, _TimeIsUp):
            terminal = Terminal(f'python3 {program} {folder} {" ".join(roots)}', variables={
                'PYTEST_DISABLE_PLUGIN_AUTOLOAD': '1', 'ROS_AUTOMATIC_DISCOVERY_RANGE': 'OFF'})
        has_ended = wait(lambda: not terminal.is_running, _LIMIT_SEC)
        terminal.interrupt()
        text = terminal.text
    if not has_ended:
        raise NoUse('tests that end', 'they were still running after some seconds. Does one of them spin?')
    results: list[dict[str, str]] = []
    for line in text.splitlines():
        if line == 'PACKAGE':
            results.append({})
        elif match := re.match(r'(?:PASSED|FAILED) (\S+) ?(.*)', line):
            results[-1][match[1]] = results[-1].get(match[1]) or match[2]
    if len(results) < len(changes):
        raise NoUse('tests that end', text[-300:])
    return results


def expect_green(results: Mapping[str, str]) -> None:
    """Expect the tests to pass on the learner's own package.

    :raises NoUse: there are none.
    """
    if words := results.get('the_file'):
        raise NoUse('a file that Python can import', words)
    expect(results, 'a function whose name begins with `test_`', 'there is none')
    failed = [f'`{name}` fails: {words}' for name, words in results.items() if words]
    expect(not failed, 'each test passes on your package', '; '.join(failed))


def expect_red(results: Mapping[str, str], what: str) -> None:
    """Expect one of the tests to fail on a package that is broken.

    :param what: What is wrong with it.
    """
    expect(any(results.values()), 'one of your tests fails', f'each of them passes {what}')


def driver_class(trial: Trial) -> type[Node]:
    """Return the class of the learner's driver.

    :raises NoUse: there is none.
    """
    return class_of(trial.work.path('driver_node.py'))


def broken_driver(trial: Trial, *breaks: str) -> dict[str, str]:
    """Return the learner's driver, and what breaks it."""
    name = driver_class(trial).__name__
    return {DRIVER: '\n'.join([trial.work.text('driver_node.py'), *(each.format(name) for each in breaks)])}


def earlier_driver(trial: Trial, step: str) -> dict[str, str]:
    """Return our driver as it was after a step, with the name of the learner's class."""
    name = driver_class(trial).__name__
    return {DRIVER: '\n'.join([ours(step)[DRIVER], '' if name == 'Driver' else f'{name} = Driver', ''])}


def start_driver(trial: Trial, *words: str, node_class: type[Node] | None = None) -> Any:
    """Start the learner's driver."""
    return trial.start(node_class or driver_class(trial), ros_args=words)


tests = Exercise('8a', 'Two tests', CHAPTER, PACKAGE, hints=(
    'Write the lines above `test_it_starts_with_each_file` into the file as they are. Inside `with started(…)`, read '
    "the file a second time: `block, = yaml.safe_load(path.read_text()).values()`, then "
    "`block['ros__parameters'].items()`.",
    'For each name and value of the file: `assert driver.has_parameter(name)`, and then that '
    '`driver.get_parameter(name).value` equals the value.',
    'The second test starts a driver without words, calls '
    "`answer, = driver.set_parameters([Parameter('max_speed_mps', value=2.0)])`, and asserts that "
    '`answer.successful` is false.'))


def _with(*lines: str) -> str:
    return '\n'.join(['/**/driver:', '  ros__parameters:', *(f'    {each}' for each in lines), ''])


_TYPO = _with('max_sped_mps: 0.8', 'rate_hz: 20')
_BAD_FILES = {
    'if `config/my_robot.yaml` says `max_sped_mps`': {CONFIG: _TYPO},
    'if its key is `/**/drive`': {CONFIG: _TYPO.replace('driver', 'drive').replace('sped', 'speed')},
    'if one more file, `config/night.yaml`, says `max_sped_mps`': {'config/night.yaml': _TYPO},
    'if one more file, `config/race.yaml`, asks for 2.0 m/s and half a meter to brake': {
        'config/race.yaml': _with('max_speed_mps: 2.0', 'stop_distance_m: 0.5', 'braking_mps2: 1.0')}}
_results: 'WeakKeyDictionary[Trial, list[dict[str, str]]]' = WeakKeyDictionary()


def results_of(trial: Trial) -> list[dict[str, str]]:
    """Return what the tests say of the learner's package, then with each bad file, last without a judge; run once."""
    if trial not in _results:
        _results[trial] = run_tests(trial, {}, *_BAD_FILES.values(), broken_driver(trial, JUDGES_NOTHING))
    return _results[trial]


@tests.require('your tests pass on your package', see=NOTICES)
def green(trial: Trial) -> None:
    expect_green(results_of(trial)[0])


@tests.require('one fails if a parameter file, whichever it is, has a typo or a value that the driver rejects',
               see=NOTICES)
def reads_files(trial: Trial) -> None:
    take_for_granted(trial, green)
    for what, results in zip(_BAD_FILES, results_of(trial)[1:-1], strict=True):
        expect_red(results, what)


@tests.require('one fails if the driver judges no request', see=NOTICES)
def judged(trial: Trial) -> None:
    take_for_granted(trial, green)
    expect_red(results_of(trial)[-1], 'on your driver without its on-set callback')


swap = Exercise('8b', 'One object', CHAPTER, PACKAGE, hints=(
    'The test: keep `before = driver.limits`. A request that is rejected leaves `driver.limits == before`. After '
    '`set_parameters_atomically` with 2.0 m/s and 2.5 m, `driver.limits == Limits(2.0, 2.5, 1.0)`.',
    'Above the driver: `@dataclass(frozen=True)`, `class Limits:`, and three lines such as `max_speed_mps: float`.',
    'A method `limits_with(self, parameters)` takes the stored values, lets those of the parameters replace them, and '
    'returns `Limits(**values)`. The judge asks it about the request; the constructor and `act` store '
    '`self.limits = self.limits_with([])`.',
    '`drive` begins with `limits = self.limits`, and asks for no parameter.'))


@swap.require('a test of yours fails on the driver of 8a, which has no `limits`', see=WHOLE)
def fails_first(trial: Trial) -> None:
    results, = run_tests(trial, earlier_driver(trial, '8a'))
    expect(any('imits' in words for words in results.values()), 'a test about `driver.limits`',
           next((f'`{name}` fails: {words}' for name, words in results.items() if words),
                'each of your tests passes on that driver'))


@swap.require('`self.limits` is a frozen `Limits`, made of the values of the start', see=WHOLE)
def is_frozen(trial: Trial) -> None:
    limits = limits_of(start_driver(trial, *overrides({SPEED: 0.75, STOP: 0.625})))
    found = {name: getattr(limits, name, None) for name in (SPEED, STOP, BRAKING)}
    expect(type(limits).__name__ == 'Limits', 'an object of the class `Limits`', f'it is {format_found(limits)}')
    for name, value in {SPEED: 0.75, STOP: 0.625, BRAKING: 1.0}.items():
        expect(found[name] == value, f'`limits.{name}` is `{value}` after a start with `{value}`',
               f'it is {format_found(found[name])}')
    try:
        setattr(limits, SPEED, 1.0)
    except AttributeError:
        return
    raise NotYet(f'`limits.{SPEED} = 1.0` raises an exception', 'it is allowed. `@dataclass(frozen=True)` forbids it')


def limits_of(driver: Any) -> Any:
    """Return the limits of a driver.

    :raises NoUse: it has none.
    """
    try:
        return driver.limits
    except AttributeError:
        raise NoUse('`self.limits` once the constructor is done', 'the driver has no such attribute') from None


@swap.require('what is stored replaces it as a whole, and what is rejected leaves it', see=WHOLE)
def replaced(trial: Trial) -> None:
    driver = start_driver(trial, node_class=derive(WithSecondJudge, driver_class(trial)))
    before = limits_of(driver)
    expect_rejected(trial, driver, {SPEED: 2.0})
    expect(driver.limits == before, '`self.limits` stays as it is when the judge rejects 2.0 m/s',
           f'it is {format_found(driver.limits)}')
    expect_accepted(trial, driver, {SPEED: 2.0, STOP: 2.5})
    after = driver.limits
    expect((getattr(after, SPEED), getattr(after, STOP)) == (2.0, 2.5),
           '`self.limits` has 2.0 m/s and 2.5 m once both are stored', f'it is {format_found(after)}')
    expect(getattr(before, SPEED) == 0.5, 'the earlier object still says 0.5 m/s', 'it has changed')
    driver.rejects = True
    trial.client(driver).set_parameter(SPEED, 0.4)
    expect(driver.limits == after, '`self.limits` stays as it is when a second judge rejects a value',
           f'it is {format_found(driver.limits)}: an on-set callback has only a proposal')


@swap.require('the robot drives by it', see=WHOLE)
def drives(trial: Trial) -> None:
    bench, driver = trial.start(Bench), start_driver(trial)
    expect_accepted(trial, driver, {SPEED: 0.25})
    expect_speed(trial, bench, 0.25, 'once `max_speed_mps = 0.25` is stored')
    slower = dataclasses.replace(limits_of(driver), max_speed_mps=0.125, stop_distance_m=3.0)
    trial.ros.run(lambda: setattr(driver, 'limits', slower), 'replace the limits')
    expect_speed(trial, bench, 0.125, 'when the check puts limits with 0.125 m/s into `self.limits`',
                 {0.25: 'Does `drive` still ask for a parameter?'})
    bench.measure(2.0)
    expect_speed(trial, bench, 0.0, '2.0 m before the wall, when `self.limits` says 3.0 m',
                 {0.125: 'Does `drive` still ask for a parameter?'})


@swap.require('your tests pass, and one fails on a driver that acts too early or never', see=WHOLE)
def tested(trial: Trial) -> None:
    take_for_granted(trial, is_frozen)
    own, never, early = run_tests(trial, {}, broken_driver(trial, ACTS_NEVER), broken_driver(trial, ACTS_AT_ONCE))
    expect_green(own)
    expect_red(never, 'on your driver without its post-set callback')
    expect_red(early, 'on a driver that replaces `self.limits` before the judge has agreed')


fixed = Exercise('8c', 'Out of reach', CHAPTER, PACKAGE, hints=(
    "The tests: `with started('-p', 'braking_mps2:=0.8') as driver:`, and a request for 3.0 is not successful. And a "
    "start with `'-p', 'qos_overrides./cmd_vel.publisher.depth:=1'`, after which `driver.commands.qos_profile.depth` "
    'is 1; `commands` is what your driver calls its publisher.',
    'In the driver, `read_only=True` goes into the descriptor of `braking_mps2`, and '
    '`qos_overriding_options=QoSOverridingOptions.with_default_policies()` into `create_publisher`.'))
_DEPTH = 'qos_overrides./cmd_vel.publisher.depth'


@fixed.require('your tests fail on the driver of 8b', see=NOT_ONE)
def fails_before(trial: Trial) -> None:
    results, = run_tests(trial, earlier_driver(trial, '8b'))
    expect(sum(bool(words) for words in results.values()) >= 2, 'two tests that fail there, one about the brakes and '
           'one about the depth', f'{sum(bool(words) for words in results.values())} of your tests fails there')


@fixed.require('a start chooses `braking_mps2`, and no request changes it', see=NOT_ONE)
def braking_fixed(trial: Trial) -> None:
    driver = start_driver(trial, *overrides({BRAKING: 0.5}))
    held = driver.get_parameter(BRAKING).value
    expect(held == 0.5, f'`{BRAKING}` is `0.5` after a start with that', f'it is `{held}`')
    expect_rejected(trial, driver, {BRAKING: 3.0})
    expect(driver.describe_parameter(BRAKING).read_only, f'`{BRAKING}` is read-only', 'its descriptor does not say so')


@fixed.require('a start chooses the depth of the publisher of `cmd_vel`', see=NOT_ONE)
def depth_chosen(trial: Trial) -> None:
    for depth in (10, 3):
        words = overrides({_DEPTH.replace('/cmd_vel', f'{CORNER}/cmd_vel'): depth}) if depth != 10 else []
        driver = start_driver(trial, *words)
        publisher = next((each for each in driver.publishers if each.topic_name.endswith('/cmd_vel')), None)
        if publisher is None:
            raise NotYet('a publisher of `cmd_vel`', 'there is none')
        found = publisher.qos_profile.depth
        after = f'with `-p {_DEPTH}:={depth}`' if words else 'without words'
        expect(found == depth, f'its depth is {depth} after a start {after}',
               f'it is {found}. `create_publisher` takes `qos_overriding_options`')


@fixed.require('your tests pass on your package', see=NOT_ONE)
def green_again(trial: Trial) -> None:
    expect_green(run_tests(trial, {})[0])


twice = Exercise('8d', 'Configured twice', CHAPTER, NODE_CLASS, node_name='server', hints=(
    'A parameter that is there stays as it is: someone may have changed it meanwhile.',
    '`if not self.has_parameter(name):`, and the declaration below it.'))


def configured(trial: Trial, *words: str) -> Any:
    """Start the learner's server, and configure it."""
    server = trial.start(ros_args=words)
    configure(trial, server)
    return server


def configure(trial: Trial, server: Any) -> None:
    """Let a server configure itself, as its executor does.

    :raises NotYet: that raises an exception.
    """
    trial.call('`configure`', trial.ros.run, server.configure, 'configure')


@twice.require('the first `configure` declares a speed for each controller, which an override can give', see=TWICE)
def once(trial: Trial) -> None:
    server = configured(trial, *overrides({'dock.max_speed_mps': 0.125}))
    for name, value in {'follow.max_speed_mps': 0.5, 'dock.max_speed_mps': 0.125}.items():
        expect(server.has_parameter(name), f'a parameter `{name}`', 'there is none')
        found = server.get_parameter(name).value
        expect(found == value, f'`{name}` is `{value}`', f'it is `{found}`')


@twice.require('the second one works, and leaves what was set meanwhile', see=TWICE)
def again(trial: Trial) -> None:
    server = configured(trial)
    expect_accepted(trial, server, {'follow.max_speed_mps': 0.25})
    configure(trial, server)
    found = server.get_parameter('follow.max_speed_mps').value
    expect(found == 0.25, '`follow.max_speed_mps` is still `0.25`, which was set before the second `configure`',
           f'it is `{found}`')


@twice.require('a controller that has come meanwhile gets its speed too', see=TWICE)
def one_more(trial: Trial) -> None:
    server = configured(trial)
    expect_accepted(trial, server, {'controllers': ['follow', 'dock', 'spin']})
    configure(trial, server)
    expect(server.has_parameter('spin.max_speed_mps'), 'a parameter `spin.max_speed_mps` after the second `configure`',
           'there is none')


EXERCISES = (tests, swap, fixed, twice)
