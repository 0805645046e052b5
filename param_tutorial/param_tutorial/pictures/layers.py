"""Where a value comes from: sources that lie on each other like layers. The one on top counts."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

from param_tutorial.pictures import motion

_WIDTH, _TOP, _SLAB, _DEPTH, _BOTTOM = 720, 92, 36, 14, 14
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
        """Return the source and its value; a source that ends with the value, like ``-p 400``, says both."""
        return self.source if self.source.endswith(f' {self.value}') else f'{self.source}{between}{self.value}'


class Layers:
    """The sources of one parameter's value, as layers that cover each other.

    LayersView (``widgets.pictured``) explains the arguments.
    """

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

    @property
    def sentence(self) -> str:
        """What counts."""
        if self._has != self._top.value:
            return f'The node has {self.subject} = {self._has}, which these layers do not explain.'
        return f'{self.subject} = {self._has}, from {self._top.source}.'

    @property
    def text(self) -> str:
        """The picture in words, as a screen reader tells it."""
        return f'Layers of {self.subject}, from the top: {"; ".join(reversed(self._lines))}. {self.sentence}'

    @property
    def _lines(self) -> list[str]:
        return [f'{layer}: ' * (len(entries) > 1 or layer != entries[0].source)
                + ', then '.join(entry.words(' ') for entry in entries)
                for layer, entries in self._layers.items()]

    def __repr__(self) -> str:
        return '\n'.join([*reversed(self._lines), self.sentence])

    def html(self, reel: motion.Reel) -> str:
        """Return the picture; at rest all layers lie on each other."""
        count = len(self._layers)
        height = _TOP + _DEPTH + count * _SLAB + _BOTTOM
        parts: list[str] = []
        for number, (layer, entries) in enumerate(self._layers.items()):
            parts += self._slab(height - _BOTTOM - (number + 1) * _SLAB, layer, entries, reel)
        end_sec = _BEGIN_SEC + sum(map(len, self._layers.values())) * _EACH_SEC
        # From above one sees the top layer only.
        eye = [motion.path(f'M{_EYE_X - 20} {_EYE_Y}q20 -18 40 0q-20 18 -40 0z', 'motion-line'),
               f'<circle cx="{_EYE_X}" cy="{_EYE_Y}" r="6" class="motion-fill"/>',
               motion.path(f'M{_EYE_X} {_EYE_Y + 16}V{_TOP - 4}', 'motion-dashed'),
               motion.label(_EYE_X + 36, _EYE_Y + 5, f'the node has {motion.cut(self._has, 30)}', anchor='start',
                            css_class='motion-big')]
        parts.append(motion.group(eye, reel.appear(end_sec)))
        return motion.stage(self.subject, self.sentence, self.text, (_WIDTH, height), parts, reel)

    def _slab(self, y: float, layer: str, entries: list[_Entry], reel: motion.Reel) -> Iterator[str]:
        first, is_top = entries[0], entries[-1] is self._top
        right = _LEFT + _SLAB_WIDTH
        faces = [motion.path(f'M{_LEFT} {y}l{_DEPTH} {-_DEPTH}H{right + _DEPTH}l{-_DEPTH} {_DEPTH}z', 'motion-blank'),
                 motion.path(f'M{right} {y}l{_DEPTH} {-_DEPTH}v{_SLAB}l{-_DEPTH} {_DEPTH}z', 'motion-box'),
                 motion.box(_LEFT, y, _SLAB_WIDTH, _SLAB, 'motion-blank' if is_top else 'motion-box', rounding=0)]
        yield motion.group([*faces, *self._names(y, layer, entries, reel)], reel.travel(
            [(0, 0, -y - _SLAB - 20), (first.begin_sec, 0, -y - _SLAB - 20), (first.begin_sec + _FALL_SEC, 0, 0)],
            'ease-in'))
        # Later sources of this layer come from the side, and slip under whatever lies above.
        counts = 'on top: this counts' if self._has == self._top.value else 'on top'
        words = counts if is_top else 'covered'
        end_sec = _BEGIN_SEC + sum(map(len, self._layers.values())) * _EACH_SEC
        yield motion.group(motion.label(_WORDS_X, y + 23, words, anchor='start',
                                        css_class='motion-bold' if is_top else 'motion-faint'), reel.appear(end_sec))

    def _names(self, y: float, layer: str, entries: list[_Entry], reel: motion.Reel) -> Iterator[str]:
        x = _LEFT + 12.0
        if len(entries) > 1 or layer != entries[0].source:
            shown = motion.cut(layer, 20)
            yield motion.label(x, y + 23, shown, anchor='start', css_class='motion-code')
            x += motion.LETTER_WIDTH * 1.1 * len(shown) + 18
        for number, entry in enumerate(entries):
            later = entries[number + 1] if number + 1 < len(entries) else None
            text = motion.cut(entry.words(': '), _LETTERS // len(entries))
            width = motion.LETTER_WIDTH * 1.1 * len(text)
            parts = [motion.label(x, y + 23, text, anchor='start', css_class='motion-value')]
            if later is not None:
                parts.append(motion.path(f'M{x - 3:.1f} {y + 18.5}h{width:.1f}', 'motion-line',
                                         reel.appear(later.begin_sec + _FALL_SEC)))
            look = '' if number == 0 else reel.travel(
                [(0, _WIDTH, 0), (entry.begin_sec, _WIDTH, 0), (entry.begin_sec + _FALL_SEC, 0, 0)], 'ease-out')
            yield motion.group(parts, look)
            x += width + 22
