"""Which callback may wait for an answer, and in which executor: what chapter 5.3 says of `await` and callback groups.

Each in a context of its own, as a program of its own would run it.
"""

import contextlib
import threading

import pytest
import rclpy
from rcl_interfaces.msg import ParameterEvent
from rcl_interfaces.srv import GetParameters, SetParameters
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.context import Context
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.task import Future

from param_tools.ros import domain
from param_tutorial import wait_until

LIMIT_SEC = {True: 60.0, False: 1.5}
"""How long an answer may take: where one is expected, and where none is."""


class Asking(Node):
    """Sets a parameter through a service, in a timer's callback that waits for the answer."""

    def __init__(self, context, tick, asks, own_group, is_expected):
        super().__init__('asking', context=context)
        self.declare_parameter('speed', 1)
        self.limit_sec = LIMIT_SEC[is_expected]
        self.is_asked, self.is_answered = threading.Event(), threading.Event()
        groups = {own_group: MutuallyExclusiveCallbackGroup()}
        self.client = self.create_client(
            SetParameters, f'/{asks}/set_parameters', callback_group=groups.get('client'))
        self.timer = self.create_timer(0.01, getattr(self, tick), callback_group=groups.get('timer'))

    def ask(self):
        self.timer.cancel()
        self.is_asked.set()
        return SetParameters.Request(parameters=[Parameter('speed', value=2).to_parameter_msg()])

    def call(self):
        if self.client.service_is_ready() and self.client.call(self.ask(), timeout_sec=self.limit_sec):
            self.is_answered.set()

    async def await_(self):
        if self.client.service_is_ready() and await self.client.call_async(self.ask()):
            self.is_answered.set()


class Other(Node):
    """The node that is asked."""

    def __init__(self, context):
        super().__init__('other', context=context)
        self.declare_parameter('speed', 1)


@contextlib.contextmanager
def spinning(executor_class, make_node, **options):
    """Spin a node in a context and a thread of its own, and yield it."""
    context = Context()
    rclpy.init(context=context, domain_id=domain.choose())
    node = make_node(context)
    executor = executor_class(context=context, **options)
    executor.add_node(node)
    # Not spin(): if it is shut down while its thread is about to wait, that of rclpy 7.1.6 raises an AttributeError.
    end = Future()
    thread = threading.Thread(target=executor.spin_until_future_complete, args=[end])
    thread.start()
    try:
        yield node
    finally:
        end.set_result(None)
        thread.join()
        executor.shutdown()
        node.destroy_node()
        context.try_shutdown()


SINGLE, MULTI = (SingleThreadedExecutor, {}), (MultiThreadedExecutor, {'num_threads': 2})


@pytest.mark.slow
@pytest.mark.parametrize(('tick', 'asks', 'own_group', 'executor', 'expected'), [
    ('call', 'other', None, SINGLE, False), ('call', 'other', None, MULTI, False),
    ('call', 'other', 'timer', SINGLE, False), ('call', 'other', 'timer', MULTI, True),
    ('call', 'other', 'client', SINGLE, False), ('call', 'other', 'client', MULTI, True),
    ('await_', 'other', None, SINGLE, False), ('await_', 'other', None, MULTI, False),
    ('await_', 'other', 'timer', SINGLE, True), ('await_', 'other', 'timer', MULTI, True),
    ('await_', 'other', 'client', SINGLE, True), ('await_', 'other', 'client', MULTI, True),
    # The services of a node that asks itself are in the default group, too.
    ('await_', 'asking', 'timer', SINGLE, True), ('await_', 'asking', 'client', SINGLE, False),
])
def test_a_callback_that_waits_needs_a_second_group_and_a_free_thread(tick, asks, own_group, executor, expected):
    def make(context):
        return Asking(context, tick, asks, own_group, expected)

    executor_class, options = executor
    with spinning(SingleThreadedExecutor, Other), spinning(executor_class, make, **options) as asking:
        assert asking.is_asked.wait(60)
        assert asking.is_answered.wait(asking.limit_sec) is expected


@pytest.mark.parametrize('create', [
    lambda node, group: node.create_timer(60.0, print, callback_group=group),
    lambda node, group: node.create_subscription(ParameterEvent, 'told', print, 10, callback_group=group),
    lambda node, group: node.create_client(GetParameters, 'ask', callback_group=group),
    lambda node, group: node.create_service(GetParameters, 'ask', print, callback_group=group),
], ids=['timer', 'subscription', 'client', 'service'])
def test_what_a_node_creates_belongs_to_its_default_group_unless_another_is_named(ros, create):
    node = ros.add(Node, 'creates')
    assert isinstance(node.default_callback_group, MutuallyExclusiveCallbackGroup)
    assert ros.run(lambda: create(node, None), 'create').callback_group is node.default_callback_group
    group = ReentrantCallbackGroup()
    assert ros.run(lambda: create(node, group), 'create').callback_group is group


class Slow(Node):
    """A service and a subscription whose callbacks await something for a moment."""

    def __init__(self, context=None):
        super().__init__('slow', context=context)
        group = ReentrantCallbackGroup()
        self.has_heard = threading.Event()
        self.create_service(GetParameters, 'ask', self.answer, callback_group=group)
        self.create_subscription(ParameterEvent, 'told', self.hear, 10, callback_group=group)
        self.publisher = self.create_publisher(ParameterEvent, 'told', 10)
        self.client = self.create_client(GetParameters, 'ask', callback_group=group)

    async def moment(self):
        future = Future()
        timer = self.create_timer(0.01, future.cancel)
        await future
        self.destroy_timer(timer)

    async def answer(self, _, response):
        await self.moment()
        return response

    async def hear(self, _):
        await self.moment()
        self.has_heard.set()


def test_services_and_subscriptions_may_await_under_rclpys_own_executor():
    with spinning(SingleThreadedExecutor, Slow) as slow:
        assert slow.client.wait_for_service(60)
        assert slow.client.call(GetParameters.Request(), timeout_sec=60)
        wait_until(slow.publisher.get_subscription_count, 'the subscription')
        slow.publisher.publish(ParameterEvent())
        assert slow.has_heard.wait(60)


# rclpy calls parameter callbacks, and never awaits what an `async def` returns.
@pytest.mark.filterwarnings('ignore:Callback returned an invalid type', 'ignore:coroutine .* was never awaited')
def test_parameter_callbacks_are_not_awaited(ros):
    class Robot(Node):
        def __init__(self):
            super().__init__('robot')
            self.declare_parameter('speed', 1)
            self.has_run = False

        async def callback(self, parameters):
            self.has_run = True

    robot = ros.add(Robot)
    fast = [Parameter('speed', value=2)]
    robot.add_on_set_parameters_callback(robot.callback)
    assert not robot.set_parameters(fast)[0].successful
    robot.remove_on_set_parameters_callback(robot.callback)
    robot.add_post_set_parameters_callback(robot.callback)
    assert robot.set_parameters(fast)[0].successful
    robot.remove_post_set_parameters_callback(robot.callback)
    robot.add_pre_set_parameters_callback(robot.callback)
    with pytest.raises(TypeError, match='not iterable'):
        robot.set_parameters(fast)
    assert not robot.has_run
