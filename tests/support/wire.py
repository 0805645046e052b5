"""A cable between two network interfaces that can be slow and lose packets: ``python -m tests.support.wire A B``.

The kernel's own way, ``tc netem``, is not in every kernel. So this process carries each frame over, later if the cable
is slow, or not at all. Its standard input says how slow and how lossy the cable is: a line with seconds and a share.
"""

import array
import fcntl
import heapq
import itertools
import os
import random
import selectors
import socket
import struct
import sys
import time

# linux/if_ether.h, linux/sockios.h and linux/ethtool.h
ETH_P_ALL = 0x0003
SIOCETHTOOL = 0x8946
ETHTOOL_STXCSUM = 0x00000017
PACKET_OUTGOING = 4


def _open_interface(name: str) -> socket.socket:
    interface = socket.socket(socket.AF_PACKET, socket.SOCK_RAW, socket.htons(ETH_P_ALL))
    interface.bind((name, ETH_P_ALL))
    interface.setblocking(False)
    return interface


def complete_checksums(name: str) -> None:
    """Have the kernel write checksums into what it sends here. Otherwise it leaves them to a network card, of which
    there is none, and the other side throws the packets away."""
    wish = array.array('B', struct.pack('II', ETHTOOL_STXCSUM, 0))
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as any_socket:
        fcntl.ioctl(any_socket, SIOCETHTOOL, struct.pack('16sP', name.encode(), wish.buffer_info()[0]))


def carry(first: str, second: str) -> None:
    """Carry frames between two interfaces until the standard input ends."""
    ends = _open_interface(first), _open_interface(second)
    selector = selectors.DefaultSelector()
    for end, other in (ends, ends[::-1]):
        selector.register(end, selectors.EVENT_READ, other)
    selector.register(sys.stdin.fileno(), selectors.EVENT_READ)
    on_the_way: list[tuple[float, int, socket.socket, bytes]] = []
    numbers, chance = itertools.count(), random.Random(1)
    delay_sec = loss = 0.0
    print('ready', flush=True)
    while True:
        wait = max(0.0, on_the_way[0][0] - time.monotonic()) if on_the_way else None
        for key, _ in selector.select(wait):
            if key.data is None:
                line = os.read(key.fd, 100).decode()
                if not line:
                    return
                delay_sec, loss = map(float, line.split())
                print('set', flush=True)
                continue
            try:
                frame, (*_, kind, _, _) = key.fileobj.recvfrom(65536)
            except OSError:  # the interface is down
                continue
            if kind != PACKET_OUTGOING and chance.random() >= loss:
                heapq.heappush(on_the_way, (time.monotonic() + delay_sec, next(numbers), key.data, frame))
        while on_the_way and on_the_way[0][0] <= time.monotonic():
            *_, target, frame = heapq.heappop(on_the_way)
            try:
                target.send(frame)
            except OSError:  # the interface is down, and a cable that is pulled out loses what is in it
                continue


if __name__ == '__main__':
    carry(*sys.argv[1:])
