"""End nodes at random moments, and count those that do not end well: `make steady-ends` runs this.

    python -m tests.tools.signals [--ends 1000] [--within 2.5] [--seed 1]

A node runs alone or through the course's `run`, and gets SIGINT, as from Ctrl+C, or SIGTERM at a random moment. Both
are held back until its first line has run, as our `launch` and `Terminal` do. It ends well with exit status 0, without
a traceback, and with no process left. The exit status of this tool is 1 if any did not.
"""

import argparse
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable

import psutil

from param_tools.cli.run import signals_held
from param_tools.ros import domain
from param_tools.ros.processes import ends
from param_tools.ros.waiting import within
from param_tutorial.notebook.interrupts import interruptible
from tests.tools.steady import EMBEDDED

WAYS = {'alone': [sys.executable, '-m', 'param_tutorial.nodes', 'simple_param_node'],
        'run': [*EMBEDDED, 'run', 'param_tutorial', 'simple_param_node']}
LIMIT_SEC = 20.0


def end(words: list[str], number: signal.Signals, after_sec: float) -> str:
    """Start a program, and send it a signal so many seconds later; return what is wrong with its end, or nothing."""
    with tempfile.TemporaryFile('w+') as errors:
        with interruptible(), signals_held(hears_of_it=True):
            process = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=errors, start_new_session=True)
        time.sleep(after_sec)
        # Ctrl+C reaches the command and its node alike.
        send: Callable[[int, int], None] = os.killpg if number == signal.SIGINT else os.kill
        send(process.pid, number)
        has_ended = within(LIMIT_SEC, ends(process))
        left = [each for each in psutil.pids() if _session(each) == process.pid]
        if left:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
        errors.seek(0)
        said = errors.read()
    if not has_ended:
        return f'not within {LIMIT_SEC:g} s'
    if left:
        return f'{len(left)} processes left'
    return said if process.returncode or 'Traceback' in said else ''


def _session(process: int) -> int | None:
    try:
        return os.getsid(process)
    except OSError:  # it has ended meanwhile
        return None


def main() -> int:
    """End nodes as the arguments say."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--ends', type=int, default=1000, help='how many (default: %(default)s)')
    parser.add_argument('--within', type=float, default=2.5, metavar='SEC',
                        help='the latest moment, in seconds after the start (default: %(default)s)')
    parser.add_argument('--seed', type=int, default=1, help='for other random moments (default: %(default)s)')
    chosen = parser.parse_args()
    domain.choose()
    moments = random.Random(chosen.seed)
    wrong = 0
    for count in range(1, chosen.ends + 1):
        way, number = moments.choice(list(WAYS)), moments.choice([signal.SIGINT, signal.SIGTERM])
        after_sec = moments.uniform(0, chosen.within)
        if problem := end(WAYS[way], number, after_sec):
            wrong += 1
            print(f'  WRONG {way}, {number.name} after {after_sec:.3f} s: {problem}', flush=True)
        if count % 100 == 0 or count == chosen.ends:
            print(f'{wrong} of {count} did not end well', flush=True)
    return min(1, wrong)


if __name__ == '__main__':
    sys.exit(main())
