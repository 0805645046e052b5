"""What an engineer's environment holds that nothing of the course could work with. No ROS, no Jupyter.

Most of it stands in a ``.bashrc``, where it is right for a robot. Processes that this one starts inherit what is left.
"""

import os
import sys
from pathlib import Path

_MIDDLEWARE = 'RMW_IMPLEMENTATION'
# In a ROS domain of our own on this host, each of them keeps processes from finding each other, stops them with an
# error, or has every one of them print a warning.
_NETWORKS = ('ROS_DISCOVERY_SERVER', 'ROS_SUPER_CLIENT', 'ROS_LOCALHOST_ONLY', 'ROS_SECURITY_ENABLE')
_INSTALL_SPACES = ('AMENT_PREFIX_PATH', 'COLCON_PREFIX_PATH')
# The name of the course's package, to ROS and to Python.
PACKAGE = __name__.partition('.')[0]


def drop_missing_middleware() -> None:
    """Take RMW_IMPLEMENTATION out of the environment, and say so, if it names a middleware that is not here.

    Call it before rclpy is imported: while rcl's library is loaded, it compares the variable with the middleware that
    it was linked to, and ends the whole process with exit status 102 (``rmw_implementation_identifier_check.c``).
    Where ROS is installed outside this Python, its libraries are elsewhere, and the variable stays as it is.
    """
    chosen = os.environ.get(_MIDDLEWARE)
    libraries = Path(sys.prefix, 'lib')
    if chosen and (libraries / 'librcl.so').exists() and not (libraries / f'lib{chosen}.so').exists():
        del os.environ[_MIDDLEWARE]
        print(f'{_MIDDLEWARE} is {chosen}, which this Python does not have: continuing with the default.',
              file=sys.stderr)


def drop_networks() -> None:
    """Take the settings for a robot's network out of the environment, for a process with a domain of its own."""
    for name in _NETWORKS:
        os.environ.pop(name, None)
    if os.environ.get('ROS_AUTOMATIC_DISCOVERY_RANGE', '').upper() == 'OFF':
        del os.environ['ROS_AUTOMATIC_DISCOVERY_RANGE']


def drop_old_builds() -> None:
    """Take install spaces that hold a build of the course's package off the search path.

    Such a build is of the package as it once was, and for another Python. A lesson that builds the package sources it
    in a shell of its own.
    """
    for name in _INSTALL_SPACES:
        if name in os.environ:
            os.environ[name] = os.pathsep.join(each for each in os.environ[name].split(os.pathsep)
                                               if not _holds_the_package(Path(each)))


def _holds_the_package(space: Path) -> bool:
    # With colcon's --merge-install, and without: there COLCON_PREFIX_PATH names the folder above.
    marker = Path('share', 'ament_index', 'resource_index', 'packages', PACKAGE)
    return any((folder / marker).exists() for folder in (space, space / PACKAGE))
