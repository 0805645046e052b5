"""Which UDP ports are open on this machine, and which processes hold them, as Linux lists it in /proc. No ROS."""

import contextlib
import os
from collections.abc import Collection, Iterable
from pathlib import Path
from typing import NamedTuple

_MOST_LOOKS = 10


class UdpSocket(NamedTuple):
    """One that is bound to a port."""

    port: int
    inode: int
    """Its number in Linux; the links in /proc/<process>/fd contain it."""


def open_sockets() -> set[UdpSocket]:
    """Return the bound UDP sockets of this machine.

    Linux gives its table out in pages, and passes over a line if one before it goes between two pages: 16 of 817 looks
    missed a port while another process opened and closed some. Then the next look differs.
    """
    looks = [_listed()]
    while len(looks) < _MOST_LOOKS:
        looks.append(_listed())
        if looks[-1] == looks[-2]:
            return looks[-1]
    return set[UdpSocket]().union(*looks)


def _listed() -> set[UdpSocket]:
    """Return the sockets that one look at Linux's table finds."""
    found: set[UdpSocket] = set()
    for table in (Path('/proc/net/udp'), Path('/proc/net/udp6')):
        with contextlib.suppress(OSError, StopIteration), table.open() as lines:
            next(lines)
            for fields in map(str.split, lines):
                found.add(UdpSocket(int(fields[1].rpartition(':')[2], 16), int(fields[9])))
    return found


def processes() -> set[int]:
    """Return the numbers of the processes that this one can see (in a container, those in it); empty without /proc."""
    with contextlib.suppress(OSError):
        return {int(path.name) for path in Path('/proc').iterdir() if path.name.isdigit()}
    return set()


def is_numbered_as_here(process_id: int) -> bool:
    """True if this process can inspect another one, and both count processes alike: no container is between them."""
    with contextlib.suppress(OSError):
        return Path(f'/proc/{process_id}/ns/pid').readlink() == Path('/proc/self/ns/pid').readlink()
    return False


def held(sockets: Collection[UdpSocket], process_ids: Iterable[int]) -> set[int]:
    """Return the ports of those sockets that some processes hold.

    This process cannot see what another user's processes hold.
    """
    files = {name for process_id in process_ids for name in _open_files(process_id)}
    return {each.port for each in sockets if f'socket:[{each.inode}]' in files}


def _open_files(process_id: int) -> set[str]:
    """Return what the descriptors of a process link to; empty if it has ended or this process must not inspect it."""
    folder, names = f'/proc/{process_id}/fd', set[str]()
    with contextlib.suppress(OSError):
        # Path takes more than twice as long, and a wait for the graph looks up to a hundred times a second.
        for descriptor in os.listdir(folder):  # noqa: PTH208
            with contextlib.suppress(OSError):  # closed meanwhile
                names.add(os.readlink(f'{folder}/{descriptor}'))  # noqa: PTH115
    return names
