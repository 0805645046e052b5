"""Run the whole suite with the processor taken away. `make test-starved` runs this.

    python -m tests.tools.starved [--runs 5] [--at-once 3] [--cores 0.5] [--busy 8]

Each run is `make test-all` in a fresh clone of what is committed, in a control group that may use half a core, beside
processes that never rest. Those are in a group of their own, with little weight, or they would leave less than half a
core to the suite. What a run printed is kept in build/starved/. Other arguments go to pytest. It takes Linux, root's
rights, and on two cores some 45 minutes for three at once. The exit status is 1 if any run was red.
"""

import argparse
import contextlib
import os
import shlex
import shutil
import subprocess
import sys
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from tests.support.paths import ROOT

FOLDER = ROOT / 'build' / 'starved'
PERIOD_USEC = 100_000
# The controller of version 1, where it is mounted; else the groups of version 2.
VERSION_1, VERSION_2 = Path('/sys/fs/cgroup/cpu'), Path('/sys/fs/cgroup')


@contextlib.contextmanager
def control_group(name: str, cores: float | None = None, weight: float = 1.0) -> Iterator[list[str]]:
    """Make a control group, and yield the words that start a command in it; what is in it at the end is killed.

    :param cores: How much processor time it may use, in cores; None for any.
    :param weight: Its part of what there is, where another group has 1.
    """
    is_old = VERSION_1.is_dir()
    group = (VERSION_1 if is_old else VERSION_2) / f'param_tutorial_{os.getpid()}_{name}'
    if not is_old:
        (VERSION_2 / 'cgroup.subtree_control').write_text('+cpu')
    group.mkdir()
    members = group / 'cgroup.procs'
    try:
        (group / ('cpu.shares' if is_old else 'cpu.weight')).write_text(str(round(weight * (1024 if is_old else 100))))
        if cores and is_old:
            (group / 'cpu.cfs_period_us').write_text(str(PERIOD_USEC))
            (group / 'cpu.cfs_quota_us').write_text(str(round(cores * PERIOD_USEC)))
        elif cores:
            (group / 'cpu.max').write_text(f'{round(cores * PERIOD_USEC)} {PERIOD_USEC}')
        yield ['sh', '-c', f'echo $$ > {members} && exec "$@"', 'sh']
    finally:
        while left := members.read_text().split():
            subprocess.run(['kill', '-KILL', *left], stderr=subprocess.DEVNULL, check=False)
            time.sleep(0.1)
        group.rmdir()


def run_suite(number: int, cores: float, arguments: str) -> bool:
    """Run the suite once, and return whether it was green."""
    checkout, log = FOLDER / f'checkout{number}', FOLDER / f'{number}.log'
    shutil.rmtree(checkout, ignore_errors=True)
    subprocess.run(['git', 'clone', '--quiet', ROOT, checkout], check=True)
    subprocess.run(['make', '--silent', 'setup-all'], cwd=checkout, check=True, stdout=subprocess.DEVNULL)
    began = time.monotonic()
    with control_group(f'suite{number}', cores) as inside, log.open('w') as output:
        # With -v the log names a test that fails at once, and also when the run is stopped.
        status = subprocess.run([*inside, 'make', 'test-all', f'ARGS=-v {arguments}'], cwd=checkout,
                                env={**os.environ, 'CI': 'true'}, stdin=subprocess.DEVNULL, stdout=output,
                                stderr=subprocess.STDOUT, check=False).returncode
    shutil.rmtree(checkout)
    text = log.read_text()
    last = next((line.strip('= ') for line in reversed(text.splitlines()) if ' in ' in line and 'passed' in line), '')
    print(f'Run {number}: {"green" if status == 0 else "RED"}, {last or "see its log"}; took '
          f'{(time.monotonic() - began) / 60:.0f} min, load {os.getloadavg()[0]:.0f}', flush=True)
    for line in text.splitlines():
        if line.startswith(('FAILED ', 'ERROR ')):
            print(f'  {line}', flush=True)
    return status == 0


def main() -> int:
    """Run as the arguments say."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--runs', type=int, default=5, help='how often (default: %(default)s)')
    parser.add_argument('--at-once', type=int, default=1, metavar='N', help='so many at a time (default: %(default)s)')
    parser.add_argument('--cores', type=float, default=0.5, help='what each run may use (default: %(default)s)')
    parser.add_argument('--busy', type=int, default=8, metavar='N',
                        help='beside N processes that never rest (default: %(default)s)')
    chosen, others = parser.parse_known_args()
    arguments = shlex.join(others)
    if os.geteuid():
        print("This makes control groups, which takes root's rights.", file=sys.stderr)
        return 2
    FOLDER.mkdir(parents=True, exist_ok=True)
    with control_group('busy', weight=0.1) as inside, ThreadPoolExecutor(chosen.at_once) as workers:
        for _ in range(chosen.busy):
            subprocess.Popen([*inside, sys.executable, '-c', 'while True: pass'])
        results = list(workers.map(lambda number: run_suite(number, chosen.cores, arguments),
                                   range(1, chosen.runs + 1)))
    return int(not all(results))


if __name__ == '__main__':
    sys.exit(main())
