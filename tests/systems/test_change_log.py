"""The log of changes: nothing is lost in a crash, and every time can be brought back."""

import datetime
import signal
import subprocess
import sys
import threading
import time

import hypothesis.strategies as st
import pytest
from hypothesis import given
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node

from param_tools import all_parameters, values
from param_tools.errors import InvalidValueError, ParameterFileError
from param_tools.ros.rclpy_private import observe_changes
from param_tools.systems.change_log import ChangeFollower, ChangeLog, ChangeLogWriter, LoggedChange
from param_tutorial import ParameterClient, wait_until
from tests.support.nodes import Arm
from tests.support.strategies import TEXT, VALUES

START = datetime.datetime(2026, 11, 22, 14, 0, tzinfo=datetime.timezone.utc)
CHANGES = st.lists(st.builds(
    LoggedChange, st.integers(0, 3600).map(lambda seconds: START + datetime.timedelta(seconds=seconds)),
    st.sampled_from(['seen', 'declared', 'changed', 'deleted']), st.sampled_from(['/a', '/b/c']), TEXT,
    st.none() | VALUES, st.none() | VALUES | st.just([])), max_size=6)


def same(left, right):
    return (left.time, left.kind, left.node, left.name) == (right.time, right.kind, right.node, right.name) and all(
        values.same(*pair) for pair in ((left.old, right.old), (left.new, right.new)))


@pytest.mark.slow
@given(CHANGES, st.data())
def test_of_a_log_that_a_crash_has_cut_all_whole_lines_are_there(tmp_path, changes, data):
    path = tmp_path / 'changes.jsonl'
    path.unlink(missing_ok=True)
    with ChangeLogWriter(path) as writer:
        writer.write(changes)
    content = path.read_bytes()
    cut = data.draw(st.integers(0, len(content)))
    path.write_bytes(content[:cut])
    whole = content[:cut].count(b'\n')
    again = LoggedChange(START, 'begin')
    with ChangeLogWriter(path) as writer:
        writer.write([again])
    log = ChangeLog.read(path)
    assert all(map(same, log, [*changes[:whole], again])) or len(log) == whole + 2
    assert len(log) >= whole + 1
    assert len(log.damaged) <= 1


@pytest.mark.slow
@given(st.one_of(st.binary(), st.text().map(str.encode), st.lists(st.sampled_from([
    b'{', b'{}', b'[]', b'null', b'{"time": 5}', b'\xff', b'{"time": "2026-11-22T14:00:00+00:00", "kind": "seen", '
    b'"node": "/a", "parameter": "x", "old": {"double": "y"}, "new": {"a": 1}}', b'[' * 5000,
    b'{"time": "2026-11-22T14:00:00+00:00", "kind": "seen", "node": "/a", "parameter": "x", "old": null, "new": 1}',
])).map(b'\n'.join)))
def test_any_file_is_read_as_far_as_it_goes_or_rejected_with_a_sentence(write, content):
    path = write(content, 'changes.jsonl')
    try:
        log = ChangeLog.read(path)
    except ParameterFileError as error:
        assert 'this is no log of parameter changes' in str(error)
        return
    log.at()
    repr(log)


def logged(kind, minute, name='x', old=None, new=None, node='/a'):
    return LoggedChange(START + datetime.timedelta(minutes=minute), kind, node, name, old, new)


LOG = ChangeLog([
    logged('begin', 0, '', node=''), logged('seen', 0, new=1), logged('seen', 0, 'y', new='a', node='/b'),
    logged('changed', 5, old=1, new=2), logged('declared', 6, 'z', new=0.5), logged('gone', 7, '', node='/b'),
    logged('deleted', 8, 'z', 0.5), logged('changed', 9, old=2, new=3),
    logged('seen', 12, node='/c', new=1), logged('begin', 20, '', node=''),
    logged('seen', 20, new=7)])


@pytest.mark.parametrize(('minute', 'state'), [
    (0, {'/a': {'x': 1}, '/b': {'y': 'a'}}), (4.9, {'/a': {'x': 1}, '/b': {'y': 'a'}}),
    (5, {'/a': {'x': 2}, '/b': {'y': 'a'}}), (6, {'/a': {'x': 2, 'z': 0.5}, '/b': {'y': 'a'}}),
    (7, {'/a': {'x': 2, 'z': 0.5}}), (8, {'/a': {'x': 2}}), (15, {'/a': {'x': 3}, '/c': {'x': 1}}),
    (21, {'/a': {'x': 7}})])
def test_the_state_at_any_time(minute, state):
    assert LOG.at(START + datetime.timedelta(minutes=minute)) == state


def test_a_state_knows_its_time_and_a_time_without_zone_is_a_local_one():
    local = (START + datetime.timedelta(minutes=5)).astimezone().replace(tzinfo=None)
    state = LOG.at(local)
    assert state == {'/a': {'x': 2}, '/b': {'y': 'a'}}
    assert f'2 nodes, {local.astimezone().isoformat(timespec="seconds")}' in state.dump().text
    assert LOG.at().taken == LOG.records[-1].time
    assert [each.kind for each in LOG.select(since=local, until=local)] == ['changed']


def test_changes_are_selected():
    assert [each.name for each in LOG.select(nodes=['/b'])] == ['y', '']
    assert [each.new for each in LOG.select(names='^x$', kinds=['changed'])] == [2, 3]
    later = START + datetime.timedelta(minutes=7)
    assert [each.kind for each in LOG.select(since=later, until=later)] == ['gone']
    assert '/b' in repr(LOG)
    assert repr(LOG.select(nodes=['/nobody'])) == '0 changes'


@pytest.mark.parametrize('text', ['', 'soon', '25:00', '2026-13-01', '9' * 30, '14:05Z+'])
def test_what_is_no_time_gets_a_sentence(text):
    with pytest.raises(InvalidValueError, match='is not a time: write 14:05'):
        LOG.parse_time(text)


def test_a_time_of_day_is_the_last_one_that_the_log_has_reached():
    times = [datetime.datetime(2026, 11, day, hour, tzinfo=datetime.timezone.utc).astimezone()
             for day, hour in ((21, 10), (22, 9))]
    log = ChangeLog(LoggedChange(each, 'begin') for each in times)
    for each in times:
        assert log.parse_time(f'{each:%H:%M}') == each
    assert log.parse_time('2026-11-21T10:00+00:00') == times[0]


# -- following ------------------------------------------------------------------------------------------------


@pytest.fixture
def told(ros):
    """Return the changes that a follower hears of, with a node that was there before it."""
    ros.add(Arm)
    changes = []
    with ChangeFollower(changes.extend):
        yield changes


def find(changes, **wanted):
    return [each for each in changes if all(getattr(each, key) == value for key, value in wanted.items())]


def test_each_change_is_reported_with_its_old_and_new_value(ros, told):
    assert [each.new for each in find(told, kind='seen', node='/arm', name='offset')] == [0.5]
    client = ParameterClient('/arm')
    client.set_parameters({'offset': 0.75, 'tool': 'hook'})
    client.set_parameter('payload', 'heavy')
    client.delete_parameter('payload')
    client.set_parameter('offset', 0.5)
    wait_until(lambda: len(find(told, kind='changed', name='offset')) == 2, 'the changes to be told')
    assert [(each.name, each.old, each.new) for each in find(told, kind='changed')] == [
        ('offset', 0.5, 0.75), ('tool', 'gripper', 'hook'), ('payload', 1.5, 'heavy'), ('offset', 0.75, 0.5)]
    assert [(each.name, each.old) for each in find(told, kind='deleted')] == [('payload', 'heavy')]
    assert ChangeLog(told).at()['/arm'] == all_parameters()['/arm']


def test_a_node_that_restarts_has_gone_and_come(ros, told):
    ParameterClient('/arm').set_parameter('offset', 0.75)
    wait_until(lambda: find(told, kind='changed'), 'the change to be told')
    ros.add(Arm)
    wait_until(lambda: find(told, kind='gone'), 'the old node to be missed')
    wait_until(lambda: ChangeLog(told).at().get('/arm', {}).get('offset') == 0.5, 'the new node to be seen')


@pytest.mark.slow
def test_a_change_whose_event_got_lost_is_found_when_a_new_node_is_read_again(ros):
    node, changes = ros.add(Arm), []
    ros.run(lambda: observe_changes(node, lambda _, callback, parameters: callback(parameters),
                                    lambda _publish, _event: None), 'lose its events')
    with ChangeFollower(changes.extend):
        ParameterClient(node).set_parameter('offset', 0.75)
        wait_until(lambda: find(changes, kind='changed'), 'the change to be told')
    assert [(each.name, each.old, each.new) for each in find(changes, kind='changed')] == [('offset', 0.5, 0.75)]


@pytest.mark.slow
def test_a_reading_does_not_overtake_the_events_before_it(ros):
    node, changes, may_go_on = ros.add(Arm), [], threading.Event()
    began = time.monotonic()

    def listen(told):
        changes.extend(told)
        if find(told, kind='changed'):
            may_go_on.wait(30)

    with ChangeFollower(listen):
        client = ParameterClient(node)
        for value in (1.0, 2.0, 3.0):
            client.set_parameter('offset', value)
        client.set_parameter('tool', 'hook')
        # The node is to be read again, and that comes first.
        wait_until(lambda: time.monotonic() > began + 1, 'the next reading to be due')
        may_go_on.set()
        wait_until(lambda: find(changes, name='tool', kind='changed'), 'the changes to be told')
    assert [each.new for each in find(changes, kind='changed')] == [1.0, 2.0, 3.0, 'hook']


@pytest.mark.slow
def test_a_node_that_hangs_is_named_and_delays_no_other(ros, silent):
    ros.add(Arm)
    changes, trouble = [], []
    with ChangeFollower(changes.extend, trouble=trouble.append, timeout_sec=0.3):
        ParameterClient('/arm').set_parameter('offset', 0.75)
        wait_until(lambda: find(changes, kind='changed'), 'the change to be told')
    assert trouble[0].node == '/silent'


@pytest.mark.slow
def test_a_node_that_does_not_answer_at_first_is_asked_again(ros, monkeypatch):
    """Also if nothing in the graph changes meanwhile."""
    monkeypatch.setattr(ros, 'on_graph_change', lambda _: lambda: None)
    silent, executor = Node('silent'), SingleThreadedExecutor()
    observe_changes(silent, lambda _, callback, parameters: callback(parameters), lambda _publish, _event: None)
    silent.declare_parameter('untold', 1)
    changes, trouble = [], []
    try:
        with ChangeFollower(changes.extend, trouble=trouble.append, timeout_sec=0.3):
            wait_until(lambda: trouble, 'the node to be named')
            executor.add_node(silent)
            wait_until(lambda: executor.spin_once(timeout_sec=0.02) or find(changes, name='untold'), 'its parameters')
    finally:
        executor.shutdown()
        silent.destroy_node()
    assert [each.kind for each in find(changes, name='untold')] == ['seen']
    assert len(trouble) == 1


@pytest.mark.slow
@pytest.mark.real_layer(reason='the log is written by another process')
def test_a_log_survives_the_death_of_the_process_that_writes_it(ros, tmp_path):
    ros.add(Arm)
    path = tmp_path / 'changes.jsonl'
    process = subprocess.Popen([sys.executable, '-m', 'param_tutorial', 'watch', '--log', path], text=True,
                               stdout=subprocess.PIPE)
    try:
        assert process.stdout.readline().startswith('Watching ')
        wait_until(lambda: 'offset' in path.read_text(), 'the node to be read')
        client = ParameterClient('/arm')
        for number in range(5):
            client.set_parameter('offset', float(number))
            assert f'→ {number}.0' in process.stdout.readline()
    finally:
        process.send_signal(signal.SIGKILL)
        process.communicate()
    assert [each.new for each in ChangeLog.read(path).select(names='offset', kinds=['changed'])] == [
        0.0, 1.0, 2.0, 3.0, 4.0]
