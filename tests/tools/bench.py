"""Measure what the course promises about speed: `make bench`, and `make bench ARGS=--quick` to see whether it works.

What is compared is measured in turns within one run, in random order, so that a busy machine slows all of it alike;
a figure is the median of many trials. A bar that is a ratio therefore holds on any machine.
"""

import argparse
import contextlib
import json
import os
import platform
import statistics
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

from playwright.sync_api import Locator, expect

from tests.support import lesson
from tests.support.kernels import Kernel
from tests.support.lab import Lab, LabPage, chromium

# Run in a kernel, as a lesson is: there a widget's messages really travel.
LATENCY = '''
import random, statistics, threading, time
import param_tutorial
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.parameter_client import AsyncParameterClient
from param_tools.node.live import LiveParameters

class Target(Node):
    def __init__(self):
        super().__init__('target')
        self.declare_parameter('bare', 0)
        self.declare_parameter('panel', 0)

executor = param_tutorial.start()
executor.add(Target)
client = AsyncParameterClient(executor.add(Node, 'bare_client'), '/target')
assert client.wait_for_services(5)

def bare(number):
    """Set a value by rclpy's client; return the seconds until the answer is in the executor's thread."""
    answered, done = [], threading.Event()
    start = time.monotonic()
    future = client.set_parameters([Parameter('bare', value=number)])
    future.add_done_callback(lambda _: (answered.append(time.monotonic()), done.set()))
    done.wait()
    assert future.result().results[0].successful
    return answered[0] - start

panel = param_tutorial.ParameterPanel('/target')
control = panel['panel']
answered_at = 0.0
on_answer = LiveParameters._on_answer

def note(live, request, future):
    """Note when the answer is in the executor's thread."""
    global answered_at
    answered_at = time.monotonic()
    on_answer(live, request, future)

LiveParameters._on_answer = note

def by_python(number):
    """Assign to the control."""
    start = time.monotonic()
    control.value = number
    return confirmed(number) - start

def by_browser(number):
    """Let the browser's message arrive."""
    start = time.monotonic()
    message = {'do': 'enter', 'name': 'panel', 'text': str(number), 'client': '', 'number': 1}
    panel._front._handle_custom_msg(message, [])
    return confirmed(number) - start

def confirmed(number):
    panel.settle()
    assert control.value == number and not control.message
    return answered_at

ways = {'bare': bare, 'python': by_python, 'browser': by_browser}
seconds = {name: [] for name in ways}
for number in range(1, TRIALS + 21):
    for name in random.sample(sorted(ways), len(ways)):
        took = ways[name](number)
        panel.settle()
        time.sleep(0.004)  # until the widgets' messages are out of the way
        if number > 20:
            seconds[name].append(took)
result = {name: statistics.median(each) for name, each in seconds.items()}
'''

END_KERNEL = '() => window.jupyterapp.shell.currentWidget.sessionContext.shutdown()'
START_AND_RUN_ALL = """async () => {
    await window.jupyterapp.shell.currentWidget.sessionContext.changeKernel({name: 'python3'});
    window.jupyterapp.commands.execute('notebook:run-all-cells');
}"""


@dataclass
class Row:
    """One line of the table."""

    what: str
    figure: str
    bar: str = ''
    is_met: bool = True


def in_kernel(code: str) -> dict[str, float]:
    """Run code in a new kernel, and return what it left in ``result``."""
    kernel = Kernel()
    try:
        said = kernel.run(f'{code}\nimport json\nprint(json.dumps(result))')
        return json.loads(said.splitlines()[-1])
    finally:
        kernel.kill()


def latency(trials: int) -> list[Row]:
    """Compare a panel with a bare client in the same executor."""
    took = in_kernel(LATENCY.replace('TRIALS', str(trials)))
    rows = [Row('bare AsyncParameterClient', _ms(took['bare']))]
    for way, words in (('python', 'panel change from Python to confirmation'),
                       ('browser', "panel change from the browser's message to confirmation")):
        ratio = took[way] / took['bare']
        rows.append(Row(words, f'{_ms(took[way])}, {ratio:.2f} times bare', 'at most 1.1 times', ratio <= 1.1))
    return rows


def first_panel(rounds: int) -> list[Row]:
    """Measure a lesson's start in the real JupyterLab and Chromium."""
    with contextlib.ExitStack() as stack:
        scratch = Path(stack.enter_context(tempfile.TemporaryDirectory()))
        notebook = lesson.write(scratch / 'notebook.ipynb')
        lab = stack.enter_context(Lab(scratch / 'lab', [notebook]))
        page = LabPage(lab, stack.enter_context(chromium()), notebook.name)
        # JupyterLab never comes to the end of a restart that is asked for while it connects to the kernel.
        page.run_all()
        # Jupyter Server asks a starting kernel who it is; where the answer is lost, as it often is, it asks again after
        # half a second.
        seconds = [_until_shown(page, page.slider('max_acceleration_mps2')) for _ in range(rounds)]
    began = statistics.median(seconds)
    return [Row('kernel start to first panel on screen', f'{began:.2f} s, at best {min(seconds):.2f} s',
                'at most 0.8 s', began <= 0.8)]


def _until_shown(page: LabPage, shown: Locator) -> float:
    """Start another kernel and run all cells, and return how many seconds that took until something was shown."""
    page.command('notebook:clear-all-cell-outputs')
    expect(shown).to_have_count(0)
    # A restart would count what the kernel before takes to end.
    page.page.evaluate(END_KERNEL)
    start = time.monotonic()
    page.page.evaluate(START_AND_RUN_ALL)
    expect(shown).to_be_visible()
    took = time.monotonic() - start
    page.run_all()
    return took


def _ms(seconds: float) -> str:
    return f'{1000 * seconds:.2f} ms'


def main() -> int:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--quick', action='store_true', help='fewer trials, to see whether it works at all')
    quick = parser.parse_args().quick
    print(f'{os.cpu_count()} cores, Python {platform.python_version()}, load {os.getloadavg()[0]:.1f}')
    is_met = True
    for measure in (lambda: latency(100 if quick else 1000), lambda: first_panel(1 if quick else 10)):
        for row in measure():
            is_met &= row.is_met
            print(f'{row.what:60} {row.figure:28} {row.bar:20} {"" if row.is_met else "NOT MET"}', flush=True)
    return int(not is_met)


if __name__ == '__main__':
    sys.exit(main())
