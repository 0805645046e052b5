"""Ctrl+C while the stage begins or ends, and exceptions in what does not return."""

import os
import signal
import threading
import time

import pytest

import param_tutorial
from param_tools.ros.interrupts import held_back, raise_in, time_limit
from param_tutorial import ParameterClient, wait_until
from param_tutorial.nodes.simple_param_node import SimpleParamNode


def press():
    signal.raise_signal(signal.SIGINT)


def test_what_is_held_back_comes_after_the_block():
    done = []
    with pytest.raises(KeyboardInterrupt), held_back():
        with held_back():
            press()
        done.append(True)
    assert done


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


def test_the_limit_of_a_block_waits_for_the_end_of_a_block_in_it():
    with pytest.raises(ValueError), time_limit(0.05, ValueError):
        with pytest.raises(KeyError), time_limit(0.1, KeyError):
            loop()
        loop()


def test_a_thread_that_sleeps_is_left_alone():
    reading, writing = os.pipe()
    result = []
    thread = threading.Thread(target=lambda: result.append(os.read(reading, 1)))
    thread.start()
    clock, seen = time.pthread_getcpuclockid(thread.ident), []
    wait_until(lambda: seen.append(time.clock_gettime(clock)) or seen[-8:] == 8 * seen[-1:], 'the thread to sleep')
    assert not raise_in(thread, ValueError)
    os.write(writing, b'x')
    thread.join()
    assert result == [b'x']
    os.close(reading)
    os.close(writing)
