"""Topics: messages by value, queues, quality of service, what each end hears of the other, and raw handles."""

import pytest
from builtin_interfaces.msg import Time
from rcl_interfaces.msg import (
    FloatingPointRange,
    Log,
    Parameter,
    ParameterDescriptor,
    ParameterEvent,
    ParameterValue,
    SetParametersResult,
)
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.impl.implementation_singleton import rclpy_implementation as layer
from rclpy.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    QoSCompatibility,
    QoSProfile,
    ReliabilityPolicy,
    qos_check_compatible,
    qos_profile_best_available,
    qos_profile_sensor_data,
    qos_profile_system_default,
)
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


@pytest.mark.parametrize('message', [
    SetParametersResult(reason=5), SetParametersResult(reason='\ud800'), ParameterEvent(node=None),
    ParameterEvent(new_parameters=5), ParameterEvent(stamp=None), ParameterValue(string_array_value=['a', 5])])
def test_a_message_that_cannot_be_sent(node, message):
    publisher = node.create_publisher(type(message), 'topic', 1)
    with pytest.raises((TypeError, AttributeError, UnicodeEncodeError)):
        publisher.publish(message)
    with pytest.raises(TypeError):
        publisher.publish(Time())


def test_a_sequence_that_is_too_long(node):
    publisher = node.create_publisher(ParameterDescriptor, 'topic', 1)
    too_long = ParameterDescriptor(integer_range=[ParameterDescriptor().integer_range] * 2)
    with pytest.raises((layer.RCLError, AttributeError)):
        publisher.publish(too_long)


def test_a_queue_keeps_the_newest(ros, node):
    publisher, subscription = connected(ros, node, Time, print, received=2)
    for number in range(5):
        publisher.publish(Time(sec=number))
    with subscription.handle:
        assert publisher.wait_for_all_acked(Duration(seconds=30))
        # Left to itself, the middleware may take a moment for what has been acknowledged.
        taken = []
        while len(taken) < 2:
            if message := subscription.handle.take_message(Time, False):
                taken.append(message)
        assert [message.sec for message, _ in taken] == [3, 4]
        assert subscription.handle.take_message(Time, False) is None
    assert taken[0][1]['source_timestamp'] <= taken[1][1]['received_timestamp']
    assert taken[0][1].keys() == {'source_timestamp', 'received_timestamp', 'publication_sequence_number',
                                  'reception_sequence_number'}


def test_keep_all(ros, node):
    heard = []
    everything = QoSProfile(history=HistoryPolicy.KEEP_ALL, reliability=ReliabilityPolicy.RELIABLE)
    publisher, _ = connected(ros, node, Time, heard.append, everything, everything)
    for number in range(30):
        publisher.publish(Time(sec=number))
    ros.wait(lambda: len(heard) == 30)
    assert [each.sec for each in heard] == [*range(30)]


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


@pytest.mark.parametrize('offered, requested', [
    (10, qos_profile_sensor_data), (LASTING, 10), (FAST, SLOW), (10, qos_profile_system_default),
    (qos_profile_sensor_data, qos_profile_best_available), (qos_profile_best_available, LASTING),
    (qos_profile_system_default, QoSProfile(depth=1))])
def test_compatible_quality_of_service(ros, node, offered, requested):
    heard = []
    publisher, _ = connected(ros, node, Time, heard.append, offered, requested)
    publisher.publish(Time(sec=7))
    ros.wait(lambda: heard)


def test_each_end_hears_of_the_other(ros, node):
    heard = {'publisher': [], 'subscription': []}
    publisher = node.create_publisher(Time, 'topic', 1, event_callbacks=PublisherEventCallbacks(
        matched=heard['publisher'].append))
    subscription = node.create_subscription(Time, 'topic', print, 1, event_callbacks=SubscriptionEventCallbacks(
        matched=heard['subscription'].append))
    ros.wait(lambda: all(heard.values()))
    node.destroy_subscription(subscription)
    ros.wait(lambda: len(heard['publisher']) == 2)
    found = [(each.total_count, each.total_count_change, each.current_count, each.current_count_change)
             for each in heard['publisher']]
    assert found == [(1, 1, 1, 1), (1, 0, 0, -1)]
    assert publisher.get_subscription_count() == 0


def test_a_topic_has_one_type_in_a_context(node):
    node.create_publisher(Time, 'topic', 1)
    with pytest.raises(layer.RCLError):
        node.create_publisher(Log, 'topic', 1)
    with pytest.raises(layer.RCLError):
        node.create_subscription(Log, 'topic', print, 1)


def test_another_type_in_another_context(ros, node):
    heard = []
    publisher = node.create_publisher(Time, 'topic', 1, event_callbacks=PublisherEventCallbacks(
        incompatible_type=heard.append))
    other = type(ros)()
    other.context.init(['program'], domain_id=node.context.get_domain_id())
    there = layer.Node('there', '', other.context.handle, None, True, True)
    subscription = layer.Subscription(there, Log, '/topic', None)
    ros.wait(lambda: len(dict(node.get_topic_names_and_types()).get('/topic', ())) == 2)
    assert dict(node.get_topic_names_and_types())['/topic'] == ['builtin_interfaces/msg/Time', 'rcl_interfaces/msg/Log']
    assert publisher.get_subscription_count() == 0
    subscription.destroy_when_not_in_use()
    there.destroy_when_not_in_use()
    other.context.shutdown()


def test_a_callback_may_want_to_know_when(ros, node):
    heard = []
    publisher = node.create_publisher(Time, 'topic', 1)
    node.create_subscription(Time, 'topic', lambda message, info: heard.append(info), 1)
    ros.wait(publisher.get_subscription_count)
    publisher.publish(Time())
    ros.wait(lambda: heard)
    assert 0 < heard[0]['source_timestamp'] <= heard[0]['received_timestamp']


EVENT = ParameterEvent(node='/ä', stamp=Time(sec=-1, nanosec=2), new_parameters=[
    Parameter(name=name, value=ParameterValue(type=index, **{f'{name}_value': value}))
    for index, (name, value) in enumerate((
        ('bool', True), ('integer', -2**63), ('double', 0.1), ('string', 'text'), ('byte_array', [b'a', b'\xff']),
        ('bool_array', [True, False]), ('integer_array', [1, 2]), ('double_array', [0.5]),
        ('string_array', ['', 'b'])))])


def test_messages_as_bytes():
    assert serialize_message(Time(sec=1, nanosec=2)) == b'\0\1\0\0\1\0\0\0\2\0\0\0'
    assert deserialize_message(b'\0\1\0\0\1\0\0\0\2\0\0\0', Time) == Time(sec=1, nanosec=2)
    # What the real one leaves between two values is anything.
    assert serialize_message(SetParametersResult(successful=True, reason='abc'))[8:16] == b'\4\0\0\0abc\0'
    assert deserialize_message(serialize_message(EVENT), ParameterEvent) == EVENT
    with pytest.raises(layer.RMWError):
        deserialize_message(b'\0\1\0\0\1', Time)


def test_a_raw_subscription_and_a_message_in_bytes(ros, node):
    heard, raw = [], []
    publisher, _ = connected(ros, node, ParameterEvent, heard.append)
    node.create_subscription(ParameterEvent, 'topic', raw.append, 10, raw=True)
    ros.wait(lambda: publisher.get_subscription_count() == 2)
    publisher.publish(serialize_message(EVENT))
    ros.wait(lambda: heard and raw)
    assert heard == [EVENT]
    assert deserialize_message(raw[0], ParameterEvent) == EVENT


def test_what_a_wait_set_rejects(ros, node):
    publisher, subscription = connected(ros, node, Time, print)
    with ros.context.handle, subscription.handle:
        with pytest.raises(layer.RCLError, match='wait set is empty'):
            layer.WaitSet(0, 0, 0, 0, 0, 0, ros.context.handle).wait(0)
        waits = layer.WaitSet(1, 0, 0, 0, 0, 0, ros.context.handle)
        index = waits.add_subscription(subscription.handle)
        with pytest.raises(layer.RCLError, match='is full'):
            waits.add_subscription(subscription.handle)
        waits.wait(0)
        assert not waits.is_ready('subscription', index)
        assert waits.get_ready_entities('subscription') == []
        publisher.publish(Time())
        waits.clear_entities()
        index = waits.add_subscription(subscription.handle)
        waits.wait(30 * 10**9)
        assert waits.is_ready('subscription', index)
        assert waits.get_ready_entities('subscription') == [subscription.handle.pointer]
        with pytest.raises(IndexError):
            waits.is_ready('subscription', 1)
        for kind in ('nothing', 'event'):
            with pytest.raises(RuntimeError):
                waits.is_ready(kind, 0)


def test_an_integer_in_the_place_of_a_double_is_hardly_more_than_zero():
    given = FloatingPointRange()
    given._to_value = 16
    sent = deserialize_message(serialize_message(given), FloatingPointRange)
    assert 0.0 < sent.to_value < 1e-300
