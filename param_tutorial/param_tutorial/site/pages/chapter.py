"""A chapter as a source for Sphinx: its views drawn, its exercises with hints and solutions."""

import json
import re
from collections.abc import Sequence
from pathlib import Path

import nbformat

from param_tools.markup.tables import with_code
from param_tutorial.exercises import EXERCISES, PREDICTIONS, RECALLS
from param_tutorial.exercises.predicting import STYLE, draw_form
from param_tutorial.exercises.prediction import MIME_TYPE
from param_tutorial.notebook.stored import WIDGET
from param_tutorial.site.live.running import LiveCell, LiveChapter
from param_tutorial.site.live.stills import still
from param_tutorial.site.pages import drawing
from param_tutorial.site.pages.links import DEEPER, LAB, NOTEBOOKS, Links, is_deeper

# The folder and the archive of the course that the site offers.
COURSE = 'param-course'
# What a page says to a browser that runs no scripts.
NO_SCRIPT = ('<noscript>\n<p class="lesson-about-page">This browser runs no scripts, so no node answers on this page. '
             'What each cell put out stands below it.</p>\n</noscript>')
# The end of a chapter's first text; the last part of it announces the cell below.
_GOALS = re.compile(r'^After this chapter you can\n\n(.*?)\n\n\*(\d+ minutes)\. *(.*?)\*(.*)', re.DOTALL | re.MULTILINE)

_SECTION = re.compile('^## .*$', re.MULTILINE)


def chapter_source(path: Path, live: LiveChapter, pages: set[str], *, alone: dict[str, str] | None = None,
                   has_lab: bool = False) -> nbformat.NotebookNode:
    """Return what Sphinx reads in place of a chapter.

    :param live: The chapter as its page's kernel ran it.
    :param pages: The names, without ending, of all pages of the site; links to others become words.
    :param alone: For a file that is given away, with nothing beside it: from which state of the course the lesson
        ran, and on what; see ``archive.provenance``.
    :param has_lab: True if JupyterLab for the browser is a part of the site.
    :raises BuildError: a link leads to a file that is not there.
    """
    notebook: nbformat.NotebookNode = nbformat.read(path, as_version=4)
    links = Links(path, notebook, pages, is_alone=alone is not None)
    _draw_views(notebook, live)
    _draw_predictions(notebook, links)
    for cell in notebook.cells:
        for output in cell.get('outputs', ()):
            if 'text/html' in output.get('data', {}):
                output.data['text/html'] = links.in_output(output.data['text/html'])
    _begin_with_what_can_be_touched(notebook)
    cells = []
    for cell in notebook.cells:
        if cell.cell_type == 'markdown':
            cell.source = links.in_markdown(cell.source)
            if 'stage' in cell.metadata.get('tags', ()):
                cell.source = _SECTION.sub(r'\g<0>\n\n<div class="lesson-stage" hidden></div>', cell.source)
        cells.append(cell)
        if cell.id.startswith('check-') and (help_html := _help_html(cell.id.removeprefix('check-'), path)):
            cells.append(_html_cell(f'help-{cell.id}', links.in_check(help_html)))
    note = _download_note(path, has_lab) if alone is None else _provenance_note(alone)
    notebook.cells = [*cells, _html_cell('about-page', note + live_cells(live.cells))]
    notebook.metadata['language_info'] = {'name': 'python', 'pygments_lexer': 'ipython3'}
    return notebook


def _begin_with_what_can_be_touched(notebook: nbformat.NotebookNode) -> None:
    """Put what the first cell shows right below the question, and fold its code, and what the chapter is for."""
    first, stage = notebook.cells[0], next((cell for cell in notebook.cells if cell.cell_type == 'code'), None)
    # A class without a view is what the text is about.
    if stage and (stage.outputs or not re.search('^class ', stage.source, re.MULTILINE)):
        words = f'Set the stage: {len(stage.source.splitlines())} lines'
        stage.metadata.tags = [*stage.metadata.get('tags', ()), 'hide-input']
        stage.metadata.mystnb = {'code_prompt_show': words, 'code_prompt_hide': words}
    found = _GOALS.search(first.source)
    question = first.source[:found.start()] if found else first.source
    first.source = f'{question.strip()}\n\n{NO_SCRIPT}'
    if not found:
        return
    goals, minutes, before, rest = found.groups()
    after = nbformat.v4.new_markdown_cell(
        f'<details class="lesson-goals">\n<summary>{minutes}: what you can do afterward</summary>\n\n{goals}\n\n'
        f'*{before}*\n\n</details>' + ('' if rest.rstrip().endswith(':') else f'\n\n{rest.strip()}'), id='goals')
    notebook.cells.insert(2 if stage and notebook.cells[1] is stage and stage.outputs else 1, after)


def _draw_views(notebook: nbformat.NotebookNode, live: LiveChapter) -> None:
    """Put the first picture of each view in the place of its widget, and a name on each cell that runs."""
    ran = {each.id: each for each in live.cells}
    for cell in notebook.cells:
        if cell.id not in ran:
            continue
        cell.metadata.tags = [*cell.metadata.get('tags', ()), f'live-{cell.id}']
        shown = [output for output in cell.outputs
                 if WIDGET in output.get('data', {}) and MIME_TYPE not in output.data]
        for root, output in zip(ran[cell.id].roots, shown, strict=True):
            output.data = nbformat.from_dict({'text/html': still(ran[cell.id], root)})


def live_cells(cells: Sequence[LiveCell]) -> str:
    """Return what the page's script has to know of the cells that it can run."""
    facts = json.dumps([each._asdict() for each in cells], ensure_ascii=False, separators=(',', ':'))
    facts = facts.replace('</', r'<\/')  # a script's element would end there
    return f'<script type="application/json" class="live-cells">{facts}</script>'


def _draw_predictions(notebook: nbformat.NotebookNode, links: Links) -> None:
    """Put the page's own form in the place of each prediction."""
    for cell in notebook.cells:
        for output in cell.get('outputs', ()):
            if MIME_TYPE in output.get('data', {}):
                number = output.data[MIME_TYPE]['number']
                prediction = PREDICTIONS.get(number) or RECALLS[number]
                decided = ' data-decided' if prediction.is_decided_by_a_cell else ''
                output.data = nbformat.from_dict({'text/html': (
                    f'<div class="lesson-prediction" id="question-{number}" data-number="{number}"{decided}>{STYLE}'
                    f'{draw_form(prediction, links.in_verdict)}</div>')})
                cell.metadata.tags = [*cell.metadata.get('tags', ()), 'remove-input']


def _html_cell(name: str, content: str) -> nbformat.NotebookNode:
    """Make a cell of which the page shows the output alone; without any source myst-nb would leave it out."""
    cell: nbformat.NotebookNode = nbformat.v4.new_code_cell(
        '...', id=name, execution_count=None, metadata={'tags': ['remove-input']},
        outputs=[nbformat.v4.new_output('display_data', {'text/html': content})])
    return cell


def _download_note(path: Path, has_lab: bool) -> str:
    name = f'{DEEPER}/{path.name}' if is_deeper(path) else path.name
    in_lab = (f' As a notebook: <a href="{LAB}/lab/index.html?path={name}">in JupyterLab, in this browser</a>.'
              if has_lab else '')
    return (f'<p class="lesson-about-page">A node runs in this page: rclpy’s own code, without a network. Change any '
            f'value, and edit and run any cell; what you do stays in this browser.{in_lab}<br>With all of ROS 2: '
            f'<a href="{COURSE}.zip" download>download the course</a>, unpack it on a Linux machine with Python, and '
            f'type <code>make lab</code> there. This lesson is its <a href="{NOTEBOOKS}/{name}" download>notebook'
            f'</a>.</p>')


def _provenance_note(facts: dict[str, str]) -> str:
    state = f', as of {facts["date"]} ({facts["commit"]}{" " + facts["changed"] if facts["changed"] else ""})' \
        if 'commit' in facts else ''
    return (f'<p class="lesson-about-page">This file is one lesson of the course <em>Mastering ROS 2 Parameters with '
            f'Python</em>{state}. It ran on Python {facts["Python"]} with rclpy {facts["rclpy"]} of ROS 2 Jazzy; what '
            f'each cell put out stands below it.</p>')


def _help_html(number: str, path: Path) -> str:
    """Return the hints and the solution of an exercise, each closed."""
    exercise = next((each for each in EXERCISES.values() if each.number.replace('.', '-') == number), None)
    if exercise is None:
        return ''
    count = len(exercise.hints)
    parts = [drawing.details(f'Exercise {exercise.number}: hint {position} of {count}',
                             f'<p>{with_code(hint)}</p>')
             for position, hint in enumerate(exercise.hints, 1)]
    solved = path.parent / exercise.solutions
    if solved.exists():
        cells = nbformat.read(solved, as_version=4).cells
        at = next(index for index, cell in enumerate(cells) if cell.id == f'solution-{number}')
        words = re.sub(r'^#+ .*\n+', '', cells[at - 1].source) if cells[at - 1].cell_type == 'markdown' else ''
        said = ''.join(output.data.get('text/html', '') for cell in cells[at:at + 2]
                       for output in cell.get('outputs', ()) if 'data' in output)
        paragraphs = ''.join(f'<p>{with_code(each)}</p>' for each in words.split('\n\n') if each.strip())
        parts.append(drawing.details(f'Exercise {exercise.number}: a worked solution',
                                     f'{paragraphs}{drawing.code(cells[at].source)}{said}'))
    return f'<div class="lesson-help">{"".join(parts)}</div>'
