"""Running the Python code of a launch file: while it runs, and no longer, ``import launch`` finds our own classes.

``reading`` fills the two tables, so that an action can read another launch file, or call a function of one.
"""

import contextlib
import sys
import traceback
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from types import ModuleType
from typing import Any

from param_tools.cli.index import provided_packages_installed
from param_tools.cli.launch.context import PACKAGE, LaunchFailed, reject
from param_tools.cli.session import CommandFailed

# The modules, and the names in each, that a launch file may import and use.
MODULES: dict[str, Mapping[str, Any]] = {}
# What reads a launch file and returns its description, by the end of the file's name.
READERS: dict[str, Callable[[Path], Any]] = {}


def read(path: Path) -> Any:
    """Read a launch file, and return what it describes."""
    if not path.is_file():
        raise LaunchFailed(f'there is no launch file {path}')
    if path.suffix not in READERS:
        raise LaunchFailed(f'{path.name} is no launch file in Python, XML or YAML, by the end of its name')
    return READERS[path.suffix](path)


@contextlib.contextmanager
def running(what: str) -> Iterator[None]:
    """Let Python code of a launch file import MODULES and find the provided packages; explain its exceptions.

    :param what: What the code is.
    """
    with provided_packages_installed(), _importable():
        try:
            yield
        except CommandFailed:
            raise
        except Exception as error:
            raise LaunchFailed(_explanation(error, what)) from error


def _packages() -> dict[str, None]:
    return dict.fromkeys(name.partition('.')[0] for name in MODULES)


def _explanation(error: Exception, what: str) -> str:
    hint = ''
    # A package of ROS, or an option such as Node(sigterm_timeout='1').
    if isinstance(error, ModuleNotFoundError) or 'unexpected keyword argument' in str(error):
        hint = '. Where that is right, the genuine `ros2 launch` has it (environment/README.md)'
    return f'Caught exception when trying to load {what}: {type(error).__name__}: {error}{_place(error)}{hint}'


def _place(error: Exception) -> str:
    """Return the line of the launch file that has raised an exception; empty if the message says it, as of a typo."""
    lines = [each for each in traceback.extract_tb(error.__traceback__)
             if not Path(each.filename).is_relative_to(PACKAGE)]
    own = [each for each in lines if each.filename == lines[0].filename]
    return f' ({Path(own[-1].filename).name}, line {own[-1].lineno})' if own else ''


@contextlib.contextmanager
def _importable() -> Iterator[None]:
    """Let the imports of a launch file find MODULES, and no installed ``launch``."""
    outer = {name: module for name, module in sys.modules.items() if name.partition('.')[0] in _packages()}
    for name in outer:
        del sys.modules[name]
    for name, names in MODULES.items():
        sys.modules[name] = _module(name, names)
        package, _, part = name.rpartition('.')
        if package:
            setattr(sys.modules[package], part, sys.modules[name])
    try:
        yield
    finally:
        for name in [name for name in sys.modules if name.partition('.')[0] in _packages()]:
            del sys.modules[name]
        sys.modules.update(outer)


def _module(name: str, names: Mapping[str, Any]) -> ModuleType:
    module = ModuleType(name, f'The part of {name} that the embedded ros2 launch has.')
    module.__path__ = []
    module.__dict__.update(names)

    def left_out(wanted: str) -> type:
        """Return a class that a launch file may import, for the types of its functions, and not use."""
        # The import system asks for these of any module.
        if wanted.startswith('__'):
            raise AttributeError(wanted)
        return type(wanted, (), {'__init__': lambda *_, **_options: reject(f'{name}.{wanted}')})

    # PEP 562: what a module has under this name is asked for names that it lacks.
    module.__dict__['__getattr__'] = left_out
    return module
