"""The page of a class: what to talk about next, with the students' names, as one file without scripts."""

import datetime
import html

from param_tools.markup.styles import style
from param_tools.markup.tables import Markup, table, with_code
from param_tools.markup.wording import format_count
from param_tutorial.teacher import misconceptions
from param_tutorial.teacher.classroom import Student, rows
from param_tutorial.teacher.misconceptions import Answered, Stuck

_STYLE = style('param_tutorial/teacher/page.css')


def document(title: str, content: str) -> str:
    """Return a whole page for a browser.

    :param content: HTML.
    """
    return ('<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
            f'<meta name="viewport" content="width=device-width"><title>{html.escape(title)}</title>'
            f'{_STYLE}</head>\n<body><h1>{html.escape(title)}</h1>\n{content}</body></html>\n')


def class_page(students: list[Student]) -> str:
    """Return the page of a class; what concerns the most students comes first."""
    waiting = [each.name for each in students if not each.has_begun]
    begun = (f'{format_count(len(students), "student")}. '
             + (f'Not begun: {_names(waiting)}.' if waiting else 'All have begun.'))
    parts = [f'<p>{begun} Read on {datetime.date.today().isoformat()} from the files in this folder.</p>']
    asked, held_up = misconceptions.answers(students), misconceptions.stuck(students)
    parts.append('<h2>Questions that were answered wrongly</h2>')
    parts += map(_answered, asked) if asked else ['<p>None.</p>']
    parts.append('<h2>Exercises that hold somebody up</h2>')
    parts += map(_stuck, held_up) if held_up else ['<p>None.</p>']
    headings, *lines = rows(students)
    parts.append('<h2>Exercises solved</h2><div class="wide" tabindex="0" role="region" aria-label="Exercises solved">'
                 f'{table(headings, lines, row_headers=True)}</div>')
    return document('What the class thinks', '\n'.join(parts))


def _answered(asked: Answered) -> str:
    question = asked.question
    items = ''.join(
        f'<li class="{"right" if choice.is_right else "wrong"}"><b>{len(names)} {"✓" if choice.is_right else "✗"}</b> '
        f'{with_code(choice.text)} <small>{_names(names)}</small>'
        + (f'<p>{with_code(choice.sentence)}</p>' if not choice.is_right and choice.sentence else '') + '</li>'
        for choice, names in asked.by_choice)
    return (f'<section><h3>{question.number} · {asked.wrong} of {asked.total} wrong</h3>'
            f'<p>{with_code(question.question)}</p><ul>{items}</ul></section>')


def _stuck(held_up: Stuck) -> str:
    items = ''.join(
        f'<li class="wrong"><b>{len(by_student)} ✗</b> {with_code(sentence)}<dl>'
        + ''.join(f'<dt>{html.escape(name)}</dt><dd>{with_code(happened) or "not met"}</dd>'
                  for name, happened in by_student.items()) + '</dl></li>'
        for sentence, by_student in held_up.by_requirement)
    return (f'<section><h3>{held_up.number} · {with_code(held_up.title)}</h3><p>{len(held_up.names)} tried it and '
            f'have not solved it; {held_up.solved} solved it.</p><ul>{items}</ul></section>')


def _names(names: list[str]) -> Markup:
    return Markup(html.escape(', '.join(names)))
