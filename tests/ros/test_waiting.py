"""Waiting: until it has come, and not longer than the limit."""

import threading
import time

from param_tools.ros import waiting
from param_tools.ros.waiting import wait, wait_for, wait_until


def test_what_comes_late_is_waited_for():
    event = threading.Event()
    threading.Timer(0.05, event.set).start()
    wait_until(event.is_set, 'the event', 60.0)
    assert wait_for(event, 0.0)


def test_the_last_look_comes_after_the_deadline(monkeypatch):
    """Else a thread that slept through its time would say that nothing has come."""
    looks = iter([False, True])

    def oversleep(seconds):
        monkeypatch.setattr(time, 'monotonic', lambda: float('inf'))

    monkeypatch.setattr(time, 'sleep', oversleep)
    assert wait(lambda: next(looks), 1.0)


def test_a_slow_machine_gets_more_time(monkeypatch):
    monkeypatch.setattr(waiting, 'PATIENCE', 10.0)
    monkeypatch.setattr(time, 'monotonic', lambda: 100.0)
    assert waiting.deadline(3.0) == 130.0
