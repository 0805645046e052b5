"""Public names that are imported when they are first used.

A package that offers much must not load all of it: checking a file needs no rclpy, and a node no widgets. Python 3.15
has ``lazy from … import …`` for this.
"""

import builtins
import importlib
import sys
import types
from collections.abc import Mapping, Sequence
from typing import Any


class Imports:
    """Notes the ``from … import …`` lines of a package in a ``with`` block, instead of importing anything.

    Editors and type checkers read the lines as they stand::

        with lazy.Imports(__name__) as imports:
            from package.module import Name as Name
        __getattr__, __dir__, __all__ = imports.load, imports.names, imports.public
    """

    def __init__(self, package: str):
        """:param package: The name of the package, which calls ``load`` as its ``__getattr__``."""
        self._package = package
        self._homes: dict[str, str] = {}

    def __enter__(self) -> 'Imports':
        self._import = builtins.__import__
        builtins.__import__ = self._note  # type: ignore[assignment]
        return self

    def __exit__(self, *_: object) -> None:
        builtins.__import__ = self._import
        for name in self._homes:
            delattr(sys.modules[self._package], name)

    def _note(self, module: str, globals: Mapping[str, Any] | None = None, locals: Any = None,
              names: Sequence[str] = (), level: int = 0) -> Any:
        if globals is None or globals.get('__name__') != self._package:  # another thread imports something
            return self._import(module, globals, locals, names, level)
        self._homes |= dict.fromkeys(names, module)
        return types.SimpleNamespace(**dict.fromkeys(names))

    @property
    def public(self) -> list[str]:
        """The names."""
        return sorted(self._homes)

    def names(self) -> list[str]:
        """Return what ``dir`` says of the package."""
        return sorted({*vars(sys.modules[self._package]), *self._homes})

    def load(self, name: str) -> Any:
        """Import what stands behind a name, and keep it in the package.

        :raises AttributeError: the package offers no such name.
        """
        if name not in self._homes:
            raise AttributeError(f'module {self._package!r} has no attribute {name!r}')
        home = self._homes[name]
        found = vars(importlib.import_module(home))
        # A module is a name of its package only once it has been imported.
        value = found[name] if name in found else importlib.import_module(f'{home}.{name}')
        setattr(sys.modules[self._package], name, value)
        return value
