"""What animated pictures share: the last state is always there, what moves ends in it, and what is named is text."""

import re

import pytest

from param_tutorial.views.drawing import svg
from param_tutorial.views.drawing.calls import Call, Calls, Line
from param_tutorial.views.drawing.checks import Checks
from param_tutorial.views.drawing.ladder import Climb
from param_tutorial.views.drawing.layers import Layers
from param_tutorial.views.drawing.lifts import Lifts
from param_tutorial.views.drawing.messages import Listener, MessageTraffic
from param_tutorial.views.drawing.number_line import NumberLine, Request, Scale
from param_tutorial.views.drawing.plane import Plane
from param_tutorial.views.drawing.requests import Request as Sent
from param_tutorial.views.drawing.requests import Requests
from param_tutorial.views.drawing.timeline import Step
from param_tutorial.views.drawing.trail import Trail
from param_tutorial.views.drawing.worlds import Worlds
from tests.support.drawings import drawn, kinds, rests, words

# What every picture is given as a name, as a value and as words.
EVIL = '<b>"&'


def make_plane():
    plane = Plane((EVIL, EVIL), {(low, high): low < high for low in (0, 1) for high in (0, 1)})
    plane.add_way('one', (0, 1), [(EVIL, (1, 0), (0, 1)), (EVIL, (0, 0), (0, 0))])
    plane.add_way(EVIL, (0, 1), [(EVIL, (1, 1), (1, 1))])
    return plane


def make_requests():
    requests = Requests('gain')
    requests.add(EVIL, EVIL, {'gain': '1'}, [Sent('gain', EVIL, EVIL), Sent('gain', '2', '2')], server=EVIL)
    requests.add(EVIL, EVIL, {EVIL: '1'}, [Sent(EVIL, EVIL, '1', EVIL), Sent('gain', '2', '2')], is_one=True)
    requests.conclude(EVIL)
    return requests


def make_trail():
    trail = Trail(EVIL, [EVIL, 'b', 'c'])
    trail.add(EVIL, [EVIL, ..., ...], ('', EVIL), note=EVIL)
    trail.add('far', [EVIL, 'b', 'c'], (EVIL, 'c'), ('', 'b'))
    trail.add('back', [EVIL, ..., ...], ('c', EVIL, EVIL, EVIL))
    return trail


def make_worlds():
    worlds = Worlds(EVIL)
    worlds.add(EVIL, {'/a': EVIL}, killed='/a', successor=EVIL, server=EVIL)
    worlds.add(EVIL, {'/a': EVIL, EVIL: 1}, killed=EVIL, successor=EVIL)
    return worlds


STEPS = [Step('asked', '', '1', proposed=EVIL), Step('on-set', '', EVIL, who=EVIL, proposed='2', objection=EVIL),
         Step('answer', '', '1')]
PICTURES = {
    'calls': Calls(EVIL, [Call(EVIL, EVIL, (EVIL,), (Line(EVIL, True), Line(EVIL, False))),
                          Call(EVIL, EVIL, (), problem=EVIL), Call(EVIL, EVIL, (), problem=EVIL, is_delivered=False)]),
    'checks': Checks(EVIL, [(EVIL, EVIL, 'accepted'), ('speed', '1', 'out of range')]),
    'ladder': Climb(EVIL, EVIL, STEPS, EVIL),
    'layers': Layers(EVIL, [(EVIL, 1), (EVIL, EVIL, 2), ('-p', EVIL, 3)]),
    'lifts': Lifts({EVIL: [(0, 0.0), (1, 1.0)], 'b': [(0, 0.0), (1, .5)]}, {0.5: EVIL}),
    'messages': MessageTraffic([EVIL], {EVIL: Listener(EVIL), '/deaf': Listener('', EVIL)}, EVIL, [EVIL], offers=EVIL),
    'number line': NumberLine(EVIL, EVIL, Scale(0, 85, 10), 40, request=Request(45, EVIL, EVIL), is_locked=True),
    'plane': make_plane(), 'requests': make_requests(), 'trail': make_trail(), 'worlds': make_worlds()}


@pytest.fixture(params=PICTURES.values(), ids=PICTURES)
def picture(request):
    return request.param


def test_it_moves_and_ends_as_it_is_drawn_at_rest(picture):
    animation = svg.Animation('one')
    moving, still = picture.html(animation), picture.html(svg.Animation('one', is_still=True))
    assert animation.moves and 'Play again' in moving and '@keyframes one-1 ' in moving
    assert 'animation:' not in still and 'Play again' not in still
    assert rests(moving) == rests(still)


def test_names_and_values_are_text(picture):
    assert any(EVIL in text for text in words(picture)) and 'b' not in {part.tag for part in drawn(picture).iter()}
    assert drawn(picture).find('.//*[@role="img"]').get('aria-label') == picture.text
    assert picture.sentence in words(picture)


def test_each_part_has_a_style_in_the_sheet(picture):
    assert {kind for each in kinds(picture) for kind in each.split()} - {'lock', 'words'} <= {
        *re.findall(r'\.motion-([\w-]+)', svg.STYLE), 'motion'}


# -- the animation -------------------------------------------------------------------------------------------

def parts_of(style):
    """Return the resting state of a style attribute, and the name of its animation; None if it has none."""
    rest, _, animation = re.fullmatch(r' style="(.*?)(;animation:(.*))?"', style).groups()
    return rest, animation and animation.split()[0]


def test_what_travels_waits_at_its_first_stop_and_rests_at_its_last():
    animation = svg.Animation('one')
    assert parts_of(animation.travel([(1, 1, 2), (2, 5, 6)])) == ('transform:translate(5.0px,6.0px)', 'one-1')
    keyframes = re.search(r'@keyframes one-1 \{(.*)\}', animation.keyframes())[1]
    assert re.findall(r'([\d.]+)% \{transform:translate\((.*?)\)', keyframes) == [
        ('0.00', '1.0px,2.0px'), ('50.00', '1.0px,2.0px'), ('100.00', '5.0px,6.0px')]
    assert animation.duration_sec == 2


def test_what_comes_and_goes_is_seen_in_between_only():
    animation = svg.Animation('one')
    rest, _ = parts_of(animation.travel([(2, 0, 0), (3, 9, 9)], from_sec=1, goes=True))
    assert rest == 'opacity:0;transform:translate(9.0px,9.0px)'
    assert re.findall(r'opacity:(\d);transform:translate\((\d)', animation.keyframes()) == [
        ('0', '0'), ('0', '0'), ('1', '0'), ('1', '0'), ('1', '9'), ('0', '9')]


@pytest.mark.parametrize(('from_sec', 'to_sec', 'rest'), [(0, None, '1'), (1, None, '1'), (0, 1, '0'), (1, 2, '0')])
def test_what_is_shown_for_a_while_is_gone_at_the_end(from_sec, to_sec, rest):
    assert parts_of(svg.Animation('one').shown(from_sec, to_sec))[0] == f'opacity:{rest}'


def test_what_never_changes_is_not_animated():
    animation = svg.Animation('one')
    assert parts_of(animation.track([(0, 'opacity:1'), (1, 'opacity:1')])) == ('opacity:1', None)
    assert not animation.moves


# -- the style sheet -----------------------------------------------------------------------------------------

def test_the_style_sheet_stops_everything_for_a_reader_who_wants_no_motion():
    rule = svg.STYLE[svg.STYLE.index('prefers-reduced-motion'):]
    assert re.match(r'prefers-reduced-motion: reduce\) \{ \.motion \* \{ animation: none !important; \}', rule)


def test_every_color_follows_the_theme():
    assert not re.search(r'(?<!, )#[0-9a-f]{3,6}\b', svg.STYLE)


def test_a_text_is_cut_where_it_is_too_long():
    assert (svg.cut('abcd', 4), svg.cut('abcde', 4)) == ('abcd', 'abc…')
    assert svg.in_two_lines('one two three four five', 8) == ['one two', 'three f…']
    assert svg.in_two_lines('', 8) == ['']
