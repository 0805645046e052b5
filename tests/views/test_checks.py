"""The checks of a node: which one stops a request, and what was passed before."""

import re

import pytest
from rcl_interfaces.msg import IntegerRange, ParameterDescriptor, SetParametersResult
from rclpy.node import Node

from param_tools.errors import NodeNotFoundError
from param_tutorial.views import ChecksView
from param_tutorial.views.drawing.checks import Checks
from tests.support.drawings import kinds, words

CHECKS = Checks('/strict', [('serial', "'x'", 'read only'), ('speed', '45', 'off the step'),
                            ('speed', '70', 'accepted'), ('max_speed_rpm', '900', 'accepted')])


def test_each_request_says_what_it_passed_and_what_stopped_it():
    assert CHECKS.text == (
        'Checks in their order: declared, read-only, type, range, step, on-set callbacks. '
        "serial = 'x' passes declared, and is stopped at read-only: read only. "
        'speed = 45 passes declared, read-only, type, range, and is stopped at step: off the step. '
        'speed = 70 passes all checks and is stored. max_speed_rpm = 900 passes all checks and is stored.')
    assert CHECKS.sentence == '2 of 4 get through all checks.'


def test_check_marks_and_crosses_tell_it_without_color():
    assert kinds(CHECKS).count('check') == 1 + 4 + 6 + 6
    assert kinds(CHECKS).count('cross') == kinds(CHECKS).count('token-bad') == 2
    assert {'read only', 'off the step', 'accepted'} <= set(words(CHECKS))


def test_a_long_name_makes_room_for_the_token():
    assert 'max_speed_rpm' in words(CHECKS) and 'max_speed_rpm = 900' not in words(CHECKS)


# -- the view ------------------------------------------------------------------------------------------------

class Strict(Node):
    def __init__(self):
        super().__init__('strict')
        limits = [IntegerRange(from_value=0, to_value=100, step=10)]
        self.declare_parameter('speed', 50, ParameterDescriptor(integer_range=limits))
        self.declare_parameter('serial', 50, ParameterDescriptor(integer_range=limits, read_only=True))
        self.add_on_set_parameters_callback(
            lambda parameters: SetParametersResult(successful=parameters[0].value != 60, reason='it rattles'))


def test_a_request_is_stopped_by_the_first_check_that_it_fails(ros):
    """Each but the last is wrong for its own check and for all later ones that can see it."""
    view = ChecksView(ros.add(Strict), [
        ('sped', 'x'), ('serial', 'x'), ('serial', 905), ('speed', None), ('speed', '60'), ('speed', 905),
        ('speed', 45), ('speed', 60), ('speed', 70)])
    stopped = re.findall(r'(\w+ = \S+) .*?(?:stopped at ([\w -]+):|is (stored))', view.text)
    assert stopped == [
        ("sped = 'x'", 'declared', ''), ("serial = 'x'", 'read-only', ''), ('serial = 905', 'read-only', ''),
        ('speed = None', 'type', ''), ("speed = '60'", 'type', ''), ('speed = 905', 'range', ''),
        ('speed = 45', 'step', ''), ('speed = 60', 'on-set callbacks', ''), ('speed = 70', '', 'stored')]
    assert repr(view) == '<ChecksView: 1 of 9 get through all checks.>' and view.node == '/strict'


@pytest.mark.slow
def test_no_check_is_shown_for_a_node_that_is_not_there(ros):
    with pytest.raises(NodeNotFoundError):
        ChecksView('/nobody', [('speed', 1)])
