"""Mastering ROS 2 Parameters with Python: the package of the course.

``start()`` runs a ROS executor in the background of a notebook, ``ParameterClient`` talks to the parameters of any
node, ``ParameterPanel`` shows them as controls; these three are of the package ``param_tools``. What draws is in
``param_tutorial.views``, and what tries an answer in ``param_tutorial.exercises``. The rooms, top to bottom; imports go
downward only (README.md one folder up says what each room is for, and a test holds both against the code):

    site
    teacher
    exercises
    notebook
    package
    views
    learner
    nodes
"""

from param_tools import lazy

# Imported when first used: `ros2 run param_tutorial simple_param_node` must not load JupyterLab's widgets.
with lazy.Imports(__name__) as _imports:
    from param_tools.node.client import ParameterClient as ParameterClient
    from param_tools.panel.panel import ParameterPanel as ParameterPanel
    from param_tools.ros.stage import start as start
    from param_tools.ros.stage import stop as stop
    from param_tools.ros.waiting import wait_until as wait_until
    from param_tutorial import views as views
    from param_tutorial.notebook.glossary import Glossary as Glossary
    from param_tutorial.notebook.magics import load_ipython_extension as load_ipython_extension
    from param_tutorial.notebook.shell import Shell as Shell
    from param_tutorial.notebook.terminal import Terminal as Terminal
    from param_tutorial.package.package import Package as Package
    from param_tutorial.views.drawing import ros1 as ros1
__getattr__, __dir__, __all__ = _imports.load, _imports.names, _imports.public
