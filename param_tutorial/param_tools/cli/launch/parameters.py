"""The parameters of a Node in a launch file: dictionaries of values, and parameter files.

``flat`` and ``parameter_value`` follow ``evaluate_parameter_dict`` of launch_ros: a value that they accept reaches the
node with the same type. A list becomes a tuple, as there.
"""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, ClassVar, List, get_args  # noqa: UP035  # launch knows List[int], and not list[int]

import yaml

from param_tools.cli.launch.context import FULL_INSTALLATION, Context, LaunchFailed
from param_tools.cli.launch.substitutions import (
    FindPackageShare,
    LaunchConfiguration,
    is_list,
    is_substitution,
    perform,
)

_SCALARS = (bool, int, float, str)
_LISTS = tuple(List[each] for each in _SCALARS)  # type: ignore[valid-type]  # noqa: UP006


class ParameterValue:
    """A parameter's value, with the type that the string of a substitution is turned into."""

    def __init__(self, value: Any, *, value_type: Any = None):
        if value_type not in (None, *_SCALARS, *_LISTS):
            raise LaunchFailed(f'ParameterValue(value_type={value_type!r}): it takes int, float, bool, str, or a '
                               f'typing.List of one of these')
        self.value = value
        self.value_type = value_type

    def evaluate(self, context: Context) -> Any:
        """Return the value.

        :raises LaunchFailed: the value doesn't have the type.
        """
        if is_substitution(self.value):
            return _converted(perform(self.value, context), self.value_type)
        if not is_list(self.value):
            return _expect(self.value, self.value_type, self.value)
        item_type, = get_args(self.value_type) or (None,)
        items = [_converted(perform(item, context), item_type) if is_substitution(item) else item
                 for item in self.value]
        return _expect(_one_type_of_number(items), self.value_type, self.value)


def _converted(text: str, value_type: Any) -> Any:
    """Return what a ParameterValue makes of the string of a substitution."""
    value: Any
    try:
        if value_type in (str, int, float):
            value = value_type(text)
        elif value_type is bool and text in ('0', '1'):
            value = text == '1'
        else:
            value = yaml.safe_load(text) if text else text
    except (ValueError, yaml.YAMLError):
        value = None  # which has none of the types
    return _expect(value, value_type, text)


def _expect(value: Any, value_type: Any, given: Any) -> Any:
    """Return a value if it is of a type that ParameterValue takes; to Python, and so to launch, a bool is an int."""
    if value_type is None:
        fits, name = value == [] or _is_value(value), 'bool, int, float or str, or a list of one of these'
    elif value_type in _SCALARS:
        fits, name = isinstance(value, value_type), value_type.__name__
    else:
        item_type, = get_args(value_type)
        fits = isinstance(value, list) and all(isinstance(item, item_type) for item in value)
        name = f'List[{item_type.__name__}]'
    if not fits:
        raise LaunchFailed(f'{given!r} was given where the launch file takes a value of type {name}')
    return value


def flat(parameters: Mapping[Any, Any], context: Context, prefix: str = '') -> dict[str, Any]:
    """Return names and values of a dictionary of parameters, inner dictionaries with dots in their names."""
    result: dict[str, Any] = {}
    for key, value in parameters.items():
        name = prefix + perform(key, context)
        result |= flat(value, context, f'{name}.') if isinstance(value, Mapping) else {
            name: parameter_value(name, value, context)}
    return result


def parameter_value(name: str, value: Any, context: Context) -> Any:
    """Return the value that a node gets: the string of a substitution is read as YAML, any other string is kept.

    :raises LaunchFailed: the value cannot be that of a parameter.
    """
    if isinstance(value, ParameterValue):
        return value.evaluate(context)
    given, found = value, value
    if is_substitution(value):
        given = perform(value, context)
        found = _from_yaml(given) if given else given
    elif isinstance(value, Sequence) and not isinstance(value, (str, bytes)):
        found = [item if isinstance(item, _SCALARS) else _from_yaml(perform(item, context))
                 for item in _one_type_of_number(value)]
    if isinstance(found, bytes) or _is_value(found):
        return tuple(found) if isinstance(found, list) else found
    advice = (f' {found!r} if it is read as YAML. If it is meant to be a string, ParameterValue(..., value_type=str) '
              f'keeps it one' if is_substitution(value) else '')
    raise LaunchFailed(f'{name}: {given!r} cannot be the value of a parameter: it takes a bool, int, float or str, a '
                       f'list of one of these that is not empty, or a substitution{advice}')


def _one_type_of_number(items: Sequence[Any]) -> Sequence[Any]:
    return [float(item) for item in items] if {type(item) for item in items} == {int, float} else items


def _from_yaml(text: str) -> Any:
    try:
        return yaml.safe_load(text)
    except (yaml.YAMLError, ValueError):  # a date such as 2026-02-31 is a ValueError
        return None  # which cannot be a value


def _is_value(value: Any) -> bool:
    """True for a value that a parameter can have, bytes aside: a scalar, or a list of scalars of one type."""
    if isinstance(value, list):
        return bool(value) and type(value[0]) in _SCALARS and all(isinstance(item, type(value[0])) for item in value)
    return isinstance(value, _SCALARS)


@dataclass
class ParameterFile:
    """A parameter file; with ``allow_substs=True`` it may hold substitutions, such as ``$(var name)``."""

    # A character after a backslash, a substitution, or the beginning of an unknown one.
    _TOKENS = re.compile(r'\\(?P<escaped>.)|\$\((?P<kind>[A-Za-z][\w-]*) (?P<argument>[^\s\'"\\$()]+)\)|\$\(.*')
    _KINDS: ClassVar[dict[str, type[LaunchConfiguration | FindPackageShare]]] = {
        'var': LaunchConfiguration, 'find-pkg-share': FindPackageShare}

    param_file: Any
    allow_substs: bool = field(default=False, kw_only=True)

    def evaluate(self, context: Context) -> Path:
        """Return the path of a file without substitutions.

        :raises LaunchFailed: the file with substitutions cannot be read, or holds an unknown one.
        """
        path = self.param_file if isinstance(self.param_file, Path) else Path(perform(self.param_file, context))
        if not self.allow_substs:
            return path
        try:
            text = path.read_text(encoding='utf-8')
        except OSError as error:
            raise LaunchFailed(f'{error.strerror}: {path}') from None

        def substituted(token: re.Match[str]) -> str:
            if token['escaped'] is not None:
                return token['escaped']
            if token['kind'] in self._KINDS:
                return self._KINDS[token['kind']](token['argument']).perform(context)
            known = ' and '.join(f'$({kind} …)' for kind in self._KINDS)
            raise LaunchFailed(f'the embedded ros2 launch knows {known} in a parameter file, and not {token[0]}. '
                               f'{FULL_INSTALLATION}')

        return context.write(self._TOKENS.sub(substituted, text))
