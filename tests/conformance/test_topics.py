"""Topics: messages by value, what a late subscription gets, and incompatible quality of service."""

import pytest
from builtin_interfaces.msg import Time
from rcl_interfaces.msg import FloatingPointRange, Log, Parameter, ParameterEvent, ParameterValue, SetParametersResult
from rcl_interfaces.srv import GetParameters
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.impl.implementation_singleton import rclpy_implementation as layer
from rclpy.qos import DurabilityPolicy, QoSCompatibility, QoSProfile, ReliabilityPolicy, qos_check_compatible
from rclpy.serialization import deserialize_message, serialize_message

LASTING = QoSProfile(depth=3, durability=DurabilityPolicy.TRANSIENT_LOCAL)


@pytest.fixture
def node(ros):
    return ros.node()


def connected(ros, node, message_type, callback, sent=10, received=10):
    """Return a publisher and a subscription that have found each other."""
    publisher = node.create_publisher(message_type, 'topic', sent)
    subscription = node.create_subscription(message_type, 'topic', callback, received)
    ros.wait(publisher.get_subscription_count)
    ros.wait(subscription.handle.get_publisher_count)
    return publisher, subscription


def test_each_subscription_gets_a_message_of_its_own(ros, node):
    heard = [], []
    publisher, _ = connected(ros, node, ParameterEvent, heard[0].append)
    node.create_subscription(ParameterEvent, 'topic', heard[1].append, 10)
    ros.wait(lambda: publisher.get_subscription_count() == 2)
    message = ParameterEvent(node='/a', stamp=Time(sec=1))
    publisher.publish(message)
    message.node, message.stamp.sec = '/b', 2
    ros.wait(lambda: heard[0] and heard[1])
    assert heard[0] == heard[1] == [ParameterEvent(node='/a', stamp=Time(sec=1))]
    assert heard[0][0] is not heard[1][0]
    assert heard[0][0].stamp is not heard[1][0].stamp


@pytest.mark.parametrize('sent, field, received', [
    (SetParametersResult(reason='ends\0here'), 'reason', 'ends'),
    (ParameterValue(string_array_value=('a', 'b')), 'string_array_value', ['a', 'b']),
    (ParameterValue(byte_array_value=b'ab'), 'byte_array_value', [b'a', b'b']),
    (ParameterValue(type=300), 'type', 44),
    (Time(sec=2**31), 'sec', -2**31),
    (ParameterValue(integer_value=True), 'integer_value', 1),
    (SetParametersResult(successful=1), 'successful', False),
    (Time(nanosec=2**32 - 1), 'nanosec', 2**32 - 1)])
def test_a_message_arrives_as_its_type_says(ros, node, sent, field, received):
    heard = []
    publisher, _ = connected(ros, node, type(sent), heard.append)
    publisher.publish(sent)
    ros.wait(lambda: heard)
    value = getattr(heard[0], field)
    assert (value, type(value)) == (received, type(received))


def test_a_late_subscription_gets_what_lasts(ros, node):
    publisher = node.create_publisher(Time, 'topic', LASTING)
    for number in range(5):
        publisher.publish(Time(sec=number))
    late, too_late = [], []
    node.create_subscription(Time, 'topic', late.append, QoSProfile(
        depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL))
    node.create_subscription(Time, 'topic', too_late.append, 10)
    ros.wait(lambda: len(late) == 3 and publisher.get_subscription_count() == 2)
    publisher.publish(Time(sec=5))
    ros.wait(lambda: too_late and len(late) == 4)
    assert [each.sec for each in late] == [2, 3, 4, 5]
    assert [each.sec for each in too_late] == [5]


BEST_EFFORT = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
FAST = QoSProfile(depth=1, deadline=Duration(seconds=1))
SLOW = QoSProfile(depth=1, deadline=Duration(seconds=2))


@pytest.mark.parametrize('offered, requested, policy', [
    (BEST_EFFORT, QoSProfile(depth=1), 'RELIABILITY'),
    (QoSProfile(depth=1), LASTING, 'DURABILITY'),
    (SLOW, FAST, 'DEADLINE'),
    (QoSProfile(depth=1), FAST, 'DEADLINE'),
    (BEST_EFFORT, LASTING, 'RELIABILITY')])
def test_incompatible_quality_of_service(ros, node, offered, requested, policy):
    heard = []
    publisher = node.create_publisher(Time, 'topic', offered, event_callbacks=PublisherEventCallbacks(
        incompatible_qos=heard.append))
    node.create_subscription(Time, 'topic', print, requested, event_callbacks=SubscriptionEventCallbacks(
        incompatible_qos=heard.append))
    ros.wait(lambda: len(heard) == 2)
    for status in heard:
        assert (status.total_count, status.total_count_change) == (1, 1)
        assert int(status.last_policy_kind) == int(getattr(layer.rmw_qos_policy_kind_t, f'RMW_QOS_POLICY_{policy}'))
    assert publisher.get_subscription_count() == 0
    assert node.count_subscribers('/topic') == 1
    assert qos_check_compatible(offered, requested)[0] == QoSCompatibility.ERROR


def test_a_topic_and_a_service_have_one_type_in_a_context(node):
    node.create_publisher(Time, 'topic', 1)
    with pytest.raises(layer.RCLError):
        node.create_publisher(Log, 'topic', 1)
    with pytest.raises(layer.RCLError):
        node.create_subscription(Log, 'topic', print, 1)
    for create in (node.create_client, lambda *given: node.create_service(*given, print)):
        with pytest.raises(layer.RCLError, match=(
                r'failed to create (\w+): create_\1\(\) called for existing request topic name rq/node/'
                'set_parametersRequest with incompatible type rcl_interfaces::srv::dds_::GetParameters_Request_')):
            create(GetParameters, 'node/set_parameters')


@pytest.mark.parametrize('message', [
    SetParametersResult(reason=5), SetParametersResult(reason='\ud800'), ParameterEvent(new_parameters=5),
    ParameterEvent(stamp=None), ParameterValue(string_array_value=['a', 5])])
def test_a_message_that_cannot_be_sent(node, message):
    publisher = node.create_publisher(type(message), 'topic', 1)
    for attempt in (publisher.publish, serialize_message):
        with pytest.raises((TypeError, AttributeError, UnicodeEncodeError)):
            attempt(message)


def test_messages_as_bytes(ros, node):
    event = ParameterEvent(node='/ä', stamp=Time(sec=-1, nanosec=2), new_parameters=[Parameter(name='a')])
    assert deserialize_message(serialize_message(event), ParameterEvent) == event
    # Where rclpy takes an integer for a double, it is hardly more than zero.
    given = FloatingPointRange()
    given._to_value = 16
    assert 0.0 < deserialize_message(serialize_message(given), FloatingPointRange).to_value < 1e-300
    with pytest.raises(layer.RMWError):
        deserialize_message(b'\0\1\0\0\1', Time)
