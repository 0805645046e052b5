"""Reading a launch file: while it runs, and no longer, ``import launch`` finds the classes of this package."""

import contextlib
import logging
import re
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from types import ModuleType
from typing import Any, NoReturn

from param_tools.cli.index import provided_packages_installed
from param_tools.cli.launch import actions, conditions, markup, parameters, ros_actions, substitutions
from param_tools.cli.launch.actions import Event, LaunchDescription, LaunchDescriptionSource, LaunchFileSource
from param_tools.cli.launch.context import FULL_INSTALLATION, Context, LaunchFailed
from param_tools.cli.session import CommandFailed

# A launch file may import these to say the types of its functions' arguments and results.
_TYPES: dict[str, Any] = {'SomeSubstitutionsType': Any, 'SomeEntitiesType': Any}
_PARAMETERS: dict[str, Any] = {
    'ParameterFile': parameters.ParameterFile, 'ParameterValue': parameters.ParameterValue}


def _named(module: ModuleType, names: str) -> dict[str, Any]:
    return {name: getattr(module, name) for name in names.split()}


def _events(names: str) -> dict[str, Any]:
    return {name: Event.named(name) for name in names.split()}


# The modules, and the names in each, that a launch file may import and use.
MODULES: dict[str, dict[str, Any]] = {
    'launch': {'Action': actions.Action, 'Condition': conditions.Condition, 'LaunchContext': Context,
               'LaunchDescription': LaunchDescription, 'LaunchDescriptionEntity': actions.Action,
               'LaunchDescriptionSource': LaunchDescriptionSource, 'Substitution': substitutions.Substitution,
               **_events('Event EventHandler'), **_TYPES},
    'launch.actions': _named(actions, (
        'AppendEnvironmentVariable DeclareLaunchArgument EmitEvent ExecuteProcess GroupAction '
        'IncludeLaunchDescription LogInfo OpaqueFunction RegisterEventHandler SetEnvironmentVariable '
        'SetLaunchConfiguration Shutdown TimerAction UnsetEnvironmentVariable UnsetLaunchConfiguration')),
    'launch.conditions': _named(conditions, (
        'IfCondition LaunchConfigurationEquals LaunchConfigurationNotEquals UnlessCondition')),
    'launch.event_handlers': _events(
        'OnExecutionComplete OnIncludeLaunchDescription OnProcessExit OnProcessIO OnProcessStart OnShutdown'),
    'launch.events': _events('matches_action ExecutionComplete Shutdown'),
    'launch.events.process': _events('ProcessExited ProcessIO ProcessStarted ShutdownProcess SignalProcess'),
    'launch.launch_description_sources': dict.fromkeys(
        ('AnyLaunchDescriptionSource', 'FrontendLaunchDescriptionSource', 'PythonLaunchDescriptionSource'),
        LaunchFileSource),
    'launch.logging': {'get_logger': logging.getLogger},
    'launch.substitutions': _named(substitutions, (
        'AllSubstitution AndSubstitution AnonName AnySubstitution Command EnvironmentVariable EqualsSubstitution '
        'FileContent FindExecutable IfElseSubstitution LaunchConfiguration NotEqualsSubstitution NotSubstitution '
        'OrSubstitution PathJoinSubstitution PathSubstitution PythonExpression TextSubstitution ThisLaunchFile '
        'ThisLaunchFileDir')),
    'launch.utilities': {
        'normalize_to_list_of_substitutions': substitutions.normalized,
        'perform_substitutions': lambda context, value: substitutions.perform(value, context)},
    'launch_ros': {},
    'launch_ros.actions': {**_named(ros_actions, (
        'ComposableNodeContainer LifecycleNode LoadComposableNodes Node PushROSNamespace SetParameter '
        'SetParametersFromFile SetRemap')), 'PushRosNamespace': ros_actions.PushROSNamespace,
        'ROSTimer': ros_actions.RosTimer, 'RosTimer': ros_actions.RosTimer},
    'launch_ros.descriptions': {**_PARAMETERS, 'ComposableNode': ros_actions.ComposableNode},
    'launch_ros.event_handlers': _events('OnStateTransition'),
    'launch_ros.events': {},
    'launch_ros.events.lifecycle': _events('ChangeState StateTransition matches_node_name'),
    'launch_ros.substitutions': _named(substitutions, (
        'ExecutableInPackage FindPackagePrefix FindPackageShare Parameter')),
    'launch_ros.parameter_descriptions': _PARAMETERS,
    'launch_xml': {},
    'launch_xml.launch_description_sources': {'XMLLaunchDescriptionSource': LaunchFileSource},
    'launch_yaml': {},
    'launch_yaml.launch_description_sources': {'YAMLLaunchDescriptionSource': LaunchFileSource},
}
# Each of these classes has a module of its own, too, such as launch.substitutions.launch_configuration.
_SINGLE = {f'{module}.{re.sub("(?<!^)(?=[A-Z])", "_", name).lower()}': {name: found}
           for module in ('launch', 'launch.actions', 'launch.conditions', 'launch.launch_description_sources',
                          'launch.substitutions', 'launch_ros.actions', 'launch_ros.descriptions')
           for name, found in MODULES[module].items()}
_PACKAGES = {name.partition('.')[0] for name in MODULES}
# What a full installation has besides: a launch file may import it, and is rejected where it uses it.
_ELSEWHERE = {
    'ExecuteLocal', 'FindPackage', 'LaunchIntrospector', 'LaunchLogDir', 'LaunchService', 'LifecycleTransition',
    'LocalSubstitution', 'OpaqueCoroutine', 'PopEnvironment', 'PopLaunchConfigurations', 'PushEnvironment',
    'PushLaunchConfigurations', 'ResetEnvironment', 'ResetLaunchConfigurations', 'SetROSLogDir', 'SetUseSimTime',
    'SubstitutionFailure', 'UnregisterEventHandler', 'evaluate_condition_expression'}


def load_description(path: Path) -> LaunchDescription:
    """Read a launch file in Python, XML or YAML, and return what it describes.

    :raises LaunchFailed: it is none, or needs what only a full installation has.
    """
    if not path.is_file():
        raise LaunchFailed(f'there is no launch file {path}')
    if path.suffix in markup.READERS:
        return markup.load(path)
    if path.suffix != '.py':
        raise LaunchFailed(f'{path.name} is no launch file in Python, XML or YAML, by the end of its name')
    scope: dict[str, Any] = {'__name__': path.stem, '__file__': str(path)}
    with running(f'file of format [{path.suffix[1:]}]'):
        exec(compile(path.read_text(encoding='utf-8'), str(path), 'exec'), scope)
        if 'generate_launch_description' not in scope:
            raise LaunchFailed(f'launch file at {path} does not contain a required function '
                               f"'generate_launch_description()'")
        found = scope['generate_launch_description']()
    if not isinstance(found, LaunchDescription):
        raise LaunchFailed(f'generate_launch_description() of {path.name} must return a LaunchDescription, and '
                           f'returned {found!r}')
    return found


@contextlib.contextmanager
def running(what: str) -> Iterator[None]:
    """Let Python code of a launch file import MODULES and find the provided packages; explain its exceptions.

    :param what: What the code is.
    :raises LaunchFailed: the code raises an exception.
    """
    with provided_packages_installed(), _importable():
        try:
            yield
        except CommandFailed:
            raise
        except Exception as error:
            raise LaunchFailed(_explanation(error, what)) from error


def _explanation(error: Exception, what: str) -> str:
    if isinstance(error, ModuleNotFoundError) and str(error.name).partition('.')[0] in _PACKAGES:
        return (f'the embedded ros2 launch has no module {error.name}; it has {", ".join(MODULES)}. '
                f'{FULL_INSTALLATION}')
    hint = ''
    if isinstance(error, ModuleNotFoundError):
        hint = f'. Where it is part of ROS or of another package: {FULL_INSTALLATION[0].lower()}{FULL_INSTALLATION[1:]}'
    elif 'unexpected keyword argument' in str(error):  # Node(sigterm_timeout='1'), for example
        hint = f'. {FULL_INSTALLATION}'
    return f'Caught exception when trying to load {what}: {type(error).__name__}: {error}{hint}'


@contextlib.contextmanager
def _importable() -> Iterator[None]:
    """Let the imports of a launch file find MODULES, and no installed ``launch``."""
    outer = {name: module for name, module in sys.modules.items() if name.partition('.')[0] in _PACKAGES}
    for name in outer:
        del sys.modules[name]
    for name, names in (MODULES | _SINGLE).items():
        sys.modules[name] = _module(name, names)
        package, _, part = name.rpartition('.')
        if package:
            setattr(sys.modules[package], part, sys.modules[name])
    try:
        yield
    finally:
        for name in [name for name in sys.modules if name.partition('.')[0] in _PACKAGES]:
            del sys.modules[name]
        sys.modules.update(outer)


def _module(name: str, names: Mapping[str, Any]) -> ModuleType:
    module = ModuleType(name, f'The part of {name} that the embedded ros2 launch has.')
    module.__path__ = []
    module.__dict__.update(names)

    def missing(wanted: str) -> type:
        # The import system asks for these of any module.
        if wanted.startswith('__'):
            raise AttributeError(wanted)
        known = ', '.join(names) or 'no names of its own'
        why = f'the embedded ros2 launch has no {name}.{wanted}; of {name} it has {known}. {FULL_INSTALLATION}'
        if wanted not in _ELSEWHERE:
            raise LaunchFailed(why)

        def reject(*_: Any, **_options: Any) -> NoReturn:
            raise LaunchFailed(why)

        return type(wanted, (), {'__init__': reject})

    # PEP 562: what a module has under this name is asked for names that it lacks.
    module.__dict__['__getattr__'] = missing
    return module
