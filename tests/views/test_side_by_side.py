"""Two views as one: they stay whole when the frame goes, and the frame loses what is closed."""

from param_tutorial import ParameterPanel
from param_tutorial.nodes.clawbot_node import ClawbotNode
from param_tutorial.views import RobotView, SideBySide


def test_closing_it_leaves_its_views_and_a_view_that_is_closed_leaves_it_before(ros):
    robot = ros.add(ClawbotNode, real_time=False)
    view, panel = RobotView(robot), ParameterPanel(robot, names=['max_speed_rpm', 'enable_safety_mode'])
    first, second = SideBySide(view, panel), SideBySide(view, panel)
    assert repr(first) == '<SideBySide: RobotView of /clawbot_node and ParameterPanel of /clawbot_node>'
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
