"""Fixtures of the tests of widgets."""

import pytest
from ipywidgets.widgets.widget import _instances as widget_registry

from param_tutorial.runtime.waiting import wait_until
from param_tutorial.widgets.panel import ParameterPanel
from param_tutorial.widgets.view import View
from tests.support.nodes import Arm
from tests.support.widgets import worker_threads


@pytest.fixture(autouse=True)
def _close_all():
    yield
    for widget in list(widget_registry.values()):
        if isinstance(widget, View):
            widget.close()
    wait_until(lambda: not worker_threads(), 'the threads of closed views to end')


@pytest.fixture
def arm(ros):
    """Return a panel of an Arm."""
    ros.add(Arm)
    panel = ParameterPanel('/arm')
    assert panel.status == ''
    return panel
