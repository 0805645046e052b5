"""Pictures of a node, one for each set of parameters that hands choose, and films where it moves.

They are packed here, since there are thousands: deflated JSON, in which parts that repeat are written once.
"""

import base64
import hashlib
import itertools
import json
import math
import re
import zlib
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from param_tools import values
from param_tools.descriptor import Descriptor
from param_tools.panel.recordable import Portrait
from param_tutorial.site.recording.asking import Asker
from param_tutorial.site.recording.questions import choices, is_value
from param_tutorial.site.recording.recorded import Row, key

# How many combinations a node is pictured with, where all its parameters are combined.
TOGETHER = 2600
# At which moments of a drive a change is recorded: a hand waits that long, at most, until it shows.
TURN_SEC = 0.5
# Where they are too many for that each two are combined: all that sliders offer, and so many words.
_WORDS = 6
# Up to so many letters a text is written as it is.
_SHORT = 20
# Where pictures of one node may begin to differ.
_SEAM = re.compile(r'(?=<)|(?=@keyframes)')


class Album:
    """What a view shows of its node, in states that the node is brought into one after another."""

    def __init__(self, portrait: Portrait, asker: Asker):
        self._portrait, self._asker = portrait, asker

    def fill(self, rows: list[Row], known: Iterable[str]) -> dict[str, Any]:
        """Take all pictures, and return them.

        :param rows: Those that have answers.
        :param known: The names of albums that need not be filled again, since the page has them.
        :return: 'looks' and 'names'; where the node moves, also the names of two albums, 'films' and 'turns', which
            holds what the node does if one parameter is changed on its way, and 'albums', those that are filled here.
        """
        moving = [row for row in rows if not row['quiet']]
        names = [row['name'] for row in moving]
        sets = list(_sets_to_see(moving, self._asker.descriptors))
        # All pictures of the node where it stands come first: from its first film on it stands elsewhere.
        looks = self._take(sets, self._portrait.look)
        recording: dict[str, Any] = {'names': names, 'looks': _pack(looks)}
        if self._portrait.in_motion:
            recording['films'] = self._name(moving)
            recording['turns'] = self._name(moving, key({row['name']: row['text'] for row in moving}))
            recording['albums'] = albums = {}
            if recording['films'] not in known:
                albums[recording['films']] = _pack(self._take(sets, self._film))
            if recording['turns'] not in known:
                albums[recording['turns']] = _pack(self._turns(moving))
        return recording

    def _take(self, sets: list[dict[str, str]], take: Any) -> dict[str, Any]:
        taken = {key(texts): take() for texts in sets if self._asker.show(texts)}
        self._asker.end_show()
        return {name: each for name, each in taken.items() if each}

    def _turns(self, rows: list[Row]) -> dict[str, Any]:
        """Return films of what follows on a change of one parameter, by the change and the number of the moment."""
        starts = self._portrait.moments(TURN_SEC)
        sets = [{row['name']: text} for row in rows for text in choices(row) if text != row['text']]
        turns = self._take(sets, lambda: [self._film(start) for start in starts])
        return {f'{changed}\n{number}': film for changed, films in turns.items()
                for number, film in enumerate(films, 1) if film}

    def _film(self, start: Any = None) -> Any:
        film = self._portrait.film(start=start)
        # What had to wait goes on by itself now; the next film must not find it on its way.
        self._portrait.rest()
        return film

    def _name(self, rows: list[Row], begin: str = '') -> str:
        """Return the same name wherever the same combinations would be filmed.

        :param begin: What they begin with, if that matters.
        """
        combined = {row['name']: choices(row) for row in rows}
        fixed = sorted((name, values.format_value(value)) for name, value in self._asker.shown.items()
                       if name not in combined)
        facts = json.dumps([self._asker.node, fixed, combined, begin])
        return hashlib.sha256(facts.encode()).hexdigest()[:12]


def _pack(pictures: dict[str, Any]) -> str:
    """Return pictures as text: in the place of each text that is worth it, the numbers of its parts."""
    def texts(each: Any) -> Iterator[str]:
        if isinstance(each, dict | list):
            for part in each.values() if isinstance(each, dict) else each:
                yield from texts(part)
        elif _is_long(each):
            yield each

    cut = {text: _SEAM.split(text) for text in set(texts(pictures))}
    # Sorted, those that are alike stand side by side, where deflation finds them.
    parts = sorted(set(itertools.chain.from_iterable(cut.values())))
    numbers = {part: number for number, part in enumerate(parts)}

    def plain(each: Any) -> Any:
        if isinstance(each, dict):
            return {name: plain(part) for name, part in each.items()}
        if isinstance(each, list):
            return [plain(part) for part in each]
        return {'$': [numbers[part] for part in cut[each]]} if _is_long(each) else each

    content = json.dumps({'parts': parts, 'pictures': plain(pictures)}, ensure_ascii=False, separators=(',', ':'))
    return base64.b64encode(zlib.compress(content.encode(), 9)).decode()


def _is_long(each: Any) -> bool:
    return isinstance(each, str) and len(each) > _SHORT


def _sets_to_see(rows: list[Row], descriptors: Mapping[str, Descriptor]) -> Iterator[dict[str, str]]:
    """Yield the sets of parameters that are to be seen, by their texts: as shown, each alone, and together."""
    shown = {row['name']: row['text'] for row in rows}
    seen = set()
    for chosen in itertools.chain([{}], _each_alone(rows, descriptors), _together(rows, descriptors)):
        texts = {**shown, **chosen}
        if key(texts) not in seen:
            seen.add(key(texts))
            yield texts


def _each_alone(rows: list[Row], descriptors: Mapping[str, Descriptor]) -> Iterator[dict[str, str]]:
    switches = [row for row in rows if row['editor'] == 'check']
    for row in rows:
        for text in (each for each in row['answers'] if is_value(descriptors[row['name']], each)):
            # With each switch too: that is the first thing that hands combine.
            for states in itertools.product(*(choices(switch) for switch in switches)):
                yield {**{switch['name']: state for switch, state in zip(switches, states)}, row['name']: text}


def _together(rows: list[Row], descriptors: Mapping[str, Descriptor]) -> Iterator[dict[str, str]]:
    """Yield combinations of values: of all parameters if they are not too many, of each two otherwise."""
    offered = {row['name']: list(dict.fromkeys([row['text'], *choices(row)])) for row in rows}
    if math.prod(map(len, offered.values())) <= TOGETHER:
        yield from (dict(zip(offered, chosen)) for chosen in itertools.product(*offered.values()))
        return
    switches = [row['name'] for row in rows if row['editor'] == 'check']
    offered |= {row['name']: [text for text in row['answers'] if is_value(descriptors[row['name']], text)][:_WORDS]
                for row in rows if not choices(row)}
    for two in itertools.combinations([name for name in offered if name not in switches], 2):
        names = (*two, *switches)
        for chosen in itertools.product(*(offered[name] for name in names)):
            yield dict(zip(names, chosen))
