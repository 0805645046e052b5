"""The learner's own copies of the chapters, in ``my_lessons/``, a folder that git ignores.

Beside the copies lie ``backups/``, with every file of the learner's as it was before it was changed here, and two
hidden folders: what was delivered, and what JupyterLab knows of whose outputs to trust.

A copy names the version of the chapter that it was made from, in its own metadata. So it never disagrees with the
version it was merged into last, whatever is interrupted, and also if JupyterLab saves an older state over it.
"""

import contextlib
import datetime
import errno
import hashlib
import os
import re
import sqlite3
from collections.abc import Iterator
from pathlib import Path

import nbformat
from nbformat.notebooknode import NotebookNode
from nbformat.sign import NotebookNotary

from param_tools.errors import ParameterToolError
from param_tutorial.learner.merging import merge
from param_tutorial.progress import ticks
from param_tutorial.progress.record import FILE, ProgressFile
from param_tutorial.progress.storage import only_one, write_whole

CHAPTERS = 'notebooks'
COPIES = 'my_lessons'
# Names the folder of the copies where they can't be in the course's: it is installed, or for many to read.
LESSONS = 'PARAM_TUTORIAL_LESSONS'
BACKUPS = 'backups'
DELIVERED = '.delivered'
TRUST = '.trust'
# Where the version of the chapter stands in a copy's metadata.
_KEY = 'param_tutorial'
# The cell that checks an exercise. The room ``exercises`` knows them too, but importing it loads rclpy.
_CHECK = re.compile(r'"id": "check-([\w-]+)"')


class CopiesError(ParameterToolError):
    """The learner's copies of the chapters cannot be read or written; the message is for the learner."""


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
        """Put a copy of each chapter where there is none, and bring what has changed into the others.

        :return: What the learner should know, a sentence each.
        :raises CopiesError: the folder can't be written; each copy is then as before or up to date.
        """
        first = not (self.folder / DELIVERED).exists()
        with self._folder_of_ours():
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
        exercises = {}
        for path in sorted(self.chapters.glob('[0-9]*.ipynb')):
            found = _CHECK.findall(path.read_text('utf-8', 'replace'))
            exercises[path.stem] = [number.replace('-', '.') for number in found]
        progress, _ = self.progress.read()
        ticks.tick(self.folder, exercises, progress.solved)

    def reset(self, chapter: str) -> str:
        """Make the copy of one chapter fresh again.

        :param chapter: Its number, such as 06 or 5.2, or its name.
        :return: What the learner should know.
        :raises CopiesError: there is no such chapter, or the folder can't be written.
        """
        name = self._find(chapter)
        copy = self.folder / name
        with self._folder_of_ours():
            fresh = _Chapter(self.chapters / name)
            if _bytes_of(copy) == fresh.text.encode():
                return f'{self._say(copy)} is fresh already.'
            kept = self._back_up(name) if copy.exists() else None
            self._give(fresh, name)
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

    def _find(self, chapter: str) -> Path:
        """Return the file of the chapter with this number or name."""
        names = sorted(path.name for path in self.chapters.glob('[0-9]*.ipynb'))
        wanted = chapter.strip().removesuffix('.ipynb').replace('.', '_').lstrip('0') + '_'
        found = [name for name in names if wanted != '_' and (Path(name).stem.lstrip('0') + '_').startswith(wanted)]
        if len(found) != 1:
            reason = 'is the number of several' if found else 'is not a chapter'
            there = ', '.join(name.removesuffix('.ipynb') for name in found or names) or 'none'
            raise CopiesError(f'{chapter!r} {reason}. There are: {there}')
        return Path(found[0])

    def _bring(self, name: Path) -> str | None:
        return self._bring_notebook(name) if name.suffix == '.ipynb' else self._bring_page(name)

    def _bring_notebook(self, name: Path) -> str | None:
        """Bring one notebook up to date.

        :return: What the learner should know of it, if anything.
        """
        try:
            fresh = _Chapter(self.chapters / name)
        except CopiesError as error:
            return f'{error} Your copy stays as it is.'
        copy = self.folder / name
        content = _bytes_of(copy)
        if content is None:
            self._give(fresh, name)
            return None
        mine = _parse(content)
        if mine is None:
            kept = self._back_up(name)
            self._give(fresh, name)
            return (f'{self._say(copy)} was not a notebook any more. A fresh copy is in its place; what was there is '
                    f'now {self._say(kept)}.')
        version = _version_of(mine)
        if version == fresh.version:
            self._write_delivered(fresh)
            return None
        base = _bytes_of(self._delivered(version))
        if base is None:
            return (f'{self._say(copy)} does not say which version of the chapter it was made from, so it stays as it '
                    f'is. make reset CHAPTER={name.stem} gives you a fresh copy and keeps this one.')
        if content == base:
            self._give(fresh, name)
            return None
        kept, trusted = self._back_up(name), self._is_trusted(mine)
        self._write_delivered(fresh)
        merged = merge(nbformat.v4.reads(base.decode()), mine, fresh.notebook)
        self._write_notebook(copy, nbformat.v4.writes(merged) + '\n', trusted=trusted)
        return (f'The course has changed {self._say(copy)}. Your work is in the new version; the file as it was is '
                f'now {self._say(kept)}.')

    def _bring_page(self, name: Path) -> str | None:
        """Bring a page or a picture up to date. There is nothing to merge it by: a new one takes its place."""
        content, copy = (self.chapters / name).read_bytes(), self.folder / name
        mine, kept = _bytes_of(copy), None
        if mine is not None and name == Path(ticks.PAGE):
            # Our own marks are no change of the learner's.
            mine = ticks.without_ticks(mine.decode(errors='surrogateescape')).encode(errors='surrogateescape')
        if mine != content:
            changed_by_learner = mine is not None and not self._delivered(_digest(mine)).exists()
            if changed_by_learner and self._delivered(_digest(content)).exists():
                return None
            kept = self._back_up(name) if changed_by_learner else None
            write_whole(copy, content)
        # Last: what is not recorded as delivered is brought again.
        self._record(_digest(content), content)
        if kept is None:
            return None
        return f'The course has changed {self._say(copy)}. The page as it was is now {self._say(kept)}.'

    def _give(self, fresh: '_Chapter', name: Path) -> None:
        """Put a fresh copy in its place; what was there is not kept."""
        self._write_delivered(fresh)
        self._write_notebook(self.folder / name, fresh.text, trusted=True)

    def _write_delivered(self, fresh: '_Chapter') -> None:
        """Keep what is delivered, to compare with later; before the copy, which names it."""
        self._record(fresh.version, fresh.text.encode())

    def _record(self, version: str, content: bytes) -> None:
        if not self._delivered(version).exists():
            write_whole(self._delivered(version), content)

    def _delivered(self, version: str) -> Path:
        return self.folder / DELIVERED / version

    def _back_up(self, name: Path) -> Path:
        """Keep a file of the learner's as it is.

        :return: Where it is kept.
        """
        now = f'{datetime.datetime.now():%Y-%m-%d_%H-%M-%S}'
        number, kept = 1, self.folder / BACKUPS / now / name
        while kept.exists():
            number += 1
            kept = self.folder / BACKUPS / f'{now}_{number}' / name
        write_whole(kept, (self.folder / name).read_bytes())
        return kept

    def _write_notebook(self, path: Path, text: str, *, trusted: bool) -> None:
        if trusted:
            # First: a signature without its notebook does no harm. Nor does a notebook without, until it has outputs.
            with contextlib.suppress(sqlite3.Error), self._notary() as notary:
                notary.sign(nbformat.v4.reads(text))
        write_whole(path, text.encode())

    def _is_trusted(self, notebook: NotebookNode) -> bool:
        """True if JupyterLab takes all outputs of this notebook for the learner's own."""
        with self._notary() as notary:
            return bool(notary.check_signature(notebook))

    @contextlib.contextmanager
    def _notary(self) -> Iterator[NotebookNotary]:
        notary = NotebookNotary(data_dir=str(self.trust))
        with contextlib.closing(notary.store):
            yield notary

    def _say(self, path: Path) -> str:
        return str(path.relative_to(self._course) if path.is_relative_to(self._course) else path)

    @contextlib.contextmanager
    def _folder_of_ours(self) -> Iterator[None]:
        """Make the folder, let one process at a time work in it, and say in one sentence what the system rejects."""
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
            self.trust.mkdir(mode=0o700, exist_ok=True)
            with only_one(self.folder):
                yield
        except OSError as error:
            raise CopiesError(_explain(error, self.folder)) from error


class _Chapter:
    """A chapter as the learner gets it: without outputs, and with the name of its version."""

    def __init__(self, path: Path):
        notebook = _parse(path.read_bytes())
        if notebook is None:
            raise CopiesError(f'{path.parent.name}/{path.name} is not a notebook: git status may say why.')
        for cell in notebook.cells:
            if cell.cell_type == 'code':
                cell.outputs, cell.execution_count = [], None
        notebook.metadata.pop('widgets', None)
        self.version = _digest(nbformat.v4.writes(notebook).encode())
        notebook.metadata[_KEY] = {'version': self.version}
        self.notebook: NotebookNode = notebook
        self.text: str = nbformat.v4.writes(notebook) + '\n'


def _parse(content: bytes) -> NotebookNode | None:
    """Return a notebook, or None if this is none that JupyterLab could open."""
    try:
        notebook = nbformat.v4.reads(content.decode('utf-8-sig'))
        for cell in notebook.cells:
            # Whatever has no text and no metadata is no cell.
            cell.source.splitlines(), cell.metadata.items()
        return notebook if notebook.nbformat == 4 and isinstance(notebook.metadata, dict) else None
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        return None


def _version_of(notebook: NotebookNode) -> str:
    """Return the version of the chapter that a copy was made from; 'unknown' if it does not say."""
    found = notebook.metadata.get(_KEY)
    version = found.get('version') if isinstance(found, dict) else None
    return version if isinstance(version, str) and re.fullmatch('[0-9a-f]+', version) else 'unknown'


def _digest(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()[:32]


def _bytes_of(path: Path) -> bytes | None:
    """Return what a file holds, or None if it isn't there."""
    try:
        return path.read_bytes()
    except FileNotFoundError:
        return None


def _explain(error: OSError, folder: Path) -> str:
    """Return one sentence on why the copies can't be written."""
    if error.errno in (errno.ENOSPC, errno.EDQUOT):
        return (f'The disk is full, so your copies of the chapters in {folder} are not all up to date; nothing of '
                f'yours was changed or lost. Free some space and run the same command again.')
    return (f'Your copies of the chapters in {folder} could not be brought up to date; nothing of yours was lost. '
            f'The reason: {error.strerror}: {error.filename}.')
