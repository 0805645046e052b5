"""What the moving pictures share: the last state is always there, and what moves ends in it."""

import re
from xml.etree import ElementTree

import pytest

from param_tutorial.pictures import motion


def looks(style):
    """Return the resting state of a style attribute, and the name of its animation; None if it has none."""
    rest, _, animation = re.fullmatch(r' style="(.*?)(;animation:(.*))?"', style).groups()
    return rest, animation and animation.split()[0]


def test_a_track_rests_in_its_last_state_and_its_keyframes_end_there():
    reel = motion.Reel('one')
    rest, animation = looks(reel.travel([(0, 1, 2), (1, 3, 4), (2, 5, 6)]))
    assert (rest, animation) == ('transform:translate(5.0px,6.0px)', 'one-1')
    keyframes = re.search(r'@keyframes one-1 \{(.*)\}', reel.style())[1]
    assert re.findall(r'([\d.]+)% \{transform:translate\((.*?)\)', keyframes) == [
        ('0.00', '1.0px,2.0px'), ('50.00', '3.0px,4.0px'), ('100.00', '5.0px,6.0px')]
    assert reel.duration_sec == 2


def test_a_still_reel_has_the_same_rest_and_nothing_that_moves():
    for make in (lambda reel: reel.appear(1.0), lambda reel: reel.shown(1.0, 2.0),
                 lambda reel: reel.travel_and_go([(0, 0, 0), (1, 9, 9)])):
        moving, still = motion.Reel('one'), motion.Reel('one', is_still=True)
        assert looks(make(still)) == (looks(make(moving))[0], None)
        assert moving.moves and not still.moves and still.style() == ''


@pytest.mark.parametrize(('from_sec', 'to_sec', 'rest'), [(0, None, '1'), (1, None, '1'), (0, 1, '0'), (1, 2, '0')])
def test_what_is_shown_for_a_while_is_gone_at_the_end(from_sec, to_sec, rest):
    assert looks(motion.Reel('one').shown(from_sec, to_sec))[0] == f'opacity:{rest}'


def test_what_never_changes_is_not_animated():
    reel = motion.Reel('one')
    assert looks(reel.track([(0, 'opacity:1'), (1, 'opacity:1')])) == ('opacity:1', None)
    assert not reel.moves


def test_only_what_moves_can_be_played_again():
    moving = motion.Reel('one')
    parts = [motion.group('', moving.appear(1))]
    assert 'Play again' in motion.stage('a', 'b', 'c', (10, 10), parts, moving)
    assert 'Play again' not in motion.stage('a', 'b', 'c', (10, 10), [], motion.Reel('one'))


def test_names_are_text():
    parts = [motion.label(0, 0, '<b>&'), motion.group(motion.token('<i>'))]
    picture = motion.stage('<node>', '<words>', '"text"', (10, 10), parts, motion.Reel('one'))
    drawn = ElementTree.fromstring(picture)
    assert {'<b>&', '<i>', '<node>', '<words>'} <= set(drawn.itertext())
    assert drawn.find('.//*[@role="img"]').get('aria-label') == '"text"'


def test_the_style_sheet_stops_everything_for_whoever_wants_no_motion():
    rule = motion.STYLE[motion.STYLE.index('prefers-reduced-motion'):]
    assert re.match(r'prefers-reduced-motion: reduce\) \{ \.motion \* \{ animation: none !important; \}', rule)


def test_every_color_follows_the_theme():
    assert not re.search(r'(?<!, )#[0-9a-f]{3,6}\b', motion.STYLE)
