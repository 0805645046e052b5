"""What a cell made goes when the cell runs again."""

from param_tutorial.nodes.simple_param_node import SimpleParamNode
from param_tutorial.widgets import cells
from param_tutorial.widgets.log import LogView
from param_tutorial.widgets.panel import ParameterPanel


def test_a_cell_that_runs_again_closes_what_it_made(ros, monkeypatch):
    ros.add(SimpleParamNode)
    run = [('cell 1', 'run 1')]
    monkeypatch.setattr(cells, '_this_cell', lambda: run[0])
    monkeypatch.setattr(cells, '_made', {})
    first, second = ParameterPanel('/simple_param_node'), LogView()
    run[0] = ('cell 2', 'run 2')
    elsewhere = ParameterPanel('/simple_param_node')
    assert 'closed' not in repr(first)
    run[0] = ('cell 1', 'run 3')
    ParameterPanel('/simple_param_node').close()
    assert repr(first) == '<ParameterPanel: /simple_param_node, closed>'
    assert second.comm is None
    assert repr(elsewhere) == '<ParameterPanel: /simple_param_node, 9 parameters>'
