"""TOML files, also on Python 3.10, which has no tomllib."""

import sys
from pathlib import Path
from typing import Any

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib


def read_toml(path: Path) -> dict[str, Any]:
    """Return what is in a TOML file."""
    return tomllib.loads(path.read_text())
