"""Values of every type that a ROS parameter can hold, for property tests."""

import hypothesis.strategies as st

from param_tools import values

INT64 = st.integers(values.INT64_MIN, values.INT64_MAX)
TEXT = st.text(st.characters(exclude_categories=['Cs'], exclude_characters='\0'))
VALUES = st.one_of(
    st.booleans(), INT64, st.floats(), TEXT,
    *(st.lists(each, min_size=1) for each in (
        st.booleans(), INT64, st.floats(), TEXT, st.binary(min_size=1, max_size=1))),
)
