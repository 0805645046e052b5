"""The picture of service calls: where requests end up, what answers carry, and the same in words."""

from xml.etree import ElementTree

import pytest

from param_tutorial.pictures import motion
from param_tutorial.pictures.calls import Call, Calls, Line

ANSWERED = Call('/arm', 'get_parameters', ('tool', 'kp'), (Line("''"), Line('2.0')))
MIXED = Call('/arm', 'set_parameters', ('kp = 3.0', 'tool = 5'),
             (Line('accepted', True), Line('rejected: wrong type', False)))
REJECTED = Call('/arm', 'set_parameters', ('tool = 5',), (Line('rejected: wrong type', False),))
LOST = Call('/amr', 'get_parameters', ('tool',), problem='there is no node /amr. Did you mean /arm?',
            is_delivered=False)
SILENT = Call('/dozing', 'list_parameters', (), problem='/dozing did not answer within 0.5 s')


def drawn(*calls, is_still=True):
    return ElementTree.fromstring(Calls('this notebook', calls).html(motion.Reel('one', is_still=is_still)))


def classes(picture):
    return [each.get('class') for each in picture.iter() if each.get('class')]


def rests(picture):
    """Return the place and the text of each card."""
    return {''.join(card.itertext()): card.get('style') for card in picture.iter('g')
            if 'translate' in card.get('style', '')}


@pytest.mark.parametrize(('call', 'sentence'), [
    (ANSWERED, '/arm answers get_parameters.'),
    (MIXED, '/arm answers set_parameters, 1 of 2 rejected.'),
    (LOST, 'Nobody takes the request get_parameters for /amr.'),
    (SILENT, '/dozing gets the request list_parameters, and no answer comes.')])
def test_what_came_of_a_call_is_said(call, sentence):
    calls = Calls('this notebook', [call])
    assert calls.sentence == sentence and sentence in calls.text
    assert calls.subject == 'this notebook'


def test_all_calls_are_told_in_words():
    assert Calls('me', [MIXED, LOST, SILENT]).text == (
        'Service calls of me. The request set_parameters to /arm carries kp = 3.0; tool = 5. /arm answers '
        'set_parameters, 1 of 2 rejected. The answer carries accepted; rejected: wrong type. The request '
        'get_parameters to /amr carries tool. Nobody takes the request get_parameters for /amr. There is no node '
        '/amr. Did you mean /arm? The request list_parameters to /dozing carries nothing. /dozing gets the request '
        'list_parameters, and no answer comes. /dozing did not answer within 0.5 s.')


def test_a_request_rests_at_the_node_and_its_answer_at_the_asker():
    (request, at_node), (answer, at_asker) = rests(drawn(ANSWERED)).items()
    assert (request, answer) == ('toolkp', "''2.0")
    x_of = [float(style.partition('(')[2].partition('px')[0]) for style in (at_node, at_asker)]
    assert x_of[0] > 400 and x_of[1] < 300


def test_a_lost_request_does_not_reach_the_place_of_the_node():
    (lost,), (taken, _) = rests(drawn(LOST)).values(), rests(drawn(ANSWERED)).values()
    assert float(lost[21:].partition('px')[0]) < float(taken[21:].partition('px')[0])
    picture = drawn(LOST)
    assert 'motion-cross' in classes(picture) and 'motion-dashed' in classes(picture)
    assert 'not there' in picture.itertext()


def test_of_a_node_that_is_silent_nothing_comes_back():
    picture = drawn(SILENT)
    assert list(rests(picture)) == ['(nothing)']
    assert 'no answer' in picture.itertext() and 'motion-cross' in classes(picture)


def test_a_rejection_has_its_own_shape_and_word():
    mixed, rejected = drawn(MIXED), drawn(REJECTED)
    assert {'motion-check', 'motion-cross'} <= set(classes(mixed)) and 'motion-token-bad' not in classes(mixed)
    assert 'motion-token-bad' in classes(rejected) and 'motion-check' not in classes(rejected)
    assert 'rejected: wrong type' in rejected.itertext()


def test_a_long_answer_is_cut_and_says_so():
    picture = drawn(Call('/arm', 'list_parameters', (), tuple(Line(f'p{number}') for number in range(9))))
    shown = list(picture.itertext())
    assert 'p2' in shown and 'p3' not in shown and '… and 6 more' in shown


def test_it_moves_call_after_call_and_is_still_when_asked_to():
    first, both = motion.Reel('one'), motion.Reel('two')
    assert '@keyframes' in Calls('me', [ANSWERED]).html(first)
    assert '@keyframes' in Calls('me', [ANSWERED] * 2).html(both)
    assert both.duration_sec > first.duration_sec
    assert '@keyframes' not in ElementTree.tostring(drawn(ANSWERED), encoding='unicode')


def test_before_the_first_call_it_is_empty():
    assert Calls('me').sentence == 'Nothing has been asked yet.'
    assert 'this notebook' in drawn().itertext()


def test_names_and_values_are_text():
    assert '<b>' in drawn(Call('/<b>', 'get_parameters', ('<i>',), (Line('<b>'),))).itertext()
