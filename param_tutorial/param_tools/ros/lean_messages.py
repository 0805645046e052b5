"""Import what every node needs of ROS's messages, without what no node needs of it.

The messages import numpy for arrays of fixed length, and two parsers for generating code. Together these took 140 of
the 175 ms of the first ``start()`` of a kernel. numpy still comes when somebody wants something of it.
"""

import importlib
import sys
import types
from typing import Any


def import_messages() -> None:
    """Import them, unless that was done before. Afterwards ``sys.modules`` holds no stand-in."""
    code_generator, numpy = 'rosidl_generator_py.generate_py_impl', _LoadedWhenUsed('numpy')
    # rosidl_generator_py does without the code generator where that can't be imported, which None says. All that a
    # message wants of the package is one small function.
    sys.modules.setdefault(code_generator, None)  # type: ignore[arg-type]
    sys.modules.setdefault('numpy', numpy)
    try:
        # The two that hold such an array: every service has an event, which only service introspection fills, and
        # every goal of an action an identifier.
        for name in ('rosidl_generator_py', 'service_msgs.msg', 'unique_identifier_msgs.msg'):
            importlib.import_module(name)
    finally:
        if sys.modules.get(code_generator) is None:
            del sys.modules[code_generator]
        numpy.leave()


class _LoadedWhenUsed(types.ModuleType):
    """Stands for a module, in the files that have imported it, until somebody wants something of it."""

    def __getattr__(self, name: str) -> Any:
        # The import system looks at __spec__ in each import of a module that is there already.
        if name == '__spec__':
            raise AttributeError(name)
        self.leave()
        return getattr(importlib.import_module(self.__name__), name)

    def leave(self) -> None:
        """Let the next import have the module itself."""
        if sys.modules.get(self.__name__) is self:
            del sys.modules[self.__name__]
