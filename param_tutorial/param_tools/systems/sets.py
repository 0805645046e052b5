"""Sets of parameters: names and values at one moment, of a node, of a file, or the defaults of a class of nodes.

Values are compared as ROS stores them: 1, 1.0 and True are three different ones, nan is equal to nan. All goes over
the standard services (see ``node.client``), so a node may be anywhere and written in any language.
"""

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from rclpy.node import Node

from param_tools import values
from param_tools.errors import InvalidValueError
from param_tools.files import parameter_files
from param_tools.markup.wording import format_count
from param_tools.node.client import ParameterClient
from param_tools.ros import stage

NodeLike = str | Node | ParameterClient

# Where a node for its defaults lives for a moment: another of the same name may be on the stage.
_CORNER = '/_defaults'


class ParameterSet(Mapping[str, Any]):
    """The parameters of a node at one moment, or of a file: names and values, which do not change any more."""

    def __init__(self, parameters: Mapping[str, Any], label: str = 'a set'):
        """
        :param parameters: Names and values; None for a parameter without a value.
        :param label: Says where they come from.
        :raises InvalidValueError: a name or a value can be none of a parameter.
        """
        self._parameters = {name: values.normalize(value) for name, value in parameters.items()}
        for name, value in self._parameters.items():
            if not isinstance(name, str) or not name:
                raise InvalidValueError(f'{label}: {name!r} is not a parameter name')
            try:
                values.type_of(value)
            except InvalidValueError as error:
                raise InvalidValueError(f'{label}: {name} cannot be a parameter: {error}') from None
        self.label = label

    @classmethod
    def of(cls, node: NodeLike, label: str = '') -> 'ParameterSet':
        """Take a snapshot of a node.

        :param label: By default the node's name.
        :raises ParameterToolError: as ParameterClient.get_parameters.
        """
        client = as_client(node)
        return cls(client.get_parameters(), label or client.node)

    @classmethod
    def from_file(cls, path: str | Path, node: NodeLike) -> 'ParameterSet':
        """Read what a parameter file holds for a node, by the rules of rcl's parser.

        :raises ParameterFileError: it cannot be read, or holds nothing for the node.
        """
        return cls(parameter_files.read(path, as_client(node).node), Path(path).name)

    @classmethod
    def defaults(cls, node_class: type[Node], *args: Any, **kwargs: Any) -> 'ParameterSet':
        """Find out what a node starts with when nobody overrides anything.

        No service tells it, so a fresh node is made for a moment, in a hidden namespace, and asked.

        :param node_class: Further arguments go to its constructor. What that does beside declaring is done, too.
        :raises ExecutorError: no executor is running in the background.
        """
        ros = stage.current()
        node = ros.add(node_class, *args, ros_args=['-r', f'__ns:={_CORNER}'], **kwargs)
        try:
            return cls(ParameterClient(node, executor=ros).get_parameters(), f'defaults of {node_class.__name__}')
        finally:
            ros.remove(node)

    def __getitem__(self, name: str) -> Any:
        value = self._parameters[name]
        return list(value) if isinstance(value, list) else value

    def __iter__(self) -> Iterator[str]:
        return iter(self._parameters)

    def __len__(self) -> int:
        return len(self._parameters)

    def __eq__(self, other: object) -> bool:
        """True if all names and values are the same, with their types."""
        return isinstance(other, Mapping) and self.keys() == other.keys() and all(
            values.same(value, values.normalize(other[name])) for name, value in self._parameters.items())

    __hash__ = None  # type: ignore[assignment]  # every object has one, says object; a list in it could not be hashed

    def __repr__(self) -> str:
        return f'<ParameterSet: {self.label}, {format_count(len(self), "parameter")}>'


def as_client(node: NodeLike) -> ParameterClient:
    """Return a client of a node."""
    return node if isinstance(node, ParameterClient) else ParameterClient(node)


def as_set(what: Mapping[str, Any] | NodeLike, label: str) -> ParameterSet:
    """Return a set of parameters as such; ask a node for its own.

    :param label: Of a mapping that has none.
    """
    if isinstance(what, ParameterSet):
        return what
    return ParameterSet(what, label) if isinstance(what, Mapping) else ParameterSet.of(what)
