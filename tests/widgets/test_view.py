"""What all live views have in common: they follow their node, say what is wrong, and release it."""

import gc
import sys

import pytest
from rcl_interfaces.msg import ParameterDescriptor as Describe
from rcl_interfaces.msg import SetParametersResult
from rclpy.node import Node

import param_tutorial
from param_tools.panel.panel import ParameterPanel
from param_tools.ros.waiting import wait_until
from param_tutorial.nodes.pid_controller_node import PidControllerNode
from param_tutorial.views import EventView, StepResponseView, TrackView
from tests.support.widgets import texts


@pytest.mark.parametrize('view', [ParameterPanel, StepResponseView])
def test_a_panel_without_an_executor_says_so_and_comes_alive_with_one(view):
    param_tutorial.stop()
    panel = view('/pid_controller_node')
    assert 'no executor is running' in (panel.status if view is ParameterPanel else panel.text)
    param_tutorial.start().add(PidControllerNode)
    panel.settle()
    assert panel.names if view is ParameterPanel else 'rise time' in panel.text
    panel.close()
    param_tutorial.start()


@pytest.mark.parametrize('view', [ParameterPanel, EventView, TrackView, StepResponseView])
def test_a_view_of_nonsense_says_so_and_nothing_else(ros, view, monkeypatch):
    others = []
    monkeypatch.setattr(sys, 'unraisablehook', lambda each: others.append(each.exc_value))
    with pytest.raises(TypeError, match='3 is not a node'):
        view(3)
    gc.collect()  # and ipywidgets closes what was never built
    assert others == []


def test_text_from_a_node_is_not_taken_for_html(ros):
    evil = '<img src=x onerror=alert(1)>'

    class Evil(Node):
        def __init__(self):
            super().__init__('evil')
            self.declare_parameter('x', 1, Describe(description=evil, additional_constraints=evil))
            self.declare_parameter('<img src=y>.z', evil)
            self.add_on_set_parameters_callback(
                lambda parameters: SetParametersResult(successful=False, reason=evil))

    view = EventView('/evil')
    ros.add(Evil)
    panel = ParameterPanel('/evil')
    panel['x'].value = 2
    panel.settle()
    wait_until(lambda: '&lt;img src=x' in texts(view), 'the table')
    assert panel['x'].message == evil
    # Description, once more as a tooltip, constraints and value; the script puts the reason in as text.
    assert panel._front.markup.count('&lt;img src=x onerror=alert(1)&gt;') == 4
    assert '<img' not in panel._front.markup + texts(view)
