"""Fixtures of the tests of widgets."""

import pytest
from ipywidgets.widgets.widget import _instances as widget_registry

from param_tools.panel.panel import ParameterPanel
from param_tools.panel.view import View
from param_tools.ros.waiting import wait_until
from tests.support.nodes import Arm
from tests.support.widgets import due_jobs


@pytest.fixture(autouse=True)
def _close_all():
    yield
    for widget in list(widget_registry.values()):
        if isinstance(widget, View):
            widget.close()
    wait_until(lambda: not due_jobs(), 'the threads of closed views to end')


@pytest.fixture
def arm(ros):
    """Return a panel of an Arm."""
    ros.add(Arm)
    panel = ParameterPanel('/arm')
    assert panel.status == ''
    return panel
