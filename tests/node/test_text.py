"""Values as people type them: a formatted value is parsed back as the same value."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from param_tools import values
from param_tools.descriptor import Descriptor
from param_tools.node import text as typed
from tests.support.strategies import INT64, TEXT

_WRITTEN = {
    values.INTEGER: INT64,
    values.DOUBLE: st.floats(),
    values.STRING: TEXT,
    values.BYTE_ARRAY: st.lists(st.binary(min_size=1, max_size=1)),
    values.BOOL_ARRAY: st.lists(st.booleans()),
    values.INTEGER_ARRAY: st.lists(INT64),
    values.DOUBLE_ARRAY: st.lists(st.floats()),
    values.STRING_ARRAY: st.lists(TEXT),
}


@pytest.mark.parametrize('parameter_type', _WRITTEN, ids=repr)
@given(data=st.data())
def test_what_a_text_box_shows_is_read_back_the_same(parameter_type, data):
    value = data.draw(_WRITTEN[parameter_type])
    form = typed.form_of(Descriptor('x', parameter_type, '', '', False, False, None))
    text = form.format(value)
    assert parameter_type is values.STRING or '\n' not in text
    assert text.replace('\n', '').isprintable()
    assert values.same(form.parse(text), value)


@given(st.one_of(TEXT, st.booleans(), *(strategy for kind, strategy in _WRITTEN.items()
                                          if kind is not values.BYTE_ARRAY)))
def test_so_is_a_value_whose_type_may_be_any(value):
    form = typed.form_of(Descriptor('x', values.STRING, '', '', False, True, None))
    text = form.format(value)
    assert '\n' not in text
    assert values.same(form.parse(text), value)


def described(parameter_type, *, dynamic=False):
    return Descriptor('x', parameter_type, '', '', False, dynamic, None)


@pytest.mark.parametrize('text', ['1e400', '-1e309', '9' * 400, '1_0e400'])
def test_a_number_beyond_the_largest_double_is_asked_about(text):
    with pytest.raises(ValueError, match=r'beyond the largest double.*do you mean inf\? Then type that'):
        typed.parse_value(described(values.DOUBLE), text)
    with pytest.raises(ValueError, match='do you mean inf'):
        typed.parse_value(described(values.DOUBLE_ARRAY), f'[inf, 1.0, {text}]')


def test_a_value_of_any_type_that_yaml_makes_infinity_of_is_asked_about():
    for text in ('1.0e+400', '[1.0, -1.0e+400]'):
        with pytest.raises(ValueError, match='do you mean inf'):
            typed.parse_value(described(values.DOUBLE, dynamic=True), text)


@pytest.mark.parametrize(('text', 'value'), [
    ('inf', float('inf')), ('-Infinity', -float('inf')), ('1.7976931348623157e308', 1.7976931348623157e308)])
def test_infinity_that_is_meant_and_the_largest_double_are_read(text, value):
    assert typed.parse_value(described(values.DOUBLE), text) == value
    assert typed.parse_value(described(values.DOUBLE_ARRAY), f'{text}, inf') == [value, float('inf')]
