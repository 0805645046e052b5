"""Substitutions: strings that are known only when a launch file is carried out.

Where a launch file takes a substitution, it also takes a string, and several of both, which are joined.
"""

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from param_tools.cli import index
from param_tools.cli.launch.context import Context, LaunchFailed


class Substitution:
    """A string that is known only when the launch file is carried out."""

    def perform(self, context: Context) -> str:
        """Return the string."""
        raise NotImplementedError

    def describe(self) -> str:
        """Return the substitution as ``--show-args`` prints it."""
        raise NotImplementedError


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
        self.default = default

    def perform(self, context: Context) -> str:
        name = perform(self.variable_name, context)
        if name in context.arguments:
            return context.arguments[name]
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


class FindPackageShare(Substitution):
    """The share folder of a package."""

    def __init__(self, package: Any):
        self.package = package

    def perform(self, context: Context) -> str:
        return str(index.share_folder_of(perform(self.package, context)))

    def describe(self) -> str:
        return f'FindPackageShare(pkg={describe(self.package)})'


def is_list(value: Any) -> bool:
    """True for a value with several parts, which a string and a dictionary are not."""
    return isinstance(value, Iterable) and not isinstance(value, (str, bytes, Mapping))


def is_substitution(value: Any) -> bool:
    """True for a substitution, and for a list of strings and substitutions with at least one substitution."""
    return isinstance(value, Substitution) or (
        is_list(value) and all(isinstance(part, (str, Substitution)) for part in value)
        and any(isinstance(part, Substitution) for part in value))


def expect_string(value: Any) -> None:
    """Expect what ``perform`` takes: a string, a substitution, or a list of these.

    :raises LaunchFailed: the value is something else.
    """
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
