"""Pieces of HTML that several views write: the cells of a table, and texts with code in them. No ROS, no Jupyter."""

import html
import re
from collections.abc import Iterable


def with_code(text: str) -> str:
    """Make HTML of a text in which backquotes stand around code."""
    return re.sub(r'`([^`]+)`', r'<code>\1</code>', html.escape(text, quote=False))


def head_row(words: Iterable[str]) -> str:
    """Make the first row of a table: what stands in each column."""
    return '<tr>' + ''.join(f'<th scope="col">{html.escape(word)}</th>' for word in words) + '</tr>'


def cells(words: Iterable[str]) -> str:
    """Make the cells of a row; what surrounds them is the caller's."""
    return ''.join(f'<td>{html.escape(word)}</td>' for word in words)
