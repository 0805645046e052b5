"""The list of nodes: which there are, what they have, what a search finds, and the panels that are opened."""

import pytest
from rclpy.node import Node

from param_tools.node.client import ParameterClient
from param_tools.ros.waiting import wait_until
from param_tutorial import ParameterPanel
from tests.support.nodes import Arm, Gate
from tests.support.widgets import press


class Fan(Node):
    def __init__(self, name='fan'):
        super().__init__(name)
        self.declare_parameter('blades', 3)
        self.declare_parameter('maker', 'Breeze & Sons')


@pytest.fixture
def shown(ros):
    """Return a list of the nodes on the stage, of which each has been read."""
    ros.add(Arm)
    ros.add(Fan)
    browser = ParameterPanel()
    wait_until(lambda: says(browser) == {'/arm': '22 parameters', '/fan': '4 parameters'}, 'the nodes to be read')
    return browser


def lines(browser):
    return {each['name']: each for each in browser._front.state['nodes']}


def says(browser):
    return {name: each['says'] for name, each in lines(browser).items()}


def test_nodes_come_and_go_and_come_back_as_others(ros, shown):
    class Bigger(Fan):
        def __init__(self):
            super().__init__()
            self.declare_parameter('size_m', 0.4)

    ros.add(Gate)
    wait_until(lambda: says(shown).get('/gate') == '4 parameters', 'the new node')
    ros.add(Bigger)
    wait_until(lambda: says(shown).get('/fan') == '5 parameters', 'the successor')
    ros.remove_all()
    wait_until(lambda: shown._front.state == {'status': '0 nodes', 'nodes': []}, 'all to be gone')


def test_a_search_looks_at_names_descriptions_and_present_values(shown):
    assert shown.find('breeze') == {'/fan': ['maker']}
    assert shown.find('fan BLADES') == {'/fan': ['blades']}
    assert shown.find('nothing like it') == {}
    press(shown, 'find', text='gains')
    wait_until(lambda: lines(shown).keys() == {'/arm'}, 'the search')
    assert lines(shown)['/arm']['hits'] == [['gains.kp', '0.3'], ['gains.ki', '0.0']]
    assert shown._front.state['status'] == '2 nodes, 2 parameters found in 1'
    ParameterClient('/fan').set_parameter('maker', 'Gains Inc')
    wait_until(lambda: lines(shown).keys() == {'/arm', '/fan'}, 'the new value to be found')


def test_a_panel_is_opened_and_shut(shown):
    press(shown, 'toggle', node='/fan')
    panel = shown['/fan']
    wait_until(lambda: 'blades' in panel, 'the panel to read the node')
    assert panel in shown._box.children
    wait_until(lambda: lines(shown)['/fan']['is_open'], 'the mark')
    assert shown.show('/fan') is panel
    press(shown, 'open', node='/arm', search='gains.kp')
    assert shown['/arm']._front.search == 'gains.kp'
    press(shown, 'toggle', node='/fan')
    with pytest.raises(KeyError):
        shown['/fan']
    assert repr(panel) == '<ParameterPanel: /fan, closed>'
    shown.close()
    assert repr(shown) == '<ParameterBrowser: closed>'


def test_the_first_node_is_opened_for_who_asks_for_that_and_only_once(ros, shown):
    page = ParameterPanel(open_first=True)
    wait_until(lambda: lines(page)['/arm']['is_open'], 'the first node to be opened')
    assert [each['is_open'] for view in (page, shown) for each in lines(view).values()] == [True, False, False, False]
    press(page, 'toggle', node='/arm')
    wait_until(lambda: not lines(page)['/arm']['is_open'], 'it to be shut')


def test_the_panel_of_a_node_that_has_gone_can_still_be_shut(ros, shown):
    press(shown, 'toggle', node='/fan')
    press(shown, 'toggle', node='/arm')
    ros.remove('/fan')
    wait_until(lambda: says(shown) == {'/arm': '22 parameters', '/fan': 'not in the graph'}, 'the list to say so')
    assert lines(shown)['/fan']['is_open']
    assert shown._front.state['status'] == '1 node'
    press(shown, 'toggle', node='/fan')
    wait_until(lambda: says(shown) == {'/arm': '22 parameters'}, 'its line to go')


def test_a_node_that_hangs_keeps_no_other_one_waiting(ros):
    gate = ros.add(Gate)
    ros.add(Fan)
    ros.add(Node, 'silent', start_parameter_services=False)
    browser = ParameterPanel(timeout_sec=0.5)
    wait_until(lambda: says(browser).get('/fan') == '4 parameters', 'the other one')
    wait_until(lambda: lines(browser)['/silent']['is_bad'], 'the silent one to be given up')
    assert 'offers no' in says(browser)['/silent']
    gate.open.release()
