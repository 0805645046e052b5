"""Where a value comes from: sources that lie on each other like layers. The one on top counts."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

from param_tutorial.views.drawing import svg

_TOP, _DEPTH, _BOTTOM, _LEFT, _EYE_Y = 92, 14, 14, 16, 26
_BEGIN_SEC, _EACH_SEC, _FALL_SEC = 0.4, 1.1, 0.5


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

    _has_narrow = True

    def __init__(self, name: str, sources: Iterable[tuple[str, Any] | tuple[str, str, Any]], *, has: Any = ...) -> None:
        self.subject = name
        self._layers: dict[str, list[_Entry]] = {}
        for number, (source, *layer, value) in enumerate(sources):
            entry = _Entry(str(source), repr(value), _BEGIN_SEC + number * _EACH_SEC)
            self._layers.setdefault(layer[0] if layer else entry.source, []).append(entry)
        self._top = list(self._layers.values())[-1][-1]
        self._has = self._top.value if has is ... else repr(has)
        self._end_sec = _BEGIN_SEC + sum(map(len, self._layers.values())) * _EACH_SEC

    @property
    def sentence(self) -> str:
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
        return _TOP + _DEPTH + len(self._layers) * self._slab_height + _BOTTOM

    @property
    def _slab_height(self) -> int:
        return 54 if self._is_narrow else 36

    @property
    def _right(self) -> int:
        """Where the front of a layer ends."""
        return self._width - 32 if self._is_narrow else 516

    def _parts(self, animation: svg.Animation) -> Iterator[str]:
        for number, (layer, entries) in enumerate(self._layers.items()):
            y = self._height - _BOTTOM - (number + 1) * self._slab_height
            yield from self._slab(y, layer, entries, animation)
        # From above you see the top layer only.
        eye_x, letters, kind = (38, 14, 'bold') if self._is_narrow else (266, 30, 'big')
        yield svg.group([svg.path(f'M{eye_x - 20} {_EYE_Y}q20 -18 40 0q-20 18 -40 0z'),
                         svg.circle(eye_x, _EYE_Y, 6),
                         svg.path(f'M{eye_x} {_EYE_Y + 16}V{_TOP - 4}', 'dashed'),
                         svg.words(eye_x + 36, _EYE_Y + 5, f'the node has {svg.cut(self._has, letters)}', kind,
                                   anchor='start')], animation.appear(self._end_sec))

    def _slab(self, y: float, layer: str, entries: list[_Entry], animation: svg.Animation) -> Iterator[str]:
        first, is_top, right, height = entries[0], entries[-1] is self._top, self._right, self._slab_height
        faces = [svg.path(f'M{_LEFT} {y}l{_DEPTH} {-_DEPTH}H{right + _DEPTH}l{-_DEPTH} {_DEPTH}z', 'blank'),
                 svg.path(f'M{right} {y}l{_DEPTH} {-_DEPTH}v{height}l{-_DEPTH} {_DEPTH}z', 'box'),
                 svg.box(_LEFT, y, right - _LEFT, height, 'blank' if is_top else 'box', rounding=0)]
        yield svg.group([*faces, *self._names(y, layer, entries, animation)], animation.travel(
            [(first.begin_sec, 0, -y - height - 20), (first.begin_sec + _FALL_SEC, 0, 0)], 'ease-in'))
        counts = 'on top: this counts' if self._has == self._top.value else 'on top'
        x, words_y, anchor = (right - 8, y + 20, 'end') if self._is_narrow else (right + 36, y + 23, 'start')
        yield svg.group(svg.words(x, words_y, counts if is_top else 'covered', 'bold' if is_top else 'faint',
                                  anchor=anchor), animation.appear(self._end_sec))

    def _names(self, y: float, layer: str, entries: list[_Entry], animation: svg.Animation) -> Iterator[str]:
        x, letters = _LEFT + 12.0, 56
        title_y = entry_y = y + 23
        if self._is_narrow:
            title_y, entry_y, letters = y + 20, y + 42, 28
        if title := svg.cut(_title(layer, entries), 11 if self._is_narrow else 20):
            yield svg.words(x, title_y, title, 'code', anchor='start')
            x += 0 if self._is_narrow else svg.CODE_WIDTH * len(title) + 18
        for number, entry in enumerate(entries):
            text = svg.cut(entry.words(': '), letters // len(entries))
            width = svg.CODE_WIDTH * len(text)
            parts = [svg.words(x, entry_y, text, 'value', anchor='start')]
            if later := entries[number + 1:]:
                parts.append(svg.path(f'M{x - 3:.1f} {entry_y - 4.5}h{width:.1f}',
                                      style=animation.appear(later[0].begin_sec + _FALL_SEC)))
            # Later sources of this layer come from the side, and slip under whatever lies above.
            yield svg.group(parts, animation.travel([(entry.begin_sec, self._width, 0), (
                entry.begin_sec + _FALL_SEC, 0, 0)], 'ease-out') if number else '')
            x += width + 22


def _title(layer: str, entries: list[_Entry]) -> str:
    """Return the name of a layer; empty if it is that of its only source."""
    return layer if len(entries) > 1 or layer != entries[0].source else ''
