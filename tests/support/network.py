"""Two hosts and a cable between them, on this machine: network namespaces, as the kernel has them.

    with Network(tmp_path) as network:
        robot = network.robot.python(ROS_DOMAIN_ID='42')
        robot.run('import param_tutorial')
        network.unplug()

Processes of one host have its interfaces, its loopback and its shared memory, and nothing of the other's.
"""

import ast
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from types import TracebackType

from tests.support.paths import ROOT, ROS_PACKAGE
from tests.support.processes import wait_or_kill

_PYTHON = '''
import ast, contextlib, json, sys
names = {'__name__': '__main__'}
for line in sys.stdin:
    source = json.loads(line)
    try:
        *before, last = ast.parse(source).body
        value = None
        with contextlib.redirect_stdout(sys.stderr):
            if not isinstance(last, ast.Expr):
                before, last = [*before, last], None
            exec(compile(ast.Module(before, []), 'test', 'exec'), names)
            if last is not None:
                value = eval(compile(ast.Expression(last.value), 'test', 'eval'), names)
        answer = {'value': 'None'}
        # Not for an object of some class.
        with contextlib.suppress(ValueError, SyntaxError):
            ast.literal_eval(repr(value))
            answer = {'value': repr(value)}
    except BaseException as error:
        answer = {'error': f'{type(error).__name__}: {error}'}
    print(json.dumps(answer), flush=True)
'''


def why_no_hosts() -> str | None:
    """Return why no hosts can be made here, or None."""
    if not shutil.which('ip'):
        return 'there is no command `ip`: apt install iproute2'
    if os.geteuid() != 0:
        return 'network namespaces need root'
    name = f'param-{os.getpid()}-try'
    done = subprocess.run(['ip', 'netns', 'add', name], capture_output=True, text=True)
    if done.returncode != 0:
        return f'ip netns add: {done.stderr.strip()}'
    # The namespace of a process that may change the network, but not mount, is made and can't be entered.
    done = subprocess.run(['ip', 'netns', 'exec', name, 'true'], capture_output=True, text=True)
    subprocess.run(['ip', 'netns', 'delete', name], check=True)
    return f'ip netns exec: {done.stderr.strip()}' if done.returncode != 0 else None


class Python:
    """A Python on a host, which runs statements on request, one after another."""

    def __init__(self, words: list[str], environment: dict[str, str], log: Path):
        self._log = log
        with log.open('w') as errors:
            self.process = subprocess.Popen(words, env=environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                            stderr=errors, text=True)

    def run(self, source: str) -> object:
        """Run these statements; return what the last one is, if it is an expression of plain Python values.

        :raises RuntimeError: it raised something, or ended.
        """
        self.process.stdin.write(json.dumps(source) + '\n')
        self.process.stdin.flush()
        line = self.process.stdout.readline()
        answer = json.loads(line) if line else {'error': 'the process has ended'}
        if 'error' in answer:
            raise RuntimeError(f'{answer["error"]}\n{self._log.read_text()}')
        return ast.literal_eval(answer['value'])

    def end(self) -> None:
        """End it."""
        self.process.stdin.close()
        wait_or_kill(self.process)
        self.process.stdout.close()


class Host:
    """One of the two hosts."""

    def __init__(self, name: str, address: str, folder: Path):
        self.name, self.address = name, address
        self._folder = folder
        self._shared_memory = folder / 'shm'
        self._shared_memory.mkdir(parents=True)
        self._pythons: list[Python] = []

    def command(self, *words: str | Path) -> list[str]:
        """Return the words that run a command on this host."""
        # What `ip netns exec` runs has mounts of its own.
        return ['ip', 'netns', 'exec', self.name, 'unshare', '--uts', '--', 'sh', '-c',
                'hostname "$0"; mount --bind "$1" /dev/shm; shift; exec "$@"',
                self.name, str(self._shared_memory), *map(str, words)]

    def environment(self, **variables: str) -> dict[str, str]:
        """Return the environment of a user who has set only these variables."""
        kept = {name: value for name, value in os.environ.items()
                if name == 'ROS_LOG_DIR' or not name.startswith(('ROS_', 'FASTRTPS_', 'RMW_', 'PYTEST'))}
        return {**kept, 'PYTHONPATH': os.pathsep.join([str(ROS_PACKAGE), str(ROOT)]), **variables}

    def python(self, **variables: str) -> Python:
        """Start a Python, which ends with the network."""
        log = self._folder / f'{len(self._pythons)}.log'
        self._pythons.append(Python(self.command(sys.executable, '-c', _PYTHON), self.environment(**variables), log))
        return self._pythons[-1]

    def end(self) -> None:
        """End what was started."""
        for python in self._pythons:
            python.end()


class Network:
    """Two hosts, ``laptop`` and ``robot``, and a cable between them."""

    def __init__(self, folder: Path):
        # Names of interfaces have at most 15 characters, and several tests may run at once.
        self._prefix = f'pt{os.getpid()}'
        self._cable = f'{self._prefix}-cable'
        self.laptop = Host(f'{self._prefix}-laptop', '10.77.0.1', folder / 'laptop')
        self.robot = Host(f'{self._prefix}-robot', '10.77.0.2', folder / 'robot')
        self._wire: subprocess.Popen[str] | None = None

    def __enter__(self) -> 'Network':
        try:
            self._ip('netns', 'add', self._cable)
            for number, host in enumerate((self.laptop, self.robot)):
                self._ip('netns', 'add', host.name)
                self._ip('link', 'add', 'eth0', 'netns', host.name, 'type', 'veth', 'peer', 'name', f'end{number}',
                         'netns', self._cable)
                self._ip('-n', host.name, 'address', 'add', f'{host.address}/24', 'dev', 'eth0')
                for interface in ('lo', 'eth0'):
                    self._ip('-n', host.name, 'link', 'set', interface, 'up')
                self._python_on(host.name, '-c', 'from tests.support.wire import complete_checksums as complete\n'
                                                 'complete("eth0")').communicate()
            self.plug()
            self._wire = self._python_on(self._cable, '-m', 'tests.support.wire', 'end0', 'end1')
            self._expect('ready')
        except BaseException:
            self.__exit__(None, None, None)
            raise
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 traceback: TracebackType | None) -> None:
        self.laptop.end()
        self.robot.end()
        if self._wire:
            self._wire.stdin.close()
            wait_or_kill(self._wire)
            self._wire.stdout.close()
        for name in (self.laptop.name, self.robot.name, self._cable):
            subprocess.run(['ip', 'netns', 'delete', name], capture_output=True)

    def plug(self) -> None:
        """Put the cable in."""
        for number in range(2):
            self._ip('-n', self._cable, 'link', 'set', f'end{number}', 'up')

    def unplug(self) -> None:
        """Pull the cable out, at both ends."""
        for number in range(2):
            self._ip('-n', self._cable, 'link', 'set', f'end{number}', 'down')

    def slow_down(self, delay_sec: float, loss: float) -> None:
        """Delay each packet by so much, and lose this share of them."""
        self._wire.stdin.write(f'{delay_sec} {loss}\n')
        self._wire.stdin.flush()
        self._expect('set')

    def _expect(self, word: str) -> None:
        said = self._wire.stdout.readline().strip()
        if said != word:
            raise RuntimeError(f'the cable says {said!r} and not {word!r}')

    def _python_on(self, name: str, *words: str) -> subprocess.Popen[str]:
        return subprocess.Popen(['ip', 'netns', 'exec', name, sys.executable, *words], cwd=ROOT, text=True,
                                stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    @staticmethod
    def _ip(*words: str) -> None:
        done = subprocess.run(['ip', *words], capture_output=True, text=True)
        if done.returncode != 0:
            raise RuntimeError(f'ip {" ".join(words)}: {done.stderr.strip()}')
