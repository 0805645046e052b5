"""Tables as HTML, and the text in their cells: columns with headings, rows in one group or several, a caption.

A cell is text, and whatever it says it stays text; only what is ``Markup`` already goes in as it is.
"""

import html
import re
from collections.abc import Iterable, Mapping, Sequence

Row = Sequence[str]

# Words begin and end with a letter; the asterisks of patterns and of arithmetic stay.
_CODE_OR_WORDS = re.compile(r'`([^`]+)`|(?<![\w*])\*([A-Za-z][^*`\n]*[A-Za-z.])\*(?![\w*])')


class Markup(str):
    """HTML that is complete, and must not be escaped again."""

    __slots__ = ()


def with_code(text: str) -> Markup:
    """Return a text as HTML in which what stands between backquotes is code, and words between asterisks stand out."""
    return Markup(_CODE_OR_WORDS.sub(
        lambda found: f'<code>{found[1]}</code>' if found[1] else f'<em>{found[2]}</em>',
        html.escape(text, quote=False)))


def table(columns: Sequence[str], rows: Iterable[Row], *, css_class: str = '', caption: str = '',
          row_headers: bool = False) -> str:
    """Return a table.

    :param columns: The heading of each column.
    :param css_class: The class of the table, for its style sheet.
    :param row_headers: True if the first cell of a row says what the row is about.
    """
    first = '<th scope="row">' if row_headers else ''
    body = ''.join(_row(row, first) for row in rows)
    # One with headings has a body even before its first row: a page may add rows to it.
    return _table(columns, f'<tbody>{body}</tbody>' if columns or body else '', css_class, caption)


def grouped_table(columns: Iterable[str], groups: Mapping[str, Sequence[Row]], *, css_class: str = '',
                  caption: str = '') -> str:
    """Return a table whose rows stand in groups, with a heading for each group in the first column.

    :param columns: The heading of each column, the first one's too.
    :param groups: For each heading its rows, at least one; they fill the columns from the second on.
    :param css_class: As for ``table``.
    """
    bodies = []
    for heading, (first, *others) in groups.items():
        head = f'<th scope="rowgroup" rowspan="{1 + len(others)}">'
        bodies.append(f'<tbody>{_row((heading, *first), head)}{"".join(map(_row, others))}</tbody>')
    return _table(columns, ''.join(bodies), css_class, caption)


def _table(columns: Iterable[str], bodies: str, css_class: str, caption: str) -> str:
    headings = ''.join(f'<th scope="col">{_cell(heading)}</th>' for heading in columns)
    attribute = f' class="{css_class}"' if css_class else ''
    return (f'<table{attribute}>'
            + (f'<caption>{_cell(caption)}</caption>' if caption else '')
            + (f'<thead><tr>{headings}</tr></thead>' if headings else '')
            + f'{bodies}</table>')


def _row(cells: Row, first: str = '') -> str:
    """Return a row.

    :param first: The tag that opens its first cell, if that is a heading.
    """
    heading, cells = (f'{first}{_cell(cells[0])}</th>', cells[1:]) if first else ('', cells)
    return f'<tr>{heading}{"".join(f"<td>{_cell(cell)}</td>" for cell in cells)}</tr>'


def _cell(text: str) -> str:
    return text if isinstance(text, Markup) else html.escape(text)
