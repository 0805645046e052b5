"""The reader's own ROS 2 package, ``my_robot``: its files, what is kept of them, and ours to go on with. No ROS.

``steps/`` holds the package as it should stand after each step of the course: for each step a folder with the files
that it changes. A step goes by the number of its exercise, such as '3c'; '2' is what ``ros2 pkg create`` writes.
"""

import atexit
import os
import re
import shutil
import tempfile
from functools import cache
from pathlib import Path

from param_tools.errors import ParameterToolError, nearest
from param_tutorial.learner.progress import own_progress
from param_tutorial.learner.storage import time_stamp, write_whole

NAME = 'my_robot'
WORKSPACE = Path('ros2_ws')
STEPS = Path(__file__).parents[1] / 'steps'
passed: set[str] = set()
"""The steps that the reader's package has passed in this process, whether or not that is remembered."""


@cache
def steps() -> tuple[str, ...]:
    """Return the numbers of all steps, in the order of the course."""
    return tuple(sorted((each.name for each in STEPS.iterdir() if each.name[0].isdigit()), key=_place))


def _place(number: str) -> tuple[list[int], str]:
    digits = re.findall(r'\d+', number)
    return [int(each) for each in digits], number.lstrip('0123456789.')


def last_step_before(chapter: str) -> str:
    """Return the last step of the chapters before one.

    :param chapter: Its number, such as '4' or '5.2'.
    :raises ParameterToolError: there is none.
    """
    earlier = [each for each in steps() if _place(each) < _place(chapter)]
    if not earlier:
        raise ParameterToolError(f'The package begins in chapter 2, so chapter {chapter!r} has nothing to begin with.')
    return earlier[-1]


@cache
def ours(step: str) -> dict[str, str]:
    """Return our package as it stands after a step: the text of each file by its path in the package.

    :raises ParameterToolError: there is no such step.
    """
    if step not in steps():
        raise ParameterToolError(f'There is no step {step!r}{nearest(step, steps(), "There are none")}')
    return {name: (STEPS / each / name).read_text(encoding='utf-8')
            for each in steps()[:steps().index(step) + 1] for name in changed_in(each)}


def changed_in(step: str) -> list[str]:
    """Return the paths of the files that a step changes."""
    return [path.relative_to(STEPS / step).as_posix() for path in sorted((STEPS / step).rglob('*'))
            if path.is_file() and '__pycache__' not in path.parts]


@cache
def our_copy(step: str) -> Path:
    """Return a folder with our package as it stands after a step; it is there as long as this process.

    :raises ParameterToolError: there is no such step.
    """
    files = PackageFiles(_temporary_folder() / f'step_{step}')
    files.lay_out(step)
    return files.root


@cache
def _temporary_folder() -> Path:
    folder = tempfile.mkdtemp(prefix='my_lessons_')
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return Path(folder)


class PackageFiles:
    """The files of the reader's package, in a folder of lessons."""

    def __init__(self, lessons: Path):
        self.lessons = lessons
        self.root = lessons / WORKSPACE / 'src' / NAME
        self.backups = lessons / WORKSPACE / 'backups'

    @classmethod
    def of_learner(cls) -> 'PackageFiles':
        """Return those in the folder that ``make lab`` has named.

        Where it has named none, as in tests, it is a temporary one, which this process works in from then on.
        """
        if progress := own_progress():
            return cls(progress.path.parent)
        folder = _temporary_folder()
        os.chdir(folder)
        return cls(folder)

    @classmethod
    def apart(cls) -> 'PackageFiles':
        """Return those in a folder that is empty, and goes with this process."""
        return cls(Path(tempfile.mkdtemp(dir=_temporary_folder())))

    @staticmethod
    def place(name: str) -> str:
        """Return the path of a file in the package.

        :param name: The same, or the name of a node's file without its folder: 'driver_node.py'.
        """
        return f'{NAME}/{name}' if name.endswith('_node.py') and '/' not in name else name

    def path(self, name: str) -> Path:
        """Return the path of a file; for its name, see ``place``."""
        return self.root / self.place(name)

    def text(self, name: str) -> str:
        """Return the text of a file; it is empty if there is none.

        :raises ParameterToolError: it is no text.
        """
        try:
            return self.path(name).read_text(encoding='utf-8')
        except FileNotFoundError:
            return ''
        except (OSError, UnicodeDecodeError) as error:
            raise ParameterToolError(f'{name} cannot be read: {error}') from None

    def lay_out(self, step: str) -> None:
        """Write those files of ours that the reader does not have."""
        for name, text in ours(step).items():
            if not (self.root / name).exists():
                self._write(name, text)

    def write(self, name: str, text: str, base: str) -> None:
        """Write a file of the reader's.

        :param base: The text that the reader has changed. If another is there now, that is kept as a backup.
        :raises ParameterToolError: it cannot be written; what was there is there still.
        """
        if self.text(name) != base:
            self.back_up(name, text)
        self._write(name, text)

    def take(self, step: str) -> Path | None:
        """Put ours in the place of the reader's files, as it stands after a step.

        :return: Where theirs are kept; None if none differed.
        :raises ParameterToolError: there is no such step, or a file cannot be written.
        """
        stamp, kept = time_stamp(), None
        for name, text in ours(step).items():
            kept = self.back_up(name, text, stamp) or kept
            self._write(name, text)
        return kept and self.backups / stamp

    def back_up(self, name: str, new: str, stamp: str = '') -> Path | None:
        """Keep a file as it is, if another text is to take its place; return where it is kept."""
        place, before = self.place(name), self.text(name)
        if not before.strip() or before in (new, *(ours(step).get(place) for step in steps())):
            return None
        kept = self.backups / (stamp or time_stamp()) / place
        _write_text(kept, before)
        # A second package of this name, and colcon builds none.
        _write_text(self.backups / 'COLCON_IGNORE', '')
        return kept

    def _write(self, name: str, text: str) -> None:
        _write_text(self.path(name), text)


def _write_text(path: Path, text: str) -> None:
    try:
        write_whole(path, text.encode())
    except OSError as error:
        raise ParameterToolError(f'{path} cannot be written: {error.strerror}') from None

