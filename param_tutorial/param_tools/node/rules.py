"""Rules for parameters beyond type and range: patterns, choices, lengths, and rules across several.

Declare first, then state the rules:

    Rules(self).matches('serial', r'[A-Z]{2}[0-9]{4}').check(
        ['low_c', 'high_c'], lambda low, high: low < high, 'low_c must be below high_c')

A rule is judged twice. When it is stated, it is judged on the values that the node has by then, defaults or overrides:
a node that is started with bad values does not start. Later an on-set callback judges it on the values as they would
be after the whole change. The rule is also written into the parameters' ``additional_constraints``, where ``ros2 param
describe`` and panels show it.
"""

import ast
import contextlib
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from rcl_interfaces.msg import SetParametersResult
from rclpy.exceptions import InvalidParameterValueException
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools import values
from param_tools.errors import InvalidValueError, ParameterNotDeclaredError, RuleError
from param_tools.ros import rclpy_private

_TEXTS = (values.STRING, values.STRING_ARRAY)
_ARRAYS = tuple(each for each in values.TYPES if each.is_array)
# How much of a value a reason repeats.
_LETTERS = 60
# The words of two rules, which ``text.choices_of`` and ``locks.conditions_of`` find in a descriptor.
ONE_OF = 'must be one of '
ONLY_WHILE, IS = 'can change only while ', ' is '
# What stands between two rules in a descriptor.
_BETWEEN = '; '


def read_values(words: str) -> list[Any]:
    """Return the values, separated by commas, with which the rest of a rule in a descriptor begins.

    :return: Empty if the text does not begin with values.
    """
    # Other rules may follow, and a value may hold what stands between two of them.
    parts = words.split(_BETWEEN)
    for end in range(1, len(parts) + 1):
        with contextlib.suppress(ValueError, SyntaxError):
            return list(ast.literal_eval(f'[{_BETWEEN.join(parts[:end])}]'))
    return []


@dataclass(frozen=True)
class Rule:
    """A condition for the values of one or several parameters."""

    names: tuple[str, ...]
    sentence: str
    """The condition in words, e.g. 'must match [A-Z]{2}', for the person who broke it."""
    holds: Callable[..., Any]
    """Called with one value for each name; returns True or False."""

    def __str__(self) -> str:
        return f'{", ".join(self.names)}: {self.sentence}'

    def judge(self, known: Mapping[str, Any]) -> str:
        """Return how these values break the rule, in words; empty if they don't, or if one of them is not set.

        :param known: The values by name. The rule gets copies, so it cannot change them.
        :raises RuleError: the rule raised an exception, or returned neither True nor False.
        """
        present = [values.normalize(known.get(name)) for name in self.names]
        if any(value is None for value in present):
            return ''
        shown = ', '.join(f'{name} = {values.format_value(value, _LETTERS)}'
                          for name, value in zip(self.names, present))
        try:
            held = self.holds(*present)
            if held is None:
                raise TypeError('it returned None; a rule has to return True or False')
            broken = not held
        except Exception as error:
            # An exception that left the callback would end the node's executor.
            raise RuleError(f'{shown}: the rule "{self.sentence}" could not be judged: '
                            f'{type(error).__name__}: {error}') from error
        return f'{shown}: {self.sentence}' if broken else ''


class Rules:
    """The rules of one node. Every method that states a rule returns the object itself, so calls can be chained.

    These methods all raise:

    - ParameterNotDeclaredError: the node has not declared a parameter of that name (yet);
    - RuleError: the rule makes no sense for the parameter's type, or raises an exception for its present value;
    - rclpy's InvalidParameterValueException: the present value, a default or an override, breaks the rule.
    """

    def __init__(self, node: Node):
        """Register an on-set callback. If a node has several Rules, or other callbacks, rclpy asks them all.

        :raises RuleError: ``node`` is not a node.
        """
        if not isinstance(node, Node):
            raise RuleError(f'Rules takes the node whose parameters they are for, usually self, not {node!r}')
        self._node = node
        self._rules: list[Rule] = []
        node.add_on_set_parameters_callback(self._validate)

    def __repr__(self) -> str:
        return '\n'.join(map(str, self._rules)) or '(no rules)'

    def matches(self, name: str, pattern: str | re.Pattern[str]) -> 'Rules':
        """State that a text, or each text of an array, matches a regular expression from end to end.

        Python's matcher has no time limit: a pattern such as ``(a+)+b`` can keep the node busy for hours.
        """
        try:
            compiled = re.compile(pattern)
            compiled.fullmatch('')  # a pattern of bytes rejects texts
        except (re.error, TypeError) as error:
            raise _nonsense(name, f'{pattern!r} is not a regular expression: {error}') from None
        return self._state_for_each(name, f'must match {compiled.pattern}', compiled.fullmatch, _TEXTS, 'texts')

    def one_of(self, name: str, choices: Iterable[Any]) -> 'Rules':
        """State that a value, or each element of an array, is one of several, of the same type."""
        listed = [values.normalize(choice) for choice in _listed(choices)]
        if not listed:
            raise _nonsense(name, f'give a list of at least one choice, not {choices!r}')
        wanted = self._type_of(name)
        for choice in listed:
            if objection := _never(choice, wanted, or_element=True):
                raise _nonsense(name, objection)
        return self._state_for_each(name, f'{ONE_OF}{", ".join(map(repr, listed))}',
                                    lambda value: any(values.same(value, choice) for choice in listed))

    def length(self, name: str, at_least: int, at_most: int | None = None) -> 'Rules':
        """State how many elements an array has, or how many characters a text.

        :param at_most: By default ``at_least``: exactly that many.
        """
        last = at_least if at_most is None else at_most
        if not all(type(count) is int for count in (at_least, last)) or not 0 <= at_least <= last:
            raise _nonsense(name, f'nothing has a length of {at_least!r} to {last!r}')
        kind = self._require_type(name, (*_ARRAYS, values.STRING), 'arrays and texts')
        counted = 'characters' if kind is values.STRING else 'elements'
        count = f'{at_least}' if at_least == last else f'{at_least} to {last}'
        return self._state(Rule((name,), f'must have {count} {counted}',
                                lambda value: at_least <= len(value) <= last))

    def only_while(self, names: str | Iterable[str], other: str, value: Any) -> 'Rules':
        """State that parameters can change only while another one has a value, and are locked until then.

        The other parameter is a mode, or a state that the node reports as a parameter. ``locks`` and panels recognize
        the rule by its words in the descriptor. A request that changes both at once is judged by the new value of the
        other parameter.
        """
        expected = values.normalize(value)
        if objection := _never(expected, self._type_of(other)):
            raise RuleError(f'cannot state a rule about {other}: {objection}')
        listed = [names] if isinstance(names, str) else _listed(names)
        if not listed or other in listed:
            raise RuleError(f'a rule about {other} takes the names of other parameters, not {names!r}')
        for name in listed:
            def holds(new: Any, state: Any, name: str = name) -> bool:
                return values.same(state, expected) or values.same(new, values.normalize(self._stored(name)))

            self._state(Rule((name, other), f'{ONLY_WHILE}{other}{IS}{expected!r}', holds), told=(name,))
        return self

    def check(self, names: str | Iterable[str], holds: Callable[..., Any], sentence: str) -> 'Rules':
        """State a rule of your own for one parameter, or across several.

        :param names: The parameters; the rule is judged whenever one of them is to change.
        :param holds: Called with their values in this order; returns whether they go together. It must change
            nothing: another callback may still reject the change.
        :param sentence: The rule in words, for the person who broke it.
        """
        listed = (names,) if isinstance(names, str) else tuple(_listed(names))
        if not listed or not callable(holds) or not isinstance(sentence, str) or not sentence.strip():
            raise RuleError(f'a rule takes names, a function and a sentence; got {names!r}, {holds!r}, {sentence!r}')
        return self._state(Rule(listed, sentence, holds))

    # ---------------------------------------------------------------------------------------------------

    def _type_of(self, name: str) -> values.ParameterType | None:
        """Return the type of a parameter; None if its type may change."""
        if not isinstance(name, str):
            raise RuleError(f'cannot state a rule for {name!r}, which is not a parameter name')
        if not self._node.has_parameter(name):
            raise ParameterNotDeclaredError(self._node.get_fully_qualified_name(), name,
                                            list(self._node.list_parameters([], 0).names))
        descriptor = self._node.describe_parameter(name)
        return None if descriptor.dynamic_typing else values.TYPES[descriptor.type]

    def _require_type(self, name: str, types: Iterable[values.ParameterType], words: str
                      ) -> values.ParameterType | None:
        found = self._type_of(name)
        if found is not None and found not in types:
            raise _nonsense(name, f'it is for {words}, and {name} is of type {found.label}')
        return found

    def _state_for_each(self, name: str, sentence: str, holds: Callable[[Any], Any],
                        types: Iterable[values.ParameterType] = values.TYPES, words: str = '') -> 'Rules':
        """State a rule for a value, or for each element of an array."""
        kind = self._require_type(name, types, words)
        if kind is not None and kind.is_array:
            sentence = f'each {sentence}'
        return self._state(Rule((name,), sentence, lambda value: all(
            map(holds, value)) if isinstance(value, list) else bool(holds(value))))

    def _state(self, rule: Rule, told: Iterable[str] = ()) -> 'Rules':
        """Add a rule, and write it into the descriptors of ``told``; by default of all parameters that it is about."""
        for name in rule.names:
            self._type_of(name)
        known = {name: self._stored(name) for name in rule.names}
        if reason := rule.judge(known):
            raise InvalidParameterValueException(rule.names[-1], known[rule.names[-1]], reason)
        self._rules.append(rule)
        # In a descriptor it begins like a sentence, unless it begins with the name of a parameter.
        words = rule.sentence
        if not words.startswith(rule.names):
            words = words[0].upper() + words[1:]
        for name in told or rule.names:
            descriptor = rclpy_private.own_descriptor(self._node, name)
            descriptor.additional_constraints = _BETWEEN.join(
                filter(None, (descriptor.additional_constraints, words)))
        return self

    def _stored(self, name: str) -> Any:
        return self._node.get_parameter_or(name).value

    def _validate(self, parameters: list[Parameter]) -> SetParametersResult:
        """Judge the values as they would be after the whole change; change nothing and raise nothing."""
        proposed = {parameter.name: parameter.value for parameter in parameters}
        reasons = []
        for rule in self._rules:
            if proposed.keys() & set(rule.names):
                known = {name: proposed[name] if name in proposed else self._stored(name) for name in rule.names}
                try:
                    reasons.append(rule.judge(known))
                except RuleError as error:
                    reasons.append(str(error))
        reason = '; '.join(filter(None, reasons))
        return SetParametersResult(successful=not reason, reason=reason)


def _nonsense(name: str, why: str) -> RuleError:
    return RuleError(f'cannot state a rule for {name}: {why}')


def _never(value: Any, wanted: values.ParameterType | None, *, or_element: bool = False) -> str:
    """Return why a parameter can never have a value, in words; empty if it can.

    :param wanted: The parameter's type; None if its type may change.
    :param or_element: True if the value may also be an element of an array.
    """
    try:
        found = values.type_of(value)
    except InvalidValueError as error:
        return str(error)
    if wanted in (None, found) or (or_element and wanted.name == f'{found.name}_ARRAY'):
        return ''
    return f'it is a parameter of type {wanted.label} and can never be {value!r}, of type {found.label}'


def _listed(things: Any) -> list[Any]:
    """Return several things as a list; an empty list for a text, or for what is no collection."""
    return list(things) if isinstance(things, Iterable) and not isinstance(things, (str, bytes)) else []
