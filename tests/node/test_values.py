"""values: the ten types, and what fits into them."""


import hypothesis.strategies as st
import pytest
from hypothesis import example, given
from rcl_interfaces.msg import ParameterValue
from rclpy.parameter import Parameter, get_parameter_value, parameter_value_to_python

from param_tools import values
from param_tools.errors import InvalidValueError
from param_tools.node.client import to_message
from tests.support.strategies import VALUES


@given(VALUES)
def test_a_value_survives_the_message_and_has_the_type_that_rclpy_gives_it(value):
    message = to_message('x', value).value
    assert values.same(values.to_python(message), value)
    assert message.type == Parameter('x', value=value).type_.value
    assert values.same(values.to_python(message), parameter_value_to_python(message))


# Where rclpy answers at all, the guess is the same; where it ends in a traceback, the text stays a text.
@given(st.text(st.characters(codec='ascii', exclude_characters='\0'), max_size=12))
@example('[true, 1]')
def test_a_word_on_the_command_line_is_read_as_ros2_does(text):
    try:
        theirs = values.to_python(get_parameter_value(text))
        values.type_of(theirs)  # a mapping, for example, is only found to be none when it is sent
    except Exception:
        return
    assert values.same(values.parse(text), theirs)


@pytest.mark.parametrize(('text', 'value'), [
    ('150', 150), ('off', False), ('y', 'y'), ('1e-3', '1e-3'), ('1.0e-3', 0.001), ('12:30', 750), ('010', 8),
    ('[1, 2.0]', '[1, 2.0]'), ('[true, 1]', [1, 1]), ('[1, off]', [1, 0]), ('[true, 1.0]', '[true, 1.0]'),
    ('[]', []), ("'42'", '42'), ('null', 'null'), ('', ''),
    ('2024-01-01', '2024-01-01'), ('2024-13-01', '2024-13-01'), ('a: b', 'a: b'), ('@x', '@x'), ('*a', '*a'),
])
def test_words_that_surprise(text, value):
    assert values.same(values.parse(text), value)


@pytest.mark.parametrize(('value', 'word'), [
    (2**63, '64 bits'), ([-2**63 - 1], '64 bits'), ('a\0b', 'NUL'), (['\0'], 'NUL'), ('\ud800', 'surrogate'),
    ({}, 'dict'), (1j, 'complex'), ([1, 2.0], 'one type'), ([1, True], 'one type'), ([None], 'NoneType'),
    (object, 'type'),
])
def test_what_no_parameter_can_hold_is_rejected_by_name(value, word):
    with pytest.raises(InvalidValueError, match=word):
        values.type_of(value)


def test_numpy_and_tuples_become_plain_python():
    numpy = pytest.importorskip('numpy')  # rclpy depends on it
    assert values.normalize(numpy.float32(0.5)) == 0.5
    assert values.type_of(values.normalize(numpy.int64(3))) is values.INTEGER
    assert values.normalize(numpy.array([1, 2])) == [1, 2]
    assert values.normalize((numpy.int64(1), 2)) == [1, 2]
    assert values.normalize(b'\x01\xff') == [b'\x01', b'\xff']


@given(st.sampled_from([[0.5] * 1000, ['on'] * 1000, ['w' * 300], 'x' * 5000, 'ab\n' * 99]), st.data())
def test_two_long_values_that_differ_look_different(value, data):
    index = data.draw(st.integers(0, len(value) - 1))
    other = {float: 0.6, str: 'y'}[type(value[index])]
    changed = value[:index] + ([other] if isinstance(value, list) else other) + value[index + 1:]
    before, after = values.format_change(value, changed, 60)
    assert before != after
    assert max(len(before), len(after)) < 150


def test_a_message_with_a_made_up_type_is_rejected():
    with pytest.raises(InvalidValueError, match='77'):
        values.to_python(ParameterValue(type=77))
