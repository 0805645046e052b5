"""Where packages are installed: the ament index, and in it the course's own package where nobody has built it.

``ament_index_python`` searches the install spaces in this process's AMENT_PREFIX_PATH. What is searched beyond them
stands there for the moment of the search only.
"""

import atexit
import contextlib
import functools
import os
import tempfile
from collections.abc import Iterator, Mapping
from pathlib import Path

from ament_index_python.packages import (
    get_package_prefix,
    get_package_share_directory,
    get_packages_with_prefixes,
)

from param_tutorial.ros2.session import CommandFailed
from param_tutorial.runtime.surroundings import PACKAGE

_SEARCH_PATH = 'AMENT_PREFIX_PATH'


class PackageNotFound(CommandFailed):
    """The install spaces hold no package of that name; the message is the index's own."""


def prefix_of(package: str, search_path: str) -> Path:
    """Return the install space that holds a package.

    :param search_path: The install spaces to search, as in AMENT_PREFIX_PATH.
    :raises PackageNotFound: none of them does.
    """
    with _not_found(), _searching(search_path):
        return Path(get_package_prefix(package))


def sourced_packages() -> list[str]:
    """Return the names of all packages in the install spaces that have been sourced, sorted; none if none has."""
    return sorted(get_packages_with_prefixes()) if os.environ.get(_SEARCH_PATH) else []


def share_folder_of(package: str) -> Path:
    """Return the folder that holds a package's launch and configuration files.

    :raises PackageNotFound: there is no such package.
    """
    with _not_found(), own_package_installed():
        return Path(get_package_share_directory(package))


def has_own_nodes(environment: Mapping[str, str] = os.environ) -> bool:
    """True if the course's own package counts as installed where nobody has built it."""
    return environment.get('PARAM_TUTORIAL_OWN_NODES') != '0'


@contextlib.contextmanager
def own_package_installed() -> Iterator[None]:
    """Let ``ament_index_python`` find the course's own package, too, unless the environment forbids it."""
    spaces = [os.environ.get(_SEARCH_PATH, '')]
    if has_own_nodes() and (checkout := _checkout()):
        # At the end: a package of this name that has been built and sourced comes first.
        spaces.append(_stand_in(checkout))
    with _searching(os.pathsep.join(filter(None, spaces))):
        yield


@contextlib.contextmanager
def _not_found() -> Iterator[None]:
    try:
        yield
    # No such package, nothing sourced at all, and what cannot be the name of a package.
    except (LookupError, OSError, ValueError) as error:
        raise PackageNotFound(error) from None


@contextlib.contextmanager
def _searching(search_path: str) -> Iterator[None]:
    before = os.environ.get(_SEARCH_PATH)
    os.environ[_SEARCH_PATH] = search_path
    try:
        yield
    finally:
        if before is None:
            del os.environ[_SEARCH_PATH]
        else:
            os.environ[_SEARCH_PATH] = before


def _checkout() -> Path | None:
    """Return the folder of the course, if this package is used where it lies."""
    root = Path(__file__).parents[3]
    return root if (root / PACKAGE / 'package.xml').exists() else None


@functools.cache
def _stand_in(checkout: Path) -> str:
    """Make what `colcon build` would make of the course's own files, with links, for as long as this process lives."""
    folder = tempfile.TemporaryDirectory(prefix='param_tutorial_')
    atexit.register(folder.cleanup)
    marker = Path(folder.name, 'share/ament_index/resource_index/packages', PACKAGE)
    share = Path(folder.name, 'share', PACKAGE)
    marker.parent.mkdir(parents=True)
    marker.touch()
    share.mkdir()
    for name, source in (('launch', checkout / PACKAGE / 'launch'), ('config', checkout / 'config')):
        (share / name).symlink_to(source)
    return folder.name
