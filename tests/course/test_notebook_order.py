"""notebooks/conftest.py: the cells of a lesson stay in order, whatever shuffles the tests."""

import importlib.util
from types import SimpleNamespace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.paths import NOTEBOOKS

CONFTEST = NOTEBOOKS / 'conftest.py'


def load():
    spec = importlib.util.spec_from_file_location('notebooks_conftest', CONFTEST)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


CELLS = [SimpleNamespace(parent=notebook, cell_num=number) for notebook in ('03', '04') for number in range(12)]
TESTS = [SimpleNamespace(parent='tests', name=name) for name in 'ab']


@pytest.mark.slow
@given(st.permutations(CELLS + TESTS))
def test_each_notebook_is_whole_and_in_order(shuffled):
    items = list(shuffled)
    load().pytest_collection_modifyitems(items)
    assert sorted(map(id, items)) == sorted(map(id, shuffled))
    for notebook in ('03', '04'):
        places = [place for place, item in enumerate(items) if item.parent == notebook]
        assert places == list(range(places[0], places[0] + 12))
        assert [items[place].cell_num for place in places] == list(range(12))
