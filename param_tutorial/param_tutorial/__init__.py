"""Mastering ROS 2 Parameters with Python: the package of the course.

``start()`` puts a ROS executor into the background of a notebook, ``ParameterClient`` talks to the parameters
of any node, ``ParameterPanel`` shows them as controls. The layers, top to bottom; imports go downward only:

    lessons                         the chapters as a website
    panels, robot_view, step_view,  ipywidgets and IPython
        magics
    exercises                       checks of what a learner wrote
    ros2, shell, terminals          the ros2 command; commands in processes of their own
    observe, snapshot               what goes on in a change, in the graph, in all nodes
    rules, aliases, parameter_sets  what ROS 2 has not (yet): richer checks, old names, compare and restore
    client, parameter_files         parameter services and files
    background, node_log, domain    one rclpy context, executor and thread for a process
    ros1                            what the real ROS 1 says, recorded
    values, errors                  no ROS, no Jupyter
    nodes                           the lessons' nodes, on rclpy alone
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
