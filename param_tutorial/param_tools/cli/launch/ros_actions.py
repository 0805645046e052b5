"""The actions of ``launch_ros``: nodes, and what they get from the launch file around them."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import yaml

from param_tools.cli.launch import components
from param_tools.cli.launch.actions import Action, Process
from param_tools.cli.launch.conditions import Condition
from param_tools.cli.launch.context import Context, LaunchFailed, Origin, blaming, written_here
from param_tools.cli.launch.parameters import ParameterFile, Parameters, flat
from param_tools.cli.launch.processes import Program
from param_tools.cli.launch.substitutions import perform, typed_bool
from param_tools.files.node_names import Flaw, flaw_of_namespace, flaw_of_node_name


@dataclass
class SetParameter(Action):
    """A parameter for every node that comes later in its group."""

    name: Any
    value: Any

    def execute(self, context: Context) -> None:
        given = flat({perform(self.name, context): self.value}, context)
        _given_to_all(context).extend(given.items())
        if self.origin is not None:
            context.origins.update(dict.fromkeys((_rule(*each) for each in given.items()), self.origin))
        context.given.update((_rule(*each), each[1]) for each in given.items())


def _rule(name: str, value: Any) -> str:
    """Return the word after ``-p``: as Python writes the value, a list as a tuple. rcl guesses the type again."""
    return f'{name}:={value}'


@dataclass
class SetParametersFromFile(Action):
    """A parameter file for every node that comes later in its group."""

    filename: Any

    def execute(self, context: Context) -> None:
        filename = str(self.filename) if isinstance(self.filename, Path) else perform(self.filename, context)
        _given_to_all(context).append(filename)


def _given_to_all(context: Context) -> list[Any]:
    """Return what every later node gets: names with values, and paths of files.

    As in launch_ros, a group has the list of what is around it, if there is one: what it adds stays after its end.
    """
    found: list[Any] = context.launch_configurations.setdefault('global_params', [])
    return found


@dataclass
class SetUseSimTime(Action):
    """The clock of launch's own node, which only the genuine launch has; no node of the launch file gets anything."""

    value: Any

    def execute(self, context: Context) -> None:
        context.expect_launchable('SetUseSimTime')
        context.warn("SetUseSimTime sets use_sim_time of launch's own node, and no node of the launch file gets it: "
                     "write SetParameter('use_sim_time', True) for these", self.origin, 'likely mistake')


@dataclass
class SetRemap(Action):
    """A remapping for every node that comes later in its group."""

    src: Any
    dst: Any

    def execute(self, context: Context) -> None:
        context.launch_configurations.setdefault('ros_remaps', []).append(
            (perform(self.src, context), perform(self.dst, context)))


@dataclass
class PushROSNamespace(Action):
    """A namespace for every node that comes later in its group, below the namespace before it."""

    namespace: Any

    def execute(self, context: Context) -> None:
        _, namespace = full_name(None, self.namespace, context)
        context.launch_configurations['ros_namespace'] = namespace


@dataclass(kw_only=True)
class Node(Process):
    """A node, started in a process of its own."""

    executable: Any
    package: Any = None
    name: Any = None
    namespace: Any = None
    parameters: list[Any] | None = None
    remappings: Sequence[tuple[Any, Any]] | None = None
    arguments: Sequence[Any] | None = None
    ros_arguments: Sequence[Any] | None = None

    def __post_init__(self) -> None:
        _expect_parameters('Node', self.parameters)

    def execute(self, context: Context) -> list[Program]:
        executable = perform(self.executable, context)
        program = [executable] if self.package is None else context.find_program(perform(self.package, context),
                                                                                 executable)
        if typed_bool(self.shell, context):
            context.expect_launchable('shell= of a Node')
        return [self.program(self.command(program, context), Path(executable).name, context)]

    def command(self, program: list[str], context: Context) -> list[str]:
        """Return the command line, as launch_ros makes it.

        :param program: The words that start the executable.
        """
        name, namespace = full_name(self.name, self.namespace, context)
        words = [*program, *(perform(word, context) for word in self.arguments or ()), '--ros-args',
                 *(perform(word, context) for word in self.ros_arguments or ()), *_name_words(name, namespace)]
        words += parameter_words(self.parameters, name, namespace, self.origin, context)
        for old, new in context.launch_configurations.get('ros_remaps', []):
            words += ['-r', f'{old}:={new}']
        for old, new in self.remappings or ():
            words += ['-r', f'{perform(old, context)}:={perform(new, context)}']
        return words


@dataclass(kw_only=True)
class LifecycleNode(Node):
    """A node with a life cycle, which has to be named in full; nothing here takes it through its states."""

    name: Any
    namespace: Any


@dataclass(kw_only=True)
class ComposableNode:
    """A node of a component, which a container loads."""

    package: Any
    plugin: Any
    name: Any = None
    namespace: Any = None
    parameters: list[Any] | None = None
    remappings: Sequence[tuple[Any, Any]] | None = None
    extra_arguments: list[Any] | None = None
    condition: Condition | None = None
    origin: Origin | None = field(default_factory=written_here, init=False)

    def __post_init__(self) -> None:
        _expect_parameters('ComposableNode', self.parameters)

    def load(self, context: Context) -> list[Program]:
        """Return the node as a program whose command line says what the container gives it."""
        if self.condition is not None and not self.condition.evaluate(context):
            return []
        plugin = perform(self.plugin, context)
        with blaming(self.origin):
            name, namespace = full_name(self.name, self.namespace, context)
            words = [*context.find_program(perform(self.package, context), plugin), '--ros-args',
                     *_name_words(name, namespace),
                     *parameter_words(self.parameters, name, namespace, self.origin, context, is_component=True)]
        return [Program(words, plugin, False, False)]


class ComposableNodeContainer(Node):
    """A program that loads components; only the genuine launch has one, and a rehearsal says what they get."""

    def __init__(self, *, name: Any, namespace: Any, composable_node_descriptions: list[ComposableNode] | None = None,
                 **options: Any):
        super().__init__(name=name, namespace=namespace, **options)
        self.composable_node_descriptions = composable_node_descriptions or []

    def execute(self, context: Context) -> list[Program]:
        loading = LoadComposableNodes(composable_node_descriptions=self.composable_node_descriptions)
        return [*super().execute(context), *loading.execute(context)]


@dataclass(kw_only=True)
class LoadComposableNodes(Action):
    """Components for a container that runs; only the genuine launch loads them."""

    composable_node_descriptions: list[ComposableNode]
    target_container: Any = None

    def execute(self, context: Context) -> list[Program]:
        if self.composable_node_descriptions:
            context.expect_launchable('component (ComposableNode)')
        return [program for node in self.composable_node_descriptions for program in node.load(context)]


def full_name(name: Any, namespace: Any, context: Context) -> tuple[str | None, str | None]:
    """Return the name of a node and its namespace, each as the launch file says it; None where it says nothing."""
    performed = None if name is None else perform(name, context)
    if performed is not None:
        _expect_valid('node name', performed, flaw_of_node_name(performed))
    full = _full_namespace(None if namespace is None else perform(namespace, context), context)
    if full is not None:
        _expect_valid('namespace', full, flaw_of_namespace(full))
    return performed, full


def _name_words(name: str | None, namespace: str | None) -> list[str]:
    """Return the words of a command line that name a node, as far as the launch file does."""
    rules = {'__node': name, '__ns': namespace}
    return [word for rule, value in rules.items() if value is not None for word in ('-r', f'{rule}:={value}')]


def _full_namespace(namespace: str | None, context: Context) -> str | None:
    """Return a namespace below the one that was pushed, unless it begins with a slash."""
    outer = context.launch_configurations.get('ros_namespace')
    if namespace is None:
        return outer
    if outer and not namespace.startswith('/'):
        namespace = f'{outer.rstrip("/")}/{namespace}'
    return (namespace if namespace.startswith('/') else f'/{namespace}').rstrip('/') or '/'


def _expect_valid(what: str, name: str, flaw: Flaw) -> None:
    if flaw is not None:
        raise LaunchFailed(f'Invalid {what}: {flaw[0]}: {name!r}')


def _expect_parameters(what: str, parameters: Any) -> None:
    if parameters is not None and not isinstance(parameters, list):
        raise LaunchFailed(f"'{what}' expected 'parameters' to be a list, but got a value of type "
                           f"'{type(parameters).__name__}'")


def parameter_words(parameters: Iterable[Any] | None, name: str | None, namespace: str | None,
                    origin: Origin | None, context: Context, *, is_component: bool = False) -> list[str]:
    """Return the words of a command line that give a node its parameters: first what all get, then its own.

    :param origin: Where the node is described.
    """
    words: list[str] = []
    for each in context.launch_configurations.get('global_params', []):
        if isinstance(each, str):
            path = Path(each).absolute()
            if not path.is_file():
                raise LaunchFailed(f'SetParametersFromFile: {path} is not a file')
            words += components.words_of_file(path, name, namespace, context) if is_component else [
                '--params-file', str(path)]
        elif is_component:
            words += components.words_of_values(dict([each]), context.origins.get(_rule(*each)), context)
        else:
            words += ['-p', _rule(*each)]
    # The full name where the launch file gives it, and every node's where it does not.
    key = '/**' if name is None or namespace is None else f'{namespace.rstrip("/")}/{name}'
    for number, source in enumerate(parameters or ()):
        if isinstance(source, Mapping):
            place = source.origin if isinstance(source, Parameters) else origin and origin._replace(number=number)
            with blaming(place):
                given = flat(source, context)
            if is_component:
                words += components.words_of_values(given, place, context)
                continue
            path = context.write(yaml.safe_dump({key: {'ros__parameters': given}}), place)
        else:
            path = (source if isinstance(source, ParameterFile) else ParameterFile(source)).evaluate(context)
            if not path.is_file():
                hint = '; launch does not expand ~: use os.path.expanduser' if str(path).startswith('~') else ''
                context.warn(f'Parameter file path is not a file: {path}{hint}', origin)
                continue
            if is_component:
                words += components.words_of_file(path, name, namespace, context)
                continue
        words += ['--params-file', str(path)]
    return words
