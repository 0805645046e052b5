"""Whole programs as answers: a check starts the file as ``python3 FILE`` does, asks its node, and ends it by a signal.

The program runs in a process of its own or, in a web page, as ``param_tools.ros.programs`` says. Its node is put into a
namespace by words after ``--ros-args``, so the program has to read them, as every program of ROS does.
"""

import ast
import contextlib
import itertools
import re
import runpy
import shlex
import signal
import sys
import traceback
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple, cast

import rclpy

from param_tools.errors import NodeError, WaitTimeoutError
from param_tools.ros.waiting import wait, wait_until
from param_tutorial.exercises.exercise import Exercise, Kind
from param_tutorial.exercises.trial import CORNER, GROUP_IS_BUSY, STUCK, NotYet, NoUse, Trial, expect, moved_to
from param_tutorial.notebook.terminal import Terminal

PROGRAM = Kind('the name of the file that the cell above writes, in quotes',
               lambda work: isinstance(work, (str, Path)) and Path(work).suffix == '.py', "'my_program.py'")

# How long a program may take until its node is there, how long a node after another one, and an end.
# Importing rclpy takes seconds on a slow machine.
START_SEC, LATER_SEC, END_SEC = 15.0, 2.0, 10.0
# How often a program may lose a race that is rclpy's own.
_TIMES = 3
_SPINS = {'spin', 'spin_once', 'spin_until_future_complete'}
# What to think of when a program ends with one of these.
_REMARKS = {
    'NotInitializedException': 'Call `rclpy.init()` before you make the node',
    'already called': 'When a signal comes, rclpy shuts down by itself: leave `rclpy.shutdown()` out',
    'KeyboardInterrupt': 'That is what Ctrl+C raises in `rclpy.spin`: catch it there',
    'ExternalShutdownException': 'That is what SIGTERM raises in `rclpy.spin`: import it from `rclpy.executors`, and '
                                 'catch it there',
    '_TimeIsUp': 'It was still running after some seconds without a `spin`, and in a page nothing else runs meanwhile',
}
# A node that a killed program leaves in the graph for some seconds must not be taken for the next one.
_numbers = itertools.count(1)


class Program(NamedTuple):
    """A learner's program that runs, and whose node answers."""

    terminal: Terminal
    node: str
    """The node's full name."""
    namespace: str
    """The node's namespace within the corner, as ``Trial.start`` takes it."""


def _start_file(trial: Trial, words: str) -> Terminal:
    """Start the learner's file with Python.

    :raises NoUse: there is none, or nothing in it, or it is no Python.
    """
    path = Path(trial.work)
    if not path.is_file():
        raise NoUse(f'a file `{path}`', 'there is none beside this notebook: run the cell above, which writes it')
    try:
        body = _parsed(path).body
    except SyntaxError as error:
        raise NoUse('a file that Python can read', f'{type(error).__name__}: {error.msg}, in line {error.lineno}, '
                    f'`{(error.text or "").strip()}`') from None
    if not body:
        raise NoUse('a whole program, from its imports to its last line', 'there is nothing in the file yet')
    # A page's Python has no program of its own. There the learner's runs in this thread, up to its first `spin`.
    python = sys.executable if Path(sys.executable).stem.startswith('python') else 'python3'
    command = f'{shlex.join([python, str(path.resolve())])} {words}'
    return cast(Terminal, trial.call('the program', Terminal, command))


@contextlib.contextmanager
def running(trial: Trial, exercise: Exercise, words: str = '') -> Iterator[Program]:
    """Start the learner's program, and end it after the block.

    :param words: More words after ``--ros-args``.
    :raises NoUse: there is none, or its node doesn't come, or doesn't answer.
    """
    namespace = f'/program_{next(_numbers)}'
    remapped = ' '.join(f'-r {rule}' for rule in moved_to(f'{CORNER}{namespace}'))
    before = Counter(trial.ros.services.node_names(hidden=True))
    terminal = _start_file(trial, f'--ros-args {remapped} {words}')
    file = _source_file(trial, exercise)
    try:
        name = _wait_for_node(trial, exercise, terminal, f'{CORNER}{namespace}/', before)
        trial.names.add(name.rpartition('/')[2])
        # A node has its name before its services are discovered, and a busy machine takes its time.
        trial.ros.services.find(name, 'list_parameters', START_SEC)
        trial.client(name).list_parameters()
        yield Program(terminal, name, namespace)
    except NodeError as error:
        # What ended the program explains more than what came of it.
        if wait(lambda: not terminal.is_running, LATER_SEC):
            raise NoUse('a program that goes on', describe_end(terminal, file)) from None
        tree = _parsed(file)
        remark = STUCK if _spins(tree) else 'Nothing spins it'
        if any(isinstance(each, ast.Await) for each in ast.walk(tree)):
            remark = f'Does it wait at an `await`? {GROUP_IS_BUSY}'
        raise NoUse('an answer', f'{error}. {remark}'.replace(namespace, '')) from None
    except NotYet as error:
        raised = '' if terminal.is_running else describe_exception(terminal.text, file)
        if raised and raised not in error.happened:
            raise NoUse('a program that goes on', raised) from None
        logger = f'{CORNER[1:]}.{namespace[1:]}.'
        raise type(error)(*(text.replace(namespace, '').replace(logger, '')
                            for text in (error.expected, error.happened))) from None
    finally:
        terminal.interrupt(END_SEC)


def _wait_for_node(trial: Trial, exercise: Exercise, terminal: Terminal, prefix: str, before: Counter[str]) -> str:
    """Return the full name of the program's node, preferably the one that the exercise asks for."""
    wanted, outside = f'{prefix}{exercise.node_name}', f'/{exercise.node_name}'

    def new() -> list[str]:
        names = Counter(trial.ros.services.node_names(hidden=True)) - before
        return sorted(each for each in names if each.startswith(prefix) or each == outside)

    with contextlib.suppress(WaitTimeoutError):
        wait_until(lambda: new() or not terminal.is_running, 'a node', START_SEC)
        if not trial.names - {exercise.node_name}:  # it had another name the last time
            wait_until(lambda: wanted in new() or not terminal.is_running, 'the node', LATER_SEC)
    if not terminal.is_running:
        raise NoUse('a program that goes on until a signal ends it',
                    describe_end(terminal, _source_file(trial, exercise)))
    found = new()
    if not found:
        raise NoUse('a node', f'none has come after {START_SEC:g} s, and the program still runs')
    if outside in found:
        raise NoUse('a node that obeys the words after `--ros-args`', 'it was started with `-r __ns:=…`, and has no '
                    'namespace. Does `rclpy.init()` get arguments other than those of the program?')
    return wanted if wanted in found else found[0]


def require_program(exercise: Exercise, file: str, see: str) -> None:
    """Add the requirement that the program starts, and that an import of its file doesn't start it."""
    @exercise.require(f'`python3 {file}` starts a node that answers', see=see)
    def starts(trial: Trial) -> None:
        with running(trial, exercise):
            pass
        _expect_quiet_import(trial)


class _Starts(BaseException):
    """Ends an import. No Exception, lest the file's own ``except Exception`` catches it."""


def _expect_quiet_import(trial: Trial) -> None:
    """Expect the learner's file not to connect to ROS when it is imported."""
    def start(*_: object, **__: object) -> None:
        raise _Starts

    path, init = str(trial.work), rclpy.init
    rclpy.init = start
    try:
        trial.call('an import', runpy.run_path, path)
    except _Starts as error:
        number = next(number for frame, number in traceback.walk_tb(error.__traceback__)
                      if frame.f_code.co_filename == path)
        raise NotYet('another file can import it, and nothing starts',
                     f'`{Path(path).read_text(encoding="utf-8").splitlines()[number - 1].strip()}` in line {number} '
                     "starts ROS then, too. `if __name__ == '__main__':` goes above it") from None
    except NotYet:
        pass  # a file beside it, for one, that only a program finds
    finally:
        rclpy.init = init


def require_ends(exercise: Exercise, see: str) -> None:
    """Add two requirements: that each of the two signals that end programs ends this one in peace."""
    @exercise.require('Ctrl+C ends it, without a traceback', see=see)
    def interrupted(trial: Trial) -> None:
        _expect_end(trial, exercise, signal.SIGINT)

    @exercise.require('SIGTERM, which `docker stop` sends, ends it without a traceback too', see=see)
    def terminated(trial: Trial) -> None:
        _expect_end(trial, exercise, signal.SIGTERM)


def _expect_end(trial: Trial, exercise: Exercise, number: signal.Signals) -> None:
    # rclpy's handler of signals shuts the context down in a thread of its own. Now and then that comes in the middle of
    # a `spin` or a `try_shutdown`, which then raises an RCLError through no fault of its caller.
    for left in reversed(range(_TIMES)):
        with running(trial, exercise) as program:
            # In the middle of a callback, a signal lets `spin` return in peace, and no exception has to be caught.
            program.terminal.wait_until_idle(LATER_SEC)
            # rclpy 7.1.6 goes on after one SIGTERM in twenty-five: its executor wakes before the context is shut down,
            # and waits again. The next signal ends it.
            status = program.terminal.interrupt(END_SEC, number, times=2)
            expect(status != -signal.SIGKILL, f'{number.name} ends it', f'it was still running {END_SEC:g} s later')
            raised = describe_exception(program.terminal.text, _source_file(trial, exercise))
            if not left or 'RCLError' not in raised:
                expect(not raised, f'{number.name} ends it without a traceback', raised)
                expect(status in (0, -number, 128 + number), f'{number.name} ends it with exit status 0',
                       f'its exit status is {status}, which stands for an error')
                return


# -- what a program says of itself ------------------------------------------------------------------------------------

def _source_file(trial: Trial, exercise: Exercise) -> Path:
    """Return the program's file; in a package, that of its node."""
    work = Path(trial.work)
    return next(work.rglob(f'{exercise.node_name}_node.py'), work) if work.is_dir() else work


def _parsed(file: Path) -> ast.Module:
    return ast.parse(file.read_text(encoding='utf-8')) if file.is_file() else ast.Module([], [])


def describe_end(terminal: Terminal, file: Path) -> str:
    """Return how a program has ended without a signal.

    :param file: Its source.
    """
    status, lines = terminal.interrupt(), terminal.text.strip().splitlines()
    why = f'. Its last line is `{lines[-1]}`' if lines else ''
    if not status:
        why = _why_it_ends(_parsed(file), file.name in terminal.command)
    return describe_exception(terminal.text, file) or f'it ended with exit status {status}{why}'


def describe_exception(text: str, file: Path) -> str:
    """Return the exception that ended a program, with the line of its file; nothing if none did.

    :param text: What the program has printed.
    """
    _, found, after = text.rpartition('Traceback (most recent call last):\n')
    if not found:
        return ''
    raised = next((line for line in after.splitlines() if line[:1].strip()), 'an exception')
    own = re.findall(rf'^  File ".*?{re.escape(file.name)}", line (\d+).*\n +(.*)', after, re.MULTILINE)
    where = ', in line {}, `{}`'.format(*own[-1]) if own else ''
    remark = next((f'. {words}' for word, words in _REMARKS.items() if word in raised), '')
    return f'it ended with `{raised}`{where}{remark}'


def _names(tree: ast.AST) -> set[str]:
    """Return each name and each attribute in a tree."""
    return {each.attr if isinstance(each, ast.Attribute) else each.id
            for each in ast.walk(tree) if isinstance(each, (ast.Attribute, ast.Name))}


def _spins(tree: ast.AST) -> bool:
    return bool(_names(tree) & _SPINS)


def _why_it_ends(tree: ast.Module, is_started_itself: bool) -> str:
    """Return what to think of when a program ends without an error and without a signal.

    :param is_started_itself: True for a file that Python runs; in a package, an entry point calls one of its functions.
    """
    if not _spins(tree):
        return '. Nothing spins the node, so the program ends after its last line'
    if _names(tree) & _SPINS == {'spin_once'}:
        return '. `spin_once` waits for one callback. `spin` goes on'
    used = {each.id for each in ast.walk(tree) if isinstance(each, ast.Name)}
    texts = {each.value for each in ast.walk(tree) if isinstance(each, ast.Constant)}
    unused = [each.name for each in tree.body if isinstance(each, ast.FunctionDef) and each.name not in used]
    if unused and is_started_itself:
        return f'. Nothing calls `{unused[0]}()`'
    if '__name__' in used and '__main__' not in texts:
        return ". The name to compare with is `'__main__'`, with two underscores on each side"
    return ''
