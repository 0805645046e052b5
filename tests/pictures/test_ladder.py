"""The ladder: how far a value gets, with whose words, and what lies where at the end. No node is needed."""

from xml.etree import ElementTree

import pytest

from param_tutorial.pictures import motion
from param_tutorial.pictures.diagrams import Step
from param_tutorial.pictures.ladder import Climb

ASKED = Step('asked', '', '100', proposed='900')
PRE = Step('pre-set', '', '100', who='trim', proposed='300')
JUDGE = Step('on-set', '', '100', who='judge', proposed='300')
ACCEPTED = [ASKED, PRE, JUDGE, Step('stored', '', '300'), Step('event', '', '300'),
            Step('post-set', '', '300', who='act', proposed='300'), Step('answer', '', '300')]
REJECTED = [ASKED, PRE, Step('on-set', '', '100', who='judge', proposed='300', objection='too fast'),
            Step('answer', '', '100', objection='too fast')]
OUT_OF_RANGE = [ASKED, Step('answer', '', '100', objection='out of range')]
RAISED = [ASKED, Step('pre-set', '', '100', who='trim', objection='raises TypeError'), Step('no answer', '', '100')]
RAISED_LATE = [*ACCEPTED[:5], Step('post-set', '', '300', who='act', proposed='300', objection='raises ValueError'),
               Step('no answer', '', '300')]


def climb(steps, objection=''):
    return Climb('/robot', 'speed', steps, objection)


def drawn(steps, objection='', *, is_still=True):
    picture = climb(steps, objection).html(motion.Reel('one', is_still=is_still))
    return ElementTree.fromstring(picture)


def texts(picture):
    return [text for text in picture.itertext() if text.strip()]


def bounces(picture):
    """True if the value lies on the ground, rejected, at the end."""
    return [tag.get('class') for tag in picture.iter('rect')].count('motion-token-bad') == 1


def test_an_accepted_value_climbs_all_rungs_and_may_change_on_the_way():
    assert climb(ACCEPTED).text == (
        'The ladder of /robot. speed = 900 is accepted, and 300 is stored. '
        '1, request: set speed to 900; stored is 100. 2, pre-set callbacks: trim gives 300; stored is 100. '
        "3, rclpy's own checks: declared, not locked, type, range, step; stored is 100. "
        '4, on-set callbacks: judge accepts; stored is 100. 5, stored: 300 is written; stored is 300. '
        '6, /parameter_events: a message tells everybody; stored is 300. '
        '7, post-set callbacks: act acts on 300; stored is 300. 8, answer: successful; stored is 300.')
    assert not bounces(drawn(ACCEPTED))


@pytest.mark.parametrize(('steps', 'rung', 'words'), [
    (REJECTED, 'on-set callbacks', 'judge rejects: too fast'),
    (OUT_OF_RANGE, "rclpy's own checks", 'out of range'),
])
def test_a_rejected_value_falls_from_the_rung_that_rejects_it(steps, rung, words):
    picture = drawn(steps, steps[-1].objection)
    assert climb(steps, steps[-1].objection).sentence == f'speed = 900 is rejected at {rung}.'
    assert words in texts(picture) and bounces(picture)
    assert climb(steps, steps[-1].objection).text.endswith(f'{rung}: {words}; stored is 100.')


def test_the_picture_says_when_no_node_answers():
    early, late = climb(RAISED, 'TypeError: no'), climb(RAISED_LATE, 'ValueError: no')
    assert early.sentence == 'speed = 900: an exception at pre-set callbacks, and the caller gets no answer.'
    assert bounces(drawn(RAISED, 'TypeError: no'))
    # It is stored by then, so it does not fall.
    assert 'post-set callbacks: act raises ValueError; stored is 300' in late.text
    assert not bounces(drawn(RAISED_LATE, 'ValueError: no'))


def test_a_rung_without_callbacks_is_passed_by():
    assert '2, pre-set callbacks: there is none' in climb([ASKED, JUDGE, *ACCEPTED[3:]]).text


def test_an_accepted_climb_takes_longer_than_one_that_ends_at_the_checks():
    durations = []
    for steps, objection in ((ACCEPTED, ''), (OUT_OF_RANGE, 'out of range')):
        reel = motion.Reel('one')
        climb(steps, objection).html(reel)
        durations.append(reel.duration_sec)
    assert durations[0] > durations[1] > 0


def test_outcomes_differ_without_color():
    # A check mark is open, and a cross is crossed; the token on the ground is dashed by its class.
    ways = [{path.get('class') for path in drawn(steps, objection).iter('path')} for steps, objection in (
        (ACCEPTED, ''), (REJECTED, 'too fast'))]
    assert 'motion-cross' not in ways[0] and 'motion-cross' in ways[1]


def test_long_words_are_wrapped_and_cut():
    steps = [*OUT_OF_RANGE[:1], Step('answer', '', '100', objection='because ' * 30)]
    assert max(map(len, texts(drawn(steps, 'because ' * 30)))) < 60


def test_a_climb_of_nothing_is_rejected():
    with pytest.raises(ValueError, match='one step'):
        climb([])
