"""What a reader fills in to answer an exercise on a page, where no kernel runs its check: blanks, an order or settings.

``lessons.recording.answers`` hands the check what can be filled in, and the page says what the check said.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True)
class Blanks:
    """Values to write. There is one requirement for each, and what it says does not depend on the others."""

    guesses: Mapping[str, Sequence[Any]]
    """By the name of each blank, code or a sentence, in the order of the requirements: what people write into it. The
    page knows the right value too, and what is said to any other value of a type, unless the blanks take texts."""
    choices: Sequence[Any] = ()
    """If the reader chooses: from what."""
    word: str = ''
    """One that may stand in place of a value; capitals and spaces around it do not count."""
    is_text: bool = False
    """True if what is written is a text as it stands, and no Python value."""
    shown: Mapping[str, str] = field(default_factory=dict)
    """What stands in the blanks at first; by default nothing."""
    make_work: Callable[[dict[str, Any]], Any] = dict
    """Returns what is handed to the check."""


@dataclass(frozen=True)
class Order:
    """Lines to put in order: those of the exercise's cell, or letters that stand for what happens."""

    letters: Mapping[str, str] | None = None


@dataclass(frozen=True)
class Combination:
    """Values to choose together; what is said to one depends on the others."""

    choices: Mapping[str, Sequence[Any]]
    """By the name of each."""
    start: Mapping[str, Any]
    """What the page shows at first."""
    make_work: Callable[[dict[str, Any]], Any] = dict
    """Returns what is handed to the check."""


Form = Blanks | Order | Combination
