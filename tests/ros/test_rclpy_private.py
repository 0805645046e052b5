"""What the tools assume of rclpy beyond its documentation: one test for each assumption, named like it.

If one of these fails with a new rclpy, mend the function in rclpy_private that it calls.
"""

import ast
import re

import pytest
import rclpy
from rcl_interfaces.msg import ParameterDescriptor, SetParametersResult
from rcl_interfaces.srv import GetParameters
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools.ros import rclpy_private
from param_tutorial import ParameterClient, wait_until
from tests.support.paths import PACKAGE, TOOLS


class Lamp(Node):
    """One parameter, and a callback of each kind."""

    def __init__(self):
        super().__init__('lamp')
        self.declare_parameter('watts', 5)
        self.seen = []
        self.add_pre_set_parameters_callback(self.pre)
        self.add_on_set_parameters_callback(self.judge)
        self.add_post_set_parameters_callback(self.post)

    def pre(self, parameters):
        self.seen.append('pre')
        return parameters

    def judge(self, parameters):
        self.seen.append('judge')
        return SetParametersResult(successful=True)

    def post(self, parameters):
        self.seen.append('post')


@pytest.fixture
def lamp(ros):
    return ros.add(Lamp)


@pytest.fixture
def observe(ros, lamp):
    """Return a function that steps in between a lamp and its parameters, and returns the one that steps out again."""
    def observe(call_instead=lambda kind, callback, parameters: callback(parameters),
                publish_instead=lambda publish, event: publish(event), set_instead=None):
        stop = ros.run(lambda: rclpy_private.observe_changes(lamp, call_instead, publish_instead, set_instead),
                       'observe')
        return lambda: ros.run(stop, 'stop observing')
    return observe


@pytest.fixture
def other_context():
    """A context and nodes apart from the stage."""
    context = rclpy.Context()
    rclpy.init(context=context)
    yield context
    rclpy.shutdown(context=context)


class CallsNodeByName(Node):
    def __init__(self):
        Node.__init__(self, 'named')


class CallsSuper(Node):
    def __init__(self):
        super().__init__('named')


@pytest.mark.parametrize('node_class', [CallsNodeByName, CallsSuper])
def test_every_class_of_nodes_gets_to_one_constructor_and_passes_its_arguments_by_name(ros, node_class):
    def turn(node_name, options):
        calls.append(node_name)
        options['cli_args'] = ['--ros-args', '-r', '__node:=turned']

    calls = []
    node = node_class.__new__(node_class)
    with rclpy_private.before_init_of(node, turn):
        node.__init__()
        other = node_class()  # created on the way, as a constructor may
    assert calls == ['named']
    assert (node.get_name(), other.get_name()) == ('turned', 'named')
    node.destroy_node()
    other.destroy_node()


def test_a_handle_is_destroyed_when_its_last_user_has_left(other_context):
    """Here a ``with`` block that does not end stands for the executor that never runs again."""
    node = Node('held', context=other_context)
    observer = Node('observer', context=other_context)
    service = next(node.services)
    service.handle.__enter__()
    wait_until(lambda: 'held' in observer.get_node_names(), 'the node')
    rclpy_private.destroy_by_force(node)
    wait_until(lambda: 'held' not in observer.get_node_names(), 'the node to be gone')
    observer.destroy_node()


@pytest.mark.real_layer(reason='rclpy in Python ends this service with its node')
def test_the_service_get_type_description_outlives_its_node_until_rcl_ends_it(ros):
    def is_there():
        return bool(ros.tool_node.get_subscriptions_info_by_topic(
            'rq/forgotten/get_type_descriptionRequest', no_mangle=True))

    node = Node('forgotten')
    end = rclpy_private.keep_type_description_service(node)
    node.destroy_node()
    # If this fails, rclpy now does it by itself, and the function can be removed.
    assert is_there()
    end()
    wait_until(lambda: not is_there(), 'the service to go')


def test_a_declaration_takes_its_override_from_the_nodes_own_dictionary(ros):
    node = ros.add(Node, 'empty', ros_args=['-p', 'old:=7'])
    overrides = rclpy_private.pending_overrides(node)
    overrides['new'] = Parameter('new', value=overrides.pop('old').value)
    assert ros.run(lambda: [node.declare_parameter(name, 1).value for name in ('new', 'old')], 'declare') == [7, 1]


def test_what_is_written_into_the_own_descriptor_is_described(ros):
    node = ros.add(Node, 'empty')
    ros.run(lambda: node.declare_parameter('serial', 'A', ParameterDescriptor(read_only=True)), 'declare')
    rclpy_private.own_descriptor(node, 'serial').additional_constraints = 'one letter'
    assert ParameterClient(node).describe_parameter('serial').additional_constraints == 'one letter'


def test_parameter_callbacks_are_called_by_going_through_three_lists(lamp, observe):
    calls = []

    def call_instead(kind, callback, parameters):
        calls.append((kind, callback))
        return callback(parameters)

    stop = observe(call_instead)
    ParameterClient(lamp).set_parameter('watts', 6)
    stop()
    ParameterClient(lamp).set_parameter('watts', 7)
    assert [call for call in calls if getattr(call[1], '__self__', None) is lamp] == [
        ('pre-set', lamp.pre), ('on-set', lamp.judge), ('post-set', lamp.post)]
    assert lamp.seen == ['pre', 'judge', 'post'] * 2


def test_a_parameter_event_is_published_through_the_nodes_own_publisher(lamp, observe):
    events = []
    stop = observe(publish_instead=lambda publish, event: events.append(event))
    ParameterClient(lamp).set_parameter('watts', 6)
    stop()
    ParameterClient(lamp).set_parameter('watts', 7)
    assert [event.changed_parameters[0].value.integer_value for event in events] == [6]


def test_every_set_goes_through_one_method_of_the_node_and_no_declaration_does(ros, lamp, observe):
    asked = []

    def set_instead(set_parameters, parameters):
        asked.append([each.value for each in parameters])
        return set_parameters(parameters)

    stop = observe(set_instead=set_instead)
    ParameterClient(lamp).set_parameter('watts', 6)
    ParameterClient(lamp).set_parameters_atomically({'watts': 7})
    ros.run(lambda: lamp.set_parameters([Parameter('watts', value=8)]), 'set')
    ros.run(lambda: lamp.declare_parameter('volts', 230), 'declare')
    stop()
    ParameterClient(lamp).set_parameter('watts', 9)
    assert asked == [[6], [7], [8]]


def test_these_three_are_all_that_a_second_program_needs_of_its_own(other_context, monkeypatch):
    stage = rclpy.utilities.get_default_context()
    for owner, name, value in rclpy_private.process_globals():
        monkeypatch.setattr(owner, name, value)
    context = rclpy.utilities.get_default_context()
    assert context is not stage
    context.init([])
    assert rclpy.context.g_logging_ref_count == 1
    executor = rclpy.get_global_executor()
    assert executor.context is context
    context.shutdown()
    assert rclpy.utilities.g_default_context is context
    assert rclpy.__dict__['__executor'] is None


@pytest.mark.slow
def test_no_other_file_uses_private_names_of_rclpy(ros, lamp):
    client = lamp.create_client(GetParameters, '/nobody/get_parameters')
    private = {name for thing in (lamp, client, lamp._parameter_service, rclpy.task.Future(), *lamp.services)
               for name in dir(thing) if re.match('_[^_]', name)}
    private.remove('_lock')  # a name that classes of ours use as well
    assert {'_parameters', '_pending_requests', '_get_node'} <= private
    found = []
    for path in [*PACKAGE.rglob('*.py'), *TOOLS.rglob('*.py')]:
        if path.name == 'rclpy_private.py':
            continue
        for step in ast.walk(ast.parse(path.read_text())):
            # What a class keeps in self belongs to it.
            if (isinstance(step, ast.Attribute) and step.attr in private
                    and ast.unparse(step.value) not in ('self', 'cls')):
                found.append(f'{path.name}: {ast.unparse(step)}')
            elif isinstance(step, ast.Constant) and step.value in private:
                found.append(f'{path.name}: {step.value!r}')
            elif isinstance(step, ast.ImportFrom) and 'rclpy.experimental' in (step.module or ''):
                found.append(f'{path.name}: {step.module}')
    assert found == []
