"""Services and clients: requests, answers, several of each, and what goes wrong."""

from rcl_interfaces.msg import ParameterValue
from rcl_interfaces.srv import GetParameters


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
