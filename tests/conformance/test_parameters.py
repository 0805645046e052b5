"""Parameters: types, callbacks, the six services, events, the event handler, and rclpy's own client."""

import pytest
from rcl_interfaces.msg import (
    FloatingPointRange,
    IntegerRange,
    ListParametersResult,
    ParameterDescriptor,
    ParameterEvent,
    ParameterType,
    ParameterValue,
    SetParametersResult,
)
from rcl_interfaces.srv import (
    DescribeParameters,
    GetParameters,
    GetParameterTypes,
    ListParameters,
    SetParameters,
    SetParametersAtomically,
)
from rclpy.exceptions import InvalidParameterValueException, ParameterAlreadyDeclaredException
from rclpy.parameter import Parameter
from rclpy.parameter_client import AsyncParameterClient
from rclpy.parameter_event_handler import ParameterEventHandler

VALUES = {
    'bool': (True, ParameterType.PARAMETER_BOOL),
    'integer': (-2**63, ParameterType.PARAMETER_INTEGER),
    'double': (1e-310, ParameterType.PARAMETER_DOUBLE),
    'string': ('ä€😀', ParameterType.PARAMETER_STRING),
    'bytes': ([b'a', b'\0', b'\xff'], ParameterType.PARAMETER_BYTE_ARRAY),
    'bools': ([True, False], ParameterType.PARAMETER_BOOL_ARRAY),
    'integers': ([1, 2**63 - 1], ParameterType.PARAMETER_INTEGER_ARRAY),
    'doubles': ([0.1, float('inf')], ParameterType.PARAMETER_DOUBLE_ARRAY),
    'strings': (['a', ''], ParameterType.PARAMETER_STRING_ARRAY),
}


@pytest.fixture
def pair(ros):
    """Return a node with a parameter of each type, and a node that asks it."""
    node = ros.node('server')
    for name, (value, _) in VALUES.items():
        node.declare_parameter(name, value)
    return node, ros.node('client')


def test_the_six_services(ros, pair):
    node, client = pair
    names = ros.call(client, ListParameters, '/server/list_parameters').result
    assert isinstance(names, ListParametersResult)
    assert {*VALUES, 'use_sim_time', 'start_type_description_service'} == set(names.names)
    types = ros.call(client, GetParameterTypes, '/server/get_parameter_types', names=[*VALUES]).types
    assert list(types) == [number for _, number in VALUES.values()]
    descriptors = ros.call(client, DescribeParameters, '/server/describe_parameters', names=['bool']).descriptors
    assert descriptors == [ParameterDescriptor(name='bool', type=ParameterType.PARAMETER_BOOL)]
    results = ros.call(client, SetParameters, '/server/set_parameters', parameters=[
        Parameter('bool', value=False).to_parameter_msg(), Parameter('integer', value='x').to_parameter_msg()]).results
    assert [each.successful for each in results] == [True, False]
    assert results[1].reason.startswith('Wrong parameter type, expected')
    result = ros.call(client, SetParametersAtomically, '/server/set_parameters_atomically', parameters=[
        Parameter('bool', value=True).to_parameter_msg(), Parameter('integer', value='x').to_parameter_msg()]).result
    assert not result.successful
    assert node.get_parameter('bool').value is False
    assert ros.call(client, GetParameters, '/server/get_parameters', names=['bool', 'nothing']).values == []


def test_the_three_kinds_of_callbacks(ros, pair):
    node, client = pair
    heard = []

    def before(parameters):
        heard.append(('before', [each.value for each in parameters]))
        return [*parameters, Parameter('double', value=2.5)]

    def judge(parameters):
        heard.append(('judge', [each.value for each in parameters]))
        return SetParametersResult(successful=parameters[0].value != 13,
                                   reason='unlucky' if parameters[0].value == 13 else '')

    node.add_pre_set_parameters_callback(before)
    node.add_on_set_parameters_callback(judge)
    node.add_post_set_parameters_callback(lambda parameters: heard.append(('after', len(parameters))))
    for value in (13, 12):
        response = ros.call(client, SetParameters, '/server/set_parameters', parameters=[
            Parameter('integer', value=value).to_parameter_msg()])
        assert response.results[0].successful is (value == 12)
        assert response.results[0].reason == ('unlucky' if value == 13 else '')
    assert heard == [('before', [13]), ('judge', [13, 2.5]), ('before', [12]), ('judge', [12, 2.5]), ('after', 2)]


def test_descriptors(ros):
    node = ros.node()
    node.declare_parameter('speed', 1.0, ParameterDescriptor(
        floating_point_range=[FloatingPointRange(from_value=0.0, to_value=2.0, step=0.5)]))
    node.declare_parameter('gear', 1, ParameterDescriptor(read_only=True))
    node.declare_parameter('count', 4, ParameterDescriptor(
        integer_range=[IntegerRange(from_value=0, to_value=8, step=4)]))
    reasons = [node.set_parameters([Parameter(name, value=value)])[0].reason
               for name, value in (('speed', 3.0), ('speed', 0.7), ('gear', 2), ('count', 5), ('count', 8))]
    assert 'out of range' in reasons[0]
    assert 'close enough to a valid step' in reasons[1]
    assert 'read-only' in reasons[2]
    assert 'not a valid step' in reasons[3]
    assert reasons[4] == ''
    with pytest.raises(InvalidParameterValueException):
        node.declare_parameter('other', 9, ParameterDescriptor(integer_range=[IntegerRange(from_value=0, to_value=8)]))
    with pytest.raises(ParameterAlreadyDeclaredException):
        node.declare_parameter('gear', 1)


def test_a_declaration_takes_the_override_and_rejects_one_of_another_type(ros):
    ros.init('-p', 'good:=2', '-p', 'bad:=text')
    node = ros.node()
    assert node.declare_parameter('good', 1).value == 2
    with pytest.raises(Exception, match='bad'):
        node.declare_parameter('bad', 1)


def test_parameter_events(ros):
    client, events = ros.node('client'), []
    client.create_subscription(ParameterEvent, '/parameter_events', events.append, 1000)
    node = ros.node('server', namespace='/ns')
    own = {'use_sim_time', 'start_type_description_service'}  # declared by every node
    ros.wait(lambda: own <= {each.name for event in events for each in event.new_parameters
                             if event.node == '/ns/server'})
    events.clear()
    node.declare_parameter('a', 1, ParameterDescriptor(dynamic_typing=True))
    node.set_parameters([Parameter('a', value=2)])
    node.set_parameters([Parameter('a')])
    ros.wait(lambda: len(events) == 3)
    assert [event.node for event in events] == ['/ns/server'] * 3
    assert [[each.name for each in event.new_parameters] for event in events] == [['a'], [], []]
    assert [[each.value.integer_value for each in event.changed_parameters] for event in events] == [[], [2], []]
    assert [[each.name for each in event.deleted_parameters] for event in events] == [[], [], ['a']]
    assert events[0].stamp.sec > 0


def test_parameter_event_handler(ros):
    watcher, heard = ros.node('watcher'), []
    handler = ParameterEventHandler(watcher)
    handle = handler.add_parameter_callback('a', '/server', lambda parameter: heard.append(parameter.value))
    handler.add_parameter_event_callback(lambda event: heard.append(event.node))
    node = ros.node('server')
    node.declare_parameter('a', 1)
    ros.wait(lambda: ParameterValue(type=2, integer_value=1) in heard)
    handler.remove_parameter_callback(handle)
    heard.clear()
    node.set_parameters([Parameter('a', value=2)])
    ros.wait(lambda: heard)
    assert heard == ['/server']
    handler.destroy()


def test_rclpys_own_client(ros, pair, tmp_path):
    client = AsyncParameterClient(pair[1], '/server')
    ros.wait(client.services_are_ready)
    assert ros.result(client.get_parameters(['string'])).values[0].string_value == 'ä€😀'
    assert ros.result(client.set_parameters([Parameter('integer', value=5)])).results[0].successful
    (tmp_path / 'file.yaml').write_text('/server: {ros__parameters: {integer: 6, bools: [false]}}\n')
    loaded = ros.result(client.load_parameter_file(str(tmp_path / 'file.yaml')))
    assert [each.successful for each in loaded.results] == [True, True]
    assert (pair[0].get_parameter('integer').value, pair[0].get_parameter('bools').value) == (6, [False])


def test_a_node_without_parameter_services(ros):
    node = ros.node(start_parameter_services=False)
    assert [name for name, _ in node.get_service_names_and_types_by_node('node', '/')] == [
        '/node/get_type_description']
    bare = ros.node('bare', start_parameter_services=False,
                    parameter_overrides=[Parameter('start_type_description_service', value=False)])
    assert bare.get_service_names_and_types_by_node('bare', '/') == []
