"""Moving pictures for the README: an animated WebP from pictures of a page, an SVG from what a terminal showed."""

import base64
import html
import struct
from collections.abc import Iterable
from dataclasses import dataclass

from playwright.sync_api import Browser

# What differs from the frame before, as a lossless WebP on a transparent ground: [its bytes in base64, left, top,
# width, height]. The container counts left and top in steps of two pixels.
_CODE = '''async ([before, after]) => {
    const pixels = async png => {
        const bitmap = await createImageBitmap(await (await fetch('data:image/png;base64,' + png)).blob());
        const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
        const context = canvas.getContext('2d', {willReadFrequently: true});
        context.drawImage(bitmap, 0, 0);
        return context.getImageData(0, 0, bitmap.width, bitmap.height);
    };
    const now = await pixels(after);
    const then = before && new Uint32Array((await pixels(before)).data.buffer);
    const words = new Uint32Array(now.data.buffer);
    let [left, top, right, bottom] = [now.width, now.height, 0, 0];
    words.forEach((word, index) => {
        if (then && then[index] === word) {
            words[index] = 0;
            return;
        }
        const x = index % now.width, y = Math.floor(index / now.width);
        [left, top] = [Math.min(left, x), Math.min(top, y)];
        [right, bottom] = [Math.max(right, x + 1), Math.max(bottom, y + 1)];
    });
    if (right === 0) return null;
    [left, top] = [left - left % 2, top - top % 2];
    const part = document.createElement('canvas');
    [part.width, part.height] = [right - left, bottom - top];
    part.getContext('2d').putImageData(now, -left, -top);
    const url = part.toDataURL('image/webp', 1);
    return [url.slice(url.indexOf(',') + 1), left, top, part.width, part.height];
}'''


def _chunk(name: bytes, content: bytes) -> bytes:
    return name + struct.pack('<I', len(content)) + content + bytes(len(content) % 2)


def _number(value: int) -> bytes:
    return value.to_bytes(3, 'little')


def _image_of(webp: bytes) -> bytes:
    """Return the chunks of a still WebP that hold its pixels."""
    position, result = 12, b''
    while position < len(webp):
        size = struct.unpack_from('<I', webp, position + 4)[0]
        chunk = webp[position:position + 8 + size + size % 2]
        if chunk[:4] in (b'VP8 ', b'VP8L', b'ALPH'):
            result += chunk
        position += len(chunk)
    return result


def animated_webp(browser: Browser, frames: Iterable[tuple[bytes, float]]) -> bytes:
    """Return an endless animation (the container of https://developers.google.com/speed/webp/docs/riff_container).

    :param browser: A Chromium, which encodes the pictures.
    :param frames: Screenshots of one size as PNG, and for how many seconds each is shown.
    """
    page = browser.new_page()
    parts: list[tuple[bytes, int, int, int, int]] = []
    seconds: list[float] = []
    before = ''
    for png, duration in frames:
        after = base64.b64encode(png).decode()
        found = page.evaluate(_CODE, [before, after])
        if found is None:  # nothing has changed: the frame before stands longer
            seconds[-1] += duration
        else:
            parts.append((base64.b64decode(found[0]), *found[1:]))
            seconds.append(duration)
        before = after
    page.close()
    width, height = parts[0][3:]
    result = _chunk(b'VP8X', bytes([0x12, 0, 0, 0]) + _number(width - 1) + _number(height - 1))
    result += _chunk(b'ANIM', bytes([255, 255, 255, 255, 0, 0]))
    for (webp, left, top, width, height), duration in zip(parts, seconds):
        # Blended with the frame before, which stays.
        result += _chunk(b'ANMF', b''.join(map(_number, (left // 2, top // 2, width - 1, height - 1,
                                                         round(1000 * duration)))) + bytes([0]) + _image_of(webp))
    return _chunk(b'RIFF', b'WEBP' + result)


@dataclass(frozen=True)
class Command:
    """A line that was typed in a terminal, and what was printed."""

    line: str
    output: str
    seconds: float
    """How long a reader needs for the output."""


_COLUMNS = 104
_SIZE = (8.0, 18.0)
"""Width and height of a character, in px."""
_MARGIN = 14.0
_TYPING_SEC = 1.2
_STYLE = '''
text { font: 13px ui-monospace, SFMono-Regular, Menlo, Consolas, "DejaVu Sans Mono", monospace; white-space: pre;
  fill: #d4d4d4; }
.line { fill: #fff; font-weight: 600; }
'''


def terminal_svg(title: str, commands: Iterable[Command], *, is_moving: bool) -> str:
    """Return the picture of a terminal.

    :param title: What is seen, for those who cannot see it.
    :param is_moving: The commands appear one after the other, over and over; otherwise all are there.
    """
    groups: list[tuple[float, list[tuple[str, str]]]] = []
    time = 0.5
    for command in commands:
        groups.append((time, [('line', each) for each in _wrapped(f'$ {command.line}')]))
        time += _TYPING_SEC
        groups.append((time, [('output', each) for line in command.output.splitlines()
                              for each in _wrapped(line.expandtabs())]))
        time += command.seconds
    rules, drawn, row = [], [], 0
    for number, (begin, lines) in enumerate(groups):
        if is_moving:
            percent = 100 * begin / time
            rules.append(f'@keyframes k{number} {{ 0%, {percent - 0.01:.2f}% {{ opacity: 0 }} {percent:.2f}%, 100% '
                         f'{{ opacity: 1 }} }}\n#g{number} {{ animation: k{number} {time:g}s infinite }}')
        drawn.append(f'<g id="g{number}">')
        for kind, text in lines:
            row += 1
            if text:
                drawn.append(f'<text class="{kind}" x="{_MARGIN:g}" y="{_MARGIN + row * _SIZE[1] - 4:g}" textLength='
                             f'"{len(text) * _SIZE[0]:g}">{html.escape(text)}</text>')
        drawn.append('</g>')
    width, height = _COLUMNS * _SIZE[0] + 2 * _MARGIN, row * _SIZE[1] + 2 * _MARGIN
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:g} {height:g}" width="{width:g}" '
             f'height="{height:g}" role="img" aria-label="{html.escape(title)}">',
             f'<title>{html.escape(title)}</title>', f'<style>{_STYLE}{chr(10).join(rules)}\n</style>',
             f'<rect width="{width:g}" height="{height:g}" rx="8" fill="#1e1e1e"/>', *drawn, '</svg>']
    return '\n'.join(lines) + '\n'


def _wrapped(line: str) -> list[str]:
    """Return a line as a terminal breaks it, wherever the last column is."""
    return [line[start:start + _COLUMNS] for start in range(0, len(line), _COLUMNS)] or ['']
