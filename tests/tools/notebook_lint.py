"""Check the notebooks without running them: `python -m tests.tools.notebook_lint notebooks`.

The notebooks are the course's tests, and nbval compares only what is stored in them. A notebook that was stripped, or
run out of order, would pass without testing anything. These rules reject it, and hold the lessons to one shape.
"""

import json
import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import nbformat

MAX_NOT_COMPARED = 1 / 8

NOT_COMPARED_TAGS = {'nbval-skip', 'nbval-ignore-output'}
NOT_COMPARED_COMMENT = re.compile(r'^\s*#+\s*(NBVAL_SKIP|NBVAL_IGNORE_OUTPUT)\s*$', re.MULTILINE)
REASON_COMMENT = re.compile(r'^\s*#\s*Not compared: \S', re.MULTILINE)
# The names of the folders of one person's machine: in an output they would fail everywhere else.
MACHINE_PATH = re.compile(r'(?<![\w./])(?:/root|/home|/tmp|/Users|[A-Z]:\\Users)(?=[/\\\s\'":,)]|$)', re.MULTILINE)
HEADING = re.compile(r'^(#{1,6})\s+(.+?)\s*#*$', re.MULTILINE)
FENCE = re.compile(r'^(```|~~~).*?^\1', re.MULTILINE | re.DOTALL)
CODE_SPAN = re.compile(r'(`+).+?\1', re.DOTALL)
LINK = re.compile(r'(?<!!)\[[^\]]*\]\(<?([^)\s>]+)>?[^)]*\)')
IMAGE = re.compile(r'!\[([^\]]*)\]\(<?([^)\s>]+)>?[^)]*\)')
HTML_IMAGE = re.compile(r'<img\b[^>]*>', re.IGNORECASE)
HTML_ALT = re.compile(r'\balt\s*=\s*(["\'])\s*\S.*?\1', re.IGNORECASE | re.DOTALL)
# A lesson imports what a reader may use: the two packages, a room of them, or a node, which is a file of its own.
TOO_DEEP = re.compile(r'^ *(?:from|import) (param_t(?:ools|utorial)\.(?!nodes\.)\w+\.[\w.]+)', re.MULTILINE)
ELSEWHERE = re.compile(r'^[a-z][a-z+.-]*:')


class Problem(NamedTuple):
    """One broken rule; cells count from 1, as a reader counts them, and 0 is the notebook as a whole."""

    path: Path
    cell: int
    text: str

    def __str__(self) -> str:
        where = f'{self.path}: cell {self.cell}' if self.cell else str(self.path)
        return f'{where}: {self.text}'


Found = Iterator[tuple[int, str]]


def check_file(path: Path) -> list[Problem]:
    """Return every broken rule in a notebook or a Markdown page."""
    found = check_notebook(path) if path.suffix == '.ipynb' else check_page(path)
    return [Problem(path, cell, text) for cell, text in found]


def check_page(path: Path) -> Found:
    text = path.read_text(encoding='utf-8')
    yield from check_headings([(0, text)])
    yield from check_references([(0, text)], path)


def check_notebook(path: Path) -> Found:
    try:
        notebook = nbformat.reads(path.read_text(encoding='utf-8'), as_version=nbformat.NO_CONVERT)
        nbformat.validate(notebook)
    except (nbformat.ValidationError, nbformat.reader.NotJSONError, ValueError, AttributeError, KeyError) as error:
        yield 0, f'is not a valid notebook: {str(error).splitlines()[0]}'
        return
    if notebook.metadata.get('kernelspec', {}).get('name') != 'python3':
        yield 0, 'must name the kernel python3, or JupyterLab asks the learner for one.'
    cells = list(enumerate(notebook.cells, start=1))
    code = [(number, cell) for number, cell in cells if cell.cell_type == 'code']
    prose = [(number, cell.source) for number, cell in cells if cell.cell_type == 'markdown']
    yield from check_sources(cells)
    yield from check_execution(code)
    yield from check_comparison(code)
    yield from check_errors(code)
    yield from check_headings(prose)
    if cells and not (cells[0][1].cell_type == 'markdown' and cells[0][1].source.startswith('# ')):
        yield 1, 'the first cell must start with the title, a heading of level 1.'
    yield from check_references(prose, path)


def check_sources(cells: list[tuple[int, Any]]) -> Found:
    for number, cell in cells:
        if not cell.source.strip():
            yield number, 'is empty: remove it.'
        elif cell.source != cell.source.rstrip():
            yield number, 'ends with blanks or blank lines: remove them.'
        for text in [cell.source, *output_texts(cell)]:
            if match := MACHINE_PATH.search(text):
                yield number, f'holds a path of one machine, {match[0]}: it would differ everywhere else.'
                break
        if match := TOO_DEEP.search(cell.source):
            yield number, f'imports from {match[1]}: let a room of the package offer it.'


def output_texts(cell: Any) -> Iterator[str]:
    for output in cell.get('outputs', ()):
        yield output.get('text', '')
        yield from output.get('traceback', ())
        for mime, data in output.get('data', {}).items():
            # Pictures are base64, in which any letters may occur.
            if not mime.startswith('image/') or mime == 'image/svg+xml':
                yield data if isinstance(data, str) else json.dumps(data)


def check_execution(code: list[tuple[int, Any]]) -> Found:
    not_run = [number for number, cell in code if cell.execution_count is None]
    if not_run:
        # One message is enough: running the notebook once runs them all.
        others = f', nor were {len(not_run) - 1} others' if len(not_run) > 1 else ''
        yield not_run[0], f'was not run{others}: use Restart Kernel and Run All Cells, and save.'
        return
    for expected, (number, cell) in enumerate(code, start=1):
        if cell.execution_count != expected:
            yield number, f'was run as [{cell.execution_count}] and not as [{expected}]: run all cells in order.'
            return


def check_comparison(code: list[tuple[int, Any]]) -> Found:
    skipped = [(number, cell) for number, cell in code if is_not_compared(cell)]
    for number, cell in skipped:
        if not cell.metadata.get('nbval_reason', '').strip() and not REASON_COMMENT.search(cell.source):
            yield number, 'is not compared and says no reason: add "# Not compared: …", or metadata nbval_reason.'
    if len(skipped) > MAX_NOT_COMPARED * len(code):
        yield 0, f'{len(skipped)} of {len(code)} code cells are not compared; at most one in eight may be left out.'


def is_not_compared(cell: Any) -> bool:
    tags = set(cell.metadata.get('tags', ()))
    return bool(tags & NOT_COMPARED_TAGS) or bool(NOT_COMPARED_COMMENT.search(cell.source))


def check_errors(code: list[tuple[int, Any]]) -> Found:
    for number, cell in code:
        raised = [output for output in cell.outputs if output.output_type == 'error']
        intended = 'raises-exception' in cell.metadata.get('tags', ())
        if raised and not intended:
            yield number, f'ends in {raised[0].ename}: mend it, or tag it raises-exception if that is the lesson.'
        if intended and not raised:
            yield number, 'is tagged raises-exception but raised none.'


def headings(text: str) -> list[tuple[int, str]]:
    return [(len(marks), title) for marks, title in HEADING.findall(FENCE.sub('', text))]


def check_headings(prose: list[tuple[int, str]]) -> Found:
    before, titles = 0, 0
    for number, text in prose:
        for level, title in headings(text):
            titles += level == 1
            if level == 1 and titles > 1:
                yield number, f'has another heading of level 1, "{title}": there is one title.'
            elif level > before + 1:
                yield number, f'the heading "{title}" jumps from level {before} to level {level}.'
            before = level
    if titles == 0:
        yield 0, 'has no title, a heading of level 1.'


def check_references(prose: list[tuple[int, str]], path: Path) -> Found:
    for number, source in prose:
        text = CODE_SPAN.sub('', FENCE.sub('', source))
        for alt, target in IMAGE.findall(text):
            if not alt.strip():
                yield number, f'the image {target} has no alternative text.'
        for tag in HTML_IMAGE.findall(text):
            if not HTML_ALT.search(tag):
                yield number, f'the image {tag} has no alternative text.'
        for target in [*LINK.findall(text), *(target for _, target in IMAGE.findall(text))]:
            if problem := reference_problem(target, path):
                yield number, problem


def reference_problem(target: str, path: Path) -> str | None:
    """Say what is wrong with a link or an image's source, or None; links to the web are not followed."""
    if ELSEWHERE.match(target) or target.startswith('attachment:'):
        return None
    name, _, anchor = target.partition('#')
    file = path.parent / name if name else path
    if not file.exists():
        return f'the link {target} leads nowhere: there is no {name} beside {path.name}.'
    if anchor and file.suffix in ('.ipynb', '.md') and anchor not in anchors(file):
        return f'the link {target} leads nowhere: {file.name} has no heading of that name.'
    return None


def anchors(path: Path) -> set[str]:
    """Return what JupyterLab lets a link name: each heading, with hyphens for blanks."""
    text = path.read_text(encoding='utf-8')
    if path.suffix == '.ipynb':
        cells = json.loads(text)['cells']
        text = '\n\n'.join(''.join(cell['source']) for cell in cells if cell['cell_type'] == 'markdown')
    return {title.replace(' ', '-') for _, title in headings(text)}


def lesson_files(folder: Path) -> list[Path]:
    """Return the notebooks and pages below a folder, without JupyterLab's checkpoints."""
    return sorted(
        path
        for path in folder.rglob('*')
        if path.suffix in ('.ipynb', '.md') and '.ipynb_checkpoints' not in path.parts
    )


def main(arguments: list[str]) -> int:
    problems, files = [], []
    for argument in arguments:
        path = Path(argument)
        files += [path] if path.is_file() else lesson_files(path)
    for path in files:
        problems += check_file(path)
    for problem in problems:
        print(problem)
    return 1 if problems else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
