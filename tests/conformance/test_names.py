"""Names of nodes, namespaces, topics and services: which are valid, what they stand for, what remaps make of them."""

import pytest
from rcl_interfaces.msg import Log
from rcl_interfaces.srv import GetParameters
from rclpy.exceptions import InvalidNamespaceException, InvalidNodeNameException, InvalidTopicNameException
from rclpy.expand_topic_name import expand_topic_name
from rclpy.impl.implementation_singleton import rclpy_implementation as layer
from rclpy.validate_topic_name import validate_topic_name


@pytest.mark.parametrize('name, why', [
    ('', 'must not be empty'),
    ('two words', 'must not contain characters other than alphanumerics'),
    ('1st', 'must not start with a number'),
    ('x' * 256, "length should not exceed '255'")])
def test_invalid_name_of_a_node(ros, name, why):
    with pytest.raises(InvalidNodeNameException, match=why):
        ros.node(name)


@pytest.mark.parametrize('namespace, why', [
    ('a b', 'must not contain characters other than'),
    ('/a/', "must not end with a '/'"),
    ('/a//b', "must not contain repeated '/'"),
    ('/1', 'must not have a token that starts with a number')])
def test_invalid_namespace(ros, namespace, why):
    with pytest.raises(InvalidNamespaceException, match=why):
        ros.node(namespace=namespace)


@pytest.mark.parametrize('topic, expanded', [
    ('chatter', '/ns/chatter'), ('/chatter', '/chatter'), ('~', '/ns/node'), ('~/chatter', '/ns/node/chatter'),
    ('a/{node}/b', '/ns/a/node/b'), ('{ns}/b', '/ns/b'), ('{namespace}/b', '/ns/b')])
def test_expanding_a_topic(ros, topic, expanded):
    assert expand_topic_name(topic, 'node', '/ns') == expanded
    node = ros.node('node', namespace='/ns')
    assert node.create_publisher(Log, topic, 1).topic_name == expanded
    assert node.create_subscription(Log, topic, print, 1).topic_name == expanded
    assert node.resolve_topic_name(topic) == node.resolve_service_name(topic) == expanded


@pytest.mark.parametrize('name, why, where', [
    ('', 'topic name must not be empty string', 0),
    ('a/', 'topic name must not end with a forward slash', 1),
    ('ab?', "topic name must not contain characters other than alphanumerics, '_', '~', '{', or '}'", 2),
    ('a/1', 'topic name token must not start with a number', 2),
    ('a}', "topic name must not have unmatched (unbalanced) curly braces '{}'", 1),
    ('a~', "topic name must not have tilde '~' unless it is the first character", 1),
    ('~ab', "topic name must not have a tilde '~' that is not followed by a forward slash '/'", 1),
    ('{a-}', "substitution name must not contain characters other than alphanumerics or '_'", 2),
    ('{1}', 'substitution name must not start with a number', 1)])
def test_words_and_place_of_a_flaw(name, why, where):
    assert layer.rclpy_get_validation_error_for_topic_name(name) == (why, where)
    with pytest.raises(InvalidTopicNameException):
        validate_topic_name(name)


def test_remapping_name_and_namespace(ros):
    ros.init('-r', '__node:=other', '-r', '__ns:=/there')
    node = ros.node('node', namespace='/here')
    assert (node.get_name(), node.get_namespace()) == ('other', '/there')
    assert ros.node('free', use_global_arguments=False).get_fully_qualified_name() == '/free'


def test_a_rule_may_be_for_one_node_and_a_nodes_own_rules_go_first(ros):
    ros.init('-r', 'left:__ns:=/l', '-r', 'right:chatter:=talk', '-r', '/x:=/y')
    assert ros.node('left').get_namespace() == '/l'
    right = ros.node('right', cli_args=['--ros-args', '-r', '/x:=/z'])
    assert right.get_namespace() == '/'
    assert right.resolve_topic_name('chatter') == '/talk'
    assert right.resolve_topic_name('x') == '/z'
    assert ros.nodes[0].resolve_topic_name('/x') == '/y'
    assert right.resolve_topic_name('x', only_expand=True) == '/x'


def test_rules_for_a_node_know_it_by_its_new_name(ros):
    ros.init('-r', 'old:__node:=new', '-r', 'old:__ns:=/old', '-r', 'new:__ns:=/new')
    assert ros.node('old').get_fully_qualified_name() == '/new/new'


def test_topics_and_services_can_have_rules_of_their_own(ros):
    ros.init('-r', 'rostopic://a:=topic', '-r', 'rosservice://a:=service', '-r', '~/b:=~/c')
    node = ros.node('n', namespace='/ns')
    assert node.create_publisher(Log, 'a', 1).topic_name == '/ns/topic'
    assert node.create_service(GetParameters, 'a', print).service_name in ('a', '/ns/service')
    assert node.resolve_service_name('a') == '/ns/service'
    assert node.resolve_topic_name('~/b') == node.resolve_service_name('n/b') == '/ns/n/c'
