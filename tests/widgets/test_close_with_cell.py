"""What a cell made goes when the cell runs again."""

import pytest

from param_tools.panel import close_with_cell
from param_tools.panel.panel import ParameterPanel
from param_tutorial.nodes.base_node import BaseNode
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from param_tutorial.notebook.magics import terminal_hint
from param_tutorial.views import EventView, SideBySide, TrackView


@pytest.fixture
def run(monkeypatch):
    """Yield a list whose one item is the cell that runs now, and which of its runs it is."""
    run = [('cell 1', 'run 1')]
    monkeypatch.setattr(close_with_cell, 'this_cell', lambda: run[0])
    monkeypatch.setattr(close_with_cell, '_made', {})
    return run


def test_a_cell_that_runs_again_closes_what_it_made(ros, run):
    ros.add(SimpleParamNode)
    first, second, third = ParameterPanel('/simple_param_node'), EventView(), terminal_hint()
    run[0] = ('cell 2', 'run 2')
    elsewhere = ParameterPanel('/simple_param_node')
    assert 'closed' not in repr(first)
    run[0] = ('cell 1', 'run 3')
    ParameterPanel('/simple_param_node').close()
    assert repr(first) == '<ParameterPanel: /simple_param_node, closed>'
    assert second.comm is third.comm is None
    assert repr(elsewhere) == '<ParameterPanel: /simple_param_node, 9 parameters>'


def test_what_another_cell_shows_stays_until_that_one_runs_again(ros, run):
    ros.add(BaseNode)

    def run_cell(cell, number):
        run[0] = (cell, f'run {number}')

    view, panel = TrackView(), ParameterPanel('/base')
    run_cell('cell 2', 2)
    both = SideBySide(view, panel)
    run_cell('cell 3', 3)
    panel._repr_mimebundle_()
    run_cell('cell 1', 4)
    new_view, _ = TrackView(), ParameterPanel('/base')
    assert both._box.children == (view, panel) and view.comm and panel.comm
    # The panel is still in the third cell, and the robot nowhere else.
    run_cell('cell 2', 5)
    SideBySide(new_view, panel)
    assert both.comm is view.comm is None and panel.comm and new_view.comm
    run_cell('cell 3', 6)
    panel._repr_mimebundle_()
    assert panel.comm
    run_cell('cell 2', 7)
    EventView()
    assert panel.comm and new_view.comm
    run_cell('cell 3', 8)
    EventView()
    assert panel.comm is None
