"""Views beside each other, as one widget."""

from param_tutorial import ParameterPanel
from param_tutorial.nodes.base_node import BaseNode
from param_tutorial.views import SideBySide, TrackView


def test_closing_it_leaves_its_views_and_a_view_that_is_closed_leaves_it_before(ros):
    base = ros.add(BaseNode)
    view, panel = TrackView(base), ParameterPanel(base)
    first, second = SideBySide(view, panel), SideBySide(view, panel)
    assert repr(first) == '<SideBySide: TrackView of /base and ParameterPanel of /base>'
    first.close()
    first.close()
    assert first.comm is None and first._box.children == () and view.comm is not None
    assert second._box.children == (view, panel)
    open_then = []
    second._box.observe(lambda change: open_then.append(view.comm is not None), 'children')
    view.close()
    assert second._box.children == (panel,) and open_then == [True]
    second.close()
    assert len(panel._on_close) == 0
