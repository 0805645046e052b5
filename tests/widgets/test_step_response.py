"""The view of a step response: what it says and draws, when it sends something, and that it lets go of its node."""

import math
import re

import pytest
from rclpy.node import Node

from param_tutorial import ParameterClient, ParameterPanel, StepResponseView, wait_until
from param_tutorial.nodes.pid_controller_node import Figures, PidControllerNode
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from param_tutorial.runtime import stage
from param_tutorial.widgets.step_response import Goals

KP, KI = 'gains.wheel_joint.p', 'gains.wheel_joint.i'
START = ('wheel_joint with p = 0.1, i = 0, d = 0: rise time 0.26 s, overshoot 4.5 %, settling time 0.67 s, '
         'steady-state error 2.86 rad/s')


@pytest.fixture
def controller(ros):
    return ros.add(PidControllerNode)


@pytest.fixture
def view(controller):
    view = StepResponseView(controller)
    yield view
    view.close()


def shows(view, words):
    wait_until(lambda: words in view.text, f'the view to say {words}; it says {view.text!r}')


def markup(view):
    """Return what the browser draws: the picture, and the figures."""
    return [each.value for each in view.children[1:]]


def test_it_shows_the_response_with_its_figures_and_the_same_in_words(view):
    assert view.text == START
    picture, figures = markup(view)
    assert re.search(r'<svg role="img" aria-label="speed in rad/s over time in s. reference: 10 rad/s. wheel_joint: '
                     r'rise time 0.26 s', picture)
    assert 'p = 0.1, i = 0, d = 0' in picture
    assert '<div class="step-figures" role="status">' in figures
    for part in ('rise time 0.26 s', 'overshoot 4.5 %', 'settling time 0.67 s', 'steady-state error 2.86 rad/s'):
        assert f'<span>{part}' in figures


def test_it_redraws_when_a_gain_is_moved_on_a_panel(view, controller):
    panel = ParameterPanel(controller)
    panel[KP].value = 0.4
    shows(view, 'p = 0.4')
    assert view.text.endswith(str(controller.response().figures))
    panel.close()


def test_it_shows_what_was_confirmed_and_nothing_of_what_was_rejected(view, controller):
    client = ParameterClient(controller)
    client.set_parameters_atomically({KP: 0.4, KI: -1.0})
    client.set_parameter('simulation.reference_rad_per_sec', 5.0)
    shows(view, 'error 1.43')
    assert 'p = 0.1, i = 0,' in view.text


def test_each_figure_says_by_shape_and_word_whether_it_meets_its_goal(view):
    figures = markup(view)[1]
    assert 'overshoot 4.5 % <b class="step-met">✓ goal met: below 5 %</b>' in figures
    assert 'settling time 0.67 s <b class="step-missed">✗ not yet: below 0.4 s</b>' in figures
    assert 'error 2.86 rad/s <b class="step-missed">✗ not yet: within 0.1 rad/s</b>' in figures
    assert '<span>rise time 0.26 s</span>' in figures
    assert 'target: 9.7 to 10.3 from 0.4 on' in markup(view)[0]
    unsteady = Figures(12.0, -2.0, None, None, None)
    assert list(Goals().verdicts(unsteady)) == [
        ('no steady speed', False, 'a steady speed'), ('12.00 rad/s at the end', None, '')]


def test_goals_of_your_own(controller):
    view = StepResponseView(controller, goals=Goals(error=3.0, overshoot_percent=1.0, settling_sec=1.0))
    figures = markup(view)[1]
    assert '✗ not yet: below 1 %' in figures and '✓ goal met: within 3 rad/s' in figures
    view.close()


def test_the_curve_of_before_a_drag_stays_and_a_page_without_a_kernel_does_not_get_it(view, controller):
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
    assert view._before is before
    assert '>before<' not in view.look() and '>before<' not in view.snapshot()['html']
    first = view.look()
    client.set_parameter(KP, 0.5)
    client.set_parameter(KP, 0.3)
    shows(view, 'p = 0.3')
    assert view.look() == first


def test_its_wheel_turns_as_the_response_says(view):
    picture = markup(view)[0]
    assert re.search(r'@keyframes (wheel-\w+) .*class="step-wheel".*animation:\1 3.00s linear both', picture)
    assert 'prefers-reduced-motion' in view.snapshot()['html']


def test_it_follows_a_controller_that_is_restarted_and_survives_one_that_is_gone(ros, view, controller):
    ros.remove(controller)
    shows(view, '/pid_controller_node is not running')
    # The words for a screen reader are there first.
    wait_until(lambda: 'is not running' in markup(view)[1] and '<svg' not in markup(view)[0], 'the picture to go')
    ros.add(PidControllerNode, ros_args=['-p', f'{KP}:=0.4'])
    shows(view, 'p = 0.4')


def test_another_joint_can_be_chosen(ros):
    ros.add(PidControllerNode, ros_args=['-p', 'dof_names:=[left, right]', '-p', 'gains.right.p:=0.4'])
    for joint, words in ((None, 'left with p = 0.1'), ('right', 'right with p = 0.4')):
        view = StepResponseView('pid_controller_node', joint=joint)
        assert view.text.startswith(words)
        view.close()


@pytest.mark.parametrize(('node_class', 'options', 'missing'), [
    (SimpleParamNode, {}, 'dof_names'), (PidControllerNode, {'joint': 'elbow'}, 'gains.elbow.p')])
def test_what_it_cannot_simulate_it_names(ros, node_class, options, missing):
    node = ros.add(node_class)
    view = StepResponseView(ParameterClient(node), **options)
    assert view.text == (f'{node.get_fully_qualified_name()} has no parameter {missing}, '
                         f'so there is nothing to simulate.')
    view.close()


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
    view.close()


def test_names_are_text(ros):
    ros.add(PidControllerNode, ros_args=['-p', "dof_names:=['<b>']"])
    view = StepResponseView('pid_controller_node')
    assert '<b>' in view.text and '<b>' not in markup(view)[0]
    view.close()


def test_its_repr_says_nothing_of_the_moment_and_closed_it_listens_to_nothing(ros, controller):
    before = len(ros._graph_listeners), len(stage._change_listeners)
    view = StepResponseView(controller)
    assert repr(view) == '<StepResponseView: /pid_controller_node>'
    view.close()
    view.close()
    assert repr(view) == '<StepResponseView: /pid_controller_node, closed>'
    assert (len(ros._graph_listeners), len(stage._change_listeners)) == before
    ParameterClient(controller).set_parameter(KP, 0.4)
    assert view.text == START
