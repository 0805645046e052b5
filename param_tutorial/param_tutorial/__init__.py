"""Mastering ROS 2 Parameters with Python: the package of the course.

``start()`` runs a ROS executor in the background of a notebook, ``ParameterClient`` talks to the parameters of any
node, ``ParameterPanel`` shows them as controls. The rooms of the package, top to bottom; imports go downward only
(README.md, "Architecture", says what each room is for, and a test holds both against the code):

    lessons
    exercises
    notebook
    widgets
    ros2
    parameters
    runtime
    pictures
    learner
    nodes
    errors
"""

import importlib
from typing import Any

from param_tutorial.runtime import surroundings

# Whatever is imported next may be rclpy, or import it.
surroundings.drop_missing_middleware()

# Imported when first used: `ros2 run param_tutorial simple_param_node` must not load JupyterLab's widgets.
_HOMES = {
    'Aliases': 'parameters.aliases',
    'BackgroundExecutor': 'runtime.executor',
    'CallsView': 'widgets.pictured',
    'CartView': 'widgets.cart',
    'ChangeFollower': 'parameters.change_log',
    'ChangeLog': 'parameters.change_log',
    'ChecksView': 'widgets.pictured',
    'DeclarationsView': 'widgets.pictured',
    'EventView': 'widgets.events',
    'LadderView': 'widgets.motion',
    'LayersView': 'widgets.pictured',
    'LiftsView': 'widgets.pictured',
    'LinePlot': 'pictures.plots',
    'LogView': 'widgets.log',
    'MessageView': 'widgets.motion',
    'NumberLineView': 'widgets.motion',
    'ParameterBrowser': 'widgets.panel',
    'ParameterClient': 'parameters.client',
    'ParameterHistory': 'parameters.history',
    'ParameterPanel': 'widgets.panel',
    'ParameterSet': 'parameters.sets',
    'PlaneView': 'widgets.pictured',
    'RequestsView': 'widgets.pictured',
    'RobotView': 'widgets.robot',
    'Rules': 'parameters.rules',
    'Shell': 'notebook.shell',
    'SideBySide': 'widgets.side_by_side',
    'Snapshot': 'parameters.snapshot',
    'StepResponseView': 'widgets.step_response',
    'Terminal': 'notebook.terminal',
    'TrailView': 'widgets.pictured',
    'WorldsView': 'widgets.pictured',
    'all_parameters': 'parameters.snapshot',
    'check_declarations': 'parameters.declarations',
    'check_files': 'parameters.checking',
    'compare': 'parameters.sets',
    'compare_systems': 'parameters.systems',
    'load_ipython_extension': 'notebook.magics',
    'locks': 'parameters.locks',
    'node_graph': 'runtime.stage',
    'plot_responses': 'pictures.plots',
    'preview': 'parameters.sets',
    'record_change': 'parameters.recording',
    'restore': 'parameters.sets',
    'start': 'runtime.stage',
    'stop': 'runtime.stage',
    'unload_ipython_extension': 'notebook.magics',
    'update_file': 'parameters.editing',
    'wait_until': 'runtime.waiting',
}
# And modules: `from param_tutorial import parameter_files`.
_MODULES = {'descriptions': 'parameters.descriptions', 'parameter_files': 'parameters.files', 'ros1': 'pictures.ros1'}
__all__ = list(_HOMES)


def __getattr__(name: str) -> Any:
    if name in _MODULES:
        value = importlib.import_module(f'{__name__}.{_MODULES[name]}')
    elif name in _HOMES:
        value = getattr(importlib.import_module(f'{__name__}.{_HOMES[name]}'), name)
    else:
        raise AttributeError(f'module {__name__!r} has no attribute {name!r}')
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *_HOMES, *_MODULES})
