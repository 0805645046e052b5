"""Tables about parameters: one record in a row, as text in a terminal and as HTML in a notebook.

A node is a system of one: the same table is about one node, and has a column for the nodes' names if there are more.
"""

from collections.abc import Iterable, Iterator, Mapping
from itertools import chain
from typing import Generic, Protocol, TypeVar

from param_tools.markup.styles import style
from param_tools.markup.tables import Row, grouped_table, table

_STYLE = style('param_tools/systems/sets.css')


class Record(Protocol):
    """What is to be said about one parameter."""

    @property
    def name(self) -> str:
        """The name of the parameter."""


R = TypeVar('R', bound=Record)


class WordTable(Generic[R]):
    """Records, and the words that stand for each in a row of a table."""

    heading = ''
    columns: tuple[str, ...] = ()

    def __init__(self, records: Iterable[R]):
        self.records = tuple(records)

    def __iter__(self) -> Iterator[R]:
        return iter(self.records)

    def __len__(self) -> int:
        return len(self.records)

    def __getitem__(self, name: str) -> R:
        """Return the first record of a parameter.

        :raises KeyError: there is nothing to say about it.
        """
        for record in self.records:
            if record.name == name:
                return record
        raise KeyError(name)

    def words(self, record: R) -> tuple[str, ...]:
        """Return the row of a record."""
        raise NotImplementedError

    def rows(self) -> list[tuple[str, ...]]:
        """Return the words of each row."""
        return list(map(self.words, self.records))

    def __repr__(self) -> str:
        # A node's reason may have several lines, and a row has one.
        rows = [[' '.join(word.splitlines()) for word in row] for row in self.rows()]
        if not rows:
            return self.heading
        widths = [max(map(len, column)) for column in zip(self.columns, *rows)]
        lines = ['  '.join(f'{word:{width}}' for word, width in zip(row, widths)).rstrip()
                 for row in (self.columns, *rows)]
        return '\n'.join([self.heading, '', *lines])

    def _repr_html_(self) -> str:
        rows = self.rows()
        return _STYLE + table(self.columns if rows else (), rows, css_class='param-set', caption=self.heading,
                              row_headers=True)


class NodesTable(WordTable[R]):
    """Records of one node, or of the nodes of a system: then the first column names the node."""

    def __init__(self, nodes: Mapping[str, Iterable[R]], *, is_of_one: bool):
        """:param is_of_one: True if the table is about one node, which needs no column for its name."""
        self.nodes = {node: tuple(records) for node, records in nodes.items()}
        super().__init__(chain.from_iterable(self.nodes.values()))
        self.is_of_one = is_of_one
        if not is_of_one:
            self.columns = ('node', *self.columns)

    def rows(self) -> list[tuple[str, ...]]:
        if self.is_of_one:
            return super().rows()
        return [(node, *self.words(record)) for node, records in self.nodes.items() for record in records]

    def _repr_html_(self) -> str:
        if self.is_of_one:
            return super()._repr_html_()
        groups: dict[str, list[Row]] = {}
        for node, *words in self.rows():
            groups.setdefault(node, []).append(words)
        return _STYLE + grouped_table(self.columns if groups else (), groups, css_class='param-set',
                                      caption=self.heading)
