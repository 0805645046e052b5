"""Calls with a deadline: what comes back, and with which error each way to fail ends."""

import pytest
from rcl_interfaces.srv import ListParameters, SetParameters
from rclpy.parameter import Parameter

from param_tools.errors import NoAnswerError, NodeNotFoundError, ParameterToolError
from param_tools.ros import executor
from param_tools.ros.services import full_name
from param_tools.ros.waiting import wait_until
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from tests.support.nodes import Counter, Gate

ROBOT = '/simple_param_node'


def set_x(value):
    return SetParameters.Request(parameters=[Parameter('x', value=value).to_parameter_msg()])


def test_a_destroyed_node_has_no_name(ros):
    node = ros.add(SimpleParamNode)
    ros.remove(node)
    with pytest.raises(ParameterToolError, match='this SimpleParamNode was destroyed, and its name went with it: make'):
        full_name(node)


def test_a_node_that_is_not_there_is_named_with_its_likeliest_neighbor(ros):
    def error_of(name):
        with pytest.raises(NodeNotFoundError) as caught:
            ros.services.call(name, 'list_parameters', ListParameters.Request())
        return str(caught.value)

    ros.add(SimpleParamNode)
    for name in ('/simple_parm_node', '/simple param node'):  # the second no node can have
        assert error_of(name) == f'there is no node {name}. Did you mean {ROBOT}?'
    assert f'There is: {ROBOT}' in error_of('/not a name')
    ros.remove_all()
    assert 'No node is running' in error_of(ROBOT)


def test_an_error_names_the_callback_of_another_node_that_is_in_the_way_each_time(ros, monkeypatch):
    monkeypatch.setattr(executor, '_BUSY_SEC', 0.2)
    ros.add(Counter)
    gate = ros.add(Gate)
    ros.services.call('/counter', 'set_parameters', set_x(1))
    ros.services.call_async('/gate', 'set_parameters', set_x(1))
    gate.entered.acquire(timeout=20)
    for _ in range(2):
        with pytest.raises(NoAnswerError, match=r'/counter did not answer set_parameters within 0\.3 s: the service '
                           r'set_parameters of /gate, in line \d+ \(`self.open.acquire\(timeout=20\)`\), does not'):
            ros.services.call('/counter', 'set_parameters', set_x(2), timeout_sec=0.3)
    gate.open.release()


def test_a_node_that_does_not_answer_in_time_costs_no_more_than_that(ros):
    node = ros.add(Gate)
    ros.services.call('/gate', 'set_parameters', SetParameters.Request())
    with pytest.raises(NoAnswerError, match=r'/gate did not answer set_parameters within 0\.1 s'):
        ros.services.call('/gate', 'set_parameters', set_x(1), timeout_sec=0.1)
    assert ros.services._pending == {}
    for _ in range(2):
        node.open.release()
    ros.services.call('/gate', 'set_parameters', set_x(2))
    assert node.seen == [1, 2]  # each was sent once


def test_a_call_without_waiting_completes_in_the_executors_thread(ros):
    ros.add(SimpleParamNode)
    answers = []
    for _ in range(2):  # of a node that is just coming, and of one that has answered before
        future = ros.services.call_async(ROBOT, 'list_parameters', ListParameters.Request())
        future.add_done_callback(lambda future: answers.append((future.result(), ros.in_thread())))
        wait_until(lambda: answers, 'the answer', 30.0)
        (answer, is_in_executor_thread), = answers
        assert is_in_executor_thread
        assert 'max_speed_rpm' in answer.result.names
        answers.clear()
    wait_until(lambda: ros.services._pending == {}, 'the call to be forgotten', 30.0)


def test_a_call_without_waiting_fails_where_there_is_no_node_and_where_it_is_late(ros):
    nobody = ros.services.call_async('/nobody', 'set_parameters', set_x(1))
    wait_until(nobody.done, 'the end')
    assert isinstance(nobody.exception(), NodeNotFoundError)
    node = ros.add(Gate)
    ros.services.call('/gate', 'set_parameters', SetParameters.Request())
    late = ros.services.call_async('/gate', 'set_parameters', set_x(1), timeout_sec=0.0)
    assert node.entered.acquire(timeout=30)
    ros.services.expire()
    assert isinstance(late.exception(), NoAnswerError)
    node.open.release()


def test_requests_are_sent_in_the_order_of_the_calls(ros):
    node = ros.add(Counter)
    futures = [ros.services.call_async('/counter', 'set_parameters', set_x(value)) for value in range(1, 6)]
    wait_until(lambda: all(future.done() for future in futures), 'the answers')
    assert node.seen == [1, 2, 3, 4, 5]
