"""How smoothly the robot moves in JupyterLab, and what that costs: `python -m tests.tools.robot_bench`.

``measure()`` gives the figures to the caller, who makes a table of them.
"""

import tempfile
import time
from pathlib import Path

import psutil
from playwright.sync_api import expect

from tests.support import lesson
from tests.support.lab import Lab, LabPage, chromium

SECONDS = 5.0
CELLS = (
    '# A robot\nOn the stage:',
    'import os\n\nfrom param_tutorial import ParameterClient, RobotView, start\n'
    'from param_tutorial.nodes.clawbot_node import ClawbotNode\n\n'
    'robot = start().add(ClawbotNode)\nclient = ParameterClient(robot)\nRobotView(robot)',
)
COUNT = '''milliseconds => new Promise(done => {
    const seen = new Set(), begin = performance.now();
    const look = now => {
        seen.add(getComputedStyle(document.querySelector('.robot-mover')).transform);
        now - begin < milliseconds ? requestAnimationFrame(look) : done(seen.size);
    };
    requestAnimationFrame(look) })'''


def measure() -> dict[str, float]:
    """Return the frames in which the robot has moved, per second, and processor time in percent of one core.

    The browser's is that of all its processes, which without a graphics card draw on the processor.
    """
    with tempfile.TemporaryDirectory() as scratch:
        notebook = lesson.write(Path(scratch) / 'robot.ipynb', CELLS)
        with Lab(Path(scratch) / 'lab', [notebook]) as lab, chromium() as browser:
            page = LabPage(lab, browser, notebook.name)
            page.run_all()
            kernel = [psutil.Process(int(lab.ask_kernel('os.getpid()')))]
            processes = [each for each in psutil.Process().children(recursive=True) if 'chrom' in each.name()]
            page.page.wait_for_timeout(3000)  # whatever JupyterLab does after running a cell
            figures = {'still: kernel': _load(page, kernel), 'still: browser': _load(page, processes)}
            lab.ask_kernel("client.set_parameter('max_acceleration_mps2', 0.02)")  # long enough on its way
            page.page.get_by_role('button', name='Drive').click()
            expect(page.page.locator('.robot-word')).to_have_text('SPEEDING UP')
            figures['moving: kernel'] = _load(page, kernel)
            figures['moving: browser'] = _load(page, processes)
            figures['frames per second'] = page.page.evaluate(COUNT, SECONDS * 1000) / SECONDS
            return figures


def _load(page: LabPage, processes: list[psutil.Process]) -> float:
    def used_sec() -> float:
        return sum(sum(each.cpu_times()[:2]) for each in processes)

    used, begin = used_sec(), time.monotonic()
    page.page.wait_for_timeout(SECONDS * 1000)
    return 100 * (used_sec() - used) / (time.monotonic() - begin)


if __name__ == '__main__':
    for name, figure in measure().items():
        print(f'{name:20}{figure:8.1f}')
