"""Messages on their way: from whom, to whom, and who gets nothing."""

from xml.etree import ElementTree

from param_tutorial.pictures import motion
from param_tutorial.pictures.messages import MessageTraffic

LISTENERS = {'/monitor': True, '/hopeful': False, 'this notebook': True}


def drawn(traffic):
    return ElementTree.fromstring(traffic.html(motion.Reel('one', is_still=True)))


def test_it_tells_in_words_what_it_draws():
    traffic = MessageTraffic(['/arm', '/monitor'], LISTENERS, '/arm', ['changed speed = 2', 'deleted note'])
    assert traffic.text == (
        'Publish on /parameter_events: /arm, /monitor; subscribe to it: /monitor, this notebook; '
        'subscribe to it and get nothing, since their QoS is incompatible: /hopeful. '
        'A message from /arm goes to 2 listeners. It says: changed speed = 2; deleted note.')
    assert drawn(traffic).find('.//*[@role="img"]').get('aria-label') == traffic.text


def test_each_listener_that_is_reached_gets_a_letter():
    def letters(listeners):
        picture = drawn(MessageTraffic(['/arm'], listeners, '/arm', ['changed speed = 2']))
        return sum(path.get('d').startswith('M-15 -9') for path in picture.iter('path'))

    assert letters({}) + 3 == letters({'/a': True, '/b': True, '/c': True})
    assert letters({'/a': False}) == letters({})


def test_before_anything_has_changed_nothing_travels():
    traffic = MessageTraffic(['/arm'], LISTENERS)
    assert traffic.text.endswith('Nothing has changed yet.')
    assert 'gets it' not in drawn(traffic).itertext()


def test_whoever_has_something_to_say_is_never_left_out():
    traffic = MessageTraffic([f'/node_{number:02}' for number in range(30)], {}, '/zoo', ['changed speed = 2'])
    assert '/zoo' in drawn(traffic).itertext()
    assert len([text for text in drawn(traffic).itertext() if text.startswith('/node_')]) == 7
