"""What an engineer's environment holds that the tools can't work with, and which packages need no build.

Most of it stands in a ``.bashrc``, where it is right for a robot. Processes that this one starts inherit what is left.
"""

import functools
import os
import sys
from collections.abc import Mapping
from importlib.metadata import entry_points
from pathlib import Path

PACKAGE_IN_WORK = 'PARAM_TOOLS_PACKAGE_IN_WORK'
_MIDDLEWARE = 'RMW_IMPLEMENTATION'
# In a ROS domain of our own on this host, each of them keeps processes from finding each other, stops them with an
# error, or has every one of them print a warning.
_NETWORKS = ('ROS_DISCOVERY_SERVER', 'ROS_SUPER_CLIENT', 'ROS_LOCALHOST_ONLY', 'ROS_SECURITY_ENABLE')
_INSTALL_SPACES = ('AMENT_PREFIX_PATH', 'COLCON_PREFIX_PATH')


@functools.cache
def provided_packages() -> dict[str, str]:
    """Return the ROS packages that Python distributions in this environment provide without a build.

    :return: The name of each package, with the Python package that holds its nodes: one module for each node, and
        ``python -m PACKAGE NODE`` runs one. Distributions name both in the entry-point group ``param_tools.packages``.
    """
    return {each.name: each.value for each in entry_points(group='param_tools.packages')}


def package_in_work(environment: Mapping[str, str] = os.environ) -> Path | None:
    """Return the folder of the package that a notebook follows, which its commands use without a build.

    :param environment: Names the folder in PARAM_TOOLS_PACKAGE_IN_WORK; None is returned if it names none.
    """
    folder = environment.get(PACKAGE_IN_WORK)
    return Path(folder) if folder else None


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
    """Take install spaces that hold a build of a provided package off the search path.

    Such a build is of the package as it once was, and for another Python.
    """
    for name in _INSTALL_SPACES:
        if name in os.environ:
            os.environ[name] = os.pathsep.join(each for each in os.environ[name].split(os.pathsep) if not any(
                _holds(Path(each), package) for package in provided_packages()))


def _holds(space: Path, package: str) -> bool:
    # With colcon's --merge-install, and without: there COLCON_PREFIX_PATH names the folder above.
    marker = Path('share', 'ament_index', 'resource_index', 'packages', package)
    return any((folder / marker).exists() for folder in (space, space / package))
