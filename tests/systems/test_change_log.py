"""The log of changes: nothing is lost in a crash, and every time can be brought back."""

import datetime
import signal
import subprocess
import sys

import hypothesis.strategies as st
import pytest
from hypothesis import given
from rclpy.task import Future

from param_tools import all_parameters, values
from param_tools.errors import InvalidValueError
from param_tools.node.client import Questions
from param_tools.systems import change_log
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


@given(CHANGES)
def test_what_is_written_is_read_back_also_after_a_torn_line(tmp_path, changes):
    path = tmp_path / 'changes.jsonl'
    path.write_bytes(b'{"time": "2026-11\n')
    with ChangeLogWriter(path) as writer:
        writer.write([logged('begin', 0, '', node=''), *changes])
    again = ChangeLog.read(path)
    assert len(again) == 1 + len(changes)
    assert all(map(same, again.records[1:], changes))


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
def changes(ros):
    """Return the changes that a follower reports, with a node that was there before it."""
    ros.add(Arm)
    reported = []
    with ChangeFollower(reported.extend):
        yield reported


def find(changes, **wanted):
    return [each for each in changes if all(getattr(each, key) == value for key, value in wanted.items())]


def now(changes):
    return ChangeLog(changes).at(datetime.datetime.now())


def test_each_change_is_reported_with_its_old_and_new_value(ros, changes):
    # As read, or as declared: the node has just started.
    assert [(each.old, each.new) for each in find(changes, node='/arm', name='offset')] == [(None, 0.5)]
    client = ParameterClient('/arm')
    client.set_parameters({'offset': 0.75, 'tool': 'hook'})
    client.set_parameter('payload', 'heavy')
    client.delete_parameter('payload')
    client.set_parameter('offset', 0.5)
    wait_until(lambda: len(find(changes, kind='changed', name='offset')) == 2, 'the changes to be reported')
    assert [(each.name, each.old, each.new) for each in find(changes, kind='changed')] == [
        ('offset', 0.5, 0.75), ('tool', 'gripper', 'hook'), ('payload', 1.5, 'heavy'), ('offset', 0.75, 0.5)]
    assert [(each.name, each.old) for each in find(changes, kind='deleted')] == [('payload', 'heavy')]
    assert now(changes)['/arm'] == all_parameters()['/arm']


def test_a_node_that_restarts_has_gone_and_come(ros, changes):
    ParameterClient('/arm').set_parameter('offset', 0.75)
    wait_until(lambda: find(changes, kind='changed'), 'the change to be reported')
    ros.add(Arm)
    wait_until(lambda: find(changes, kind='gone'), 'the old node to be missed')
    wait_until(lambda: now(changes).get('/arm', {}).get('offset') == 0.5, 'the new node to be seen')


def test_an_answer_that_comes_late_puts_no_old_value_after_a_newer_one(ros, monkeypatch):
    """The node is read before it changes, and what it said arrives after the events of the changes."""
    changes, read, answered, may_answer = [], [], [], Future(executor=ros._executor)

    class Late(Questions):
        async def get_parameters(self, names=None):
            present = await super().get_parameters(names)
            read.append(present['offset'])
            await may_answer
            answered.append(present['offset'])
            return present

    with ChangeFollower(changes.extend, nodes=['/arm']):
        monkeypatch.setattr(change_log, 'Questions', Late)
        client = ParameterClient(ros.add(Arm))
        wait_until(lambda: read, 'the node to be read')
        for value in (1.0, 2.0, 3.0):
            client.set_parameter('offset', value)
        wait_until(lambda: find(changes, name='offset', new=3.0), 'the changes to be reported')
        ros.run(lambda: may_answer.set_result(None), 'answer')
        wait_until(lambda: answered, 'the answer')
    assert answered[0] == 0.5
    assert [each.new for each in find(changes, name='offset')] == [0.5, 1.0, 2.0, 3.0]


def test_a_node_that_hangs_is_named_and_delays_no_other(ros, silent):
    ros.add(Arm)
    changes, trouble = [], []
    with ChangeFollower(changes.extend, trouble=trouble.append, timeout_sec=0.3):
        ParameterClient('/arm').set_parameter('offset', 0.75)
        wait_until(lambda: find(changes, kind='changed'), 'the change to be reported')
    assert trouble[0].node == '/silent'


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
    assert [each.new for each in find(ChangeLog.read(path), name='offset', kind='changed')] == [
        0.0, 1.0, 2.0, 3.0, 4.0]
