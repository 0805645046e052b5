"""As much of numpy as the generated messages use, for where it is not installed: fixed arrays of bytes, such as UUIDs.

A web page has no numpy unless it is loaded, 3 MB for two fields that no lesson shows.
"""

import types
from collections.abc import Iterable
from typing import NoReturn


class uint8(int):  # as numpy calls it
    """What such an array holds."""


class ndarray(list[int]):  # as numpy calls it
    """An array of bytes."""

    def __init__(self, values: Iterable[int] = (), dtype: type = int):
        super().__init__(values)
        self.dtype = dtype

    @property
    def size(self) -> int:
        """How many elements it has."""
        return len(self)

    def copy(self) -> 'ndarray':
        """Return an array of its own with the same elements."""
        return ndarray(self, self.dtype)

    def __ne__(self, other: object) -> list[bool]:  # type: ignore[override]  # element by element, as in numpy
        return [one != another for one, another in zip(self, other, strict=True)]  # type: ignore[call-overload]


def _miss(name: str) -> NoReturn:
    """Say of everything else that there is no numpy; Python itself asks for names with underscores."""
    raise AttributeError(name) if name[0] == '_' else ModuleNotFoundError("No module named 'numpy'", name='numpy')


def make() -> types.ModuleType:
    """Return a module to be imported as numpy."""
    module = types.ModuleType('numpy', __doc__)
    vars(module).update(
        ndarray=ndarray, uint8=uint8, array=ndarray, zeros=lambda count, dtype=uint8: ndarray([0] * count, dtype),
        all=all, float64=float,  # IPython looks for the last one wherever there is a numpy
        __getattr__=_miss)
    return module
