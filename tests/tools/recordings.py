"""Make the README's moving pictures from real use: `python -m tests.tools.recordings`.

Four nodes of the course run as a robot, each in its own process. Two pictures show what the commands print about them,
and one is the panel's page in Chromium. Look at each frame before you commit them: `--frames FOLDER` keeps them.
"""

import argparse
import contextlib
import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from playwright.sync_api import Locator, expect

from param_tools.ros import domain
from tests.support.animation import Command, animated_webp, terminal_svg
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
    'check': ('A terminal: check finds the mistakes in a parameter file.', (
        ('cat -n robot.yaml', 3.0),
        ("python -m param_tutorial check robot.yaml --against '/robot/**'", 10.0))),
    'restore': ('A terminal: snapshot, diff and restore of a robot.', (
        ('python -m param_tutorial snapshot --save before.yaml', 2.0),
        ('python -m param_tutorial param set /robot/left_wheel gains.wheel_joint.p 0.9', 1.5),
        ('python -m param_tutorial param set /robot/lift lift.speed_mps 0.1', 1.5),
        ("python -m param_tutorial diff before.yaml '/robot/**'", 4.0),
        ('python -m param_tutorial restore before.yaml', 5.0),
        ("python -m param_tutorial diff before.yaml '/robot/**'", 5.0))),
}
"""For each picture of a terminal: what is seen, the commands, and how long a reader needs for what they print."""

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
    """Return the pictures of terminals beside the robot, moving and still, by the names of their files.

    :param folder: Where the commands are typed.
    """
    (folder / 'robot.yaml').write_text(ROBOT_YAML)
    pictures = {}
    for name, (title, lines) in TERMINALS.items():
        commands = [Command(line, run(line, folder, environment), seconds) for line, seconds in lines]
        pictures[f'{name}.svg'] = terminal_svg(title, commands, is_moving=True)
        pictures[f'{name}_still.svg'] = terminal_svg(title, commands, is_moving=False)
    return pictures


def panel(folder: Path, environment: dict[str, str]) -> tuple[bytes, bytes, list[bytes]]:
    """Return the panel's page as a moving picture, as a still, and frame by frame."""
    with subprocess.Popen([sys.executable, '-m', 'param_tutorial', 'panel', '--no-browser'], cwd=folder,
                          env=environment, stdout=subprocess.PIPE, text=True) as process, chromium() as browser:
        try:
            assert process.stdout is not None
            found = re.search(r'http://\S+', process.stdout.readline())
            assert found, 'the page has not been served'
            page = browser.new_page(viewport=VIEW)
            page.add_init_script(POINTER)
            page.goto(found[0], timeout=120_000)
            frames: list[tuple[bytes, float]] = []

            def frame(seconds: float) -> None:
                frames.append((page.screenshot(animations='disabled', caret='initial'), seconds))

            def click(what: Locator, seconds: float = 0.6) -> None:
                what.hover()
                frame(seconds)
                what.click()

            def write(what: Locator, text: str) -> None:
                click(what)
                page.keyboard.press('Control+a')
                for letter in text:
                    page.keyboard.type(letter)
                    frame(0.15)

            nodes = page.locator('.param-nodes')
            search = nodes.get_by_role('searchbox', name='Search nodes and parameters')
            expect(nodes.locator('.node-says', has_text='parameters')).to_have_count(len(NODES))
            frame(2)
            write(search, 'speed m/s')
            hit = nodes.get_by_role('button', name='lift.speed_mps = 0.2')
            expect(hit).to_be_visible()
            frame(1.5)
            click(hit)
            box = page.get_by_label('speed_mps', exact=True)
            expect(box).to_have_value('0.2')
            frame(1.5)
            write(box, '0.5')
            page.keyboard.press('Enter')
            expect(page.locator('.param-message')).to_be_visible()
            frame(4)
            write(box, '0.3')
            page.keyboard.press('Enter')
            expect(page.get_by_role('button', name='Back to 0.2: lift.speed_mps')).to_be_visible()
            frame(2.5)
            still = page.screenshot()
            click(page.locator('.param-head').get_by_role('button', name='Undo'))
            expect(box).to_have_value('0.2')
            frame(3)
            page.close()
            return animated_webp(browser, frames), animated_webp(browser, [(still, 1)]), [each for each, _ in frames]
        finally:
            process.terminate()


def make_panel(folder: Path, environment: dict[str, str], frames_folder: Path | None) -> None:
    """Write the pictures of the panel's page, and its frames into a folder of their own if there is one."""
    moving, still, frames = panel(folder, environment)
    (FOLDER / 'panel.webp').write_bytes(moving)
    (FOLDER / 'panel_still.webp').write_bytes(still)
    if frames_folder:
        frames_folder.mkdir(parents=True, exist_ok=True)
        for number, png in enumerate(frames):
            (frames_folder / f'{number:02}.png').write_bytes(png)


def main() -> None:
    """Make the pictures."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--frames', type=Path, metavar='FOLDER', help="also keep the frames of the panel's page")
    parser.add_argument('--terminals', type=Path, metavar='FOLDER', help='only those of terminals, put there')
    options = parser.parse_args()
    domain.choose()
    environment = shell_environment()
    target = options.terminals or FOLDER
    target.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch, robot(environment):
        folder = Path(scratch)
        if not options.terminals:
            make_panel(folder, environment, options.frames)
        for name, picture in terminals(folder, environment).items():
            (target / name).write_text(picture)
    for path in sorted(target.iterdir()):
        print(f'{path}: {path.stat().st_size} bytes')


if __name__ == '__main__':
    main()
