"""The views of the course: what a node does, drawn in a cell. Each is one file, its name is that of its class."""

from typing import TYPE_CHECKING, Any

from param_tools import lazy

if TYPE_CHECKING:
    from param_tutorial.pictures.plots import LinePlot as LinePlot
    from param_tutorial.pictures.plots import plot_responses as plot_responses
    from param_tutorial.views.cart import CartView as CartView
    from param_tutorial.views.events import EventView as EventView
    from param_tutorial.views.log import LogView as LogView
    from param_tutorial.views.motion import LadderView as LadderView
    from param_tutorial.views.motion import MessageView as MessageView
    from param_tutorial.views.motion import NumberLineView as NumberLineView
    from param_tutorial.views.pictured import CallsView as CallsView
    from param_tutorial.views.pictured import ChecksView as ChecksView
    from param_tutorial.views.pictured import DeclarationsView as DeclarationsView
    from param_tutorial.views.pictured import LayersView as LayersView
    from param_tutorial.views.pictured import LiftsView as LiftsView
    from param_tutorial.views.pictured import PlaneView as PlaneView
    from param_tutorial.views.pictured import RequestsView as RequestsView
    from param_tutorial.views.pictured import TrailView as TrailView
    from param_tutorial.views.pictured import WorldsView as WorldsView
    from param_tutorial.views.recording import record_change as record_change
    from param_tutorial.views.robot import RobotView as RobotView
    from param_tutorial.views.ros_graph import node_graph as node_graph
    from param_tutorial.views.side_by_side import SideBySide as SideBySide
    from param_tutorial.views.step_response import StepResponseView as StepResponseView

_HOMES = {
    'CallsView': 'param_tutorial.views.pictured',
    'CartView': 'param_tutorial.views.cart',
    'ChecksView': 'param_tutorial.views.pictured',
    'DeclarationsView': 'param_tutorial.views.pictured',
    'EventView': 'param_tutorial.views.events',
    'LadderView': 'param_tutorial.views.motion',
    'LayersView': 'param_tutorial.views.pictured',
    'LiftsView': 'param_tutorial.views.pictured',
    'LinePlot': 'param_tutorial.pictures.plots',
    'LogView': 'param_tutorial.views.log',
    'MessageView': 'param_tutorial.views.motion',
    'NumberLineView': 'param_tutorial.views.motion',
    'PlaneView': 'param_tutorial.views.pictured',
    'RequestsView': 'param_tutorial.views.pictured',
    'RobotView': 'param_tutorial.views.robot',
    'SideBySide': 'param_tutorial.views.side_by_side',
    'StepResponseView': 'param_tutorial.views.step_response',
    'TrailView': 'param_tutorial.views.pictured',
    'WorldsView': 'param_tutorial.views.pictured',
    'node_graph': 'param_tutorial.views.ros_graph',
    'plot_responses': 'param_tutorial.pictures.plots',
    'record_change': 'param_tutorial.views.recording',
}
__all__ = list(_HOMES)


def __getattr__(name: str) -> Any:
    return lazy.load(__name__, _HOMES, name)


def __dir__() -> list[str]:
    return sorted({*globals(), *_HOMES})
