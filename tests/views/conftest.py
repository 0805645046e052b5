"""Fixtures of the tests of views."""

import pytest
from rcl_interfaces.msg import IntegerRange, ParameterDescriptor, SetParametersResult
from rclpy.node import Node
from rclpy.parameter import Parameter

import param_tutorial
from param_tutorial import ParameterClient
from tests.support.nodes import Weather
from tests.widgets.conftest import _close_all  # noqa: F401


@pytest.fixture
def weather(ros):
    return ros.add(Weather)


class Robot(Node):
    """Has a callback of each kind: one trims the speed to 300, and one rejects -5."""

    def __init__(self, name='robot'):
        super().__init__(name)
        self.declare_parameter('speed', 100)
        self.declare_parameter('opening', 40, ParameterDescriptor(
            integer_range=[IntegerRange(from_value=0, to_value=85, step=10)]))
        self.declare_parameter('serial', 7, ParameterDescriptor(read_only=True))
        self.declare_parameter('note', 'new', ParameterDescriptor(dynamic_typing=True))
        self.acted = []
        self.add_pre_set_parameters_callback(self.trim)
        self.add_on_set_parameters_callback(self.judge)
        self.add_post_set_parameters_callback(self.act)

    def trim(self, parameters):
        return [Parameter(each.name, value=min(each.value, 300)) if each.name == 'speed' else each
                for each in parameters]

    def judge(self, parameters):
        return SetParametersResult(successful=parameters[0].value != -5, reason='minus five')

    def act(self, parameters):
        self.acted += [each.value for each in parameters]


@pytest.fixture
def robot(ros):
    return ros.add(Robot)


@pytest.fixture
def client(robot):
    return ParameterClient(robot)


def shows(view, words):
    """Wait until a view says this."""
    param_tutorial.wait_until(lambda: words in view.text, f'the view to say {words!r}; it says {view.text!r}')
