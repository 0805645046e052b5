"""What a learner has achieved, as text and as HTML: a chapter's ticks, and the certificate of the whole course."""

import datetime
import html
from collections.abc import Sequence
from typing import NamedTuple

from param_tools.markup.styles import style
from param_tools.markup.tables import table, with_code
from param_tutorial.exercises.exercise import Exercise
from param_tutorial.exercises.prediction import Prediction
from param_tutorial.exercises.results import Answer
from param_tutorial.learner.progress import Progress, ProgressFile
from param_tutorial.learner.storage import write_whole
from param_tutorial.views.drawing.medal import medal

_STYLE = style('param_tutorial/exercises/achievements.css')
HOW = 'Start the course with `make lab`, and what you solve is remembered and ticked here.'
CERTIFICATE = 'certificate.html'


class Chapter(NamedTuple):
    """What there is to solve in one chapter."""

    number: str
    name: str
    """Of its notebook, without the ending."""
    exercises: Sequence[Exercise]
    recalls: Sequence[Prediction]
    """Its questions about earlier chapters."""
    predictions: Sequence[Prediction]
    praise: str
    """A sentence for the learner who has solved it."""


class ChapterProgress(Answer):
    """What a learner has solved of one chapter."""

    def __init__(self, chapter: Chapter, file: ProgressFile | None):
        """:param file: The learner's; None if nothing is remembered."""
        self._chapter, self._remembers = chapter, file is not None
        progress, note = file.read() if file else (Progress(), '')
        self._solved = {number: _day(at) for number, at in progress.solved.items()}
        self._predicted = progress.predicted
        super().__init__(note)

    @property
    def is_solved(self) -> bool:
        return all(each.number in self._solved for each in self._chapter.exercises)

    @property
    def _heading(self) -> str:
        exercises, predictions = self._chapter.exercises, self._chapter.predictions
        if not self._remembers:
            return f'Chapter {self._chapter.number}: {len(exercises)} exercises, {len(predictions)} predictions'
        solved = sum(each.number in self._solved for each in exercises)
        made = [self._predicted[each.number] for each in predictions if each.number in self._predicted]
        return (f'Chapter {self._chapter.number}: {solved} of {len(exercises)} exercises solved, {len(made)} of '
                f'{len(predictions)} predictions made, {sum(each.right for each in made)} of them right')

    def __repr__(self) -> str:
        lines = [self._heading, '']
        for each in self._chapter.exercises:
            mark = '✓' if each.number in self._solved else '·'
            lines.append(f'{mark} {each.number:<5} {each.title}  {self._solved.get(each.number, "")}'.rstrip())
        for questions in filter(None, (self._chapter.recalls, self._chapter.predictions)):
            lines += ['', ' '.join(f'{each.number}{self._mark(each)}' for each in questions)]
        if self._remembers and self.is_solved:
            lines += ['', f'Solved. {self._chapter.praise}']
        return '\n'.join([*lines, *(['', HOW] if not self._remembers else []), *([self.text] if self.text else [])])

    def _mark(self, prediction: Prediction) -> str:
        made = self._predicted.get(prediction.number)
        return '' if made is None else ' ✓' if made.right else ' ✗'

    def _repr_html_(self) -> str:
        exercises = ''.join(
            f'<li class="{"param-solved" if each.number in self._solved else ""}">'
            f'<span aria-hidden="true">{"✓" if each.number in self._solved else "·"}</span> <b>{each.number}</b> '
            f'{with_code(each.title)} <small>{self._solved_words(each)}</small></li>'
            for each in self._chapter.exercises)
        questions = ''.join(
            f'<p>{title}:</p><ul class="param-predictions">'
            + ''.join(f'<li>{each.number}{self._prediction_words(each)}</li>' for each in asked) + '</ul>'
            for title, asked in (('Earlier chapters', self._chapter.recalls),
                                 ('Predictions', self._chapter.predictions)) if asked)
        solved = self._remembers and self.is_solved
        praise = (f'<div class="param-praise">{medal(self._chapter.number)}'
                  f'<p><b>Solved.</b> {with_code(self._chapter.praise)}</p></div>' if solved else '')
        notes = ''.join(f'<p>{with_code(each)}</p>' for each in (self.text, '' if self._remembers else HOW) if each)
        return (f'{_STYLE}<div class="param-progress"><p><b>{self._heading}</b></p>{praise}'
                f'<ul class="param-exercises">{exercises}</ul>'
                f'{questions}{notes}</div>')

    def _solved_words(self, exercise: Exercise) -> str:
        if not self._remembers:
            return ''
        day = self._solved.get(exercise.number)
        return f'solved {day}' if day else 'not yet'

    def _prediction_words(self, prediction: Prediction) -> str:
        made = self._predicted.get(prediction.number)
        return '' if made is None else ' ✓ right' if made.right else ' ✗ not so'


class CourseProgress(Answer):
    """What a learner has solved of the whole course, a row for each chapter."""

    def __init__(self, chapters: Sequence[Chapter], file: ProgressFile | None):
        """:param file: The learner's; None if nothing is remembered."""
        progress, note = file.read() if file else (Progress(), HOW)
        self._rows = []
        for each in chapters:
            solved = sum(exercise.number in progress.solved for exercise in each.exercises)
            made = sum(prediction.number in progress.predicted for prediction in each.predictions)
            self._rows.append(('✓' if solved == len(each.exercises) else '·', each.number,
                               f'{solved}/{len(each.exercises)}', f'{made}/{len(each.predictions)}'))
        super().__init__(note)

    def __repr__(self) -> str:
        lines = [f'{mark} {number:<5} exercises {solved}   predictions {made}'
                 for mark, number, solved, made in self._rows]
        return '\n'.join([*lines, *(['', self.text] if self.text else [])])

    def _repr_html_(self) -> str:
        rows = table(('', 'chapter', 'exercises solved', 'predictions made'), self._rows)
        note = f'<p>{with_code(self.text)}</p>' if self.text else ''
        return f'{_STYLE}<div class="param-progress">{rows}{note}</div>'


class Certificate(Answer):
    """What a learner has proved; with the learner's name, as a page that is written beside the file of progress."""

    def __init__(self, chapters: Sequence[Chapter], file: ProgressFile | None, name: str):
        """:param name: The learner's; without it, no page is written."""
        self._html = ''
        if file is None:
            super().__init__('A certificate lists the exercises that you have solved, with their dates. ' + HOW)
            return
        progress, note = file.read()
        solved = {number: _day(at) for number, at in progress.solved.items()}
        total = sum(len(each.exercises) for each in chapters)
        count = sum(each.number in solved for chapter in chapters for each in chapter.exercises)
        if not count:
            super().__init__(f'There is nothing to certify yet: the course has {total} exercises. {note}'.strip())
            return
        if not name:
            super().__init__(f'{count} of {total} exercises proved. To have it as a page that you can print, give it '
                             f"your name: `exercises.certificate('Ada Lovelace')`. {note}".strip())
            return
        self._html = _certificate(chapters, solved, name, count, total)
        path = file.path.with_name(CERTIFICATE)
        try:
            write_whole(path, _page(self._html).encode())
            said = f'The page is {path.name}, beside your chapters: open it in a browser, and print it.'
        except OSError as error:
            said = f'The page {path.name} could not be written: {error.strerror}.'
        super().__init__(f'{count} of {total} exercises proved. {said} {note}'.strip())

    def _repr_html_(self) -> str:
        return f'{super()._repr_html_()}{self._html}'


def _certificate(chapters: Sequence[Chapter], solved: dict[str, str], name: str, count: int, total: int) -> str:
    rows = ''.join(
        f'<tr><th scope="row">{each.number}</th><td>{with_code(each.title)}</td><td>{solved[each.number]}</td></tr>'
        for chapter in chapters for each in chapter.exercises if each.number in solved)
    robot = medal('')
    return (f'{_STYLE}<section class="param-certificate" aria-label="Certificate">{robot}'
            f'<p>Mastering ROS 2 Parameters with Python</p><h1>{html.escape(name)}</h1>'
            f'<p>has solved {"all" if count == total else count} of {total} exercises. Each was checked on a running '
            f'node.</p><table><thead><tr><th scope="col">Exercise</th><th scope="col">What was proved</th>'
            f'<th scope="col">Date</th></tr></thead><tbody>{rows}</tbody></table>'
            f'<p><small>Made on {datetime.date.today().isoformat()} from the file of progress, which is the '
            f"learner's own.</small></p></section>")


def _page(content: str) -> str:
    return ('<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
            '<meta name="viewport" content="width=device-width">'
            f'<title>Certificate</title></head><body>{content}</body></html>\n')


def _day(at: str) -> str:
    return at.partition('T')[0]
