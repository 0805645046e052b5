"""Makes the website: runs what has changed, records it, has Sphinx write the pages, and puts the site in its place.

    .venv/bin/python -m param_tutorial.lessons                          the site, in build/html/
    .venv/bin/python -m param_tutorial.lessons --lesson 06              one chapter as one file, in build/

Runs and recordings are kept under what they depend on, so a chapter that has not changed is not run again. The site
is written beside the old one and takes its place when it is whole; whatever goes wrong before leaves the old one as
it was.
"""

import concurrent.futures
import hashlib
import json
import multiprocessing
import os
import platform
import re
import shutil
import subprocess
import sys
import time
from importlib.metadata import version
from pathlib import Path
from typing import Any

import nbformat
from sphinx.application import Sphinx
from sphinx.util.docutils import docutils_namespace

from param_tutorial.lessons import chapter, front_page, run
from param_tutorial.widgets import robot

SITE = Path(__file__).parent / 'site'
PACKAGE_ROOT = Path(__file__).parents[2]
ROOT = PACKAGE_ROOT.parent
# What a run cannot depend on: how its recording is drawn.
_DRAWN_BY = ('build.py', 'chapter.py', 'command.py', 'drawing.py', 'front_page.py', 'single.py', '__init__.py',
             '__main__.py')
_COLOUR = re.compile(r'\x1b\[[0-9;]*m')
VERSIONS = ('ros-jazzy-rclpy', 'ipykernel', 'ipywidgets')


class BuildError(Exception):
    """The site cannot be made; the message is for whoever builds it."""


class Site:
    """One build: which notebooks, and where everything goes."""

    def __init__(self, notebooks: Path, target: Path, work: Path, names: list[str] | None = None, *,
                 processes: int = 0):
        """
        :param notebooks: The folder of the chapters.
        :param target: Where the site shall be.
        :param work: Where runs, recordings and Sphinx's memory are kept from one build to the next.
        :param names: What the names of the wanted chapters begin with; by default all.
        :param processes: How many kernels run at once; by default one for each processor.
        """
        found = sorted(notebooks.glob('[0-9]*.ipynb'))
        self.chapters = [path for path in found
                         if names is None or any(path.stem.startswith(name) for name in names)]
        if not self.chapters:
            raise BuildError(f'there is no chapter {" or ".join(names or [])} in {notebooks}: '
                             f'there are {", ".join(path.stem for path in found) or "none"}')
        self.notebooks, self.target, self.work = notebooks, target, work
        self._processes = processes or os.cpu_count() or 1

    def build(self) -> None:
        """Make the site.

        :raises ChapterError: a chapter fails, or does not do what is stored in it.
        :raises BuildError: Sphinx is not content.
        """
        recordings = self.record()
        self.write_sources(recordings)
        say('Writing the pages')
        sphinx(self.work / 'source', self.work / 'html', self.work / 'doctrees', self._processes)
        replace(self.work / 'html', self.target)
        say(f'The lessons are in {shown(self.target / "index.html")}')

    # -- running ---------------------------------------------------------------------------------------

    def record(self) -> dict[Path, dict[int, list[dict[str, Any]]]]:
        """Run every chapter that has changed, and give the recordings of all."""
        kept = self.work / 'recordings'
        kept.mkdir(parents=True, exist_ok=True)
        surroundings = digest_of_surroundings()
        recordings, to_run = {}, {}
        for path in self.chapters:
            key = hashlib.sha256(path.read_bytes() + surroundings + self._others_read_by(path)).hexdigest()
            found = load(kept / f'{path.stem}.json')
            if found.get('key') == key:
                recordings[path] = {int(index): each for index, each in found['recordings'].items()}
            else:
                to_run[path] = key
        if recordings:
            say(f'{len(recordings)} of {len(self.chapters)} chapters have not changed')
        for path, recorded in self._run(list(to_run)):
            recordings[path] = recorded
            save(kept / f'{path.stem}.json', {'key': to_run[path], 'recordings': recorded})
        return {path: recordings[path] for path in self.chapters}

    def _others_read_by(self, path: Path) -> bytes:
        """Give the other chapters, if a chapter reads them: the glossary is made of all."""
        if 'Glossary' not in path.read_text(encoding='utf-8'):
            return b''
        return b''.join(each.read_bytes() for each in sorted(self.notebooks.glob('*.ipynb')))

    def _run(self, paths: list[Path]):
        """Run chapters in several kernels at once, and give each with its recordings when all of it is there."""
        if not paths:
            return
        os.environ['IPYTHONDIR'] = str(self.work / 'ipython')
        (self.work / 'ipython').mkdir(parents=True, exist_ok=True)
        parts = {path: run.parts(path) for path in paths}
        begun, done = time.monotonic(), 0
        say(f'Running {len(paths)} chapter{"" if len(paths) == 1 else "s"}, {self._processes} kernels at a time')
        # Spawned, since a fork takes over locks and threads of the libraries that are loaded here.
        pool = concurrent.futures.ProcessPoolExecutor(self._processes, multiprocessing.get_context('spawn'))
        try:
            futures = {pool.submit(run.run_part, path, part): (path, part)
                       for path in paths for part in parts[path]}
            results: dict[Path, dict] = {path: {} for path in paths}
            for future in concurrent.futures.as_completed(futures):
                path, part = futures[future]
                results[path][part] = future.result()
                if len(results[path]) == len(parts[path]):
                    done += 1
                    recorded = {index: found for index, found in results[path].items() if index is not None}
                    asked = sum(each.get('asked', 0) for found in recorded.values() for each in found)
                    say(f'[{done}/{len(paths)}] {path.stem}: ran as stored; {counted(recorded)} recorded'
                        + (f', {asked:,} answers' if asked else '') + f' ({time.monotonic() - begun:.0f} s)')
                    yield path, dict(sorted(recorded.items()))
        finally:
            pool.shutdown(cancel_futures=True)

    # -- writing ---------------------------------------------------------------------------------------

    def write_sources(self, recordings: dict[Path, dict[int, list[dict[str, Any]]]]) -> None:
        """Write what Sphinx reads; files that stay the same are not touched, so that Sphinx need not read them."""
        folder = self.work / 'source'
        pages = {path.stem for path in self.chapters} | {'index'}
        wanted = {folder / 'index.md': front_page.source(self.notebooks / 'index.md', recordings, provenance())}
        for path in self.chapters:
            wanted[folder / path.name] = nbformat.writes(chapter.source(path, recordings[path], pages)) + '\n'
            wanted[folder / 'extra' / chapter.NOTEBOOKS / path.name] = path.read_text(encoding='utf-8')
        for path in sorted((self.notebooks / 'solutions').glob('*.ipynb')):
            if path.stem in pages:
                wanted[folder / 'extra' / chapter.NOTEBOOKS / 'solutions' / path.name] = path.read_text(
                    encoding='utf-8')
        for path in folder.rglob('*'):
            if path.is_file() and path not in wanted:
                path.unlink()
        for path, text in wanted.items():
            if not path.exists() or path.read_text(encoding='utf-8') != text:
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding='utf-8')
        write_static(folder)


def write_static(source: Path) -> None:
    """Write, beside Sphinx's sources, the styles that the notebook's own views bring along."""
    (source / 'static').mkdir(exist_ok=True)
    (source / 'static' / 'robot.css').write_text(
        robot.STYLE.replace('<style>', '').replace('</style>', '').strip() + '\n', encoding='utf-8')


def counted(recorded: dict[int, list]) -> str:
    """Say how many views a chapter has."""
    count = sum(map(len, recorded.values()))
    return f'{count} view{"" if count == 1 else "s"}'


def digest_of_surroundings() -> bytes:
    """Give a digest of all that a chapter's run may depend on beside the chapter."""
    digest = hashlib.sha256(json.dumps([sys.version, [version(name) for name in VERSIONS]]).encode())
    files = [path for folder in (PACKAGE_ROOT, ROOT / 'config') for path in sorted(folder.rglob('*'))
             if path.is_file() and path.suffix != '.pyc' and SITE not in path.parents
             and not (path.parent == SITE.parent and path.name in _DRAWN_BY)
             and not any(part.endswith('.egg-info') for part in path.parts)]
    for path in files:
        digest.update(str(path.relative_to(ROOT)).encode() + b'\0' + path.read_bytes())
    return digest.digest()


def provenance() -> dict[str, str]:
    """Say from which state of the course, and on what, the lessons ran: the same for each build of a commit."""
    facts = {'Python': platform.python_version(), 'rclpy': version('ros-jazzy-rclpy')}
    done = subprocess.run(['git', 'log', '-1', '--format=%h %cs'], cwd=ROOT, capture_output=True, text=True,
                          check=False)
    if done.returncode == 0 and done.stdout.strip():
        commit, date = done.stdout.split()
        changed = subprocess.run(['git', 'status', '--porcelain', '--', 'notebooks', 'param_tutorial', 'config'],
                                 cwd=ROOT, capture_output=True, text=True, check=False).stdout.strip()
        facts |= {'date': date, 'commit': commit, 'changed': 'with changes since' if changed else ''}
    return facts


def sphinx(source: Path, target: Path, doctrees: Path, processes: int = 1, builder: str = 'html',
           settings: dict[str, Any] | None = None) -> None:
    """Let Sphinx write pages.

    :raises BuildError: it warns of something; the message is what it says.
    """
    target.mkdir(parents=True, exist_ok=True)
    extra = source / 'extra'
    settings = {'html_static_path': [str(SITE / '_static'), str(source / 'static')],
                'html_extra_path': [str(extra)] if extra.exists() else [], **(settings or {})}
    warnings = Path(f'{doctrees}.warnings')
    warnings.parent.mkdir(parents=True, exist_ok=True)
    with warnings.open('w+', encoding='utf-8') as said, docutils_namespace():
        app = Sphinx(str(source), str(SITE), str(target), str(doctrees), builder, confoverrides=settings,
                     status=None, warning=said, parallel=processes)
        app.build()
        said.seek(0)
        text = _COLOUR.sub('', said.read()).strip()
    if app.statuscode or text:
        # A page with a warning is in Sphinx's memory already and would not be warned of again.
        shutil.rmtree(doctrees, ignore_errors=True)
        raise BuildError(f'Sphinx is not content with the pages:\n{text}')


def replace(new: Path, target: Path) -> None:
    """Put a copy of a folder in the place of another, as a whole."""
    beside, old = target.with_name(f'{target.name}.new'), target.with_name(f'{target.name}.old')
    for folder in (beside, old):
        shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(new, beside, ignore=shutil.ignore_patterns('.buildinfo', '_sources', '*.map'))
    if target.exists():
        target.rename(old)
    beside.rename(target)
    shutil.rmtree(old, ignore_errors=True)


def load(path: Path) -> dict[str, Any]:
    """Read what ``save`` wrote; nothing if that is not there or not whole."""
    try:
        return json.loads(path.read_text(encoding='utf-8'))
    except (OSError, ValueError):
        return {}


def save(path: Path, content: dict[str, Any]) -> None:
    """Write JSON, as a whole or not at all."""
    new = path.with_suffix('.new')
    new.write_text(json.dumps(content, ensure_ascii=False), encoding='utf-8')
    new.replace(path)


def shown(path: Path) -> str:
    """Give a path as short as can be."""
    return str(path.relative_to(Path.cwd()) if path.is_relative_to(Path.cwd()) else path)


def say(text: str) -> None:
    """Print progress at once."""
    print(text, flush=True)
