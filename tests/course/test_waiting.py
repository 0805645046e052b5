"""Which callback may wait for an answer, and in which executor: what chapter 5.3 says of `await` and callback groups.

Each in a context of its own, as a program of its own would run it.
"""

import contextlib
import threading

import pytest
import rclpy
from rcl_interfaces.srv import SetParameters
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.context import Context
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.task import Future

from param_tools.ros import domain

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
    ('call', 'other', None, MULTI, False), ('call', 'other', 'timer', SINGLE, False),
    ('call', 'other', 'timer', MULTI, True), ('call', 'other', 'client', MULTI, True),
    ('await_', 'other', None, MULTI, False), ('await_', 'other', 'timer', SINGLE, True),
    ('await_', 'other', 'client', SINGLE, True),
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
