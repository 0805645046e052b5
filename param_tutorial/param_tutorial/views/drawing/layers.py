"""Where a value comes from: sources that lie on each other like layers. The one on top counts."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from param_tutorial.views.drawing import svg
from param_tutorial.views.drawing.diagram import WIDTH, Diagram, Moving, Part, Seen

_TOP, _DEPTH, _BOTTOM, _LEFT, _RIGHT, _EYE_X, _EYE_Y, _SLAB = 92, 14, 14, 16, 516, 266, 26, 36
_TITLE_LETTERS, _SLAB_LETTERS = 20, 56
_BEGIN_SEC, _EACH_SEC, _FALL_SEC = 0.4, 1.1, 0.5


@dataclass(frozen=True)
class _Entry:
    """The value that one source (default, file, override) gives to the parameter."""

    source: str
    value: str
    begin_sec: float

    def words(self, between: str) -> str:
        """Return the source and its value; a source that ends with the value, like ``-p speed:=400``, says both."""
        says_both = self.source.endswith((f' {self.value}', f'={self.value}'))
        return self.source if says_both else f'{self.source}{between}{self.value}'


def draw_layers(name: str, sources: Iterable[tuple[str, Any] | tuple[str, str, Any]], *, has: Any) -> Diagram:
    """Draw the sources of one parameter's value; at rest all layers lie on each other.

    LayersView explains the arguments.
    """
    layers: dict[str, list[_Entry]] = {}
    for number, (source, *into, value) in enumerate(sources):
        entry = _Entry(str(source), repr(value), _BEGIN_SEC + number * _EACH_SEC)
        layers.setdefault(into[0] if into else entry.source, []).append(entry)
    top = list(layers.values())[-1][-1]
    in_node = repr(has)
    is_explained = in_node == top.value
    sentence = f'{name} = {in_node}, from {top.source}.' if is_explained else \
        f'The node has {name} = {in_node}, which these layers do not explain.'
    lines = [_title(layer, entries) + ': ' * bool(_title(layer, entries))
             + ', then '.join(entry.words(' ') for entry in entries) for layer, entries in layers.items()]
    diagram = Diagram(name, sentence, f'Layers of {name}, from the top: {"; ".join(reversed(lines))}. {sentence}',
                      _TOP + _DEPTH + len(layers) * _SLAB + _BOTTOM)
    end_sec = _BEGIN_SEC + sum(map(len, layers.values())) * _EACH_SEC
    y = diagram.height - _BOTTOM
    for layer, entries in layers.items():
        y -= _SLAB
        is_top = entries[-1] is top
        diagram.add(_slab(y, _title(layer, entries), entries, is_top=is_top))
        words = f'on top{": this counts" * is_explained}' if is_top else 'covered'
        diagram.show(end_sec, svg.words(_RIGHT + 36, y + 23, words, 'bold' if is_top else 'faint', anchor='start'))
    # From above you see the top layer only.
    diagram.show(end_sec, svg.path(f'M{_EYE_X - 20} {_EYE_Y}q20 -18 40 0q-20 18 -40 0z'),
                 svg.circle(_EYE_X, _EYE_Y, 6), svg.path(f'M{_EYE_X} {_EYE_Y + 16}V{_TOP - 4}', 'dashed'),
                 svg.words(_EYE_X + 36, _EYE_Y + 5, f'the node has {svg.cut(in_node, 30)}', 'big', anchor='start'))
    return diagram


def _slab(y: float, title: str, entries: list[_Entry], *, is_top: bool) -> Moving:
    """Return a layer, which falls from above onto those that lie there already."""
    parts: list[Part] = [
        svg.path(f'M{_LEFT} {y}l{_DEPTH} {-_DEPTH}H{_RIGHT + _DEPTH}l{-_DEPTH} {_DEPTH}z', 'blank'),
        svg.path(f'M{_RIGHT} {y}l{_DEPTH} {-_DEPTH}v{_SLAB}l{-_DEPTH} {_DEPTH}z', 'box'),
        svg.box(_LEFT, y, _RIGHT - _LEFT, _SLAB, 'blank' if is_top else 'box', rounding=0)]
    x, title = _LEFT + 12.0, svg.cut(title, _TITLE_LETTERS)
    if title:
        parts.append(svg.words(x, y + 23, title, 'code', anchor='start'))
        x += svg.CODE_WIDTH * len(title) + 18
    for entry, later in zip(entries, [*entries[1:], None], strict=True):
        text = svg.cut(entry.words(': '), _SLAB_LETTERS // len(entries))
        width = svg.CODE_WIDTH * len(text)
        words: list[Part] = [svg.words(x, y + 23, text, 'value', anchor='start')]
        if later:
            words.append(Seen(svg.path(f'M{x - 3:.1f} {y + 18.5}h{width:.1f}'), later.begin_sec + _FALL_SEC))
        # Later sources of this layer come from the side, and slip under whatever lies above.
        parts += words if entry is entries[0] else [Moving(words, easing='ease-out', stops=[
            (entry.begin_sec, WIDTH, 0), (entry.begin_sec + _FALL_SEC, 0, 0)])]
        x += width + 22
    begin_sec = entries[0].begin_sec
    return Moving(parts, [(begin_sec, 0, -y - _SLAB - 20), (begin_sec + _FALL_SEC, 0, 0)], easing='ease-in')


def _title(layer: str, entries: list[_Entry]) -> str:
    """Return the name of a layer; empty if it is that of its only source."""
    return layer if len(entries) > 1 or layer != entries[0].source else ''
