"""interrupts: Ctrl+C reaches what a notebook starts, also in a process that was itself started to ignore it."""

import os
import signal
import subprocess
import sys
import threading

import pytest

from param_tutorial import Shell, Terminal, wait_until
from param_tutorial.notebook.interrupts import handed_to, interruptible

WAITS = f'"{sys.executable}" -c "import signal; print(1, flush=True); signal.pause()"'


@pytest.fixture(autouse=True)
def ignores_ctrl_c():
    """Ignore SIGINT, as a process does that nohup or a shell's background job has started."""
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    yield
    assert signal.getsignal(signal.SIGINT) is signal.SIG_IGN
    signal.signal(signal.SIGINT, before)


@pytest.fixture
def press_ctrl_c_when():
    """Return a function that interrupts this process as soon as a file exists."""
    threads = []

    def when_exists(path):
        def press():
            wait_until(path.exists, f'{path}', timeout_sec=30)
            os.kill(os.getpid(), signal.SIGINT)

        threads.append(threading.Thread(target=press))
        threads[0].start()

    yield when_exists
    threads[0].join()


def test_a_terminals_command_ends_with_ctrl_c():
    terminal = Terminal(WAITS)
    terminal.read(until='1')
    assert terminal.interrupt() == -signal.SIGINT
    assert 'KeyboardInterrupt' in terminal.text


def test_what_is_typed_into_a_shell_ends_with_ctrl_c_and_the_shell_stays(press_ctrl_c_when):
    shell = Shell()
    press_ctrl_c_when(shell.home / 'ready')
    # In one process: a bash that waits for a program continues after Ctrl+C if that program ends with status 0.
    assert shell.run("bash -c ': > ready; exec sleep 60'", timeout_sec=50) == ''
    assert shell.status == 128 + signal.SIGINT
    assert shell.run('echo and on') == 'and on'
    shell.close()


def test_python_itself_is_interrupted():
    with pytest.raises(KeyboardInterrupt), interruptible():
        signal.raise_signal(signal.SIGINT)


@pytest.mark.parametrize('ended', [False, True])
def test_what_is_handed_on_raises_nothing_here(ended):
    with interruptible():
        child = subprocess.Popen(['sleep', '60'], start_new_session=True)
    if ended:
        child.kill()
        child.wait()
    with handed_to(child.pid):
        signal.raise_signal(signal.SIGINT)
    assert child.wait() == -(signal.SIGKILL if ended else signal.SIGINT)


@pytest.mark.parametrize('context', [interruptible, lambda: handed_to(os.getpid())])
def test_in_another_thread_nothing_changes(context):
    found = []

    def look():
        with context():
            found.append(signal.getsignal(signal.SIGINT))

    thread = threading.Thread(target=look)
    thread.start()
    thread.join()
    assert found == [signal.SIG_IGN]
