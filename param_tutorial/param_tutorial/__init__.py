"""Mastering ROS 2 Parameters with Python: the package of the course.

``start()`` puts a ROS executor into the background of a notebook, ``ParameterClient`` talks to the parameters
of any node, ``ParameterPanel`` shows them as controls. The layers, top to bottom; imports go downward only (README.md,
"Architecture", says what each of them does, and a test compares):

    lessons
    panels, panel_editors, robot_view, step_view, event_view, log_view, views, cells, magics
    exercises
    ros2, shell, terminals
    observe, snapshot
    rules, aliases, parameter_sets
    live, worker
    client, parameter_files
    background, services, node_log
    plots, diagrams, svg
    ros1, glossary
    values, domain, markup, errors
    nodes
"""

import importlib

# Imported when first used: `ros2 run param_tutorial simple_param_node` must not load JupyterLab's widgets.
_HOMES = {
    'Aliases': 'aliases',
    'BackgroundExecutor': 'background',
    'EventView': 'event_view',
    'LinePlot': 'plots',
    'LogView': 'log_view',
    'ParameterClient': 'client',
    'ParameterHistory': 'parameter_sets',
    'ParameterPanel': 'panels',
    'ParameterSet': 'parameter_sets',
    'RobotView': 'robot_view',
    'Rules': 'rules',
    'Shell': 'shell',
    'StepResponseView': 'step_view',
    'Terminal': 'terminals',
    'all_parameters': 'snapshot',
    'compare': 'parameter_sets',
    'load_ipython_extension': 'magics',
    'node_graph': 'observe',
    'plot_responses': 'step_view',
    'record_change': 'observe',
    'restore': 'parameter_sets',
    'start': 'background',
    'stop': 'background',
    'wait_until': 'background',
}
__all__ = sorted(_HOMES)


def __getattr__(name: str):
    if name not in _HOMES:
        raise AttributeError(f'module {__name__!r} has no attribute {name!r}')
    value = getattr(importlib.import_module(f'{__name__}.{_HOMES[name]}'), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *_HOMES})
