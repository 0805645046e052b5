"""The robot on its track: what the picture says of a moment, and how its view follows the base."""

import pytest

from param_tools.errors import NodeNotFoundError
from param_tutorial import ParameterClient
from param_tutorial.nodes.base_node import BaseNode
from param_tutorial.views import TrackView
from param_tutorial.views.drawing.track import Moment, draw_track
from tests.nodes.test_base import Resting, drive
from tests.support.widgets import press
from tests.views.conftest import shows


@pytest.mark.parametrize(('position', 'speed', 'command', 'word'), [
    (0.0, 0.0, 0.0, 'READY'), (0.0, 0.0, -0.5, 'READY'), (0.0, 0.0, 0.5, 'SPEEDING UP'), (3.0, 0.2, 0.5, 'SPEEDING UP'),
    (3.0, 0.5, 0.5, 'DRIVING'), (3.0, 0.5, 0.2, 'SLOWING DOWN'), (3.0, 0.5, -0.5, 'SLOWING DOWN'),
    (3.0, -0.2, -0.5, 'SPEEDING UP'), (3.0, -0.5, -0.5, 'BACKING UP'), (3.0, -0.5, 0.0, 'SLOWING DOWN'),
    (3.0, 0.0, 0.0, 'STOPPED'), (3.0, -0.001, 0.001, 'STOPPED')])
def test_a_moment_has_a_word_and_numbers_without_a_negative_zero(position, speed, command, word):
    moment = Moment('/base', 4.0, position, speed, command)
    assert moment.word == word
    assert '-0.00' not in moment.text
    assert all(words in draw_track(moment) for words in (word, *moment.says.values()))


@pytest.mark.parametrize('wall_m', [1.0, 2.5, 10.0, 11.0, 50.0])
def test_a_track_has_a_mark_at_its_start_and_few_enough_to_read(wall_m):
    picture = draw_track(Moment('/base', wall_m))
    assert 2 <= picture.count('<span class="track-mark') <= 11
    assert 'left:0.00%">0 m<' in picture


def test_it_shows_where_the_robot_is_and_nothing_is_sent_while_it_stands(ros):
    base, view, moments = ros.add(Resting), TrackView(), []
    assert view.text == ('READY. The robot waits for a speed on cmd_vel. '
                         'cmd_vel 0.00 m/s, speed 0.00 m/s, distance 10.00 m.')
    picture = view._front.picture
    view._front.observe(lambda change: moments.append(change.new), 'moment')
    for duration_sec in (0.5, 1.0, 1.0):
        drive(base, 1.0, duration_sec)
        assert view._job.call_now(5.0)
    assert [(each['css']['--at'], each['says']['track-speed']) for each in moments[-3:]] == [
        (0.0125, '0.50 m/s'), (0.1, '1.00 m/s'), (0.2, '1.00 m/s')]
    assert view.text.startswith('DRIVING.') and view._front.picture == picture
    base.step(3.0)
    assert view._job.call_now(5.0)
    shows(view, 'STOPPED. The robot stands 7.05 m from the wall.')
    count = len(moments)
    for _ in range(3):
        assert view._job.call_now(5.0)
    assert len(moments) == count
    ParameterClient(base).set_parameter('wall_m', 2.0)
    drive(base, 1.0, 1.0)
    shows(view, 'CRASHED. The robot has hit the wall at 0.05 m/s.')
    assert moments[-1]['hasCrashed'] and view._front.picture != picture
    press(view, 'reset')
    shows(view, 'READY. The robot waits for a speed on cmd_vel. cmd_vel 0.00 m/s, speed 0.00 m/s, distance 2.00 m.')


def test_it_follows_a_base_that_comes_later_is_replaced_or_gone(ros):
    view = TrackView('base')
    assert view.text == '/base is not running. It comes back here when it does.'
    press(view, 'reset')
    with pytest.raises(NodeNotFoundError):
        view.reset()
    for wall in ('5.0', '6.0'):
        ros.add(BaseNode, ros_args=['-p', f'wall_m:={wall}'])
        shows(view, f'distance {wall}0 m')
    ros.remove('/base')
    shows(view, '/base is not running')
    assert view._front.moment == {} and 'track-robot' not in view._front.picture
    view.close()
    view.close()
    assert repr(view) == '<TrackView: /base, closed>'
