"""What nodes declare, as data: asked of running nodes, saved in a file, and read back.

A description holds what a node says of its parameters (type, range, text, read-only), and the value that each had:

    parameter_descriptions: 1
    complete: true                 # these are all nodes of the system
    nodes:
      /arm:
        parameters:
          speed:
            type: double           # bool, int, double, string, or an array: byte_array, double_array, …
            default_value: 0.5
            description: Speed of the tool, in m/s
            additional_constraints: A text for people
            read_only: true
            dynamic_typing: true
            range: {from: 0.0, to: 2.0, step: 0.1}
"""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

from param_tools import values
from param_tools.descriptor import Descriptor, Range
from param_tools.errors import NodeError, ParameterFileError
from param_tools.files.parameter_files import Dump, read_bytes
from param_tools.files.parsing import not_yaml
from param_tools.values import ParameterType

VERSION = 1
_FORMAT = 'parameter_descriptions'

_TYPES = {
    'none': values.NOT_SET, 'bool': values.BOOL, 'int': values.INTEGER, 'double': values.DOUBLE,
    'string': values.STRING, 'byte_array': values.BYTE_ARRAY, 'bool_array': values.BOOL_ARRAY,
    'int_array': values.INTEGER_ARRAY, 'double_array': values.DOUBLE_ARRAY, 'string_array': values.STRING_ARRAY}
_NAMES = {parameter_type: name for name, parameter_type in _TYPES.items()}
# rclpy.node.Node.PARAM_REL_TOL
_REL_TOL = 1e-6


@dataclass(frozen=True)
class Objection:
    """Why a parameter cannot hold a value."""

    kind: str
    """'wrong type', 'out of range' or 'off the step'."""
    reason: str


@dataclass(frozen=True)
class DescribedParameter:
    """What is known of one parameter."""

    descriptor: Descriptor
    default: Any = None
    """The value that it had when it was described; None if it had none."""

    @property
    def name(self) -> str:
        """The full name, with dots."""
        return self.descriptor.name

    def objection(self, value: Any) -> Objection | None:
        """Return why the parameter cannot hold a value; None if nothing is known against it.

        Ranges are judged as rclpy and rclcpp do: both ends are always valid, even off the step.

        :param value: As ``values.normalize`` gives it.
        """
        descriptor = self.descriptor
        if descriptor.type is not values.NOT_SET and not descriptor.dynamic_typing:
            fits = descriptor.type.is_array if values.is_empty_array(value) else descriptor.type.accepts(value)
            if not fits:
                return Objection('wrong type', f'it is of type {descriptor.type.label}, and '
                                               f'{values.format_value(value, 60)} is {values.describe_type(value)}')
        if descriptor.range is not None and type(value) in (int, float):
            return _outside(value, descriptor.range)
        return None


def _outside(value: int | float, limits: Range) -> Objection | None:
    low, high, step = limits.from_value, limits.to_value, limits.step

    def close(one: float, other: float) -> bool:
        return one == other if isinstance(value, int) else math.isclose(one, other, rel_tol=_REL_TOL)

    if close(value, low) or close(value, high):
        return None
    if not low < value < high:
        return Objection('out of range', f'{value} is not between {low} and {high}')
    if step and not (math.isinf(low) or math.isinf(value)):
        off = ((value - low) % step != 0 if isinstance(value, int)
               else not close(low + round((value - low) / step) * step, value))
        if off:
            return Objection('off the step', f'{value} is not on a step: the valid values are {step} apart, counted '
                                             f'from {low}')
    return None


@dataclass(frozen=True)
class NodeDescription:
    """What is known of the parameters of one node."""

    node: str
    """Its fully qualified name."""
    parameters: dict[str, DescribedParameter]


class Descriptions(dict[str, NodeDescription]):
    """The descriptions of nodes, by their names."""

    def __init__(self, nodes: Iterable[NodeDescription] = (), *, complete: bool = False,
                 unanswered: Mapping[str, NodeError] | None = None):
        """
        :param complete: These are all nodes of the system: a file for another one is for none.
        :param unanswered: The nodes that could not be described, and why.
        """
        super().__init__((each.node, each) for each in nodes)
        self.complete = complete
        self.unanswered = dict(unanswered or {})

    def add(self, others: 'Descriptions') -> None:
        """Add descriptions; of two of one node the later one counts."""
        self.update(others)
        self.complete = self.complete or others.complete
        self.unanswered.update(others.unanswered)

    def dump(self) -> Dump:
        """Return the text of a file that ``read`` reads back."""
        nodes = {each.node: {'parameters': {name: _written(described) for name, described in each.parameters.items()}}
                 for each in self.values()}
        text = yaml.dump({_FORMAT: VERSION, 'complete': self.complete, 'nodes': nodes}, Dumper=_Dumper,
                         sort_keys=False, allow_unicode=True, width=100)
        lines = [f'# {node} is missing: {" ".join(str(error).split())}\n' for node, error in self.unanswered.items()]
        return Dump('# What nodes declare: to check parameter files without a robot.\n' + ''.join(lines) + text, {})


class _Dumper(yaml.SafeDumper):
    """Escapes what is not printable: the YAML library writes some line breaks as others."""

    def ignore_aliases(self, data: Any) -> bool:
        """Write a value as often as it is there."""
        return True


_Dumper.add_representer(str, lambda dumper, text: dumper.represent_scalar(
    'tag:yaml.org,2002:str', text, None if text.isprintable() else '"'))


def _written(described: DescribedParameter) -> dict[str, Any]:
    descriptor = described.descriptor
    result: dict[str, Any] = {'type': _NAMES[descriptor.type]}
    if described.default is not None:
        result['default_value'] = ([byte[0] for byte in described.default] if descriptor.type is values.BYTE_ARRAY
                                   else described.default)
    for key in ('description', 'additional_constraints', 'read_only', 'dynamic_typing'):
        if getattr(descriptor, key):
            result[key] = getattr(descriptor, key)
    if descriptor.range:
        limits = descriptor.range
        result['range'] = {'from': limits.from_value, 'to': limits.to_value, 'step': limits.step}
    return result


# -- reading ----------------------------------------------------------------------------------------------------


def read(path: str | Path) -> Descriptions:
    """Read a saved description.

    :raises ParameterFileError: the file cannot be read, or is none.
    """
    content = _load_yaml(path)
    try:
        return _read_saved(content)
    except _Unfit as error:
        raise ParameterFileError(f'{path}: {error}') from None


def _load_yaml(path: str | Path) -> Any:
    """Return what the YAML library makes of a file.

    :raises ParameterFileError: the file cannot be read, or is not YAML.
    """
    content = read_bytes(path)
    try:
        return yaml.safe_load(content)
    except yaml.YAMLError as error:
        rejected = not_yaml(error, content)
        raise ParameterFileError(f'{path}, line {rejected.place.line}: {rejected}') from None
    except RecursionError:
        raise ParameterFileError(f'{path}: it is nested too deeply') from None
    # A date that is none, an integer of thousands of digits, a key that is a list.
    except (ValueError, TypeError, AttributeError, KeyError, OverflowError) as error:
        raise ParameterFileError(f'{path}: it holds something that YAML cannot read: {error}') from None


class _Unfit(Exception):
    """The content of a description makes no sense."""


def _read_saved(content: Any) -> Descriptions:
    if not isinstance(content, dict) or _FORMAT not in content:
        raise _Unfit(f'it is no saved description, whose first line is "{_FORMAT}: {VERSION}"')
    if content[_FORMAT] != VERSION or content[_FORMAT] is True:
        raise _Unfit(f'it is in version {content[_FORMAT]!r} of the format, and this program knows version {VERSION}')
    result = []
    for node, each in _map(content.get('nodes'), 'nodes').items():
        if not isinstance(node, str) or not node.startswith('/'):
            raise _Unfit(f'{node!r} is not the name of a node: it must start with a slash')
        parameters = _map(_map(each, node).get('parameters'), f'the parameters of {node}')
        result.append(NodeDescription(
            node, {str(name): _described(str(name), _map(leaf, f'{node}: {name}'))
                   for name, leaf in parameters.items()}))
    return Descriptions(result, complete=content.get('complete') is True)


def _map(content: Any, what: str) -> dict[Any, Any]:
    if not isinstance(content, dict):
        raise _Unfit(f'{what} should be a map, and is {values.format_value(content, 60)}')
    return content


def _described(name: str, leaf: Mapping[Any, Any]) -> DescribedParameter:
    word = leaf.get('type')
    if not isinstance(word, str) or word not in _TYPES:
        raise _Unfit(f'{name} has the type {word!r}; the types are {", ".join(_TYPES)}')
    parameter_type = _TYPES[word]
    descriptor = Descriptor(
        name, parameter_type, str(leaf.get('description') or ''), str(leaf.get('additional_constraints') or ''),
        leaf.get('read_only') is True, leaf.get('dynamic_typing') is True, _range(name, leaf.get('range')))
    return DescribedParameter(descriptor, _default(name, parameter_type, leaf))


def _range(name: str, content: Any) -> Range | None:
    if content is None:
        return None
    found = [_map(content, f'the range of {name}').get(key, 0) for key in ('from', 'to', 'step')]
    if not all(type(each) in (int, float) for each in found):
        raise _Unfit(f'the range of {name} must have numbers in from, to and step')
    return Range(*found)


def _default(name: str, parameter_type: ParameterType, leaf: Mapping[Any, Any]) -> Any:
    value = leaf.get('default_value')
    if value is None:
        return None
    if parameter_type is values.BYTE_ARRAY and isinstance(value, list):
        value = [bytes([each]) if type(each) is int and 0 <= each < 256 else each for each in value]
    if parameter_type is not values.NOT_SET and not parameter_type.accepts(value):
        raise _Unfit(f'the default value of {name} is not a {parameter_type.label}: {values.format_value(value, 60)}')
    return value
