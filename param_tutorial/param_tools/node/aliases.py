"""Several names for one parameter of an rclpy node: old names go on working, with a warning when they are set.

Before the first declaration:

    Aliases(self, {'max_speed': 'max_speed_rpm'})
    self.declare_parameter('max_speed_rpm', 100)

rclpy has no aliases, so an old name is a second parameter, a *mirror*, which is declared together with the new one. A
pre-set callback turns a change of one name into the same change of all of them, in one step. So set, get, list,
describe, events and dumps know the old name. Overrides are moved to the new name before it is declared.

rclpy sets two limits. Reading an old name gives no warning. And in set_parameters, where each parameter is a separate
change, two names with two values are two changes, and the later value stays; set atomically, they are rejected.
"""

import copy
import weakref
from collections.abc import Callable, Mapping

from rcl_interfaces.msg import SetParametersResult
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools import values
from param_tools.errors import AliasError
from param_tools.ros import rclpy_private

_nodes_with_aliases: 'weakref.WeakSet[Node]' = weakref.WeakSet()


class Aliases:
    """The old names of a node's parameters. A node has at most one such object, for all its old names."""

    def __init__(self, node: Node, names: Mapping[str, str], *,
                 pre_set: Callable[[list[Parameter]], list[Parameter]] | None = None):
        """Move the overrides of the old names to the new ones, and register one callback of each kind.

        :param node: Has not declared any of the names yet.
        :param names: The new name of each old name.
        :param pre_set: The node's own pre-set callback, if it has one. It sees new names only. It can't be registered
            beside this object: rclpy appends the answers of all pre-set callbacks, so every change would happen twice.
        :raises AliasError: an argument makes no sense, the node has Aliases already, a name is declared already, an old
            name stands for itself or for another old name, or overrides give two names of one parameter two values.
        """
        if not isinstance(node, Node) or not isinstance(names, Mapping) or not (pre_set is None or callable(pre_set)):
            raise AliasError(f'Aliases takes a node, usually self, a dictionary of old names and new ones, and as '
                             f'pre_set a function; got {node!r}, {names!r}, {pre_set!r}')
        self._node = node
        self._new_names = dict(names)
        self._pre_set = pre_set
        self._declaring = ''
        self._used: list[str] = []
        self._reject_nonsense()
        _nodes_with_aliases.add(node)
        self._move_overrides()
        node.add_pre_set_parameters_callback(self._forward)
        node.add_on_set_parameters_callback(self._validate)
        node.add_post_set_parameters_callback(self._declare_mirrors)

    def __repr__(self) -> str:
        return '\n'.join(f'{old} is an old name of {new}' for old, new in self._new_names.items()) or '(no aliases)'

    @property
    def used(self) -> list[str]:
        """The old names that somebody has set so far, by override or request. The others may be removed."""
        return list(self._used)

    def _reject_nonsense(self) -> None:
        full_name = self._node.get_fully_qualified_name()
        if self._node in _nodes_with_aliases:
            raise AliasError(f'{full_name} has Aliases already: name all of them in one object, since two pre-set '
                             f'callbacks would make every change twice')
        for old, new in self._new_names.items():
            if not all(isinstance(name, str) and name for name in (old, new)):
                raise AliasError(f'{old!r} cannot stand for {new!r}: both must be strings that are not empty')
            if old == new:
                raise AliasError(f'{old} cannot stand for itself')
            if new in self._new_names:
                raise AliasError(f'{old} cannot stand for {new}, which is an old name itself: name the newest one')
            for name in (old, new):
                if self._node.has_parameter(name):
                    raise AliasError(f'{full_name} has declared {name} already: create its Aliases before the first '
                                     f'declaration, and do not declare old names')

    def _move_overrides(self) -> None:
        overrides = rclpy_private.pending_overrides(self._node)
        for old, new in self._new_names.items():
            if old not in overrides:
                continue
            given = overrides.pop(old)
            if new in overrides and not _equal(overrides[new], given):
                raise AliasError(f'{old} and {new} are one parameter of {self._node.get_fully_qualified_name()}, and '
                                 f'at its start one was given {given.value!r} and the other {overrides[new].value!r}: '
                                 f'remove the one for {old}')
            overrides[new] = Parameter(new, given.type_, given.value)
            self._notice(old)

    def _notice(self, old: str) -> None:
        """Warn once for each old name."""
        if old not in self._used:
            self._used.append(old)
            self._node.get_logger().warning(f'{old} is deprecated: set {self._new_names[old]} instead')

    def _mirrors_of(self, name: str) -> list[str]:
        return [old for old, new in self._new_names.items() if new == name]

    # -- the callbacks ----------------------------------------------------------------------------------------

    def _forward(self, parameters: list[Parameter]) -> list[Parameter]:
        """Turn a change of one name of a parameter into the same change of all its names."""
        forwarded: list[Parameter] = []
        said: dict[str, Parameter] = {}
        for proposed in parameters:
            parameter = proposed
            if proposed.name in self._new_names:
                self._notice(proposed.name)
                parameter = Parameter(self._new_names[proposed.name], proposed.type_, proposed.value)
            if self._mirrors_of(parameter.name):
                if parameter.name in said:
                    if not _equal(said[parameter.name], parameter):
                        # A pre-set callback can't give a reason. _validate can, and rejects this change.
                        return parameters
                    continue
                said[parameter.name] = parameter
            forwarded.append(parameter)
        if self._pre_set is not None:
            forwarded = self._pre_set(forwarded)
        # The new name comes first, so that rclpy names it in a rejection.
        return [each for parameter in forwarded for each in (parameter, *(
            Parameter(old, parameter.type_, parameter.value) for old in self._mirrors_of(parameter.name)
            if self._node.has_parameter(old)))]

    def _validate(self, parameters: list[Parameter]) -> SetParametersResult:
        """Reject a change in which the names of one parameter have different values."""
        said: dict[str, Parameter] = {}
        names = [parameter.name for parameter in parameters]
        for parameter in parameters:
            new = self._new_names.get(parameter.name, parameter.name)
            if not self._mirrors_of(new):
                continue
            if parameter.name not in (new, self._declaring) and not self._node.has_parameter(parameter.name):
                return _rejected(f'{parameter.name} is an old name of {new}, which declares it: do not declare it')
            if not _equal(said.setdefault(new, parameter), parameter):
                return _rejected(f'{said[new].name} = {said[new].value!r} and {parameter.name} = {parameter.value!r} '
                                f'are one parameter: set {new} only')
            if names.count(parameter.name) > 1:
                return _rejected(f'{parameter.name} is there twice in one change. If the request named it once, the '
                                f'node has another pre-set callback: hand that to Aliases(..., pre_set=...)')
        return SetParametersResult(successful=True)

    def _declare_mirrors(self, parameters: list[Parameter]) -> None:
        """Declare the mirrors of a parameter that has just been declared."""
        for parameter in parameters:
            for old in self._mirrors_of(parameter.name):
                if not self._node.has_parameter(old) and self._node.has_parameter(parameter.name):
                    self._declare_mirror(old, parameter)

    def _declare_mirror(self, old: str, parameter: Parameter) -> None:
        # A copy, because rclpy writes name and type into the descriptor that it is given.
        descriptor = copy.deepcopy(self._node.describe_parameter(parameter.name))
        descriptor.description = f'Deprecated, use {parameter.name}. {descriptor.description}'.rstrip()
        # The type of a value is known, unless there is no value, or an empty array.
        of_type = Parameter.Type(descriptor.type)
        is_known = descriptor.dynamic_typing or Parameter.Type.from_parameter_value(parameter.value) == of_type
        self._declaring = old
        try:
            self._node.declare_parameter(old, parameter.value if is_known else of_type, descriptor)
        finally:
            self._declaring = ''


def _equal(left: Parameter, right: Parameter) -> bool:
    return left.type_ == right.type_ and values.same(values.normalize(left.value), values.normalize(right.value))


def _rejected(reason: str) -> SetParametersResult:
    return SetParametersResult(successful=False, reason=reason)
