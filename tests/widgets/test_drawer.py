"""The drawer: presets of nodes, and the history of the session with a way back; without a browser."""

import re
from pathlib import Path

import pytest

from param_tools.node.client import ParameterClient
from param_tools.panel import drawer as module
from param_tools.panel.drawer import ParameterDrawer
from param_tools.panel.panel import ParameterPanel
from param_tools.ros.waiting import wait_until
from tests.support.nodes import Arm, Counter


@pytest.fixture
def arm(ros):
    """Return a client of an Arm, beside which there is a Counter."""
    ros.add(Counter)
    return ParameterClient(ros.add(Arm))


@pytest.fixture
def drawer(arm, tmp_path):
    """Return a drawer that follows both nodes, opened at the history."""
    made = ParameterDrawer(folder=tmp_path)
    ask(made, 'open', tab='history')
    wait_until(lambda: lines(made) and made._front.state['heard'] > 20, 'both nodes to be read')
    return made


def ask(drawer, do, **details):
    """Do what the browser does when someone uses the drawer, and return the kernel's answer."""
    sent = []
    drawer._front.send = sent.append
    drawer._front._handle_custom_msg({'do': do, 'client': 'test', 'number': 7, **details}, [])
    wait_until(lambda: sent, 'the answer')
    assert (sent[0].pop('client'), sent[0].pop('number')) == ('test', 7)
    return sent[0]


def words(markup):
    """Return the text of HTML, with a blank for each tag."""
    return ' '.join(re.sub('<[^>]*>', ' ', markup).split())


def lines(drawer):
    """Return the history as the browser shows it, without the times."""
    return [(each['whose'], each['says']) for each in drawer._front.state['changes']]


BEGAN = ('', 'What the nodes had at the beginning')


def test_a_preset_says_what_it_would_change_before_it_does(drawer, arm, tmp_path):
    said = ask(drawer, 'save', name='calm', node='/arm')['said']
    assert words(said).startswith('Saved 20 values of 1 node. Left out: /arm: calibrated_at, ')
    ask(drawer, 'save', name='all', node='')
    wait_until(lambda: {(each['name'], each['holds']) for each in drawer._front.state['presets']}
               == {('calm', '1 node'), ('all', '2 nodes')}, 'both to be listed')
    assert drawer._front.state['folder'] == str(tmp_path)
    path = tmp_path / 'all.yaml'
    path.write_text(path.read_text().replace('reach: 0.5', 'reach: 7.5') + '/gone:\n  ros__parameters: {x: 1}\n')
    arm.set_parameters({'tool': 'saw', 'offset': 2.0})
    ParameterClient('/counter').set_parameter('x', 3)
    look = ask(drawer, 'look', name='all')
    assert look['can']
    assert words(look['markup']) == (
        '3 values would be set, 1 would not, because 7.5 is not between 0.01 and 2.0. Not running: /gone. '
        'parameter now then expected reason /arm offset 2.0 0.5 would be set /arm tool &#x27;saw&#x27; '
        '&#x27;gripper&#x27; would be set /counter x 3 0 would be set '
        '/arm reach 0.5 7.5 out of range 7.5 is not between 0.01 and 2.0')
    assert arm.get_parameter('tool') == 'saw', 'looking changes nothing'
    said = words(ask(drawer, 'apply', name='all')['said'])
    assert re.match(r'3 values set\. /arm reach: rejected, .*7\.5', said), said
    assert arm.get_parameters(['tool', 'offset', 'reach']) == {'tool': 'gripper', 'offset': 0.5, 'reach': 0.5}
    assert ParameterClient('/counter').get_parameter('x') == 0
    look = ask(drawer, 'look', name='calm')
    assert (words(look['markup']), look['can']) == ('Nothing would change: the nodes have these values.', False)


def test_a_preset_is_renamed_and_deleted(drawer, tmp_path):
    ask(drawer, 'save', name='calm', node='/counter')
    ask(drawer, 'rename', name='calm', to='tuned')
    assert [path.name for path in tmp_path.iterdir()] == ['tuned.yaml']
    assert 'is no name for a preset' in ask(drawer, 'rename', name='tuned', to='../x')['said']
    ask(drawer, 'delete', name='tuned')
    wait_until(lambda: drawer._front.state['presets'] == [], 'the list to be empty')
    assert 'there is no preset tuned in' in ask(drawer, 'look', name='tuned')['said']


def test_where_nothing_may_be_set_the_drawer_only_shows(ros, drawer, arm, tmp_path, monkeypatch):
    ask(drawer, 'save', name='calm', node='/arm')
    arm.set_parameter('tool', 'saw')
    monkeypatch.setattr(ros.services, 'is_read_only', True, raising=False)
    assert ask(drawer, 'look', name='calm')['can']
    for do in ('apply', 'save', 'rename', 'delete'):
        assert ask(drawer, do, name='calm', node='', to='x') == {}
    wait_until(lambda: drawer._front.state['is_read_only'], 'the drawer to say so')
    assert [path.name for path in tmp_path.iterdir()] == ['calm.yaml']
    assert arm.get_parameter('tool') == 'saw'


def test_the_history_goes_back_to_each_moment(drawer, arm):
    for value in (1.0, 1.5, 2.0):  # as a slider does
        arm.set_parameter('offset', value)
    arm.set_parameters_atomically({'tool': 'saw', 'joints': 9})
    ParameterClient('/counter').set_parameter('x', 3)
    expected = [('/counter x', '0 → 3'), ('/arm joints', '5 → 9'), ('/arm tool', "'gripper' → 'saw'"),
                ('/arm offset', '0.5 → 2.0 in 3 changes'), BEGAN]
    wait_until(lambda: lines(drawer) == expected, 'the history', 20)
    times = [each['time'] for each in drawer._front.state['changes']]
    assert times[1] == times[2], 'what was set together has one moment'
    look = ask(drawer, 'look', time=times[3])
    assert words(look['markup']).startswith('3 values would be set. parameter now then /arm ')
    assert words(ask(drawer, 'apply', time=times[3])['said']) == '3 values set.'
    assert arm.get_parameters(['offset', 'tool', 'joints']) == {'offset': 2.0, 'tool': 'gripper', 'joints': 5}
    wait_until(lambda: ('/arm tool', "'saw' → 'gripper'") in lines(drawer), 'the way back to be in the history, too')
    ask(drawer, 'apply', time=times[4])
    assert arm.get_parameter('offset') == 0.5


def test_a_node_that_goes_and_comes_is_one_line_each(ros, drawer, arm):
    arm.set_parameter('tool', 'saw')
    ros.remove('/arm')
    changed = [('/arm tool', "'gripper' → 'saw'"), BEGAN]
    wait_until(lambda: lines(drawer) == [('/arm', 'is gone'), *changed], 'the end of the node', 20)
    ros.add(Arm)
    wait_until(lambda: lines(drawer) == [('/arm', 'has come'), ('/arm', 'is gone'), *changed], 'the node', 20)
    look = ask(drawer, 'look', time=drawer._front.state['changes'][2]['time'])
    assert words(look['markup']).endswith(' /arm tool &#x27;gripper&#x27; &#x27;saw&#x27;')


def test_undo_in_a_panel_goes_on_after_a_way_back(drawer, arm):
    panel = ParameterPanel('/arm')
    panel['offset'].value = 2.0
    panel.settle()
    wait_until(lambda: len(lines(drawer)) == 2, 'the change')
    ask(drawer, 'apply', time=drawer._front.state['changes'][-1]['time'])
    panel['tool'].value = 'saw'
    panel.settle()
    panel.undo()
    assert (arm.get_parameter('tool'), arm.get_parameter('offset')) == ('gripper', 0.5)


def test_what_is_beyond_the_log_is_the_beginning_of_the_history(drawer, arm, monkeypatch):
    monkeypatch.setattr(module, '_MOST_KEPT', 30)
    monkeypatch.setattr(module, '_KEPT', 2)
    monkeypatch.setattr(module, '_ONE_PULL', module.datetime.timedelta())
    arm.set_parameter('tool', 'saw')
    for value in range(12):
        arm.set_parameter('offset', float(value))
    arm.set_parameter('tool', 'drill')
    wait_until(lambda: lines(drawer)[0] == ('/arm tool', "'saw' → 'drill'"), 'the changes')
    oldest = drawer._front.state['changes'][-1]
    assert oldest['whose'] == '/arm offset'
    ask(drawer, 'apply', time=oldest['time'])
    assert arm.get_parameters(['offset', 'tool']) == {'offset': float(oldest['says'].split(' → ')[1]), 'tool': 'saw'}


def test_a_drawer_of_some_nodes_leaves_the_others_alone(ros, arm, tmp_path):
    some = ParameterDrawer(['arm'], folder=Path(tmp_path))
    ask(some, 'open', tab='history')
    wait_until(lambda: some._front.state['heard'] > 20, 'the node to be read')
    assert some._front.state['nodes'] == ['/arm']
    ParameterClient('/counter').set_parameter('x', 3)
    arm.set_parameter('tool', 'saw')
    wait_until(lambda: lines(some) == [('/arm tool', "'gripper' → 'saw'"), BEGAN], 'the history')
    assert words(ask(some, 'save', name='all', node='')['said']).startswith('Saved 20 values of 1 node.')
    assert repr(some) == '<ParameterDrawer: /arm>'
    some.close()
    assert repr(some) == '<ParameterDrawer: /arm, closed>'
