"""What all views of animated pictures do: record as a still, close, and let go of what they follow."""

import re

import pytest

import param_tutorial
from param_tutorial import ParameterClient
from param_tutorial.views import (
    CallsView,
    ChecksView,
    DeclarationsView,
    LadderView,
    LayersView,
    LiftsView,
    MessageView,
    NumberLineView,
    PlaneView,
    RequestsView,
    TrailView,
    WorldsView,
)
from tests.support.widgets import texts
from tests.views.conftest import Robot, Weather, wait_for_text

LIVE = {'ladder': LadderView, 'line': lambda node: NumberLineView(node, 'speed'), 'messages': lambda _: MessageView()}
MEASURED = {
    'calls': CallsView, 'requests': lambda: RequestsView('speed'), 'worlds': lambda: WorldsView('speed'),
    'layers': lambda: LayersView('speed', [('default', 100)]), 'trail': lambda: TrailView('speed', ['wheel']),
    'lifts': lambda: LiftsView({'a': [(0, 0.0), (1, 1.0)]}), 'declarations': lambda: DeclarationsView(Weather),
    'checks': lambda: ChecksView('/weather', [('low_c', -6)]),
    'plane': lambda: PlaneView('/weather', {'low_c': (0, 10), 'high_c': (0, 10)})}


@pytest.mark.parametrize('make', MEASURED.values(), ids=MEASURED)
def test_a_picture_of_what_was_measured_outlives_the_stage(weather, make):
    view = make()
    param_tutorial.stop()
    recorded = view.snapshot()
    assert recorded['kind'] == 'still' and recorded['text'] == repr(view)
    assert re.search(r'<div class="motion">.*role="img" aria-label="[^"]', recorded['html'], re.DOTALL)
    assert 'prefers-reduced-motion' in recorded['html']
    view.close()
    view.close()
    assert 'closed' in repr(view)


ADD = {
    'trail': (lambda: TrailView('speed', ['wheel']),
              lambda view: view.add('set', [100], ('', 'wheel'), note='it turns'),
              '<TrailView: set: it turns.>'),
    'worlds': (lambda: WorldsView('speed'), lambda view: view.add('ROS 2', {'/a': 9}, killed='/a', successor=1),
               '<WorldsView: ROS 2: the new /a has 1.>')}


@pytest.mark.parametrize(('make', 'add', 'shown'), ADD.values(), ids=ADD)
def test_what_is_added_is_played_and_a_closed_view_draws_no_more(make, add, shown):
    view = make()
    assert 'Play again' not in texts(view) and view.node == 'speed'
    add(view)
    played = texts(view)
    assert '@keyframes' in played and repr(view) == shown
    view.close()
    add(view)
    assert view._drawn.value in played


@pytest.mark.slow
@pytest.mark.parametrize('make', LIVE.values(), ids=LIVE)
def test_a_live_picture_is_recorded_lets_go_of_a_node_and_follows_the_next_stage(robot, client, make):
    view, other = make(robot), make(robot)
    client.set_parameter('speed', 5)
    wait_for_text(view, 'speed = 5')
    recorded = view.snapshot()
    assert recorded['kind'] == 'still' and recorded['text'] == repr(view)
    assert re.search(r'<div class="motion">.*aria-label="[^"]*speed = 5', recorded['html'], re.DOTALL)
    view.close()
    view.close()
    client.set_parameter('speed', 6)
    wait_for_text(other, 'speed = 6')
    assert 'speed = 6' not in view.text and 'closed' in repr(view)
    param_tutorial.stop()
    again = param_tutorial.start()
    again.add(Robot)
    ParameterClient('/robot').set_parameter('speed', 9)
    wait_for_text(other, '9')
