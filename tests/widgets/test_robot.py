"""The robot's view: what it sends to the browser and when, its words, and that it releases the robot."""

import math
import re

import pytest

from param_tutorial import ParameterClient, RobotView, wait_until
from param_tutorial.errors import NodeNotFoundError
from param_tutorial.nodes.clawbot_node import ClawbotNode
from param_tutorial.runtime import stage
from tests.support.widgets import press

FOREVER = math.inf


@pytest.fixture
def robot(ros):
    return ros.add(ClawbotNode, real_time=False)


@pytest.fixture
def view(robot):
    view = RobotView(robot)
    yield view
    view.close()


def shows(view, word):
    """Wait until the view says this."""
    wait_until(lambda: view.text.startswith(word), f'the view to say {word}; it says {view.text!r}')


def picture(view):
    """Return the markup that the browser draws."""
    return view._front.picture


def test_a_drive_is_sent_as_its_phases(view, robot):
    assert '@keyframes' not in picture(view)
    view.drive()
    shows(view, 'SPEEDING UP')
    steps = re.search(r'@keyframes robot-NAME-robot \{(.*?)\}\}', picture(view))[1]
    phases, units_per_m = robot.motion[0].phases, 1000 / (0.8 + 4.0 + 0.35)
    places = [float(place) for place in re.findall(r'translateX\(([\d.]+)px\)', steps)]
    assert places == pytest.approx(
        [(0.8 + at_m) * units_per_m for at_m in (*[p.position_m for p in phases], 3.8)], abs=1e-2)
    assert steps.count('cubic-bezier') == len(phases) == 3
    assert f'{robot.motion[0].duration_sec:.4f}s linear both' in picture(view)


def test_a_second_drive_on_the_way_begins_the_picture_anew(view, robot):
    view.drive()
    shows(view, 'SPEEDING UP')
    take = view._front.take
    robot.step(1.0)
    view.drive()
    wait_until(lambda: (view._front.take, view._front.scene[:2]) == (take + 1, [0.0, 'SPEEDING UP']), 'the new drive')


def test_a_parameter_changed_on_the_way_is_sent_from_where_the_robot_is(view, robot):
    view.drive()
    robot.step(1.0)
    ParameterClient(robot).set_parameter('max_acceleration_mps2', 1.5)
    wait_until(lambda: '1.50 m/s²' in view.text, 'the new acceleration')
    assert 'Speed 0.50 m/s, 3.75 m to the wall' in view.text
    assert f'translateX({1000 * 1.05 / 5.15:.3f}px)' in picture(view)


def test_name_safety_and_offset_are_seen_at_once_while_it_stands(view, robot):
    client = ParameterClient(robot)
    stop_line = '>stop</text>'
    assert stop_line in picture(view)
    client.set_parameters({'robot_name': 'A <b>"claw"</b>', 'enable_safety_mode': False})
    wait_until(lambda: 'safety off' in view.text and 'A <b>' in view.text, 'the changes')
    assert stop_line not in picture(view)
    assert '<b>' not in picture(view)
    assert 'A &lt;b&gt;&quot;claw&quot;&lt;/b&gt;' in picture(view)


def test_what_it_waits_for_is_kept_up_to_date(view, robot):
    client = ParameterClient(robot)
    client.set_parameters({'simulation.ambient_temperature_c': -10})
    view.drive()
    wait_until(lambda: '-10 °C is below' in view.text, 'the view to say how cold it is')
    client.set_parameters({'simulation.ambient_temperature_c': -20})  # still too cold, so the robot waits on
    wait_until(lambda: '-20 °C is below' in view.text, f'the view to follow; it says {view.text!r}')


def test_the_picture_has_a_text_alternative_and_the_words_a_live_region(view, robot):
    assert view.text == 'READY. Clawbot stands at the start. Speed 0.00 m/s, 4.00 m to the wall, safety on.'
    assert f'role="img" aria-label="{view.text}"' in picture(view)
    assert view._front.scene[2:4] == [view.text, 'Clawbot stands at the start.']
    assert '<div class="robot-says" role="status">' in view._front.markup
    assert 'prefers-reduced-motion: reduce' in view._front._css


@pytest.mark.parametrize(('change', 'text'), [
    ({}, 'STOPPED. Clawbot has stopped 0.20 m from the wall. Speed 0.00 m/s, 0.20 m to the wall, safety on.'),
    ({'enable_safety_mode': False},
     'CRASHED. Clawbot has run into the wall at 1.05 m/s. Speed 0.00 m/s, 0.00 m to the wall, safety off.'),
    ({'min_operating_temperature_c': 20},
     'WAITING. Clawbot is waiting: 15 °C is below min_operating_temperature_c = 20. '
     'Speed 0.00 m/s, 4.00 m to the wall, safety on.'),
])
def test_each_end_in_words(view, robot, change, text):
    ParameterClient(robot).set_parameters(change).raise_for_reason()
    view.drive()
    robot.step(FOREVER)
    wait_until(lambda: view.text == text, f'the view to say so; it says {view.text!r}')
    assert text.split('.')[0] in picture(view)


def test_the_button_drives(view, robot):
    press(view, 'drive')
    assert robot.state.word == 'SPEEDING UP'


def test_its_repr_says_nothing_of_the_moment(view):
    before = repr(view)
    view.drive()
    assert before == repr(view) == '<RobotView: /clawbot_node>'
    view.close()
    assert repr(view) == '<RobotView: /clawbot_node, closed>'


@pytest.mark.slow
def test_it_follows_a_robot_that_is_replaced_and_survives_one_that_is_gone(ros, view, robot):
    again = ros.add(ClawbotNode, real_time=False, ros_args=['-p', 'robot_name:=Second'])
    wait_until(lambda: 'Second' in view.text, 'the view to follow')
    assert robot._listeners == []
    assert len(again._listeners) == 1
    ros.remove(again)
    shows(view, '/clawbot_node is not running')
    with pytest.raises(NodeNotFoundError):
        view.drive()
    press(view, 'drive')  # before the page knows that the robot is gone
    assert view._front.scene == []
    ros.add(ClawbotNode, real_time=False)
    shows(view, 'READY')


def test_closed_it_listens_to_nothing(ros, robot):
    before = len(ros._graph_listeners), len(stage._change_listeners)
    view = RobotView(robot)
    view.close()
    view.close()
    assert robot._listeners == []
    assert (len(ros._graph_listeners), len(stage._change_listeners)) == before
    robot.drive()


def test_it_may_be_made_before_its_robot(ros):
    view = RobotView('clawbot_node')
    assert view.text == '/clawbot_node is not running. It comes back here when it does.'
    ros.add(ClawbotNode, real_time=False)
    shows(view, 'READY')
    view.close()
