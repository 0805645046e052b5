"""Puts a new folder in the place of an old one, which stays until the new one is whole."""

import shutil
from pathlib import Path


def replace(new: Path, target: Path) -> None:
    """Put a copy of a folder in the place of another, as a whole."""
    beside, old = target.with_name(f'{target.name}.new'), target.with_name(f'{target.name}.old')
    shutil.rmtree(beside, ignore_errors=True)
    shutil.copytree(new, beside, ignore=shutil.ignore_patterns('.buildinfo*', '_sources', '*.map'))
    shutil.rmtree(old, ignore_errors=True)
    if target.exists():
        target.rename(old)
    beside.rename(target)
    shutil.rmtree(old, ignore_errors=True)
