"""The unit of a parameter: known if its texts or its name give one, and none if they leave doubt."""

import pytest

from param_tools import values
from param_tools.descriptor import Descriptor
from param_tools.node.units import unit_of


def unit(name='x', text='', constraints='', kind=values.DOUBLE):
    return unit_of(Descriptor(name, kind, text, constraints, False, False, None))


@pytest.mark.parametrize(('text', 'expected'), [
    ('Top speed, in m/s', 'm/s'), ('Top speed in m/s.', 'm/s'), ('Top speed [m/s]', 'm/s'), ('Its (rpm)', 'rpm'),
    ('Acceleration [m/s^2]', 'm/s²'), ('How long it waits, in seconds, before it ends', 's'),
    ('Timeout in seconds before it ends', 's'), ('Temperature in degrees Celsius', '°C'), ('Angle in degrees', 'deg'),
    ('Rate (in Hz)', 'Hz'), ('Share, in percent', '%'), ('Distance in meters', 'm'),
])
def test_a_text_says_it(text, expected):
    assert unit(text=text) == expected
    assert unit(constraints=text) == expected


@pytest.mark.parametrize('text', [
    '', 'Used in A* search', 'Which one of [a, b]', 'One of (s, t)', 'Which joint(s)', 'Plan B in a hall',
    'Cost in seconds per meter', 'In which meters', 'Speed [m/s] or [rpm]', 'A value in bar charts',
    'in metersomething',
])
def test_a_text_that_does_not_say_one_surely_says_none(text):
    assert unit(text=text) == ''


@pytest.mark.parametrize(('name', 'expected'), [
    ('max_acceleration_mps2', 'm/s²'), ('arm.speed_mps', 'm/s'), ('max_speed_rpm', 'rpm'), ('rate_hz', 'Hz'),
    ('timeout_sec', 's'), ('width_meters', 'm'), ('max_temperature_c', '°C'),
    ('gain_c', ''), ('delay_ms', ''), ('m', ''), ('hz', ''), ('rpm_max', ''),
])
def test_a_name_says_it(name, expected):
    assert unit(name) == expected


def test_the_text_comes_before_the_name_and_only_numbers_have_one():
    assert unit('rate_hz', 'Rate (rpm)') == 'rpm'
    assert unit('rate_hz', kind=values.INTEGER_ARRAY) == 'Hz'
    assert unit('rate_hz', 'in Hz', kind=values.STRING) == ''
    assert unit('rate_hz', 'in Hz', kind=values.BOOL) == ''
