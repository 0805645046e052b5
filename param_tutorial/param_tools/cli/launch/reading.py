"""Reading a launch file: while it runs, and no longer, ``import launch`` finds the classes of this package."""

import contextlib
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any, NoReturn

from param_tools.cli.index import provided_packages_installed
from param_tools.cli.launch import actions, parameters, substitutions
from param_tools.cli.launch.actions import LaunchDescription
from param_tools.cli.launch.context import FULL_INSTALLATION, LaunchFailed

_PARAMETERS: dict[str, Any] = {
    'ParameterFile': parameters.ParameterFile, 'ParameterValue': parameters.ParameterValue}

# The modules, and the names in each, that a launch file may import.
MODULES: dict[str, dict[str, Any]] = {
    'launch': {'LaunchDescription': actions.LaunchDescription},
    'launch.actions': {'DeclareLaunchArgument': actions.DeclareLaunchArgument},
    'launch.substitutions': {name: getattr(substitutions, name) for name in (
        'LaunchConfiguration', 'PathJoinSubstitution', 'TextSubstitution')},
    'launch_ros': {},
    'launch_ros.actions': {'Node': actions.Node, 'SetParameter': actions.SetParameter},
    'launch_ros.descriptions': _PARAMETERS,
    'launch_ros.substitutions': {'FindPackageShare': substitutions.FindPackageShare},
    'launch_ros.parameter_descriptions': _PARAMETERS,
}
_PACKAGES = {name.partition('.')[0] for name in MODULES}


def load_description(path: Path) -> LaunchDescription:
    """Run a launch file and return what it describes.

    :raises LaunchFailed: it is not a launch file in Python, or needs what only a full installation has.
    """
    if path.suffix != '.py':
        raise LaunchFailed(f'{path.name} is no launch file in Python, and the embedded ros2 launch reads no other. '
                           f'{FULL_INSTALLATION}')
    scope: dict[str, Any] = {'__name__': path.stem, '__file__': str(path)}
    with provided_packages_installed(), _importable():
        try:
            exec(compile(path.read_text(encoding='utf-8'), str(path), 'exec'), scope)
            if 'generate_launch_description' not in scope:
                raise LaunchFailed(f'launch file at {path} does not contain a required function '
                                   f"'generate_launch_description()'")
            found = scope['generate_launch_description']()
        except LaunchFailed:
            raise
        except Exception as error:
            raise LaunchFailed(_explanation(error)) from error
    if not isinstance(found, LaunchDescription):
        raise LaunchFailed(f'generate_launch_description() of {path.name} must return a LaunchDescription, and '
                           f'returned {found!r}')
    return found


def _explanation(error: Exception) -> str:
    if isinstance(error, ModuleNotFoundError) and str(error.name).partition('.')[0] in _PACKAGES:
        return (f'the embedded ros2 launch has no module {error.name}; it has {", ".join(MODULES)}. '
                f'{FULL_INSTALLATION}')
    hint = ''
    if isinstance(error, ModuleNotFoundError):
        hint = f'. Where it is part of ROS or of another package: {FULL_INSTALLATION[0].lower()}{FULL_INSTALLATION[1:]}'
    elif 'unexpected keyword argument' in str(error):  # Node(respawn=True), for example
        hint = f'. {FULL_INSTALLATION}'
    return f'Caught exception when trying to load file of format [py]: {type(error).__name__}: {error}{hint}'


@contextlib.contextmanager
def _importable() -> Iterator[None]:
    """Let the imports of a launch file find MODULES, and no installed ``launch``."""
    outer = {name: module for name, module in sys.modules.items() if name.partition('.')[0] in _PACKAGES}
    for name in outer:
        del sys.modules[name]
    for name in MODULES:
        sys.modules[name] = _module(name)
        package, _, part = name.rpartition('.')
        if package:
            setattr(sys.modules[package], part, sys.modules[name])
    try:
        yield
    finally:
        for name in [name for name in sys.modules if name.partition('.')[0] in _PACKAGES]:
            del sys.modules[name]
        sys.modules.update(outer)


def _module(name: str) -> ModuleType:
    module = ModuleType(name, f'The part of {name} that the embedded ros2 launch has.')
    module.__path__ = []
    module.__dict__.update(MODULES[name])

    def raise_missing(wanted: str) -> NoReturn:
        # The import system asks for these of any module.
        if wanted.startswith('__'):
            raise AttributeError(wanted)
        known = ', '.join(MODULES[name]) or 'no names of its own'
        raise LaunchFailed(f'the embedded ros2 launch has no {name}.{wanted}; of {name} it has {known}. '
                           f'{FULL_INSTALLATION}')

    # PEP 562: what a module has under this name is asked for names that it lacks.
    module.__dict__['__getattr__'] = raise_missing
    return module
