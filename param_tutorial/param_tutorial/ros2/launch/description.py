"""What a launch file is made of: the classes of ``launch`` and ``launch_ros`` that the lessons use.

They hold what they were given, and turn it into text and command lines; nothing here starts a process.
"""

import tempfile
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import yaml

from param_tutorial.ros2 import index
from param_tutorial.ros2.session import CommandFailed

FULL_INSTALLATION = 'A full installation knows more: environment/README.md says how to get one'


class LaunchFailed(CommandFailed):
    """What a launch file asks for cannot be done."""


@dataclass
class Context:
    """What is known while a description is carried out."""

    arguments: dict[str, str]
    """The launch configurations: what was given, and the defaults of what was not."""
    folder: Path
    """Where parameter files may be written."""
    warn: Callable[[str], object]
    """Warns the learner."""


class Substitution:
    """A text that is known only when the launch file is carried out."""

    def perform(self, context: Context) -> str:
        """Return the text."""
        raise NotImplementedError

    def describe(self) -> str:
        """Return it as ``--show-args`` shows it."""
        raise NotImplementedError


class TextSubstitution(Substitution):
    """A text that is known already."""

    def __init__(self, *, text: str):
        self.text = text

    def perform(self, context: Context) -> str:
        return self.text

    def describe(self) -> str:
        return repr(self.text)


class LaunchConfiguration(Substitution):
    """The value of a launch argument."""

    def __init__(self, variable_name: str, *, default: Any = None):
        self.variable_name = variable_name
        self.default = default

    def perform(self, context: Context) -> str:
        if self.variable_name in context.arguments:
            return context.arguments[self.variable_name]
        if self.default is None:
            raise LaunchFailed(f"launch configuration '{self.variable_name}' does not exist")
        return perform(self.default, context)

    def describe(self) -> str:
        return f'LaunchConfiguration({self.variable_name!r})'


class PathJoinSubstitution(Substitution):
    """A path made of parts."""

    def __init__(self, substitutions: Iterable[Any]):
        self.substitutions = list(substitutions)

    def perform(self, context: Context) -> str:
        return str(Path(*(perform(part, context) for part in self.substitutions)))

    def describe(self) -> str:
        return f'PathJoin({" + ".join(map(describe, self.substitutions))})'


class FindPackageShare(Substitution):
    """The share folder of a package."""

    def __init__(self, package: Any):
        self.package = package

    def perform(self, context: Context) -> str:
        return str(index.share_folder_of(perform(self.package, context)))

    def describe(self) -> str:
        return f'FindPackageShare(pkg={describe(self.package)})'


def perform(value: Any, context: Context) -> str:
    """Return the text that something stands for: a text, a substitution, or several of them in a row."""
    if isinstance(value, (str, Path)):
        return str(value)
    if isinstance(value, Substitution):
        return value.perform(context)
    if isinstance(value, Iterable):
        return ''.join(perform(part, context) for part in value)
    raise LaunchFailed(f'a text or a substitution was expected in the launch file, not {value!r}')


def describe(value: Any) -> str:
    """Return something that ``perform`` takes as ``--show-args`` shows it."""
    if isinstance(value, (str, Path)):
        return repr(str(value))
    return value.describe() if isinstance(value, Substitution) else ' + '.join(map(describe, value))


@dataclass
class ParameterValue:
    """A parameter's value with the type that it shall have, whatever it looks like."""

    value: Any
    value_type: type | None = None

    def evaluate(self, context: Context) -> Any:
        if self.value_type not in (str, int, float, bool, None):
            raise LaunchFailed(f"ParameterValue(value_type={self.value_type!r}): the course's own ros2 launch knows "
                               f'str, int, float and bool. {FULL_INSTALLATION}')
        if self.value_type is str:
            return perform(self.value, context) if not isinstance(self.value, (bool, int, float)) else str(self.value)
        value = parameter_value(self.value, context)
        if self.value_type is None or type(value) is self.value_type:
            return value
        if self.value_type is float and type(value) is int:
            return float(value)
        raise LaunchFailed(f'{value!r} was given where the launch file wants a value of type '
                           f'{self.value_type.__name__}')


def parameter_value(value: Any, context: Context) -> Any:
    """Return the value of a parameter as launch_ros understands it: a substitution's text is read as YAML."""
    if isinstance(value, ParameterValue):
        return value.evaluate(context)
    if isinstance(value, (bool, int, float, str)):
        return value
    if isinstance(value, Substitution):
        return yaml.safe_load(value.perform(context))
    if isinstance(value, Sequence) and value:
        if any(isinstance(part, Substitution) for part in value):
            return yaml.safe_load(perform(value, context))
        kinds = {type(part) for part in value}
        if kinds == {int, float}:
            return [float(part) for part in value]
        if len(kinds) == 1 and kinds <= {bool, int, float, str}:
            return list(value)
    raise LaunchFailed(f'{value!r} in the launch file cannot be the value of a parameter: it takes a bool, int, float '
                       f'or str, a list of one of these that is not empty, or a substitution')


def flat(parameters: Mapping[Any, Any], context: Context, prefix: str = '') -> dict[str, Any]:
    """Return names and values of a dictionary of parameters, inner dictionaries with dots in their names."""
    result: dict[str, Any] = {}
    for key, value in parameters.items():
        name = prefix + perform(key, context)
        if isinstance(value, Mapping):
            result.update(flat(value, context, f'{name}.'))
        else:
            result[name] = parameter_value(value, context)
    return result


class DeclareLaunchArgument:
    """An argument of the launch file, given as ``name:=value``."""

    def __init__(self, name: str, *, default_value: Any = None, description: str | None = None,
                 choices: list[str] | None = None):
        self.name = name
        self.default_value = default_value
        self.choices = choices
        self.description = description or ('no description given' if choices is None else f'One of: {choices}')
        if description and choices is not None:
            self.description = f'{description.rstrip(".")}. Valid choices are: {choices}'

    def declare(self, context: Context) -> None:
        """Put its default into the context, unless it was given."""
        if self.name not in context.arguments:
            if self.default_value is None:
                raise LaunchFailed(f'Required launch argument "{self.name}" was not provided.')
            context.arguments[self.name] = perform(self.default_value, context)
        given = context.arguments[self.name]
        if self.choices is not None and given not in self.choices:
            raise LaunchFailed(f'Argument "{self.name}" provided value "{given}" is not valid. Valid options are: '
                               f'{self.choices}')


@dataclass(kw_only=True)
class Node:
    """A node, started in a process of its own."""

    executable: Any
    package: Any
    name: Any = None
    namespace: Any = None
    parameters: Sequence[Any] = ()
    remappings: Sequence[tuple[Any, Any]] = ()
    arguments: Sequence[Any] = ()
    ros_arguments: Sequence[Any] = ()
    output: Any = 'log'
    emulate_tty: bool = False

    def command(self, program: list[str], context: Context) -> list[str]:
        """Return the command line, as launch_ros makes it.

        :param program: The words that start the executable.
        """
        words = [*program, *(perform(word, context) for word in self.arguments or ()), '--ros-args',
                 *(perform(word, context) for word in self.ros_arguments or ())]
        if self.name is not None:
            words += ['-r', f'__node:={perform(self.name, context)}']
        namespace = perform(self.namespace, context) if self.namespace is not None else ''
        if namespace:
            namespace = '/' + namespace.lstrip('/')
            words += ['-r', f'__ns:={namespace}']
        if isinstance(self.parameters, (str, Mapping)):
            raise LaunchFailed(f'parameters= of a Node takes a list of files and dictionaries, not '
                               f'{self.parameters!r}')
        for source in self.parameters or ():
            if isinstance(source, Mapping):
                path = self._write(flat(source, context), namespace, context)
            else:
                path = perform(source, context)
                if not Path(path).is_file():
                    context.warn(f'Parameter file path is not a file: {path}')
                    continue
            words += ['--params-file', path]
        for old, new in self.remappings or ():
            words += ['-r', f'{perform(old, context)}:={perform(new, context)}']
        return words

    def _write(self, values: dict[str, Any], namespace: str, context: Context) -> str:
        # As launch_ros: the full name where the launch file gives it, and every node's where it does not.
        known = self.name is not None and namespace
        key = f'{namespace.rstrip("/")}/{perform(self.name, context)}' if known else '/**'
        with tempfile.NamedTemporaryFile('w', prefix='launch_params_', dir=context.folder, delete=False) as file:
            yaml.dump({key: {'ros__parameters': values}}, file, default_flow_style=False)
        return file.name


@dataclass
class LaunchDescription:
    """What a launch file starts, in this order."""

    entities: Sequence[Any] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.entities = list(self.entities or ())
        for entity in self.entities:
            self._check(entity)

    def add_action(self, action: Any) -> None:
        """Add something at the end."""
        self._check(action)
        self.entities = [*self.entities, action]

    def _check(self, entity: Any) -> None:
        if not isinstance(entity, (Node, DeclareLaunchArgument)):
            raise LaunchFailed(f'a LaunchDescription takes Node and DeclareLaunchArgument here, not {entity!r}. '
                               f'{FULL_INSTALLATION}')
