"""Who asks for whose parameters: the graph is the real one, and its picture tells the same in words."""

from rclpy.node import Node

from param_tutorial import ParameterClient
from param_tutorial.nodes.param_event_monitor import ParamEventMonitor
from param_tutorial.nodes.param_query_node import ParamQueryNode
from param_tutorial.views import node_graph
from param_tutorial.views.drawing.ros_graph import NodeGraph
from tests.support.drawings import labels, parsed

GRAPH = NodeGraph(serves=['/b', '/a'], asks=[('/b', '/a'), ('me', '/a'), ('me', '/gone')], tells=['/a', '/b'],
                  listens=['/b'])


def test_a_graph_tells_in_words_what_it_draws():
    assert repr(GRAPH).splitlines() == [
        'offer parameter services: /a, /b', '/b asks: /a', 'me asks: /a, /gone', 'asked for, and not there: /gone',
        'publish on /parameter_events: /a, /b', 'listen to /parameter_events: /b']
    assert parsed(GRAPH).get('aria-label') == '. '.join(repr(GRAPH).splitlines())
    boxes = [text for text in labels(GRAPH) if text.startswith('/') or text == 'me']
    assert sorted(boxes) == ['/a', '/b', '/b', '/b', '/gone', '/parameter_events', 'me']


def test_each_relation_has_its_arrow_and_what_is_not_there_is_dashed():
    # Three questions, two publishers, one listener.
    assert len(list(parsed(GRAPH).iter('polygon'))) == 6
    assert sum('stroke-dasharray' in box.attrib for box in parsed(GRAPH).iter('rect')) == 1


def test_names_are_text_and_an_empty_graph_is_drawn_too():
    graph = NodeGraph(serves=['/<b>'], asks=[('"', '/<b>')], tells=['/<b>'], listens=['&'])
    assert {'/<b>', '"', '&'} <= set(labels(graph))
    empty = NodeGraph(serves=[], asks=[], tells=[], listens=[])
    assert '/parameter_events' in labels(empty) and 'nobody' in repr(empty)


# -- the real graph ------------------------------------------------------------------------------------------

def test_the_graph_is_what_is_connected(ros, weather):
    ros.add(ParamEventMonitor)
    query = ros.add(ParamQueryNode)
    ParameterClient(weather).list_parameters()
    graph = node_graph()
    assert {'/weather', '/param_event_monitor', '/param_query_node'} <= set(graph.serves)
    assert {'/param_event_monitor', 'this notebook'} <= set(graph.listens)
    assert {('this notebook', '/weather'), ('/param_query_node', '/simple_param_node')} <= set(graph.asks)
    assert '/simple_param_node' in graph.missing
    ros.remove(query)
    assert '/param_query_node' not in node_graph().askers


def test_a_hidden_node_is_not_missed_either(ros, weather):
    ros.add(Node, '_corner')
    ParameterClient('/_corner').list_parameters()
    assert '_corner' not in repr(node_graph())
