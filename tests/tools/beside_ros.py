"""Run the chapters as on an engineer's machine: a genuine ``ros2`` on the PATH, a workspace sourced, ROS variables set.

ROS itself is not on PyPI, so a stand-in (``ros2_stand_in``) takes the place of its command. It answers as the genuine
one does, also where the embedded command has other words, and knows nothing of the course's nodes. The workspace holds
an older build of the course's package, which no chapter may run.
"""

import os
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

from param_tools.cli import genuine
from tests.support.paths import ROOT, ROS_PACKAGE

# What the user has sourced stays on PYTHONPATH, as the nodes of a workspace need it.
ROS2 = """#!/bin/sh
exec {python} {stand_in} {command} -- "$@"
"""
OLD_BUILD = """#!/bin/sh
echo 'this is the old build, for another Python'
exit 1
"""
# As they stand in many a .bashrc. RMW_IMPLEMENTATION is another test's: a cell says that it is not used.
VARIABLES = {'ROS_DISTRO': 'jazzy', 'ROS_VERSION': '2', 'ROS_LOCALHOST_ONLY': '1', 'RCUTILS_COLORIZED_OUTPUT': '1',
             'RCUTILS_CONSOLE_OUTPUT_FORMAT': '[{severity}] [{time}] {message}', 'ROS_SECURITY_ENABLE': 'false'}


def make_executable(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    path.chmod(0o755)


def machine(folder: Path) -> dict[str, str]:
    """Create what such a machine has, and return its environment."""
    ros, workspace = folder / 'opt' / 'ros', folder / 'ros2_ws' / 'install'
    make_executable(ros / 'bin' / 'ros2', ROS2.format(
        python=shlex.quote(sys.executable), stand_in=shlex.quote(str(ROOT / 'tests' / 'tools' / 'ros2_stand_in.py')),
        command=shlex.join(genuine.embedded_words())))
    # There, PYTHONPATH has rclpy for it.
    make_executable(ros / 'bin' / 'python3', f'#!/bin/sh\nexec {shlex.quote(sys.executable)} "$@"\n')
    (ros / 'local_setup.bash').touch()  # colcon looks for it
    for node in (ROS_PACKAGE / 'param_tutorial' / 'nodes').glob('*_node.py'):
        make_executable(workspace / 'lib' / 'param_tutorial' / node.stem, OLD_BUILD)
    marker = workspace / 'share' / 'ament_index' / 'resource_index' / 'packages' / 'param_tutorial'
    marker.parent.mkdir(parents=True)
    marker.touch()
    (workspace / 'share' / 'param_tutorial').mkdir()
    return {**os.environ, **VARIABLES, 'PATH': f'{ros / "bin"}{os.pathsep}{os.environ["PATH"]}',
            'AMENT_PREFIX_PATH': f'{workspace}{os.pathsep}{ros}'}


def main(arguments: list[str]) -> int:
    with tempfile.TemporaryDirectory() as folder:
        return subprocess.run(
            [sys.executable, '-m', 'pytest', '-q', '-n', '4', '--dist', 'loadscope', '--nbval',
             *(arguments or ['notebooks'])],
            cwd=ROOT, env=machine(Path(folder)), check=False).returncode


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
