"""A plan for each lesson, made from its chapter: minutes per section, what to ask, and what its questions test."""

import re
from pathlib import Path
from typing import NamedTuple

import nbformat

from param_tools.markup.tables import table, with_code
from param_tutorial.exercises import CHAPTERS
from param_tutorial.exercises.achievements import Chapter
from param_tutorial.exercises.prediction import Prediction
from param_tutorial.teacher.page import document

# At the head of a chapter: '*50 minutes.', or '*30 + 30 minutes.' for two sittings.
_MINUTES = re.compile(r'^\*([\d +]+) minutes\.', re.MULTILINE)
_ASKS = re.compile(r"exercises\.(predict|recall|check)\('([\w.-]+)'")
# What is not in the chapter's minutes: '*Fifteen minutes more, for a second sitting.*'
_MORE = re.compile(r'^\*(\w+ minutes) more, for a second sitting\.\*', re.MULTILINE)

# How a first-year student's time divides, in minutes. The chapter's own minutes decide on the sum.
_PER_WORD, _PER_CELL, _PER_QUESTION, _PER_EXERCISE = 1 / 150, 0.5, 1, 5


class Section(NamedTuple):
    """A part of a chapter, from one heading to the next."""

    title: str
    minutes: float
    numbers: list[str]
    """Of the questions and exercises in it."""
    later: str
    """What of it is for a second sitting, e.g. 'Fifteen minutes'; usually empty."""


def plans_page(chapters: Path) -> str:
    """Return the plans of all lessons as one page, which prints each on pages of its own.

    :param chapters: The folder of the notebooks.
    """
    return document('Plans of the lessons', '\n'.join(_plan(chapter, chapters / f'{chapter.name}.ipynb')
                                                      for chapter in CHAPTERS.values()))


def sections(chapter: nbformat.NotebookNode) -> list[Section]:
    """Return the sections of a chapter with their minutes, which add up to those at its head, but for rounding."""
    head, *cells = chapter.cells
    found = [Section('Questions about earlier chapters', 0, [], '')]
    weights = [0.0]
    is_later = False
    for cell in cells:
        title = re.match(r'(#{2,3}) (.+)', cell.source) if cell.cell_type == 'markdown' else None
        if title and title[1] == '##':
            found.append(Section(title[2], 0, [], ''))
            weights.append(0.0)
        if title:
            more = _MORE.search(cell.source)
            is_later = more is not None
            found[-1] = found[-1]._replace(later=more[1] if more else found[-1].later)
        asked = _ASKS.search(cell.source) if cell.cell_type == 'code' else None
        if asked:
            found[-1].numbers.append(asked[2])
        if not is_later:
            weights[-1] += _weight(cell, asked[1] if asked else '')
    minutes = sum(int(each) for each in _MINUTES.findall(head.source)[0].split('+'))
    return [each._replace(minutes=minutes * weight / sum(weights)) for each, weight in zip(found, weights) if weight]


def _weight(cell: nbformat.NotebookNode, asks: str) -> float:
    if cell.cell_type == 'markdown':
        return len(cell.source.split()) * _PER_WORD
    return {'check': _PER_EXERCISE, 'predict': _PER_QUESTION, 'recall': _PER_QUESTION}.get(asks, _PER_CELL)


def _plan(chapter: Chapter, path: Path) -> str:
    notebook = nbformat.read(path, as_version=4)
    head = notebook.cells[0].source
    title = head.splitlines()[0].removeprefix('# ')
    goals = ''.join(f'<li>{with_code(each)}</li>' for each in re.findall(r'^- (.+)$', head, re.MULTILINE))
    lines = [(each.title + (f' ({each.later.lower()} more for a second sitting)' if each.later else ''),
              f'{each.minutes:.0f}', ', '.join(each.numbers)) for each in sections(notebook)]
    parts = [f'<section class="lesson"><h2>{with_code(title)}</h2>',
             f'<p>Afterwards they can</p><ul class="plain">{goals}</ul>',
             table(('Section', 'Minutes', 'Questions and exercises'), lines, row_headers=True)]
    for heading, questions in (('Ask at the beginning', chapter.recalls),
                               ('What the questions test', chapter.predictions)):
        if questions:
            parts.append(f'<h3>{heading}</h3>{"".join(map(_question, questions))}')
    work = ''.join(f'<li><b>{each.number} · {with_code(each.title)}</b><br>'
                   f'{with_code("; ".join(one.sentence for one in each.requirements))}</li>'
                   for each in chapter.exercises)
    return '\n'.join([*parts, f'<h3>What the exercises ask for</h3><ul class="plain">{work}</ul></section>'])


def _question(question: Prediction) -> str:
    wrong = ''.join(f'<li class="wrong">✗ {with_code(each.text)}<br><small>{with_code(each.sentence)}</small></li>'
                    for each in question.choices if not each.is_right)
    right = ''.join(f'<li class="right">✓ {with_code(each.text)}</li>' for each in question.choices if each.is_right)
    return (f'<section><p><b>{question.number}</b> · {with_code(question.question)}</p>'
            f'<ul>{right}{wrong}</ul></section>')
