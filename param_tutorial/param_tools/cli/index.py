"""Where packages are installed: the ament index, and in it the provided packages, which nobody has built.

``ament_index_python`` searches the install spaces in this process's AMENT_PREFIX_PATH. What is searched beyond them
stands there for the moment of the search only.
"""

import atexit
import contextlib
import functools
import importlib.util
import os
import tempfile
from collections.abc import Iterator, Mapping
from pathlib import Path

from ament_index_python.packages import get_package_prefix, get_package_share_directory

from param_tools.cli.session import CommandFailed
from param_tools.ros.environment import package_in_work, provided_packages

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


def share_folder_of(package: str) -> Path:
    """Return the folder that holds a package's launch and configuration files.

    :raises PackageNotFound: there is no such package.
    """
    # The error says where was searched, and should name no folder that nobody knows.
    with _not_found(), provided_packages_installed() if package in _sources() else contextlib.nullcontext():
        return Path(get_package_share_directory(package))


def provided(environment: Mapping[str, str] = os.environ) -> dict[str, str]:
    """Return the packages that count as installed although nobody has built them, as ``provided_packages`` does.

    :param environment: With PARAM_TOOLS_PROVIDED=0 in it, there are none.
    """
    return {} if environment.get('PARAM_TOOLS_PROVIDED') == '0' else provided_packages()


@contextlib.contextmanager
def provided_packages_installed() -> Iterator[None]:
    """Let ``ament_index_python`` find the provided packages, too, unless the environment forbids it."""
    # At the end: a package of the same name that has been built and sourced comes first.
    spaces = [os.environ.get(_SEARCH_PATH, ''), *(_stand_in(name, each) for name, each in _sources().items())]
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


def _sources() -> dict[str, Path]:
    """Return the folders of the packages that stand in without a build: the provided ones, and the one in work."""
    found = {name: source for name, nodes in provided().items() if (source := _source_folder(name, nodes))}
    in_work = package_in_work()
    return {**found, in_work.name: in_work} if in_work else found


def _source_folder(package: str, nodes: str) -> Path | None:
    """Return the folder of a provided package's package.xml, if its Python package is used where it lies."""
    found = importlib.util.find_spec(nodes.partition('.')[0])
    folder = Path(found.origin).parents[1] if found is not None and found.origin else None
    return folder if folder and folder.name == package and (folder / 'package.xml').exists() else None


@functools.cache
def _stand_in(package: str, source: Path) -> str:
    """Make what `colcon build` would make of a package's files, with links, for as long as this process lives."""
    folder = tempfile.TemporaryDirectory(prefix='param_tools_')
    atexit.register(folder.cleanup)
    marker = Path(folder.name, 'share/ament_index/resource_index/packages', package)
    share = Path(folder.name, 'share', package)
    marker.parent.mkdir(parents=True)
    marker.touch()
    share.mkdir()
    (share / 'launch').symlink_to(source / 'launch')
    # In a package in work, what is missing may come. config/ may also stand beside the package.
    config, beside = source / 'config', source.parent / 'config'
    (share / 'config').symlink_to(beside if beside.is_dir() and not config.is_dir() else config)
    return folder.name
