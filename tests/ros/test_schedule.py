"""Jobs of the one thread that draws and asks again: soon, not too often, and never twice at once. And waiting."""

import itertools
import subprocess
import sys
import threading
import time

import pytest

from param_tools.ros import schedule
from param_tools.ros.schedule import Job
from param_tools.ros.waiting import wait, wait_until


@pytest.fixture
def job():
    """Yield a function that makes a job, which ends after the test."""
    jobs = []

    def make(step, period_sec=0.0):
        jobs.append(Job(step, period_sec))
        return jobs[-1]

    yield make
    for each in jobs:
        each.end()


def test_however_often_it_is_woken_it_keeps_its_period(job):
    times = []
    each = job(lambda: times.append(schedule.time.monotonic()), 0.05)
    while len(times) < 4:
        each.wake()
    assert all(after - before >= 0.05 for before, after in itertools.pairwise(times))


def test_it_never_runs_twice_at_once(job):
    entered, go_on = threading.Event(), threading.Event()

    def step():
        entered.set()
        go_on.wait(60)

    each = job(step)
    each.wake()
    assert entered.wait(60)
    assert not each.call_now(0.01)
    go_on.set()
    assert each.call_now(60.0)


def test_a_job_that_raises_is_shown_and_keeps_no_other_from_running(job, capfd):
    ran = threading.Event()
    job(lambda: 1 / 0).wake()
    wait_until(lambda: 'ZeroDivisionError' in capfd.readouterr().err, 'the traceback')
    job(ran.set).wake()
    assert ran.wait(60)


def test_a_process_ends_while_a_job_is_due():
    code = 'from param_tools.ros.schedule import Job; job = Job(lambda: 0.001, 0.0); job.wake(); print("end")'
    done = subprocess.run([sys.executable, '-c', code], capture_output=True, text=True, timeout=60)
    assert (done.stdout, done.stderr, done.returncode) == ('end\n', '', 0)


def test_the_last_look_comes_after_the_deadline(monkeypatch):
    """Else a thread that slept through its time would say that nothing has come."""
    looks = iter([False, True])

    def oversleep(seconds):
        monkeypatch.setattr(time, 'monotonic', lambda: float('inf'))

    monkeypatch.setattr(time, 'sleep', oversleep)
    assert wait(lambda: next(looks), 1.0)
