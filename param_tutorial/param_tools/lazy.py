"""Public names that are imported when they are first used.

A package that offers much must not load all of it: checking a file needs no rclpy, and a node no widgets.
"""

import importlib
import sys
from collections.abc import Mapping
from typing import Any


def load(package: str, homes: Mapping[str, str], name: str) -> Any:
    """Import what a package offers under a name, and keep it there.

    :param package: Its ``__getattr__`` calls this function.
    :param homes: For each public name the module that defines it; or, for a module, its own full name.
    :raises AttributeError: the package offers no such name.
    """
    if name not in homes:
        raise AttributeError(f'module {package!r} has no attribute {name!r}')
    home = importlib.import_module(homes[name])
    value = getattr(home, name, home)
    setattr(sys.modules[package], name, value)
    return value
