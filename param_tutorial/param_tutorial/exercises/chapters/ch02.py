"""Exercises of chapter 2: put the lines of a terminal in order, complete a package that is really built, and find a
program as ``ros2 run`` does."""

import functools
import os
import re
import shlex
import signal
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from param_tools.cli.run import find_program
from param_tools.cli.session import CommandFailed
from param_tools.errors import ParameterToolError
from param_tools.ros import host
from param_tools.ros.waiting import PATIENCE, wait
from param_tutorial.exercises.exercise import DICTIONARY, FUNCTION, TEXT, Exercise
from param_tutorial.exercises.programs import describe_end, describe_exception
from param_tutorial.exercises.trial import NotYet, NoUse, Trial, expect
from param_tutorial.notebook.shell import NO_SHELL, Shell
from param_tutorial.notebook.terminal import Terminal

CHAPTER = '02_workspace'
BUILD = 'Build it'
SOURCE = 'Source it'
OVERLAY = 'One workspace on top of another'
NODE = 'A node, and its entry point'
COPY = 'Break it: a `setup.py` to copy'
ENTRY = 'Build it: one line, in the right place'

READY = 'The lift is ready.'
INDEX = 'share/ament_index/resource_index/packages'
MARKER = f'{INDEX}/lift'
PROGRAM = 'lib/lift/lift_node'
# Another package, with two programs.
CRANE = f'{INDEX}/crane', 'lib/crane/hook', 'lib/crane/arm'
# A slow machine takes a few seconds.
BUILD_LIMIT_SEC = 8.0
LINES_LIMIT_SEC = 6.0
# A program that still waits after this long waits for Ctrl+C.
STAYS_SEC = 1.0

SETUP, SOURCE_FILE = 'setup.py', 'lift/lift_node.py'
# The package of the first two exercises, apart from these two files.
LIFT = {
    'package.xml': '<package format="3"><name>lift</name><version>0.0.0</version></package>\n',
    'setup.cfg': '[develop]\nscript_dir=$base/lib/lift\n[install]\ninstall_scripts=$base/lib/lift\n',
    'resource/lift': '',
    'lift/__init__.py': '',
}


class Ran(NamedTuple):
    """How the executable of a package ran, until Ctrl+C or its own end."""

    printed: str
    went_on: bool
    """True if only Ctrl+C ended it."""
    complaint: str
    """What is wrong with its end; empty if nothing is."""


class Built(NamedTuple):
    """The result of a build."""

    complaint: str
    """The last line that the build printed, if it failed; else empty."""
    installed: frozenset[str]
    """Each file in the install space."""
    ran: Ran


NEVER_RAN = Ran('', False, '')


@functools.lru_cache(maxsize=4)
def build(setup: str, node: str) -> Built:
    """Build the package with a setup.py and the file of its node, in a scratch workspace, and run its executable.

    setuptools gets the arguments that colcon gives it. colcon itself takes five seconds, and writes a missing marker.
    """
    with tempfile.TemporaryDirectory(prefix='param_tutorial_') as folder:
        root, install = Path(folder, 'src'), Path(folder, 'install')
        for name, text in {**LIFT, SETUP: setup, SOURCE_FILE: node}.items():
            root.joinpath(name).parent.mkdir(parents=True, exist_ok=True)
            root.joinpath(name).write_text(text, encoding='utf-8')
        Path(folder, 'build').mkdir()
        # With --root, a `data_files` that begins with a slash stays in the scratch workspace, too.
        status, printed = _build(['setup.py', '-q', 'egg_info', '--egg-base', '../build', 'build', '--build-base',
                                  '../build', 'install', '--root', folder, '--prefix', '/install', '--record',
                                  '../build/record', '--single-version-externally-managed'], root)
        if status:
            last = printed.strip().splitlines()[-1:] or [f'exit status {status}']
            return Built(last[0], frozenset(), NEVER_RAN)
        installed = frozenset(str(path.relative_to(install)) for path in install.rglob('*') if path.is_file())
        try:
            program, = find_program('lift', 'lift_node', {'AMENT_PREFIX_PATH': str(install)})
        except CommandFailed:
            return Built('', installed, NEVER_RAN)
        return Built('', installed, _run(program, install, root / SOURCE_FILE))


def _build(words: list[str], folder: Path) -> tuple[int, str]:
    """Run Python in a folder, and return its exit status and what it printed.

    :raises NoUse: it does not come to an end, or can't be started where there are no processes.
    """
    if not host.host.has_processes:
        raise NoUse('the package is built', NO_SHELL)
    passed_on = {name: value for name, value in os.environ.items() if not name.startswith('PYTHON')}
    with subprocess.Popen([sys.executable, *words], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True,
                          env={**passed_on, 'PYTHONWARNINGS': 'ignore', 'PYTHONUTF8': '1'}) as process:
        try:
            printed, _ = process.communicate(timeout=BUILD_LIMIT_SEC * PATIENCE)
        except subprocess.TimeoutExpired:
            process.kill()
            raise NoUse('the build ends', f'it is still running after {BUILD_LIMIT_SEC:g} s') from None
        except BaseException:
            process.kill()
            raise
    return process.returncode, printed


def _run(program: str, install: Path, source: Path) -> Ran:
    """Start a program as ``ros2 run`` does, and press Ctrl+C once it waits."""
    modules = next(install.glob('lib/python*/site-packages'), install)
    terminal = Terminal(shlex.quote(program), variables={'PYTHONPATH': str(modules)})
    try:
        wait(lambda: READY in terminal.text or not terminal.is_running, BUILD_LIMIT_SEC)
        terminal.wait_until_idle(LINES_LIMIT_SEC)
        if wait(lambda: not terminal.is_running, STAYS_SEC):
            return Ran(terminal.text, False, describe_end(terminal, source))
        status = terminal.interrupt(LINES_LIMIT_SEC)
        complaint = describe_exception(terminal.text, source)
        if not complaint and status not in (0, -signal.SIGINT, 128 + signal.SIGINT):
            complaint = f'its exit status is {status}, which stands for an error'
        return Ran(terminal.text, True, complaint)
    finally:
        terminal.interrupt(LINES_LIMIT_SEC)


def texts(trial: Trial) -> tuple[str, str]:
    """Return the learner's two files.

    :raises NoUse: one is missing.
    """
    for name in (SETUP, SOURCE_FILE):
        if not isinstance(trial.work.get(name), str):
            raise NoUse(f'the text of `{name}` in the dictionary', f'there is `{trial.work.get(name)!r}`')
        if not trial.work[name].strip():
            raise NoUse(f'the text of `{name}`', 'it is empty')
    return trial.work[SETUP], trial.work[SOURCE_FILE]


def built(trial: Trial) -> Built:
    """Build the package with the learner's files.

    :raises NoUse: it cannot be built.
    """
    result = build(*texts(trial))
    if result.complaint:
        raise NoUse('a build without an error', result.complaint)
    return result


mend = Exercise('2b', 'Complete a package', CHAPTER, DICTIONARY, hints=(
    'Compare the `setup.py`, line by line, with the one that `ros2 pkg create` writes: the section “Create it” shows '
    'one. And compare the node with the one in the section “A node, and its entry point”.',
    '`data_files` is a list of pairs: a folder in the install space, and the files that go there. The marker goes to '
    '`share/ament_index/resource_index/packages`. In the source, it is in the folder `resource`.',
    'An entry point is `name = package.module:function`. Here the module is `lift_node`, in the package `lift`.',
    '`main` has a `try:` with two lines in it, `rclpy.init(args=args)` and `rclpy.spin(Lift())`. It catches '
    '`KeyboardInterrupt` and `ExternalShutdownException`. Both names need an import above the class: `rclpy`, and the '
    'exception from `rclpy.executors`.'))


@mend.require('the package builds', see=COPY)
def builds(trial: Trial) -> None:
    if not built(trial).installed:
        raise NoUse('the build installs something', 'it installs nothing: does the file call `setup(...)`?')


@mend.require('`package.xml` is in the share folder of the package', see=COPY)
def package_xml(trial: Trial) -> None:
    expect('share/lift/package.xml' in built(trial).installed, '`share/lift/package.xml`', 'it is not there')


@mend.require('the marker is where ROS looks for packages', see=BUILD)
def marker(trial: Trial) -> None:
    installed = built(trial).installed
    shares = sorted(name for name in installed if name.startswith('share/'))
    if MARKER not in installed:
        raise NoUse(f'`{MARKER}`', 'what is installed in `share` is '
                    + (', '.join(f'`{name}`' for name in shares) or 'nothing'))


@mend.require('there is an executable `lift_node`', see=ENTRY)
def executable(trial: Trial) -> None:
    programs = sorted(name for name in built(trial).installed
                      if name.startswith(('lib/lift/', 'bin/')) and '.' not in name)
    if PROGRAM not in programs:
        raise NoUse(f'`{PROGRAM}`', 'there is ' + (', '.join(f'`{name}`' for name in programs) or 'none'))


@mend.require(f'`ros2 run lift lift_node` starts the node, which logs “{READY}”', see=NODE)
def starts(trial: Trial) -> None:
    ran = built(trial).ran
    if READY not in ran.printed:
        last = ran.printed.strip().splitlines()[-1:] or ['nothing']
        raise NoUse(f'it logs “{READY}”', f'it prints {last[0]}' if ran.went_on else ran.complaint)


@mend.require('the node stays until Ctrl+C, which ends it without a traceback', see=NODE)
def stays(trial: Trial) -> None:
    ran = built(trial).ran
    expect(ran.went_on, 'a program that goes on until Ctrl+C', ran.complaint)
    expect(not ran.complaint, 'Ctrl+C ends it without a traceback', ran.complaint)


find = Exercise('2c', 'Be `ros2 run`', CHAPTER, FUNCTION, hints=(
    'Go through the prefixes in their order. Check whether the package’s marker is in each: '
    '`(prefix / "share/ament_index/resource_index/packages" / package).exists()`.',
    'The first prefix with the marker decides, and you look at no other. The program is in its '
    '`lib/package/program`, or nowhere.',
    'Return one of two sentences if there is no program: `No executable found` from inside the loop, and after it '
    "`Package 'lift' not found`, with the name of the package."))


def find_in(trial: Trial, spaces: Mapping[str, Sequence[str]], package: str, program: str) -> tuple[str, str]:
    """Return what the function answers, and what ``ros2 run`` does.

    :param spaces: For each install space, in the order of AMENT_PREFIX_PATH, the files in it.
    :raises NoUse: the function raises an exception.
    """
    with tempfile.TemporaryDirectory(prefix='param_tutorial_') as folder:
        for space, names in spaces.items():
            Path(folder, space).mkdir()
            for name in names:
                path = Path(folder, space, name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.touch(0o755)
        prefixes = [Path(folder, space) for space in spaces]
        try:
            right, = find_program(package, program, {'AMENT_PREFIX_PATH': os.pathsep.join(map(str, prefixes))})
        except CommandFailed as failure:
            right = str(failure)
        try:
            given = trial.call('your function', trial.work, package, program, prefixes)
        except NotYet as error:  # it may raise it again wherever it should return a sentence
            raise NoUse(error.expected, error.happened) from None
    answer = str(given) if isinstance(given, (str, Path)) else repr(given)
    return answer.replace(f'{folder}/', ''), right.replace(f'{folder}/', '')


def expect_finds(trial: Trial, spaces: Mapping[str, Sequence[str]], package: str = 'lift',
                 program: str = 'lift_node', *, wrong: Mapping[str, str] | None = None) -> None:
    """Expect the function to answer as ``ros2 run`` does.

    :param wrong: For wrong answers that one may well give, what to think of.
    """
    answer, right = find_in(trial, spaces, package, program)
    because = (wrong or {}).get(answer, '')
    expect(answer == right, f'`{right}`, as `ros2 run {package} {program}` says',
           f'it returns `{answer}`' + (f'. {because}' if because else ''))


@find.require('it finds a program that is there', see=BUILD)
def found(trial: Trial) -> None:
    try:
        expect_finds(trial, {'first': (MARKER, PROGRAM)})
    except NotYet as error:  # an answer that never finds anything meets no other requirement either
        raise NoUse(error.expected, error.happened) from None
    for program in ('hook', 'arm'):
        expect_finds(trial, {'first': (*CRANE, MARKER, PROGRAM)}, 'crane', program)


@find.require('it passes over an install space without the marker, whatever else is there', see=SOURCE)
def no_marker(trial: Trial) -> None:
    words = 'Without the marker, ROS does not know the package'
    expect_finds(trial, {'first': (PROGRAM,)}, wrong={f'first/{PROGRAM}': words})
    expect_finds(trial, {'first': (MARKER, 'lib/crane/hook')}, 'crane', 'hook', wrong={'first/lib/crane/hook': words})
    expect_finds(trial, {'first': (PROGRAM,), 'second': (MARKER, PROGRAM)}, wrong={f'first/{PROGRAM}': words})
    expect_finds(trial, {'first': CRANE, 'second': (), 'third': (MARKER, PROGRAM)})
    # The marker of another package, whose name begins or ends like this one's.
    for other in ('lift_tools', 'forklift'):
        expect_finds(trial, {'first': (f'{INDEX}/{other}', f'lib/{other}/lift_node', PROGRAM)},
                     wrong={f'first/{PROGRAM}': f'The marker there is that of `{other}`'})
    expect_finds(trial, {})


@find.require('it says so if the package is there and the program is not', see=SOURCE)
def no_program(trial: Trial) -> None:
    expect_finds(trial, {'first': (MARKER, 'lib/lift/door_node')})
    for other in ('lift_node_old', 'old_lift_node'):
        expect_finds(trial, {'first': (MARKER, f'lib/lift/{other}')})
    expect_finds(trial, {'first': (f'{INDEX}/crane', MARKER, PROGRAM)}, 'crane', 'hook')


@find.require('of two install spaces with the package, the first one decides', see=OVERLAY)
def overlaid(trial: Trial) -> None:
    both = {'first': (MARKER, PROGRAM), 'second': (MARKER, PROGRAM)}
    expect_finds(trial, both, wrong={f'second/{PROGRAM}': 'The overlay stands first, and hides the underlay'})
    # What else it may answer here is the matter of the requirement above.
    answer, right = find_in(trial, {'first': (MARKER, 'lib/lift/door_node'), 'second': (MARKER, PROGRAM)}, 'lift',
                            'lift_node')
    expect(answer != f'second/{PROGRAM}', f'`{right}`, as `ros2 run lift lift_node` says',
           f'it returns `{answer}`. `ros2 run` finds the package in `first`, and looks no further')


order = Exercise('2a', 'Put a terminal in order', CHAPTER, TEXT, hints=(
    'Ask of each line what it needs. `source`, for one, needs a file that only a build writes.',
    '`colcon build` writes into the folder in which you call it, so the line that goes to the workspace comes first. '
    'And `ros2 run` finds only what the terminal has sourced.'))

WORKSPACE = 'ros2_ws'
# What the build of the package would put into its install space; a real one takes half a minute on a slow machine.
BUILT = {
    f'lift/{MARKER}': '',
    f'lift/{PROGRAM}': f'#!/bin/sh\necho started >> "$HOME/.started"\necho "{READY}"\n',
}
SETUP_FILES = 'setup.bash', 'setup.sh', 'local_setup.bash', 'local_setup.sh'
# As the real one does, it builds what is anywhere below the folder in which it is called, and only what is selected.
COLCON = f"""colcon() {{
    if [ "$1" != build ]; then echo 'colcon: this terminal has the verb build, and no other' >&2; return 2; fi
    if [[ " $* " =~ " --packages-"(select|up-to)" " && " $* " != *" lift "* ]] ||
       [[ " $* " =~ " --packages-"(skip|ignore)" " && " $* " == *" lift "* ]] ||
       [ -z "$(find . -name package.xml)" ]; then
        echo 'Summary: 0 packages finished'; return
    fi
    mkdir -p install build log; cp -r ~/.built/. install
    for name in {' '.join(SETUP_FILES)}; do
        echo "export AMENT_PREFIX_PATH=\\"$PWD/install/lift:\\$AMENT_PREFIX_PATH\\"" > install/$name
    done
    echo 'Summary: 1 package finished'
}}"""


class Typed(NamedTuple):
    """The result of lines that were typed in a terminal."""

    printed: str
    built_in: str | None
    """The folder with the install space of the package, from the home folder; None if there is none."""
    is_sourced: bool
    """True if the terminal knows the package in the end."""
    is_started: bool


@functools.lru_cache(maxsize=4)
def type_lines(lines: str) -> Typed:
    """Type lines in a new terminal, beside a workspace with the source of the package.

    :raises WaitTimeoutError: they do not come to an end.
    """
    shell = Shell()
    try:
        source = shell.home / WORKSPACE / 'src' / 'lift'
        source.mkdir(parents=True)
        (source / 'package.xml').write_text(LIFT['package.xml'], encoding='utf-8')
        for name, text in BUILT.items():
            path = Path(shell.home, '.built', name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding='utf-8')
            path.chmod(0o755)
        shell.run(COLCON)
        printed = shell.run(lines, LINES_LIMIT_SEC)
        known = shell.environment().get('AMENT_PREFIX_PATH', '').split(os.pathsep)
        spaces = sorted(path.parent.relative_to(shell.home) for path in shell.home.rglob('install')
                        if (path / 'lift' / MARKER).exists())
        in_place = [path for path in spaces if path == Path(WORKSPACE)]
        return Typed(printed, str([*in_place, *spaces][0]) if spaces else None,
                     any(Path(prefix, MARKER).exists() for prefix in known if prefix),
                     (shell.home / '.started').exists())
    finally:
        shell.close()


def typed(trial: Trial) -> Typed:
    """Type the learner's lines.

    :raises NoUse: there are none, or they do not come to an end.
    """
    if not trial.work.strip():
        raise NoUse('some lines to type', 'there is none')
    try:
        return type_lines(trial.work)
    except ParameterToolError as error:
        raise NoUse('the lines finish', str(error)) from None


@order.require('the package is built, in its workspace', see=BUILD)
def is_built(trial: Trial) -> None:
    done = typed(trial)
    if done.built_in != WORKSPACE:
        happened = 'it is not there'
        if done.built_in:
            folder = '~' if done.built_in == '.' else f'~/{done.built_in}'
            happened += f', but in `{folder}/install`: `colcon build` writes into the folder in which you call it'
        elif '0 packages' in done.printed:
            happened += ': `colcon build` has found no package that it should build'
        raise NoUse(f'`~/{WORKSPACE}/install/lift`', happened)


@order.require('the terminal knows the package', see=SOURCE)
def is_sourced(trial: Trial) -> None:
    done = typed(trial)
    if not done.is_sourced:
        raise NoUse('`AMENT_PREFIX_PATH` of this terminal leads to the package', 'it does not' + (
            '. You can source a file only when it is there' if 'setup.bash: No such file' in done.printed else ''))


@order.require('`ros2 run lift lift_node` starts the node', see=SOURCE)
def is_running(trial: Trial) -> None:
    done = typed(trial)
    complaints = [line.strip() for line in done.printed.splitlines() if re.search('not found|No executable', line)]
    expect(done.is_started, f'the node starts, and prints “{READY}”', 'it does not start' + (
        f'; the terminal says `{complaints[0]}`' if complaints else ''))


EXERCISES = (order, mend, find)
