"""A change is recorded as rclpy makes it, its picture tells the same in words, and the recorder leaves no trace."""

import pytest
from rclpy.parameter import Parameter

from param_tools.errors import CallbackError, ExecutorError, InvalidValueError
from param_tutorial import ParameterClient
from param_tutorial.views import record_change
from param_tutorial.views.drawing.timeline import Step, Timeline
from param_tutorial.views.set_recorder import follow_sets
from tests.support.drawings import labels, parsed


def rows(timeline):
    return [(step.what, step.happened, step.stored) for step in timeline.steps]


# What chapter 5.2 calls the ladder; claims.md, section 2 (a).
def test_a_change_is_recorded_rung_by_rung(robot):
    assert rows(record_change(robot, 'speed', 900)) == [
        ('asked', 'set speed to 900', '100'),
        ('pre-set', 'trim sees 900, gives 300', '100'),
        ('on-set', 'judge sees 300, accepts', '100'),
        ('on-set', "rclpy's TimeSource sees 300, accepts", '100'),
        ('stored', 'the value is written', '300'),
        ('event', 'speed = 300', '300'),
        ('post-set', 'act sees 300', '300'),
        ('answer', 'successful', '300')]


@pytest.mark.parametrize(('name', 'value', 'last_callback', 'answer'), [
    ('speed', -5, 'on-set', 'rejected: minus five'),
    ('opening', 900, 'pre-set', 'rejected: Parameter opening out of range. Min: 0, Max: 85, value: 900'),
    ('wings', 2, 'pre-set', 'rejected: Invalid access to undeclared parameter(s): []'),
])
def test_a_rejection_ends_where_it_happens(robot, name, value, last_callback, answer):
    steps = record_change(robot, name, value).steps
    assert [steps[-2].what, steps[-1].what, steps[-1].happened] == [last_callback, 'answer', answer]
    assert len({step.stored for step in steps}) == 1


def test_a_deleted_parameter_is_stored_no_more(robot):
    robot.remove_pre_set_parameters_callback(robot.trim)
    steps = {step.what: step for step in record_change(robot, 'note', None).steps}
    assert (steps['event'].happened, steps['event'].stored) == ('note = None', 'nothing')


def test_an_exception_in_a_callback_is_drawn(robot):
    steps = record_change(robot, 'speed', 'fast').steps
    assert [(step.what, step.happened) for step in steps[1:]] == [
        ('pre-set', "trim sees 'fast', raises TypeError"), ('no answer', 'the caller would wait forever')]


@pytest.mark.parametrize('answer', [None, [3]])
def test_a_pre_set_callback_that_answers_nonsense_is_drawn_and_fails_as_without_a_recorder(ros, robot, answer):
    robot.add_pre_set_parameters_callback(lambda _: answer)
    with pytest.raises(CallbackError) as bare:
        ParameterClient(robot).set_parameter('speed', 150)
    timeline = record_change(robot, 'speed', 150)
    assert f'gives {answer!r}, which is not a list of parameters' in timeline.text
    assert str(ros.errors[-1]) == str(bare.value.__cause__)


def test_a_pre_set_callback_that_gives_nothing_stops_the_value(robot):
    robot.remove_pre_set_parameters_callback(robot.trim)
    robot.add_pre_set_parameters_callback(lambda _: [])
    steps = record_change(robot, 'speed', 5).steps
    assert 'gives nothing' in [step.objection for step in steps if step.what == 'pre-set']
    assert steps[-1].happened.startswith('rejected') and steps[-1].stored == '100'


def test_the_recorder_leaves_no_trace(ros, robot):
    def insides():
        return (robot._pre_set_parameters_callbacks[:], robot._on_set_parameters_callbacks[:],
                robot._post_set_parameters_callbacks[:], robot._parameter_event_publisher)

    before = insides()
    for value in (150, -5, 'fast'):
        record_change(robot, 'speed', value)
    assert insides() == before
    assert [type(each).__name__ for each in insides()[1]] == ['method', 'method']
    assert robot.acted == [150]


def test_only_a_node_on_the_stage_can_be_recorded(ros, robot):
    with pytest.raises(InvalidValueError):
        record_change(robot, 'speed', {1: 2})
    assert '_set_parameters_atomically' not in vars(robot)
    ros.remove(robot)
    with pytest.raises(ExecutorError, match=r'ros\.add'):
        record_change(robot, 'speed', 1)


def test_who_follows_a_node_hears_of_each_set_and_of_what_the_node_rejects(ros, robot):
    heard = []
    stop_following = follow_sets(robot, lambda record: heard.append((record.value, record.stored, record.objection)))
    client = ParameterClient(robot)
    for value in (900, -5):
        client.set_parameter('speed', value)
    client.set_parameter('opening', 900)
    client.set_parameter('wings', 2)
    ros.run(lambda: robot.set_parameters([Parameter('speed', value=7)]), 'set')
    with pytest.raises(CallbackError):
        client.set_parameter('speed', 'fast')
    stop_following()
    stop_following()
    client.set_parameter('speed', 8)
    assert heard == [
        (900, 300, ''), (-5, 300, 'minus five'),
        (900, 40, 'Parameter opening out of range. Min: 0, Max: 85, value: 900'),
        (2, None, 'Invalid access to undeclared parameter(s): []'), (7, 7, ''),
        ('fast', 7, "TypeError: '<' not supported between instances of 'int' and 'str'")]


def test_several_follow_one_node_and_leave_in_any_order(robot):
    first, second = [], []
    stop_first, stop_second = follow_sets(robot, first.append), follow_sets(robot, second.append)
    ParameterClient(robot).set_parameter('speed', 1)
    stop_first()
    ParameterClient(robot).set_parameter('speed', 2)
    stop_second()
    assert ([each.value for each in first], [each.value for each in second]) == ([1], [1, 2])
    assert robot._pre_set_parameters_callbacks == [robot.trim]
    assert type(robot._pre_set_parameters_callbacks[0]).__name__ == 'method'


def test_a_callback_that_sets_another_parameter_is_recorded_by_itself(ros, robot):
    heard = []

    def set_opening(parameters):
        if parameters[0].name == 'speed':
            robot.set_parameters([Parameter('opening', value=10)])

    robot.add_post_set_parameters_callback(set_opening)
    stop_following = follow_sets(robot, lambda record: heard.append((record.timeline.name, record.stored)))
    ParameterClient(robot).set_parameter('speed', 5)
    stop_following()
    assert heard == [('opening', 10), ('speed', 5)]


# -- the picture ---------------------------------------------------------------------------------------------

STEPS = [Step('asked', 'set speed to 2', '1', comes_from='you'), Step('on-set', 'judge sees 2, accepts', '1'),
         Step('stored', 'the value is written', '2'), Step('answer', 'successful', '2', goes_to='you')]


def test_a_timeline_tells_in_words_what_it_draws():
    timeline = Timeline('/robot', 'speed', STEPS)
    assert timeline.text == (
        'speed of /robot, step by step. 1, asked: set speed to 2; stored is 1. 2, on-set: judge sees 2, accepts; '
        'stored is 1. 3, stored: the value is written; stored is 2. 4, answer: successful; stored is 2')
    assert parsed(timeline).get('aria-label') == timeline.text
    assert repr(timeline).splitlines() == [
        '/robot: speed                    stored',
        '  asked   set speed to 2         1',
        '  on-set  judge sees 2, accepts  1',
        '  stored  the value is written   2',
        '  answer  successful             2']


def test_a_timeline_marks_the_one_moment_of_the_change_without_color():
    fills = [circle.get('fill') for circle in parsed(Timeline('/robot', 'speed', STEPS)).iter('circle')]
    assert len(set(fills)) == 2
    assert fills.count(fills[2]) == 1


def test_a_long_step_is_wrapped_and_a_long_value_is_cut():
    timeline = Timeline('/robot', 'speed', [Step('answer', 'rejected: ' + 'because ' * 20, "'" + 'x' * 60 + "'")])
    shown = labels(timeline)
    assert ' '.join(shown).count('because') == 20
    assert max(map(len, shown)) <= 60
    assert 'x' * 60 in timeline.text
