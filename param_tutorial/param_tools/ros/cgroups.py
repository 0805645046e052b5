"""How far Linux holds this process back, where a container or a service may use only a part of the processors.

Such a quota belongs to a control group: in each period of a tenth of a second its processes run until the quota is
used up, and then stand still. Nothing in /proc/loadavg tells of that. See ``cpu.max`` and ``cpu.stat`` in the kernel's
cgroup-v2.rst, and ``cpu.cfs_quota_us`` in sched-bwc.rst for version 1.
"""

import contextlib
import time
from pathlib import Path

MEMBERSHIP = Path('/proc/self/cgroup')
MOUNTS = Path('/sys/fs/cgroup')
# Long enough for several periods.
_LOOK_PERIOD_SEC = 0.5


class Throttle:
    """How much slower the threads of this process are than without its quotas."""

    def __init__(self) -> None:
        self._looked = time.monotonic()
        self._stood_still = {folder: _stood_still_sec(folder) for folder in _quotas()}
        self._slowness = 1.0

    def __call__(self) -> float:
        """Return how many times slower a thread gets on, 1.0 if nothing holds it back; looks twice a second."""
        now = time.monotonic()
        took = now - self._looked
        if took >= _LOOK_PERIOD_SEC:
            quotas, before = _quotas(), self._stood_still
            self._looked, self._stood_still = now, {folder: _stood_still_sec(folder) for folder in quotas}
            # Where a thread has to stand still, its group is using all that it may use.
            self._slowness = 1.0 + max((max(0.0, seconds - before.get(folder, seconds)) / took / quotas[folder]
                                        for folder, seconds in self._stood_still.items()), default=0.0)
        return self._slowness


def _quotas() -> dict[Path, float]:
    """Return how many cores each control group may use that this process is in and that has a quota, by its folder."""
    folders = []
    with contextlib.suppress(OSError, ValueError):
        for line in MEMBERSHIP.read_text().splitlines():
            _, controllers, name = line.split(':', 2)
            if not controllers or 'cpu' in controllers.split(','):
                root = MOUNTS / controllers
                group = root / name.lstrip('/')
                # In a container the name may be the host's, and the root is the container's own group.
                folders += [each for each in (group, *group.parents) if each.is_relative_to(root)]
    return {folder: cores for folder in folders if (cores := _quota_cores(folder)) < float('inf')}


def _quota_cores(folder: Path) -> float:
    """Return how many cores a group may use, infinity if it has no quota."""
    with contextlib.suppress(OSError, ValueError, ZeroDivisionError):
        quota, period = (folder / 'cpu.max').read_text().split()
        return int(quota) / int(period)  # "max" is no number
    with contextlib.suppress(OSError, ValueError, ZeroDivisionError):
        quota, period = ((folder / f'cpu.cfs_{what}_us').read_text() for what in ('quota', 'period'))
        if int(quota) > 0:
            return int(quota) / int(period)
    return float('inf')


def _stood_still_sec(folder: Path) -> float:
    """Return for how long threads of a group have had to stand still, added up over the cores; in seconds."""
    with contextlib.suppress(OSError, ValueError):
        for line in (folder / 'cpu.stat').read_text().splitlines():
            name, number = line.split()
            if name in ('throttled_usec', 'throttled_time'):
                return int(number) / (1e6 if name == 'throttled_usec' else 1e9)
    return 0.0
