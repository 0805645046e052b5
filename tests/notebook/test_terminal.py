"""terminals: commands in processes of their own, and their end."""

import signal
import sys
from pathlib import Path

import psutil
import pytest

from param_tools.errors import WaitTimeoutError
from param_tools.ros import stage
from param_tutorial import ParameterClient, Terminal, wait_until
from tests.support.kernels import Kernel

OPEN_FILES = Path('/proc/self/fd')


def test_a_node_runs_is_reached_and_ends_in_good_order(ros):
    terminal = Terminal('ros2 run param_tutorial simple_param_node --ros-args -p max_speed_rpm:=7')
    assert terminal.read(until='max_speed_rpm').splitlines()[-1] == '[INFO] [simple_param_node]:   max_speed_rpm: 7'
    assert ParameterClient('/simple_param_node', timeout_sec=30).get_parameter('max_speed_rpm') == 7
    assert 'running' in repr(terminal)
    terminal.read(until='robot_serial_number')
    assert terminal.interrupt() == 0
    assert terminal.interrupt() == 0
    assert 'Traceback' not in terminal.text
    assert 'ended with status 0' in repr(terminal)


def test_a_command_reads_from_a_terminal_where_nobody_types():
    python = f'{sys.executable} -c'
    terminal = Terminal(f"""{python} 'import sys; print("typed:", sys.stdin.isatty(), flush=True); input()'""")
    assert terminal.read(until='typed') == 'typed: True'
    assert terminal.is_running
    before = len(list(OPEN_FILES.iterdir()))
    terminal.interrupt()
    assert 'EOFError' not in terminal.text
    wait_until(lambda: len(list(OPEN_FILES.iterdir())) < before, 'the terminal to be closed')


def test_output_that_does_not_come_is_an_error_that_shows_what_came():
    terminal = Terminal(f'"{sys.executable}" -c "print(1234)"')
    with pytest.raises(WaitTimeoutError, match=r"the command ended before a line with 'x'.*\n1234"):
        terminal.read(until='x')
    assert terminal.interrupt() == 0


def test_a_command_that_ignores_ctrl_c_is_killed():
    terminal = Terminal(
        f'"{sys.executable}" -c "import signal, time; signal.signal(2, signal.SIG_IGN); print(1); time.sleep(60)"')
    terminal.read(until='1')
    assert terminal.interrupt(timeout_sec=0.2) == -9
    assert not psutil.pid_exists(terminal._process.process.pid)


def test_a_new_start_ends_the_terminals_of_an_earlier_run(ros):
    lost = Terminal('ros2 run param_tutorial simple_param_node')
    lost.read(until='robot_serial_number')
    stage.start()
    assert not lost.is_running
    assert lost.interrupt() == 0


def test_a_cell_that_starts_a_command_again_ends_the_first():
    command = f'"{sys.executable}" -c "import time; print(1, flush=True); time.sleep(60)"'
    first, other = Terminal(command), Terminal(f'{command} other')
    for terminal in (first, other):
        terminal.read(until='1')
    again = Terminal(command)
    again.read(until='1')
    assert (first.is_running, other.is_running, again.is_running) == (False, True, True)
    # Left running, they would be missed by Python a minute later, in the middle of another test.
    assert (other.interrupt(), again.interrupt()) == (-signal.SIGINT, -signal.SIGINT)


PREPARED = '%load_ext param_tutorial\nfrom param_tutorial import Shell, Terminal\nshell = Shell()'
# What is typed into a cell; {ready} is the path of a file that is made once all is running.
STARTED = "{terminal}.read(until='robot_serial_number', timeout_sec=60)\nopen('{ready}', 'w').close()"
SLEEPS = 'sleep 1000 & touch {ready}; sleep 1000'


def end_by_killing(kernel, cell, ready):
    """Kill a kernel in which a cell runs; return what it had started."""
    def started():
        return psutil.Process(kernel.manager.provisioner.process.pid).children(recursive=True)

    try:
        kernel.run(PREPARED)
        before = started()
        kernel.client.execute(cell.format(ready=ready))
        wait_until(ready.exists, 'all to run', 60)
        children = started()
        assert len(children) > len(before) >= 1
    finally:
        kernel.kill()
    return children


@pytest.mark.parametrize('cell', [
    STARTED.replace('{terminal}', "Terminal('ros2 launch param_tutorial simple_param_launch.py')"),
    f'%%shell shell\n{SLEEPS}',
], ids=['launch', 'shell'])
def test_a_killed_kernel_leaves_no_process_behind(tmp_path, cell):
    children = end_by_killing(Kernel(), cell, tmp_path / 'ready')
    wait_until(lambda: not any(child.is_running() for child in children), 'the processes to end', 30)
