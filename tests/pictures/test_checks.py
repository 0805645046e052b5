"""The picture of the checks: which gate stops a request, and what was passed before."""

import re
from xml.etree import ElementTree

import pytest

from param_tutorial.pictures import motion
from param_tutorial.pictures.checks import Checks


@pytest.fixture
def checks():
    return Checks('/strict', [('serial', "'x'", 'read only'), ('speed', '45', 'off the step'),
                              ('speed', '70', 'accepted')])


def drawn(checks):
    return ElementTree.fromstring(checks.html(motion.Reel('one', is_still=True)))


def test_each_request_says_what_it_passed_and_what_stopped_it(checks):
    assert checks.text == (
        'Checks in their order: declared, read-only, type, range, step, on-set callbacks. '
        "serial = 'x' passes declared, and is stopped at read-only: read only. "
        'speed = 45 passes declared, read-only, type, range, and is stopped at step: off the step. '
        'speed = 70 passes all checks and is stored.')
    assert checks.sentence == '1 of 3 get through all checks.'


def test_ticks_and_crosses_tell_it_without_color(checks):
    classes = [part.get('class') for part in drawn(checks).iter()]
    assert classes.count('motion-check') == 1 + 4 + 6
    assert classes.count('motion-cross') == classes.count('motion-token-bad') == 2
    assert {'read only', 'off the step', 'accepted'} <= set(drawn(checks).itertext())


def test_it_moves_one_request_after_another_and_ends_as_it_is_drawn_at_rest(checks):
    reel = motion.Reel('one')
    moving, still = checks.html(reel), checks.html(motion.Reel('one', is_still=True))
    assert reel.moves and 'animation' not in still
    ends = [re.findall(r'style="(transform[^";]*)', picture) for picture in (moving, still)]
    assert len(ends[0]) == 3 and ends[0] == ends[1]


def test_a_long_name_makes_room_for_the_token():
    words = list(drawn(Checks('/a', [('max_speed_rpm', '900', 'accepted')])).itertext())
    assert 'max_speed_rpm' in words and 'max_speed_rpm = 900' not in words


@pytest.mark.parametrize(('requests', 'words'), [([], 'one request at least'),
                                                 ([('a', '1', 'too late')], "no check answers 'too late'")])
def test_what_cannot_be_drawn_is_rejected(requests, words):
    with pytest.raises(ValueError, match=words):
        Checks('/strict', requests)


def test_names_and_values_are_text():
    assert {'<b> = <i>', '<i>'} <= set(drawn(Checks('<a>', [('<b>', '<i>', 'accepted')])).itertext())
