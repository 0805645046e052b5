"""Two hosts, which are network namespaces of this machine.

Processes of one have its interfaces, its loopback and its shared memory, and nothing of the other's.
"""

import contextlib
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.support import missing
from tests.support.paths import ROOT
from tests.support.processes import wait_or_kill


def ip(*words: str) -> None:
    subprocess.run(['ip', *words], check=True, capture_output=True, text=True)


class Host:
    """A host with one Ethernet interface."""

    def __init__(self, name: str, address: str, folder: Path):
        # Several tests may run at once.
        self.name, self.address = f'pt{os.getpid()}-{name}', address
        self._shared_memory = folder / name
        self._shared_memory.mkdir()
        self._started: list[subprocess.Popen[str]] = []
        ip('netns', 'add', self.name)
        ip('-n', self.name, 'link', 'set', 'lo', 'up')

    def command(self, *words: str | Path) -> list[str]:
        """Return the words that run a command on this host; what `ip netns exec` runs has mounts of its own."""
        return ['ip', 'netns', 'exec', self.name, 'sh', '-c', 'mount --bind "$0" /dev/shm; exec "$@"',
                str(self._shared_memory), *map(str, words)]

    def environment(self, **variables: str) -> dict[str, str]:
        """Return the environment of a user who has set only these variables."""
        return variables | {name: value for name, value in os.environ.items() if name == 'ROS_LOG_DIR'
                            or not name.startswith(('ROS_', 'FASTRTPS_', 'RMW_', 'PYTEST'))}

    def run(self, *words: str | Path, **variables: str) -> str:
        """Return what a command prints here, errors included."""
        return subprocess.run(self.command(*words), env=self.environment(**variables), cwd=ROOT, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT).stdout.strip()

    def start(self, *words: str | Path, **variables: str) -> subprocess.Popen[str]:
        """Start Python with these words; it ends with the host."""
        self._started.append(subprocess.Popen(
            self.command(sys.executable, *words), env=self.environment(**variables), cwd=ROOT, text=True,
            stdin=subprocess.PIPE, stdout=subprocess.PIPE))
        return self._started[-1]

    def end(self) -> None:
        for process in self._started:
            process.stdin.close()
            wait_or_kill(process)
            process.stdout.close()
        ip('netns', 'delete', self.name)


def why_no_hosts() -> str | None:
    """Return why no hosts can be made here, or None."""
    try:
        done = subprocess.run(['unshare', '--net', '--mount', 'ip', 'link'], capture_output=True, text=True)
    except FileNotFoundError as error:
        return str(error)
    return done.stderr.strip() or None


@pytest.fixture
def hosts(tmp_path: Path) -> Iterator[tuple[Host, Host]]:
    """Yield a robot and a laptop that share a network."""
    if why := why_no_hosts():
        missing.skip(f'two hosts need root and iproute2: {why}')
    with contextlib.ExitStack() as stack:
        hosts = Host('robot', '10.77.0.2', tmp_path), Host('laptop', '10.77.0.1', tmp_path)
        robot, laptop = hosts
        for host in hosts:
            stack.callback(host.end)
        ip('link', 'add', 'eth0', 'netns', robot.name, 'type', 'veth', 'peer', 'name', 'eth0', 'netns', laptop.name)
        for host in hosts:
            ip('-n', host.name, 'address', 'add', f'{host.address}/24', 'dev', 'eth0')
            ip('-n', host.name, 'link', 'set', 'eth0', 'up')
        yield hosts
