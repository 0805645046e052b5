"""What a learner has solved of a chapter, as text and as HTML."""

from collections.abc import Sequence
from typing import NamedTuple

from param_tools.markup.styles import style
from param_tools.markup.tables import with_code
from param_tutorial.exercises.exercise import Exercise
from param_tutorial.exercises.prediction import Prediction
from param_tutorial.exercises.results import Answer
from param_tutorial.learner.progress import Progress, ProgressFile

_STYLE = style('param_tutorial/exercises/chapter_progress.css')
_HOW = 'Run this cell to see what you have solved: the website remembers it, as does the lab that `make lab` starts.'


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
        progress, note = file.read() if file else (Progress(), _HOW)
        self._solved = {number: at.partition('T')[0] for number, at in progress.solved.items()}
        self._predicted = progress.predicted
        self._praise = chapter.praise if all(each.number in self._solved for each in chapter.exercises) else ''
        super().__init__(note)

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
        if self._praise:
            lines += ['', f'Solved. {self._praise}']
        return '\n'.join([*lines, *(['', self.text] if self.text else [])])

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
        praise = f'<p><b>Solved.</b> {with_code(self._praise)}</p>' if self._praise else ''
        note = f'<p>{with_code(self.text)}</p>' if self.text else ''
        return (f'{_STYLE}<div class="param-progress"><p><b>{self._heading}</b></p>{praise}'
                f'<ul class="param-exercises">{exercises}</ul>{questions}{note}</div>')

    def _solved_words(self, exercise: Exercise) -> str:
        if not self._remembers:
            return ''
        day = self._solved.get(exercise.number)
        return f'solved {day}' if day else 'not yet'

    def _prediction_words(self, prediction: Prediction) -> str:
        mark = self._mark(prediction)
        return f'{mark} {"right" if mark == " ✓" else "not so"}' if mark else ''
