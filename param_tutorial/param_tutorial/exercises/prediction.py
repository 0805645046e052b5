"""What a prediction is: a question about the next cell, and a sentence for each answer that people give.

A recall is its sister: a question about an earlier chapter, which no cell has to decide.
"""

from dataclasses import dataclass
from typing import ClassVar, NamedTuple

# In the output of a cell that shows a prediction: its number, so that a page of the website can show it as a form.
MIME_TYPE = 'application/x-param-tutorial-prediction+json'


class Choice(NamedTuple):
    """One answer to a question."""

    text: str
    sentence: str
    """What the next cell shows about this answer."""
    is_right: bool

    @property
    def word(self) -> str:
        """The verdict in short."""
        return '✓ Right.' if self.is_right else '✗ Not so.'


def right(text: str, sentence: str) -> Choice:
    """Make the right choice: its text, and the sentence that confirms it."""
    return Choice(text, sentence, True)


def wrong(text: str, sentence: str) -> Choice:
    """Make a wrong choice: its text, and the sentence that refutes it."""
    return Choice(text, sentence, False)


@dataclass(frozen=True)
class Scale:
    """Where the learner puts a marker, and does not type a number."""

    low: float
    high: float
    step: float
    unit: str = ''
    tolerance: float = 0.0
    """How far from a choice's number an answer may be that means that choice."""
    is_track: bool = False
    """True for the distance of the robot from the wall: pictures of the track show the marker, too, as a robot."""

    def __str__(self) -> str:
        return f'(put a marker between {self.low:g} and {self.high:g}{f" {self.unit}" if self.unit else ""})'


@dataclass(frozen=True)
class Prediction:
    """A question that the learner answers before running the cell that decides it."""

    number: str
    """Of the chapter, and its own: '5.2-1'."""
    question: str
    """Code stands between backquotes."""
    choices: tuple[Choice, ...]
    """In the order in which they are shown; their texts are plain. One of them is right."""
    otherwise: str = ''
    """The sentence for any other number. With it the learner gives a number, and the choices are not shown."""
    scale: Scale | None = None
    """Where the number is given in a picture; None where it is typed."""

    word: ClassVar[str] = 'Predict'
    """What the learner is asked to do."""
    is_decided_by_a_cell: ClassVar[bool] = True
    """True if the learner is told what is right only after the next cell has run."""

    @property
    def is_number(self) -> bool:
        """True if the learner gives a number, and does not choose."""
        return bool(self.otherwise)

    def choice(self, text: str) -> Choice:
        """Return what belongs to an answer: a choice, or what is said to any other."""
        return next((each for each in self.choices if each.text == text), wrong(text, self.otherwise))

    @property
    def text(self) -> str:
        """The question and the choices, without the answer."""
        number = str(self.scale or '(type a value)')
        lines = [number] if self.is_number else [f'( ) {each.text}' for each in self.choices]
        return '\n'.join([f'{self.word} {self.number} · {self.question}', *(f'    {line}' for line in lines)])

    @property
    def right(self) -> str:
        """The text of the right choice."""
        return next(each.text for each in self.choices if each.is_right)

    def words_for(self, choice: Choice) -> str:
        """Return what is said to an answer after the verdict in short: why, and what is right."""
        if choice.is_right or choice.sentence == self.otherwise:  # that one says it itself
            return choice.sentence
        answer = f'{self.right} {self.scale.unit if self.scale else ""}'.strip()
        return f'{choice.sentence} The answer is “{answer}”.'


@dataclass(frozen=True)
class Recall(Prediction):
    """A question about an earlier chapter; the answer is told at once."""

    chapter: str = ''
    """The number of the chapter in which it was learned, e.g. '5.2'."""
    section: str = ''
    """The heading there."""

    word: ClassVar[str] = 'Recall'
    is_decided_by_a_cell: ClassVar[bool] = False

    def words_for(self, choice: Choice) -> str:
        return f'{super().words_for(choice)} You learned it in chapter {self.chapter}, “{self.section}”.'
