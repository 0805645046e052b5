"""Step responses: what the view says and draws, when it sends something, how the wheel turns, and that it lets go."""

import math
import re

import pytest
from rclpy.node import Node

from param_tutorial import ParameterClient, wait_until
from param_tutorial.nodes.pid_controller_node import Figures, PidControllerNode
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from param_tutorial.views import StepResponseView
from param_tutorial.views.step_response import verdicts
from tests.views.conftest import shows

KP, KI = 'gains.wheel_joint.p', 'gains.wheel_joint.i'
START = ('wheel_joint with p = 0.1, i = 0, d = 0: rise time 0.26 s, overshoot 4.5 %, settling time 0.67 s, '
         'steady-state error 2.86 rad/s')


@pytest.fixture
def controller(ros):
    return ros.add(PidControllerNode)


@pytest.fixture
def view(controller):
    return StepResponseView(controller)


def markup(view):
    """Return what the browser draws: the picture, and the figures."""
    return [each.value for each in view.children[1:]]


def test_it_shows_the_response_with_its_figures_and_the_same_in_words(view):
    assert view.text == START
    picture, figures = markup(view)
    assert re.search(r'<svg role="img" aria-label="speed in rad/s over time in s. reference: 10 rad/s. wheel_joint: '
                     r'rise time 0.26 s', picture)
    assert 'p = 0.1, i = 0, d = 0' in picture
    assert re.search(r'@keyframes (wheel-\w+) .*class="step-wheel".*animation:\1 3.00s linear both', picture)
    assert '<div class="step-figures" role="status">' in figures
    for part in ('rise time 0.26 s', 'overshoot 4.5 %', 'settling time 0.67 s', 'steady-state error 2.86 rad/s'):
        assert f'<span>{part}' in figures


def test_a_change_sends_each_part_once_and_what_makes_no_difference_sends_nothing(view, controller):
    sent = []
    for each in view.children:
        each.observe(lambda change: sent.append(change.new), 'value')
    client = ParameterClient(controller)
    client.set_parameters_atomically({KP: 0.4, KI: 0.4})
    shows(view, 'i = 0.4')
    view.settle()
    assert len(sent) == 2
    client.set_parameter(KP, 0.4)
    client.set_parameters_atomically({KP: 0.9, KI: -1.0})  # which the node rejects
    for _ in range(3):
        view.settle()
    assert len(sent) == 2 and 'p = 0.4, i = 0.4' in view.text


def test_each_figure_says_by_shape_and_word_whether_it_meets_its_goal(view):
    figures = markup(view)[1]
    assert 'overshoot 4.5 % <b class="step-met">✓ goal met: below 5 %</b>' in figures
    assert 'settling time 0.67 s <b class="step-missed">✗ not yet: below 0.4 s</b>' in figures
    assert 'error 2.86 rad/s <b class="step-missed">✗ not yet: within 0.1 rad/s</b>' in figures
    assert '<span>rise time 0.26 s</span>' in figures
    assert 'target: 9.7 to 10.3 from 0.4 on' in markup(view)[0]
    unsteady = Figures(12.0, -2.0, None, None, None)
    assert list(verdicts(unsteady)) == [
        ('no steady speed', False, 'a steady speed'), ('12.00 rad/s at the end', None, '')]


def test_the_curve_of_before_a_drag_stays(view, controller):
    assert 'before' not in markup(view)[0]
    client = ParameterClient(controller)
    view._drawn_sec -= 60
    client.set_parameter(KP, 0.2)
    shows(view, 'p = 0.2')
    wait_until(lambda: '>before<' in markup(view)[0], 'the curve of before')
    before = view._before
    view._drawn_sec += 60  # still the same drag
    client.set_parameter(KP, 0.3)
    shows(view, 'p = 0.3')
    view.settle()
    assert view._before is before and '>before<' in markup(view)[0]


def test_it_follows_a_controller_that_is_restarted_and_survives_one_that_is_gone(ros, view, controller):
    ros.remove(controller)
    shows(view, '/pid_controller_node is not running')
    # The words for a screen reader are there first.
    wait_until(lambda: 'is not running' in markup(view)[1] and '<svg' not in markup(view)[0], 'the picture to go')
    ros.add(PidControllerNode, ros_args=['-p', f'{KP}:=0.4'])
    shows(view, 'p = 0.4')


def test_what_it_cannot_simulate_it_names(ros):
    view = StepResponseView(ParameterClient(ros.add(SimpleParamNode)))
    assert view.text == '/simple_param_node has no parameter dof_names, so there is nothing to simulate.'


class Careless(Node):
    """Has the parameters of a controller, and takes any value for them."""

    def __init__(self, like, **others):
        super().__init__('careless')
        own = {name: value for name, value in ParameterClient(like).get_parameters().items() if '.' in name}
        self.declare_parameters('', [*({**own, 'dof_names': ['wheel_joint'], 'update_rate': 100, **others}).items()])


@pytest.mark.parametrize('others', [
    {'update_rate': 0}, {'update_rate': 'often'}, {KP: math.nan}, {KP: 'much'}, {'simulation.inertia_kgm2': 0.0}])
def test_values_that_cannot_be_simulated_are_reported(ros, controller, others):
    ros.add(Careless, controller, **others)
    view = StepResponseView('careless')
    assert view.text.startswith('/careless holds values with which nothing can be simulated: ')
