"""The learner's own copies of the chapters, in ``my_lessons/``, a folder that git ignores.

A copy in which the learner has changed nothing follows the course. A changed one stays as it is until the learner
resets it. ``.delivered/`` tells them apart: an empty file for each text ever delivered, named by a digest of that
text. ``backups/`` keeps the changed ones that were reset, and ``.trust/`` what JupyterLab knows of whose outputs to
trust.
"""

import contextlib
import hashlib
import os
import sqlite3
from collections.abc import Iterator
from pathlib import Path

import nbformat
from nbformat.sign import NotebookNotary

from param_tools.errors import ParameterToolError, nearest
from param_tutorial.learner import ticks
from param_tutorial.learner.progress import FILE, ProgressFile
from param_tutorial.learner.storage import time_stamp, write_whole
from param_tutorial.learner.syllabus import number_of, read_syllabus

CHAPTERS = 'notebooks'
COPIES = 'my_lessons'
# Names the folder of the copies where they can't be in the course's: it is installed, or for many to read.
LESSONS = 'PARAM_TUTORIAL_LESSONS'
BACKUPS = 'backups'
DELIVERED = '.delivered'
TRUST = '.trust'


class Copies:
    """The copies of one checkout's chapters."""

    def __init__(self, course: Path, folder: Path | None = None):
        """:param course: The checkout, with the folder of the chapters in it.
        :param folder: The folder of the copies; by default ``my_lessons/`` in the checkout.
        """
        self.chapters, self.folder = course / CHAPTERS, folder or course / COPIES
        self.trust = self.folder / TRUST
        self._course = course

    @classmethod
    def of_learner(cls, course: Path) -> 'Copies':
        """Return the copies of the user of this process, in the folder that its environment names, if it does."""
        folder = os.environ.get(LESSONS)
        return cls(course, Path(folder) if folder else None)

    def deliver(self) -> list[str]:
        """Put a copy of each chapter where there is none, and replace those that the learner has not changed.

        :return: What the learner should know, a sentence or two for each copy.
        :raises ParameterToolError: the folder can't be written; each copy is then as before or up to date.
        """
        first = not (self.folder / DELIVERED).exists()
        with self._made_folder():
            said = [sentence for name in self._names() if (sentence := self._bring(name))]
        self.tick()
        if first:
            said.append(f'Your own copies of the chapters are in {self._say(self.folder)}/. Change whatever you like '
                        f'there.')
        return said

    @property
    def progress(self) -> ProgressFile:
        """What the learner has solved."""
        return ProgressFile(self.folder / FILE)

    def tick(self) -> None:
        """Mark on the start page what the learner has solved."""
        progress, _ = self.progress.read()
        ticks.tick(self.folder, read_syllabus(self.chapters), progress.solved)

    def reset(self, chapter: str) -> str:
        """Make the copy of one chapter fresh again.

        :param chapter: Its number, such as 06 or 5.2, or its name.
        :return: What the learner should know.
        :raises ParameterToolError: there is no such chapter, or the folder can't be written.
        """
        names = {number_of(path.stem): path.name for path in sorted(self.chapters.glob('[0-9]*.ipynb'))}
        wanted = number_of(chapter.strip().removesuffix('.ipynb'))
        if wanted not in names:
            raise ParameterToolError(f'There is no chapter {chapter!r}{nearest(wanted, list(names), "There are none")}')
        name = Path(names[wanted])
        copy, fresh = self.folder / name, _fresh(self.chapters / name)
        with self._made_folder():
            if _bytes_of(copy) == fresh:
                return f'{self._say(copy)} is fresh already.'
            kept = self.folder / BACKUPS / time_stamp() / name if copy.exists() else None
            if kept:
                write_whole(kept, copy.read_bytes())
            self._give(name, fresh)
        said = f'{self._say(copy)} is fresh again.'
        if kept:
            said += (f' What was there is now {self._say(kept)}. If the chapter is open in JupyterLab, choose '
                     f'File, Reload Notebook from Disk.')
        return said

    def _names(self) -> list[Path]:
        """Return what learners get: notebooks, pages and pictures, and none of the tests' Python files."""
        found = (path.relative_to(self.chapters) for path in self.chapters.rglob('*') if path.is_file())
        return sorted(path for path in found
                      if path.suffix != '.py' and not any(part.startswith(('.', '__')) for part in path.parts))

    def _bring(self, name: Path) -> str | None:
        """Bring one copy up to date, unless the learner has changed it.

        :return: What the learner should know of it, if anything.
        """
        copy, fresh = self.folder / name, _fresh(self.chapters / name)
        content = _bytes_of(copy)
        new = self._delivered(_digest(name, fresh))
        mine = None if content is None else self._delivered(_digest(name, content))
        if mine is None or (mine != new and mine.exists()):
            self._give(name, fresh)
        elif mine == new or new.exists():  # it is the new version, or was made from it
            new.touch()
        else:
            is_chapter = name.suffix == '.ipynb' and name.parent == Path()
            remedy = (f'make reset CHAPTER={number_of(name.stem)} gives you the new one and keeps yours as a backup.'
                      if is_chapter else 'Rename or delete yours, and the next make lab brings the new one.')
            return (f'There is a new version of {self._say(copy)}. Yours stays as it is, because you have changed it. '
                    f'{remedy}')
        return None

    def _give(self, name: Path, fresh: bytes) -> None:
        """Put a fresh copy in its place; what was there is not kept."""
        if name.suffix == '.ipynb':
            # First: a signature without its notebook does no harm. Nor does a notebook without, until it has outputs.
            with contextlib.suppress(sqlite3.Error):
                notary = NotebookNotary(data_dir=str(self.trust))
                with contextlib.closing(notary.store):
                    notary.sign(nbformat.v4.reads(fresh.decode()))
        write_whole(self.folder / name, fresh)
        self._delivered(_digest(name, fresh)).touch()

    def _delivered(self, digest: str) -> Path:
        """Return the file that is there if a text with this digest was ever delivered."""
        return self.folder / DELIVERED / digest

    def _say(self, path: Path) -> str:
        return str(path.relative_to(self._course) if path.is_relative_to(self._course) else path)

    @contextlib.contextmanager
    def _made_folder(self) -> Iterator[None]:
        """Make the folder, and say in one sentence what the system rejects."""
        try:
            (self.folder / DELIVERED).mkdir(parents=True, exist_ok=True)
            self.trust.mkdir(mode=0o700, exist_ok=True)
            yield
        except OSError as error:
            raise ParameterToolError(
                f'Your copies of the chapters in {self.folder} could not be brought up to date; nothing of yours was '
                f'lost. The reason: {error.strerror}: {error.filename}.') from error


def _fresh(path: Path) -> bytes:
    """Return a file of the course as the learner gets it: a notebook without outputs, anything else as it is."""
    content = path.read_bytes()
    if path.suffix != '.ipynb':
        return content
    notebook = nbformat.v4.reads(content.decode())
    for cell in notebook.cells:
        if cell.cell_type == 'code':
            cell.outputs, cell.execution_count = [], None
    return f'{nbformat.v4.writes(notebook)}\n'.encode()


def _digest(name: Path, content: bytes) -> str:
    """Return the digest of a name and of what a learner can change in that file.

    Of a notebook that is the text of its cells: outputs come and go, and JupyterLab adds an empty cell at the end. Of
    the start page it is all but our own marks.
    """
    if name.suffix == '.ipynb':
        with contextlib.suppress(ValueError, TypeError, KeyError, AttributeError):  # it is no notebook any more
            cells = nbformat.v4.reads(content.decode('utf-8-sig')).cells
            texts = [(cell.cell_type, cell.source.splitlines(), cell.metadata.get('tags') or []) for cell in cells]
            content = repr([text for text in texts if any(map(str.strip, text[1]))]).encode()
    elif name == Path(ticks.PAGE):
        content = ticks.without_ticks(content.decode(errors='surrogateescape')).encode(errors='surrogateescape')
    return hashlib.sha256(f'{name}\n'.encode() + content).hexdigest()[:32]


def _bytes_of(path: Path) -> bytes | None:
    try:
        return path.read_bytes()
    except FileNotFoundError:
        return None
