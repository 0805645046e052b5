"""The links of a chapter's page: what leads from one notebook to another leads to where the site has that."""

import html
import re
from pathlib import Path

from nbformat import NotebookNode

from param_tutorial.exercises.results import anchor
from param_tutorial.site.pages.writing import BuildError

# Where the site keeps the notebooks for readers who want to run them.
NOTEBOOKS = 'notebooks'
# The folder, below the chapters, of the notebooks that go deeper; their pages stand beside those of the chapters.
DEEPER = 'deeper'
_SOLVED = 'solutions'
# The folder of JupyterLab for the browser.
LAB = 'lite'
_MARKDOWN = re.compile(r'(?<!!)\[([^\]]*)\]\(([\w/.-]+\.(?:ipynb|md))(#[^)]*)?\)')
_HREF = re.compile(r'<a href="(\w+)\.ipynb">(.*?)</a>', re.DOTALL)
_HEADING = re.compile(r'^#+ +(.+)$', re.MULTILINE)
# What hints name, and checks without a link: a section of the chapter, and the file of the solutions.
_SECTION = re.compile(r'(?<!">)“([^“”]+)”')
_SOLUTIONS = re.compile(r'(?<![\w/"])(solutions/(\w+)\.ipynb)')
_TAG = re.compile(r'<[^>]+>')
# What a recall says to look up: a section of another chapter.
_ELSEWHERE = re.compile(r'\bchapter (\d+(?:\.\d+)?), (“[^“”]+”)')


def is_deeper(path: Path) -> bool:
    """True if a notebook is one of those that go deeper."""
    return path.parent.name == DEEPER


def has_solutions(name: str, pages: set[str]) -> bool:
    """True if a notebook of solutions, by its name without ending, is that of one of some pages."""
    return any(page.startswith(name.removesuffix(_SOLVED)) for page in pages)


class Links:
    """Leads the links of one chapter."""

    def __init__(self, path: Path, notebook: NotebookNode, pages: set[str], *, is_alone: bool = False) -> None:
        """
        :param path: Of the chapter; its links begin in that folder.
        :param pages: The names, without ending, of the pages that are made.
        :param is_alone: Whether the page is given away, with nothing beside it.
        """
        self._path, self._pages, self._is_alone = path, pages, is_alone
        self.anchors = {anchor(heading.replace('`', '')) for cell in notebook.cells if cell.cell_type == 'markdown'
                         for heading in _HEADING.findall(cell.source)}

    def in_markdown(self, text: str) -> str:
        """Return a text with its links led to pages of the site; where it has none, words stay.

        :raises BuildError: a link leads to a file that is not there.
        """
        return _MARKDOWN.sub(self._lead, text)

    def in_output(self, text: str) -> str:
        """Return what a cell has put out, its links led to pages of the site; what a check names is a link, too."""
        text = _HREF.sub(lambda found: self._html_link(f'{found[1]}.ipynb', found[2]), text)
        return self.in_check(text) if 'class="param-check"' in text else text

    def in_check(self, text: str) -> str:
        """Return the HTML of checks and hints, with links to the sections and the solutions that they name."""
        text = _SECTION.sub(self._section_link, text)
        return _SOLUTIONS.sub(lambda found: self._html_link(found[1], found[1]), text)

    def in_verdict(self, text: str) -> str:
        """Return what is said to an answer, as HTML, with a link to the section of the chapter that it names."""
        return _ELSEWHERE.sub(self._elsewhere_link, text)

    def _elsewhere_link(self, found: re.Match[str]) -> str:
        number, section = found.groups()
        begins = re.compile(rf'0*{number.replace(".", "_")}_(?!\d_)')
        chapters = sorted(self._path.parent.glob('[0-9]*.ipynb'))
        target = next((path for path in chapters if begins.match(path.name)), None)
        if target is None:
            return found[0]
        place = anchor(html.unescape(_TAG.sub('', section.strip('“”'))))
        return f'chapter {number}, {self._html_link(target.name, section, f"#{place}")}'

    def _lead(self, found: re.Match[str]) -> str:
        words, target, place = found[1], found[2], found[3] or ''
        if not (self._path.parent / target).exists():
            raise BuildError(f'{self._path.name} links to {target}, which is not there.')
        if Path(target).stem in self._pages and Path(target).parent.name != _SOLVED:
            return f'[{words}]({Path(target).name}{place})'
        return self._html_link(target, html.escape(words), place)

    def _html_link(self, target: str, words: str, place: str = '') -> str:
        """Return a link to a notebook, as HTML; the words alone if that is nowhere."""
        name, is_solution = Path(target).stem, Path(target).parent.name == _SOLVED
        if not (has_solutions(name, self._pages) and not self._is_alone if is_solution else name in self._pages):
            return words
        if is_solution:
            return f'<a href="{NOTEBOOKS}/{html.escape(target)}" download>{words}</a>'
        return f'<a href="{name}.html{html.escape(place)}">{words}</a>'

    def _section_link(self, found: re.Match[str]) -> str:
        name = anchor(html.unescape(_TAG.sub('', found[1])))
        return f'<a href="#{html.escape(name)}">{found[0]}</a>' if name in self.anchors else found[0]
