"""Programs where no process can be started, as in a web page: each runs in this one, as a loop of the host.

A program's file is run as it is written, with one change: where it waits in a ``spin`` of rclpy, everything else gets
its turn. Python's own coroutines do that: ``rclpy.spin(node)`` is compiled as ``await``, and a function that spins as
``async def``. So its ``try``, ``except`` and ``finally`` do what they do in a process. What a process has for itself is
in place while its program runs: arguments, output, handlers of signals, rclpy's default context and with it
``--ros-args``, and logging. A signal comes while the program spins. At its end, its nodes leave the graph.

All programs share what else there is: imported modules, and after the start the environment and the current folder.
They have no threads. What waits in any other way (``time.sleep``, ``Client.call``) lets everything go on but the cell.
Only Python files, the programs of provided packages, and the embedded ``ros2`` run so.
"""

import ast
import contextlib
import importlib.util
import inspect
import itertools
import math
import os
import signal
import sys
import time
import traceback
import types
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, Protocol

import rclpy
from rclpy.executors import Executor, ExternalShutdownException

from param_tools.errors import NoProcessError
from param_tools.rcl_in_python import processes as layer
from param_tools.ros import rclpy_private
from param_tools.ros.environment import provided_packages
from param_tools.ros.host import Loop
from param_tools.ros.processes import Output
from param_tools.ros.waiting import Steps, wait

# A program that always has something to do may run so many callbacks in a turn.
_CALLBACKS = 50
_SPINS = frozenset({'spin', 'spin_once', 'spin_until_future_complete'})
_SPIN = '__spin_in_turns__'
_numbers = itertools.count(1)
# What SIGKILL has stopped: to let go of it would run its ``finally``.
_killed: list[Steps] = []


class Turns(Protocol):
    """What a program needs of the host."""

    program: 'Program | None'
    """That whose surroundings are in place; None for what runs in none."""

    def loop_within(self, program: 'Program', step: Callable[[float], bool], is_over: Callable[[], bool]) -> Loop:
        """Return a loop that calls a function again and again, in a program's surroundings."""

    def within(self, program: 'Program') -> contextlib.AbstractContextManager[None]:
        """Put a program's surroundings into place in this block."""


class Program:
    """A program that runs in this process."""

    def __init__(self, turns: Turns, arguments: Sequence[str], make: Callable[[], Steps], output: Output | None, *,
                 environment: Mapping[str, str], folder: Path | None, ends_quietly: bool):
        """Run it to its first wait.

        :param make: Called in its surroundings; returns what it does, step by step.
        :param output: Takes what it prints. Without it, it prints where its parent does, and hears of its signals.
        :param ends_quietly: After a signal, nothing that it raises is an error.
        """
        self._output, self._ends_quietly = output, ends_quietly
        self._status: int | None = None
        self._came: list[int] = []
        self._has_heard = False
        self._group: list[Program] = []
        self._condition: Callable[[], object] = _always
        self._handlers: dict[int, Any] = {signal.SIGINT: signal.default_int_handler}
        if ends_quietly:
            self._handlers = {signal.SIGINT: _ignore, signal.SIGTERM: _ignore}
        if output is None and turns.program is not None:
            turns.program._group.append(self)
        if output is not None:
            output.began(next(_numbers))
        with _started_in(environment, folder):
            self._places = self._surroundings(arguments)
            with turns.within(self):
                self._steps = make()
                self._resume(self._steps.__next__)
        turns.loop_within(self, self._step, lambda: self._status is not None).start()

    def _surroundings(self, arguments: Sequence[str]) -> list[tuple[Any, str, Any]]:
        """Return where a process has something of its own: an object, the name of an attribute, and its value."""
        stdout: Any = sys.stdout
        stderr: Any = sys.stderr
        if self._output is not None:
            stdout = _Lines(self._output.show)
            stderr = stdout if self._output.show_err is None else _Lines(self._output.show_err)
        return [(sys, 'argv', list(arguments)), (sys, 'stdout', stdout), (sys, 'stderr', stderr),
                (sys, 'path', [str(Path(arguments[0]).parent), *sys.path]),
                (signal, 'signal', self._set_handler), (signal, 'getsignal', self._handlers.get),
                *rclpy_private.process_globals(), *layer.process_globals()]

    def swap(self) -> None:
        """Put the program's surroundings into place, and keep what was there; or the other way round."""
        before = [(owner, name, getattr(owner, name)) for owner, name, _ in self._places]
        for owner, name, value in self._places:
            setattr(owner, name, value)
        self._places = before

    def _set_handler(self, number: int, handler: Any) -> Any:
        before, self._handlers[number] = self._handlers.get(number, signal.SIG_DFL), handler
        return before

    # -- steps ----------------------------------------------------------------------------------------------------

    def _step(self, _wait_sec: float) -> bool:
        """Take a step if there is anything to do."""
        if self._came:
            self._hear(self._came.pop(0))
        elif self._condition():
            self._resume(self._steps.__next__)
        return False

    def _hear(self, number: int) -> None:
        """Do what a signal does."""
        handler = self._handlers.get(number, signal.SIG_DFL)
        self._has_heard = True
        if number == signal.SIGKILL or handler is signal.SIG_DFL:
            _killed.append(self._steps)
            self._end(-number)
        elif handler is not signal.SIG_IGN:
            try:
                handler(number, None)
            except BaseException as error:
                raised = error
                self._resume(lambda: self._steps.throw(raised))

    def _resume(self, step: Callable[[], Callable[[], object]]) -> None:
        """Let the program go on to its next wait, or to its end."""
        try:
            self._condition = step()
        except StopIteration as end:
            self._end(end.value)
        except SystemExit as end:
            if isinstance(end.code, str):
                print(end.code, file=sys.stderr)
            self._end(end.code if isinstance(end.code, int) else int(end.code is not None))
        except BaseException as error:
            if self._has_heard and self._ends_quietly and isinstance(error, Exception):
                self._end(0)
                return
            traceback.print_exception(type(error), error, _own_part(error.__traceback__))
            self._end(-signal.SIGINT if isinstance(error, KeyboardInterrupt) else 1)

    def _end(self, status: int) -> None:
        layer.end()
        sys.stdout.flush()
        sys.stderr.flush()
        self._status = status
        if self._output is not None:
            self._output.ended(status)

    # -- as seen by the one who started it --------------------------------------------------------------------------

    def poll(self) -> int | None:
        return self._status

    def send(self, number: int) -> None:
        for each in (self, *self._group):
            each._came.append(number)

    def wait(self, timeout_sec: float) -> bool:
        return wait(lambda: self._status is not None, timeout_sec)


def start(turns: Turns, command: Sequence[str], output: Output | None, *, environment: Mapping[str, str] | None,
          folder: Path | None, instead: Callable[[], Steps] | None) -> Program:
    """Run a command as a program in this process.

    :raises NoProcessError: it is none that can run here.
    """
    make, arguments, ends_quietly = instead, list(command), False
    is_python = command[0] == sys.executable or Path(command[0]).stem.startswith('python')
    if make is None and command[0] == sys.executable and command[1:2] == ['-m']:
        package, name, *rest = command[2:]
        if package in provided_packages().values():
            make, arguments, ends_quietly = lambda: _module(package, name), [package, *rest], True
    elif make is None and is_python and command[1].endswith('.py'):
        make, arguments = lambda: _run(Path(command[1]), '__main__', None), list(command[1:])
    if make is None:
        raise NoProcessError(f'There are no processes in a web page, and {Path(command[0]).name!r} needs one: only '
                             f'ros2, its programs of this course, and files in Python run here')
    return Program(turns, arguments, make, output, environment=os.environ if environment is None else environment,
                   folder=folder, ends_quietly=ends_quietly)


def _always() -> bool:
    return True


def _ignore(*_: object) -> None:
    """Do nothing about a signal, but what rclpy does."""


def _own_part(step: types.TracebackType | None) -> types.TracebackType | None:
    """Return the part of a traceback that is about the program, and not about how it is run."""
    here = _own_part.__code__.co_filename  # __file__ differs where a module comes without its source
    while step is not None and step.tb_next is not None and step.tb_frame.f_code.co_filename == here:
        step = step.tb_next
    return step


@contextlib.contextmanager
def _started_in(environment: Mapping[str, str], folder: Path | None) -> Iterator[None]:
    """Let what starts in this block have an environment and a current folder."""
    before, folder_before = dict(os.environ), Path.cwd()
    os.environ.clear()
    os.environ.update(environment if environment is not os.environ else before)
    os.chdir(folder or folder_before)
    try:
        yield
    finally:
        os.environ.clear()
        os.environ.update(before)
        os.chdir(folder_before)


class _Lines:
    """A stream that passes on whole lines."""

    encoding, errors = 'utf-8', 'replace'

    def __init__(self, show: Callable[[str], object]):
        self._show, self._rest = show, ''

    def write(self, text: str) -> int:
        *lines, self._rest = (self._rest + text).split('\n')
        for line in lines:
            self._show(f'{line}\n')
        return len(text)

    def flush(self) -> None:
        """Pass on what is no whole line."""
        if self._rest:
            rest, self._rest = self._rest, ''
            self._show(rest)

    def isatty(self) -> bool:
        return False


# -- Python files -------------------------------------------------------------------------------------------------

def _module(package: str, name: str) -> Steps:
    """Run the function ``main`` of a module of a package."""
    found = importlib.util.find_spec(f'{package}.{name}')
    if found is None or found.origin is None:
        raise ModuleNotFoundError(f'No module named {package}.{name}')
    return _run(Path(found.origin), f'{package}.{name}', package)


def _run(path: Path, name: str, package: str | None) -> Steps:
    module = types.ModuleType(name)
    module.__dict__.update({'__file__': str(path), '__package__': package, _SPIN: _spin})
    code = _compiled(path.read_text(encoding='utf-8'), str(path), calls_main=package is not None)
    done = eval(code, module.__dict__)
    if done is not None:
        yield from done.__await__()
    return 0


def _compiled(source: str, path: str, *, calls_main: bool) -> types.CodeType:
    """Compile a program, with each spin that it comes to outside callbacks and classes as a wait for its turn."""
    tree = ast.parse(source, path)
    if calls_main:
        tree.body.append(ast.Expr(ast.Call(ast.Name('main', ast.Load()), [], [])))
    functions = {each.name: each for each in tree.body if isinstance(each, ast.FunctionDef)}
    spinning: set[str] = set()
    while more := {name for name, function in functions.items() if name not in spinning and any(
            _spins(each, spinning) for each in ast.walk(function))}:
        spinning |= more
    tree = ast.fix_missing_locations(_Awaiting(spinning).visit(tree))
    code: types.CodeType = compile(tree, path, 'exec', ast.PyCF_ALLOW_TOP_LEVEL_AWAIT, dont_inherit=True)
    return code


def _spins(node: ast.AST, functions: set[str]) -> bool:
    """True for a call that spins, by rclpy or by one of these functions."""
    if not isinstance(node, ast.Call):
        return False
    called = node.func
    return (called.attr in _SPINS if isinstance(called, ast.Attribute) else
            isinstance(called, ast.Name) and called.id in {*_SPINS, *functions})


class _Awaiting(ast.NodeTransformer):
    def __init__(self, functions: set[str]):
        self._functions = functions

    def visit_Call(self, node: ast.Call) -> ast.AST:
        self.generic_visit(node)
        if not _spins(node, self._functions):
            return node
        if not (isinstance(node.func, ast.Name) and node.func.id in self._functions):
            node.args.insert(0, node.func)
            node.func = ast.Name(_SPIN, ast.Load())
        return ast.copy_location(ast.Await(node), node)

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.AST:
        if node.name not in self._functions:
            return node
        self.generic_visit(node)
        return ast.copy_location(ast.AsyncFunctionDef(**{name: getattr(node, name) for name in node._fields}), node)

    def visit_ClassDef(self, node: ast.ClassDef) -> ast.AST:
        return node

    def visit_Lambda(self, node: ast.Lambda) -> ast.AST:
        return node


async def _spin(function: Callable[..., Any], *args: Any, **options: Any) -> Any:
    """Do what a function of rclpy does that spins, and give turns while nothing is due."""
    executor = getattr(function, '__self__', None)
    if not isinstance(executor, Executor) and getattr(function, '__module__', '') != 'rclpy':
        return function(*args, **options)  # somebody's own function of this name
    given = inspect.signature(function).bind(*args, **options).arguments
    node: Any = given.get('node')
    future, timeout = given.get('future'), given.get('timeout_sec')
    if not isinstance(executor, Executor):
        executor = given.get('executor') or rclpy.get_global_executor()
    end = math.inf if timeout is None or timeout < 0 else time.monotonic() + timeout
    is_added = node is not None and executor.add_node(node)
    try:
        for number in itertools.count(1):
            if not executor.context.ok() or (future and future.done()):
                return None
            has_run = _run_next(executor)
            if time.monotonic() >= end or (has_run and function.__name__ == 'spin_once'):
                return None
            if not has_run or number % _CALLBACKS == 0:
                await _turn()
                if not executor.context.ok():
                    raise ExternalShutdownException
    finally:
        if is_added:
            executor.remove_node(node)


@types.coroutine
def _turn() -> Generator[Callable[[], object], None, None]:
    """Let everything else have its turn."""
    yield _always


def _run_next(executor: Any) -> bool:
    """Run the next callback that is due, and return whether there was one."""
    found = []
    wait_for_ready_callbacks = executor.wait_for_ready_callbacks

    def note(*args: Any, **options: Any) -> Any:
        found.append(wait_for_ready_callbacks(*args, **options))
        return found[0]

    executor.wait_for_ready_callbacks = note
    try:
        executor.spin_once(timeout_sec=0.0)
    finally:
        del executor.wait_for_ready_callbacks
    return bool(found)
