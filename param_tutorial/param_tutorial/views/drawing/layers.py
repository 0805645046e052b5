"""Where a value comes from: sources that lie on each other like layers. The one on top counts."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

from param_tutorial.views.drawing import svg

_TOP, _SLAB, _DEPTH, _BOTTOM = 92, 36, 14, 14
_LEFT, _SLAB_WIDTH, _WORDS_X = 16, 500, 552
_EYE_X, _EYE_Y = 266, 26
_BEGIN_SEC, _EACH_SEC, _FALL_SEC = 0.4, 1.1, 0.5
_LETTERS = 56


@dataclass(frozen=True)
class _Entry:
    """What one source says."""

    source: str
    value: str
    begin_sec: float

    def words(self, between: str) -> str:
        """Return the source and its value; a source that ends with the value, like ``-p speed:=400``, says both."""
        says_both = self.source.endswith((f' {self.value}', f'={self.value}'))
        return self.source if says_both else f'{self.source}{between}{self.value}'


class Layers(svg.AnimatedPicture):
    """The sources of one parameter's value; at rest all layers lie on each other. LayersView explains the arguments."""

    def __init__(self, name: str, sources: Iterable[tuple[str, Any] | tuple[str, str, Any]], *, has: Any = ...) -> None:
        self.subject = name
        self._layers: dict[str, list[_Entry]] = {}
        for number, (source, *layer, value) in enumerate(sources):
            entry = _Entry(str(source), repr(value), _BEGIN_SEC + number * _EACH_SEC)
            self._layers.setdefault(layer[0] if layer else entry.source, []).append(entry)
        if not self._layers:
            raise ValueError('Layers takes one source at least')
        self._top = list(self._layers.values())[-1][-1]
        self._has = self._top.value if has is ... else repr(has)
        self._end_sec = _BEGIN_SEC + sum(map(len, self._layers.values())) * _EACH_SEC

    @property
    def sentence(self) -> str:
        """What counts."""
        if self._has != self._top.value:
            return f'The node has {self.subject} = {self._has}, which these layers do not explain.'
        return f'{self.subject} = {self._has}, from {self._top.source}.'

    @property
    def text(self) -> str:
        lines = [_title(layer, entries) + ': ' * bool(_title(layer, entries))
                 + ', then '.join(entry.words(' ') for entry in entries) for layer, entries in self._layers.items()]
        return f'Layers of {self.subject}, from the top: {"; ".join(reversed(lines))}. {self.sentence}'

    @property
    def _height(self) -> float:
        return _TOP + _DEPTH + len(self._layers) * _SLAB + _BOTTOM

    def _parts(self, animation: svg.Animation) -> Iterator[str]:
        for number, (layer, entries) in enumerate(self._layers.items()):
            yield from self._slab(self._height - _BOTTOM - (number + 1) * _SLAB, layer, entries, animation)
        # From above you see the top layer only.
        yield svg.group([svg.path(f'M{_EYE_X - 20} {_EYE_Y}q20 -18 40 0q-20 18 -40 0z'),
                         svg.circle(_EYE_X, _EYE_Y, 6),
                         svg.path(f'M{_EYE_X} {_EYE_Y + 16}V{_TOP - 4}', 'dashed'),
                         svg.words(_EYE_X + 36, _EYE_Y + 5, f'the node has {svg.cut(self._has, 30)}', 'big',
                                   anchor='start')], animation.appear(self._end_sec))

    def _slab(self, y: float, layer: str, entries: list[_Entry], animation: svg.Animation) -> Iterator[str]:
        first, is_top, right = entries[0], entries[-1] is self._top, _LEFT + _SLAB_WIDTH
        faces = [svg.path(f'M{_LEFT} {y}l{_DEPTH} {-_DEPTH}H{right + _DEPTH}l{-_DEPTH} {_DEPTH}z', 'blank'),
                 svg.path(f'M{right} {y}l{_DEPTH} {-_DEPTH}v{_SLAB}l{-_DEPTH} {_DEPTH}z', 'box'),
                 svg.box(_LEFT, y, _SLAB_WIDTH, _SLAB, 'blank' if is_top else 'box', rounding=0)]
        yield svg.group([*faces, *self._names(y + 23, layer, entries, animation)], animation.travel(
            [(first.begin_sec, 0, -y - _SLAB - 20), (first.begin_sec + _FALL_SEC, 0, 0)], 'ease-in'))
        counts = 'on top: this counts' if self._has == self._top.value else 'on top'
        yield svg.group(svg.words(_WORDS_X, y + 23, counts if is_top else 'covered', 'bold' if is_top else 'faint',
                                  anchor='start'), animation.appear(self._end_sec))

    def _names(self, y: float, layer: str, entries: list[_Entry], animation: svg.Animation) -> Iterator[str]:
        x = _LEFT + 12.0
        if title := svg.cut(_title(layer, entries), 20):
            yield svg.words(x, y, title, 'code', anchor='start')
            x += svg.CODE_WIDTH * len(title) + 18
        for number, entry in enumerate(entries):
            text = svg.cut(entry.words(': '), _LETTERS // len(entries))
            width = svg.CODE_WIDTH * len(text)
            parts = [svg.words(x, y, text, 'value', anchor='start')]
            if later := entries[number + 1:]:
                parts.append(svg.path(f'M{x - 3:.1f} {y - 4.5}h{width:.1f}',
                                      style=animation.appear(later[0].begin_sec + _FALL_SEC)))
            # Later sources of this layer come from the side, and slip under whatever lies above.
            yield svg.group(parts, animation.travel([(entry.begin_sec, self._width, 0), (
                entry.begin_sec + _FALL_SEC, 0, 0)], 'ease-out') if number else '')
            x += width + 22


def _title(layer: str, entries: list[_Entry]) -> str:
    """Return the name of a layer; empty if it is that of its only source."""
    return layer if len(entries) > 1 or layer != entries[0].source else ''
