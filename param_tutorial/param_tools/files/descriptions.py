"""What nodes declare, as data: read from a file in which it was saved, or from a generate_parameter_library schema.

A description holds what a node tells of its parameters (type, range, text, read-only), the value that each had, and
what only a schema knows: the built-in validators of generate_parameter_library. The keys of a saved description are
those of such a schema where it has one for the same thing:

    parameter_descriptions: 1
    complete: true                 # these are all nodes of the system
    nodes:
      /arm:
        defaults: as declared      # or: as found in a running node
        schema: arm_controller     # its name: without a valid value of each parameter, the node does not start
        allows_undeclared: true    # written by hand, for a node that takes whatever a file holds
        parameters:
          speed:
            type: double           # bool, int, double, string, or an array: byte_array, double_array, …
            default_value: 0.5
            description: Speed of the tool, in m/s
            additional_constraints: A text for people
            read_only: true
            dynamic_typing: true
            range: {from: 0.0, to: 2.0, step: 0.1}
            validation: {one_of<>: [[0.5, 1.0]]}
            unit: m/s              # written by hand

A parameter of a schema may have ``__map_joints`` as a part of its name: there is one for each value of ``joints``.
"""

import dataclasses
import itertools
import math
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import yaml

from param_tools import values
from param_tools.descriptor import Descriptor, Range, is_housekeeping
from param_tools.errors import NodeError, ParameterFileError
from param_tools.files.parameter_files import Dump, read_bytes
from param_tools.files.parsing import not_yaml
from param_tools.files.reference import Reference, ReferenceRow, reference_of
from param_tools.values import ParameterType

VERSION = 1
_FORMAT = 'parameter_descriptions'
AS_DECLARED = 'as declared'
AS_FOUND = 'as found in a running node'
_MAP = '__map_'

_TYPES = {
    'none': values.NOT_SET, 'bool': values.BOOL, 'int': values.INTEGER, 'double': values.DOUBLE,
    'string': values.STRING, 'byte_array': values.BYTE_ARRAY, 'bool_array': values.BOOL_ARRAY,
    'int_array': values.INTEGER_ARRAY, 'double_array': values.DOUBLE_ARRAY, 'string_array': values.STRING_ARRAY}
_NAMES = {parameter_type: name for name, parameter_type in _TYPES.items()}
_FIXED = re.compile(r'(string|bool_array|int_array|double_array|string_array)_fixed_([0-9]{1,9})')
# What a schema can say of a parameter. Each may also be the name of a parameter or group, and is a map then.
_SAID_OF_A_PARAMETER = ('type', 'default_value', 'description', 'read_only', 'additional_constraints')
# rclpy.node.Node.PARAM_REL_TOL
_REL_TOL = 1e-6


@dataclass(frozen=True)
class Objection:
    """Why a parameter cannot hold a value."""

    kind: str
    """'wrong type', 'out of range', 'off the step' or 'invalid' for what a validator of a schema rejects."""
    reason: str


@dataclass(frozen=True)
class DescribedParameter:
    """What is known of one parameter."""

    descriptor: Descriptor
    default: Any = None
    """The value that it had when it was described; None if it had none."""
    validation: Mapping[str, tuple[Any, ...]] = field(default_factory=dict)
    """Validators of generate_parameter_library by name, without ``<>``, with their arguments."""
    unit: str = ''
    """Written by hand: neither ROS nor generate_parameter_library has a place for it."""

    @property
    def name(self) -> str:
        """The full name, with dots."""
        return self.descriptor.name

    @property
    def choices(self) -> tuple[Any, ...]:
        """The values among which it chooses; empty if there is no such list."""
        found = self.validation.get('one_of', ((),))[0]
        return tuple(found) if isinstance(found, list) else ()

    @property
    def validator_calls(self) -> list[str]:
        """The validators with their arguments, as a schema writes them, e.g. ``'bounds<>: [0.0, 2.0]'``."""
        return [f'{name}<>' + (f': {values.format_value(list(arguments))}' if arguments else '')
                for name, arguments in self.validation.items()]

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
                                               f'{values.format_value(value, 60)} is {_label(value)}')
        if descriptor.range is not None and type(value) in (int, float):
            found = _outside(value, descriptor.range)
            if found:
                return found
        for name, arguments in self.validation.items():
            if name in _VALIDATORS and (reason := _reason(name, value, arguments)):
                return Objection('invalid' if 'bound' not in name and name not in ('lt', 'gt', 'lt_eq', 'gt_eq')
                                 else 'out of range', reason)
        return None


def _label(value: Any) -> str:
    label = values.type_of(value).label
    return f'an {label}' if label[0] in 'aeiou' else f'a {label}'


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


# The built-in validators of generate_parameter_library, as RSL defines them: what each says about a value.
_VALIDATORS: dict[str, Callable[..., str]] = {
    'bounds': lambda value, low, high: '' if low <= value <= high else f'must be between {low} and {high}',
    'lt': lambda value, limit: '' if value < limit else f'must be less than {limit}',
    'gt': lambda value, limit: '' if value > limit else f'must be greater than {limit}',
    'lt_eq': lambda value, limit: '' if value <= limit else f'must be at most {limit}',
    'gt_eq': lambda value, limit: '' if value >= limit else f'must be at least {limit}',
    'lower_bounds': lambda value, limit: '' if value >= limit else f'must be at least {limit}',
    'upper_bounds': lambda value, limit: '' if value <= limit else f'must be at most {limit}',
    'one_of': lambda value, choices: '' if value in choices else f'must be one of {_listed(choices)}',
    'fixed_size': lambda value, size: '' if len(value) == size else f'must have {size} elements, not {len(value)}',
    'size_gt': lambda value, size: '' if len(value) > size else f'must have more than {size} elements',
    'size_lt': lambda value, size: '' if len(value) < size else f'must have fewer than {size} elements',
    'not_empty': lambda value: '' if len(value) else 'must not be empty',
    'unique': lambda value: '' if len(set(value)) == len(value) else 'must not have the same element twice',
    'subset_of': lambda value, choices: '' if set(value) <= set(choices) else f'may only have {_listed(choices)}',
    'element_bounds': lambda value, low, high: '' if all(low <= item <= high for item in value)
        else f'must have elements between {low} and {high}',
    'lower_element_bounds': lambda value, limit: '' if all(item >= limit for item in value)
        else f'must have elements of at least {limit}',
    'upper_element_bounds': lambda value, limit: '' if all(item <= limit for item in value)
        else f'must have elements of at most {limit}',
    'at_most': lambda value, size: '' if len(value) <= size else f'must not be longer than {size}, not {len(value)}',
}


def _listed(choices: Any) -> str:
    return ', '.join(map(values.format_value, choices))


def _reason(name: str, value: Any, arguments: tuple[Any, ...]) -> str:
    try:
        reason = _VALIDATORS[name](value, *arguments)
    except TypeError:  # the schema gives it other arguments than it takes, or it is for other types
        return ''
    return f'it {reason}' if reason else ''


@dataclass(frozen=True)
class NodeDescription:
    """What is known of the parameters of one node."""

    node: str
    """Its fully qualified name; a schema of generate_parameter_library doesn't know it for sure."""
    parameters: dict[str, DescribedParameter]
    defaults_from: str = AS_FOUND
    """Where the default values come from, in words."""
    allows_undeclared: bool = False
    """The node also takes parameters that are not described; only a person who knows it can say so."""
    schema: str = ''
    """The name of the schema that it comes from, several with spaces between them: such a node does not start if one of
    its parameters has no value or an invalid one. Empty if it does not come from schemas alone."""

    def joined(self, other: 'NodeDescription') -> 'NodeDescription':
        """Return what both say of the node, as of one with several schemas: what this one says of a parameter stays,
        with the validators that only the other one knows."""
        parameters = dict(self.parameters)
        for name, described in other.parameters.items():
            mine = parameters.setdefault(name, described)
            parameters[name] = dataclasses.replace(mine, validation={**described.validation, **mine.validation},
                                                   unit=mine.unit or described.unit)
        return dataclasses.replace(
            self, parameters=parameters, allows_undeclared=self.allows_undeclared or other.allows_undeclared,
            defaults_from=self.defaults_from if self.defaults_from == other.defaults_from else AS_FOUND,
            schema=f'{self.schema} {other.schema}' if self.schema and other.schema else '')

    def missing(self, given: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
        """Yield the parameters without which the node does not start, and why, if it gets only these values."""
        for name in self.names(given) if self.schema else ():
            described = self.find(name, given)
            if name in given or described is None or described.descriptor.type is values.NOT_SET:
                continue
            if described.default is None:
                yield name, 'it has no default'
            elif objection := described.objection(described.default):
                yield name, f'its default is {values.format_value(described.default, 60)}, and {objection.reason}'

    def names(self, known: Mapping[str, Any] | None = None) -> list[str]:
        """Return the names of the parameters, with those that a schema makes of others' values.

        :param known: Values that a file gives to the node; they come before the defaults.
        """
        return [name for each in self.parameters for name in self._expanded(each, known or {})]

    def find(self, name: str, known: Mapping[str, Any] | None = None) -> DescribedParameter | None:
        """Return the parameter of a name, None if there is none.

        :param known: Values that a file gives to the node: in a schema, they may name parameters.
        """
        if name in self.parameters:
            return self.parameters[name]
        for template, described in self.parameters.items():
            if _MAP in template and re.fullmatch(self._pattern(template, known or {}), name):
                return described
        return None

    def _keys(self, parts: Sequence[str], known: Mapping[str, Any]) -> list[str] | None:
        """Return the names that take the place of the last part of a name; None if they are not known.

        The parameter that holds them is in the same group, or in one around it.
        """
        groups = list(itertools.takewhile(lambda part: not part.startswith(_MAP), parts[:-1]))
        for depth in range(len(groups), -1, -1):
            key = '.'.join((*groups[:depth], parts[-1].removeprefix(_MAP)))
            if key in known or key in self.parameters:
                found = known[key] if key in known else self.parameters[key].default
                return [str(each) for each in found] if isinstance(found, list) else None
        return None

    def _choices(self, template: str, known: Mapping[str, Any]) -> Iterator[list[str] | None]:
        """Yield for each part of a name what may stand there; None if that is not known."""
        parts = template.split('.')
        for number, part in enumerate(parts):
            yield self._keys(parts[:number + 1], known) if part.startswith(_MAP) else [part]

    def _pattern(self, template: str, known: Mapping[str, Any]) -> str:
        return r'\.'.join('[^.]+' if keys is None else f'(?:{"|".join(map(re.escape, keys))})'
                          for keys in self._choices(template, known))

    def _expanded(self, template: str, known: Mapping[str, Any]) -> Iterator[str]:
        choices = [keys or [] for keys in self._choices(template, known)]
        yield from itertools.islice(map('.'.join, itertools.product(*choices)), 1000)

    def reference(self) -> Reference:
        """Return a table of the parameters in Markdown, for a README.

        Where a schema makes parameters of another one's values, the table has one row for them: ``gains.<joints>.p``.
        Parameters that every node has are left out.
        """
        is_declared = self.defaults_from == AS_DECLARED

        def row(name: str, each: DescribedParameter) -> ReferenceRow:
            known = '' if each.default is None and is_declared else values.format_value(each.default)
            told = each.descriptor
            return ReferenceRow(re.sub(rf'{_MAP}(\w+)', r'<\1>', name), told.type.label, known,
                                [*told.rules, *each.validator_calls],
                                (told.description, told.additional_constraints, each.unit and f'In {each.unit}.'))

        return reference_of([row(name, each) for name, each in self.parameters.items() if not is_housekeeping(name)],
                            'default' if is_declared else 'value')


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
        """Add descriptions; several of one node are one description."""
        for node, each in others.items():
            self[node] = self[node].joined(each) if node in self else each
        self.complete = self.complete or others.complete
        self.unanswered.update(others.unanswered)

    def dump(self) -> Dump:
        """Return the text of a file that ``read`` reads back."""
        nodes = {each.node: {'defaults': each.defaults_from,
                             **({'schema': each.schema} if each.schema else {}),
                             **({'allows_undeclared': True} if each.allows_undeclared else {}),
                             'parameters': {name: _written(described) for name, described in each.parameters.items()}}
                 for each in self.values()}
        text = yaml.dump({_FORMAT: VERSION, 'complete': self.complete, 'nodes': nodes}, Dumper=_Dumper,
                         sort_keys=False, allow_unicode=True, width=100)
        lines = [f'# {node} is missing: {" ".join(str(error).split())}\n' for node, error in self.unanswered.items()]
        return Dump('# What nodes declare: to check parameter files without a robot.\n' + ''.join(lines) + text, {})

    def reference(self) -> Reference:
        """Return a table in Markdown for each node, with its name as a heading if there are several."""
        return Reference('\n'.join((f'## {node}\n\n' if len(self) > 1 else '') + each.reference().text
                                   for node, each in self.items()))


class _Dumper(yaml.SafeDumper):
    """Escapes what is not printable: the YAML library writes some line breaks as others."""

    def ignore_aliases(self, data: Any) -> bool:
        """Write a value as often as it is there."""
        return True


def _quoted(dumper: _Dumper, text: str) -> yaml.ScalarNode:
    return dumper.represent_scalar('tag:yaml.org,2002:str', text, None if text.isprintable() else '"')


_Dumper.add_representer(str, _quoted)


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
    if described.unit:
        result['unit'] = described.unit
    if described.validation:
        result['validation'] = {f'{name}<>': list(arguments) for name, arguments in described.validation.items()}
    return result


# -- reading ----------------------------------------------------------------------------------------------------


def is_description(content: Any) -> bool:
    """True if a YAML document looks like a saved description or a schema, and not like a parameter file."""
    return isinstance(content, dict) and (_FORMAT in content or _is_schema(content))


def read(path: str | Path, node: str | None = None) -> Descriptions:
    """Read a saved description, or a schema of generate_parameter_library.

    :param node: The name of the node that the file describes, where that is another one than the file says. A
        schema says none: without this, the node is taken to be named like the schema.
    :raises ParameterFileError: the file cannot be read, or is neither.
    """
    content = load_yaml(path)
    try:
        if isinstance(content, dict) and _FORMAT in content:
            found = _read_saved(content)
        elif _is_schema(content):
            found = Descriptions(_read_schema(content))
        else:
            raise _Unfit('it is neither a saved description (its first line is "parameter_descriptions: 1") nor a '
                         'schema of generate_parameter_library')
    except RecursionError:
        raise ParameterFileError(f'{path}: it is nested too deeply') from None
    except _Unfit as error:
        raise ParameterFileError(f'{path}: {error}') from None
    if node is None:
        return found
    name = '/' + node.strip('/')
    if len(found) != 1:
        raise ParameterFileError(f'{path} describes {len(found)} nodes, so it cannot be the description of {name}')
    only = next(iter(found.values()))
    return Descriptions([dataclasses.replace(only, node=name)])


def load_yaml(path: str | Path) -> Any:
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


def _is_schema(content: Any) -> bool:
    if not isinstance(content, dict) or len(content) != 1:
        return False
    (tree,) = content.values()
    try:
        return isinstance(tree, dict) and _is_group(tree)
    except RecursionError:
        return False


def _is_group(tree: Mapping[Any, Any]) -> bool:
    """True if a map holds groups and parameters of a schema, and at least one parameter."""
    if 'ros__parameters' in tree or not all(isinstance(branch, dict) for branch in tree.values()):
        return False
    return any(_is_parameter(branch) or _is_group(branch) for branch in tree.values())


def _is_parameter(branch: Mapping[Any, Any]) -> bool:
    """True if a map of a schema is a parameter: it holds what a group has no place for."""
    return any(key in branch and not isinstance(branch[key], dict) for key in _SAID_OF_A_PARAMETER)


def _read_schema(content: Mapping[Any, Any]) -> Iterator[NodeDescription]:
    for name, tree in content.items():
        parameters = {'.'.join(path): _described('.'.join(path), leaf) for path, leaf in _leaves(tree)}
        yield NodeDescription(f'/{name}', parameters, AS_DECLARED, schema=str(name))


def _leaves(tree: Mapping[Any, Any], path: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], Mapping[Any, Any]]]:
    """Yield the parameters of a schema."""
    for key, branch in tree.items():
        name = '.'.join((*path, str(key)))
        if not isinstance(branch, dict):
            raise _Unfit(f'{name} is neither a parameter nor a group: it should be a map')
        if not _is_parameter(branch):
            yield from _leaves(branch, (*path, str(key)))
        elif 'type' in branch:
            yield (*path, str(key)), branch
        else:
            raise _Unfit(f'{name} has no type; the types are {", ".join(_TYPES)}')


def _read_saved(content: Mapping[Any, Any]) -> Descriptions:
    if content[_FORMAT] != VERSION or content[_FORMAT] is True:
        raise _Unfit(f'it is in version {content[_FORMAT]!r} of the format, and this program knows version {VERSION}')
    result = []
    for node, each in _map(content.get('nodes'), 'nodes').items():
        if not isinstance(node, str) or not node.startswith('/'):
            raise _Unfit(f'{node!r} is not the name of a node: it must start with a slash')
        parameters = _map(_map(each, node).get('parameters'), f'the parameters of {node}')
        result.append(NodeDescription(
            node, {str(name): _described(str(name), _map(leaf, f'{node}: {name}'))
                   for name, leaf in parameters.items()}, str(each.get('defaults', AS_FOUND)),
            each.get('allows_undeclared') is True, str(each.get('schema') or '')))
    return Descriptions(result, complete=content.get('complete') is True)


def _map(content: Any, what: str) -> dict[Any, Any]:
    if not isinstance(content, dict):
        raise _Unfit(f'{what} should be a map, and is {values.format_value(content, 60)}')
    return content


def _described(name: str, leaf: Mapping[Any, Any]) -> DescribedParameter:
    word = leaf.get('type')
    validation: dict[str, tuple[Any, ...]] = {}
    if fixed := _FIXED.fullmatch(str(word)):
        word = fixed[1]
        validation['at_most'] = (int(fixed[2]),)
    if not isinstance(word, str) or word not in _TYPES:
        raise _Unfit(f'{name} has the type {word!r}; the types are {", ".join(_TYPES)}')
    parameter_type = _TYPES[word]
    for key, arguments in _map(leaf.get('validation') or {}, f'the validation of {name}').items():
        listed = arguments if isinstance(arguments, list) else [] if arguments is None else [arguments]
        validation[str(key).removesuffix('<>')] = tuple(listed)
    descriptor = Descriptor(
        name, parameter_type, str(leaf.get('description') or ''), str(leaf.get('additional_constraints') or ''),
        leaf.get('read_only') is True, leaf.get('dynamic_typing') is True, _range(name, leaf.get('range')))
    return DescribedParameter(descriptor, _default(name, parameter_type, leaf), validation, str(leaf.get('unit') or ''))


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
    elif parameter_type is values.DOUBLE and type(value) is int:
        value = float(value)
    elif parameter_type is values.DOUBLE_ARRAY and isinstance(value, list):
        value = [float(each) if type(each) is int else each for each in value]
    dynamic = parameter_type is values.NOT_SET
    if not dynamic and not (parameter_type.accepts(value) or (parameter_type.is_array and value == [])):
        raise _Unfit(f'the default value of {name} is not a {parameter_type.label}: {values.format_value(value, 60)}')
    return value
