"""Ctrl+C while the stage begins or ends, and exceptions in what does not return."""

import signal
import threading

import pytest

import param_tutorial
from param_tools.ros.interrupts import time_limit
from param_tutorial import ParameterClient
from param_tutorial.nodes.simple_param_node import SimpleParamNode


@pytest.mark.parametrize('act', ['start', 'stop'])
def test_the_stage_is_whole_after_an_interrupt_of_its_beginning_and_its_end(ros, act):
    if act == 'start':
        param_tutorial.stop()
    with pytest.raises(KeyboardInterrupt):
        threading.Timer(0.01, signal.pthread_kill, [threading.main_thread().ident, signal.SIGINT]).start()
        while True:
            getattr(param_tutorial, act)()
    again = param_tutorial.start()
    again.add(SimpleParamNode)
    assert ParameterClient('simple_param_node').list_parameters()


def loop():
    while True:
        pass


def test_a_block_is_ended_when_its_time_is_over_also_one_that_catches_everything_once():
    before = signal.getsignal(signal.SIGALRM)
    with pytest.raises(ValueError), time_limit(0.05, ValueError):
        with pytest.raises(ValueError):
            loop()
        loop()
    assert signal.getsignal(signal.SIGALRM) is before
