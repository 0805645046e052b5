"""Make the README's pictures of commands and of the panel from real use: `python -m tests.tools.recordings`.

Four nodes of the course run as a robot, each in its own process. Two pictures show what the commands print about them,
and a moving one is the panel's page in Chromium. Look at all of them before you commit them.
"""

import argparse
import contextlib
import io
import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from PIL import Image
from playwright.sync_api import Locator, Page, expect
from rich.console import Console
from rich.text import Text

from param_tools.ros import domain
from tests.support.lab import chromium, wait_for
from tests.support.paths import ROOT

FOLDER = ROOT / '.github' / 'recordings'

NODES = {'base': 'clawbot_node', 'lift': 'pallet_lift_node', 'left_wheel': 'pid_controller_node',
         'right_wheel': 'pid_controller_node'}

# Each block has a mistake or two.
ROBOT_YAML = '''\
/robot/left_wheel:
  ros__parameters:
    update_rate: 100.0
    gains.wheel_joint.p: 0.3
    gains.wheel_joint.antiwindup_strategy: off
    gains.wheel_joint.u_clamp: 1.0
/robot/lifter:
  ros__parameters:
    lift.speed_mps: 0.1
/robot/base:
  ros__parameters:
    max_speed_rpm: 9999
'''

TERMINALS = {
    'check': ('cat -n robot.yaml', "python -m param_tutorial check robot.yaml --against '/robot/**'"),
    'restore': (
        'python -m param_tutorial snapshot --save before.yaml',
        'python -m param_tutorial param set /robot/left_wheel gains.wheel_joint.p 0.9',
        'python -m param_tutorial param set /robot/lift lift.speed_mps 0.1',
        "python -m param_tutorial diff before.yaml '/robot/**'",
        'python -m param_tutorial restore before.yaml',
        "python -m param_tutorial diff before.yaml '/robot/**'"),
}
COLUMNS = 104

# Headless Chromium draws no pointer.
POINTER = '''document.addEventListener('mousemove', ({clientX, clientY}) => {
    let pointer = document.getElementById('pointer');
    if (!pointer) {
        pointer = document.body.appendChild(document.createElement('div'));
        pointer.id = 'pointer';
        pointer.style = 'position: fixed; pointer-events: none; z-index: 99999';
        pointer.innerHTML = '<svg width="16" height="24" viewBox="0 0 16 24">'
            + '<path d="M1 1v18l4-4 3 8 4-1.5-3.5-7.5H14z" fill="#000" stroke="#fff" stroke-width="1.5"/></svg>';
    }
    [pointer.style.left, pointer.style.top] = [`${clientX}px`, `${clientY}px`];
}, true)'''
VIEW = {'width': 880, 'height': 500}


def shell_environment() -> dict[str, str]:
    """Return the environment of a terminal beside the robot, with the course's Python first."""
    inherited = {name: value for name, value in os.environ.items() if not name.startswith(('JUPYTER', 'PYTEST'))}
    path = f'{Path(sys.executable).parent}{os.pathsep}{inherited["PATH"]}'
    return {**inherited, 'PATH': path, 'PYTHONUNBUFFERED': '1'}


@contextlib.contextmanager
def robot(environment: dict[str, str]) -> Iterator[None]:
    """Run the nodes until the end of the block."""
    with contextlib.ExitStack() as stack:
        for name, node in NODES.items():
            process = stack.enter_context(subprocess.Popen(
                [sys.executable, '-m', 'param_tutorial.nodes', node, '--ros-args', '-r', f'__node:={name}',
                 '-r', '__ns:=/robot'], env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL))
            stack.callback(process.terminate)
        wanted = ''.join(f'/robot/{name}\n' for name in sorted(NODES))
        wait_for(lambda: run('python -m param_tutorial node list', ROOT, environment) == wanted, 'the nodes')
        yield


def run(line: str, folder: Path, environment: dict[str, str]) -> str:
    """Return what a command prints, errors with the rest as in a terminal."""
    return subprocess.run(['bash', '-c', line], cwd=folder, env=environment, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, timeout=60).stdout


def terminals(folder: Path, environment: dict[str, str]) -> dict[str, str]:
    """Return the pictures of terminals beside the robot, as SVG, by the names of their files.

    :param folder: Where the commands are typed.
    """
    (folder / 'robot.yaml').write_text(ROBOT_YAML)
    pictures = {}
    for name, lines in TERMINALS.items():
        console = Console(record=True, width=COLUMNS, file=io.StringIO())
        for line in lines:
            console.print(Text(f'$ {line}', 'bold'))
            console.print(Text(run(line, folder, environment).expandtabs().rstrip('\n')))
        # A picture fetches no font from elsewhere.
        pictures[f'{name}.svg'] = re.sub(r'@font-face {.*?}\s*', '', console.export_svg(title='', unique_id=name),
                                         flags=re.DOTALL)
    return pictures


def make_panel(folder: Path, environment: dict[str, str]) -> None:
    """Save the panel's page as a moving picture, and as a still one for readers who want no motion."""
    with subprocess.Popen([sys.executable, '-m', 'param_tutorial', 'panel', '--no-browser'], cwd=folder,
                          env=environment, stdout=subprocess.PIPE, text=True) as process, chromium() as browser:
        try:
            assert process.stdout is not None
            found = re.search(r'http://\S+', process.stdout.readline())
            assert found, 'the page has not been served'
            page = browser.new_page(viewport=VIEW)
            page.add_init_script(POINTER)
            page.goto(found[0], timeout=120_000)
            film = Film(page)
            use_panel(film)
        finally:
            process.terminate()
    film.frames[film.still_at].save(FOLDER / 'panel_still.webp', lossless=True)
    film.frames[0].save(FOLDER / 'panel.webp', save_all=True, append_images=film.frames[1:], loop=0, lossless=True,
                        duration=film.milliseconds, minimize_size=True)


class Film:
    """What is seen on a page, one picture after another, while it is used."""

    def __init__(self, page: Page) -> None:
        self.page = page
        self.frames: list[Image.Image] = []
        self.milliseconds: list[int] = []
        self.still_at = 0

    def show(self, seconds: float) -> None:
        """Take a picture, to be shown for so long."""
        self.frames.append(Image.open(io.BytesIO(self.page.screenshot(animations='disabled', caret='initial'))))
        self.milliseconds.append(round(1000 * seconds))

    def click(self, what: Locator, seconds: float = 0.6) -> None:
        """Point at something, and press the mouse's button."""
        what.hover()
        self.show(seconds)
        what.click()

    def write(self, what: Locator, text: str) -> None:
        """Click into a box, and write a text in place of what is there."""
        self.click(what)
        self.page.keyboard.press('Control+a')
        for letter in text:
            self.page.keyboard.type(letter)
            self.show(0.15)


def use_panel(film: Film) -> None:
    """Search, have a value rejected and another one accepted, and undo that."""
    page = film.page
    nodes = page.locator('.param-nodes')
    expect(nodes.locator('.node-says', has_text='parameters')).to_have_count(len(NODES))
    film.show(2)
    film.write(nodes.get_by_role('searchbox', name='Search nodes and parameters'), 'speed m/s')
    hit = nodes.get_by_role('button', name='lift.speed_mps = 0.2')
    expect(hit).to_be_visible()
    film.show(1.5)
    film.click(hit)
    box = page.get_by_label('speed_mps', exact=True)
    expect(box).to_have_value('0.2')
    film.show(1.5)
    film.write(box, '0.5')
    page.keyboard.press('Enter')
    expect(page.locator('.param-message')).to_be_visible()
    film.show(4)
    film.write(box, '0.3')
    page.keyboard.press('Enter')
    expect(page.get_by_role('button', name='Back to 0.2: lift.speed_mps')).to_be_visible()
    film.still_at = len(film.frames)
    film.show(2.5)
    film.click(page.locator('.param-head').get_by_role('button', name='Undo'))
    expect(box).to_have_value('0.2')
    film.show(3)


def main() -> None:
    """Make the pictures."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--terminals', type=Path, metavar='FOLDER', help='only those of terminals, put there')
    options = parser.parse_args()
    domain.choose()
    environment = shell_environment()
    target = options.terminals or FOLDER
    target.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch, robot(environment):
        folder = Path(scratch)
        if not options.terminals:
            make_panel(folder, environment)
        for name, picture in terminals(folder, environment).items():
            (target / name).write_text(picture)
    for path in sorted(target.iterdir()):
        print(f'{path}: {path.stat().st_size} bytes')


if __name__ == '__main__':
    main()
