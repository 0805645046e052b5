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

from typing import TYPE_CHECKING, Any

from param_tools import lazy

if TYPE_CHECKING:
    from param_tools.files import descriptions as descriptions
    from param_tools.files import parameter_files as parameter_files
    from param_tools.files.checking import check_files as check_files
    from param_tools.files.editing import update_file as update_file
    from param_tools.node import locks as locks
    from param_tools.node.aliases import Aliases as Aliases
    from param_tools.node.client import ParameterClient as ParameterClient
    from param_tools.node.declarations import check_declarations as check_declarations
    from param_tools.node.rules import Rules as Rules
    from param_tools.panel.drawer import ParameterDrawer as ParameterDrawer
    from param_tools.panel.panel import ParameterBrowser as ParameterBrowser
    from param_tools.panel.panel import ParameterPanel as ParameterPanel
    from param_tools.ros.executor import BackgroundExecutor as BackgroundExecutor
    from param_tools.ros.stage import start as start
    from param_tools.ros.stage import stop as stop
    from param_tools.ros.waiting import wait_until as wait_until
    from param_tools.systems.change_log import ChangeFollower as ChangeFollower
    from param_tools.systems.change_log import ChangeLog as ChangeLog
    from param_tools.systems.comparing import compare as compare
    from param_tools.systems.comparing import compare_systems as compare_systems
    from param_tools.systems.describe import describe as describe
    from param_tools.systems.restoring import preview as preview
    from param_tools.systems.restoring import restore as restore
    from param_tools.systems.sets import ParameterSet as ParameterSet
    from param_tools.systems.snapshot import Snapshot as Snapshot
    from param_tools.systems.snapshot import all_parameters as all_parameters

__version__ = '0.1.0'

# Twice, because editors and type checkers read imports, and nothing should be imported before it is used.
_HOMES = {
    'Aliases': 'param_tools.node.aliases',
    'BackgroundExecutor': 'param_tools.ros.executor',
    'ChangeFollower': 'param_tools.systems.change_log',
    'ChangeLog': 'param_tools.systems.change_log',
    'ParameterBrowser': 'param_tools.panel.panel',
    'ParameterClient': 'param_tools.node.client',
    'ParameterDrawer': 'param_tools.panel.drawer',
    'ParameterPanel': 'param_tools.panel.panel',
    'ParameterSet': 'param_tools.systems.sets',
    'Rules': 'param_tools.node.rules',
    'Snapshot': 'param_tools.systems.snapshot',
    'all_parameters': 'param_tools.systems.snapshot',
    'check_declarations': 'param_tools.node.declarations',
    'check_files': 'param_tools.files.checking',
    'compare': 'param_tools.systems.comparing',
    'compare_systems': 'param_tools.systems.comparing',
    'describe': 'param_tools.systems.describe',
    'descriptions': 'param_tools.files.descriptions',
    'locks': 'param_tools.node.locks',
    'parameter_files': 'param_tools.files.parameter_files',
    'preview': 'param_tools.systems.restoring',
    'restore': 'param_tools.systems.restoring',
    'start': 'param_tools.ros.stage',
    'stop': 'param_tools.ros.stage',
    'update_file': 'param_tools.files.editing',
    'wait_until': 'param_tools.ros.waiting',
}
__all__ = list(_HOMES)


def __getattr__(name: str) -> Any:
    return lazy.load(__name__, _HOMES, name)


def __dir__() -> list[str]:
    return sorted({*globals(), *_HOMES})
