"""A file of the reader's as a class of nodes: what Python makes of it, or the line that it does not take.

The file may wait for good where it is imported or makes its node. In a thread of its own, or in the main thread where
there are no others, that is ended after a time, as a callback is on the stage.
"""

import contextlib
import linecache
import sys
import threading
import traceback
import types
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TypeVar

from rclpy.node import Node

from param_tools.errors import ParameterToolError, cause
from param_tools.ros import host, interrupts

T = TypeVar('T')

LIMIT_SEC = 4.0
# A name in each file of the reader's, by which a traceback tells its frames from those of ROS.
READERS = '__my_robot__'


class LoadError(ParameterToolError):
    """A file of the reader's makes no node; the message is a sentence, ``line`` the number of its line, or 0."""

    def __init__(self, message: str, line: int = 0):
        super().__init__(message)
        self.line = line


class _TimeIsUp(BaseException):
    """Ends what does not return. No Exception, lest the file's own ``except Exception`` catches it."""


def load_node_class(path: Path, root: Path) -> type[Node]:
    """Run a file as an import does, and return the class of nodes in it.

    :param root: The folder of its package, from which it may import other files.
    :raises LoadError: Python does not take it, or there is no such class.
    """
    module = types.ModuleType(path.stem)
    module.__file__ = str(path)
    module.__dict__[READERS] = True

    def run() -> None:
        # The file may just have changed.
        linecache.checkcache(str(path))
        with _importable(root):
            exec(compile(path.read_text(encoding='utf-8'), path, 'exec'), module.__dict__)

    within_limit(run, path)
    classes = [each for each in vars(module).values()
               if isinstance(each, type) and issubclass(each, Node) and each.__module__ == module.__name__]
    if not classes:
        raise LoadError(f'{path.name} has no class derived from `Node` yet.')
    return classes[-1]


@contextlib.contextmanager
def _importable(root: Path) -> Iterator[None]:
    """Let ``from my_robot import …`` find the package as it is now."""
    for name in [each for each in sys.modules if each.partition('.')[0] == root.name]:
        del sys.modules[name]
    sys.path.insert(0, str(root))
    try:
        yield
    finally:
        sys.path.remove(str(root))


def within_limit(job: Callable[[], T], path: Path) -> T:
    """Do something that runs a file of the reader's, and end it if it takes too long.

    :raises LoadError: it raised an exception, or was ended.
    """
    results: list[T] = []
    errors: list[BaseException] = []

    def work() -> None:
        try:
            results.append(job())
        except BaseException as error:
            errors.append(error)

    if host.host.has_processes:
        thread = threading.Thread(target=work, name=f'load {path.name}', daemon=True)
        thread.start()
        thread.join(LIMIT_SEC)
        if thread.is_alive() and interrupts.raise_in(thread, _TimeIsUp):
            thread.join(LIMIT_SEC)
        if thread.is_alive():
            frames = traceback.walk_stack(sys._current_frames().get(thread.ident or 0))
            line = [0, *(number for frame, number in frames if frame.f_code.co_filename == str(path))][-1]
            raise LoadError(f'{path.name} waits in line {line}, and cannot be ended: restart the kernel. A constructor '
                            "has to end at once, and `main()` belongs below `if __name__ == '__main__':`.", line)
    else:
        with contextlib.suppress(_TimeIsUp), interrupts.time_limit(LIMIT_SEC, _TimeIsUp):
            work()
    if errors:
        raise describe(errors[0], path) from None
    return results[0]


def describe(error: BaseException, path: Path) -> LoadError:
    """Return an exception as a sentence, with the line of the reader's file that it comes from."""
    if isinstance(error, SyntaxError) and error.filename == str(path):
        line = error.lineno or 0
        end = '' if error.msg.endswith('?') else '.'
        return LoadError(f'{type(error).__name__} in line {line} of {path.name}: {error.msg}{end}', line)
    lines = [number for frame, number in traceback.walk_tb(error.__traceback__)
             if frame.f_code.co_filename == str(path)]
    line = lines[-1] if lines else 0
    where = f' in line {line} of {path.name}' if line else ''
    if isinstance(error, _TimeIsUp):
        return LoadError(f'Something does not return{where}. A constructor has to end at once, and `rclpy.spin` '
                         'belongs in `main`.', line)
    said, why = str(error).rstrip('.'), cause(error)
    words = f'{type(error).__name__}{where}' + (f': {said}.' if said else '.')
    return LoadError(words + (f' {why}.' if why else ''), line)
