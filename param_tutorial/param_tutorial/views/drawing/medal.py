"""The picture for a solved chapter: the robot rolls up to a flag, and stops where it should."""

import html


def medal(number: str) -> str:
    """Return the picture as SVG; its style is in ``exercises/achievements.css``.

    :param number: Of the chapter, which stands on the flag; empty for none.
    """
    what = f'the flag of chapter {html.escape(number)}' if number else 'a flag'
    wheels = ''.join(
        f'<g class="medal-wheel"><circle cx="{x}" cy="66" r="9" fill="none" stroke="currentColor" stroke-width="4"/>'
        f'<path d="M{x} 57v18M{x - 9} 66h18" stroke="currentColor" stroke-width="2"/></g>' for x in (34, 66))
    return (f'<svg class="param-medal" viewBox="0 0 140 84" role="img" aria-label="The robot stands at {what}">'
            f'<path d="M2 77h136" stroke="currentColor" stroke-width="3"/>'
            f'<path d="M104 77V10" stroke="currentColor" stroke-width="3"/>'
            f'<path class="medal-flag" d="M105 10h32l-7 11 7 11h-32z"/>'
            f'<text x="117" y="26" text-anchor="middle" font-size="13" font-weight="bold" fill="#fff">'
            f'{html.escape(number)}</text>'
            f'<g class="medal-robot"><rect class="medal-body" x="18" y="40" width="64" height="20" rx="5"/>'
            f'<rect class="medal-body" x="28" y="22" width="32" height="20" rx="5"/>'
            f'<circle cx="49" cy="31" r="4" fill="#fff"/><path d="M82 46h10m-10 8h10" stroke="currentColor" '
            f'stroke-width="4"/>{wheels}</g></svg>')
