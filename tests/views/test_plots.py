"""The line plot: its words, axes and lines, and that what is named in it stays text."""

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from param_tutorial.views.drawing.plots import Band, LinePlot, _scale
from tests.support.drawings import labels, parsed

RAMP = [(0.0, 0.0), (2.0, 1.0)]


def test_it_tells_in_words_what_it_draws():
    plot = LinePlot({'before': RAMP, 'after': [(0, 0), (1, 1)]}, x='time in s', y='speed in m/s', marks={1: 'changed'})
    words = ('speed in m/s over time in s. before: 0.00 at 0.00, 1.00 at 2.00. after: 0.00 at 0.00, 1.00 at 1.00. '
             'changed at 1')
    assert repr(plot) == f'<LinePlot: {words}>'
    assert f'<svg role="img" aria-label="{words}"' in plot._repr_html_()


def test_its_lines_go_through_its_points():
    picture = parsed(LinePlot({'ramp': RAMP}, x='x', y='y'))
    corners = picture.find('polyline').get('points')
    assert corners == '44.0,180.0 408.0,40.0'


def test_lines_differ_without_color():
    strokes = re.findall(r'<polyline[^>]*?(stroke-dasharray="[^"]*")?/>',
                         LinePlot({name: RAMP for name in 'abcd'}, x='x', y='y')._repr_html_())
    assert len(set(strokes)) == 4


@pytest.mark.parametrize(('names', 'rows'), [
    (('ramp', 'p'), [['ramp', 'p']]), (('reference', 'p', 'conditional_integration'), [
        [], ['reference', 'p'], ['conditional_integration']])])
def test_each_name_in_the_key_keeps_to_its_own_stroke(names, rows):
    picture = parsed(LinePlot(dict.fromkeys(names, RAMP), x='x', y='speed in m/s'))
    strokes = {(float(line.get('x2')), float(line.get('y1'))): float(line.get('x1')) for line in picture.iter('line')}
    found = [[] for _ in rows]
    ends = [8.0 * len('speed in m/s'), *[0.0] * len(rows)]
    for text in picture.iter('text'):
        if text.text in names and text.get('text-anchor') == 'start':
            x, y = float(text.get('x')), float(text.get('y'))
            found[int(y - 16) // 18].append((x, text.text))
    for row, places in enumerate(found):
        for x, name in sorted(places):
            # The widest letters are not wider than 8 on average.
            assert strokes[x - 8, 12.0 + 18 * row] >= ends[row]
            ends[row] = x + 8 * len(name)
            assert ends[row] <= 420
    assert [[name for _, name in sorted(places)] for places in found] == rows


def test_names_are_text():
    assert {'<b>"', 'a & b', '<i>'} <= set(labels(LinePlot({'<b>"': RAMP}, x='a & b', y='<i>')))


@given(st.floats(1e-6, 1e9))
def test_an_axis_holds_its_largest_value_in_a_few_round_steps(largest):
    step, end = _scale(largest)
    assert largest <= end * (1 + 1e-6) <= largest + step * (1 + 1e-6)
    assert 2 <= round(end / step) <= 7
    assert f'{step:.0e}'[0] in '125'


@pytest.mark.parametrize('lines', [{}, {'empty': []}, {name: RAMP for name in 'abcde'}])
def test_it_says_what_it_takes(lines):
    with pytest.raises(ValueError, match='one to 4 lines'):
        LinePlot(lines, x='x', y='y')


def test_a_band_and_the_previous_line_are_drawn_and_described():
    plain = LinePlot({'speed': [(0, 0.0), (1, 10.0)]}, x='s', y='rad/s')
    plot = LinePlot({'speed': [(0, 0.0), (1, 10.0)]}, x='s', y='rad/s', before=[(0, 0.0), (1, 5.0)],
                    band=Band(0.4, 9.7, 10.3))
    assert plot.text == f'{plain.text}. target: 9.7 to 10.3 from 0.4 on'
    picture = plot._repr_html_()
    assert '>target<' in picture and '>before<' in picture and picture.count('<polyline') == 2
    assert plain._repr_html_().count('<polyline') == 1 and '>before<' not in plain._repr_html_()
