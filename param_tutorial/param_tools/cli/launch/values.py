"""Values of parameters in a launch file: which Python values launch_ros takes, and what it makes of each."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, List, get_args  # noqa: UP035  # launch knows List[int], and not list[int]

import yaml

from param_tools.cli.launch.substitutions import Context, LaunchFailed, Substitution, is_substitution, perform

_SCALARS = (bool, int, float, str)
_LISTS = tuple(List[each] for each in _SCALARS)  # type: ignore[valid-type]  # noqa: UP006
_STAYS_A_STRING = 'ParameterValue(..., value_type=str) keeps it a string'


class ParameterValue:
    """A parameter's value, with the type that the string of a substitution is turned into."""

    def __init__(self, value: Any, *, value_type: Any = None):
        if value_type is not None and value_type not in (*_SCALARS, *_LISTS):
            raise LaunchFailed(f'ParameterValue(value_type={value_type!r}): it takes int, float, bool, str, or a '
                               f'typing.List of one of these')
        self.value = value
        self.value_type = value_type
        if isinstance(value, _SCALARS):
            self._expect(value)
        elif not is_substitution(value):
            if not isinstance(value, Iterable) or isinstance(value, (bytes, Mapping)):
                raise LaunchFailed(f'{value!r} cannot be the value of a ParameterValue')
            if value_type in _SCALARS:
                raise LaunchFailed(f'ParameterValue(value_type={value_type.__name__}) was given a list: {value!r}')

    def evaluate(self, context: Context) -> Any:
        """Return the value."""
        if isinstance(self.value, _SCALARS):
            return self.value
        if is_substitution(self.value):
            return _coerced(perform(self.value, context), self.value_type)
        item_type = get_args(self.value_type)[0] if self.value_type else None
        items = [_coerced(perform(item, context), item_type) if is_substitution(item) else item for item in self.value]
        if {type(item) for item in items} == {int, float}:
            items = [float(item) for item in items]
        self._expect(items)
        return items

    def _expect(self, value: Any) -> None:
        if not _is_of(value, self.value_type):
            raise LaunchFailed(f'{value!r} was given where the launch file takes a value of type '
                               f'{_name(self.value_type)}')


def _name(value_type: Any) -> str:
    if value_type is None:
        return 'bool, int, float or str, or a list of one of these'
    return value_type.__name__ if value_type in _SCALARS else f'List[{get_args(value_type)[0].__name__}]'


def _is_of(value: Any, value_type: Any) -> bool:
    """True if a value is of a type as launch sees it; to Python, and so to launch, a bool is an int."""
    if value_type is None:
        return isinstance(value, _SCALARS) or (isinstance(value, list) and (not value or _is_uniform(value)))
    if value_type in _SCALARS:
        return isinstance(value, value_type)
    return isinstance(value, list) and all(isinstance(item, get_args(value_type)[0]) for item in value)


def _is_uniform(items: Sequence[Any]) -> bool:
    return bool(items) and type(items[0]) in _SCALARS and all(isinstance(item, type(items[0])) for item in items)


def _coerced(text: str, value_type: Any) -> Any:
    """Return what a substitution's string becomes in a ParameterValue."""
    if value_type is str:
        return text
    try:
        if value_type in (int, float):
            return value_type(text)
        if value_type is bool:
            text = {'1': 'true', '0': 'false'}.get(text, text)
        value = yaml.safe_load(text) if text else text
    except (ValueError, yaml.YAMLError):
        value = None
    if value is None or not _is_of(value, value_type):
        raise LaunchFailed(f'{text!r} was given where the launch file takes a value of type {_name(value_type)}')
    return value


def flat(parameters: Mapping[Any, Any], context: Context, prefix: str = '') -> dict[str, Any]:
    """Return names and values of a dictionary of parameters, inner dictionaries with dots in their names."""
    result: dict[str, Any] = {}
    for key, value in parameters.items():
        name = prefix + perform(key, context)
        if isinstance(value, Mapping):
            result.update(flat(value, context, f'{name}.'))
        else:
            result[name] = parameter_value(name, value, context)
    return result


def parameter_value(name: str, value: Any, context: Context) -> Any:
    """Return the value of a parameter as launch_ros understands it: a substitution's string is read as YAML."""
    if isinstance(value, ParameterValue):
        return value.evaluate(context)
    if isinstance(value, (*_SCALARS, bytes)):
        return value
    if is_substitution(value):
        return _read(name, perform(value, context))
    if isinstance(value, Sequence):
        return _list(name, value, context)
    raise _cannot_be(name, value)


def _read(name: str, text: str) -> Any:
    if not text:
        return text
    try:
        value = yaml.safe_load(text)
    # A date such as 2026-02-31 is a ValueError.
    except (yaml.YAMLError, ValueError):
        raise LaunchFailed(f'{name} is {text!r}, which is not YAML. If it is meant to be a string, '
                           f'{_STAYS_A_STRING}') from None
    if isinstance(value, (*_SCALARS, bytes)) or (isinstance(value, list) and _is_uniform(value)):
        return value
    raise LaunchFailed(f'{name} is {text!r}, which YAML reads as {value!r}, and that cannot be the value of a '
                       f'parameter. If it is meant to be a string, {_STAYS_A_STRING}')


def _list(name: str, value: Sequence[Any], context: Context) -> list[Any]:
    if value and all(type(item) in (int, float) for item in value):
        floats = float in map(type, value)
        return [float(item) for item in value] if floats else list(value)
    items = [item if isinstance(item, _SCALARS) else _item(name, item, context) for item in value]
    if not _is_uniform(items):
        raise _cannot_be(name, value)
    return items


def _item(name: str, item: Any, context: Context) -> Any:
    """Return an item of a list that is a substitution, or several strings and substitutions in a row."""
    if not isinstance(item, (Substitution, Sequence)):
        raise _cannot_be(name, item)
    return yaml.safe_load(perform(item, context))


def _cannot_be(name: str, value: Any) -> LaunchFailed:
    return LaunchFailed(f'{name}: {value!r} in the launch file cannot be the value of a parameter: it takes a bool, '
                        f'int, float or str, a list of one of these that is not empty, or a substitution')
