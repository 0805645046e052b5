"""The genuine ``ros2``, where ROS is installed, and what stands for it elsewhere."""

import os
import shutil
import sys
from pathlib import Path

# What this process's own rclpy needs and another build of it must not find, and what `make` keeps away for the
# same reason.
_OURS = ('PYTHONPATH', 'PYTHONHOME', 'LD_LIBRARY_PATH', '_ROS_WHEELS_BOOTSTRAP_COMPLETE')

# As `python -m param_tutorial`, also where a learner's workspace holds a package of this name and has been sourced,
# which puts it in front: the folder of the course's own is named, and for this one process only.
_EMBEDDED = ('import sys; sys.path.insert(0, sys.argv.pop(1)); '
             'from param_tutorial.__main__ import main; sys.exit(main())')


def path() -> str | None:
    """Return the path of the genuine command; None if there is none, or the environment forbids it."""
    return None if os.environ.get('PARAM_TUTORIAL_ROS2') == 'embedded' else shutil.which('ros2')


def words() -> list[str]:
    """Return what stands for ``ros2`` on a command line: the genuine one, or else the embedded one."""
    genuine = path()
    if genuine is not None:
        return [genuine]
    return [sys.executable, '-c', _EMBEDDED, str(Path(__file__).parents[2])]


def environment() -> dict[str, str]:
    """Return the environment in which it works: this one's, with its own Python packages and libraries."""
    result = {name: value for name, value in os.environ.items() if name not in _OURS}
    sourced = [Path(each) for each in os.environ.get('AMENT_PREFIX_PATH', '').split(os.pathsep) if each]
    packages = [each for prefix in sourced for pattern in (
        'lib/python3*/site-packages', 'local/lib/python3*/dist-packages') for each in sorted(prefix.glob(pattern))]
    libraries = [prefix / 'lib' for prefix in sourced if (prefix / 'lib').is_dir()]
    if packages:
        result['PYTHONPATH'] = os.pathsep.join(map(str, packages))
    if libraries:
        result['LD_LIBRARY_PATH'] = os.pathsep.join(map(str, libraries))
    return result
