"""What a launch file is made of: the actions of ``launch`` and ``launch_ros`` that the lessons use.

They hold what they were given, and turn it into command lines; nothing here starts a process. What the genuine classes
reject when they are made is rejected then, too.
"""

import re
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import yaml
from rclpy.exceptions import InvalidNamespaceException, InvalidNodeNameException
from rclpy.validate_namespace import validate_namespace
from rclpy.validate_node_name import validate_node_name

from param_tools.cli.launch.substitutions import (
    FULL_INSTALLATION,
    Context,
    FindPackageShare,
    LaunchConfiguration,
    LaunchFailed,
    expect_string,
    perform,
)
from param_tools.cli.launch.values import flat, parameter_value

# Where the two streams of a program go, for each word that output= takes; a program's own log file is not kept here.
_OUTPUTS = {
    'screen': {'both': {'screen'}},
    'log': {'both': {'log'}, 'stderr': {'screen'}},
    'both': {'both': {'log', 'screen'}},
    'own_log': {'both': {'own_log'}},
    'full': {'both': {'screen', 'log', 'own_log'}},
}


class DeclareLaunchArgument:
    """An argument of the launch file, given as ``name:=value``."""

    def __init__(self, name: str, *, default_value: Any = None, description: str | None = None,
                 choices: list[str] | None = None):
        if default_value is not None:
            expect_string(default_value)
        if choices is not None and not choices:
            raise LaunchFailed('Provided choices arg is empty. Use None to ignore the choice list.')
        if choices is not None and isinstance(default_value, str) and default_value not in choices:
            raise LaunchFailed(f'Provided default_value "{default_value}" is not in provided choices "{choices}".')
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


class SetParameter:
    """A parameter for every node that comes later in the launch file."""

    def __init__(self, name: Any, value: Any):
        self.name = name
        self.value = value

    def set(self, context: Context) -> None:
        """Put it into the context."""
        name = perform(self.name, context)
        values = (flat(self.value, context, f'{name}.') if isinstance(self.value, Mapping)
                  else {name: parameter_value(name, self.value, context)})
        context.parameters.extend(values.items())


class ParameterFile:
    """A parameter file; with ``allow_substs=True`` it may hold substitutions, as ``$(var name)``."""

    # A character after a backslash, a substitution, or the beginning of what is none.
    _TOKENS = re.compile(r'\\(?P<escaped>.)|\$\((?P<kind>[A-Za-z][\w-]*) (?P<argument>[^\s\'"\\$()]+)\)|(?P<open>\$\()')

    def __init__(self, param_file: Any, *, allow_substs: bool = False):
        if not isinstance(allow_substs, bool):
            raise LaunchFailed(f'ParameterFile(allow_substs=…) takes True or False, not {allow_substs!r}')
        self.param_file = param_file
        self.allow_substs = allow_substs

    def evaluate(self, context: Context) -> Path:
        """Return the path of a file without substitutions.

        :raises LaunchFailed: there is no such file to substitute in, or it is not YAML afterwards.
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
            if token['kind'] == 'var':
                return LaunchConfiguration(token['argument']).perform(context)
            if token['kind'] == 'find-pkg-share':
                return FindPackageShare(token['argument']).perform(context)
            line = text[token.start():].partition('\n')[0]
            raise LaunchFailed(f"the course's own ros2 launch knows $(var name) and $(find-pkg-share package) in a "
                               f'parameter file, and not {line}. {FULL_INSTALLATION}')

        text = self._TOKENS.sub(substituted, text)
        try:
            yaml.safe_load(text)
        except (yaml.YAMLError, ValueError):
            raise LaunchFailed('The substituted parameter file is not a valid yaml file') from None
        return _written(text, context)


def _written(text: str, context: Context) -> Path:
    with tempfile.NamedTemporaryFile('w', prefix='launch_params_', dir=context.folder, delete=False,
                                     encoding='utf-8') as file:
        file.write(text)
    return Path(file.name)


@dataclass(kw_only=True)
class Node:
    """A node, started in a process of its own."""

    executable: Any
    package: Any = None
    name: Any = None
    namespace: Any = None
    parameters: list[Any] | None = None
    remappings: Sequence[tuple[Any, Any]] = ()
    arguments: Sequence[Any] = ()
    ros_arguments: Sequence[Any] = ()
    output: Any = 'log'
    emulate_tty: bool = False

    def __post_init__(self) -> None:
        if self.package is None:
            raise LaunchFailed(f"the course's own ros2 launch needs package= for a Node. {FULL_INSTALLATION}")
        if self.parameters is not None and not isinstance(self.parameters, list):
            raise LaunchFailed(f"'Node' expected 'parameters' to be a list, but got a value of type "
                               f"'{type(self.parameters).__name__}'")

    def command(self, program: list[str], context: Context) -> list[str]:
        """Return the command line, as launch_ros makes it.

        :param program: The words that start the executable.
        """
        name, namespace = self._full_name(context)
        words = [*program, *(perform(word, context) for word in self.arguments or ()), '--ros-args',
                 *(perform(word, context) for word in self.ros_arguments or ())]
        if name is not None:
            words += ['-r', f'__node:={name}']
        if namespace is not None:
            words += ['-r', f'__ns:={namespace}']
        for parameter, value in context.parameters:
            # As Python writes it, and a list as a tuple: so do the genuine ones. rcl guesses the type again.
            words += ['-p', f'{parameter}:={tuple(value) if isinstance(value, list) else value}']
        # The full name where the launch file gives it, and every node's where it does not.
        key = '/**' if name is None or namespace is None else f'{namespace.rstrip("/")}/{name}'
        for source in self.parameters or ():
            if isinstance(source, Mapping):
                values = {key: {'ros__parameters': flat(source, context)}}
                path = _written(yaml.dump(values, default_flow_style=False), context)
            else:
                path = (source if isinstance(source, ParameterFile) else ParameterFile(source)).evaluate(context)
                if not path.is_file():
                    context.warn(f'Parameter file path is not a file: {path}')
                    continue
            words += ['--params-file', str(path)]
        for old, new in self.remappings or ():
            words += ['-r', f'{perform(old, context)}:={perform(new, context)}']
        return words

    def streams_on_screen(self, context: Context) -> tuple[bool, bool]:
        """True for each of standard output and standard error that is shown."""
        where = self.output if isinstance(self.output, Mapping) else _OUTPUTS.get(perform(self.output, context))
        if where is None:
            raise LaunchFailed(f'{self.output} is not a valid standard output config i.e. "screen", "log" or "both"')
        for source, target in where.items():
            if source not in ('stdout', 'stderr', 'both'):
                raise LaunchFailed(f'{source} is not a valid output source i.e. "stdout", "stderr" or "both"')
            for each in {target} if isinstance(target, str) else target:
                if each not in ('screen', 'log', 'own_log'):
                    raise LaunchFailed(f'{each} is not a valid output destination i.e. "screen", "log" or "own_log"')
        stdout, stderr = ('screen' in where.get('both', ()) or 'screen' in where.get(stream, ())
                          for stream in ('stdout', 'stderr'))
        return stdout, stderr

    def _full_name(self, context: Context) -> tuple[str | None, str | None]:
        name = perform(self.name, context) if self.name is not None else None
        namespace = perform(self.namespace, context) if self.namespace is not None else None
        if namespace is not None:
            namespace = '/' + namespace.rstrip('/') if not namespace.startswith('/') else namespace.rstrip('/') or '/'
        try:
            if name is not None:
                validate_node_name(name)
            if namespace is not None:
                validate_namespace(namespace)
        except (InvalidNodeNameException, InvalidNamespaceException) as error:
            # The third line points at a character of the second, which is the name.
            what, which, *_ = str(error).splitlines()
            raise LaunchFailed(f'{what} {which.strip()}') from None
        return name, namespace


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
        if not isinstance(entity, (Node, DeclareLaunchArgument, SetParameter)):
            raise LaunchFailed(f'a LaunchDescription takes Node, DeclareLaunchArgument and SetParameter here, not '
                               f'{entity!r}. {FULL_INSTALLATION}')
