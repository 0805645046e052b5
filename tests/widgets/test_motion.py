"""Pictures that play what happens to a real node: what they show, what they wait for, and that they let go."""

import re

import pytest
from rcl_interfaces.msg import IntegerRange, ParameterDescriptor, ParameterEvent, SetParametersResult
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.qos import DurabilityPolicy, QoSProfile

import param_tutorial
from param_tutorial import LadderView, MessageView, NumberLineView, ParameterClient
from param_tutorial.errors import CallbackError, NodeNotFoundError
from param_tutorial.nodes.param_event_monitor import ParamEventMonitor
from param_tutorial.widgets.motion import MotionView
from tests.support.widgets import texts


class Robot(Node):
    def __init__(self, name='robot'):
        super().__init__(name)
        self.declare_parameter('speed', 100)
        self.declare_parameter('opening', 40, ParameterDescriptor(
            integer_range=[IntegerRange(from_value=0, to_value=85, step=10)]))
        self.declare_parameter('serial', 7, ParameterDescriptor(read_only=True))
        self.declare_parameter('note', 'new')
        self.add_pre_set_parameters_callback(self.trim)
        self.add_on_set_parameters_callback(self.judge)
        self.add_post_set_parameters_callback(self.act)

    def trim(self, parameters):
        return [Parameter(each.name, value=min(each.value, 300)) if each.name == 'speed' else each
                for each in parameters]

    def judge(self, parameters):
        return SetParametersResult(successful=parameters[0].value != -5, reason='minus five')

    def act(self, parameters):
        pass


@pytest.fixture
def robot(ros):
    return ros.add(Robot)


@pytest.fixture
def client(robot):
    return ParameterClient(robot)


def wait_for_text(view, words):
    param_tutorial.wait_until(lambda: words in view.text, f'{words!r} in the picture')


# -- the ladder ----------------------------------------------------------------------------------------------

def test_a_value_climbs_the_ladder_when_anybody_sets_it(robot, client):
    view = LadderView(robot)
    assert view.text == 'Set a parameter, and see how far the value climbs.'
    client.set_parameter('speed', 900)
    wait_for_text(view, 'speed = 900 is accepted, and 300 is stored')
    assert 'trim gives 300' in texts(view) and '@keyframes' in texts(view)


def test_a_rejected_value_falls_with_the_nodes_words(robot, client):
    view = LadderView(client, 'speed')
    client.set_parameter('speed', -5)
    wait_for_text(view, 'judge rejects: minus five; stored is 100')
    with pytest.raises(CallbackError):
        client.set_parameter('speed', 'fast')
    wait_for_text(view, 'an exception at pre-set callbacks, and the caller gets no answer')


def test_what_the_node_sets_itself_climbs_too(ros, robot):
    view = LadderView(robot)
    ros.run(lambda: robot.set_parameters([Parameter('speed', value=7)]), 'set')
    wait_for_text(view, 'speed = 7 is accepted')


def test_the_ladder_follows_a_node_that_is_replaced(ros, robot):
    view = LadderView('/robot')
    robot = ros.add(Robot)
    ParameterClient(robot).set_parameter('speed', 8)
    wait_for_text(view, 'speed = 8')


def test_a_node_that_is_not_there_is_waited_for(ros):
    view = LadderView('robot')
    assert 'is not running' in view.text
    ros.add(Robot)
    wait_for_text(view, 'Set a parameter')


@pytest.mark.slow
def test_asked_for_a_value_it_shows_what_comes_of_it_and_nothing_after(robot, client):
    accepted, rejected = LadderView(robot, 'speed', 900), LadderView(robot, 'speed', -5)
    line, message = NumberLineView(client, 'opening', 45), MessageView(client, 'speed', 7)
    assert [repr(view) for view in (accepted, rejected, line)] == [
        '<LadderView: speed = 900 is accepted, and 300 is stored.>',
        '<LadderView: speed = -5 is rejected at on-set callbacks.>',
        '<NumberLineView: opening = 45 is rejected; 40 stays.>']
    assert 'It says: changed speed = 7.' in message.text and repr(message) == '<MessageView: /robot accepted speed = 7>'
    before = [texts(view) for view in (accepted, rejected, line, message)]
    other = LadderView(robot)
    client.set_parameters({'speed': 8, 'opening': 50})
    wait_for_text(other, 'opening = 50')
    assert [texts(view) for view in (accepted, rejected, line, message)] == before


def test_a_node_that_is_not_there_cannot_be_asked(ros):
    with pytest.raises(NodeNotFoundError, match='/nobody'):
        LadderView('nobody', 'speed', 1)


# -- the number line -----------------------------------------------------------------------------------------

@pytest.mark.slow
def test_the_number_line_shows_range_value_and_request(robot, client):
    view = NumberLineView(robot, 'opening')
    assert view.text == 'Number line of opening of /robot: 0 to 85 in steps of 10; stored is 40. opening = 40'
    client.set_parameter('opening', 45)
    wait_for_text(view, 'opening = 45 is rejected; 40 stays. The parameter value for opening is not a valid step')
    client.set_parameter('opening', 85)
    wait_for_text(view, 'stored is 85. opening = 85 is stored.')


def test_a_locked_number_and_one_without_limits(robot, client):
    locked, free = NumberLineView(robot, 'serial'), NumberLineView(robot, 'speed')
    client.set_parameter('serial', 8)
    wait_for_text(locked, 'no limits, read-only; stored is 7. serial = 8 is rejected; 7 stays.')
    client.set_parameter('speed', -5)
    wait_for_text(free, 'speed = -5 is rejected')


def test_the_number_line_of_no_number_says_so(robot):
    assert NumberLineView(robot, 'note').text == 'note is not a number.'
    assert 'no parameter wings' in NumberLineView(robot, 'wings').text


# -- messages ------------------------------------------------------------------------------------------------

@pytest.mark.slow
def test_a_message_travels_to_all_who_listen(ros, robot, client):
    ros.add(ParamEventMonitor)
    view = MessageView()
    assert 'Nothing has changed yet' in view.text
    client.set_parameter('speed', 5)
    wait_for_text(view, 'A message from /robot goes to 2 listeners. It says: changed speed = 5.')
    assert 'subscribe to it: /param_event_monitor, this notebook' in view.text
    client.set_parameter('speed', -5)
    client.set_parameter('speed', 6)
    wait_for_text(view, 'It says: changed speed = 6.')


def test_a_subscription_that_asks_for_too_much_gets_nothing(ros, robot, client):
    class Hopeful(Node):
        def __init__(self):
            super().__init__('hopeful')
            profile = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)
            self.create_subscription(ParameterEvent, '/parameter_events', print, profile)

    ros.add(Hopeful)
    view = MessageView()
    client.set_parameter('speed', 5)
    wait_for_text(view, 'their QoS is incompatible: /hopeful. A message from /robot goes to 1 listener.')


def test_who_comes_later_changes_the_picture_and_sends_nothing_again(ros, robot, client):
    view = MessageView()
    client.set_parameter('speed', 5)
    wait_for_text(view, 'goes to 1 listener.')
    ros.add(ParamEventMonitor)
    wait_for_text(view, '/param_event_monitor, this notebook')
    assert '@keyframes' not in view.children[1].value


# -- all of them ---------------------------------------------------------------------------------------------

VIEWS = {'ladder': LadderView, 'line': lambda node: NumberLineView(node, 'speed'), 'messages': lambda _: MessageView()}


@pytest.mark.parametrize('make', VIEWS.values(), ids=VIEWS)
def test_each_has_a_still_for_a_page_without_a_kernel(robot, client, make):
    view = make(robot)
    client.set_parameter('speed', 5)
    wait_for_text(view, 'speed = 5')
    recorded = view.snapshot()
    assert recorded['kind'] == 'still' and recorded['text'] == repr(view)
    assert re.search(r'<div class="motion">.*aria-label="[^"]*speed = 5', recorded['html'], re.DOTALL)
    assert 'prefers-reduced-motion' in recorded['html']


@pytest.mark.slow
@pytest.mark.parametrize('make', VIEWS.values(), ids=VIEWS)
def test_closed_it_hears_no_more_and_outlives_the_stage(ros, robot, client, make):
    view, other = make(robot), make(robot)
    assert isinstance(view, MotionView)
    view.close()
    view.close()
    client.set_parameter('speed', 5)
    wait_for_text(other, 'speed = 5')
    assert 'speed = 5' not in view.text
    assert 'closed' in repr(view)
    param_tutorial.stop()
    again = param_tutorial.start()
    again.add(Robot)
    ParameterClient('/robot').set_parameter('speed', 9)
    wait_for_text(other, '9')
