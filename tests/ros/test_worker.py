"""The thread behind a view: when it calls, and when it ends. Waits for conditions, never for a time."""

import subprocess
import sys
import textwrap
import threading

import pytest

from param_tools.ros import worker as module
from param_tools.ros.waiting import wait_until
from param_tools.ros.worker import THREAD_NAME_PREFIX, Worker

TIMEOUT_SEC = 30.0


class Step:
    """What a worker calls: it counts its calls, returns what a test chooses, and can be held in mid-call."""

    def __init__(self, *answers):
        self.answers = list(answers)
        self.calls = 0
        self.threads = set()
        self.at_once = self.most_at_once = 0
        self.gate = threading.Event()
        self.gate.set()
        self.entered = threading.Event()

    def __call__(self):
        self.at_once += 1
        self.most_at_once = max(self.most_at_once, self.at_once)
        self.threads.add(threading.current_thread())
        self.entered.set()
        assert self.gate.wait(TIMEOUT_SEC)
        self.at_once -= 1
        self.calls += 1
        return self.answers.pop(0) if self.answers else None


@pytest.fixture
def make():
    """Return a function that makes a worker from a step; all of them are ended afterward."""
    made = []

    def make(step, period_sec=0.001):
        made.append(Worker(step, 'test', period_sec))
        return made[-1]

    yield make
    for each in made:
        each.end()
        wait_until(lambda each=each: each.is_idle, 'the thread to end', TIMEOUT_SEC)


@pytest.fixture
def never_by_itself(monkeypatch):
    """Keep workers from looking by themselves, so that each call is one that the test asked for."""
    monkeypatch.setattr(module, '_LOOK_PERIOD_SEC', 3600.0)


def wait_for_calls(step, count):
    wait_until(lambda: step.calls >= count, f'{count} calls; there were {step.calls}', TIMEOUT_SEC)


def test_it_has_no_thread_until_it_is_needed_and_none_when_nothing_is_left(make, monkeypatch):
    monkeypatch.setattr(module, '_LOOK_PERIOD_SEC', 0.001)
    step = Step()
    worker = make(step)
    assert worker.is_idle
    worker.wake()
    wait_for_calls(step, 1)
    wait_until(lambda: worker.is_idle, 'the thread to end', TIMEOUT_SEC)
    # Once because it was woken, and a few times to look for what is late.
    assert step.calls == 1 + module._IDLE_LOOKS
    worker.wake()
    wait_for_calls(step, 2 + module._IDLE_LOOKS)
    assert all(each.name == f'{THREAD_NAME_PREFIX}test' and each.daemon for each in step.threads)


def test_a_step_is_called_again_when_it_says_so_and_not_only_when_the_worker_looks_by_itself(make, never_by_itself):
    step = Step(*[0.001] * 20)
    make(step).wake()
    wait_for_calls(step, 21)


def test_zero_seconds_are_an_answer_too(make, never_by_itself):
    step = Step(*[0.0] * 20)
    make(step).wake()
    wait_for_calls(step, 21)


def test_a_step_with_nothing_outstanding_is_left_alone(make, never_by_itself):
    step = Step()
    worker = make(step)
    worker.wake()
    wait_for_calls(step, 1)
    worker.wake()
    wait_for_calls(step, 2)
    assert step.calls == 2


def test_waking_during_a_call_leads_to_another_one(make, never_by_itself):
    step = Step()
    step.gate.clear()
    worker = make(step)
    worker.wake()
    assert step.entered.wait(TIMEOUT_SEC)
    for _ in range(10):
        worker.wake()
    step.gate.set()
    wait_for_calls(step, 2)
    assert step.calls == 2


def test_staying_starts_a_thread_where_there_is_none(make, never_by_itself):
    step = Step()
    worker = make(step)
    worker.stay()
    wait_for_calls(step, 1)


class LateNews(threading.Condition):
    """Lets something happen between the end of a wait and the waiter's return, where a busy machine leaves it room."""

    def __init__(self, lock):
        super().__init__(lock)
        self.waits = 0
        self.news = {}

    def wait(self, timeout=None):
        is_notified = super().wait(timeout)
        self.waits += 1
        self.news.pop(self.waits, lambda: None)()
        return is_notified


@pytest.mark.parametrize(('news', 'calls'), [(Worker.wake, 1), (Worker.stay, module._IDLE_LOOKS)])
def test_what_happens_just_before_the_thread_would_end_is_looked_after(make, monkeypatch, news, calls):
    monkeypatch.setattr(module, '_LOOK_PERIOD_SEC', 0.001)
    step = Step()
    worker = make(step)
    worker._changed = LateNews(worker._lock)
    worker._changed.news[module._IDLE_LOOKS + 1] = lambda: news(worker)
    worker.wake()
    wait_until(lambda: worker.is_idle, 'the thread to end', TIMEOUT_SEC)
    assert worker._changed.news == {}
    assert step.calls >= 1 + module._IDLE_LOOKS + calls


def test_a_call_in_the_callers_thread_waits_its_turn_or_gives_up(make, never_by_itself):
    step = Step()
    step.gate.clear()
    worker = make(step)
    worker.wake()
    assert step.entered.wait(TIMEOUT_SEC)
    assert not worker.call_now(0.0)
    step.gate.set()
    assert worker.call_now(TIMEOUT_SEC)
    assert threading.current_thread() in step.threads
    assert step.most_at_once == 1


def test_what_a_call_in_the_callers_thread_leaves_outstanding_is_looked_after(make, never_by_itself):
    step = Step(0.0)
    worker = make(step)
    assert worker.call_now(TIMEOUT_SEC)
    wait_for_calls(step, 2)
    nothing_left = Step()
    idle = make(nothing_left)
    assert idle.call_now(TIMEOUT_SEC)
    assert idle.is_idle


def test_ended_it_calls_no_more(make, never_by_itself):
    step = Step(0.0)
    worker = make(step)
    worker.wake()
    wait_for_calls(step, 2)
    worker.end()
    wait_until(lambda: worker.is_idle, 'the thread to end', TIMEOUT_SEC)
    worker.wake()
    worker.stay()
    assert worker.is_idle


def test_after_an_exception_it_can_be_woken_again(make, never_by_itself, monkeypatch):
    raised = []
    monkeypatch.setattr(threading, 'excepthook', raised.append)
    step = Step()

    def step_that_raises_once():
        if not raised:
            raise ZeroDivisionError
        return step()

    worker = make(step_that_raises_once)
    worker.wake()
    wait_until(lambda: raised and worker.is_idle, 'the exception', TIMEOUT_SEC)
    assert raised[0].exc_type is ZeroDivisionError
    worker.wake()
    wait_for_calls(step, 1)


def test_no_worker_is_left_when_the_interpreter_ends():
    # Functions registered first are called last.
    done = subprocess.run([sys.executable, '-c', textwrap.dedent('''
        import atexit, threading
        atexit.register(lambda: print(threading.active_count()))
        from param_tools.ros.worker import Worker
        workers = [Worker(lambda: 0.0, 'busy', 0.001) for _ in range(20)]
        for worker in workers:
            worker.wake()
        print(threading.active_count())
    ''')], capture_output=True, text=True, timeout=60, check=False)
    assert (done.returncode, done.stdout, done.stderr) == (0, '21\n1\n', '')
