"""Reading a launch file: what it may import, and what it describes."""

import re
from pathlib import Path
from types import ModuleType
from typing import Any

from param_tools.cli.launch import actions, conditions, markup, parameters, ros_actions, substitutions
from param_tools.cli.launch.actions import Event, LaunchDescription, LaunchFileSource
from param_tools.cli.launch.context import Context, LaunchFailed
from param_tools.cli.launch.importing import MODULES, READERS, read, running

_PARAMETERS: dict[str, Any] = {
    'ParameterFile': parameters.ParameterFile, 'ParameterValue': parameters.ParameterValue}


def _named(module: ModuleType, names: str) -> dict[str, Any]:
    return {name: getattr(module, name) for name in names.split()}


def _events(names: str) -> dict[str, Any]:
    return {name: type(name, (Event,), {}) for name in names.split()}


def _load_module(path: str) -> ModuleType:
    """Return the functions of another launch file in Python."""
    module = ModuleType('python_launch_file')
    module.__file__ = path
    exec(compile(Path(path).read_text(encoding='utf-8'), path, 'exec'), module.__dict__)
    return module


_MODULES: dict[str, dict[str, Any]] = {
    'launch': {'LaunchContext': Context, 'LaunchDescription': LaunchDescription,
               'LaunchDescriptionEntity': actions.Action, 'Substitution': substitutions.Substitution},
    'launch.actions': _named(actions, (
        'AppendEnvironmentVariable DeclareLaunchArgument EmitEvent ExecuteProcess GroupAction '
        'IncludeLaunchDescription LogInfo OpaqueFunction RegisterEventHandler SetEnvironmentVariable '
        'SetLaunchConfiguration Shutdown TimerAction')),
    'launch.conditions': _named(conditions, (
        'IfCondition LaunchConfigurationEquals LaunchConfigurationNotEquals UnlessCondition')),
    'launch.event_handlers': _events('OnProcessExit OnShutdown'),
    'launch.events': _events('Shutdown matches_action'),
    'launch.launch_description_sources': {
        'AnyLaunchDescriptionSource': LaunchFileSource, 'PythonLaunchDescriptionSource': LaunchFileSource,
        'load_python_launch_file_as_module': _load_module},
    'launch.substitutions': _named(substitutions, (
        'AndSubstitution Command EnvironmentVariable EqualsSubstitution FileContent FindExecutable '
        'IfElseSubstitution LaunchConfiguration NotEqualsSubstitution NotSubstitution PathJoinSubstitution '
        'PathSubstitution PythonExpression TextSubstitution ThisLaunchFileDir')),
    'launch_ros': {},
    'launch_ros.actions': {**_named(ros_actions, (
        'ComposableNodeContainer LifecycleNode LoadComposableNodes Node PushROSNamespace SetParameter '
        'SetParametersFromFile SetRemap SetUseSimTime')), 'PushRosNamespace': ros_actions.PushROSNamespace},
    'launch_ros.descriptions': {**_PARAMETERS, 'ComposableNode': ros_actions.ComposableNode},
    'launch_ros.event_handlers': _events('OnStateTransition'),
    'launch_ros.events': {},
    'launch_ros.events.lifecycle': _events('ChangeState'),
    'launch_ros.substitutions': _named(substitutions, (
        'ExecutableInPackage FindPackagePrefix FindPackageShare Parameter')),
    'launch_ros.parameter_descriptions': _PARAMETERS,
}
# In launch, each of these classes has a module of its own, too, such as launch.substitutions.launch_configuration.
MODULES.update(_MODULES)
MODULES.update({f'{module}.{re.sub("(?<!^)(?=[A-Z])", "_", name).lower()}': {name: found}
                for module in ('launch', 'launch.actions', 'launch.conditions', 'launch.launch_description_sources',
                               'launch.substitutions', 'launch_ros.actions', 'launch_ros.descriptions')
                for name, found in _MODULES[module].items() if name[0].isupper()})


def load_description(path: Path) -> LaunchDescription:
    """Read a launch file in Python, XML or YAML, and return what it describes."""
    found: LaunchDescription = read(path)
    return found


def _load_python(path: Path) -> LaunchDescription:
    with running(f'file of format [{path.suffix[1:]}]'):
        scope = vars(_load_module(str(path)))
        if 'generate_launch_description' not in scope:
            raise LaunchFailed(f'launch file at {path} does not contain a required function '
                               f"'generate_launch_description()'")
        found = scope['generate_launch_description']()
    if not isinstance(found, LaunchDescription):
        raise LaunchFailed(f'generate_launch_description() of {path.name} must return a LaunchDescription, and '
                           f'returned {found!r}')
    return found


READERS['.py'] = _load_python
READERS.update(dict.fromkeys(markup.READERS, markup.load))
