"""CopiesView: how far a new value gets in a node that copied a parameter, and in one that reads it."""

from typing import Any

from param_tools.node.client import ParameterClient
from param_tools.ros.waiting import wait_until
from param_tutorial.views.base import PictureView
from param_tutorial.views.drawing.trail import Moment, Move, draw_trail


class CopiesView(PictureView):
    """A parameter, its copy, and what two nodes do with them. Show it as the last line of a cell."""

    def __init__(self, copies: Any, reads: Any, name: str, used: str) -> None:
        """
        :param copies: A node that has copied the parameter into an attribute of the same name.
        :param reads: A node that reads the parameter each time.
        :param name: The parameter of both.
        :param used: The attribute of both with the value that they use, which a timer keeps up to date.
        """
        self._nodes, self._name, self._used = (copies, reads), name, used
        first, second = (f'/{node.get_name()}' for node in self._nodes)
        self._copied = [Move(f'{first} variable', f'{first} {used}'), Move(f'{second} parameter', f'{second} {used}')]
        self._set = [Move('', f'{first} parameter'), Move('', f'{second} parameter')]
        self._places = [f'{first} parameter', f'{first} variable', f'{first} {used}', f'{second} parameter',
                        f'{second} {used}']
        self._moments = [Moment('so far', '', self._values(), self._copied)]
        super().__init__(draw_trail(name, self._places, self._moments))

    def set_parameter(self, value: Any) -> None:
        """Set the parameter of both nodes, wait until the second uses the value, and add what there is then."""
        for node in self._nodes:
            ParameterClient(node).set_parameter(self._name, value).raise_for_reason()
        reads = self._nodes[1]
        wait_until(lambda: getattr(reads, self._used) == value, f'/{reads.get_name()} to use {value}')
        self._moments.append(Moment(f'set to {value}', 'the copy is stale', self._values(), self._set + self._copied))
        self._replace(draw_trail(self._name, self._places, self._moments))

    def _values(self) -> dict[str, str]:
        """Return what each place holds now."""
        copies, reads = self._nodes
        now = (copies.get_parameter(self._name).value, getattr(copies, self._name), getattr(copies, self._used),
               reads.get_parameter(self._name).value, getattr(reads, self._used))
        return dict(zip(self._places, map(str, now), strict=True))
