"""What there is to solve in each chapter, read from the chapters themselves.

The room ``exercises`` knows the same, and a test compares the two; but importing that room loads rclpy, which
``make lab`` doesn't need.
"""

import re
from pathlib import Path

# The cell that checks an exercise.
_CHECK = re.compile(r'"id": "check-([\w-]+)"')


def read_syllabus(chapters: Path) -> dict[str, list[str]]:
    """Return the chapters in a folder, in order: the numbers of the exercises, by the name without its ending."""
    return {path.stem: [number.replace('-', '.') for number in _CHECK.findall(path.read_text('utf-8', 'replace'))]
            for path in sorted(chapters.glob('[0-9]*.ipynb'))}


def number_of(name: str) -> str:
    """Return the number of a chapter, e.g. '5.2', from its name, which begins with it: '05_2_…'; or else the name."""
    digits = re.match(r'0*([1-9]\d*)(?:[._](\d+))?(?=_|$)', name)
    return '.'.join(filter(None, digits.groups())) if digits else name
