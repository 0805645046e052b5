"""The commands watch and history, and going back to a time."""

import re
import threading

import pytest

from param_tools.ros.interrupts import raise_in
from param_tools.systems.change_log import ChangeLog
from param_tutorial import ParameterClient, wait_until
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from tests.support.commands import run


@pytest.fixture
def log(ros, tmp_path):
    """Return the path of a log in which a robot gets another name, and then another."""
    ros.add(SimpleParamNode)
    path = tmp_path / 'changes.jsonl'
    thread = threading.Thread(target=lambda: results.append(run('watch', '--log', path, in_notebook=False)))
    results = []
    thread.start()
    try:
        wait_until(lambda: path.exists() and 'robot_name' in path.read_text(), 'the log to begin')
        for name in ('Berta', 'Carla'):
            ParameterClient('/simple_param_node').set_parameter('robot_name', name)
        wait_until(lambda: 'Carla' in path.read_text(), 'the changes to be written')
        ros.remove_all()
        wait_until(lambda: 'gone' in path.read_text(), 'the node to be missed')
    finally:
        # What Ctrl+C would raise, as soon as the thread runs Python code. A duration would be over too early on a busy
        # machine.
        while thread.is_alive():
            raise_in(thread, KeyboardInterrupt)
    stdout, stderr, status = results[0]
    assert stdout.startswith('Watching 9 parameters of 1 node\n')
    assert "/simple_param_node robot_name: 'Clawbot' → 'Berta'\n" in stdout
    assert (stderr, status) == ('', 0)
    return path


def test_what_has_happened_is_printed_and_brought_back(ros, log):
    stdout, stderr, status = run('history', log)
    assert re.search(r"/simple_param_node  robot_name  changed  'Berta' +'Carla'\n", stdout)
    assert (stderr, status) == ('', 0)
    first, second = (each for each in ChangeLog.read(log) if each.kind == 'changed')
    assert first.time < second.time
    ros.add(SimpleParamNode)
    stdout, _, status = run('restore', f'{log}@{first.time.isoformat()}')
    assert 'complete, 1 parameter set' in stdout
    assert status == 0
    assert ParameterClient('/simple_param_node').get_parameter('robot_name') == 'Berta'
    assert run('diff', f'{log}@{first.time.isoformat()}', '/**')[2] == 0
    stdout, _, status = run('diff', f'{log}@{first.time.isoformat()}', f'{log}@{second.time.isoformat()}')
    assert '1 difference, 8 the same' in stdout
    assert status == 1
    stdout, stderr, status = run('restore', f'{log}@2001-01-01T00:00')
    assert 'does not reach back to' in stderr
    assert status == 1


@pytest.mark.parametrize(('words', 'complaint'), [
    (['history', 'nowhere.jsonl'], 'cannot read nowhere.jsonl'),
    (['history', 'FILE'], 'FILE: this is no log of parameter changes'),
    (['watch'], 'This would keep the cell busy'),
    (['watch', '--duration', '1', '--log', 'no/such/folder/x'], 'cannot write no/such/folder/x'),
    (['restore', 'FILE@soon'], 'this is no log'),
])
def test_nonsense_gets_a_sentence(ros, write, words, complaint):
    path = write('hello\n', 'bad.jsonl')
    stdout, stderr, status = run(*(word.replace('FILE', str(path)) for word in words))
    assert (stdout, status) == ('', 1)
    assert complaint.replace('FILE', str(path)) in stderr
    assert 'Traceback' not in stderr
