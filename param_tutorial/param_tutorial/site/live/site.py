"""All live chapters of a build, and the scripts that their pages share."""

import concurrent.futures
import json
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

from param_tutorial.site.browser import page_python
from param_tutorial.site.bundling import bundle
from param_tutorial.site.live import python_files
from param_tutorial.site.live.running import EXPLAINED, LiveCell, LiveChapter, run_chapter

# A page fetches nothing, not even from its own server, and neither does its kernel, which runs what the reader typed:
# code comes in scripts of the site. Pyodide makes machine code, and a worker is a script in memory.
# Of a page on a disk, Firefox takes no other page for its own, and the search is one.
POLICY = ("default-src 'self' data: blob: 'unsafe-inline'; connect-src data: blob:; worker-src blob:; "
          "script-src 'self' blob: 'unsafe-inline' 'unsafe-eval'; form-action 'self' file:; "
          "frame-src 'none'; object-src 'none'")
_HERE = Path(__file__).parent
_PYTHON, _EDITOR = 'python.js', 'editor.js'
# What a chapter's run depends on, beside the packages.
_RUNS = ('kernel.js', 'run.mjs', 'running.py')


class Live:
    """Runs chapters in the kernel of their pages, and keeps what came of it as long as nothing has changed."""

    def __init__(self, work: Path) -> None:
        """:param work: What is kept from one build to the next."""
        self.work = work
        self.chapters: dict[Path, LiveChapter] = {}
        self._python = ''

    def run(self, paths: list[Path], notebooks: Path) -> None:
        """Run all chapters, several at a time.

        :param notebooks: The folder of the chapters.
        :raises PagePythonError: the Python of a page can't be put together.
        :raises ChapterError: a chapter fails, or its page's node says something else than is stored.
        """
        self.work.mkdir(parents=True, exist_ok=True)
        pyodide = self.work / 'pyodide'
        print('Gathering the Python of the pages', flush=True)
        page_python.gather(pyodide)
        packed = python_files.packages(pyodide, notebooks)
        (self.work / 'packages').write_bytes(packed)
        surroundings = packed + b''.join((_HERE / name).read_bytes() for name in _RUNS)
        # Most of a run is waiting for what moves.
        with concurrent.futures.ThreadPoolExecutor(2 * (os.cpu_count() or 1)) as pool:
            runs = {pool.submit(self._run, path, pyodide, surroundings): path for path in paths}
            for number, run in enumerate(concurrent.futures.as_completed(runs), 1):
                run.result()
                print(f'[{number}/{len(paths)}] {runs[run].stem}: ran in its page as stored', flush=True)
        self.chapters = {path: run.result() for run, path in runs.items()}
        print('Packing the Python of the pages', flush=True)
        everything = python_files.everything(pyodide, packed)
        self._python = self._kept('python', everything, lambda: python_files.script(everything))

    def _run(self, path: Path, pyodide: Path, surroundings: bytes) -> LiveChapter:
        key = path.read_bytes() + surroundings + repr(EXPLAINED).encode()
        chapter = self._kept(path.stem, key, lambda: json.dumps(run_chapter(path, pyodide, self.work / 'packages')))
        cells, shared = json.loads(chapter)
        return LiveChapter([LiveCell(*each) for each in cells], shared)

    def _kept(self, name: str, key: bytes, make: Callable[[], str]) -> str:
        """Return a text, which is made anew only if what it depends on has changed."""
        return page_python.kept(self.work, name, key, lambda: make().encode()).read_text(encoding='utf-8')

    def scripts(self) -> dict[str, str]:
        """Return the scripts of the pages, by name: the Python, the worker's, the editor, and those of widgets."""
        shared = {name: text for chapter in self.chapters.values() for name, text in chapter.shared.items()}
        worker = json.dumps(bundle('live/worker.js'))
        fronts = f'self.lessonFronts = {json.dumps(shared)};\nself.lessonWorker = {worker};\n'
        return {_PYTHON: self._python, _EDITOR: bundle('live/editor.js', 'lessonEditor'), 'fronts.js': fronts}

    def settings(self) -> dict[str, Any]:
        """Return Sphinx's settings for live pages."""
        return {'html_context.live_policy': POLICY, 'html_context.later_scripts': [_PYTHON, _EDITOR],
                'html_context.lessons': [path.stem for path in self.chapters],
                'html_js_files': ['fronts.js', 'lessons.js']}
