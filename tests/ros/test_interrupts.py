"""interrupts: a Ctrl+C that Python has only printed comes again, and none leaves anything locked."""

import functools
import gc
import itertools
import queue
import signal
import subprocess
import sys
import threading

import pytest
from rcl_interfaces.msg import Log
from rcl_interfaces.srv import ListParameters

import param_tutorial
from param_tools.errors import WaitTimeoutError
from param_tools.panel.pending_clicks import Backlog
from param_tools.ros import interrupts
from param_tools.ros.interrupts import Latch, held_back, raise_in
from param_tools.ros.node_log import NodeLog
from param_tools.ros.waiting import wait_until, within
from param_tools.ros.worker import Worker
from param_tutorial import ParameterClient, Terminal
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from tests.support.paths import ROOT

# An interrupt at the end of open() leaves the file to its finalizer, which closes it, and warns of that.
pytestmark = pytest.mark.filterwarnings('ignore:unclosed file:ResourceWarning')


class Swallows:
    """Has a finalizer, in which an exception goes no further."""

    def __init__(self, act):
        self.act = act

    def __del__(self):
        self.act()


def press():
    signal.raise_signal(signal.SIGINT)


def fail():
    raise ValueError('in a finalizer')


@pytest.mark.usefixtures('ros')
def test_an_interrupt_in_a_finalizer_comes_again():
    swallows = Swallows(press)
    with pytest.raises(KeyboardInterrupt):
        del swallows
        threading.Event().wait(60)


def test_whoever_wants_to_hear_of_other_exceptions_in_finalizers_does(monkeypatch):
    heard = []
    monkeypatch.setattr(sys, 'unraisablehook', lambda each: heard.append(str(each.exc_value)))
    param_tutorial.stop()
    before = sys.unraisablehook
    param_tutorial.start()
    assert sys.unraisablehook is not before
    Swallows(fail)
    assert heard == ['in a finalizer']
    param_tutorial.stop()
    assert sys.unraisablehook is before


class InterruptedEverywhere:
    """Calls a function again and again, with a Ctrl+C at the end of one call that it makes: of the first, then of the
    second, or of the one that is ``stride`` further, until it makes no more.

    One that a finalizer swallows does not come again here: on a busy machine it would come after the test.
    """

    def __init__(self, act, check, stride=1):
        self.interrupts = 0
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(interrupts, '_press_again', lambda _: None)
            self._press_everywhere(act, check, stride)

    def _press_everywhere(self, act, check, stride):
        for number in itertools.count(1, stride):
            self._left = number
            gc.disable()  # nor is a finalizer of something else to be interrupted
            sys.setprofile(self._look)
            try:
                act()
            except (KeyboardInterrupt, WaitTimeoutError, RuntimeError):  # Condition.wait makes a RuntimeError of some
                pass
            finally:
                sys.setprofile(None)
                gc.enable()
            if self._left:
                break
            self.interrupts += 1
            check()

    def _look(self, _frame, event, _argument):
        if event in ('return', 'c_return') and self._left:
            self._left -= 1
            if not self._left:
                press()


def in_another_thread(act, timeout_sec=5.0):
    """Return a function that calls another one in a thread, and fails if that does not end."""
    def call():
        thread = threading.Thread(target=act, daemon=True)
        thread.start()
        within(timeout_sec, lambda seconds: thread.join(seconds) or not thread.is_alive())
        assert not thread.is_alive(), 'something is locked'
    return call


def interrupt_an_event():
    event = threading.Event()
    with pytest.raises(AssertionError, match='locked'):
        InterruptedEverywhere(lambda: event.wait(0.001), in_another_thread(event.set, 0.5))


def interrupt_starting_workers():
    calls = queue.SimpleQueue()
    workers = [Worker(functools.partial(calls.put, 0), 'interrupted', 0.0)]

    def wake_another():
        workers.append(Worker(functools.partial(calls.put, len(workers)), 'interrupted', 0.0))
        workers[-1].wake()

    def work():
        workers[-1].wake()
        while calls.get() != len(workers) - 1:
            pass

    assert InterruptedEverywhere(wake_another, in_another_thread(work)).interrupts > 5


@pytest.mark.parametrize('act', [
    interrupt_an_event,  # if this one fails, a Python has come that needs no Latch
    interrupt_starting_workers,
])
def test_in_a_process_that_keeps_a_locked_thread(act):
    """Python's own Event, and with it Thread.start(), may leave a thread that waits until the process ends."""
    done = subprocess.run([sys.executable, '-c', f'from {__name__} import {act.__name__}; {act.__name__}()'],
                          cwd=ROOT, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, '')


@pytest.mark.parametrize('act', ['start', 'stop'])
def test_the_stage_is_there_after_each_interrupt_of_its_beginning_and_its_end(act):
    def ask():
        ros = param_tutorial.start()
        assert ros.services.node_names() == []
        ros.add(SimpleParamNode)
        assert ParameterClient('simple_param_node').list_parameters()
        if act == 'start':
            param_tutorial.stop()

    ask()
    assert InterruptedEverywhere(getattr(param_tutorial, act), ask, stride=5).interrupts > 5


def test_a_call_is_forgotten_after_each_interrupt(ros):
    client = ParameterClient(ros.add(SimpleParamNode))

    def look():
        assert ros.services._pending == {}

    client.list_parameters()
    assert InterruptedEverywhere(client.list_parameters, look).interrupts > 20
    assert client.list_parameters()


def test_so_is_one_without_waiting_when_its_time_is_over(ros):
    ros.add(SimpleParamNode)
    ros.services.greet('/simple_param_node')

    def ask():
        ros.services.call_async('/simple_param_node', 'list_parameters', ListParameters.Request(), lambda _: None,
                                timeout_sec=0.1)

    def look():
        wait_until(lambda: ros.services._pending == {}, 'the call to be forgotten', timeout_sec=30)

    assert InterruptedEverywhere(ask, look).interrupts > 5


def test_what_is_held_back_comes_behind_the_block():
    done = []
    with pytest.raises(KeyboardInterrupt), held_back():
        with held_back():
            press()
        done.append(True)
    assert done


def test_another_thread_holds_nothing_back():
    before = signal.getsignal(signal.SIGINT)
    found = []

    def look():
        with held_back():
            found.append(signal.getsignal(signal.SIGINT))
    in_another_thread(look)()
    assert found == [before]


def test_what_is_raised_in_a_sleeping_thread_waits_for_it_and_holds_up_no_other():
    """In CPython 3.11, a function that is profiled would never begin."""
    awake, is_ready, heard = threading.Lock(), threading.Event(), []

    def sleep():
        try:
            is_ready.set()
            awake.acquire()
        except ValueError:
            heard.append('an error')

    with awake:
        sleeper = threading.Thread(target=sleep)
        sleeper.start()
        is_ready.wait()
        raise_in(sleeper, ValueError)
        sys.setprofile(lambda *_: None)
        try:
            sleeper.is_alive()
        finally:
            sys.setprofile(None)
    sleeper.join()
    assert heard == ['an error']


def test_nothing_is_raised_in_a_thread_that_has_ended():
    """Its number may be that of the next one that begins."""
    for _ in range(100):
        thread = threading.Thread(target=lambda: None)
        thread.start()
        thread.join()
        raise_in(thread, ValueError)


@pytest.mark.parametrize('waiters', [1, 2])
def test_a_latch_can_be_set_after_each_interrupt(waiters):
    latch = Latch()
    assert InterruptedEverywhere(lambda: latch.wait(0.001), in_another_thread(lambda: None)).interrupts >= 1
    assert not latch.is_set()
    in_another_thread(latch.set)()
    assert latch.is_set()
    for _ in range(waiters):
        in_another_thread(lambda: latch.wait(60.0))()


def test_who_waits_for_a_latch_beside_an_interrupted_one_hears_of_it():
    latch = Latch()
    heard = []
    threads = [threading.Thread(target=lambda: heard.append(latch.wait(60.0))) for _ in range(3)]
    for thread in threads:
        thread.start()
    latch.set()
    for thread in threads:
        thread.join()
    assert heard == [True] * 3


def test_a_log_can_be_read_after_each_interrupt():
    log = NodeLog()
    done = InterruptedEverywhere(lambda: log.read(until='never', timeout_sec=0.0), in_another_thread(log.lines))
    assert done.interrupts > 5
    log.receive(Log(level=20, name='talker', msg='Hello'))
    assert log.read(until='Hello') == '[INFO] [talker]: Hello'


def test_messages_from_a_page_are_counted_although_a_cell_was_interrupted_before_it_began():
    backlog = Backlog()
    backlog.add()
    assert InterruptedEverywhere(lambda: backlog.wait(0.001), in_another_thread(backlog.add)).interrupts > 5


@pytest.mark.parametrize('act', ['wake', 'stay', 'call_now'])
def test_a_worker_works_on_after_each_interrupt(act):
    calls = queue.SimpleQueue()
    worker = Worker(lambda: calls.put(None), 'interrupted', 0.0)

    def work():
        while not calls.empty():
            calls.get()
        worker.wake()
        calls.get()

    doing = {'wake': worker.wake, 'stay': worker.stay, 'call_now': lambda: worker.call_now(0.1)}[act]
    assert InterruptedEverywhere(doing, in_another_thread(work)).interrupts >= 1
    worker.end()


def test_a_terminal_collects_on_after_each_interrupt_of_a_read():
    terminal = Terminal('seq 1 3')
    terminal.read(until='3')
    assert terminal.interrupt() == 0
    done = InterruptedEverywhere(lambda: terminal.read(until='never', timeout_sec=0.0),
                                 in_another_thread(lambda: terminal.text))
    assert done.interrupts > 5
    assert terminal.text == '1\n2\n3\n'
