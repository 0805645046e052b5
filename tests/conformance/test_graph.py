"""What nodes know of each other: names, types, counts, endpoints."""

from builtin_interfaces.msg import Time
from rcl_interfaces.srv import GetParameters
from rclpy.context import Context
from rclpy.impl.implementation_singleton import rclpy_implementation as layer
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from rclpy.topic_endpoint_info import TopicEndpointTypeEnum


def test_nodes(ros):
    first, _ = ros.node('first'), ros.node('second', namespace='/ns')
    ros.wait(lambda: len(first.get_node_names()) == 2)
    assert first.get_node_names_and_namespaces() == [('first', '/'), ('second', '/ns')]
    assert first.get_node_names_and_namespaces_with_enclaves() == [('first', '/', '/'), ('second', '/ns', '/')]
    assert first.get_fully_qualified_node_names() == ['/first', '/ns/second']
    first.executor.remove_node(ros.nodes[1])
    ros.nodes.pop().destroy_node()
    ros.wait(lambda: first.get_node_names() == ['first'])


def test_services(ros):
    node = ros.node(start_parameter_services=False)
    node.create_service(GetParameters, 'serve', print)
    node.create_client(GetParameters, 'ask')
    ros.wait(lambda: node.count_clients('/ask') and node.count_services('/serve'))
    types = ['rcl_interfaces/srv/GetParameters']
    described = ('/node/get_type_description', ['type_description_interfaces/srv/GetTypeDescription'])
    assert node.get_service_names_and_types() == [('/ask', types), described, ('/serve', types)]
    assert node.get_service_names_and_types_by_node('node', '/') == [described, ('/serve', types)]
    assert node.get_client_names_and_types_by_node('node', '/') == [('/ask', types)]
    assert (node.count_services('/ask'), node.count_clients('/serve')) == (0, 0)


def test_the_services_of_a_node(ros):
    node = ros.node('n', namespace='/ns')
    names = [name for name, _ in node.get_service_names_and_types_by_node('n', '/ns')]
    assert names == [f'/ns/n/{name}' for name in (
        'describe_parameters', 'get_parameter_types', 'get_parameters', 'get_type_description', 'list_parameters',
        'set_parameters', 'set_parameters_atomically')]


def test_endpoints(ros):
    node = ros.node('n', namespace='/ns')
    profile = QoSProfile(depth=4, durability=DurabilityPolicy.TRANSIENT_LOCAL,
                         reliability=ReliabilityPolicy.BEST_EFFORT)
    node.create_publisher(Time, 'topic', profile)
    node.create_subscription(Time, 'topic', print, 1)
    ros.wait(lambda: node.count_publishers('/ns/topic') and node.count_subscribers('/ns/topic'))
    (sends,), (hears,) = node.get_publishers_info_by_topic('topic'), node.get_subscriptions_info_by_topic('/ns/topic')
    for info, kind in ((sends, TopicEndpointTypeEnum.PUBLISHER), (hears, TopicEndpointTypeEnum.SUBSCRIPTION)):
        assert (info.node_name, info.node_namespace, info.topic_type) == ('n', '/ns', 'builtin_interfaces/msg/Time')
        assert info.endpoint_type == kind
        assert len(info.endpoint_gid) == 16
    assert sends.endpoint_gid != hears.endpoint_gid
    assert sends.qos_profile.durability == DurabilityPolicy.TRANSIENT_LOCAL
    assert sends.qos_profile.reliability == ReliabilityPolicy.BEST_EFFORT
    assert str(hears.qos_profile.history) == str(sends.qos_profile.history)
    assert sends.qos_profile.lifespan == hears.qos_profile.deadline
    assert node.get_publishers_info_by_topic('nothing') == []
    assert len(node.get_publishers_info_by_topic('rt/ns/topic', no_mangle=True)) == 1


def test_contexts_of_one_domain_see_each_other_and_those_of_another_do_not(ros):
    node = ros.node('here')
    others, contexts = [], [Context(), Context()]
    for context, more, name in zip(contexts, (0, 1), ('near', 'far')):
        context.init(['program'], domain_id=node.context.get_domain_id() + more)
        others.append(layer.Node(name, '', context.handle, None, True, True))
    ros.wait(lambda: 'near' in node.get_node_names())
    assert node.get_node_names() in (['here', 'near'], ['near', 'here'])
    assert others[1].get_node_names_and_namespaces() == [('far', '/')]
    for other in others:
        other.destroy_when_not_in_use()
    for context in contexts:
        context.shutdown()
