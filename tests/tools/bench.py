"""Measure what the course promises about speed. `make bench` runs this; the figures go to build/bench.json.

What is compared is measured in turns within one run, in random order, so that a busy machine slows all of it alike;
a figure is the median of many trials. A bar that is a ratio therefore holds on any machine.
"""

import argparse
import json
import os
import platform
import statistics
import subprocess
import sys
import tempfile
import textwrap
import time
from dataclasses import asdict, dataclass
from pathlib import Path

import psutil
from jupyter_client.manager import start_new_kernel
from playwright.sync_api import Locator, expect

from tests.support import lesson
from tests.support.lab import CHROMIUM, ROOT, Lab, LabPage, chromium
from tests.tools import memory_bench, panel_bench, picture_bench

# Run in a kernel, as a lesson is: there a widget's messages really travel.
LATENCY = '''
import json, random, statistics, threading, time
import param_tutorial, rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.parameter_client import AsyncParameterClient
from param_tools.node.live import LiveParameters

class Target(Node):
    def __init__(self, **options):
        super().__init__('target', **options)
        self.declare_parameter('bare', 0)
        self.declare_parameter('panel', 0)

def bare(client):
    """Return a function that sets a value and gives the seconds until the answer is in the executor's thread."""
    def once(number):
        answered, done = [], threading.Event()
        start = time.monotonic()
        future = client.set_parameters([Parameter('bare', value=number)])
        future.add_done_callback(lambda _: (answered.append(time.monotonic()), done.set()))
        done.wait()
        assert future.result().results[0].successful
        return answered[0] - start
    return once

executor = param_tutorial.start()
executor.add(Target)
same = AsyncParameterClient(executor.add(Node, 'bare_client'), '/target')
assert same.wait_for_services(5)

# rclpy's usual executor, with a node of the same class, in a graph of its own.
context = rclpy.Context()
rclpy.init(context=context, domain_id=102)
elsewhere, other = Target(context=context), Node('bare_client', context=context)
single = SingleThreadedExecutor(context=context)
single.add_node(elsewhere)
single.add_node(other)
threading.Thread(target=single.spin, daemon=True).start()
usual = AsyncParameterClient(other, '/target')
assert usual.wait_for_services(5)

panel = param_tutorial.ParameterPanel('/target')
control = panel['panel']
answered_at = 0.0
on_answer = LiveParameters._on_answer

def note(live, request, future):
    """Note when the answer is in the executor's thread; not by the panel's own clock, which slows on a busy machine."""
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

def until_shown(number):
    start = time.monotonic()
    control.value = number
    panel.settle()
    return time.monotonic() - start

ways = {'bare': bare(same), 'single': bare(usual), 'python': by_python, 'browser': by_browser, 'shown': until_shown}
seconds = {name: [] for name in ways}
for number in range(1, TRIALS + 21):
    for name in random.sample(sorted(ways), len(ways)):
        took = ways[name](number)
        panel.settle()
        time.sleep(0.004)  # until the widgets' messages are out of the way
        if number > 20:
            seconds[name].append(took)
result = {name: statistics.median(each) for name, each in seconds.items()}
single.shutdown()
rclpy.shutdown(context=context)
'''

COMMAND = '''
import subprocess, sys, time, statistics
import param_tutorial
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from IPython.utils.capture import capture_output

executor = param_tutorial.start()
executor.add(SimpleParamNode)
shell = get_ipython()
shell.run_line_magic('load_ext', 'param_tutorial')
words = 'param set /simple_param_node max_speed_rpm'

def magic(number):
    with capture_output() as captured:
        start = time.perf_counter()
        shell.run_line_magic('ros2', f'{words} {number}')
        took = time.perf_counter() - start
    assert 'Set parameter successful' in captured.stdout, captured.stdout
    return took

def process(number):
    start = time.perf_counter()
    done = subprocess.run([sys.executable, '-m', 'param_tutorial', *words.split(), str(number)],
                          capture_output=True, text=True)
    took = time.perf_counter() - start
    assert 'Set parameter successful' in done.stdout, done.stdout + done.stderr
    return took

magics, processes = [], []
for number in range(PROCESSES):
    processes.append(process(number))
    magics += [magic(each) for each in range(20)]
result = {'magic': statistics.median(magics), 'process': statistics.median(processes)}
'''

DRAG = '''
import time
import psutil
import param_tutorial
from param_tutorial import ParameterPanel, StepResponseView
from param_tutorial.nodes.pid_controller_node import PidControllerNode

controller = param_tutorial.start().add(PidControllerNode)
panel = ParameterPanel(controller)
me = psutil.Process()

def load(moves):
    """Move a gain 30 times a second as a browser does; give the processor time in percent of one core."""
    start, before = time.monotonic(), sum(me.cpu_times()[:2])
    for number in range(moves):
        panel['gains.wheel_joint.p'].enter(str(0.1 + number % 100 / 100))
        panel._show()
        time.sleep(max(0.0, start + (number + 1) / 30 - time.monotonic()))
    return 100 * (sum(me.cpu_times()[:2]) - before) / (time.monotonic() - start)

shares = {'with': [], 'without': []}
for _ in range(ROUNDS):
    shares['without'].append(load(60))
    view = StepResponseView(controller)
    shares['with'].append(load(60))
    view.close()
result = {name: sum(each) / len(each) for name, each in shares.items()}
'''

SYSTEM = '''
import statistics, subprocess, sys, time
import param_tutorial
from param_tutorial import all_parameters, wait_until
from rclpy.parameter_client import AsyncParameterClient
from rclpy.node import Node

ROBOT = """
import signal, rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node

class Robot(Node):
    def __init__(self, number):
        super().__init__(f'node_{number}', enable_rosout=False)
        for index in range(40):
            self.declare_parameter(f'group_{index % 4}.value_{index}', float(index))

rclpy.init()
executor = SingleThreadedExecutor()
for number in range(50):
    executor.add_node(Robot(number))
try:
    executor.spin()
except BaseException:
    pass
"""

executor = param_tutorial.start()
asking = executor.add(Node, 'asking')
robot = subprocess.Popen([sys.executable, '-c', ROBOT], stderr=subprocess.DEVNULL)
names = [f'/node_{number}' for number in range(50)]
try:
    wait_until(lambda: set(names) <= set(executor.services.node_names()), 'the nodes to be there', 60)

    def wait(future):
        wait_until(future.done, 'an answer', 20)
        return future.result()

    def one_by_one():
        """Ask node after node, each through rclpy's own client."""
        for name in names:
            client = AsyncParameterClient(asking, name)
            assert client.wait_for_services(10)
            found = wait(client.list_parameters()).result.names
            assert len(wait(client.get_parameters(found)).values) == 42
            for service in ('_get_parameter', '_list_parameter', '_set_parameter', '_get_parameter_types',
                            '_describe_parameters', '_set_parameters_atomically'):
                asking.destroy_client(getattr(client, service + '_client'))

    def at_once():
        found = all_parameters(names)
        assert sum(map(len, found.values())) == 50 * 42

    def timed(function):
        start = time.perf_counter()
        function()
        return time.perf_counter() - start

    result = {'first': timed(at_once), 'at once': [], 'one by one': []}
    for _ in range(ROUNDS):
        result['one by one'].append(timed(one_by_one))
        result['at once'].append(timed(at_once))
    start = time.perf_counter()
    subprocess.run([sys.executable, '-m', 'param_tutorial', 'param', 'dump', '/node_7'], check=True,
                   stdout=subprocess.DEVNULL)
    result |= {'command': time.perf_counter() - start, 'at once': statistics.median(result['at once']),
               'one by one': statistics.median(result['one by one'])}
finally:
    robot.terminate()
    robot.wait()
'''

SLOW_ROBOT = (
    '# A robot\nOn the stage, and long on its way:',
    'from param_tutorial import ParameterClient, RobotView, start\n'
    'from param_tutorial.nodes.clawbot_node import ClawbotNode\n\n'
    "robot = start().add(ClawbotNode)\nParameterClient(robot).set_parameter('max_acceleration_mps2', 0.02)\n"
    'RobotView(robot)',
)

# What a lesson cannot do without: a node of rclpy, and a widget.
BARE = (
    '# Bare\nA node and a slider:',
    "import os\n\nos.environ['ROS_AUTOMATIC_DISCOVERY_RANGE'] = 'LOCALHOST'\n"
    'import rclpy\nfrom rclpy.node import Node\n\n'
    "if not rclpy.ok():\n    rclpy.init()\nnode = Node('bare')\nnode.declare_parameter('x', 0.5)",
    'import ipywidgets\n\nipywidgets.FloatSlider(0.5)',
)

END_KERNEL = '() => window.jupyterapp.shell.currentWidget.sessionContext.shutdown()'
START_AND_RUN_ALL = """async () => {
    await window.jupyterapp.shell.currentWidget.sessionContext.changeKernel({name: 'python3'});
    window.jupyterapp.commands.execute('notebook:run-all-cells');
}"""

# One node with more and more parameters: what takes more than its share of the time shows.
MANY = '''
import sys
import param_tutorial
from rclpy.node import Node

class Many(Node):
    def __init__(self, name, count):
        super().__init__(name, enable_rosout=False)
        for index in range(count):
            self.declare_parameter(f'group_{index % 50}.value_{index}', float(index))

executor = param_tutorial.start()
'''
ELSEWHERE = MANY + '''
executor.add(Many, 'elsewhere', 1000)
sys.stdin.read()
'''
SCALE = MANY + '''
import subprocess, tempfile, time
from pathlib import Path
from param_tutorial import ParameterClient, all_parameters, compare

def timed(function):
    start = time.perf_counter()
    function()
    return time.perf_counter() - start

def one_by_one(client, names):
    for name in names:
        client.get_parameter(name)

result = {}
with tempfile.TemporaryDirectory() as folder:
    path = Path(folder, 'many.yaml')
    for count in COUNTS:
        client = ParameterClient(executor.add(Many, 'many', count), timeout_sec=120)
        before = client.get_parameters()
        after = {name: value + 1.0 for name, value in before.items() if name.startswith('group_')}
        ways = {'list': client.list_parameters, 'dump': lambda: client.dump(path),
                'load': lambda: client.load(path).raise_for_reason(),
                'snapshot': lambda: all_parameters('/many', timeout_sec=120),
                'difference': lambda: repr(compare(before, after))}
        for way, function in ways.items():
            result[f'{way} {count}'] = min(timed(function) for _ in range(ROUNDS))
        if count == 1000:
            result['one by one'] = min(timed(lambda: one_by_one(client, after)) for _ in range(ROUNDS))
    process = subprocess.Popen([sys.executable, '-c', ELSEWHERE], stdin=subprocess.PIPE)
    client = ParameterClient('/elsewhere', timeout_sec=120)
    names = client.list_parameters()
    result['dump elsewhere'] = min(timed(lambda: client.dump(path)) for _ in range(ROUNDS))
    result['one by one elsewhere'] = min(timed(lambda: one_by_one(client, names)) for _ in range(ROUNDS))
    process.communicate()
'''


@dataclass
class Row:
    """One line of the table."""

    what: str
    figure: str
    bar: str
    met: bool | None
    """None if there is no bar."""


def in_kernel(code: str) -> dict[str, float]:
    """Run code in a new kernel, and return what it left in ``result``."""
    manager, client = start_new_kernel(kernel_name='python3', stderr=subprocess.DEVNULL)
    try:
        answer = client.execute_interactive(
            code, output_hook=_show_errors, timeout=600,
            user_expressions={'result': '__import__("json").dumps(result)'})
        return json.loads(eval(answer['content']['user_expressions']['result']['data']['text/plain']))
    finally:
        client.stop_channels()
        manager.shutdown_kernel(now=True)


def _show_errors(message) -> None:
    if message['msg_type'] == 'error':
        print('\n'.join(message['content']['traceback']), file=sys.stderr)


def latency(trials: int) -> list[Row]:
    """Compare a panel with a bare client."""
    took = in_kernel(LATENCY.replace('TRIALS', str(trials)))
    rows = [Row('bare AsyncParameterClient, same executor', _ms(took['bare']), '', None),
            Row('bare AsyncParameterClient, SingleThreadedExecutor', _ms(took['single']), '', None)]
    for way, words in (('python', 'panel change from Python to confirmation'),
                       ('browser', "panel change from the browser's message to confirmation")):
        ratio = took[way] / took['bare']
        rows += [Row(words, f'{_ms(took[way])}, {ratio:.2f} times bare', 'at most 1.1 times', ratio <= 1.1),
                 Row(f'{words}, against SingleThreadedExecutor', f'{took[way] / took["single"]:.2f} times',
                     'at most 1 time', took[way] <= took['single'])]
    return [*rows, Row('panel change until read back and shown (settle)', _ms(took['shown']), '', None)]


def command(processes: int) -> list[Row]:
    """Compare %ros2 with a new process."""
    took = in_kernel(COMMAND.replace('PROCESSES', str(processes)))
    ratio = took['process'] / took['magic']
    return [Row('%ros2 param set in a kernel', _ms(took['magic']), '', None),
            Row('ros2 param set as a new process', _ms(took['process']), 'at most 0.5 s', took['process'] <= 0.5),
            Row('%ros2 against a new process', f'{ratio:.0f} times faster', 'at least 100 times', ratio >= 100)]


def step_response(rounds: int) -> list[Row]:
    """Measure what it costs to redraw a step response while a gain is dragged."""
    shares = in_kernel(DRAG.replace('ROUNDS', str(rounds)))
    view = shares['with'] - shares['without']
    return [Row('CPU while a gain is dragged: controller and panel', f'{shares["without"]:.1f} % of a core', '', None),
            Row('what the view of the step response adds', f'{view:.1f} % of a core', 'at most 15 %', view <= 15)]


def whole_system(rounds: int) -> list[Row]:
    """Read 50 nodes of 40 parameters in another process, at once and in the ways of other tools."""
    took = in_kernel(SYSTEM.replace('ROUNDS', str(rounds)))
    return [Row('50 nodes of 40 parameters read at once, the first time', f'{took["first"]:.2f} s', 'at most 1 s',
                took['first'] <= 1),
            Row('the same, again', f'{took["at once"]:.2f} s', '', None),
            Row("the same, node after node through rclpy's AsyncParameterClient",
                f'{took["one by one"] / took["at once"]:.0f} times as long', '', None),
            Row('the same, with a `param dump` for each node', f'{50 * took["command"] / took["at once"]:.0f} times as '
                                                               f'long', '', None)]


def many_parameters(rounds: int) -> list[Row]:
    """Measure one node with 1 to 10,000 parameters."""
    counts = (1, 100, 1000, 10_000)
    took = in_kernel(SCALE.replace('ROUNDS', str(rounds)).replace('COUNTS', str(counts))
                     .replace('ELSEWHERE', repr(ELSEWHERE)))
    rows = [Row(f'{way} of 1, 100, 1,000 and 10,000 parameters',
                ' '.join(f'{1000 * took[f"{way} {count}"]:.0f}' for count in counts) + ' ms', '', None)
            for way in ('list', 'dump', 'load', 'snapshot', 'difference')]
    ratio = took['one by one elsewhere'] / took['dump elsewhere']
    return [*rows,
            Row('a dump of 1,000 parameters of a node in another process, against a call for each',
                f'{ratio:.0f} times faster', 'at least 20 times', ratio >= 20),
            Row('the same, the node in the same process',
                f'{took["one by one"] / took["dump 1000"]:.0f} times faster', '', None)]


def lesson_in_browser(rounds: int, idle_sec: float) -> list[Row]:
    """Measure a lesson in the real JupyterLab and Chromium."""
    if CHROMIUM is None:
        return [Row('a lesson in the browser', 'not measured: there is no Chromium', '', None)]
    panel_sec, slider_sec = [], []
    with tempfile.TemporaryDirectory() as scratch:
        notebook = lesson.write(Path(scratch) / 'lesson.ipynb')
        bare = lesson.write(Path(scratch) / 'bare.ipynb', BARE)
        with Lab(Path(scratch) / 'lab', [notebook, bare]) as lab, chromium() as browser:
            page, bare_page = (LabPage(lab, browser, each.name) for each in (notebook, bare))
            for each in (page, bare_page):
                # JupyterLab never comes to the end of a restart that is asked for while it connects to the kernel.
                each.run_all()
            for _ in range(rounds):
                panel_sec.append(_until_shown(page, page.slider('max_acceleration_mps2')))
                slider_sec.append(_until_shown(bare_page, bare_page.page.locator('.noUi-target')))
            bare_page.page.evaluate(END_KERNEL)
            kernel = psutil.Process(int(lab.ask_kernel("__import__('os').getpid()")))
            # What a lesson has just done (threads that end, garbage) is not idling.
            time.sleep(5)
            before, start = kernel.cpu_times(), time.monotonic()
            time.sleep(idle_sec)
            after, stop = kernel.cpu_times(), time.monotonic()
            share = (after.user + after.system - before.user - before.system) / (stop - start)
            memory = kernel.memory_info().rss / 2**20
    began = statistics.median(panel_sec)
    # Jupyter Server asks a starting kernel who it is; where the answer is lost, as it often is, it asks again after
    # half a second. A median tells on which side this coin fell more often, so the fastest are compared.
    ratio = min(panel_sec) / min(slider_sec)
    return [Row('kernel start to first panel on screen', f'{began:.2f} s, at best {min(panel_sec):.2f} s',
                'at most 0.8 s', began <= 0.8),
            Row("the same at best, against one of ipywidgets' sliders and a bare node", f'{ratio:.2f} times',
                'at most 1 time', ratio <= 1),
            Row('idle CPU of a running lesson', f'{100 * share:.1f} % of a core', 'at most 2 %', share <= 0.02),
            Row("memory of a lesson's kernel (RSS)", f'{memory:.0f} MiB', '', None)]


def _until_shown(page: LabPage, shown: Locator) -> float:
    """Start another kernel and run all cells, and return how many seconds that took until something was shown."""
    page.page.evaluate("() => window.jupyterapp.commands.execute('notebook:clear-all-cell-outputs')")
    expect(shown).to_have_count(0)
    # A restart would count what the kernel before takes to end.
    page.page.evaluate(END_KERNEL)
    start = time.monotonic()
    page.page.evaluate(START_AND_RUN_ALL)
    expect(shown).to_be_visible()
    took = time.monotonic() - start
    page.run_all()
    return took


def robot_in_browser() -> list[Row]:
    """Measure how smoothly the robot moves, and what that costs."""
    if CHROMIUM is None:
        return []
    with tempfile.TemporaryDirectory() as scratch:
        figures, = picture_bench.measure(lesson.write(Path(scratch) / 'robot.ipynb', SLOW_ROBOT))

    def load(what: str, percent: float, most: float) -> Row:
        return Row(f'CPU while the robot is {what}', f'{percent:.1f} % of a core', f'at most {most:g} %',
                   percent <= most)

    return [Row('frames in which the robot has moved', f'{figures.frames_per_sec:.0f} per second', 'at least 20',
                figures.frames_per_sec >= 20),
            load('moving: kernel', figures.moving_kernel, 15), load('moving: browser', figures.moving_browser, 10),
            load('still: kernel', figures.still_kernel, 1)]


def large_panels() -> list[Row]:
    """Measure panels of a large node and of many nodes."""
    if CHROMIUM is None:
        return []
    figures = panel_bench.measure()
    return [Row('502 parameters of a node on screen', f'{figures["large"]:.2f} s', 'at most 2 s',
                figures['large'] <= 2),
            Row('frames while they scroll', f'{figures["frames"]:.0f} per second, {figures["at rest"]:.0f} at rest',
                'at least 60',
                round(figures['frames']) >= 60),
            Row('50 nodes of 42 parameters on screen', f'{figures["nodes"]:.2f} s', 'at most 2 s',
                figures['nodes'] <= 2),
            Row('a search over their parameters, from the last key to the hits', f'{figures["found"]:.2f} s', '', None),
            Row('longest time without a frame while somebody types it', f'{figures["longest frame"]:.0f} ms', '', None)]


def cells_again(warm_up: int, runs: int) -> list[Row]:
    """Measure what a kernel keeps of chapter 6.1, which starts and ends a dozen nodes each time its cells run."""
    growth = memory_bench.measure('06_1', warm_up, runs)
    return [Row('memory that each further run of 6.1 costs, its history forgotten', f'{growth:.0f} KiB', '', None)]


def _ms(seconds: float) -> str:
    return f'{1000 * seconds:.2f} ms'


def main() -> int:
    """Measure, print and save."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--quick', action='store_true', help='fewer trials, to see whether it works at all')
    quick = parser.parse_args().quick
    print(textwrap.dedent(f'''\
        {platform.processor() or platform.machine()}, {os.cpu_count()} cores, Python {platform.python_version()}, \
        load {os.getloadavg()[0]:.1f}'''))
    saved = ROOT / 'build' / ('bench_quick.json' if quick else 'bench.json')
    last = {row['what']: row['figure'] for row in json.loads(saved.read_text())} if saved.exists() else {}
    rows: list[Row] = []
    for measure in (lambda: latency(100 if quick else 1000), lambda: command(3 if quick else 10),
                    lambda: step_response(1 if quick else 5), lambda: whole_system(1 if quick else 5),
                    lambda: many_parameters(1 if quick else 5),
                    lambda: lesson_in_browser(1 if quick else 10, 5.0 if quick else 20.0),
                    large_panels, robot_in_browser, lambda: cells_again(*((2, 2) if quick else (200, 100)))):
        for row in measure():
            rows.append(row)
            verdict = {True: 'met', False: 'NOT MET', None: ''}[row.met]
            print(f'{row.what:72} {row.figure:28} {row.bar:20} {verdict:8}'
                  + (f'last time: {last[row.what]}' if row.what in last else ''), flush=True)
    saved.parent.mkdir(exist_ok=True)
    saved.write_text(json.dumps([asdict(row) for row in rows], indent=1) + '\n')
    print(f'Saved as {saved.relative_to(ROOT)}')
    return int(any(row.met is False for row in rows))


if __name__ == '__main__':
    sys.exit(main())
