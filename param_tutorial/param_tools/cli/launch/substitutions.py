"""Strings that are known only when a launch file is carried out, and what else may stand where one is expected."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from param_tools.cli import index
from param_tools.cli.session import CommandFailed

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
    """Warn the learner."""
    parameters: list[tuple[str, Any]] = field(default_factory=list)
    """What ``SetParameter`` gives to every node that comes later."""


class Substitution:
    """A string that is known only when the launch file is carried out."""

    def perform(self, context: Context) -> str:
        """Return the string."""
        raise NotImplementedError

    def describe(self) -> str:
        """Return it as ``--show-args`` shows it."""
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
        return f'LaunchConfiguration({describe(self.variable_name)})'


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


def is_substitution(value: Any) -> bool:
    """True for a substitution, and for several strings and substitutions in a row."""
    return isinstance(value, Substitution) or (
        isinstance(value, Iterable) and not isinstance(value, (str, bytes, Mapping))
        and all(isinstance(part, (str, Substitution)) for part in value)
        and any(isinstance(part, Substitution) for part in value))


def expect_string(value: Any) -> None:
    """Expect what ``perform`` takes: a string, a substitution, or several of them in a row.

    :raises LaunchFailed: it is something else.
    """
    parts = value if isinstance(value, Iterable) and not isinstance(value, (str, bytes, Mapping)) else (value,)
    if not all(isinstance(part, (str, Substitution)) for part in parts):
        raise LaunchFailed(f'the launch file has {value!r} where a string or a substitution belongs')


def perform(value: Any, context: Context) -> str:
    """Return the string that something stands for."""
    expect_string(value)
    if isinstance(value, str):
        return value
    if isinstance(value, Substitution):
        return value.perform(context)
    return ''.join(perform(part, context) for part in value)


def describe(value: Any) -> str:
    """Return something that ``perform`` takes as ``--show-args`` shows it."""
    if isinstance(value, str):
        return repr(value)
    return value.describe() if isinstance(value, Substitution) else ' + '.join(map(describe, value))
