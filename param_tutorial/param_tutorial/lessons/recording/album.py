"""Pictures of a node, one for each set of parameters that a reader is likely to choose, and films where it moves."""

import itertools
import math
from collections.abc import Iterator, Mapping
from typing import Any

from param_tutorial.lessons.recording.asking import Asker
from param_tutorial.lessons.recording.questions import choices, spread
from param_tutorial.lessons.recording.recorded import Row
from param_tutorial.widgets.recordable import Portrait

# How many combinations of values a node is pictured with.
_TOGETHER = 160
_SPREADS = (7, 5, 4, 3, 2)


class Album:
    """What a view shows of its node: taken while an answer holds, and of what no answer has brought."""

    def __init__(self, portrait: Portrait):
        self._portrait = portrait
        self._looks: dict[str, Any] = {}

    def take(self, changed: Mapping[str, str]) -> None:
        """Take the picture of the node as it is now, with these parameters changed."""
        if look := self._portrait.look():
            self._looks[_key(changed)] = look

    def fill(self, asker: Asker, rows: list[Row]) -> dict[str, list[dict[str, Any]]]:
        """Take the pictures that are missing, and return all, as 'pictures', or as 'films' where the node moves.

        :param rows: Those that have answers.
        """
        sets = list(_sets_to_see(rows))
        # All pictures of the node where it stands come first: from its first film on it stands elsewhere.
        for changed in sets:
            if _key(changed) not in self._looks:
                state = asker.enter(changed)
                self.take(changed)
                asker.leave(state)
        pictures = [{'changed': changed, 'look': self._looks[_key(changed)]} for changed in sets]
        if not self._portrait.in_motion:
            return {'pictures': pictures}
        return {'films': [{**picture, **film} for picture, film in zip(pictures, self._films(asker, sets))]}

    def _films(self, asker: Asker, sets: list[dict[str, str]]) -> Iterator[dict[str, Any]]:
        for changed in sets:
            state = asker.enter(changed)
            yield self._portrait.film() or {}
            asker.leave(state)
            # What had to wait goes on by itself now; the next film must not find it on its way.
            self._portrait.rest()


def _key(changed: Mapping[str, str]) -> str:
    """Return a name for a set of changed parameters, whatever their order."""
    return '\n'.join(f'{name}={text}' for name, text in sorted(changed.items()))


def _sets_to_see(rows: list[Row]) -> Iterator[dict[str, str]]:
    """Yield the sets of changed parameters that are to be seen: none, each alone, and some together."""
    shown = {row['name']: row['text'] for row in rows}
    moving = {row['name']: row for row in rows if not row['quiet'] and choices(row)}
    seen = set()
    for chosen in itertools.chain([{}], _each_alone(moving), _together(moving)):
        changed = {name: text for name, text in chosen.items() if text != shown[name]}
        if _key(changed) not in seen:
            seen.add(_key(changed))
            yield changed


def _each_alone(rows: dict[str, Row]) -> Iterator[dict[str, str]]:
    for name, row in rows.items():
        for text in choices(row):
            if 'value' in row['answers'][text]:
                yield {name: row['answers'][text]['value']}


def _together(rows: dict[str, Row]) -> Iterator[dict[str, str]]:
    """Yield combinations of values: of all parameters if they are few, of each two otherwise."""
    def some(row: Row, count: int) -> list[str]:
        taken = [text for text in choices(row) if 'value' in row['answers'][text]]
        return list(dict.fromkeys([row['text'], *spread(taken, count)]))

    for count in _SPREADS:
        texts = {name: some(row, count) for name, row in rows.items()}
        if math.prod(map(len, texts.values())) <= _TOGETHER:
            for chosen in itertools.product(*texts.values()):
                yield dict(zip(texts, chosen))
            return
    for (one, first), (two, second) in itertools.combinations(rows.items(), 2):
        for pair in itertools.product(some(first, 3), some(second, 3)):
            yield dict(zip((one, two), pair))
