"""A bash beside a notebook, in which one command is typed after the other: ``%%shell``.

``%ros2`` runs one command and forgets it. Building a workspace needs more: a folder that stays the current one, and
``source``, which changes the environment of what is typed later. No Jupyter here; the magic is in ``magics``.
"""

import asyncio
import os
import re
import secrets
import selectors
import shlex
import signal
import subprocess
import sys
import time
import weakref
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory, mkdtemp

from param_tools.cli.command import process_words
from param_tools.errors import ParameterToolError
from param_tools.ros import domain, host
from param_tools.ros.processes import Guard
from param_tutorial.notebook.interrupts import handed_to, interruptible

# The learner's own settings would change what commands do and print: git's name and address, colcon's defaults, how
# nodes log, and what has been built and sourced before.
_NOT_PASSED_ON = re.compile(
    r'^(PYTHON.*|GIT_.*|COLCON_.*|(AMENT|CMAKE)_PREFIX_PATH|RCUTILS_.*|BASH_ENV|ENV|BASH_FUNC_.*|PROMPT_COMMAND|PS[0-4])$')
_LOOK_PERIOD_SEC = 0.1
NO_SHELL = 'there is no shell in a web page'
# [0.52s] after a package, [0.523s] before a warning (on 3.13 a negative number), and [0.52s, exited with code 1].
_SECONDS = r'-?(?:\d+min )?\d+(?:\.\d+)?s'
_TIME_TAKEN = re.compile(rf'^\[{_SECONDS}\] | \[{_SECONDS}\]$|(?<=\[){_SECONDS}, ', re.MULTILINE)


class Shell:
    """A real bash, in a home folder that is not the user's.

    >>> shell = Shell()                        # doctest: +SKIP
    >>> print(shell.run('mkdir src; ls'))      # doctest: +SKIP
    src

    Commands are the real ones; the one thing that is lent is ``ros2``. Two things are
    left out of what is shown, because they differ each time: the home folder's name, for which ``~`` stands, and
    the seconds that colcon took. A command that goes on until Ctrl+C belongs in a ``Terminal``.
    """

    def __init__(self, beside: 'Shell | None' = None, home: Path | None = None):
        """Start a bash, in the ROS domain of this process.

        :param beside: Share this shell's home folder, as a second terminal does, and nothing else.
        :param home: The home folder, which stays; by default a new one, which goes when the shell is closed.
        :raises FileNotFoundError: there is no bash.
        """
        domain.choose()
        self._beside = beside  # so that the home folder stays as long as anybody lives in it
        folder = None
        if beside:
            home = beside.home
        elif home is None:
            folder = TemporaryDirectory(prefix='param_tutorial_', ignore_cleanup_errors=True)
            home = Path(folder.name)
        self.home: Path = home.resolve()
        """The home folder."""
        self.status = 0
        """The exit status of the last command."""
        self._process: subprocess.Popen[bytes] | None = None
        if not host.host.has_processes:
            self._close: Callable[[], object] = weakref.finalize(self, _remove, folder)
            return
        self._programs, colcon = _programs_without_space(self.home)
        with interruptible():
            # What is running when this process is killed would go on.
            guard = Guard()
            self._process = bash = subprocess.Popen(
                ['bash', '--noprofile', '--norc'], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT, cwd=self.home, env=self._first_environment(),
                start_new_session=True)
            guard.watch(bash.pid)
        # Also when a cell that makes a shell runs again, and when the kernel ends.
        self._close = weakref.finalize(self, _close, bash, guard, folder)
        assert bash.stdin and bash.stdout  # both are pipes
        self._input, self._output = bash.stdin, bash.stdout
        os.set_blocking(self._output.fileno(), False)
        # Ctrl+C ends the command and not the shell.
        self.run('trap : INT')
        self.run(f'ros2() {{ {shlex.join(process_words())} "$@"; }}')
        if colcon:
            self.run(f'colcon() {{ {colcon} "$@"; }}')

    def _first_environment(self) -> dict[str, str]:
        passed_on = {name: value for name, value in os.environ.items() if not _NOT_PASSED_ON.match(name)}
        # Where colcon was installed with this Python: first, so that the nodes that it builds find this Python's rclpy.
        passed_on['PATH'] = os.pathsep.join([str(self._programs), passed_on.get('PATH', os.defpath)])
        # As on a machine on which nothing has been built yet, `ros2 run` finds no package. A package that `ros2 pkg
        # create` has written has the option tests_require, of which only setuptools newer than Jazzy's complain.
        return {**passed_on, 'PARAM_TOOLS_PROVIDED': '0', 'PYTHONWARNINGS': 'ignore:Unknown distribution option',
                'HOME': str(self.home), 'USER': 'learner', 'LOGNAME': 'learner', 'LC_ALL': 'C.UTF-8',
                'GIT_CONFIG_NOSYSTEM': '1', 'PYTHONUNBUFFERED': '1'}

    def __repr__(self) -> str:
        if self._process is None:
            return f'<Shell: {NO_SHELL}>'
        return f'<Shell: {"running" if self._process.poll() is None else "closed"}>'

    def run(self, commands: str, timeout_sec: float = 120.0) -> str:
        """Type one or more lines, wait until they have been done, and return what was printed.

        :raises ParameterToolError: the shell is closed, or they were not done in time, or ended it; the message shows
            what came.
        """
        output, self.status = self._type(commands, timeout_sec)
        return self._stable(output)

    async def run_awaited(self, commands: str) -> str:
        """Do what ``run`` says, and let the event loop of this thread go on meanwhile.

        :raises ParameterToolError: as ``run``.
        """
        # A signal comes to the main thread only, and there it would cancel the cell.
        with handed_to(self._bash.pid):
            return await asyncio.to_thread(self.run, commands)

    @property
    def can_run(self) -> bool:
        """False where there are no processes, and so no bash; then every command is an error that says so."""
        return self._process is not None

    @property
    def _bash(self) -> subprocess.Popen[bytes]:
        if self._process is None:
            raise ParameterToolError(NO_SHELL)
        return self._process

    def _type(self, commands: str, timeout_sec: float = 120.0) -> tuple[str, int]:
        """Do what ``run`` says, and return what was printed, unchanged, and the exit status."""
        if self._bash.poll() is not None:
            raise ParameterToolError('this shell is closed: start a new one with Shell()')
        mark = secrets.token_hex(8)
        # One `eval`, so that a quote that is never closed is an error here and does not swallow what is typed later;
        # without a standard input, so that no command waits for one.
        line = f'eval {shlex.quote(commands)} </dev/null; printf "\\n{mark} %d\\n" $?\n'
        deadline = time.monotonic() + timeout_sec
        end = re.compile(rf'\n{mark} (\d+)\n'.encode())
        output = b''
        with handed_to(self._bash.pid), selectors.DefaultSelector() as selector:
            selector.register(self._output, selectors.EVENT_READ)
            self._input.write(line.encode())
            self._input.flush()
            while not (found := end.search(output)):
                ready = selector.select(_LOOK_PERIOD_SEC)
                if not ready and time.monotonic() < deadline:
                    continue
                chunk = os.read(self._output.fileno(), 65536) if ready else b''
                if not chunk:
                    why = 'ended the shell' if ready else f'was not done within {timeout_sec:g} s'
                    what_came = self._stable(output.decode(errors='replace')) or '(nothing)'
                    self.close()
                    raise ParameterToolError(f'{commands.strip()!r} {why}; what came:\n{what_came}')
                output += chunk
        return output[:found.start()].decode(errors='replace'), int(found[1])

    def _stable(self, output: str) -> str:
        """Leave out of an output what differs each time."""
        output = output.replace(str(self.home), '~')
        output = re.sub(r'^bash: line \d+: ', 'bash: ', output, flags=re.MULTILINE)
        return _TIME_TAKEN.sub('', output).rstrip('\n')

    def environment(self) -> dict[str, str]:
        """Return the environment of a program that starts here now."""
        entries, _ = self._type('env -0')
        return dict(entry.split('=', 1) for entry in entries.split('\0') if '=' in entry)

    def folder(self) -> Path:
        """Return the current folder."""
        return Path(self._type('printf %s "$PWD"')[0])

    def close(self) -> None:
        """End the shell, and remove its home folder if it is its own; safe to call more than once."""
        self._close()


def _programs_without_space(home: Path) -> tuple[Path, str]:
    """Return the folder of this Python's programs, and the words that start colcon there if its own program won't do.

    What colcon builds is started by a first line that names Python, and Linux ends a name there at the first space. So
    where .venv lies below a folder with one in its name, it gets another path.
    """
    programs = Path(sys.executable).parent
    if not re.search(r'\s', str(programs)):
        return programs, ''
    link = Path(mkdtemp() if re.search(r'\s', str(home)) else home, '.python')
    link.unlink(missing_ok=True)
    link.symlink_to(programs.parent)
    program = 'import sys; from colcon_core.command import main; sys.exit(main())'
    return link / programs.name, shlex.join([str(link / programs.name / 'python'), '-c', program])


def _close(process: subprocess.Popen[bytes], guard: Guard, folder: TemporaryDirectory[str] | None) -> None:
    assert process.stdin and process.stdout  # both are pipes
    process.stdin.close()  # bash ends with its input
    try:
        process.wait(1.0)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGTERM)
        process.wait(10.0)
    guard.dismiss()
    process.stdout.close()
    _remove(folder)


def _remove(folder: TemporaryDirectory[str] | None) -> None:
    if folder is not None:
        folder.cleanup()
