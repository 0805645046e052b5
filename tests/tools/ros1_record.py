"""Ask the real ROS 1 what stands in ros1_recording.txt, and write down what it says.

    apt-get install --no-install-recommends python3-rosmaster python3-rosparam python3-rospy python3-dynamic-reconfigure
    /usr/bin/python3 tests/tools/ros1_record.py            writes each answer in the recording anew
    /usr/bin/python3 tests/tools/ros1_record.py --check    changes nothing; status 1 and the differences if ROS 1 says
                                                           something else, 2 if it cannot be asked

ROS 1 has come to its end, but Debian has kept it. Its Python half is enough here: the master with its parameter
server, rospy, rosparam and dynamic_reconfigure. This file runs under Debian's own Python, which can import the one
module of the course that reads the recording. What is typed there goes to the master, to real nodes (one process each)
or to a shell, all of them on the loopback device.
"""

import argparse
import ast
import contextlib
import difflib
import importlib.util
import io
import multiprocessing
import os
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time
import traceback
from collections.abc import Callable, Mapping
from dataclasses import replace
from multiprocessing.connection import Connection
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / 'param_tutorial'))

from param_tutorial.views.drawing.ros1 import RECORDING, Step, parse

PACKAGES = ('python3-rosmaster', 'python3-rosparam', 'python3-rospy', 'python3-dynamic-reconfigure')
TIME_LIMIT_SEC = 20.0
# How long a node is given while the master is frozen. It will not answer, so a longer wait proves no more.
FROZEN_LIMIT_SEC = 0.5
NO_ANSWER = '(no answer)'
# An address on the loopback device for this process alone. So the master always gets the port that is ROS 1's own,
# which, other than one that the system chooses, is not lent to somebody else before the master starts again.
ADDRESS = f'127.{os.getpid() >> 16}.{os.getpid() >> 8 & 255}.{os.getpid() & 255}'
PORT = 11311

# The steps of each scene, by its name.
Scenes = Mapping[str, tuple[Step, ...]]


def render(head: str, scenes: Scenes) -> str:
    """Write a recording, as ``parse`` reads it."""
    parts = [head]
    for name, steps in scenes.items():
        lines = [f'== {name}']
        for step in steps:
            first, *more = step.typed.split('\n')
            lines += [f'{step.prompt} {first}', *(f'... {line}'.rstrip() for line in more)]
            lines += [step.answer] * bool(step.answer)
        parts.append('\n'.join(lines))
    return '\n\n'.join(parts) + '\n'


# -- the processes of a ROS 1 system ------------------------------------------------------------------------------

# The names that what is typed may use.
Space = dict[str, Any]
# Does with what was typed what a process is asked to do, and returns what came of it.
Work = Callable[[Space, str], str]


class RecordingError(Exception):
    """Something could not be asked; the message says what."""


def _answer(space: Space, typed: str) -> str:
    """Do what was typed, and return what a Python prompt would have printed."""
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        try:
            tree = ast.parse(typed)
            last = tree.body[-1]
            if not isinstance(last, ast.Expr):
                exec(compile(tree, 'typed', 'exec'), space)
            else:
                exec(compile(ast.Module(tree.body[:-1], []), 'typed', 'exec'), space)
                value = eval(compile(ast.Expression(last.value), 'typed', 'eval'), space)
                if value is not None:
                    print(repr(value))
        except Exception as error:
            print(traceback.format_exception_only(error)[-1].strip())
    return printed.getvalue().rstrip()


def _wait(space: Space, condition: str) -> str:
    while not eval(condition, space):
        time.sleep(0.01)
    return ''


def _serve(connection: Connection, space: Space) -> None:
    """Do what comes through a pipe until its other end is closed."""
    def work(number: int, do: Work, typed: str) -> None:
        connection.send((number, do(space, typed)))

    with contextlib.suppress(EOFError):
        while True:
            # In a thread of its own, which makes its own connection to the master: one that hangs keeps nobody else.
            threading.Thread(target=work, args=connection.recv(), daemon=True).start()


def _master(connection: Connection) -> None:
    import rosmaster.master

    _quiet()
    master = rosmaster.master.Master(PORT)
    master.start()
    connection.send((0, 'ready'))
    _serve(connection, {'master': master, 'rosmaster': rosmaster})


def _node(connection: Connection, name: str) -> None:
    namespace, _, name = name.rpartition('/')
    os.environ['ROS_NAMESPACE'] = namespace or '/'  # which rospy reads when it is imported
    import rospy

    _quiet()
    sys.argv = [name, '', '', '', '']  # dynamic_reconfigure's generator insists on the four words that catkin gives it
    rospy.init_node(name)
    connection.send((0, 'ready'))
    _serve(connection, {'rospy': rospy, 'compiled': _compiled})


def _compiled(generator: Any) -> SimpleNamespace:
    """Return for a ParameterGenerator what catkin makes of a .cfg file at build time: a module that a Server takes."""
    from dynamic_reconfigure.encoding import extract_params

    description = generator.group.to_dict()
    return SimpleNamespace(config_description=description, **{
        ours: {each['name']: each[theirs] for each in extract_params(description)}
        for ours, theirs in (('defaults', 'default'), ('min', 'min'), ('max', 'max'), ('level', 'level'))})


def _quiet() -> None:
    """Keep the console to the recorder, and Ctrl+C too, which ends the others in order."""
    with Path(os.devnull).open('w') as nowhere:
        os.dup2(nowhere.fileno(), 1)
        os.dup2(nowhere.fileno(), 2)
    signal.signal(signal.SIGINT, signal.SIG_IGN)


class _Process:
    """A master or a node, in a process of its own."""

    def __init__(self, function: Callable[..., None], *arguments: str):
        context = multiprocessing.get_context('fork')
        self._connection, other = context.Pipe()
        self.process = context.Process(target=function, args=(other, *arguments), daemon=True)
        self.process.start()
        self._pid = cast(int, self.process.pid)  # None only before the start
        other.close()
        self._asked = 0
        if self._receive(TIME_LIMIT_SEC) is None:
            self.kill()
            raise RecordingError(f'a ROS 1 process was not ready after {TIME_LIMIT_SEC:g} s')

    def ask(self, do: Work, typed: str, limit_sec: float = TIME_LIMIT_SEC) -> str | None:
        """Let it do something with what was typed; None if there is no answer in time."""
        self._asked += 1
        self._connection.send((self._asked, do, typed))
        return self._receive(limit_sec)

    def _receive(self, limit_sec: float) -> str | None:
        deadline = time.monotonic() + limit_sec
        while self._connection.poll(max(0.0, deadline - time.monotonic())):
            try:
                reply: tuple[int, str] = self._connection.recv()
            except EOFError:
                raise RecordingError('a ROS 1 process ended before it had answered') from None
            number, answer = reply
            if number == self._asked:  # and not what a question from before the thaw has led to
                return answer
        return None

    def freeze(self) -> None:
        os.kill(self._pid, signal.SIGSTOP)
        os.waitpid(self._pid, os.WUNTRACED)  # it may go on for a moment after the signal

    def thaw(self) -> None:
        os.kill(self._pid, signal.SIGCONT)

    def kill(self) -> None:
        self.process.kill()
        self.process.join()
        self._connection.close()


class System:
    """A master, and a node for each name that is used; a folder for files."""

    def __init__(self, folder: str):
        self.folder = folder
        self.nodes: dict[str, _Process] = {}
        self.frozen = False
        self.master = _Process(_master)

    def node(self, name: str) -> _Process:
        if name not in self.nodes:
            self.nodes[name] = _Process(_node, name)
        return self.nodes[name]

    def ask(self, step: Step) -> str:
        """Do one step, and return what came of it."""
        limit_sec = FROZEN_LIMIT_SEC if self.frozen else TIME_LIMIT_SEC
        if step.prompt == '$':
            done = subprocess.run(step.typed, shell=True, cwd=self.folder, timeout=TIME_LIMIT_SEC,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            lines = done.stdout.rstrip().splitlines()
            return lines[-1] if 'Traceback (most recent call last):' in lines else '\n'.join(lines)
        if step.prompt == '!':
            return self.act(step.typed)
        name = step.prompt.removesuffix('>>>')
        process = self.master if name == 'master' else self.node(name)
        answer = process.ask(_answer, step.typed, limit_sec)
        if answer is None and not self.frozen:
            raise RecordingError(f'{name} has not answered within {limit_sec:g} s: {step.typed}')
        return NO_ANSWER if answer is None else answer

    def act(self, action: str) -> str:
        """Do what an event says: these six, and nothing else."""
        if match := re.fullmatch(r'(\S+) waits until (.*)', action):
            if self.node(match[1]).ask(_wait, match[2]) is None:
                raise RecordingError(f'timed out after {TIME_LIMIT_SEC:g} s waiting until {match[2]}')
        elif match := re.fullmatch(r'(/\S+) is killed', action):
            self.nodes.pop(match[1]).kill()
        elif action == 'the master is killed':
            self.master.kill()
        elif action == 'the master starts again':
            self.master = _Process(_master)
        elif action == 'the master is held up':
            self.master.freeze()
            self.frozen = True
        elif action == 'the master goes on':
            self.master.thaw()
            self.frozen = False
        else:
            raise RecordingError(f'{action!r} is no event that this recorder knows')
        return ''

    def end(self) -> None:
        for process in [*self.nodes.values(), self.master]:
            process.kill()


def _set_environment(folder: str) -> None:
    """Keep ROS 1 off the network, and its logs in a folder."""
    os.environ.update(ROS_IP=ADDRESS, ROS_MASTER_URI=f'http://{ADDRESS}:{PORT}', ROS_HOME=folder, ROS_LOG_DIR=folder,
                      PYTHONWARNINGS='ignore')
    for name in ('ROS_HOSTNAME', 'ROS_NAMESPACE', 'ROS_PACKAGE_PATH', 'PYTHONPATH'):
        os.environ.pop(name, None)


def record(scenes: Scenes) -> Scenes:
    """Do every step of every scene, and return them with the answers of now."""
    recorded = {}
    for name, steps in scenes.items():
        with tempfile.TemporaryDirectory() as folder:
            _set_environment(folder)
            system = System(folder)
            try:
                recorded[name] = tuple(replace(step, answer=system.ask(step)) for step in steps)
            except RecordingError as error:
                raise RecordingError(f'in the scene "{name}": {error}') from None
            finally:
                system.end()
    return recorded


def main() -> int:
    """Write the recording anew, or compare."""
    parser = argparse.ArgumentParser(description='Ask the real ROS 1 what stands in ros1_recording.txt.')
    parser.add_argument('--check', action='store_true', help='compare, and change nothing')
    parser.add_argument('recording', nargs='?', type=Path, default=RECORDING, help='by default that of the course')
    arguments = parser.parse_args()
    modules = {name: name.removeprefix('python3-').replace('-', '_') for name in PACKAGES}
    missing = [name for name, module in modules.items() if not importlib.util.find_spec(module)]
    if missing:
        print(f'{sys.executable} finds no {" and no ".join(missing)}. This needs what Debian has kept of ROS 1, and '
              f'Debian’s own Python:\n\n    apt-get install --no-install-recommends {" ".join(PACKAGES)}\n'
              f'    /usr/bin/python3 {os.path.relpath(__file__)}', file=sys.stderr)
        return 2
    before = arguments.recording.read_text(encoding='utf-8')
    head, scenes = parse(before)
    try:
        after = render(head, record(scenes))
    except RecordingError as error:
        print(error, file=sys.stderr)
        return 2
    if not arguments.check:
        arguments.recording.write_text(after, encoding='utf-8')
        return 0
    sys.stdout.writelines(difflib.unified_diff(
        before.splitlines(keepends=True), after.splitlines(keepends=True), 'recorded', 'ROS 1, now'))
    return int(before != after)


if __name__ == '__main__':
    sys.exit(main())
