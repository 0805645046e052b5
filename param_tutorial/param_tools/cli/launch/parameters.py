"""The parameters of a Node in a launch file: dictionaries of values, and parameter files.

The string of a substitution is read as YAML, as launch_ros does, unless a ParameterValue says the type.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from inspect import formatannotation
from pathlib import Path
from typing import Any, get_args

import yaml

from param_tools.cli.launch.context import Context, LaunchFailed, Origin
from param_tools.cli.launch.substitutions import is_substitution, perform
from param_tools.cli.launch.text import parse_text

_NUMBERS = (bool, int, float)
_SCALARS = (*_NUMBERS, str)


class Parameters(dict[Any, Any]):
    """A dictionary of parameters from an element of XML or YAML."""

    def __init__(self, parameters: Mapping[Any, Any], origin: Origin):
        super().__init__(parameters)
        self.origin = origin


@dataclass
class ParameterValue:
    """A parameter's value, with the type that the string of a substitution is turned into."""

    value: Any
    value_type: Any = field(default=None, kw_only=True)
    """int, float, bool, str, or a typing.List of one of these."""


def flat(parameters: Mapping[Any, Any], context: Context, prefix: str = '') -> dict[str, Any]:
    """Return names and values of a dictionary of parameters, inner dictionaries with dots in their names."""
    result: dict[str, Any] = {}
    for key, value in parameters.items():
        name = prefix + perform(key, context)
        result |= flat(value, context, f'{name}.') if isinstance(value, Mapping) else {
            name: parameter_value(name, value, context)}
    return result


def parameter_value(name: str, value: Any, context: Context) -> Any:
    """Return the value that a node gets. A plain list becomes a tuple, as in launch_ros."""
    content, wanted = (value.value, value.value_type) if isinstance(value, ParameterValue) else (value, None)
    given, found = content, content
    if is_substitution(content):
        given = perform(content, context)
        found = _read(given, wanted)
    elif isinstance(content, (list, tuple)):
        parts = [part for item in content for part in (item if isinstance(item, (list, tuple)) else [])]
        if any(isinstance(each, Mapping) for each in content) or any(isinstance(each, _NUMBERS) for each in parts):
            raise LaunchFailed(f'{name}: ROS has no lists of maps or of lists, and launch rejects {content!r}: give '
                               f'each element a name, such as {name}.first')
        item_type, = get_args(wanted) or (None,)
        found = [item if isinstance(item, _SCALARS) else _read(perform(item, context), item_type) for item in content]
        if {type(item) for item in found} == {int, float}:
            found = [float(item) for item in found]
    if _fits(found, wanted):
        return tuple(found) if isinstance(found, list) and content is value else found
    if wanted is not None:
        raise LaunchFailed(f'{given!r} was given where the launch file takes a value of type '
                           f'{formatannotation(wanted)}')
    advice = (f' {found!r} if it is read as YAML. If it is meant to be a string, ParameterValue(..., value_type=str) '
              f'keeps it one' if is_substitution(content) else '')
    raise LaunchFailed(f'{name}: {given!r} cannot be the value of a parameter: it takes a bool, int, float or str, a '
                       f'list of one of these that is not empty, or a substitution{advice}')


def _read(text: str, wanted: Any) -> Any:
    """Return what the string of a substitution stands for; None if it is no value."""
    try:
        if wanted in (str, int, float):
            return wanted(text)
        if wanted is bool and text in ('0', '1'):
            return text == '1'
        return yaml.safe_load(text) if text else text
    except (yaml.YAMLError, ValueError):  # a date such as 2026-02-31 is a ValueError
        return None


def _fits(value: Any, wanted: Any) -> bool:
    """True for a scalar or a list of scalars of one type: the wanted one, if that is said."""
    items = value if isinstance(value, list) else [value]
    types = {type(item) for item in items}
    # As in launch_ros, where True after an integer is one.
    if wanted is None and items and type(items[0]) is int and all(isinstance(item, int) for item in items):
        return True
    if wanted is not None and (bool(get_args(wanted)) is not isinstance(value, list)
                               or types != {*(get_args(wanted) or [wanted])}):
        return False
    return len(types) == 1 and types <= {*_SCALARS}


@dataclass
class ParameterFile:
    """A parameter file; with ``allow_substs=True`` it may hold substitutions, such as ``$(var name)``."""

    param_file: Any
    allow_substs: bool = field(default=False, kw_only=True)

    def __post_init__(self) -> None:
        if not isinstance(self.allow_substs, bool):
            raise LaunchFailed(f'ParameterFile takes True or False for allow_substs, not {self.allow_substs!r}')

    def evaluate(self, context: Context) -> Path:
        """Return the path of a file without substitutions."""
        path = self.param_file if isinstance(self.param_file, Path) else Path(perform(self.param_file, context))
        if not self.allow_substs:
            return path
        try:
            text = path.read_text(encoding='utf-8')
        except OSError as error:
            raise LaunchFailed(f'{error.strerror}: {path}') from None

        return context.write(perform(parse_text(text), context), Origin(path, None))
