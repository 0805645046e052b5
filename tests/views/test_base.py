"""What all views of pictures of what was measured do: outlive the stage, play what is added, and close."""

import re

import pytest

import param_tutorial
from param_tutorial import views
from tests.support.widgets import texts
from tests.views.conftest import Weather

MEASURED = {
    'calls': views.CallsView,
    'checks': lambda: views.ChecksView('/weather', [('low_c', -6)]),
    'declarations': lambda: views.DeclarationsView(Weather),
    'ladder': lambda: views.LadderView('/weather', 'low_c', -6),
    'layers': lambda: views.LayersView('speed', [('default', 100)]),
    'lifts': lambda: views.LiftsView({'a': [(0, 0.0), (1, 1.0)]}),
    'message': lambda: views.MessageView('/weather', 'low_c', -6),
    'plane': lambda: views.PlaneView('/weather', {'low_c': (0, 10), 'high_c': (0, 10)}),
    'requests': lambda: views.RequestsView('speed'),
    'trail': lambda: views.TrailView('speed', ['wheel']),
    'worlds': lambda: views.WorldsView('speed')}


@pytest.mark.parametrize('make', MEASURED.values(), ids=MEASURED)
def test_a_picture_of_what_was_measured_outlives_the_stage(weather, make):
    view = make()
    param_tutorial.stop()
    assert re.search(r'<div class="motion">.*role="img" aria-label="[^"]', texts(view), re.DOTALL)
    assert 'prefers-reduced-motion' in texts(view)
    view.close()
    view.close()
    assert 'closed' in repr(view)


def test_what_is_added_is_played_and_a_closed_view_draws_no_more():
    view = views.WorldsView('speed')
    assert 'Play again' not in texts(view) and view.node == 'speed'
    view.add('ROS 2', {'/a': 9}, killed='/a', successor=1)
    played = texts(view)
    assert '@keyframes' in played and repr(view) == '<WorldsView: ROS 2: the new /a has 1.>'
    view.close()
    view.add('ROS 3', {'/a': 9}, killed='/a', successor=1)
    assert view._drawn.value in played
