"""Put the layer where rclpy looks for its compiled module, and where messages look for theirs.

``install()`` comes before the first import of rclpy. From then on Python finds this layer under the names of the
compiled modules; the files of rclpy and of the messages stay as they are.
"""

import importlib.util
import multiprocessing
import sys
import threading
import types
from collections.abc import Sequence
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec, PathFinder

from param_tools.errors import LayerError
from param_tools.rcl_in_python import arrays, module

_COMPILED = 'rclpy._rclpy_pybind11'
_TYPE_SUPPORT = '_s__rosidl_typesupport_c'
_NUMPY = 'numpy'


class _TypeSupport(types.ModuleType):
    """A package's compiled messages: whatever is asked of it is there, and nobody looks inside."""

    def __getattr__(self, name: str) -> str:
        if name.startswith('__'):
            raise AttributeError(name)
        return f'{self.__name__}.{name}'


class Lock:
    """A lock as ``multiprocessing.Lock()`` returns it, for the threads of one process."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self.release = self._lock.release

    def acquire(self, block: bool = True, timeout: float | None = None) -> bool:
        return self._lock.acquire(block, -1 if timeout is None or not block else max(0.0, timeout))

    def __enter__(self) -> bool:
        return self.acquire()

    def __exit__(self, *_: object) -> None:
        self.release()


class _Finder(MetaPathFinder, Loader):
    """Finds the layer under the names of compiled modules, and a little of numpy if nobody else does."""

    def find_spec(self, name: str, path: Sequence[str] | None, target: types.ModuleType | None = None,
                  ) -> ModuleSpec | None:
        is_numpy_missing = name == _NUMPY and PathFinder.find_spec(_NUMPY) is None
        if name == _COMPILED or name.endswith(_TYPE_SUPPORT) or is_numpy_missing:
            return ModuleSpec(name, self, origin='rclpy in Python')
        return None

    def create_module(self, spec: ModuleSpec) -> types.ModuleType:
        if spec.name == _COMPILED:
            return module.make(spec.name)
        return arrays.make() if spec.name == _NUMPY else _TypeSupport(spec.name)

    def exec_module(self, _: types.ModuleType) -> None:
        """There is nothing left to do."""


def is_installed() -> bool:
    """True if rclpy stands on this layer in this process, or will when it is imported."""
    return any(isinstance(each, _Finder) for each in sys.meta_path)


def install(*, even_beside_the_real_one: bool = False) -> None:
    """Have rclpy stand on this layer in this process; safe to call more than once.

    :param even_beside_the_real_one: Also where rclpy's compiled module is installed, as tests do.
    :raises LayerError: it is installed, or is in use already.
    """
    if is_installed():
        return
    if _COMPILED in sys.modules:
        raise LayerError('rclpy is imported already, with its compiled layer: install rclpy in Python before that')
    if not even_beside_the_real_one and _has_compiled_layer():
        raise LayerError('the real rclpy is installed here, and its nodes reach other processes: use it')
    sys.meta_path.insert(0, _Finder())
    if PathFinder.find_spec('_multiprocessing') is None:  # rclpy takes its lock from there, and means threads
        multiprocessing.Lock = Lock  # type: ignore[assignment]


def _has_compiled_layer() -> bool:
    package = importlib.util.find_spec('rclpy')
    if package is None or package.submodule_search_locations is None:
        return False
    return PathFinder.find_spec(_COMPILED, package.submodule_search_locations) is not None
