"""Reading a launch file: for that moment, and for no longer, ``import launch`` finds the classes of ``description``."""

import contextlib
import sys
from collections.abc import Iterator, Sequence
from importlib.abc import MetaPathFinder
from pathlib import Path
from types import ModuleType
from typing import Any, NoReturn

from param_tools.cli.index import provided_packages_installed
from param_tools.cli.launch import description, substitutions, values
from param_tools.cli.launch.description import LaunchDescription
from param_tools.cli.launch.substitutions import FULL_INSTALLATION, LaunchFailed

_PARAMETER_DESCRIPTIONS: dict[str, Any] = {
    'ParameterFile': description.ParameterFile, 'ParameterValue': values.ParameterValue}

# Which names each module has here.
MODULES: dict[str, dict[str, Any]] = {
    'launch': {'LaunchDescription': description.LaunchDescription},
    'launch.actions': {'DeclareLaunchArgument': description.DeclareLaunchArgument},
    'launch.substitutions': {name: getattr(substitutions, name) for name in (
        'LaunchConfiguration', 'PathJoinSubstitution', 'TextSubstitution')},
    'launch_ros': {},
    'launch_ros.actions': {'Node': description.Node, 'SetParameter': description.SetParameter},
    'launch_ros.descriptions': _PARAMETER_DESCRIPTIONS,
    'launch_ros.substitutions': {'FindPackageShare': substitutions.FindPackageShare},
    'launch_ros.parameter_descriptions': _PARAMETER_DESCRIPTIONS,
}
_PACKAGES = {name.partition('.')[0] for name in MODULES}


def load_description(path: Path) -> LaunchDescription:
    """Run a launch file and return what it describes.

    :raises LaunchFailed: it is not a launch file in Python, or needs what only a full installation has.
    """
    if path.suffix != '.py':
        raise LaunchFailed(f"{path.name} is no launch file in Python, and the course's own ros2 launch reads no other. "
                           f'{FULL_INSTALLATION}')
    scope: dict[str, Any] = {'__name__': path.stem, '__file__': str(path)}
    with provided_packages_installed(), _stand_ins():
        try:
            exec(compile(path.read_text(encoding='utf-8'), str(path), 'exec'), scope)
            if 'generate_launch_description' not in scope:
                raise LaunchFailed(f'launch file at {path} does not contain a required function '
                                   f"'generate_launch_description()'")
            found = scope['generate_launch_description']()
        except LaunchFailed:
            raise
        except Exception as error:
            # Node(respawn=True), for example.
            hint = f'. {FULL_INSTALLATION}' if 'unexpected keyword argument' in str(error) else ''
            raise LaunchFailed(f'Caught exception when trying to load file of format [py]: '
                               f'{type(error).__name__}: {error}{hint}') from error
    if not isinstance(found, LaunchDescription):
        raise LaunchFailed(f'generate_launch_description() of {path.name} must return a LaunchDescription, and '
                           f'returned {found!r}')
    return found


class _Refuse(MetaPathFinder):
    """Raise a sentence for a module that is missing here."""

    def find_spec(self, name: str, path: Sequence[str] | None = None, target: ModuleType | None = None) -> None:
        if name.partition('.')[0] in _PACKAGES:
            raise LaunchFailed(f"the course's own ros2 launch has no module {name}; it has {', '.join(MODULES)}. "
                               f'{FULL_INSTALLATION}')


@contextlib.contextmanager
def _stand_ins() -> Iterator[None]:
    outer = {name: module for name, module in sys.modules.items() if name.partition('.')[0] in _PACKAGES}
    for name in outer:
        del sys.modules[name]
    for name in MODULES:
        sys.modules[name] = _module(name)
        package, _, part = name.rpartition('.')
        if package:
            setattr(sys.modules[package], part, sys.modules[name])
    finder = _Refuse()
    sys.meta_path.insert(0, finder)
    try:
        yield
    finally:
        sys.meta_path.remove(finder)
        for name in [name for name in sys.modules if name.partition('.')[0] in _PACKAGES]:
            del sys.modules[name]
        sys.modules.update(outer)


def _module(name: str) -> ModuleType:
    module = ModuleType(name, f'The part of {name} that the lessons use.')
    module.__path__ = []
    module.__dict__.update(MODULES[name])

    def raise_missing(wanted: str) -> NoReturn:
        # The import system asks for these of any module.
        if wanted.startswith('__'):
            raise AttributeError(wanted)
        known = ', '.join(MODULES[name]) or 'no names of its own'
        raise LaunchFailed(f"the course's own ros2 launch has no {name}.{wanted}; of {name} it has {known}. "
                           f'{FULL_INSTALLATION}')

    # PEP 562: what a module has under this name is asked for names that it lacks.
    module.__dict__['__getattr__'] = raise_missing
    return module
