"""Messages on their way: from whom, to whom, and who gets nothing."""

from rcl_interfaces.msg import ParameterEvent
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile

from param_tutorial.nodes.param_event_monitor import ParamEventMonitor
from param_tutorial.views import MessageView
from param_tutorial.views.drawing.messages import MessageTraffic
from tests.support.drawings import drawn, words

LISTENERS = {'/monitor': True, '/hopeful': False, 'this notebook': True}


def test_it_tells_in_words_what_it_draws():
    traffic = MessageTraffic(['/arm', '/monitor'], LISTENERS, '/arm', ['changed speed = 2', 'deleted note'])
    assert traffic.text == (
        'Publish on /parameter_events: /arm, /monitor; subscribe to it: /monitor, this notebook; '
        'subscribe to it and get nothing, since their QoS is incompatible: /hopeful. '
        'A message from /arm goes to 2 listeners. It says: changed speed = 2; deleted note.')


def test_each_listener_that_is_reached_gets_a_letter():
    def letters(listeners):
        picture = drawn(MessageTraffic(['/arm'], listeners, '/arm', ['changed speed = 2']))
        return sum(path.get('d').startswith('M-15 -9') for path in picture.iter('path'))

    assert letters({}) + 3 == letters({'/a': True, '/b': True, '/c': True})
    assert letters({'/a': False}) == letters({})


def test_before_anything_has_changed_nothing_travels():
    traffic = MessageTraffic(['/arm'], LISTENERS)
    assert traffic.text.endswith('Nothing has changed yet.')
    assert 'gets it' not in words(traffic)


# -- the view ------------------------------------------------------------------------------------------------

def test_a_rejected_value_sends_no_message(robot):
    view = MessageView(robot, 'speed', -5)
    assert 'Nothing has changed yet' in view.text and 'rejected' in repr(view)


def test_a_message_travels_to_all_who_listen_and_ask_for_no_more_than_there_is(ros, robot, client):
    class Hopeful(Node):
        def __init__(self):
            super().__init__('hopeful')
            profile = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)
            self.create_subscription(ParameterEvent, '/parameter_events', print, profile)

    ros.add(ParamEventMonitor)
    ros.add(Hopeful)
    view = MessageView(client, 'speed', 5)
    assert 'subscribe to it: /param_event_monitor, this notebook' in view.text
    assert view.text.endswith('their QoS is incompatible: /hopeful. A message from /robot goes to 2 listeners. '
                              'It says: changed speed = 5.')
    assert (repr(view), view.node) == ('<MessageView: /robot accepted speed = 5>', '/robot')
