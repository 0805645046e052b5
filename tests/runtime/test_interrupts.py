"""Ctrl+C in the main thread: none is lost, and the stage and a terminal know afterwards whether they run."""

import contextlib
import signal
import sys
import threading

import pytest

import param_tutorial
from param_tutorial.errors import WaitTimeoutError


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


def press_again_and_again(ask, times):
    """Press Ctrl+C so many times while the main thread asks without a pause."""
    main = threading.main_thread().ident
    for _ in range(times):
        asking = threading.Event()

        def press_soon(asking=asking):
            asking.wait()
            signal.pthread_kill(main, signal.SIGINT)

        presser = threading.Thread(target=press_soon)
        presser.start()
        with pytest.raises(KeyboardInterrupt):
            asking.set()
            while True:
                ask()
        presser.join()


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


def test_the_stage_runs_on_after_an_interrupt_while_somebody_asks_whether_it_runs(ros):
    press_again_and_again(lambda: ros.is_running, 100)
    assert ros.is_running


def test_a_command_runs_on_after_an_interrupt_while_somebody_waits_for_its_words(ros):
    command = param_tutorial.Terminal('sh -c "echo begun; sleep 1000"')
    command.read('begun')

    def ask():
        with contextlib.suppress(WaitTimeoutError):
            command.read('nothing like this', timeout_sec=-1.0)

    press_again_and_again(ask, 500)
    with pytest.raises(WaitTimeoutError, match=r'0\.01 s passed'):
        command.read('nothing like this', timeout_sec=0.01)
