"""Tools for the parameters of ROS 2 nodes: a client, a panel, checked files, snapshots, and an embedded ``ros2``.

``start()`` runs a ROS executor in the background, ``ParameterClient`` talks to the parameters of any node, and
``ParameterPanel`` shows them as controls in a notebook. The rooms, top to bottom; imports go downward only (README.md
one folder up says what each room is for, and a test holds both against the code):

    cli
    panel
    systems
    node
    ros
    rcl_in_python
    files
    markup
    descriptor
    values
    errors
    lazy

``files`` and what is below it need PyYAML alone, and only ``panel`` needs Jupyter.

A slider's value. ``panel.js`` sends it to ``ParameterPanel``, and its ``Control`` hands it to ``LiveParameters.ask``.
There the state machine ``LiveState`` sends it, or keeps it until the request before is answered. ``Services`` sends the
request to the node. The answer comes in the executor's thread; what the node has stored then is read, by a coroutine,
and a job of ``schedule`` draws it.

A file to a node. ``ParameterClient.load`` has ``files.parameter_files`` read it: ``parsing`` reads as rcl does, line by
line, and ``effective`` says which value counts for the node. The client asks the node what it has, leaves out the
read-only parameters that have the file's value already, and sets the others in one request.

``%ros2 param set NODE NAME TEXT``. ``cli.command`` parses the words; where ROS is installed, the genuine ``ros2`` gets
them. ``cli.session`` finds the node in the graph. ``values.parse`` turns the text into a value by YAML's rules, as the
genuine command does, and ``cli.param`` prints what the node answers.
"""

from param_tools import lazy

with lazy.Imports(__name__) as _imports:
    from param_tools.files import descriptions as descriptions
    from param_tools.files import parameter_files as parameter_files
    from param_tools.files.checking import check_files as check_files
    from param_tools.node.client import ParameterClient as ParameterClient
    from param_tools.panel.panel import ParameterPanel as ParameterPanel
    from param_tools.ros.executor import BackgroundExecutor as BackgroundExecutor
    from param_tools.ros.stage import start as start
    from param_tools.ros.stage import stop as stop
    from param_tools.ros.waiting import wait_until as wait_until
    from param_tools.systems.change_log import ChangeFollower as ChangeFollower
    from param_tools.systems.change_log import ChangeLog as ChangeLog
    from param_tools.systems.restoring import restore as restore
    from param_tools.systems.sets import ParameterSet as ParameterSet
    from param_tools.systems.sets import compare as compare
    from param_tools.systems.snapshot import all_parameters as all_parameters
    from param_tools.systems.snapshot import describe as describe

__version__ = '0.1.0'
__getattr__, __dir__, __all__ = _imports.load, _imports.names, _imports.public
