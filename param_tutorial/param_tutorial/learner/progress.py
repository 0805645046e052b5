"""The file that remembers what a learner has solved and predicted.

It is JSON: for each solved exercise when that was, for each one that was checked and is not solved yet what its last
check missed, and for each prediction what the learner committed to, whether it was right, and when. The first solution
and the first prediction count; later ones change nothing. Nothing is remembered unless ``make lab`` has
named the file in an environment variable, so tests write nothing.
"""

import datetime
import json
import os
from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from pathlib import Path

from param_tools.errors import ParameterToolError
from param_tutorial.learner.storage import only_one, time_stamp, write_whole

VARIABLE = 'PARAM_TUTORIAL_PROGRESS'
FILE = 'progress.json'
_VERSION = 1


@dataclass(frozen=True)
class Committed:
    """A prediction that a learner has committed to."""

    choice: str
    right: bool
    at: str
    """When, as local time in ISO 8601."""


@dataclass(frozen=True)
class Tried:
    """What the last check of an exercise has missed; no longer kept once it is solved."""

    met: int
    """How many requirements were met."""
    missed: dict[str, str]
    """The sentences of those that were not, and what happened instead."""
    times: int
    """How many checks have said something else than the one before: once for a blank that runs with all cells."""
    at: str
    """When, as local time in ISO 8601."""


@dataclass
class Progress:
    """What a learner has achieved, by the numbers of exercises and predictions."""

    solved: dict[str, str] = field(default_factory=dict)
    """When each was solved, as local time in ISO 8601."""
    tried: dict[str, Tried] = field(default_factory=dict)
    predicted: dict[str, Committed] = field(default_factory=dict)


def parse(content: bytes) -> Progress:
    """Return what a file holds.

    :raises ParameterToolError: it is damaged, or no file of progress at all.
    """
    try:
        data = json.loads(content)
        if data['version'] != _VERSION:
            raise ParameterToolError(f'it is of version {data["version"]!r}, and this course knows version {_VERSION}')
        # A file from before failed checks were kept has no 'tried'.
        progress = Progress(dict(data['solved']),
                            {number: Tried(**each) for number, each in data.get('tried', {}).items()},
                            {number: Committed(**each) for number, each in data['predicted'].items()})
    except (ValueError, TypeError, KeyError, AttributeError) as error:
        raise ParameterToolError(f'it holds no progress ({type(error).__name__})') from None
    return progress


class ProgressFile:
    """One learner's file. No method raises for a file that is missing, damaged or can't be written."""

    def __init__(self, path: Path):
        self.path = path

    def read(self) -> tuple[Progress, str]:
        """Return what is remembered, and what the learner should know if the file can't be read."""
        try:
            return parse(self.path.read_bytes()), ''
        except FileNotFoundError:
            return Progress(), ''
        except (OSError, ParameterToolError) as error:
            return Progress(), f"{self.path.name} can't be read: {error}."

    def add_solved(self, number: str) -> str:
        """Remember that an exercise is solved.

        :return: What the learner should know, if anything went wrong; otherwise an empty text.
        """
        def add(progress: Progress) -> None:
            progress.solved.setdefault(number, _now())
            progress.tried.pop(number, None)

        return self._change(add)

    def add_tried(self, number: str, met: int, missed: dict[str, str]) -> str:
        """Remember what a check has missed, unless the exercise was solved before; returns as ``add_solved`` does."""
        def add(progress: Progress) -> None:
            before = progress.tried.get(number)
            if number not in progress.solved and (before is None or (before.met, before.missed) != (met, missed)):
                progress.tried[number] = Tried(met, missed, 1 + (before.times if before else 0), _now())

        return self._change(add)

    def add_prediction(self, number: str, choice: str, *, right: bool) -> str:
        """Remember what a learner has predicted; returns as ``add_solved`` does."""
        return self._change(lambda progress: progress.predicted.setdefault(number, Committed(choice, right, _now())))

    def _change(self, change: Callable[[Progress], object]) -> str:
        said = ''
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            with only_one(self.path.parent):
                progress = Progress()
                if self.path.exists():
                    try:
                        progress = parse(self.path.read_bytes())
                    except ParameterToolError as error:
                        name = f'{self.path.stem}-damaged-{time_stamp()}{self.path.suffix}'
                        kept = self.path.rename(self.path.with_name(name))
                        said = f'Your {self.path.name} could not be read: {error}. It is kept as {kept.name}.'
                before = _text_of(progress)
                change(progress)
                if _text_of(progress) != before:
                    write_whole(self.path, _text_of(progress).encode())
        except OSError as error:
            said = f'This could not be remembered in {self.path.name}: {error.strerror}.'
        return said


def own_progress() -> ProgressFile | None:
    """Return the learner's file; None if nothing is to be remembered, as in tests."""
    path = os.environ.get(VARIABLE)
    return ProgressFile(Path(path)) if path else None


def _text_of(progress: Progress) -> str:
    return json.dumps({'version': _VERSION, **asdict(progress)}, indent=1, ensure_ascii=False) + '\n'


def _now() -> str:
    return datetime.datetime.now().isoformat(timespec='seconds')
