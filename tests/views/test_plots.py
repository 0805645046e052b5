"""The line plot: its axes; how it looks and what it tells is approved in test_drawings."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from param_tutorial.views.drawing.plots import LinePlot, _scale

RAMP = [(0.0, 0.0), (2.0, 1.0)]


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
