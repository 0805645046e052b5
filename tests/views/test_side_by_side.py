"""Two views as one: they stay whole when the frame goes, and the frame loses what is closed."""

import pytest

from param_tutorial import ParameterPanel
from param_tutorial.nodes.clawbot_node import ClawbotNode
from param_tutorial.views import RobotView, SideBySide


@pytest.fixture
def views(ros):
    robot = ros.add(ClawbotNode, real_time=False)
    return RobotView(robot), ParameterPanel(robot, names=['max_speed_rpm', 'enable_safety_mode'])


def test_its_repr_names_both_and_says_nothing_of_the_moment(ros, views):
    both = SideBySide(*views)
    before = repr(both)
    ros.remove(*ros.nodes)
    assert before == repr(both) == '<SideBySide: RobotView of /clawbot_node and ParameterPanel of /clawbot_node>'


def test_closing_it_leaves_the_views_as_they_are(views):
    view, panel = views
    first, second = SideBySide(view, panel), SideBySide(view, panel)
    first.close()
    first.close()
    assert first.comm is None and first._box.comm is None and first._box.children == ()
    assert second._box.children == (view, panel)
    panel['max_speed_rpm'].value = 50
    panel.settle()
    assert panel['max_speed_rpm'].value == 50
    assert view.comm is not None


def test_a_view_that_is_closed_leaves_it_before(views):
    view, panel = views
    both = SideBySide(view, panel)
    open_then = []
    both._box.observe(lambda change: open_then.append(view.comm is not None), 'children')
    view.close()
    assert both._box.children == (panel,)
    assert open_then == [True]
    both.close()
    assert len(panel._on_close) == 0
