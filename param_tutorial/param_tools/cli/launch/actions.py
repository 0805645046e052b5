"""The actions of ``launch``: arguments, groups, included files, variables, timers, and programs that are no nodes.

An action is carried out by ``visit``, which returns the programs to start. Nothing here starts a process, so a
mistake anywhere in a launch file leaves nothing running.
"""

import contextlib
import shlex
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple

from param_tools.cli.launch.conditions import Condition
from param_tools.cli.launch.context import Context, LaunchFailed, Origin, blaming, written_here
from param_tools.cli.launch.importing import read, running
from param_tools.cli.launch.processes import Program
from param_tools.cli.launch.substitutions import expect_string, is_list, perform, typed_bool
from param_tools.cli.session import CommandFailed

# Where the two streams of a program go, for each word that output= takes. A program's log file is not kept here.
_OUTPUTS: dict[str, dict[str, Any]] = {
    'screen': {'both': 'screen'}, 'log': {'both': 'log', 'stderr': 'screen'}, 'both': {'both': 'screen'},
    'own_log': {'both': 'own_log'}, 'full': {'both': 'screen'}}
# What logs the errors of the declaration of an argument.
_LOGGER = 'launch.actions.declare_launch_argument'


class DeclaredArgument(NamedTuple):
    """An argument of a launch file, and where it is declared."""

    declaration: 'DeclareLaunchArgument'
    is_conditional: bool
    """True if conditions decide whether it is."""
    given: tuple[str, ...]
    """The names of the arguments that the launch files around it pass on to the one that declares it."""


@dataclass(kw_only=True)
class Action:
    """An entry of a launch description."""

    condition: Condition | None = None
    origin: Origin | None = field(default_factory=written_here, init=False, compare=False, repr=False)
    """Where it is written."""

    def visit(self, context: Context) -> list[Program]:
        """Carry out the action if its condition is true, and return the programs to start."""
        with blaming(self.origin):
            try:
                if self.condition is None or self.condition.evaluate(context):
                    return self.execute(context) or []
            except LaunchFailed:
                raise
            except CommandFailed as error:  # no such package, no such program
                raise LaunchFailed(error) from error
            except (TypeError, ValueError) as error:  # a null character in a path, for example
                raise LaunchFailed(f'{type(error).__name__}: {error}') from error
        return []

    def execute(self, context: Context) -> list[Program] | None:
        """Carry out the action, and return the programs to start, if there are any."""
        raise NotImplementedError

    def declared_arguments(self) -> Iterator[DeclaredArgument]:
        """Return the arguments of the launch file that the action declares, as far as that is known before a launch."""
        yield from ()


def visit_all(actions: Iterable[Action] | None, context: Context) -> list[Program]:
    """Carry out actions, and return the programs to start."""
    return [program for action in expect_actions(actions) for program in action.visit(context)]


def expect_actions(actions: Iterable[Action] | None) -> list[Action]:
    """Return actions as a list."""
    found = list(actions or ())
    for each in found:
        if not isinstance(each, Action):
            raise LaunchFailed(f'a LaunchDescription takes actions such as Node(...), not {each!r}')
    return found


def _declared_in(actions: Iterable[Action], is_conditional: bool) -> Iterator[DeclaredArgument]:
    for action in actions:
        for each in action.declared_arguments():
            yield each._replace(is_conditional=each.is_conditional or is_conditional)


class DeclareLaunchArgument(Action):
    """An argument of the launch file, given as ``name:=value``."""

    def __init__(self, name: str, *, default_value: Any = None, description: str | None = None,
                 choices: list[str] | None = None, condition: Condition | None = None):
        super().__init__(condition=condition)
        if default_value is not None:
            expect_string(default_value)
        self.name = name
        self.default_value = default_value
        self.choices = choices
        self.description = description or ('no description given' if choices is None else f'One of: {choices}')
        if description and choices is not None:
            self.description = f'{description.rstrip(".")}. Valid choices are: {choices}'

    def execute(self, context: Context) -> None:
        if self.name not in context.launch_configurations:
            if self.default_value is None:
                context.log('ERROR', _LOGGER, f'Required launch argument "{self.name}" (description: '
                                              f'"{self.description}") was not provided')
                raise LaunchFailed(f'Required launch argument "{self.name}" was not provided.')
            context.launch_configurations[self.name] = perform(self.default_value, context)
        given = context.launch_configurations[self.name]
        if self.choices is not None and given not in self.choices:
            error = f'Argument "{self.name}" provided value "{given}" is not valid. Valid options are: {self.choices}'
            context.log('ERROR', _LOGGER, error)
            raise LaunchFailed(error)

    def declared_arguments(self) -> Iterator[DeclaredArgument]:
        yield DeclaredArgument(self, self.condition is not None, ())


@dataclass
class SetLaunchConfiguration(Action):
    """A value for an argument, also for one that nobody has declared."""

    name: Any
    value: Any

    def execute(self, context: Context) -> None:
        name = perform(self.name, context)
        context.launch_configurations[name] = perform(self.value, context)


@dataclass
class SetEnvironmentVariable(Action):
    """An environment variable of every program that comes later in the launch file."""

    name: Any
    value: Any

    def execute(self, context: Context) -> None:
        context.environment[perform(self.name, context)] = perform(self.value, context)


@dataclass
class AppendEnvironmentVariable(Action):
    """A part of an environment variable such as PATH, at its end or at its beginning."""

    name: Any
    value: Any
    prepend: Any = False
    separator: Any = ':'

    def execute(self, context: Context) -> None:
        name = perform(self.name, context)
        parts = [context.environment[name]] if name in context.environment else []
        parts.insert(0 if typed_bool(self.prepend, context) else 1, perform(self.value, context))
        context.environment[name] = perform(self.separator, context).join(parts)


@dataclass
class LogInfo(Action):
    """A line that the launch prints."""

    msg: Any

    def execute(self, context: Context) -> None:
        context.log('INFO', 'launch.user', perform(self.msg, context))


class LaunchDescription(Action):
    """What a launch file starts, in this order."""

    def __init__(self, initial_entities: Iterable[Action] | None = None, *, deprecated_reason: str | None = None):
        super().__init__()
        self.entities = expect_actions(initial_entities)
        self.deprecated_reason = deprecated_reason

    def add_action(self, action: Action) -> None:
        """Add an action at the end."""
        self.entities += expect_actions([action])

    add_entity = add_action

    def execute(self, context: Context) -> list[Program]:
        if self.deprecated_reason is not None:
            context.log('WARNING', 'launch',
                        f'launch file [{context.launch_file}] is deprecated: {self.deprecated_reason}')
        return visit_all(self.entities, context)

    def declared_arguments(self) -> Iterator[DeclaredArgument]:
        yield from _declared_in(self.entities, self.condition is not None)


class GroupAction(Action):
    """Actions whose settings end with the group, unless it has no scope of its own."""

    def __init__(self, actions: Iterable[Action], *, scoped: bool = True, condition: Condition | None = None):
        super().__init__(condition=condition)
        self.actions = expect_actions(actions)
        self.scoped = scoped

    def execute(self, context: Context) -> list[Program]:
        with context.scope() if self.scoped else contextlib.nullcontext():
            return visit_all(self.actions, context)

    def declared_arguments(self) -> Iterator[DeclaredArgument]:
        yield from _declared_in(self.actions, self.condition is not None)


class LaunchFileSource:
    """Another launch file, by its path: in Python, XML or YAML, as the end of its name says."""

    def __init__(self, launch_file_path: Any):
        self._path = str(launch_file_path) if isinstance(launch_file_path, Path) else launch_file_path

    def load(self, context: Context) -> tuple[LaunchDescription, Path]:
        """Return what the launch file describes, and its path."""
        path = Path(perform(self._path, context)).absolute()
        return read(path), path


class IncludeLaunchDescription(Action):
    """Another launch file, with values for its arguments, which stay set after it."""

    def __init__(self, launch_description_source: Any, *, launch_arguments: Iterable[tuple[Any, Any]] | None = None,
                 condition: Condition | None = None):
        super().__init__(condition=condition)
        self.source = (launch_description_source if isinstance(launch_description_source, LaunchFileSource)
                       else LaunchFileSource(launch_description_source))
        self.launch_arguments = tuple(launch_arguments or ())

    def execute(self, context: Context) -> list[Program]:
        description, path = self.source.load(context)
        # As in launch, it stays the current one when the file around it goes on.
        context.launch_file = path
        names = [perform(name, context) for name, _ in self.launch_arguments]
        seen: set[str] = set()
        for declared, is_conditional, given in description.declared_arguments():
            is_given = declared.name in (*names, *given)
            if declared.name not in seen and not (is_conditional or is_given or declared.default_value is not None):
                raise LaunchFailed(f"Included launch description missing required argument '{declared.name}' "
                                   f"(description: '{declared.description}'), given: [{', '.join((*names, *given))}]")
            seen.add(declared.name)
        for name, value in self.launch_arguments:
            SetLaunchConfiguration(name, value).execute(context)
        return description.visit(context)

    def declared_arguments(self) -> Iterator[DeclaredArgument]:
        nothing = Context()
        try:
            description, _ = self.source.load(nothing)
            own = tuple(perform(name, nothing) for name, _ in self.launch_arguments)
        except CommandFailed:
            return  # the path is known at the launch only
        for each in _declared_in([description], self.condition is not None):
            yield each._replace(given=(*own, *each.given))


@dataclass(kw_only=True)
class OpaqueFunction(Action):
    """A function of the launch file, which takes the context and returns further actions."""

    function: Callable[..., Iterable[Action] | None]
    args: Iterable[Any] | None = None
    kwargs: Mapping[str, Any] | None = None

    def __post_init__(self) -> None:
        if not callable(self.function):
            raise LaunchFailed(f"OpaqueFunction expected a callable for 'function', got '{type(self.function)}'")

    def execute(self, context: Context) -> list[Program]:
        with running(getattr(self.function, '__name__', 'an OpaqueFunction')):
            found = self.function(context, *(self.args or ()), **(self.kwargs or {}))
        return visit_all(found, context)


class TimerAction(Action):
    """Actions that are carried out some seconds later: only a rehearsal carries them out, after all others."""

    def __init__(self, *, period: Any, actions: Iterable[Action], condition: Condition | None = None):
        super().__init__(condition=condition)
        self.period = period
        self.actions = expect_actions(actions)

    def execute(self, context: Context) -> None:
        context.expect_launchable('TimerAction')
        context.postponed.append(self.actions)

    def declared_arguments(self) -> Iterator[DeclaredArgument]:
        yield from _declared_in(self.actions, is_conditional=True)


@dataclass(kw_only=True)
class Shutdown(Action):
    """The end of all programs: as ``on_exit`` of one of them."""

    reason: Any = ''

    def execute(self, context: Context) -> None:
        context.expect_launchable('Shutdown() but as on_exit= of a program')


@dataclass(kw_only=True)
class Process(Action):
    """What a Node and another program have in common: how it is started and where its output goes."""

    output: Any = 'log'
    emulate_tty: Any = False
    respawn: Any = False
    respawn_delay: float | None = None
    respawn_max_retries: float = -1
    shell: Any = False
    sigterm_timeout: Any = None
    sigkill_timeout: Any = None
    log_cmd: bool = False
    prefix: Any = None
    cwd: Any = None
    additional_env: Mapping[Any, Any] | None = None
    on_exit: Any = None

    def program(self, command: list[str], name: str, context: Context) -> Program:
        """Return what is to be started.

        :param name: The program's on the screen.
        """
        prefix = context.launch_configurations.get('launch-prefix', '') if self.prefix is None else self.prefix
        if typed_bool(self.respawn, context):
            context.expect_launchable('respawn= of a program')
        for option in ('sigterm_timeout', 'sigkill_timeout', 'log_cmd'):
            if getattr(self, option):
                context.expect_launchable(f'{option}= of a program')
        environment = dict(context.environment)
        for variable, value in (self.additional_env or {}).items():
            environment[perform(variable, context)] = perform(value, context)
        return Program(
            [*shlex.split(perform(prefix, context)), *command], name, *self.streams_on_screen(context),
            environment=None if environment == context.environment_before else environment,
            folder=None if self.cwd is None else Path(perform(self.cwd, context)),
            ends_all=self._ends_all(context))

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

    def _ends_all(self, context: Context) -> bool:
        actions = [] if self.on_exit is None else list(self.on_exit) if is_list(self.on_exit) else [self.on_exit]
        if not all(isinstance(each, Shutdown) for each in actions):
            context.expect_launchable('on_exit= of a program but Shutdown()')
        return bool(actions)


@dataclass(kw_only=True)
class ExecuteProcess(Process):
    """A program that is no node of a package."""

    cmd: Sequence[Any]
    name: Any = None

    def execute(self, context: Context) -> list[Program]:
        if not is_list(self.cmd) or not self.cmd:
            raise LaunchFailed(f"'ExecuteProcess' expected 'cmd' to be a list of strings and substitutions, but got "
                               f'{self.cmd!r}')
        words = [perform(word, context) for word in self.cmd]
        name = Path(words[0]).name if self.name is None else perform(self.name, context)
        return [self.program(['sh', '-c', ' '.join(words)] if typed_bool(self.shell, context) else words, name,
                             context)]


@dataclass
class RegisterEventHandler(Action):
    """Actions that an event sets off, such as the end of a program: only a rehearsal carries them out."""

    event_handler: 'Event'

    def execute(self, context: Context) -> None:
        context.expect_launchable(f'event handler {type(self.event_handler).__name__}')
        context.postponed.append(self.event_handler.actions)


@dataclass(kw_only=True)
class EmitEvent(Action):
    """An event, which only the genuine launch has."""

    event: 'Event'

    def execute(self, context: Context) -> None:
        context.expect_launchable(f'event {type(self.event).__name__}')


class Event:
    """Stands for any event and event handler of launch: keeps the actions that it would carry out, if they are listed
    and not returned by a function."""

    def __init__(self, *_: Any, **options: Any):
        found: Any = next((options[name] for name in ('on_exit', 'on_start', 'on_completion', 'on_shutdown', 'entities')
                           if options.get(name) is not None), [])
        self.actions = expect_actions(found if is_list(found) else [] if callable(found) else [found])


def carry_out(actions: Iterable[Action], context: Context) -> list[Program]:
    """Carry out actions and, in a rehearsal, after them what was postponed; return the programs to start."""
    with context.scope():
        programs = LaunchDescription(actions).execute(context)
        while context.postponed:
            programs += LaunchDescription(context.postponed.pop(0)).execute(context)
    return programs
