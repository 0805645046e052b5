"""Substitutions: strings that are known only when a launch file is carried out.

Where a launch file takes a substitution, it also takes a string, and several of both, which are joined.
"""

import math
import shlex
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import yaml

from param_tools.cli import index
from param_tools.cli.launch.context import Context, LaunchFailed

TRUTH = {'true': True, '1': True, 'false': False, '0': False}
"""What conditions and comparisons take as booleans, in small letters."""


class Substitution:
    """A string that is known only when the launch file is carried out."""

    def perform(self, context: Context) -> str:
        """Return the string."""
        raise NotImplementedError

    def describe(self) -> str:
        """Return the substitution as ``--show-args`` prints it; of those that no default in a chapter is, the name."""
        return f'{type(self).__name__}(…)'


class TextSubstitution(Substitution):
    """A string that is known already."""

    def __init__(self, *, text: str):
        self.text = text

    def perform(self, context: Context) -> str:
        return self.text

    def describe(self) -> str:
        return repr(self.text)


class LaunchConfiguration(Substitution):
    """The value of a launch argument."""

    def __init__(self, variable_name: Any, *, default: Any = None):
        self.variable_name = variable_name
        if default is not None and not isinstance(default, (str, Substitution)):
            # As in launch, which takes numbers, too.
            default = [part if isinstance(part, (str, Substitution)) else str(part)
                       for part in (default if is_list(default) else [default])]
        self.default = default

    def perform(self, context: Context) -> str:
        name = perform(self.variable_name, context)
        if name in context.launch_configurations:
            return str(context.launch_configurations[name])
        if self.default is None:
            raise LaunchFailed(f"launch configuration '{name}' does not exist")
        return perform(self.default, context)

    def describe(self) -> str:
        return f'LaunchConfig({describe(self.variable_name)})'


class PathJoinSubstitution(Substitution):
    """A path made of parts."""

    def __init__(self, substitutions: Iterable[Any]):
        self.substitutions = list(substitutions)

    def perform(self, context: Context) -> str:
        return str(Path(*(perform(part, context) for part in self.substitutions)))

    def describe(self) -> str:
        return f"PathJoin('{describe(self.substitutions)}')"


class PathSubstitution(PathJoinSubstitution):
    """A path to which ``/`` adds parts; it is newer than launch 3.4.3, and launch files for Jazzy use it."""

    def __init__(self, path: Any):
        super().__init__([path])

    def __truediv__(self, part: Any) -> 'PathSubstitution':
        return PathSubstitution(PathJoinSubstitution([*self.substitutions, part]))


class FindPackageShare(Substitution):
    """The share folder of a package."""

    def __init__(self, package: Any):
        self.package = package

    def find(self, package_name: str) -> str:
        """Return the folder of a package."""
        return str(index.share_folder_of(package_name))

    def perform(self, context: Context) -> str:
        return self.find(perform(self.package, context))

    def describe(self) -> str:
        return f'{type(self).__name__}(pkg={describe(self.package)})'


class FindPackagePrefix(FindPackageShare):
    """The install space that holds a package."""

    def find(self, package_name: str) -> str:
        return str(Path(super().find(package_name)).parents[1])


class Parameter(Substitution):
    """The value of a parameter that SetParameter gives to every node."""

    def __init__(self, name: Any, *, default: Any = None):
        self.name = name
        self.default = default

    def perform(self, context: Context) -> str:
        name = perform(self.name, context)
        for each in context.launch_configurations.get('global_params', []):
            if isinstance(each, tuple) and each[0] == name:
                return str(each[1])
        if self.default is None:
            raise LaunchFailed(f"parameter '{name}' not found")
        return perform(self.default, context)


class ExecutableInPackage(Substitution):
    """The path of a package's program."""

    def __init__(self, executable: Any, package: Any):
        self.executable = executable
        self.package = package

    def perform(self, context: Context) -> str:
        return context.find_program(perform(self.package, context), perform(self.executable, context))[-1]


class EnvironmentVariable(Substitution):
    """The value of an environment variable."""

    def __init__(self, name: Any, *, default_value: Any = None):
        self.name = name
        self.default_value = default_value

    def perform(self, context: Context) -> str:
        name = perform(self.name, context)
        if name in context.environment:
            return context.environment[name]
        if self.default_value is None:
            raise LaunchFailed(f"environment variable '{name}' does not exist")
        return perform(self.default_value, context)

    def describe(self) -> str:
        return f'EnvVar({describe(self.name)})'


class PythonExpression(Substitution):
    """What Python makes of an expression."""

    def __init__(self, expression: Any):
        self.expression = expression

    def perform(self, context: Context) -> str:
        expression = perform(self.expression, context)
        try:
            # As in launch, the names of math need no module before them.
            return str(eval(expression, {}, {**vars(math), 'math': math}))
        except Exception as error:
            raise LaunchFailed(f'the expression {expression!r} fails: {type(error).__name__}: {error}') from error


class ThisLaunchFileDir(Substitution):
    """The folder of the launch file that was included last."""

    def perform(self, context: Context) -> str:
        if context.launch_file is None:
            raise LaunchFailed('ThisLaunchFileDir used outside of a launch file (in a script)')
        return str(context.launch_file.parent)


class FindExecutable(Substitution):
    """The path of a program on the PATH."""

    def __init__(self, *, name: Any):
        self.name = name

    def perform(self, context: Context) -> str:
        return context.find_executable(perform(self.name, context))


class Command(Substitution):
    """What a command prints."""

    def __init__(self, command: Any):
        self.command = command

    def perform(self, context: Context) -> str:
        words = shlex.split(perform(self.command, context))
        if not words:
            raise LaunchFailed('a Command without a command')
        return context.output_of(words)


class FileContent(Substitution):
    """The text of a file."""

    def __init__(self, path: Any):
        self.path = path

    def perform(self, context: Context) -> str:
        path = perform(self.path, context)
        try:
            return Path(path).read_text(encoding='utf-8')
        except OSError as error:
            raise LaunchFailed(f'{error.strerror}: {path}') from None


class _Logical(Substitution):
    """A substitution that is ``true`` or ``false``."""

    def __init__(self, *values: Any):
        self.values = values

    def perform(self, context: Context) -> str:
        return str(self.holds([perform(value, context) for value in self.values])).lower()

    def holds(self, texts: list[str]) -> bool:
        """Return whether it is true of these texts."""
        raise NotImplementedError


class AndSubstitution(_Logical):
    """True if both values are."""

    def __init__(self, left: Any, right: Any):
        super().__init__(left, right)

    def holds(self, texts: list[str]) -> bool:
        return all([as_bool(text) for text in texts])  # both are read


class NotSubstitution(_Logical):
    """True if the value is not."""

    def __init__(self, value: Any):
        super().__init__(value)

    def holds(self, texts: list[str]) -> bool:
        return not as_bool(texts[0])


class EqualsSubstitution(_Logical):
    """True if two values are equal as booleans, as numbers, or as texts."""

    def __init__(self, left: Any, right: Any):
        super().__init__(*(value if isinstance(value, str) or is_substitution(value) else '' if value is None
                           else str(value).lower() if isinstance(value, bool) else str(value)
                           for value in (left, right)))

    def holds(self, texts: list[str]) -> bool:
        booleans = [TRUTH.get(text.lower()) for text in texts]
        if None not in booleans:
            return booleans[0] is booleans[1]
        try:
            return math.isclose(*map(float, texts))
        except ValueError:
            return texts[0] == texts[1]


class NotEqualsSubstitution(EqualsSubstitution):
    """True if two values are not equal."""

    def holds(self, texts: list[str]) -> bool:
        return not super().holds(texts)


class IfElseSubstitution(Substitution):
    """One of two values."""

    def __init__(self, condition: Any, if_value: Any = '', else_value: Any = ''):
        self.condition, self.if_value, self.else_value = condition, if_value, else_value

    def perform(self, context: Context) -> str:
        return perform(self.if_value if as_bool(perform(self.condition, context)) else self.else_value, context)


def as_bool(text: str) -> bool:
    """Return what a text says as a boolean, as YAML has it; 1 and 0 are booleans, too."""
    try:
        found = {'1': True, '0': False}.get(text, yaml.safe_load(text) if text else None)
    except yaml.YAMLError:
        found = None
    if not isinstance(found, bool):
        raise LaunchFailed(f"Cannot convert value '{text}' to '{bool}'")
    return found


def typed_bool(value: Any, context: Context) -> bool:
    """Return a boolean, or the one that a substitution stands for."""
    return value if isinstance(value, bool) else as_bool(perform(value, context))


def is_list(value: Any) -> bool:
    """True for a value with several parts, which a string and a dictionary are not."""
    return isinstance(value, Iterable) and not isinstance(value, (str, bytes, Mapping))


def is_substitution(value: Any) -> bool:
    """True for a substitution, and for a list of strings and substitutions with at least one substitution."""
    return isinstance(value, Substitution) or (
        is_list(value) and all(isinstance(part, (str, Substitution)) for part in value)
        and any(isinstance(part, Substitution) for part in value))


def expect_string(value: Any) -> None:
    """Expect what ``perform`` takes: a string, a substitution, or a list of these."""
    if not all(isinstance(part, (str, Substitution)) for part in (value if is_list(value) else [value])):
        raise LaunchFailed(f'the launch file has {value!r} where a string or a substitution belongs')


def perform(value: Any, context: Context) -> str:
    """Return the string that a value stands for."""
    expect_string(value)
    if isinstance(value, str):
        return value
    return value.perform(context) if isinstance(value, Substitution) else ''.join(
        perform(part, context) for part in value)


def describe(value: Any) -> str:
    """Return a value that ``perform`` takes as ``--show-args`` prints it."""
    if isinstance(value, str):
        return repr(value)
    return value.describe() if isinstance(value, Substitution) else ' + '.join(map(describe, value))
