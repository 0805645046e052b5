"""Call the embedded ros2 thousands of times, and count the answers that are wrong. `make steady` runs this.

    python -m tests.tools.steady [--calls 2000] [--busy 8] [--in-kernel] [--at-once 2]

Two nodes live in processes of their own. Each call is a new process, which has to discover them first, or a `%ros2` in
one kernel. Every answer is compared with the one right answer, byte for byte. With `--busy N`, N processes that never
rest take the processor away meanwhile. A first line says how many answers were wrong; the exit status is 1 if any was.
"""

import argparse
import ast
import contextlib
import itertools
import os
import statistics
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor

from param_tools.ros import domain
from param_tools.ros.waiting import wait_until
from tests.support.kernels import Kernel

EMBEDDED = [sys.executable, '-m', 'param_tutorial']
NODES = {'simple_param_node': '/simple_param_node', 'cart_node': '/cart_node'}
NAMES = ('enable_safety_mode', 'max_acceleration_mps2', 'max_speed_rpm', 'min_operating_temperature_c', 'robot_name',
         'robot_serial_number', 'sensor_offset_meters', 'start_type_description_service', 'use_sim_time')
# Commands and the one right answer to each: standard output, standard error, and exit status.
Answer = tuple[str, str, int]
CALLS: dict[str, Answer] = {
    'param get /simple_param_node max_speed_rpm': ('Integer value is: 100\n', '', 0),
    'node list': ('/cart_node\n/simple_param_node\n', '', 0),
    'param list /simple_param_node': (''.join(f'  {name}\n' for name in NAMES), '', 0),
    'param set /simple_param_node robot_name Claw': ('Set parameter successful\n', '', 0),
    'param get /cart_node no_such_parameter': ('', 'Parameter not set\n', 1),
    'param get /nobody x': ('', 'Node not found\n', 1),
    'param describe /simple_param_node max_speed_rpm': (
        'Parameter name: max_speed_rpm\n  Type: integer\n'
        '  Description: Maximum wheel speed in rpm. Must not be negative.\n  Constraints:\n', '', 0),
}
# What `%ros2` calls, with streams that can be looked at.
IN_KERNEL = '''
import io
from param_tools.cli import command
from param_tools.ros import stage

def ask(words):
    out, error = io.StringIO(), io.StringIO()
    status = command.main(words.split(), stdout=out, stderr=error, get_executor=stage.current, in_notebook=True)
    return out.getvalue(), error.getvalue(), status

stage.start()
'''


@contextlib.contextmanager
def running_nodes() -> Iterator[None]:
    """Run the nodes, in processes of their own, in this block."""
    nodes = [subprocess.Popen([*EMBEDDED, 'run', 'param_tutorial', program], stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL) for program in NODES]
    try:
        wait_until(lambda: in_process('node list')[0].split() == sorted(NODES.values()), 'the nodes', 60)
        yield
    finally:
        for node in nodes:
            node.terminate()
        for node in nodes:
            node.wait()


@contextlib.contextmanager
def busy(count: int) -> Iterator[None]:
    """Keep so many processes busy in this block."""
    loops = [subprocess.Popen([sys.executable, '-c', 'while True: pass']) for _ in range(count)]
    try:
        yield
    finally:
        for loop in loops:
            loop.kill()
            loop.wait()


def in_process(words: str) -> Answer:
    """Answer a command by a new process."""
    done = subprocess.run([*EMBEDDED, *words.split()], stdin=subprocess.DEVNULL, capture_output=True, text=True,
                          check=False)
    return done.stdout, done.stderr, done.returncode


@contextlib.contextmanager
def in_kernel() -> Iterator[Callable[[str], Answer]]:
    """Yield a function that answers commands in one kernel."""
    kernel = Kernel(os.environ)
    try:
        kernel.run(IN_KERNEL)
        yield lambda words: ast.literal_eval(kernel.run(f'print(ask({words!r}))'))
    finally:
        kernel.kill()


def measure(ask: Callable[[str], Answer], calls: int, at_once: int) -> int:
    """Ask, and print the figures and the first wrong answers. Return how many were wrong."""
    answers: list[tuple[str, Answer, float]] = []

    def wrong() -> list[tuple[str, Answer]]:
        return [(words, answer) for words, answer, _ in answers if answer != CALLS[words]]

    def timed(words: str) -> tuple[str, Answer, float]:
        began = time.monotonic()
        return words, ask(words), time.monotonic() - began

    began = time.monotonic()
    with ThreadPoolExecutor(at_once) as workers:
        # If you end it early, you have seen how far it came.
        for answer in workers.map(timed, itertools.islice(itertools.cycle(CALLS), calls)):
            answers.append(answer)
            if len(answers) % 200 == 0:
                print(f'{len(wrong())} of {len(answers)} wrong so far', flush=True)
    took_sec = time.monotonic() - began
    print(f'{len(wrong())} of {len(answers)} answers wrong, in {took_sec:.0f} s, at load {os.getloadavg()[0]:.1f}')
    for words, answer in wrong()[:10]:
        print(f'  WRONG {words}: {answer}')
    for words in CALLS:
        if seconds := [each for asked, _, each in answers if asked == words]:
            print(f'  {words}: {statistics.median(seconds):.3f} s in the middle, {max(seconds):.3f} s at most')
    return len(wrong())


def main() -> int:
    """Measure as the arguments say."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--calls', type=int, default=2000, help='how many (default: %(default)s)')
    parser.add_argument('--busy', type=int, default=0, metavar='N', help='beside N processes that never rest')
    parser.add_argument('--in-kernel', action='store_true', help='in one kernel, and not as new processes')
    parser.add_argument('--at-once', type=int, default=2, metavar='N',
                        help='processes that ask at the same time (default: %(default)s)')
    chosen = parser.parse_args()
    # A new domain, which nodes, commands and kernel inherit.
    domain.choose()
    with running_nodes(), contextlib.ExitStack() as stack:
        ask = stack.enter_context(in_kernel()) if chosen.in_kernel else in_process
        stack.enter_context(busy(chosen.busy))
        return min(1, measure(ask, chosen.calls, 1 if chosen.in_kernel else chosen.at_once))


if __name__ == '__main__':
    sys.exit(main())
