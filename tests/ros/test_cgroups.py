"""How far a container's quota of the processor holds a process back, as Linux tells it in files of either version."""

from pathlib import Path
from types import SimpleNamespace

import pytest

from param_tools.ros import cgroups


class Machine:
    """The files of a machine, and its time."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch):
        self.folder, self.now = folder, 0.0
        monkeypatch.setattr(cgroups, 'MEMBERSHIP', folder / 'membership')
        monkeypatch.setattr(cgroups, 'MOUNTS', folder)
        monkeypatch.setattr(cgroups, 'time', SimpleNamespace(monotonic=lambda: self.now))

    def write(self, files: dict[str, str]) -> None:
        """Write texts into files, by their paths."""
        for name, text in files.items():
            path = self.folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)


@pytest.fixture
def machine(tmp_path, monkeypatch):
    return Machine(tmp_path, monkeypatch)


def test_where_no_quota_holds_anything_back_nothing_is_slower(machine):
    assert cgroups.Throttle()() == 1.0  # no such files: not Linux
    machine.write({'membership': '0::/user.slice\n', 'user.slice/cpu.max': 'max 100000\n',
                   'user.slice/cpu.stat': 'usage_usec 5\nthrottled_usec 0\n'})
    throttle = cgroups.Throttle()
    machine.now += 2.0
    assert throttle() == 1.0


# Half a core: while two cores' threads want to run, each core stands still for three quarters of the time.
@pytest.mark.parametrize(('files', 'stat', 'still'), [
    ({'membership': '0::/a/b\n', 'a/b/cpu.max': '50000 100000\n'}, 'a/b/cpu.stat', 'throttled_usec {:.0f}'),
    # The quota is that of a group around its own.
    ({'membership': '0::/a/b\n', 'a/b/cpu.max': 'max 100000\n', 'a/cpu.max': '50000 100000\n'},
     'a/cpu.stat', 'throttled_usec {:.0f}'),
    # In a container, its own group stands where the host has the root, and the name is the host's.
    ({'membership': '5:cpu,cpuacct:/docker/c0ffee\n', 'cpu,cpuacct/cpu.cfs_quota_us': '50000\n',
      'cpu,cpuacct/cpu.cfs_period_us': '100000\n'}, 'cpu,cpuacct/cpu.stat', 'throttled_time {:.0f}000'),
])
def test_a_thread_that_stands_still_gets_on_more_slowly(machine, files, stat, still):
    machine.write({**files, stat: 'nr_throttled 1\n' + still.format(7e6)})
    throttle = cgroups.Throttle()
    machine.now += 2.0
    machine.write({stat: 'nr_throttled 9\n' + still.format(10e6)})
    assert throttle() == pytest.approx(4.0)
    # It is a matter of the last second or so.
    machine.now += 0.1
    assert throttle() == pytest.approx(4.0)
    machine.now += 2.0
    assert throttle() == 1.0


def test_files_that_nobody_expects_hold_nothing_back(machine):
    machine.write({'membership': 'nonsense\n0::/a\n', 'a/cpu.max': 'much\n'})
    assert cgroups.Throttle()() == 1.0
    machine.write({'membership': '0::/a\n', 'a/cpu.max': '50000 0\n', 'a/cpu.stat': 'throttled_usec soon\n'})
    assert cgroups.Throttle()() == 1.0
