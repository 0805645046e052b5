"""The views of the course: what a node does, drawn in a cell.

Each view is one file, named like its class, and its drawing is the file of the same name in ``drawing``.
"""

from param_tools import lazy

with lazy.Imports(__name__) as _imports:
    from param_tutorial.views.calls import CallsView as CallsView
    from param_tutorial.views.drawing.plots import LinePlot as LinePlot
    from param_tutorial.views.drawing.step_response import plot_responses as plot_responses
    from param_tutorial.views.events import EventView as EventView
    from param_tutorial.views.ladder import LadderView as LadderView
    from param_tutorial.views.number_line import NumberLineView as NumberLineView
    from param_tutorial.views.plane import PlaneView as PlaneView
    from param_tutorial.views.side_by_side import SideBySide as SideBySide
    from param_tutorial.views.step_response import StepResponseView as StepResponseView
    from param_tutorial.views.track import TrackView as TrackView
__getattr__, __dir__, __all__ = _imports.load, _imports.names, _imports.public
