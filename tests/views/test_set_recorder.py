"""A change is recorded as rclpy makes it, and the recorder leaves no trace."""

from functools import partial

import pytest
from rclpy.parameter import Parameter

from param_tools.errors import CallbackError, ExecutorError
from param_tutorial import ParameterClient
from param_tutorial.views.set_recorder import follow_sets, record_set


# The ladder of callbacks; claims.md, section 2 (a).
def test_a_change_is_recorded_rung_by_rung(robot):
    record = record_set(robot, 'speed', 900)
    assert (record.node, record.name, record.stored) == ('/robot', 'speed', 300)
    assert [(step.what, step.happened, step.stored) for step in record.steps] == [
        ('asked', 'set speed to 900', '100'),
        ('pre-set', 'trim sees 900, gives 300', '100'),
        ('on-set', 'judge sees 300, accepts', '100'),
        ('on-set', "rclpy's TimeSource sees 300, accepts", '100'),
        ('stored', 'the value is written', '300'),
        ('event', 'speed = 300', '300'),
        ('post-set', 'act sees 300', '300'),
        ('answer', 'successful', '300')]


def test_a_partial_has_the_name_of_its_function(robot):
    robot.remove_post_set_parameters_callback(robot.act)
    robot.add_post_set_parameters_callback(partial(robot.act))
    assert record_set(robot, 'speed', 900).steps[-2].happened == 'act sees 300'


@pytest.mark.parametrize(('name', 'value', 'last_callback', 'answer'), [
    ('speed', -5, 'on-set', 'rejected: minus five'),
    ('opening', 900, 'pre-set', 'rejected: Parameter opening out of range. Min: 0, Max: 85, value: 900'),
    ('wings', 2, 'pre-set', 'rejected: Invalid access to undeclared parameter(s): []'),
])
def test_a_rejection_ends_where_it_happens(robot, name, value, last_callback, answer):
    steps = record_set(robot, name, value).steps
    assert [steps[-2].what, steps[-1].what, steps[-1].happened] == [last_callback, 'answer', answer]
    assert len({step.stored for step in steps}) == 1


def test_a_deleted_parameter_is_stored_no_more(robot):
    robot.remove_pre_set_parameters_callback(robot.trim)
    steps = {step.what: step for step in record_set(robot, 'note', None).steps}
    assert (steps['event'].happened, steps['event'].stored) == ('note = None', 'nothing')


def test_an_exception_in_a_callback_is_noted(robot):
    steps = record_set(robot, 'speed', 'fast').steps
    assert [(step.what, step.happened) for step in steps[1:]] == [
        ('pre-set', "trim sees 'fast', raises TypeError"), ('no answer', 'the caller would wait forever')]


def test_a_pre_set_callback_that_answers_nonsense_fails_as_without_a_recorder(ros, robot):
    robot.add_pre_set_parameters_callback(lambda _: [3])
    with pytest.raises(CallbackError) as bare:
        ParameterClient(robot).set_parameter('speed', 150)
    assert 'gives [3], which is not a list of parameters' in record_set(robot, 'speed', 150).steps[1].happened
    assert str(ros.errors[-1]) == str(bare.value.__cause__)


def test_each_set_is_heard_of_also_one_in_a_callback_and_what_the_node_rejects_and_no_trace_is_left(ros, robot):
    def insides():
        return (robot._pre_set_parameters_callbacks[:], robot._on_set_parameters_callbacks[:],
                robot._post_set_parameters_callbacks[:], robot._parameter_event_publisher)

    def set_opening(parameters):
        if parameters[0].value == 7:
            robot.set_parameters([Parameter('opening', value=10)])

    robot.add_post_set_parameters_callback(set_opening)
    before, heard, also = insides(), [], []
    stop_following = follow_sets(robot, lambda record: heard.append((record.value, record.stored, record.objection)))
    stop_too = follow_sets(robot, also.append)
    client = ParameterClient(robot)
    for value in (900, -5):
        client.set_parameter('speed', value)
    stop_too()
    ros.run(lambda: robot.set_parameters([Parameter('speed', value=7)]), 'set')
    with pytest.raises(CallbackError):
        client.set_parameter('speed', 'fast')
    stop_following()
    stop_following()
    client.set_parameter('speed', 8)
    assert heard == [(900, 300, ''), (-5, 300, 'minus five'), (10, 10, ''), (7, 7, ''),
                     ('fast', 7, "TypeError: '<' not supported between instances of 'int' and 'str'")]
    assert len(also) == 2 and insides() == before and '_set_parameters_atomically' not in vars(robot)
    ros.remove(robot)
    with pytest.raises(ExecutorError, match=r'ros\.add'):
        record_set(robot, 'speed', 1)
