"""Time limits are counted in machine time: they are longer if many threads share a core."""

import signal
import threading
import time
from types import SimpleNamespace

import pytest

from param_tools.errors import WaitTimeoutError
from param_tools.ros import waiting
from param_tools.ros.waiting import wait_until, within


@pytest.fixture(params=[(1, 1, 1), (2, 1, 1), (8, 1, 4), (1, 2, 1), (1, 4, 2), (3, 4, 6)],
                ids=['idle', 'shared', 'busy', 'half a core', 'held back', 'busy and held back'])
def slowness(request, monkeypatch, tmp_path):
    """Pretend that threads share each core, and a quota holds them back; return how much slower time passes then."""
    threads_per_core, held_back, slowness = request.param
    cores = len(waiting.os.sched_getaffinity(0))
    (tmp_path / 'loadavg').write_text(f'1.00 1.00 1.00 {threads_per_core * cores}/300 4711\n')
    monkeypatch.setattr(waiting, '_LOAD', tmp_path / 'loadavg')
    monkeypatch.setattr(waiting.cgroups, 'Throttle', lambda: lambda: held_back)
    return slowness


@pytest.fixture
def now(monkeypatch):
    """Let time stand still for a new clock, return the time as a list of one number.

    Only in this thread: others, as the one that ends a test that hangs, go by the time that it is.
    """
    now, this_thread, real_machine_time = [0.0], threading.current_thread(), waiting.machine_time

    def is_pretended():
        return threading.current_thread() is this_thread

    monkeypatch.setattr(waiting, 'time', SimpleNamespace(
        monotonic=lambda: now[0] if is_pretended() else time.monotonic(), sleep=time.sleep))
    clock = waiting._MachineClock()
    monkeypatch.setattr(waiting, 'machine_time', lambda: clock() if is_pretended() else real_machine_time())
    return now


def test_machine_time_is_shared_by_those_who_run(slowness, now):
    now[0] += 1.0
    began = waiting.machine_time()
    now[0] += 8.0
    assert waiting.machine_time() - began == pytest.approx(8.0 / slowness)


@pytest.fixture
def no_quota(monkeypatch):
    """Pretend that nothing holds this process back."""
    monkeypatch.setattr(waiting.cgroups, 'Throttle', lambda: lambda: 1.0)


def test_on_a_machine_without_such_a_file_it_is_time(no_quota, now, monkeypatch, tmp_path):
    monkeypatch.setattr(waiting, '_LOAD', tmp_path / 'missing')
    now[0] += 1.0
    began = waiting.machine_time()
    now[0] += 8.0
    assert waiting.machine_time() - began == pytest.approx(8.0)


def test_a_wait_in_vain_takes_as_long_as_the_machine_needs(slowness, now):
    now[0] += 1.0
    waiting.machine_time()
    began = now[0]

    def wait(seconds):
        now[0] += seconds
        return False

    assert not within(2.0, wait)
    assert now[0] - began == pytest.approx(2.0 * slowness, abs=0.1)


def test_a_wait_ends_with_what_it_waits_for():
    event = threading.Event()
    threading.Timer(0.05, event.set).start()
    assert within(60.0, event.wait)
    assert within(0.0, event.wait)
    assert not within(0.0, threading.Event().wait)


def test_a_condition_that_does_not_come_true_is_named():
    with pytest.raises(WaitTimeoutError, match=r'timed out after 0\.1 s waiting for the end'):
        wait_until(lambda: False, 'the end', 0.1)


def test_the_last_look_is_after_the_deadline(monkeypatch):
    """A look may take long, and what it looks for may come meanwhile."""
    now = [0.0]
    monkeypatch.setattr(waiting, 'machine_time', lambda: now[0])

    def condition():
        now[0] += 3.0
        return now[0] > 6.0

    assert waiting.wait_until(condition, 'nothing', timeout_sec=5.0)


@pytest.mark.slow
def test_a_signals_handler_may_ask_for_machine_time_while_the_thread_that_it_interrupts_does(monkeypatch):
    asked = []
    monkeypatch.setattr(waiting, '_LOOK_PERIOD_SEC', 0.0)  # each look reads a file, and so takes longer
    previous = signal.signal(signal.SIGALRM, lambda *_: asked.append(waiting.machine_time()))
    signal.setitimer(signal.ITIMER_REAL, 0.001, 0.001)
    try:
        times = [waiting.machine_time()]
        while len(asked) < 200:
            times.append(waiting.machine_time())
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, previous)
    assert times == sorted(times)  # what the handler was told may not be in order: it may interrupt itself
