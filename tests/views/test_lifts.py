"""Lifts beside each other: where they are, how fast they go, and how far apart they end."""

import re

import pytest

from param_tutorial.views.drawing.lifts import Lifts
from param_tutorial.views.drawing.svg import Animation
from tests.support.drawings import words

BEFORE, AFTER = [(0, 0.0), (1, 0.2), (2, 0.7)], [(0, 0.0), (1, 0.2), (2, 0.4)]


def test_the_picture_in_words():
    lifts = Lifts({'before': BEFORE, 'after': AFTER}, {1: 'rejected'})
    assert lifts.sentence == 'After 2 s: before at 0.70 m, after at 0.40 m.'
    assert 'before rises: 0.00 m at 0 s, 0.20 m at 1 s, 0.70 m at 2 s.' in lifts.text
    assert 'At 1 s: rejected.' in lifts.text


def test_lifts_tell_their_speeds_their_heights_and_their_difference():
    assert {'0.70 m', '0.40 m', '0.30 m', '0.2 m/s', '0.5 m/s'} <= set(words(Lifts({'before': BEFORE, 'after': AFTER})))


def test_lifts_at_one_height_have_no_difference():
    assert '0.00 m' not in words(Lifts({'a': BEFORE, 'b': BEFORE}))


def test_a_lift_goes_by_its_points_evenly():
    animation = Animation('one')
    Lifts({'a': BEFORE}).html(animation)
    cabin = next(frames for frames in re.findall(r'@keyframes [\w-]+ \{(.*?\})\}', animation.keyframes())
                 if len(set(re.findall(r'px,([\d.]+)px', frames))) == 3)
    times, places = zip(*((float(at), float(y)) for at, y in re.findall(r'([\d.]+)% \{\S+px,([\d.]+)px', cabin)),
                        strict=True)
    assert 'linear' in cabin
    # The second way takes as long, and is two and a half times as far.
    assert (times[3] - times[2]) == pytest.approx(times[2] - times[1], abs=.02)
    assert (places[2] - places[3]) / (places[1] - places[2]) == pytest.approx(2.5, rel=.02)
