"""Ghosts: names that rmw keeps in the graph after their process has ended are no nodes, for any of our tools.

A real one comes once in some thirty ends of a process on a busy machine, and none can be had for the asking: its last
message has to lose a race within Fast DDS. So a ghost's names are added to what rmw lists, and all else is real.
"""

import io
import math

import pytest
from rcl_interfaces.srv import ListParameters
from rclpy.node import Node

import param_tutorial
from param_tools.cli import command
from param_tools.ros import graph, waiting
from param_tutorial import wait_until
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from param_tutorial.views import node_graph


@pytest.fixture
def haunted(ros, monkeypatch):
    """Return an executor that has run for a while, and whose rmw lists two ghosts, one with the robot's name."""
    list_also(monkeypatch, ros, 'ghost', 'simple_param_node')
    monkeypatch.setitem(graph._arrivals, ros.tool_node, -graph._UNHEARD_SEC)
    return ros


def list_also(monkeypatch, ros, *names):
    """Let rmw list some names about which nothing else is known."""
    listed = ros.tool_node.get_node_names_and_namespaces
    monkeypatch.setattr(ros.tool_node, 'get_node_names_and_namespaces',
                        lambda: [*((name, '/') for name in names), *listed()])


def shown(ros, *words):
    """Type a command, and return what it prints."""
    printed = io.StringIO()
    command.main(words, stdout=printed, stderr=printed, get_executor=lambda: ros, in_notebook=True)
    return printed.getvalue()


def test_a_ghost_is_no_node(haunted):
    assert haunted.services.node_names() == []
    assert '/ghost' not in haunted.services.node_names(hidden=True)
    assert shown(haunted, 'node', 'list') == ''
    assert shown(haunted, 'param', 'get', '/ghost', 'x') == 'Node not found\n'
    assert node_graph().serves == []


def test_a_node_beside_a_ghost_of_its_name_is_one(haunted):
    haunted.add(SimpleParamNode)
    assert haunted.services.node_names() == ['/simple_param_node']
    assert shown(haunted, 'node', 'list') == '/simple_param_node\n'
    assert node_graph().serves == ['/simple_param_node']


def test_a_process_that_has_lived_long_does_not_wait_for_a_ghost_even_when_it_looks_for_the_first_time(monkeypatch):
    param_tutorial.stop()
    ros = param_tutorial.start()
    list_also(monkeypatch, ros, 'ghost')
    later = waiting.machine_time() + graph._UNHEARD_SEC + 1.0
    monkeypatch.setattr(graph, 'machine_time', lambda: later)
    assert graph.is_complete(ros.tool_node)


def test_a_node_whose_name_comes_first_is_waited_for(ros, monkeypatch):
    """A new process hears of such a name from one that has run for a while."""
    monkeypatch.setattr(graph, '_LEFT_SEC', 0.0)
    list_also(monkeypatch, ros, 'simple_param_node')
    looks = []

    def is_ready():
        looks.append(1)
        if len(looks) == 5:
            ros.add(SimpleParamNode)
        return ros.services.is_ready('/simple_param_node', 'list_parameters')

    assert graph.wait_for_service(is_ready, '/simple_param_node', 'list_parameters', ros.tool_node)


def test_what_a_new_process_has_not_heard_of_a_node_counts_as_missing(ros, monkeypatch):
    monkeypatch.setitem(graph._arrivals, ros.tool_node, math.inf)  # new for as long as this test takes
    wait_until(lambda: graph.is_complete(ros.tool_node), 'all to be known')
    list_also(monkeypatch, ros, 'simple_param_node')
    assert not graph.is_complete(ros.tool_node)
    ros.add(SimpleParamNode)
    assert graph.is_complete(ros.tool_node)


def test_a_node_without_parameter_events_is_one_as_long_as_it_has_anything(ros):
    """Like a node written for rcl, or for rclcpp with that publisher turned off."""
    node = ros.add(Node, 'plain', start_parameter_services=False, enable_rosout=False,
                   ros_args=['-p', 'start_type_description_service:=false'])
    assert ros.services.node_names() == ['/plain']
    ros.run(lambda: node.destroy_publisher(node._parameter_event_publisher), 'take its publisher away')
    # The executor may still hold the publisher, which is destroyed once nothing holds it.
    wait_until(lambda: ros.services.node_names() == [], 'its end')
    ros.run(lambda: node.create_service(ListParameters, 'list', print), 'give it a service')
    assert ros.services.node_names() == ['/plain']
