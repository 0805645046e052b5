"""interrupts: Ctrl+C reaches what a notebook starts, also in a process that was itself started to ignore it."""

import os
import signal
import sys
import threading

import pytest

from param_tutorial import Shell, Terminal, wait_until

WAITS = f'"{sys.executable}" -c "import signal; print(1, flush=True); signal.pause()"'


@pytest.fixture(autouse=True)
def ignores_ctrl_c():
    """Ignore SIGINT, as a process does that nohup or a shell's background job has started."""
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    yield
    assert signal.getsignal(signal.SIGINT) is signal.SIG_IGN
    signal.signal(signal.SIGINT, before)


def test_a_terminals_command_ends_with_ctrl_c():
    terminal = Terminal(WAITS)
    terminal.read(until='1')
    assert terminal.interrupt() == -signal.SIGINT
    assert 'KeyboardInterrupt' in terminal.text


def test_what_is_typed_into_a_shell_ends_with_ctrl_c_and_the_shell_stays():
    shell = Shell()

    def press_ctrl_c():
        wait_until((shell.home / 'ready').exists, 'the command to run', timeout_sec=30)
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=press_ctrl_c)
    thread.start()
    # In one process: a bash that waits for a program continues after Ctrl+C if that program ends with status 0.
    assert shell.run("bash -c ': > ready; exec sleep 60'", timeout_sec=50) == ''
    thread.join()
    assert shell.status == 128 + signal.SIGINT
    assert shell.run('echo and on') == 'and on'
    shell.close()
