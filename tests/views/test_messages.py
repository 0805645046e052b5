"""Messages on their way: from whom, to whom, and who gets nothing."""

from rcl_interfaces.msg import ParameterEvent
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile

from param_tutorial.nodes.param_event_monitor import ParamEventMonitor
from param_tutorial.views import MessageView
from param_tutorial.views.drawing.messages import Listener, MessageTraffic
from tests.support.drawings import drawn, words

USUAL = Listener('reliable, volatile')
HOPEFUL = Listener('reliable, transient local', 'incompatible QoS')
LISTENERS = {'/monitor': USUAL, '/hopeful': HOPEFUL, 'this notebook': USUAL}


def test_it_tells_in_words_what_it_draws():
    traffic = MessageTraffic(['/arm', '/monitor'], LISTENERS, '/arm', ['changed speed = 2', 'deleted note'],
                             offers='reliable, volatile')
    assert traffic.text == (
        'Publish on /parameter_events (they offer reliable, volatile): /arm, /monitor; '
        'subscribe to it: /monitor (asks for reliable, volatile), this notebook (asks for reliable, volatile); '
        '/hopeful (asks for reliable, transient local) subscribes and gets nothing: incompatible QoS. '
        'A message from /arm goes to 2 listeners. It says: changed speed = 2; deleted note.')
    assert {'they offer: reliable, volatile', 'asks for: reliable, transient local',
            'gets nothing: incompatible QoS'} < set(words(traffic))


def test_each_listener_that_is_reached_gets_a_letter():
    def letters(listeners):
        picture = drawn(MessageTraffic(['/arm'], listeners, '/arm', ['changed speed = 2']))
        return sum(path.get('d').startswith('M-15 -9') for path in picture.iter('path'))

    assert letters({}) + 3 == letters({'/a': USUAL, '/b': USUAL, '/c': USUAL})
    assert letters({'/a': HOPEFUL}) == letters({})


def test_before_anything_has_changed_nothing_travels():
    traffic = MessageTraffic(['/arm'], LISTENERS)
    assert traffic.text.endswith('Nothing has changed yet.')
    assert 'gets it' not in words(traffic)


# -- the view ------------------------------------------------------------------------------------------------

def test_a_rejected_value_sends_no_message(robot):
    view = MessageView(robot, 'speed', -5)
    assert 'Nothing has changed yet' in view.text and 'rejected' in repr(view)


class Ears(Node):
    """Listens, and keeps what it hears."""

    def __init__(self, name, durability):
        super().__init__(name)
        self.heard = []
        self.ears = self.create_subscription(ParameterEvent, '/parameter_events', self.hear,
                                             QoSProfile(depth=10, durability=durability))

    def hear(self, event):
        self.heard += [each.name for each in event.changed_parameters]


def test_a_message_travels_to_all_who_listen_and_ask_for_no_more_than_there_is(ros, robot, client):
    ros.add(ParamEventMonitor)
    ros.add(Ears, 'hopeful', DurabilityPolicy.TRANSIENT_LOCAL)
    view = MessageView(client, 'speed', 5)
    assert 'subscribe to it: /param_event_monitor (asks for reliable, volatile), this notebook' in view.text
    assert view.text.endswith('/hopeful (asks for reliable, transient local) subscribes and gets nothing: incompatible '
                              'QoS. A message from /robot goes to 2 listeners. It says: changed speed = 5.')
    assert (repr(view), view.node) == ('<MessageView: /robot accepted speed = 5>', '/robot')


def test_a_listener_subscribes_again_with_the_qos_that_is_chosen_and_hears_what_that_allows(ros, robot, client):
    ears = ros.add(Ears, 'ears', DurabilityPolicy.TRANSIENT_LOCAL)
    view = MessageView(client, 'speed', 5)
    *_, below = view.children

    def choose(policy, word, name='/ears'):
        ears.heard.clear()
        below._handle_custom_msg({'chosen': [name, policy, word]}, [])
        return ears.heard

    assert below.things == {'/ears': {'reliability': 'reliable', 'durability': 'transient local'}} and not ears.heard
    assert choose('durability', 'volatile') == ['speed']
    assert below.told == view.text and '/ears (asks for reliable, volatile)' in view.text
    assert choose('reliability', 'best effort') == ['speed'] and '/ears (asks for best effort, volatile)' in view.text
    assert choose('durability', 'transient local') == []
    assert '/ears (asks for best effort, transient local) subscribes and gets nothing' in view.text
    # The node has the new subscription wherever it had the old one, and no other.
    assert list(ears.subscriptions) == [ears.ears] and ears.ears.get_publisher_count() == 0
    choose('durability', 'volatile', '/nobody')
    assert '/nobody' in below.said


def test_what_may_arrive_and_does_not_is_drawn_as_not_arrived(ros, robot, client, monkeypatch):
    ears = ros.add(Ears, 'ears', DurabilityPolicy.VOLATILE)
    monkeypatch.setattr('param_tutorial.views.messages._ARRIVAL_SEC', 0.2)
    ros.run(lambda: ears.executor.remove_node(ears), 'leave the node alone')
    assert '/ears (asks for reliable, volatile) subscribes and gets nothing: it did not arrive' in MessageView(
        client, 'speed', 5).text
