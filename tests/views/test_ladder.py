"""The ladder: how far a value gets, with whose words, and what lies where at the end."""

import re

import pytest

from param_tools.errors import NodeNotFoundError
from param_tutorial.views import LadderView
from param_tutorial.views.drawing.ladder import Climb
from param_tutorial.views.drawing.svg import Animation
from param_tutorial.views.drawing.timeline import Step
from tests.support.drawings import kinds, rests, words
from tests.support.widgets import texts

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


def is_bad(picture):
    """True if the value is drawn as rejected at the end."""
    return kinds(picture).count('token-bad') == 1


def height(picture):
    """Return how far down the value stands at the end."""
    place = rests(picture.html(Animation('one', is_still=True)))[0]
    return float(re.search(r',([\d.]+)px\)', place)[1])


def test_an_accepted_value_climbs_down_all_rungs_and_may_change_on_the_way():
    assert climb(ACCEPTED).text == (
        'The ladder of /robot. speed = 900 is accepted, and 300 is stored. '
        '1, request: set speed to 900; stored is 100. 2, pre-set callbacks: trim gives 300; stored is 100. '
        "3, rclpy's own checks: declared, not locked, type, range, step; stored is 100. "
        '4, on-set callbacks: judge accepts; stored is 100. 5, stored: 300 is written; stored is 300. '
        '6, /parameter_events: a message tells everybody; stored is 300. '
        '7, post-set callbacks: act acts on 300; stored is 300. 8, answer: successful; stored is 300.')
    assert not is_bad(climb(ACCEPTED)) and 'cross' not in kinds(climb(ACCEPTED))


@pytest.mark.parametrize(('steps', 'rung', 'reason'), [
    (REJECTED, 'on-set callbacks', 'judge rejects: too fast'),
    (OUT_OF_RANGE, "rclpy's own checks", 'out of range'),
])
def test_a_rejected_value_returns_from_the_rung_that_rejects_it(steps, rung, reason):
    picture = climb(steps, steps[-1].objection)
    assert picture.sentence == f'speed = 900 is rejected at {rung}.'
    assert picture.text.endswith(f'{rung}: {reason}; stored is 100.')
    assert reason in words(picture) and is_bad(picture) and 'cross' in kinds(picture)


def test_time_runs_from_top_to_bottom_and_a_rejected_value_goes_back_to_the_top():
    accepted, rejected, raised = climb(ACCEPTED), climb(REJECTED, 'too fast'), climb(RAISED, 'TypeError: no')
    # Nothing comes back to the caller from an exception.
    assert height(rejected) < height(raised) < height(accepted)


def test_the_picture_says_when_no_node_answers():
    early, late = climb(RAISED, 'TypeError: no'), climb(RAISED_LATE, 'ValueError: no')
    assert early.sentence == 'speed = 900: an exception at pre-set callbacks, and the caller gets no answer.'
    assert is_bad(early)
    # It is stored by then.
    assert 'post-set callbacks: act raises ValueError; stored is 300' in late.text
    assert not is_bad(late)


def test_a_rung_without_callbacks_is_passed_by():
    assert '2, pre-set callbacks: there is none' in climb([ASKED, JUDGE, *ACCEPTED[3:]]).text


def test_long_words_are_wrapped_and_cut():
    steps = [*OUT_OF_RANGE[:1], Step('answer', '', '100', objection='because ' * 30)]
    assert all(len(text) < 60 for text in words(climb(steps, 'because ' * 30)) if 'rejected' not in text)


# -- the view ------------------------------------------------------------------------------------------------

def test_a_value_climbs_down_the_ladder_or_returns_from_it(robot):
    accepted, rejected = LadderView(robot, 'speed', 900), LadderView('/robot', 'speed', -5)
    assert [repr(view) for view in (accepted, rejected)] == [
        '<LadderView: speed = 900 is accepted, and 300 is stored.>',
        '<LadderView: speed = -5 is rejected at on-set callbacks.>']
    assert 'trim gives 300' in texts(accepted) and '@keyframes' in texts(accepted)
    assert 'judge rejects: minus five; stored is 300' in rejected.text and rejected.node == '/robot'
    assert 'an exception at pre-set callbacks, and the caller gets no answer' in LadderView(robot, 'speed', 'fast').text
    with pytest.raises(NodeNotFoundError, match='/nobody'):
        LadderView('nobody', 'speed', 1)


def test_another_value_is_typed_below_the_ladder(ros, robot):
    view = LadderView(robot, 'speed', 900)
    *_, below = view.children

    def ask(text):
        below._handle_custom_msg({'chosen': text}, [])
        return view.text

    assert (below.name, below.text) == ('speed', '900')
    assert 'judge rejects: minus five; stored is 300' in ask('-5')
    # With the type that `ros2 param set` would give it.
    before = ask('fast')
    assert 'an exception at pre-set callbacks' in before and below.said == ''
    ros.remove(robot)
    assert ask('7') == before
    assert '/robot' in below.said
