"""A node followed live: the threads and services around the state machine, on real nodes and without widgets.

What the state machine itself promises is in test_live_state; what a panel makes of it in tests/widgets/test_panel.
"""

import threading

import pytest

import param_tutorial
from param_tools.node.client import ParameterClient
from param_tools.node.live import LiveParameters
from param_tools.ros.waiting import wait_until
from tests.support.nodes import Counter
from tests.support.widgets import due_jobs

TIMEOUT_SEC = 30.0


@pytest.fixture
def follow(ros):
    """Return a function that follows a node, and shows it by keeping what it saw; all are closed afterwards."""
    followed = []

    def follow(node, **options):
        live = LiveParameters(node, lambda: live.shown.append({name: each.value for name, each
                                                               in live.parameters.items()}), **options)
        live.shown = []
        followed.append(live)
        live.first_look()
        return live

    yield follow
    for each in followed:
        each.close()
    wait_until(lambda: not due_jobs(), 'the threads to end', TIMEOUT_SEC)


def test_a_first_look_that_is_interrupted_leaves_nobody_following(ros, follow):
    counter = ParameterClient(ros.add(Counter))
    shown = []

    def press_ctrl_c():
        shown.append(1)
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        LiveParameters('counter', press_ctrl_c).first_look()
    counter.set_parameter('x', 2)
    assert follow('counter').parameters['x'].value == 2
    assert len(shown) <= 2  # the schedule may have shown it at the same time


def test_the_lock_is_free_while_the_node_is_asked_and_while_it_is_shown(ros, monkeypatch):
    """Otherwise a node that hangs, or a slow page, would keep the executor's thread from serving all others."""
    free = {'send': [], 'show': []}

    def try_lock(what):
        def try_it():
            free[what].append(live._lock.acquire(timeout=5.0))
            if free[what][-1]:
                live._lock.release()

        thread = threading.Thread(target=try_it)
        thread.start()
        thread.join()

    def trying(what, call):
        return lambda *args, **options: (try_lock(what), call(*args, **options))[1]

    monkeypatch.setattr(ros.services, 'call_async', trying('send', ros.services.call_async))
    ros.add(Counter)
    live = LiveParameters('counter', lambda: try_lock('show'))
    live.first_look()
    for value in (1, 2, 3):
        live.ask(live.parameters['x'], value)
    live.settle(TIMEOUT_SEC)
    live.close()
    assert all(free.values())
    assert all(all(each) for each in free.values()), free


def test_a_value_that_cannot_be_sent_is_reported_and_nothing_is_stuck(ros, follow):
    ros.add(Counter)
    live = follow('counter')
    x = live.parameters['x']
    live.ask(x, {'no': 'parameter'})
    assert not x.busy
    assert 'cannot be a parameter' in x.message
    live.ask(x, 4)
    live.settle(TIMEOUT_SEC)
    assert (x.value, x.message) == (4, '')


def test_it_survives_the_executor(ros, follow):
    ros.add(Counter)
    live = follow('counter')
    param_tutorial.stop()
    assert 'no executor is running' in live.status
    live.ask(live.parameters['x'], 3)
    assert 'no executor is running' in live.parameters['x'].message
    param_tutorial.start().add(Counter)
    live.settle(TIMEOUT_SEC)
    assert (live.status, live.parameters['x'].message) == ('', '')
    assert live.shown[-1]['x'] == 0
