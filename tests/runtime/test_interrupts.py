"""interrupts: a Ctrl+C that Python has only printed comes again."""

import signal
import sys
import threading

import pytest

import param_tutorial


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
