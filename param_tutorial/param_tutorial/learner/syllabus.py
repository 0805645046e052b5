"""What there is to solve in each chapter, read from the chapters themselves.

The room ``exercises`` knows the same, and a test compares the two; but importing that room loads rclpy, which neither
``make lab`` nor ``make class`` needs.
"""

import re
from pathlib import Path
from typing import NamedTuple

# The cell that checks an exercise, and the call that asks a question.
_CHECK = re.compile(r'"id": "check-([\w-]+)"')
_QUESTION = re.compile(r"exercises\.(?:predict|recall)\('([\w.-]+)'\)")


class Lesson(NamedTuple):
    """One chapter, and the numbers of what there is to solve in it."""

    number: str
    name: str
    """Of its notebook, without the ending."""
    exercises: list[str]
    questions: list[str]
    """Predictions, and questions about earlier chapters."""


def read_syllabus(chapters: Path) -> list[Lesson]:
    """Return the chapters in a folder, in order."""
    lessons = []
    for path in sorted(chapters.glob('[0-9]*.ipynb')):
        text = path.read_text('utf-8', 'replace')
        exercises = [number.replace('-', '.') for number in _CHECK.findall(text)]
        lessons.append(Lesson(number_of(path.stem), path.stem, exercises, _QUESTION.findall(text)))
    return lessons


def number_of(name: str) -> str:
    """Return the number of a chapter, e.g. '5.2', from its name, which begins with it: '05_2_…'; or else the name."""
    digits = re.match(r'0*([1-9]\d*)(?:[._](\d+))?(?=_|$)', name)
    return '.'.join(filter(None, digits.groups())) if digits else name
