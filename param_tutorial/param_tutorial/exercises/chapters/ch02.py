"""Exercises of chapter 2: order the lines of a terminal, mend a setup.py that is really built, and find a program
as ``ros2 run`` does."""

import functools
import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from param_tutorial.errors import ParameterToolError
from param_tutorial.exercises.exercise import FUNCTION, TEXT, Exercise
from param_tutorial.exercises.trial import NotYet, NoUse, Trial, expect
from param_tutorial.notebook.shell import Shell
from param_tutorial.ros2.run import find_program
from param_tutorial.ros2.session import CommandFailed

CHAPTER = '02_workspace'
BUILD = 'Build it'
SOURCE = 'Source it'
COPY = 'Break it: a `setup.py` to copy'
ENTRY = 'Build it: one line, in the right place'

READY = 'The lift is ready.'
MARKER = 'share/ament_index/resource_index/packages/lift'
PROGRAM = 'lib/lift/lift_node'
OTHER_PROGRAM = 'lib/lift/door_node'
# For a build; a slow machine takes a few seconds.
TIME_LIMIT_SEC = 30.0

# The package of the first exercise, apart from its setup.py.
LIFT = {
    'package.xml': '<package format="3"><name>lift</name><version>0.0.0</version></package>\n',
    'setup.cfg': '[develop]\nscript_dir=$base/lib/lift\n[install]\ninstall_scripts=$base/lib/lift\n',
    'resource/lift': '',
    'lift/__init__.py': '',
    'lift/lift_node.py': f'def main():\n    print({READY!r})\n',
}


class Built(NamedTuple):
    """What became of a package."""

    complaint: str
    """The last line of what the build said, if it failed; else empty."""
    installed: frozenset[str]
    """Each file in the install space."""
    said: str
    """What its program printed; or, if there is none, what ``ros2 run`` says."""


@functools.lru_cache(maxsize=4)
def build(setup: str) -> Built:
    """Build the package with a setup.py, in a scratch workspace, and run its program.

    setuptools gets the words that colcon gives it. colcon itself takes five seconds, and writes a missing marker.
    """
    with tempfile.TemporaryDirectory(prefix='param_tutorial_') as folder:
        root, install = Path(folder, 'src'), Path(folder, 'install')
        for name, text in {**LIFT, 'setup.py': setup}.items():
            root.joinpath(name).parent.mkdir(parents=True, exist_ok=True)
            root.joinpath(name).write_text(text, encoding='utf-8')
        Path(folder, 'build').mkdir()
        status, said = _run(['setup.py', '-q', 'egg_info', '--egg-base', '../build', 'build', '--build-base',
                             '../build', 'install', '--prefix', '../install', '--record', '../build/record',
                             '--single-version-externally-managed'], root)
        if status:
            return Built(said.strip().splitlines()[-1] if said.strip() else f'exit status {status}', frozenset(), '')
        installed = frozenset(str(path.relative_to(install)) for path in install.rglob('*') if path.is_file())
        try:
            program, = find_program('lift', 'lift_node', {'AMENT_PREFIX_PATH': str(install)})
        except CommandFailed as failure:
            return Built('', installed, str(failure))
        modules = next(install.glob('lib/python*/site-packages'), install)
        return Built('', installed, _run([program], root.parent, PYTHONPATH=str(modules))[1].strip())


def _run(words: list[str], folder: Path, **environment: str) -> tuple[int, str]:
    """Run Python in a folder, and return its exit status and what it said."""
    passed_on = {name: value for name, value in os.environ.items() if not name.startswith('PYTHON')}
    done = subprocess.run([sys.executable, *words], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, timeout=TIME_LIMIT_SEC,
                          env={**passed_on, 'PYTHONWARNINGS': 'ignore', 'PYTHONUTF8': '1', **environment})
    return done.returncode, done.stdout


def built(trial: Trial) -> Built:
    """Build the package with the learner's setup.py.

    :raises NoUse: it cannot be built.
    """
    try:
        result = build(trial.work)
    except subprocess.TimeoutExpired:
        raise NoUse('it comes to an end', f'it had not done so after {TIME_LIMIT_SEC:g} s') from None
    if result.complaint:
        raise NoUse('a build without an error', result.complaint)
    return result


mend = Exercise('2a', 'Mend a `setup.py`', CHAPTER, TEXT, hints=(
    'Compare it, line by line, with the `setup.py` that `ros2 pkg create` writes: the section “Create it” shows one.',
    '`data_files` is a list of pairs: a folder in the install space, and the files that go there. The marker goes to '
    '`share/ament_index/resource_index/packages`, and it lies in the folder `resource`.',
    'An entry point is `name = package.module:function`. Here the module is `lift_node`, in the package `lift`.'))


@mend.require('the package builds', see=COPY)
def builds(trial: Trial) -> None:
    if not trial.work.strip():
        raise NoUse('the text of a `setup.py`', 'there is nothing in it')
    if not built(trial).installed:
        raise NoUse('something is installed', 'nothing is: does it call `setup(...)`?')


@mend.require('the marker is where ROS looks for packages', see=BUILD)
def marker(trial: Trial) -> None:
    installed = built(trial).installed
    shares = sorted(name for name in installed if name.startswith('share/'))
    expect(MARKER in installed, f'`{MARKER}`', 'what is installed in `share` is '
           + (', '.join(f'`{name}`' for name in shares) or 'nothing'))


@mend.require('`package.xml` is in the share folder of the package', see=COPY)
def package_xml(trial: Trial) -> None:
    expect('share/lift/package.xml' in built(trial).installed, '`share/lift/package.xml`', 'it is not there')


@mend.require('there is an executable `lift_node`', see=ENTRY)
def executable(trial: Trial) -> None:
    programs = sorted(name for name in built(trial).installed
                      if name.startswith(('lib/lift/', 'bin/')) and '.' not in name)
    expect(PROGRAM in programs, f'`{PROGRAM}`',
           'there is ' + (', '.join(f'`{name}`' for name in programs) or 'none'))


@mend.require('`ros2 run lift lift_node` starts it', see=ENTRY)
def starts(trial: Trial) -> None:
    said = built(trial).said
    expect(said == READY, f'it says “{READY}”', said.splitlines()[-1] if said else 'it says nothing')


find = Exercise('2b', 'Be `ros2 run`', CHAPTER, FUNCTION, hints=(
    'Go through the prefixes in their order. Ask each whether the package’s marker is in it: '
    '`(prefix / "share/ament_index/resource_index/packages" / package).exists()`.',
    'The first prefix with the marker decides, and no other is looked at. The program is in its '
    '`lib/package/program`, or nowhere.',
    "Two sentences are to be given back as texts: `Package 'lift' not found` after the loop, and "
    '`No executable found` in it.'))


def expect_finds(trial: Trial, spaces: Mapping[str, Sequence[str]], *, because: str = '') -> None:
    """Expect the function to answer as ``ros2 run lift lift_node`` does.

    :param spaces: For each install space, in the order of AMENT_PREFIX_PATH, the files in it.
    """
    with tempfile.TemporaryDirectory(prefix='param_tutorial_') as folder:
        for space, names in spaces.items():
            for name in names:
                path = Path(folder, space, name)
                path.parent.mkdir(parents=True)
                path.touch(0o755)
        prefixes = [Path(folder, space) for space in spaces]
        try:
            wanted, = find_program('lift', 'lift_node', {'AMENT_PREFIX_PATH': os.pathsep.join(map(str, prefixes))})
        except CommandFailed as failure:
            wanted = str(failure)
        given = trial.call('your function', trial.work, 'lift', 'lift_node', prefixes)

    def format_answer(answer: object) -> str:
        return f'`{str(answer).replace(f"{folder}/", "")}`'

    if not isinstance(given, (str, Path)):
        raise NotYet('a path, or a text', f'it gives `{given!r}`')
    expect(str(given) == wanted, f'{format_answer(wanted)}, as `ros2 run` says', f'{format_answer(given)}{because}')


@find.require('a package without a marker is not found, whatever else is there', see=SOURCE)
def no_marker(trial: Trial) -> None:
    expect_finds(trial, {'first': (PROGRAM,)}, because='. Without the marker, ROS does not know of the package')
    expect_finds(trial, {})


@find.require('a program that is there is found', see=BUILD)
def found(trial: Trial) -> None:
    expect_finds(trial, {'first': (MARKER, PROGRAM)})
    expect_finds(trial, {'first': (), 'second': (MARKER, PROGRAM)})


@find.require('a package in which there is no such program is told apart', see=SOURCE)
def no_program(trial: Trial) -> None:
    expect_finds(trial, {'first': (MARKER, OTHER_PROGRAM)})


@find.require('of two install spaces with the package, the first one decides', see=SOURCE)
def overlaid(trial: Trial) -> None:
    expect_finds(trial, {'first': (MARKER, PROGRAM), 'second': (MARKER, PROGRAM)},
                 because='. What was sourced last stands first, and hides the other')
    expect_finds(trial, {'first': (MARKER, OTHER_PROGRAM), 'second': (MARKER, PROGRAM)},
                 because='. `ros2` has found the package in `first`, and looks no further')


order = Exercise('2c', 'Put a terminal in order', CHAPTER, TEXT, hints=(
    'Say for each line what has to be there before it: `source` needs a file that only a build writes.',
    '`colcon build` builds the workspace that the terminal stands in, so the first line goes there. And `ros2 run` '
    'finds only what the terminal has sourced.'))

WORKSPACE = 'ros2_ws'
# What the build of the package would put into its workspace; a real one takes half a minute on a slow machine.
BUILT = {
    f'install/lift/{MARKER}': '',
    f'install/lift/{PROGRAM}': f'#!/bin/sh\necho "{READY}"\n',
    'install/setup.bash': f'export AMENT_PREFIX_PATH="$HOME/{WORKSPACE}/install/lift:$AMENT_PREFIX_PATH"\n',
}
COLCON = """colcon() {
    if [ "$1" = build ] && [ -d src/lift ]; then cp -r ~/.built/install . && echo 'Summary: 1 package finished'
    else echo 'Summary: 0 packages finished'; fi
}"""


class Typed(NamedTuple):
    """What became of lines that were typed in a terminal."""

    said: str
    is_built: bool
    """True if the package is in the install space of its workspace."""
    is_sourced: bool
    """True if the terminal knows the package in the end."""


@functools.lru_cache(maxsize=4)
def type_lines(lines: str) -> Typed:
    """Type lines in a new terminal, beside a workspace with the source of the package.

    :raises WaitTimeoutError: they do not come to an end.
    """
    shell = Shell()
    try:
        Path(shell.home, WORKSPACE, 'src', 'lift').mkdir(parents=True)
        for name, text in BUILT.items():
            path = Path(shell.home, '.built', name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding='utf-8')
            path.chmod(0o755)
        shell.run(COLCON)
        said = shell.run(lines, TIME_LIMIT_SEC)
        known = shell.environment().get('AMENT_PREFIX_PATH', '').split(os.pathsep)
        install = Path(shell.home, WORKSPACE, 'install', 'lift')
        return Typed(said, (install / MARKER).exists(),
                     any(Path(prefix, MARKER).exists() for prefix in known if prefix))
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
        raise NoUse('the lines come to an end', str(error)) from None


@order.require('the package is built, in its workspace', see=BUILD)
def is_built(trial: Trial) -> None:
    done = typed(trial)
    expect(done.is_built, f'`~/{WORKSPACE}/install/lift` is there', 'it is not' + (
        '. `colcon build` builds what is in `src` of the folder in which the terminal stands'
        if '0 packages' in done.said else ''))


@order.require('the terminal knows the package', see=SOURCE)
def is_sourced(trial: Trial) -> None:
    done = typed(trial)
    expect(done.is_sourced, '`AMENT_PREFIX_PATH` of this terminal leads to the package', 'it does not' + (
        '. A file can be sourced only when it is there' if 'setup.bash: No such file' in done.said else ''))


@order.require('`ros2 run lift lift_node` starts the node', see=SOURCE)
def is_running(trial: Trial) -> None:
    said = typed(trial).said
    lines = [line for line in said.splitlines()
             if re.search('not found|No such file|No executable|0 packages', line)]
    expect(READY in said, f'the node says “{READY}”', 'it does not say so' + (
        f'; the terminal says `{lines[0].strip()}`' if lines else ''))


EXERCISES = (order, mend, find)
