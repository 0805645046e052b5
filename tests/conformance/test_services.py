"""Services and clients: requests, answers, several of each, and what goes wrong."""

import pytest
import rclpy
from rcl_interfaces.msg import ParameterValue
from rcl_interfaces.srv import GetParameters
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.impl.implementation_singleton import rclpy_implementation as layer


def number_of_names(request, response):
    response.values = [ParameterValue(type=2, integer_value=len(request.names))]
    return response


def test_request_and_answer(ros):
    node = ros.node()
    service = node.create_service(GetParameters, 'count', number_of_names)
    client = node.create_client(GetParameters, 'count')
    assert (client.service_name, service.service_name) == ('/count', '/count')
    request = GetParameters.Request(names=['a', 'b'])
    assert client.wait_for_service(timeout_sec=30)
    future = client.call_async(request)
    request.names.append('c')
    assert ros.result(future).values[0].integer_value == 2


def test_each_client_gets_its_own_answer(ros):
    node = ros.node()
    node.create_service(GetParameters, 'count', number_of_names)
    clients = [node.create_client(GetParameters, 'count') for _ in range(3)]
    ros.wait(lambda: all(client.service_is_ready() for client in clients))
    futures = [client.call_async(GetParameters.Request(names=['x'] * (10 * index + number)))
               for number in (1, 2) for index, client in enumerate(clients)]
    assert [ros.result(future).values[0].integer_value for future in futures] == [1, 11, 21, 2, 12, 22]


def test_a_service_that_is_not_there(ros):
    node = ros.node()
    client = node.create_client(GetParameters, 'nothing')
    assert not client.service_is_ready()
    assert not client.wait_for_service(timeout_sec=0.2)
    service = node.create_service(GetParameters, 'nothing', number_of_names)
    ros.wait(client.service_is_ready)
    node.destroy_service(service)
    ros.wait(lambda: not client.service_is_ready())


def test_a_request_to_nobody_is_lost(ros):
    node = ros.node()
    client = node.create_client(GetParameters, 'count')
    lost = client.call_async(GetParameters.Request())
    node.create_service(GetParameters, 'count', number_of_names)
    ros.wait(client.service_is_ready)
    assert ros.result(client.call_async(GetParameters.Request())).values[0].integer_value == 0
    assert not lost.done()
    client.remove_pending_request(lost)


def test_a_callback_that_raises(ros):
    node = ros.node()
    node.create_service(GetParameters, 'bad', lambda request, response: 1 / 0)
    client = node.create_client(GetParameters, 'bad')
    ros.wait(client.service_is_ready)
    future = client.call_async(GetParameters.Request())
    with pytest.raises(ZeroDivisionError):
        ros.result(future)
    assert not future.done()


def test_a_callback_may_be_a_coroutine(ros):
    node = ros.node()
    group = ReentrantCallbackGroup()
    node.create_service(GetParameters, 'count', number_of_names, callback_group=group)
    client = node.create_client(GetParameters, 'count', callback_group=group)

    async def relay(request, response):
        return await client.call_async(request)

    node.create_service(GetParameters, 'relay', relay, callback_group=group)
    response = ros.call(node, GetParameters, 'relay', names=['a'])
    assert response.values[0].integer_value == 1


def test_a_blocking_call_from_another_callback(ros):
    node = ros.node()
    node.create_service(GetParameters, 'count', number_of_names, callback_group=MutuallyExclusiveCallbackGroup())
    client = node.create_client(GetParameters, 'count', callback_group=MutuallyExclusiveCallbackGroup())
    ros.executor.remove_node(node)
    executor = MultiThreadedExecutor(2, context=ros.context)
    executor.add_node(node)
    assert client.wait_for_service(timeout_sec=30)
    task = executor.create_task(lambda: client.call(GetParameters.Request(names=['a'])).values[0].integer_value)
    executor.spin_until_future_complete(task, 60)
    assert task.result() == 1
    executor.shutdown()


def test_raw_handles(ros):
    node = ros.node()
    service = layer.Service(node.handle, GetParameters, 'raw', None)
    client = layer.Client(node.handle, GetParameters, 'raw', None)
    assert (service.name, client.service_name) == ('/raw', '/raw')
    assert service.service_take_request(GetParameters.Request) == (None, None)
    assert client.take_response(GetParameters.Response) == (None, None)
    ros.wait(client.service_server_is_available)
    assert [client.send_request(GetParameters.Request(names=[name])) for name in ('a', 'b')] == [1, 2]
    requests = []
    ros.wait(lambda: requests.append(service.service_take_request(GetParameters.Request)) or requests[-1][0])
    request, info = requests[-1]
    assert (request.names, info.request_id.sequence_number) == (['a'], 1)
    assert 0 < info.source_timestamp <= info.received_timestamp
    service.service_send_response(GetParameters.Response(), info.request_id)
    answers = []
    ros.wait(lambda: answers.append(client.take_response(GetParameters.Response)) or answers[-1][0])
    assert answers[-1][0].request_id.sequence_number == 1
    client.destroy_when_not_in_use()
    service.destroy_when_not_in_use()


def test_the_global_spin_functions():
    rclpy.init(args=['program'])
    try:
        node = rclpy.create_node('node')
        node.create_service(GetParameters, 'count', number_of_names)
        client = node.create_client(GetParameters, 'count')
        assert client.wait_for_service(timeout_sec=30)
        future = client.call_async(GetParameters.Request(names=['a']))
        rclpy.spin_until_future_complete(node, future, timeout_sec=60)
        assert future.result().values[0].integer_value == 1
        rclpy.spin_once(node, timeout_sec=0)
        node.destroy_node()
    finally:
        rclpy.shutdown()
