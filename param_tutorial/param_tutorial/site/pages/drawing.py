"""Small pieces of HTML that several pages have."""

import html
import json
import re
from typing import Any

from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import get_lexer_by_name


def code(source: str) -> str:
    """Return Python code as HTML, in the colors of the page."""
    html: str = highlight(source, get_lexer_by_name('ipython3'), HtmlFormatter(cssclass='highlight'))
    return html.replace('<pre>', '<pre tabindex="0">', 1)


def details(summary: str, content: str) -> str:
    """Return something that a reader opens and closes."""
    return f'<details class="lesson-details"><summary>{html.escape(summary)}</summary><div>{content}</div></details>'


def inline(text: str) -> str:
    """Return HTML of a text in which backquotes stand around code."""
    return re.sub(r'`([^`]+)`', r'<code>\1</code>', html.escape(text, quote=False))


def json_in_script(value: Any) -> str:
    """Return a value as JSON that may stand in a script's element, which ends at the first `</`."""
    return json.dumps(value, ensure_ascii=False, separators=(',', ':')).replace('</', r'<\/')
