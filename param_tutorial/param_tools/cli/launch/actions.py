"""What a launch file is made of: a LaunchDescription, and the actions of ``launch`` and ``launch_ros`` in it.

An action is carried out by ``execute``, which returns the programs to start. Nothing here starts a process, so a
mistake anywhere in a launch file leaves nothing running.
"""

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import yaml
from rclpy.exceptions import NameValidationException
from rclpy.validate_namespace import validate_namespace
from rclpy.validate_node_name import validate_node_name

from param_tools.cli.launch.context import FULL_INSTALLATION, Context, LaunchFailed
from param_tools.cli.launch.parameters import ParameterFile, flat
from param_tools.cli.launch.processes import Program
from param_tools.cli.launch.substitutions import expect_string, perform
from param_tools.cli.run import find_program
from param_tools.cli.session import CommandFailed

# Where the two streams of a program go, for each word that output= takes. A program's log file is not kept here.
_OUTPUTS: dict[str, dict[str, Any]] = {
    'screen': {'both': 'screen'}, 'log': {'both': 'log', 'stderr': 'screen'}, 'both': {'both': 'screen'},
    'own_log': {'both': 'own_log'}, 'full': {'both': 'screen'}}


class Action:
    """An entry of a launch description."""

    def execute(self, context: Context) -> list[Program]:
        """Carry out the action, and return the programs to start.

        :raises LaunchFailed: that cannot be done.
        """
        raise NotImplementedError

    def declared_arguments(self) -> list['DeclareLaunchArgument']:
        """Return the arguments of the launch file that the action declares."""
        return []


class DeclareLaunchArgument(Action):
    """An argument of the launch file, given as ``name:=value``."""

    def __init__(self, name: str, *, default_value: Any = None, description: str | None = None,
                 choices: list[str] | None = None):
        if default_value is not None:
            expect_string(default_value)
        self.name = name
        self.default_value = default_value
        self.choices = choices
        self.description = description or ('no description given' if choices is None else f'One of: {choices}')
        if description and choices is not None:
            self.description = f'{description.rstrip(".")}. Valid choices are: {choices}'

    def execute(self, context: Context) -> list[Program]:
        if self.name not in context.arguments:
            if self.default_value is None:
                context.log_error(f'Required launch argument "{self.name}" (description: "{self.description}") was not '
                                  f'provided')
                raise LaunchFailed(f'Required launch argument "{self.name}" was not provided.')
            context.arguments[self.name] = perform(self.default_value, context)
        given = context.arguments[self.name]
        if self.choices is not None and given not in self.choices:
            error = f'Argument "{self.name}" provided value "{given}" is not valid. Valid options are: {self.choices}'
            context.log_error(error)
            raise LaunchFailed(error)
        return []

    def declared_arguments(self) -> list['DeclareLaunchArgument']:
        return [self]


@dataclass
class SetParameter(Action):
    """A parameter for every node that comes later in the launch file."""

    name: Any
    value: Any

    def execute(self, context: Context) -> list[Program]:
        name = perform(self.name, context)
        context.parameters.extend(flat({name: self.value}, context).items())
        return []


@dataclass(kw_only=True)
class Node(Action):
    """A node, started in a process of its own."""

    executable: Any
    package: Any = None
    name: Any = None
    namespace: Any = None
    parameters: list[Any] | None = None
    remappings: Sequence[tuple[Any, Any]] | None = None
    arguments: Sequence[Any] | None = None
    ros_arguments: Sequence[Any] | None = None
    output: Any = 'log'
    emulate_tty: bool = False

    def __post_init__(self) -> None:
        if self.package is None:
            raise LaunchFailed(f'the embedded ros2 launch needs package= for a Node. {FULL_INSTALLATION}')
        if self.parameters is not None and not isinstance(self.parameters, list):
            raise LaunchFailed(f"'Node' expected 'parameters' to be a list, but got a value of type "
                               f"'{type(self.parameters).__name__}'")
        for option, value in (('arguments', self.arguments), ('ros_arguments', self.ros_arguments)):
            if not isinstance(value, Iterable | None):
                raise LaunchFailed(f"'Node' expected '{option}' to be a list of strings and substitutions, but got "
                                   f'{value!r}')
        rules = [] if self.remappings is None else self.remappings
        if not isinstance(rules, Iterable) or not all(isinstance(rule, tuple) and len(rule) == 2 for rule in rules):
            raise LaunchFailed(f"'Node' expected 'remappings' to be a list of pairs such as ('old', 'new'), but got "
                               f'{self.remappings!r}')

    def execute(self, context: Context) -> list[Program]:
        executable = perform(self.executable, context)
        program = find_program(perform(self.package, context), executable)
        return [Program(self.command(program, context), executable, *self.streams_on_screen(context))]

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
            # As Python writes the value, a list as a tuple: so does launch_ros. rcl guesses the type again.
            words += ['-p', f'{parameter}:={value}']
        # The full name where the launch file gives it, and every node's where it does not.
        key = '/**' if name is None or namespace is None else f'{namespace.rstrip("/")}/{name}'
        for source in self.parameters or ():
            if isinstance(source, Mapping):
                path = context.write(yaml.safe_dump({key: {'ros__parameters': flat(source, context)}}))
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
        output = self.output if isinstance(self.output, Mapping) else _OUTPUTS.get(perform(self.output, context))
        if output is None or not output.keys() <= {'stdout', 'stderr', 'both'} or not all(
                isinstance(value, str | Collection) for value in output.values()):
            raise LaunchFailed(f'output={self.output!r} is not valid: use {", ".join(map(repr, _OUTPUTS))}, or a '
                               f"dictionary such as {{'stdout': 'screen', 'stderr': 'log'}}")
        stdout, stderr = ('screen' in output.get('both', ()) or 'screen' in output.get(stream, ())
                          for stream in ('stdout', 'stderr'))
        return stdout, stderr

    def _full_name(self, context: Context) -> tuple[str | None, str | None]:
        name, namespace = (None if each is None else perform(each, context) for each in (self.name, self.namespace))
        try:
            if name is not None:
                validate_node_name(name)
            if namespace is not None:
                namespace = (namespace if namespace.startswith('/') else f'/{namespace}').rstrip('/') or '/'
                validate_namespace(namespace)
        except NameValidationException as error:
            # The third line points at a character of the second, which is the name.
            what, which, *_ = str(error).splitlines()
            raise LaunchFailed(f'{what} {which.strip()}') from None
        return name, namespace


class LaunchDescription(Action):
    """What a launch file starts, in this order."""

    def __init__(self, entities: Sequence[Action] | None = None):
        self.entities: list[Action] = []
        for entity in entities or ():
            self.add_action(entity)

    def add_action(self, action: Action) -> None:
        """Add an action at the end."""
        if not isinstance(action, Action):
            raise LaunchFailed(f'a LaunchDescription takes actions such as Node(...), not {action!r}')
        self.entities.append(action)

    def execute(self, context: Context) -> list[Program]:
        try:
            return [program for entity in self.entities for program in entity.execute(context)]
        except CommandFailed as error:  # no such package, no such program
            raise LaunchFailed(error) from error
        except (TypeError, ValueError) as error:  # a null character in a path, for example
            raise LaunchFailed(f'{type(error).__name__}: {error}') from error

    def declared_arguments(self) -> list[DeclareLaunchArgument]:
        return [argument for entity in self.entities for argument in entity.declared_arguments()]
