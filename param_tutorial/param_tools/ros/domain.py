"""A ROS domain for each process, so that two learners on one machine do not meet. No ROS, no Jupyter.

DDS keeps domains apart by UDP port numbers. Nothing in ROS hands domains out: processes that use the same
number are in the same graph, and two nodes of one name in one graph may both obey a ``param set``.
"""

import os
import socket
from pathlib import Path

from param_tools.errors import ExecutorError
from param_tools.ros import environment

# Above 101 the ports of a domain reach into Linux's ephemeral range, and 0 is what everybody else is in.
DOMAIN_IDS = range(1, 102)

_ANY_NETWORK = Path(__file__).with_name('fastdds.xml')
_THIS_HOST = Path(__file__).with_name('fastdds_this_host.xml')
# Domain, and the file descriptor that holds its claim. A socket object would complain at exit that it was left open.
_claim: tuple[int, int] | None = None


def choose() -> int:
    """Return the ROS domain of this process and put it into its environment.

    The domain that the user chose with ROS_DOMAIN_ID, on the network that the user chose; otherwise one that no other
    process on this machine has claimed, limited to this host, and without the settings that are for a network.
    Processes that this one starts inherit both, so that ``ros2`` in a subprocess finds the same nodes. Asking again
    gives the same answer.

    :raises ExecutorError: ROS_DOMAIN_ID is no domain, or all domains are taken.
    """
    global _claim
    chosen = os.environ.get('ROS_DOMAIN_ID')
    if _claim is not None and chosen == str(_claim[0]):
        return _claim[0]
    if not chosen:
        environment.drop_networks()
    # Fast DDS 2.14 knows this name only; from 3.0 on it is FASTDDS_DEFAULT_PROFILES_FILE.
    if not os.environ.get('FASTRTPS_DEFAULT_PROFILES_FILE'):
        own_network = chosen or os.environ.get('ROS_AUTOMATIC_DISCOVERY_RANGE')
        os.environ['FASTRTPS_DEFAULT_PROFILES_FILE'] = str(_ANY_NETWORK if own_network else _THIS_HOST)
    if chosen:
        if not (chosen.isascii() and chosen.isdigit() and int(chosen) <= 232):
            raise ExecutorError(f'ROS_DOMAIN_ID is {chosen!r}: it must be an integer from 0 to 232, or unset')
        return int(chosen)
    if _claim is None:
        _claim = _claim_free_domain()
    os.environ['ROS_DOMAIN_ID'] = str(_claim[0])
    # LOCALHOST would listen on all interfaces, and add shared memory to whatever a profile says.
    os.environ.setdefault('ROS_AUTOMATIC_DISCOVERY_RANGE', 'SYSTEM_DEFAULT' if _on_loopback() else 'LOCALHOST')
    return _claim[0]


def settings() -> dict[str, str]:
    """Return what lets another process join the ROS domain of this one: variables of the environment."""
    names = ('ROS_DOMAIN_ID', 'ROS_AUTOMATIC_DISCOVERY_RANGE', 'FASTRTPS_DEFAULT_PROFILES_FILE')
    return {name: os.environ[name] for name in names if name in os.environ}


def is_limited_to_this_host() -> bool:
    """True if discovery leaves other machines alone, as the environment of this process has it."""
    if os.environ.get('ROS_LOCALHOST_ONLY') == '1':  # rcl then ignores the others
        return True
    if os.environ.get('ROS_STATIC_PEERS'):
        return False
    discovery_range = os.environ.get('ROS_AUTOMATIC_DISCOVERY_RANGE', '').upper()
    return discovery_range in ('LOCALHOST', 'OFF') or (discovery_range == 'SYSTEM_DEFAULT' and _on_loopback())


def reaches_other_hosts() -> bool:
    """True if this process has its domain, and it is not limited to this host."""
    return bool(os.environ.get('ROS_DOMAIN_ID')) and not is_limited_to_this_host()


def _on_loopback() -> bool:
    """True if the profile is that of this host: this package's, or that of a copy of it, which has another path."""
    return Path(os.environ.get('FASTRTPS_DEFAULT_PROFILES_FILE', '')).name == _THIS_HOST.name


def _claim_free_domain() -> tuple[int, int]:
    """Claim the first free domain for as long as this process lives.

    The claim is a name in Linux's abstract socket namespace: it can be bound once on a machine, and is free
    again the moment its process ends, however it ends. Nothing is left on the disk to clean up.
    """
    # Starting at different places spares most processes the walk over the domains that are taken.
    start = os.getpid() % len(DOMAIN_IDS)
    for domain_id in [*DOMAIN_IDS[start:], *DOMAIN_IDS[:start]]:
        claim = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
        try:
            claim.bind(f'\0param_tools/ros_domain/{domain_id}')
        except OSError:
            claim.close()
            continue
        # A program that knows nothing of claims, or a node that has outlived the kernel that started it.
        if _is_used(domain_id):
            claim.close()
            continue
        return domain_id, claim.detach()
    raise ExecutorError(f'all ROS domains from {DOMAIN_IDS[0]} to {DOMAIN_IDS[-1]} are in use on this machine: shut '
                        f'down kernels that are no longer needed, or set ROS_DOMAIN_ID to share one of them')


def _is_used(domain_id: int) -> bool:
    """True if a participant of a domain listens on this machine.

    Participant number n of a domain listens on port 7400 + 250 * domain + 10 + 2 * n (RTPS specification, 9.6.1.1).
    Linux lists the open ports in /proc/net/udp; where there is no such file, no domain counts as used.
    """
    first = 7400 + 250 * domain_id + 10
    try:
        lines = Path('/proc/net/udp').read_text().splitlines()[1:]
    except OSError:
        return False
    return any(int(line.split()[1].rpartition(':')[2], 16) in range(first, first + 240, 2) for line in lines)
