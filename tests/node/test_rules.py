"""rules: what each kind accepts and rejects, on a real node; at its start, one by one and together."""

import pytest
from rcl_interfaces.msg import ParameterDescriptor
from rclpy.exceptions import InvalidParameterValueException
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools import Rules
from param_tools.errors import RuleError
from param_tutorial import ParameterClient


class Robot(Node):
    """One parameter of every kind that a rule can be for, and no rule."""

    def __init__(self):
        super().__init__('robot')
        self.declare_parameters('', [
            ('serial', 'AB1234'), ('tags', ['a1', 'b2']), ('mode', 'slow'), ('modes', ['slow']), ('level', 1),
            ('gains', [1.0, 0.1, 0.0]), ('low_c', 18), ('high_c', 22),
            ('any', 1, ParameterDescriptor(dynamic_typing=True)),
            ('locked', 'now', ParameterDescriptor(read_only=True)),
            ('unset', Parameter.Type.INTEGER)])


@pytest.fixture
def robot(ros):
    return ros.add(Robot)


@pytest.fixture
def client(robot):
    return ParameterClient(robot)


@pytest.mark.parametrize(('method', 'arguments', 'good', 'bad', 'sentence'), [
    ('matches', ('serial', '[A-Z]{2}[0-9]{4}'), ['ZZ0000'], ['', 'AB12345', 'xAB1234', 'AB1234\n'],
     'must match [A-Z]{2}[0-9]{4}'),
    ('matches', ('tags', '[a-z][0-9]'), [['c3'], []], [['c3', 'd']], 'each must match [a-z][0-9]'),
    ('one_of', ('mode', ['slow', 'fast']), ['fast'], ['Fast', ''], "must be one of 'slow', 'fast'"),
    ('one_of', ('modes', ['slow', 'fast']), [['fast', 'slow'], []], [['fast', 'x']],
     "each must be one of 'slow', 'fast'"),
    ('one_of', ('level', (1, 2, 3)), [3], [0], 'must be one of 1, 2, 3'),
    ('one_of', ('any', [1, 'one']), ['one', 1], [True, 1.0], "must be one of 1, 'one'"),
    ('length', ('gains', 3), [[0.0] * 3], [[0.0] * 2, []], 'must have 3 elements'),
    ('length', ('gains', 1, 3), [[0.0]], [[], [0.0] * 4], 'must have 1 to 3 elements'),
    ('length', ('serial', 1, 6), ['x'], ['', '1234567'], 'must have 1 to 6 characters'),
    ('check', ('level', lambda level: level != 13, 'must not be 13'), [12], [13], 'must not be 13'),
])
def test_a_rule_rejects_with_parameter_value_and_rule(robot, client, method, arguments, good, bad, sentence):
    getattr(Rules(robot), method)(*arguments)
    name = arguments[0]
    assert client.describe_parameter(name).additional_constraints == sentence[0].upper() + sentence[1:]
    for value in good:
        assert client.set_parameter(name, value).successful, value
    held = client.get_parameter(name)
    for value in bad:
        result = client.set_parameter(name, value)
        assert (result.successful, result.reason) == (False, f'{name} = {value!r}: {sentence}')
    assert client.get_parameter(name) == held


@pytest.fixture
def heater(robot):
    Rules(robot).check(['low_c', 'high_c'], lambda low, high: low < high, 'low_c must be below high_c')
    return ParameterClient(robot)


def test_a_rule_across_parameters_sees_the_whole_change(heater):
    assert heater.set_parameter('low_c', 30).reason == 'low_c = 30, high_c = 22: low_c must be below high_c'
    assert heater.set_parameters_atomically({'low_c': 30, 'high_c': 40}).successful
    assert not heater.set_parameters_atomically({'high_c': 10, 'low_c': 20}).successful
    # One by one, the order decides.
    assert [each.successful for each in heater.set_parameters({'low_c': 50, 'high_c': 60})] == [False, True]
    assert heater.get_parameters(['low_c', 'high_c']) == {'low_c': 30, 'high_c': 60}


def test_a_rule_across_parameters_is_added_to_the_descriptions_of_both(robot, client):
    robot.describe_parameter('low_c').additional_constraints = 'even'
    rules = Rules(robot).check(('low_c', 'high_c'), lambda low, high: low < high, 'low_c is below')
    rules.one_of('high_c', [22, 24])
    assert client.describe_parameter('low_c').additional_constraints == 'even; low_c is below'
    assert client.describe_parameter('high_c').additional_constraints == 'low_c is below; Must be one of 22, 24'
    assert repr(rules) == 'low_c, high_c: low_c is below\nhigh_c: must be one of 22, 24'
    assert client.set_parameter('high_c', 2).reason == (
        'low_c = 18, high_c = 2: low_c is below; high_c = 2: must be one of 22, 24')


def test_a_parameter_that_changes_only_while_another_one_has_a_value(robot, client):
    rules = Rules(robot).only_while(['level', 'gains'], 'mode', 'slow')
    assert client.describe_parameter('level').additional_constraints == "Can change only while mode is 'slow'"
    assert client.describe_parameter('mode').additional_constraints == ''
    assert repr(rules) == '\n'.join(
        f"{name}, mode: can change only while mode is 'slow'" for name in ('level', 'gains'))
    assert client.set_parameter('level', 2).successful
    assert client.set_parameter('mode', 'fast').successful
    assert client.set_parameter('level', 3).reason == (
        "level = 3, mode = 'fast': can change only while mode is 'slow'")
    assert client.set_parameter('level', 2).successful  # no change
    # Together with the other one, in one request.
    assert client.set_parameters_atomically({'level': 3, 'mode': 'slow'}).successful
    assert not client.set_parameters_atomically({'level': 4, 'mode': 'fast'}).successful
    assert client.get_parameters(['level', 'mode']) == {'level': 3, 'mode': 'slow'}


class Ruled(Robot):
    """States its rules as a node should: in the constructor, after the declarations."""

    def __init__(self):
        super().__init__()
        Rules(self).matches('locked', 'now|later').one_of('mode', ['slow', 'fast']).check(
            ['low_c', 'high_c'], lambda low, high: low < high, 'low_c must be below high_c')


@pytest.mark.parametrize(('override', 'words'), [
    ('mode:=flying', "mode = 'flying': must be one of 'slow', 'fast'"),
    ('low_c:=30', 'low_c = 30, high_c = 22: low_c must be below high_c'),
    ('locked:=maybe', "locked = 'maybe': must match now|later"),
])
def test_a_node_does_not_start_with_an_override_that_breaks_a_rule(ros, override, words):
    with pytest.raises(InvalidParameterValueException) as raised:
        ros.add(Ruled, ros_args=['-p', override])
    assert words in str(raised.value)
    assert not ros.nodes


@pytest.mark.parametrize(('state', 'words'), [
    (lambda rules: rules.matches('serial', '[A-Z'), "'[A-Z' is not a regular expression: unterminated"),
    (lambda rules: rules.one_of('level', [1, 2.0]), 'it is a parameter of type integer and can never be 2.0, of type '
                                                    'double'),
    (lambda rules: rules.check('level', lambda level: level.upper(), 'upper'),
     'level = 1: the rule "upper" could not be judged: AttributeError'),
    (lambda rules: rules.check('level', print, 'nothing'), 'it returned None; a rule has to return True or False'),
    (lambda rules: rules.check('level', lambda low, high: True, 'two'), 'missing 1 required positional argument'),
])
def test_a_rule_that_makes_no_sense_raises_when_it_is_stated(robot, client, state, words):
    with pytest.raises(RuleError) as raised:
        state(Rules(robot))
    assert words in str(raised.value)
    assert client.describe_parameter('level').additional_constraints == ''
    assert client.set_parameter('level', 2).successful


def test_a_rule_that_raises_later_rejects_and_the_node_lives(ros, robot, client):
    Rules(robot).check(['level', 'any'], lambda level, other: level / other < 10, 'a small ratio')
    assert client.set_parameter('any', 0).reason == (
        'level = 1, any = 0: the rule "a small ratio" could not be judged: ZeroDivisionError: division by zero')
    assert 'TypeError' in client.set_parameter('any', 'text').reason
    assert client.set_parameter('any', 2).successful
    assert not ros.errors


def test_a_rule_is_silent_without_a_value(robot, client):
    Rules(robot).check('unset', lambda number: number % 2 == 0, 'even').check(
        ['any', 'level'], lambda other, level: other == level, 'equal')
    assert not client.set_parameter('unset', 3).successful
    assert client.set_parameter('unset', 4).successful
    assert client.delete_parameter('any').successful
    assert client.set_parameter('level', 7).successful
