"""Exercises of chapter 2: the reader's package says what it needs, its program is built and run; and two small ones
beside it: the lines of an empty terminal, and the line of an entry point."""

import functools
import os
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

from param_tools.cli.run import find_program
from param_tools.cli.session import CommandFailed
from param_tools.errors import ParameterToolError
from param_tools.ros import host
from param_tools.ros.waiting import PATIENCE, wait
from param_tutorial.exercises.exercise import TEXT, Exercise
from param_tutorial.exercises.programs import describe_exception
from param_tutorial.exercises.steps import (
    PACKAGE,
    expect_entry_points,
    needed_packages,
    package_xml,
    remark_elsewhere,
)
from param_tutorial.exercises.trial import NoUse, Trial, expect, take_for_granted
from param_tutorial.learner.package_files import NAME, WORKSPACE, PackageFiles
from param_tutorial.notebook.shell import NO_SHELL, Shell
from param_tutorial.notebook.terminal import Terminal

CHAPTER = '02_workspace'
CREATE = 'Create it'
BUILD = 'Build it'
SOURCE = 'Source it'
ENTRY = 'What a program is called'
EDIT = 'Edit it, and run it'

INDEX = 'share/ament_index/resource_index/packages'
# A slow machine takes a few seconds.
BUILD_LIMIT_SEC = 8.0
LINES_LIMIT_SEC = 6.0


class Built(NamedTuple):
    """The result of a build."""

    complaint: str
    """The last line that the build printed, if it failed; else empty."""
    installed: frozenset[str]
    """Each file in the install space."""
    printed: str
    """What the program has printed, if there is one."""


@functools.lru_cache(maxsize=4)
def build(package: str, program: str, files: tuple[tuple[str, str], ...]) -> Built:
    """Build a package in a scratch workspace, and run a program of it as ``ros2 run`` does.

    setuptools gets the arguments that colcon gives it. colcon itself takes five seconds, and writes a missing marker.

    :param files: The path of each in the package, and its text.
    :raises NoUse: it cannot be built here.
    """
    with tempfile.TemporaryDirectory(prefix='param_tutorial_') as folder:
        root, install = Path(folder, 'src'), Path(folder, 'install')
        for name, text in files:
            root.joinpath(name).parent.mkdir(parents=True, exist_ok=True)
            root.joinpath(name).write_text(text, encoding='utf-8')
        Path(folder, 'build').mkdir()
        # With --root, a `data_files` that begins with a slash stays in the scratch workspace, too.
        status, printed = _build(['setup.py', '-q', 'egg_info', '--egg-base', '../build', 'build', '--build-base',
                                  '../build', 'install', '--root', folder, '--prefix', '/install', '--record',
                                  '../build/record', '--single-version-externally-managed'], root)
        if status:
            last = printed.strip().splitlines()[-1:] or [f'exit status {status}']
            return Built(last[0], frozenset(), '')
        installed = frozenset(str(path.relative_to(install)) for path in install.rglob('*') if path.is_file())
        try:
            path, = find_program(package, program, {'AMENT_PREFIX_PATH': str(install)})
        except CommandFailed:
            return Built('', installed, '')
        modules = next(install.glob('lib/python*/site-packages'), install)
        return Built('', installed, _run(shlex.quote(path), {'PYTHONPATH': str(modules)}))


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


def _run(command: str, variables: dict[str, str] | None = None) -> str:
    """Return what a program prints until it ends, or is ended."""
    terminal = Terminal(command, variables=variables)
    try:
        wait(lambda: not terminal.is_running, LINES_LIMIT_SEC)
    finally:
        terminal.interrupt(LINES_LIMIT_SEC)
    return terminal.text


def expect_program(built: Built, package: str, program: str) -> None:
    """Expect a package to be built, and to have a program.

    :raises NoUse: it is not, or has not.
    """
    if built.complaint:
        raise NoUse('a build without an error', built.complaint)
    programs = sorted(name for name in built.installed if re.match(rf'(lib/{package}|bin)/[^.]+$', name))
    if f'lib/{package}/{program}' not in programs:
        raise NoUse(f'`lib/{package}/{program}`', 'there is ' + (', '.join(f'`{each}`' for each in programs) or 'none'))


# -- 2a and 2d: the reader's package ---------------------------------------------------------------------------------

NEEDED = 'rclpy', 'geometry_msgs', 'sensor_msgs', 'rcl_interfaces'
DRIVES = 'I drive my_robot.'

fill = Exercise('2a', 'Fill in the gaps', CHAPTER, PACKAGE, hints=(
    'Both gaps are marked by a *TODO*. Replace all that stands between the opening and the closing tag.',
    'Each package takes a line, such as `<exec_depend>rclpy</exec_depend>`. They stand below the license, in any '
    'order.'))


def expect_words(trial: Trial, tag: str) -> None:
    """Expect an element with words of the reader's."""
    found = ' '.join((package_xml(trial.work).findtext(tag) or '').split())
    expect('TODO' not in found, f'words of yours in `<{tag}>`', f'it says `{found}`')
    expect(found, f'words in `<{tag}>`', 'it is empty, or missing')


@fill.require('it says what the package is for', see=CREATE)
def has_description(trial: Trial) -> None:
    expect_words(trial, 'description')


@fill.require('it names a license', see=CREATE)
def has_license(trial: Trial) -> None:
    expect_words(trial, 'license')


@fill.require('it names the four packages that the driver needs when it runs', see=CREATE)
def has_dependencies(trial: Trial) -> None:
    root = package_xml(trial.work)
    missing = [each for each in NEEDED if each not in needed_packages(root)]
    expect(not missing, 'an `<exec_depend>` for each', 'there is none for ' + ', '.join(f'`{each}`' for each in missing)
           + remark_elsewhere(root, missing))
    left = [each.text for each in root if (each.text or '').strip().startswith('ament_')]
    expect(not left, 'they replace the three lines with `ament_`',
           'there are still ' + ', '.join(f'`{each}`' for each in left))


says = Exercise('2d', 'What your driver says', CHAPTER, PACKAGE, hints=(
    'The line to change is the one with `print`. What it prints stands in quotes; the rest of the file stays.',
    'Save the file. Then type `colcon build` into the builder, in `~/ros2_ws`, and run this check again.'))


@says.require(f'`ros2 run my_robot driver_node` prints “{DRIVES}”', see=EDIT)
def prints(trial: Trial) -> None:
    files: PackageFiles = trial.work
    package_xml(files)
    source = files.path('driver_node.py')
    if host.host.has_processes:
        texts = {path.relative_to(files.root).as_posix(): path.read_text(encoding='utf-8', errors='replace')
                 for path in files.root.rglob('*') if path.is_file() and '__pycache__' not in path.parts}
        built = build(NAME, 'driver_node', tuple(sorted(texts.items())))
        expect_program(built, NAME, 'driver_node')
        if f'{INDEX}/{NAME}' not in built.installed:
            raise NoUse(f'the marker, `{INDEX}/{NAME}`', 'the build installs none. `data_files` in `setup.py` takes it '
                        f'from `resource/{NAME}`')
        printed = built.printed
    else:
        expect_entry_points(trial, files.root, 'driver_node')
        printed = _run(f'python3 {shlex.quote(str(source))}')
    last = printed.strip().splitlines()[-1:]
    # A traceback may quote it.
    expect(DRIVES in map(str.strip, printed.splitlines()), f'it prints `{DRIVES}`', describe_exception(printed, source)
           or (f'it prints `{last[0]}`' if last else 'it prints nothing'))


@says.require('what you have built is your file as it is now', see=EDIT)
def is_built_anew(trial: Trial) -> None:
    take_for_granted(trial, prints)
    files: PackageFiles = trial.work
    now = files.text('driver_node.py')
    space = files.lessons / WORKSPACE / 'install' / NAME
    expect(space.is_dir() or not host.host.has_processes, f'`~/{WORKSPACE}/install/{NAME}`',
           'it is not there: a build makes it')
    copies = space.rglob('driver_node.py')  # none after `--symlink-install`, when Python reads the file itself
    expect(all(each.read_text(encoding='utf-8') == now for each in copies), 'a copy of it in the install space',
           'the copy there is older. A build replaces it')


# -- 2b: an empty terminal -------------------------------------------------------------------------------------------

type_in = Exercise('2b', 'From an empty terminal', CHAPTER, TEXT, hints=(
    'Ask of each line what it needs. `ros2 run` needs a terminal that has been told where to look, and the file that '
    'tells it is written by a build.',
    'Four lines: `cd` to the workspace, `colcon build`, `source` with the file that the build has written, and '
    '`ros2 run` with the names of package and program.'))

MARKER, PROGRAM = f'{INDEX}/{NAME}', f'lib/{NAME}/driver_node'
# What the build of the package would put into its install space; a real one takes half a minute on a slow machine.
BUILT = {
    f'{NAME}/{MARKER}': '',
    f'{NAME}/{PROGRAM}': '#!/bin/sh\necho started >> "$HOME/.started"\necho "Hi from my_robot."\n',
}
SETUP_FILES = 'setup.bash', 'setup.sh', 'local_setup.bash', 'local_setup.sh'
# As the real one does, it builds what is anywhere below the folder in which it is called, and only what is selected.
COLCON = f"""colcon() {{
    if [ "$1" != build ]; then echo 'colcon: this terminal has the verb build, and no other' >&2; return 2; fi
    if [[ " $* " =~ " --packages-"(select|up-to)" " && " $* " != *" {NAME} "* ]] ||
       [[ " $* " =~ " --packages-"(skip|ignore)" " && " $* " == *" {NAME} "* ]] ||
       [ -z "$(find . -name package.xml)" ]; then
        echo 'Summary: 0 packages finished'; return
    fi
    mkdir -p install build log; cp -r ~/.built/. install
    for name in {' '.join(SETUP_FILES)}; do
        echo "export AMENT_PREFIX_PATH=\\"$PWD/install/{NAME}:\\$AMENT_PREFIX_PATH\\"" > install/$name
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
        source = shell.home / WORKSPACE / 'src' / NAME
        source.mkdir(parents=True)
        (source / 'package.xml').touch()
        for name, text in BUILT.items():
            path = Path(shell.home, '.built', name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding='utf-8')
            path.chmod(0o755)
        shell.run(COLCON)
        printed = shell.run(lines, LINES_LIMIT_SEC)
        known = shell.environment().get('AMENT_PREFIX_PATH', '').split(os.pathsep)
        spaces = sorted(path.parent.relative_to(shell.home) for path in shell.home.rglob('install')
                        if (path / NAME / MARKER).exists())
        in_place = [path for path in spaces if path == WORKSPACE]
        return Typed(printed, str([*in_place, *spaces][0]) if spaces else None,
                     any(Path(prefix, MARKER).exists() for prefix in known if prefix),
                     (shell.home / '.started').exists())
    finally:
        shell.close()


def typed(trial: Trial) -> Typed:
    """Type the reader's lines.

    :raises NoUse: there are none, or they do not come to an end.
    """
    if not trial.work.strip():
        raise NoUse('some lines to type', 'there is none')
    try:
        return type_lines(trial.work)
    except ParameterToolError as error:
        raise NoUse('the lines finish', str(error)) from None


@type_in.require('the package is built, in its workspace', see=BUILD)
def is_built(trial: Trial) -> None:
    done = typed(trial)
    if done.built_in != str(WORKSPACE):
        happened = 'it is not there'
        if done.built_in:
            folder = '~' if done.built_in == '.' else f'~/{done.built_in}'
            happened += f', but in `{folder}/install`: `colcon build` writes into the folder in which you call it'
        elif '0 packages' in done.printed:
            happened += ': `colcon build` has found no package that it should build'
        raise NoUse(f'`~/{WORKSPACE}/install/{NAME}`', happened)


@type_in.require('the terminal knows the package', see=SOURCE)
def is_sourced(trial: Trial) -> None:
    done = typed(trial)
    if not done.is_sourced:
        raise NoUse('`AMENT_PREFIX_PATH` of this terminal leads to the package', 'it does not' + (
            '. You can source a file only when it is there' if 'setup.bash: No such file' in done.printed else ''))


@type_in.require('`ros2 run my_robot driver_node` starts the program', see=SOURCE)
def is_running(trial: Trial) -> None:
    done = typed(trial)
    complaints = [line.strip() for line in done.printed.splitlines() if re.search('not found|No executable', line)]
    expect(done.is_started, 'the program starts', 'it does not start' + (
        f'; the terminal says `{complaints[0]}`' if complaints else ''))


# -- 2c: an entry point ----------------------------------------------------------------------------------------------

name_it = Exercise('2c', 'One line for a lift', CHAPTER, TEXT, hints=(
    'An entry point has three parts: `program = package.module:function`. What you type after `ros2 run lift` is the '
    'first of them.',
    'The module is the file without its ending, and the package comes first: `lift.cabin`.'))

UP = 'The lift goes up.'
LIFT = {
    'setup.cfg': '[develop]\nscript_dir=$base/lib/lift\n[install]\ninstall_scripts=$base/lib/lift\n',
    'resource/lift': '',
    'lift/__init__.py': '',
    'lift/cabin.py': f"def start():\n    print('{UP}')\n\n\ndef stop():\n    print('The lift stops.')\n",
}
SETUP = """from setuptools import setup

setup(
    name='lift',
    version='0.0.0',
    packages=['lift'],
    data_files=[('share/ament_index/resource_index/packages', ['resource/lift'])],
    entry_points={{'console_scripts': [{!r}]}},
)
"""


def lift(trial: Trial) -> Built:
    """Build a lift with the reader's line.

    :raises NoUse: there is no line, or none can be built.
    """
    line = trial.work.strip().rstrip(',').strip('\'"')
    if not line:
        raise NoUse('a line', 'there is none')
    if not re.fullmatch(r'[\w.-]+ *= *[\w.]+ *: *\w+', line):  # what setuptools says of it differs with its version
        raise NoUse('a line such as `program = package.module:function`', f'it is `{line}`')
    return build('lift', 'go_up', tuple({**LIFT, 'setup.py': SETUP.format(line)}.items()))


@name_it.require('the package builds', see=ENTRY)
def builds(trial: Trial) -> None:
    if complaint := lift(trial).complaint:
        raise NoUse('a build without an error', complaint)


@name_it.require('there is a program `go_up`', see=ENTRY)
def has_program(trial: Trial) -> None:
    expect_program(lift(trial), 'lift', 'go_up')


@name_it.require('`ros2 run lift go_up` calls the function `start` in `lift/cabin.py`', see=ENTRY)
def calls_start(trial: Trial) -> None:
    printed = lift(trial).printed
    last = printed.strip().splitlines()[-1:] or ['nothing']
    expect(UP in printed, f'it prints `{UP}`, as `start` does', f'it prints `{last[0]}`')


EXERCISES = (fill, type_in, name_it, says)
