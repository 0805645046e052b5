"""Puts a new folder in the place of an old one, so that at every moment one of them is there, whole."""

import ctypes
import os
import shutil
from pathlib import Path

# Of Linux: see renameat2(2).
_AT_FDCWD, _RENAME_EXCHANGE = -100, 2


def replace(new: Path, target: Path) -> None:
    """Put a copy of a folder in the place of another, as a whole: at no moment is there none, or a part of one."""
    recover(target)
    beside, old = _beside(target)
    shutil.rmtree(beside, ignore_errors=True)
    shutil.copytree(new, beside, ignore=shutil.ignore_patterns('.buildinfo*', '_sources', '*.map'))
    if not target.exists():
        beside.rename(target)
    elif not _exchange(beside, target):
        target.rename(old)
        beside.rename(target)
    for folder in (beside, old):
        shutil.rmtree(folder, ignore_errors=True)


def recover(target: Path) -> None:
    """Bring back the site that a build had put aside when it was ended."""
    _, old = _beside(target)
    if old.exists() and not target.exists():
        old.rename(target)
    shutil.rmtree(old, ignore_errors=True)


def _beside(target: Path) -> tuple[Path, Path]:
    """Return where a new site is written, and where the old one goes if it cannot be exchanged in one step."""
    return target.with_name(f'{target.name}.new'), target.with_name(f'{target.name}.old')


def _exchange(one: Path, other: Path) -> bool:
    """Let two folders change their names in one step, and return True; False where the system can't do that."""
    try:
        renameat2 = ctypes.CDLL(None, use_errno=True).renameat2
    except AttributeError:
        return False
    return bool(renameat2(_AT_FDCWD, os.fsencode(one), _AT_FDCWD, os.fsencode(other), _RENAME_EXCHANGE) == 0)
