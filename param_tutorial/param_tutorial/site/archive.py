"""The recordings of all chapters: those that are kept, and new ones of what has changed.

A chapter's recordings are kept under a digest of all that they may depend on, so a chapter is not run again without
need.
"""

import hashlib
import io
import json
import os
import platform
import subprocess
import sys
import time
import zipfile
from collections.abc import Iterator
from importlib.metadata import version
from pathlib import Path
from typing import Any

from param_tools.markup.wording import format_count
from param_tutorial.site.console import say
from param_tutorial.site.recording.recorded import Recordings
from param_tutorial.site.recording.run import read_notebook, source_of
from param_tutorial.site.workers import record_all

PACKAGE_ROOT = Path(__file__).parents[2]
ROOT = PACKAGE_ROOT.parent
_SITE = Path(__file__).parent
_VERSIONS = ('ros-jazzy-rclpy', 'ipykernel', 'ipywidgets')


class Archive:
    """Recordings of chapters; those that are missing are made, in as many kernels at once as there are processes."""

    def __init__(self, notebooks: Path, work: Path, processes: int):
        """
        :param notebooks: The folder of all chapters.
        :param work: Where recordings are kept from one build to the next.
        """
        self._notebooks, self._work, self._processes = notebooks, work, processes

    def recordings(self, chapters: list[Path]) -> dict[Path, Recordings]:
        """Run every chapter that has changed, and return the recordings of all.

        :raises ChapterError: a chapter fails, or does not do what is stored in it.
        """
        kept = self._work / 'recordings'
        kept.mkdir(parents=True, exist_ok=True)
        surroundings = digest_of_surroundings()
        recordings: dict[Path, Recordings] = {}
        to_run: dict[Path, str] = {}
        for path in chapters:
            key = hashlib.sha256(what_runs(path) + surroundings + self._others_read_by(path)).hexdigest()
            found = _load(kept / f'{path.stem}.json')
            if found.get('key') == key:
                recordings[path] = found['recordings']
            else:
                to_run[path] = key
        if recordings:
            say(f'{len(recordings)} of {len(chapters)} chapters have not changed')
        for path, recorded in self._run(list(to_run)):
            recordings[path] = recorded
            _save(kept / f'{path.stem}.json', {'key': to_run[path], 'recordings': recorded})
        return {path: recordings[path] for path in chapters}

    def _others_read_by(self, path: Path) -> bytes:
        """Return all chapters, if a chapter reads them: the glossary is made of all."""
        if 'Glossary' not in path.read_text(encoding='utf-8'):
            return b''
        return b''.join(each.read_bytes() for each in sorted(self._notebooks.glob('*.ipynb')))

    def _run(self, paths: list[Path]) -> Iterator[tuple[Path, Recordings]]:
        """Run chapters in several kernels at once, and yield each with its recordings when all of it is there."""
        if not paths:
            return
        os.environ['IPYTHONDIR'] = str(self._work / 'ipython')
        (self._work / 'ipython').mkdir(parents=True, exist_ok=True)
        began = time.monotonic()
        say(f'Running {format_count(len(paths), "chapter")}, {self._processes} kernels at a time')
        for done, (path, recorded) in enumerate(record_all(paths, self._processes), 1):
            asked = sum(part.get('asked', 0) for found in recorded.values() for each in found
                        for part in each.get('parts', [each]))
            kinds = [each['kind'] for found in recorded.values() for each in found]
            views, forms = len(kinds) - kinds.count('answers'), kinds.count('answers')
            say(f'[{done}/{len(paths)}] {path.stem}: ran as stored; {format_count(views, "view")} and '
                f'{format_count(forms, "exercise")} recorded'
                + (f', {asked:,} answers' if asked else '') + f' ({time.monotonic() - began:.0f} s)')
            yield path, recorded


def what_runs(path: Path) -> bytes:
    """Return all of a chapter, and of the code of its solutions, that its recordings may depend on: not its prose."""
    cells = [[cell.id, cell.source, cell.metadata.get('tags'), cell.execution_count, cell.outputs]
             for cell in read_notebook(path).cells if cell.cell_type == 'code']
    return json.dumps([path.name, cells, source_of(path)], sort_keys=True).encode()


def digest_of_surroundings() -> bytes:
    """Return a digest of all that a chapter's run may depend on beside the chapter.

    That is the package without the lessons, which no chapter imports, but with their ``recording``, which imports
    nothing of the rest of them.
    """
    digest = hashlib.sha256(json.dumps([sys.version, [version(name) for name in _VERSIONS]]).encode())
    files = [path for folder in (PACKAGE_ROOT, ROOT / 'config') for path in sorted(folder.rglob('*'))
             if path.is_file() and path.suffix != '.pyc'
             and (_SITE not in path.parents or _SITE / 'recording' in path.parents)
             and not any(part.endswith('.egg-info') for part in path.parts)]
    for path in files:
        digest.update(str(path.relative_to(ROOT)).encode() + b'\0' + path.read_bytes())
    return digest.digest()


def provenance() -> dict[str, str]:
    """Return from which state of the course, and on what, the lessons ran: the same for each build of a commit."""
    facts = {'Python': platform.python_version(), 'rclpy': version('ros-jazzy-rclpy')}
    if commit := _git('log', '-1', '--format=%h %cs'):
        name, date = commit.split()
        changed = _git('status', '--porcelain', '--', 'notebooks', 'param_tutorial', 'config')
        facts |= {'date': date, 'commit': name, 'changed': 'with changes since' if changed else ''}
    return facts


def course_archive(folder: str) -> bytes:
    """Return the course as a zip file, the same for each build of a commit.

    :param folder: In which all files are.
    """
    names = [name for name in _git('ls-files', '-z').split('\0') if name and (ROOT / name).is_file()]
    if not names:  # no clone: what a clone has, as far as one can tell
        names = [str(path.relative_to(ROOT)) for path in ROOT.rglob('*') if path.is_file() and not any(
            part.startswith(('.', '__')) or part.endswith('.egg-info')
            or part in ('build', 'my_lessons', 'node_modules')
            for part in path.relative_to(ROOT).parts)]
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, 'w', zipfile.ZIP_DEFLATED) as archive:
        for name in sorted(names):
            path = ROOT / name
            entry = zipfile.ZipInfo(f'{folder}/{name}', (1980, 1, 1, 0, 0, 0))
            entry.external_attr = (0o755 if os.access(path, os.X_OK) else 0o644) << 16
            archive.writestr(entry, path.read_bytes(), zipfile.ZIP_DEFLATED, 9)
    return buffer.getvalue()


def _git(*arguments: str) -> str:
    """Return what git prints about the course; nothing if it is not a clone, or there is no git."""
    try:
        return subprocess.run(['git', *arguments], cwd=ROOT, capture_output=True, text=True, check=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return ''


def _load(path: Path) -> dict[str, Any]:
    """Return what ``_save`` wrote; nothing if that is not there or not whole."""
    try:
        return dict(json.loads(path.read_text(encoding='utf-8')))
    except (OSError, ValueError):
        return {}


def _save(path: Path, content: dict[str, Any]) -> None:
    """Write JSON, as a whole or not at all."""
    new = path.with_suffix('.new')
    new.write_text(json.dumps(content, ensure_ascii=False), encoding='utf-8')
    new.replace(path)
