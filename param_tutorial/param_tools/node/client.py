"""Talk to the parameters of one node: list, get, set, describe, delete, dump and load.

The verbs and their names are rclpy's (AsyncParameterClient), but every call waits for its answer, with a
time limit, and every failure says which node, which parameter, which value and why. How an answer travels
is in ``services``; what a file looks like is in ``parameter_files``.
"""

import re
from collections.abc import Awaitable, Callable, Coroutine, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

from rcl_interfaces import srv
from rcl_interfaces.msg import Parameter, ParameterDescriptor, ParameterEvent
from rclpy.node import Node

from param_tools import values
from param_tools.descriptor import Descriptor, Descriptors, Range
from param_tools.errors import InvalidValueError, ParameterNotDeclaredError, ParameterRejectedError, nearest
from param_tools.files import parameter_files
from param_tools.ros import stage
from param_tools.ros.executor import BackgroundExecutor
from param_tools.ros.services import TIMEOUT_SEC, full_name
from param_tools.values import ParameterType

T = TypeVar('T')

# How often all is asked if parameters are deleted between two questions.
_ATTEMPTS = 4

# What rclpy (and, after the bar, rclcpp) say when they reject, before any callback of the node is asked.
_KINDS = (
    ('undeclared', r'^Invalid access to undeclared parameter|cannot be set because it was not declared$'),
    ('read only', r'^Trying to set a read-only parameter|cannot be set because it is read-only$'),
    ('wrong type', r'^Wrong parameter type, '),
    ('off the step', r'^The parameter value for .* is not (close enough to )?a valid step'),
    ('out of range', r"^Parameter .* out of range\.? Min: |^Parameter \{.*\} doesn't comply with .* range"),
    ('not deletable', r'^Static parameter cannot be undeclared'),
)


@dataclass(frozen=True)
class SetResult:
    """What became of one parameter that a node was asked to set."""

    node: str
    name: str
    value: Any
    successful: bool
    reason: str = ''
    """The node's own words; empty if it accepted."""
    hint: str = ''
    """What the node could have said and did not, e.g. the likeliest name."""

    @property
    def kind(self) -> str:
        """'accepted', or why not: 'undeclared', 'read only', 'wrong type', 'off the step', 'out of range',
        'not deletable', or 'rejected by the node' for everything that the node's own callback decided."""
        if self.successful:
            return 'accepted'
        return next((kind for kind, pattern in _KINDS if re.search(pattern, self.reason)), 'rejected by the node')

    def raise_for_reason(self) -> 'SetResult':
        """Raise ParameterRejectedError if the node rejected, else return the result itself."""
        if not self.successful:
            raise ParameterRejectedError(self)
        return self

    def __str__(self) -> str:
        asked = f'{self.name} = {values.format_value(self.value)}'
        if self.successful:
            return f'{self.node} accepted {asked}'
        return f'{self.node} rejected {asked} ({self.kind}): {self.reason}{self.hint}'

    __repr__ = __str__


class SetResults(list[SetResult]):
    """One SetResult for each parameter, in the order of the request."""

    @property
    def successful(self) -> bool:
        """True if all were accepted."""
        return all(result.successful for result in self)

    def raise_for_reason(self) -> 'SetResults':
        """Raise ParameterRejectedError for the first rejected one, if any, else return the results themselves."""
        for result in self:
            result.raise_for_reason()
        return self

    def __repr__(self) -> str:
        return '\n'.join(map(str, self)) or '(nothing was set)'


class ParameterValues(dict[str, Any]):
    """Parameter names and their values; shown one to a line."""

    def __repr__(self) -> str:
        width = max(map(len, self), default=0)
        return '\n'.join(f'{name:{width}}  {values.format_value(value)}'
                         for name, value in self.items()) or '(no parameters)'


def descriptor_of(name: str, message: ParameterDescriptor) -> Descriptor:
    """Return what a rcl_interfaces/msg/ParameterDescriptor says.

    :param name: The parameter's. In the message it is empty if the parameter was set without being declared.
    """
    # A range of the other kind than the value can be declared; rclpy never looks at it.
    ranges = {values.INTEGER: message.integer_range, values.DOUBLE: message.floating_point_range}.get(
        values.TYPES[message.type])
    limits = None
    if ranges:
        low, high = sorted((ranges[0].from_value, ranges[0].to_value))  # rclpy takes them in either order
        limits = Range(low, high, ranges[0].step)
    return Descriptor(message.name or name, values.TYPES[message.type], message.description,
                      message.additional_constraints, message.read_only, message.dynamic_typing, limits)


def node_name(node: 'str | Node | ParameterClient') -> str:
    """Return the fully qualified name of a node, given in any of the ways in which our tools take one.

    :raises TypeError: it is none of these.
    """
    return node.node if isinstance(node, ParameterClient) else full_name(node)


class Questions:
    """What a node has, as coroutines: the client finishes them at once, and a panel awaits them in the executor."""

    def __init__(self, node: str, ask: Callable[[str, Any], Awaitable[Any]]):
        """
        :param node: Fully qualified name.
        :param ask: Called with the name of one of the node's services and a request; returns the response.
        """
        self._node, self._ask = node, ask

    async def list_parameters(self, prefixes: Iterable[str] = (), *, depth: int = 0) -> list[str]:
        """Return the names of the node's parameters; see ParameterClient for this and the others."""
        request = srv.ListParameters.Request(prefixes=_listed(prefixes, 'prefixes'), depth=depth)
        return list((await self._ask('list_parameters', request)).result.names)

    async def get_parameters(self, names: Iterable[str] | None = None) -> ParameterValues:
        """Return the values of several parameters, or of all."""
        wanted = await self.list_parameters() if names is None else _listed(names)
        answer = (await self._ask('get_parameters', srv.GetParameters.Request(names=wanted))).values
        if len(answer) == len(wanted):
            return ParameterValues(zip(wanted, map(values.to_python, answer), strict=True))
        # One name without a value empties the whole answer of an rclpy node: ask for each alone.
        existing = await self.list_parameters()
        result = ParameterValues()
        for name in wanted:
            answer = (await self._ask('get_parameters', srv.GetParameters.Request(names=[name]))).values
            if answer:
                result[name] = values.to_python(answer[0])
            elif name in existing:
                result[name] = None
            elif names is not None:
                raise ParameterNotDeclaredError(self._node, name, existing)
        return result

    async def get_parameter_types(self, names: Iterable[str]) -> dict[str, ParameterType]:
        """Return the types of parameters."""
        names = _listed(names)
        answer = (await self._ask('get_parameter_types', srv.GetParameterTypes.Request(names=names))).types
        await self._require_all(names, answer)
        return {name: values.TYPES[number] for name, number in zip(names, answer, strict=True)}

    async def describe_parameters(self, names: Iterable[str] | None = None) -> Descriptors:
        """Return type, range, description and more of several parameters, or of all."""
        wanted = await self.list_parameters() if names is None else _listed(names)
        answer = (await self._ask('describe_parameters', srv.DescribeParameters.Request(names=wanted))).descriptors
        await self._require_all(wanted, answer)
        return Descriptors(zip(wanted, map(descriptor_of, wanted, answer), strict=True))

    async def describe_and_get(self, names: Iterable[str] | None = None) -> tuple[Descriptors, ParameterValues]:
        """Return descriptors and values of the same parameters, though some may be deleted meanwhile."""
        only = None if names is None else _listed(names)
        for attempts_left in reversed(range(_ATTEMPTS)):
            existing = await self.list_parameters()
            wanted = existing if only is None else [name for name in only if name in existing]
            try:
                return await self.describe_parameters(wanted), await self.get_parameters(wanted)
            except ParameterNotDeclaredError:
                if not attempts_left:
                    raise
        raise AssertionError('the last attempt returns or raises')

    async def _require_all(self, names: Sequence[str], answer: Sequence[object]) -> None:
        """Name the unknown one among names: with one unknown name the whole answer of a node is empty."""
        if len(answer) == len(names):
            return
        existing = await self.list_parameters()
        unknown = next((name for name in names if name not in existing), names[0])
        raise ParameterNotDeclaredError(self._node, unknown, existing)


def _finish(coroutine: Coroutine[Any, Any, T]) -> T:
    """Return what a coroutine returns that never has to wait."""
    try:
        coroutine.send(None)
    except StopIteration as end:
        result: T = end.value
        return result
    raise AssertionError('the coroutine waits for something')


class ParameterClient:
    """The parameters of one node, wherever it runs. Cheap to make; there is nothing to close.

    >>> client = ParameterClient('/simple_param_node')          # doctest: +SKIP
    >>> client.set_parameter('max_speed_rpm', 150)              # doctest: +SKIP
    /simple_param_node accepted max_speed_rpm = 150
    """

    def __init__(self, node: str | Node, *, timeout_sec: float = TIMEOUT_SEC,
                 executor: BackgroundExecutor | None = None):
        """
        :param node: The node, or its name; ``talker`` is ``/talker``.
        :param timeout_sec: How long the node may take for each answer.
        :param executor: Carries the calls; by default whichever runs in the background at each call.
        """
        self.node = full_name(node)
        self.timeout_sec = timeout_sec
        self._executor = executor
        self._questions = Questions(self.node, self._answer)

    def __repr__(self) -> str:
        return f'<ParameterClient: {self.node}>'

    # All the methods below raise the errors of Services.call as well as those that they name.

    def list_parameters(self, prefixes: Iterable[str] = (), *, depth: int = 0) -> list[str]:
        """Return the names of the node's parameters, in the order in which it declared them.

        :param prefixes: Only names that start with one of these and a dot.
        :param depth: Only names with at most this many parts below the prefix; 0 for all.
        """
        return _finish(self._questions.list_parameters(prefixes, depth=depth))

    def get_parameter(self, name: str) -> Any:
        """Return the value of one parameter; None if it is declared without a value.

        :raises ParameterNotDeclaredError: the node has no parameter of that name.
        """
        return self.get_parameters([name])[name]

    def get_parameters(self, names: Iterable[str] | None = None) -> ParameterValues:
        """Return the values of several parameters, or of all.

        :param names: Which; by default all, in the order in which the node declared them.
        :raises ParameterNotDeclaredError: the node has no parameter of one of these names.
        """
        return _finish(self._questions.get_parameters(names))

    def get_parameter_types(self, names: Iterable[str]) -> dict[str, ParameterType]:
        """Return the types of parameters.

        :raises ParameterNotDeclaredError: the node has no parameter of one of these names.
        """
        return _finish(self._questions.get_parameter_types(names))

    def describe_parameter(self, name: str) -> Descriptor:
        """Return type, range, description and more of one parameter.

        :raises ParameterNotDeclaredError: the node has no parameter of that name.
        """
        return self.describe_parameters([name])[name]

    def describe_parameters(self, names: Iterable[str] | None = None) -> Descriptors:
        """Return type, range, description and more of several parameters, or of all.

        :raises ParameterNotDeclaredError: the node has no parameter of one of these names.
        """
        return _finish(self._questions.describe_parameters(names))

    def describe_and_get(self, names: Iterable[str] | None = None) -> tuple[Descriptors, ParameterValues]:
        """Return descriptors and values of the same parameters, though some may be deleted meanwhile.

        :param names: Only those of these that there are, in this order; by default all.
        :raises ParameterNotDeclaredError: each time that the node was asked, one was deleted between two questions.
        """
        return _finish(self._questions.describe_and_get(names))

    def set_parameter(self, name: str, value: Any) -> SetResult:
        """Ask the node to set one parameter. A rejection is a result, not an exception.

        ROS converts nothing: 3 is an integer and will be rejected by a double, which wants 3.0.

        :raises InvalidValueError: no parameter can hold this value.
        """
        return self.set_parameters({name: value})[0]

    def set_parameters(self, new: Mapping[str, Any]) -> SetResults:
        """Ask the node to set several parameters, each for itself: some may be rejected and others not.

        :raises InvalidValueError: no parameter can hold one of the values; then nothing was sent.
        """
        request = srv.SetParameters.Request(parameters=self._to_messages(new))
        answer = self._call('set_parameters', request).results
        return SetResults(self._result(name, new[name], each) for name, each in zip(new, answer, strict=True))

    def set_parameters_atomically(self, new: Mapping[str, Any]) -> SetResults:
        """Ask the node to set several parameters together: all are stored, or none.

        :return: One result for each parameter; where the node rejected, all carry its one reason.
        :raises InvalidValueError: no parameter can hold one of the values; then nothing was sent.
        """
        request = srv.SetParametersAtomically.Request(parameters=self._to_messages(new))
        answer = self._call('set_parameters_atomically', request).result
        return SetResults(self._result(name, value, answer) for name, value in new.items())

    def delete_parameter(self, name: str) -> SetResult:
        """Ask the node to undeclare a parameter, which only one with dynamic typing allows: "not set" deletes it."""
        return self.set_parameter(name, None)

    def dump(self, path: str | Path | None = None) -> parameter_files.Dump:
        """Write the node's parameters as a parameter file that ``--params-file`` and ``load`` read back.

        :param path: Where to write it; by default nowhere. An existing file is replaced as a whole, or not at all.
        :return: The text, and which parameters no file can hold (``left_out``), with the reason.
        :raises OSError: the file cannot be written.
        """
        dump = parameter_files.render(self.node, self.get_parameters())
        if path is not None:
            dump.save(path)
        return dump

    def load(self, path: str | Path, *, atomically: bool = False) -> SetResults:
        """Set the parameters that a file holds for this node, read with the rules of rcl's own parser.

        Read-only parameters that have the file's value already are passed over: every dump holds some.

        :param atomically: All or none.
        :raises ParameterFileError: the file cannot be read, or holds nothing for this node; nothing was set.
        """
        new = parameter_files.read(path, self.node)
        existing = set(self.list_parameters())
        known = [name for name in new if name in existing]
        present, descriptors = self.get_parameters(known), self.describe_parameters(known)
        new = {name: value for name, value in new.items()
               if not (name in existing and descriptors[name].read_only and values.same(present[name], value))}
        return self.set_parameters_atomically(new) if atomically else self.set_parameters(new)

    # ---------------------------------------------------------------------------------------------------

    @property
    def executor(self) -> BackgroundExecutor:
        """What carries the calls."""
        return self._executor or stage.current()

    def _call(self, service: str, request: Any) -> Any:
        return self.executor.services.call(self.node, service, request, timeout_sec=self.timeout_sec)

    async def _answer(self, service: str, request: Any) -> Any:
        return self._call(service, request)

    def _to_messages(self, new: Mapping[str, Any]) -> list[Parameter]:
        new = {name: values.normalize(value) for name, value in new.items()}
        # An empty list has no type of its own: it gets the one that the node's parameter has.
        empty = [name for name, value in new.items() if values.is_empty_array(value)]
        types = {name: each.type for name, each in self.describe_parameters(empty).items()} if empty else {}
        messages = []
        for name, value in new.items():
            if not isinstance(name, str) or not name:
                raise InvalidValueError(f'{name!r} is not a parameter name: it must be a string that is not empty')
            try:
                messages.append(to_message(name, value, types.get(name)))
            except InvalidValueError as error:
                raise InvalidValueError(f'cannot set {name} of {self.node}: {error}') from None
        return messages

    def _result(self, name: str, value: Any, message: Any) -> SetResult:
        result = SetResult(self.node, name, value, message.successful, message.reason)
        if result.kind != 'undeclared':
            return result
        existing = self.list_parameters()
        if name in existing:  # set atomically, together with another one that is unknown
            return result
        return SetResult(self.node, name, value, False, message.reason,
                         nearest(name, existing, 'It has no parameters at all'))


def _listed(names: Iterable[str], what: str = 'names') -> list[str]:
    """Return names as a list.

    :raises TypeError: they are none, or a single one, which Python would take for a list of its letters.
    """
    if isinstance(names, Iterable) and not isinstance(names, str):
        listed = list(names)
        if all(isinstance(name, str) for name in listed):
            return listed
    raise TypeError(f'{names!r} is not a list of {what}; a list with one of them is ["gain"]')


def to_message(name: str, value: Any, parameter_type: ParameterType | None = None) -> Parameter:
    """Return a rcl_interfaces/msg/Parameter.

    :param value: As ``values.normalize`` gives it.
    :param parameter_type: The type of an array that is empty; any other value tells its own.
    :raises InvalidValueError: the value cannot be a parameter.
    """
    if parameter_type is None or not (values.is_empty_array(value) and parameter_type.is_array):
        parameter_type = values.type_of(value)
    # A ParameterValue that is passed to the constructor costs a second one: it makes its default anyway.
    message = Parameter(name=name)
    message.value.type = parameter_type.number
    if parameter_type.field:
        setattr(message.value, parameter_type.field, value)
    return message


def changes(event: ParameterEvent) -> ParameterValues:
    """Return the values that a message on /parameter_events tells of: new and changed; None for deleted."""
    return ParameterValues(
        [(each.name, values.to_python(each.value)) for each in [*event.new_parameters, *event.changed_parameters]]
        + [(each.name, None) for each in event.deleted_parameters])
