"""Makes the website: runs the chapters in the kernel of their pages, has the pages written, and puts the site in place.

    .venv/bin/python -m param_tutorial.site                          the site, in build/html/
    .venv/bin/python -m param_tutorial.site --lesson 06              one chapter as one file, in build/

The site is written beside the old one and takes its place when it is whole; whatever goes wrong before leaves the old
one as it was.
"""

from pathlib import Path

import nbformat

from param_tutorial.site.archive import course_archive, provenance
from param_tutorial.site.browser import lite
from param_tutorial.site.live.site import Live
from param_tutorial.site.pages.chapter import COURSE, chapter_source
from param_tutorial.site.pages.front_page import at_home_source, front_page_source
from param_tutorial.site.pages.links import DEEPER, LAB, NOTEBOOKS, has_solutions, is_deeper
from param_tutorial.site.pages.writing import BuildError, write_pages, write_static
from param_tutorial.site.replacing import replace

_NOT_FOUND = '''---
orphan: true
---
# There is no such page

The lesson may have another name now. [The first page](index.md) lists all lessons, and the search finds their words.
'''


def format_path(path: Path) -> str:
    """Return a path as short as it can be: from the current folder if it is below that."""
    return str(path.relative_to(Path.cwd()) if path.is_relative_to(Path.cwd()) else path)


class Site:
    """One build: which notebooks, and where everything goes."""

    def __init__(self, notebooks: Path, target: Path, work: Path, names: list[str] | None = None, *,
                 has_lab: bool = False):
        """
        :param notebooks: The folder of the chapters, and of the folder of those that go deeper.
        :param target: Where the site will be.
        :param work: Where runs of chapters and Sphinx's memory are kept from one build to the next.
        :param names: What the names of the wanted chapters begin with; by default all.
        :param has_lab: True if JupyterLab for the browser is a part of the site.
        :raises BuildError: there is no such chapter.
        """
        self._has_lab = has_lab
        found = [*sorted(notebooks.glob('[0-9]*.ipynb')), *sorted((notebooks / DEEPER).glob('*.ipynb'))]
        self.chapters = [path for path in found
                         if names is None or any(path.stem.startswith(name) for name in names)]
        if not self.chapters:
            raise BuildError(f'there is no chapter {" or ".join(names or [])} in {notebooks}: '
                             f'there are {", ".join(path.stem for path in found) or "none"}')
        self.notebooks, self.target, self.work = notebooks, target, work
        self.live = Live(work / 'live')

    def build(self) -> None:
        """Make the site.

        :raises ChapterError: a chapter fails, or does not do what is stored in it.
        :raises BuildError: Sphinx is not content.
        :raises PagePythonError: the Python of a page can't be put together.
        """
        self.live.run(self.chapters, self.notebooks)
        self._write_sources()
        print('Writing the pages', flush=True)
        settings = {**self.live.settings(), 'html_context.lab': LAB if self._has_lab else '',
                    'html_context.deeper': [path.stem for path in self.chapters if is_deeper(path)]}
        write_pages(self.work / 'source', self.work / 'html', self.work / 'doctrees', settings=settings)
        self._delete_stale_pages()
        if self._has_lab:
            print('Building JupyterLab for the browser', flush=True)
            lite.build(self.work / 'html' / LAB)
        replace(self.work / 'html', self.target)
        print(f'The lessons are in {format_path(self.target / "index.html")}')

    def _delete_stale_pages(self) -> None:
        """Delete the pages of chapters that an earlier build had and this one has not: Sphinx leaves them there."""
        sources = {path.stem for path in (self.work / 'source').iterdir()} | {'search'}
        for page in (self.work / 'html').glob('*.html'):
            if page.stem not in sources:
                page.unlink()

    def _write_sources(self) -> None:
        """Write what Sphinx reads; files that stay the same are not touched, so that Sphinx need not read them."""
        folder = self.work / 'source'
        wanted = {folder / name: text.encode() if isinstance(text, str) else text
                  for name, text in self._sources().items()}
        for path in folder.rglob('*'):
            if path.is_file() and path not in wanted:
                path.unlink()
        for path, content in wanted.items():
            if not path.exists() or path.read_bytes() != content:
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(content)
        write_static(folder, self.live.scripts())

    def _sources(self) -> dict[Path, str | bytes]:
        """Return what Sphinx reads, by the names of the files."""
        pages = {path.stem for path in self.chapters} | {'index', 'claims'}
        download = Path('extra', NOTEBOOKS)
        sources: dict[Path, str | bytes] = {
            Path('index.md'): front_page_source(self.notebooks / 'index.md', self.live.chapters, provenance(),
                                                has_lab=self._has_lab),
            Path('at_home.md'): at_home_source(self.notebooks / 'index.md', pages),
            Path('404.md'): _NOT_FOUND,
            Path('extra', f'{COURSE}.zip'): course_archive(COURSE)}
        claims = self.notebooks / 'claims.md'
        if claims.exists():
            sources[Path(claims.name)] = f'---\norphan: true\n---\n{claims.read_text(encoding="utf-8")}'
        for path in self.chapters:
            page = chapter_source(path, self.live.chapters[path], pages, has_lab=self._has_lab)
            sources[Path(path.name)] = nbformat.writes(page) + '\n'
            sources[download / path.relative_to(self.notebooks)] = path.read_text(encoding='utf-8')
        for path in sorted((self.notebooks / 'solutions').glob('*.ipynb')):
            if has_solutions(path.stem, pages):
                sources[download / 'solutions' / path.name] = path.read_text(encoding='utf-8')
        return sources
