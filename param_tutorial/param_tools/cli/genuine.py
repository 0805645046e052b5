"""The genuine ``ros2``, where ROS is installed, and what stands for it elsewhere."""

import contextlib
import functools
import os
import shutil
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

from param_tools.ros import domain
from param_tools.ros.environment import provided_packages

# What this process's own rclpy needs and another build of it must not find, and what `make` keeps away for the
# same reason.
_OURS = ('PYTHONPATH', 'PYTHONHOME', 'LD_LIBRARY_PATH', '_ROS_WHEELS_BOOTSTRAP_COMPLETE')

# As `python -m param_tools`, also where a workspace that holds a build of this package has been sourced, which puts the
# build in front: the folder of this package is named, and for this one process only.
_EMBEDDED = ('import sys; sys.path.insert(0, sys.argv.pop(1)); '
             'from param_tools.__main__ import main; sys.exit(main())')

OWN_COMMANDS = ('check', 'describe', 'snapshot', 'diff', 'restore', 'watch', 'history')
"""The commands that the genuine one has not."""


def path() -> str | None:
    """Return the path of the genuine command; None if there is none, or the environment forbids it.

    In the folder PARAM_TOOLS_STAND_IN stands a ``ros2`` that is the embedded one.
    """
    found = None if os.environ.get('PARAM_TOOLS_ROS2') == 'embedded' else shutil.which('ros2')
    return None if found and str(Path(found).parent) == os.environ.get('PARAM_TOOLS_STAND_IN') else found


def path_for(words: Sequence[str]) -> str | None:
    """Return the path of the genuine command if it runs these words after ``ros2``; None if the embedded one does.

    What only the embedded one has, it runs itself. So it does with the nodes of provided packages: nobody has built
    them, so the genuine one does not find them; and if somebody has, the build is for ROS's Python and holds what the
    package was then.
    """
    if (words[:1] and words[0] in (*OWN_COMMANDS, 'panel')) or '--all-nodes' in words:
        return None
    return None if words[:1] in (['run'], ['launch']) and any(map(_names_provided_package, words[1:])) else path()


def _names_provided_package(word: str) -> bool:
    """True for the name of a provided package, and for a launch file that names one."""
    if word in provided_packages():
        return True
    with contextlib.suppress(OSError, ValueError):
        return word.endswith('.py') and any(name in Path(word).read_text(encoding='utf-8')
                                            for name in provided_packages())
    return False


def embedded_words() -> list[str]:
    """Return what stands for ``ros2`` on the command line of a process, to start the embedded one."""
    return [sys.executable, '-c', _EMBEDDED, str(Path(__file__).parents[2])]


def command(words: Sequence[str]) -> tuple[list[str], dict[str, str]]:
    """Return the command line for these words after ``ros2``, and the environment in which it works."""
    genuine = path_for(words)
    return ([*embedded_words(), *words], dict(os.environ)) if genuine is None else command_of(genuine, words)


def command_of(genuine: str, words: Sequence[str]) -> tuple[list[str], dict[str, str]]:
    """Return the same where it is known that the genuine command, at this path, runs the words."""
    stop_daemon_in_the_end()
    return [genuine, *words], environment()


def environment() -> dict[str, str]:
    """Return the environment in which the genuine command works: this one's, with its own packages and libraries."""
    result = {name: value for name, value in os.environ.items() if name not in _OURS}
    sourced = [Path(each) for each in os.environ.get('AMENT_PREFIX_PATH', '').split(os.pathsep) if each]
    packages = [each for prefix in sourced for each in _python_packages(prefix)]
    libraries = [prefix / 'lib' for prefix in sourced if (prefix / 'lib').is_dir()]
    if packages:
        result['PYTHONPATH'] = os.pathsep.join(map(str, packages))
    if libraries:
        result['LD_LIBRARY_PATH'] = os.pathsep.join(map(str, libraries))
    return result


def _python_packages(prefix: Path) -> list[Path]:
    """Return the folders that sourcing an install space puts on PYTHONPATH."""
    # `colcon build --symlink-install` leaves a package in its build folder, as a hook in that folder says.
    hooks = [(prefix / line.partition(';')[2]).resolve() for listed in sorted(prefix.glob('share/*/package.dsv'))
             for line in listed.read_text().splitlines() if line.endswith('/pythonpath_develop.dsv')]
    developed = [Path(line.rpartition(';')[2]) for hook in hooks if hook.exists()
                 for line in hook.read_text().splitlines() if ';PYTHONPATH;' in line]
    installed = [each for pattern in ('lib/python3*/site-packages', 'local/lib/python3*/dist-packages')
                 for each in sorted(prefix.glob(pattern))]
    return [*developed, *installed]


@functools.cache
def stop_daemon_in_the_end() -> subprocess.Popen[bytes] | None:
    """Let the daemon that the genuine command starts in this process's own ROS domain end with this process.

    It would stay for two hours, holding the domain and 68 MB. In a domain that the user chose, it is the user's.

    :return: A shell that waits until its input is closed, which is when this process ends, also if it is killed. It is
        cached, so that the input stays open until then.
    """
    if not (genuine := path()) or not domain.is_claimed():
        return None
    return subprocess.Popen(['sh', '-c', 'read -r _; exec timeout 10 "$0" daemon stop', genuine], env=environment(),
                            stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                            start_new_session=True)
