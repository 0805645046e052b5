"""Small pieces of HTML that several pages have."""

import html

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
