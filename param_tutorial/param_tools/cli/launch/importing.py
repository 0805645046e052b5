"""Running the Python code of a launch file: while it runs, and no longer, ``import launch`` finds our own classes.

``reading`` fills the two tables, so that an action can read another launch file, or call a function of one.
"""

import contextlib
import re
import sys
import traceback
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from types import ModuleType
from typing import Any

from param_tools.cli.index import provided_packages_installed
from param_tools.cli.launch.context import PACKAGE, LaunchFailed, Origin, blaming, reject
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


# What options of nodes were called up to Foxy.
_RENAMED = {'node_executable': 'executable', 'node_name': 'name', 'node_namespace': 'namespace',
            'node_plugin': 'plugin'}


@contextlib.contextmanager
def running(what: str) -> Iterator[None]:
    """Let Python code of a launch file import MODULES and find the provided packages; explain its exceptions.

    :param what: What the code is.
    """
    with provided_packages_installed(), _importable():
        try:
            yield
        except CommandFailed as error:
            if isinstance(error, LaunchFailed):
                error.origin = error.origin or _origin(error)
            raise
        except Exception as error:
            with blaming(_origin(error)):
                raise LaunchFailed(_explanation(error, what)) from error


def _packages() -> dict[str, None]:
    return dict.fromkeys(name.partition('.')[0] for name in MODULES)


def _explanation(error: Exception, what: str) -> str:
    hint = ''
    old = re.search("unexpected keyword argument '(node_\\w+)'", str(error))
    if old and old[1] in _RENAMED:
        hint = f'. ROS 2 has called it {_RENAMED[old[1]]}= since Galactic, and launch rejects the old name'
    # A package of ROS, or an option such as Node(cached_output=True).
    elif isinstance(error, ModuleNotFoundError) or 'unexpected keyword argument' in str(error):
        hint = '. Where that is right, the genuine `ros2 launch` has it (environment/README.md)'
    origin = _origin(error)
    place = f' ({origin.file.name}, line {origin.line})' if origin else ''
    return f'Caught exception when trying to load {what}: {type(error).__name__}: {error}{place}{hint}'


def _origin(error: Exception) -> Origin | None:
    """Return the line of the launch file that has raised an exception; None if the message says it, as of a typo."""
    lines = [each for each in traceback.extract_tb(error.__traceback__)
             if not Path(each.filename).is_relative_to(PACKAGE)]
    own = [each for each in lines if each.filename == lines[0].filename]
    return Origin(Path(own[-1].filename), own[-1].lineno) if own else None


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
