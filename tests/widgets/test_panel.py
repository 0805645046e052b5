"""The parameter panel, on real nodes and without a browser.

What a person does in the browser arrives as a message; ``enter`` and ``slide`` send just that.
"""

import html
import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from rcl_interfaces.msg import SetParametersResult
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools import values
from param_tools.errors import ParameterNotDeclaredError
from param_tools.node.client import ParameterClient
from param_tools.node.rules import Rules
from param_tools.panel.panel import ParameterPanel
from param_tools.ros import stage
from param_tools.ros.waiting import wait_until
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from tests.support.nodes import Arm, Band, Counter, Gate
from tests.support.processes import standing_still
from tests.support.widgets import enter, is_locked, press, says, shows, slide

NODE = '/arm'


# -- what the node confirmed --------------------------------------------------------------------------


def test_a_rejected_value_springs_back_with_the_nodes_reason_until_the_next_change(ros):
    ros.add(SimpleParamNode)
    panel = ParameterPanel('/simple_param_node')
    control = panel['max_speed_rpm']
    enter(panel, 'max_speed_rpm', '-5')
    panel.settle()
    assert shows(panel, 'max_speed_rpm') == ('100',)
    assert control.value == 100
    assert control.message == 'max_speed_rpm must not be negative, got -5'
    assert says(panel, 'max_speed_rpm') == ('rejected', control.message)
    panel.settle()
    assert control.message == 'max_speed_rpm must not be negative, got -5'
    enter(panel, 'max_speed_rpm', '120')
    panel.settle()
    assert (control.message, shows(panel, 'max_speed_rpm')) == ('', ('120',))
    assert says(panel, 'max_speed_rpm') is None


def test_a_value_that_the_node_changes_is_shown_as_stored(ros):
    class Clamp(Node):
        def __init__(self):
            super().__init__('clamp')
            self.declare_parameter('x', 0)
            self.declare_parameter('deaf', 0)
            self.add_pre_set_parameters_callback(
                lambda all_: [Parameter('x', value=min(each.value, 10)) for each in all_ if each.name == 'x'])

    ros.add(Clamp)
    panel = ParameterPanel('/clamp')
    enter(panel, 'x', '99')
    enter(panel, 'deaf', '5')
    # The test does not call settle: the panel reads back by itself, even if no event reports a change.
    wait_until(lambda: (panel['x'].value, shows(panel, 'x')) == (10, ('10',)), 'what was stored')
    wait_until(lambda: (panel['deaf'].value, shows(panel, 'deaf')) == (0, ('0',)), 'what was stored')
    assert says(panel, 'x') == ('adjusted', 'You asked for 99, and the node has stored 10.')
    ParameterClient('/clamp').set_parameter('x', 3)
    wait_until(lambda: (shows(panel, 'x'), says(panel, 'x')) == (('3',), None), 'the next change')


def test_a_change_made_elsewhere_shows_without_being_asked_for(arm):
    client = ParameterClient(NODE)
    client.set_parameter('joints', 9)
    wait_until(lambda: shows(arm, 'joints') == ('9', 2), 'the panel to follow')
    client.set_parameters({'tool': 'saw', 'enabled': False})
    wait_until(lambda: shows(arm, 'tool') == ('saw',) and shows(arm, 'enabled') == ('false',),
                          'the panel to follow')


def test_a_dynamic_parameter_that_has_become_bytes_still_shows_what_it_was(arm):
    """An empty list is an array of bytes to rclpy, and no number can be written as one."""
    enter(arm, 'payload', '[]')
    arm.settle()
    row = arm._front.state['rows']['payload']
    assert (row['text'], row['first']) == ('[]', '1.5')
    enter(arm, 'tool', 'saw')  # the panel goes on
    arm.settle()
    assert arm['tool'].value == 'saw'


def test_a_parameter_declared_later_appears_and_a_deleted_one_goes(arm):
    arm_node, = stage.current().nodes
    stage.current().run(lambda: arm_node.declare_parameter('gains.kd', 3), 'declare')
    wait_until(lambda: 'gains.kd' in arm, 'the new parameter')
    names = arm.names
    assert names.index('gains.kd') == names.index('gains.ki') + 1
    ParameterClient(NODE).delete_parameter('payload')
    wait_until(lambda: 'payload' not in arm, 'the deleted parameter to go')
    with pytest.raises(ParameterNotDeclaredError, match="has no parameter 'payload'"):
        arm['payload']


# -- a fast hand and a slow node ----------------------------------------------------------------------


def test_a_flood_is_thinned_out_and_its_last_value_arrives(ros):
    node = ros.add(Counter)
    panel = ParameterPanel('/counter')
    for value in range(1, 1001):
        panel['x'].value = value
    panel.settle()
    assert (node.seen[-1], panel['x'].value, shows(panel, 'x')) == (1000, 1000, ('1000',))
    assert len(node.seen) < 500
    assert node.seen == sorted(node.seen)


def test_a_callback_that_raises_is_reported_beside_the_control(ros):
    class Faulty(Node):
        def __init__(self):
            super().__init__('faulty')
            self.declare_parameter('x', 1)
            self.declare_parameter('y', 1)
            self.add_on_set_parameters_callback(self.check)
            self.add_post_set_parameters_callback(self.react)

        def check(self, parameters):
            if parameters[0].name == 'x':
                raise ZeroDivisionError('not <b>that</b> way')
            return SetParametersResult(successful=True)

        def react(self, parameters):
            raise KeyError('too late')

    ros.add(Faulty)
    panel = ParameterPanel('/faulty')
    enter(panel, 'x', '2')
    enter(panel, 'y', '2')
    panel.settle()
    assert 'raised ZeroDivisionError while it served set_parameters: not <b>that</b> way' in panel['x'].message
    assert shows(panel, 'x') == ('1',)
    # Raised after the value was stored: the panel shows what the node has.
    assert 'raised KeyError' in panel['y'].message
    assert shows(panel, 'y') == ('2',)


# -- nodes in processes of their own ------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.real_layer(reason='the node is in another process')
def test_a_node_elsewhere_that_goes_and_comes_back(ros, remote):
    process = remote('comes_and_goes')
    panel = ParameterPanel('comes_and_goes')
    wait_until(lambda: 'x' in panel, 'the panel to find the node', 20)
    enter(panel, 'x', '5')
    panel.settle()
    assert panel['x'].value == 5
    process.stdin.close()
    wait_until(lambda: panel.status, 'the panel to miss the node', 20)
    wait_until(lambda: is_locked(panel, 'x'), 'the control to be locked')
    assert panel.status == '/comes_and_goes is not running. Its controls come back when it does.'
    assert panel._front.state['status'] == panel.status
    assert repr(panel) == '<ParameterPanel: /comes_and_goes, not available>'
    panel['x'].value = 6
    panel.settle()
    assert panel['x'].message.startswith(('there is no node /comes_and_goes', '/comes_and_goes is running but offers'))
    remote('comes_and_goes')
    wait_until(lambda: not panel.status and not is_locked(panel, 'x'), 'the panel to revive', 20)
    assert (panel['x'].value, shows(panel, 'x'), panel['x'].message) == (1, ('1',), '')


@pytest.mark.slow
@pytest.mark.real_layer(reason='the node is in another process')
def test_no_answer_to_a_change_springs_back_and_says_so(ros, remote):
    process = remote('stopped')
    panel = ParameterPanel('stopped', timeout_sec=3.0)
    wait_until(lambda: 'x' in panel, 'the panel to find the node', 20)
    with standing_still(process):
        enter(panel, 'x', '5')
        waiting = 'waiting', 'Waiting for the node to answer…'
        wait_until(lambda: says(panel, 'x') == waiting, 'the panel to say that it waits')
        wait_until(lambda: panel['x'].message, 'the panel to give up', 20)
        assert '/stopped did not answer set_parameters within 3 s' in panel['x'].message
        wait_until(lambda: says(panel, 'x') == ('failed', panel['x'].message), 'the panel not to speak of a rejection')
        wait_until(lambda: shows(panel, 'x') == ('1',), 'the control to spring back')
        assert '/stopped did not answer' in panel.status
        wait_until(lambda: is_locked(panel, 'x'), 'the control to be locked')
    wait_until(lambda: not panel.status, 'the panel to hear from the node', 20)
    wait_until(lambda: not is_locked(panel, 'x'), 'the control to be free', 20)
    wait_until(lambda: shows(panel, 'x') == ('5',), 'the node to do, late, what it was asked to', 20)
    wait_until(lambda: not says(panel, 'x'), 'the word that it did not answer to go', 20)
    panel.close()


# -- restarts -----------------------------------------------------------------------------------------


def test_a_restarted_node_is_read_afresh(ros):
    ros.add(SimpleParamNode)
    panel = ParameterPanel('/simple_param_node')
    panel['max_speed_rpm'].value = 150
    panel['robot_name'].value = ' '
    panel.settle()
    assert panel['robot_name'].message == 'robot_name must not be empty'
    ros.add(SimpleParamNode)
    panel.settle()
    assert shows(panel, 'max_speed_rpm') == ('100',)
    assert panel['robot_name'].message == ''
    enter(panel, 'max_speed_rpm', '120')
    panel.settle()
    assert ParameterClient('/simple_param_node').get_parameter('max_speed_rpm') == 120


def test_a_node_that_comes_back_with_other_parameters(ros):
    class Other(Node):
        def __init__(self):
            super().__init__('arm')
            self.declare_parameter('joints', 'many')

    ros.add(Arm)
    panel = ParameterPanel(NODE)
    ros.add(Other)
    panel.settle()
    assert panel.names == ['joints', 'use_sim_time', 'start_type_description_service']
    assert (panel['joints'].row.editor, panel['joints'].row.last) == ('text', None)
    assert shows(panel, 'joints') == ('many',)


@pytest.mark.slow
def test_a_panel_of_a_node_that_is_not_there_waits_for_it(ros):
    ros.add(SimpleParamNode)
    panel = ParameterPanel('simple_parm_node')
    assert 'there is no node /simple_parm_node. Did you mean /simple_param_node?' in panel.status
    assert panel.status in html.unescape(panel._front.markup)

    class Late(Node):
        def __init__(self):
            super().__init__('simple_parm_node')
            self.declare_parameter('x', 1)

    ros.add(Late)
    wait_until(lambda: 'x' in panel, 'the panel to find the node')
    panel.close()


# -- the page -----------------------------------------------------------------------------------------


def test_repr_and_mime_bundle(arm):
    assert repr(arm) == '<ParameterPanel: /arm, 22 parameters>'
    bundle = arm._repr_mimebundle_()
    assert bundle['text/plain'] == repr(arm)
    assert 'application/vnd.jupyter.widget-view+json' in bundle
    assert repr(arm['joints']) == '<Control: joints = 5>'
    arm.close()
    assert repr(arm) == '<ParameterPanel: /arm, closed>'


def test_names_choose_and_order(ros):
    ros.add(Arm)
    panel = ParameterPanel(NODE, names=['tool', 'use_sim_time', 'joints', 'no_such'])
    assert panel.names == ['tool', 'use_sim_time', 'joints']
    assert repr(panel) == '<ParameterPanel: /arm, 3 parameters>'


def test_a_panel_made_again_resets_to_what_the_node_began_with(ros):
    node = ros.add(Band, ros_args=['-p', 'high:=50'])
    panel = ParameterPanel(node)
    panel['high'].value = 60
    panel.settle()
    again = ParameterPanel(node)
    assert again.changed == {'high': 50}
    again.reset()
    assert (again['high'].value, again.changed) == (50, {})

    # The panel goes on with the node that takes this one's place, and its values.
    node = ros.add(Band, ros_args=['-p', 'high:=70'])
    wait_until(lambda: again['high'].value == 70, 'the panel to follow')
    again.settle()
    assert again.changed == {}


def test_reset_brings_back_what_the_panel_first_saw_of_a_node_elsewhere(ros):
    node = Band()
    ros.run(lambda: ros._executor.add_node(node), 'spin a node that is not on the stage')
    try:
        ParameterClient('/band').set_parameter('high', 5)
        panel = ParameterPanel('/band')
        panel['high'].value = 20
        panel.settle()
        panel.reset()
        assert panel['high'].value == 5
    finally:
        ros.run(lambda: ros._executor.remove_node(node), 'let go of it')
        node.destroy_node()


def test_reset_brings_back_what_the_panel_first_saw(ros):
    ros.add(Band)
    panel = ParameterPanel('/band')
    first = {name: panel[name].value for name in panel.names}
    for name, value in (('high', 20), ('low', 10), ('name', 'other')):
        panel[name].value = value
        panel.settle()
    panel['high'].value = 30  # still on its way
    panel.reset()
    assert {name: panel[name].value for name in panel.names} == first
    assert not any(panel[name].message for name in panel.names)


def test_what_cannot_be_brought_back_is_said(ros):
    node = ros.add(Band)
    panel = ParameterPanel('/band')
    panel['low'].value = 0
    panel.settle()
    node.add_on_set_parameters_callback(lambda _: SetParametersResult(successful=False, reason='it is locked'))
    panel.reset()
    assert (panel['low'].value, panel['low'].message) == (0, 'it is locked')


# -- undo ---------------------------------------------------------------------------------------------


@pytest.mark.slow
def test_undo_and_redo_take_the_node_back_and_forth(arm):
    enter(arm, 'tool', 'saw')
    arm.settle()
    enter(arm, 'offset', '2')
    arm.settle()
    assert arm.changed == {'tool': 'gripper', 'offset': 0.5}
    assert arm._front.state['undo'] and not arm._front.state['redo']
    arm.undo()
    assert (arm['offset'].value, arm['tool'].value) == (0.5, 'saw')
    arm.undo()
    assert (arm.changed, arm['tool'].value) == ({}, 'gripper')
    arm.redo()
    arm.redo()
    assert ParameterClient(NODE).get_parameters(['tool', 'offset']) == {'tool': 'saw', 'offset': 2.0}
    arm.redo()
    arm.undo()
    enter(arm, 'offset', '3')
    arm.settle()
    assert not arm._front.state['redo'], 'what was undone and then replaced cannot be done again'


@pytest.mark.slow
def test_one_pull_of_a_slider_is_undone_at_once(arm):
    for position in range(50, 100):
        slide(arm, 'reach', position, grip=1)
        arm.settle()
    slide(arm, 'reach', 10, grip=2)
    arm.settle()
    arm.undo()
    assert arm['reach'].value == 1.0
    arm.undo()
    assert arm['reach'].value == 0.5
    assert not arm._front.state['undo']


def test_what_a_callback_changes_is_undone_with_it(ros):
    class Twins(Node):
        def __init__(self):
            super().__init__('twins')
            self.declare_parameters('', [('one', 1), ('other', 1)])
            self.add_post_set_parameters_callback(self.follow)

        def follow(self, parameters):
            if parameters[0].name == 'one' and self.get_parameter('other').value != parameters[0].value:
                self.set_parameters([Parameter('other', value=parameters[0].value)])

    ros.add(Twins)
    panel = ParameterPanel('/twins')
    enter(panel, 'other', '5')
    panel.settle()
    enter(panel, 'one', '7')
    panel.settle()
    wait_until(lambda: panel['other'].value == 7, 'the other to follow')
    panel.settle()
    panel.undo()
    assert (panel['one'].value, panel['other'].value) == (1, 5)


@pytest.mark.slow
@pytest.mark.thorough
@settings(max_examples=3)
@given(st.lists(st.sampled_from([
    ('enabled', 'true'), ('enabled', 'false'), ('tool', 'saw'), ('tool', 'drill'), ('offset', '1'), ('offset', '2.5'),
    ('joints', '9'), ('joints', '77'), ('gains.kp', '0.9'), ('names', '[a]'), ('order', '[]'), ('serial', 'x')]),
    min_size=100, max_size=100))
def test_undo_of_a_hundred_edits_gives_the_exact_first_state(arm, edits):
    first = ParameterClient(NODE).get_parameters(arm.names)
    for name, text in edits:
        enter(arm, name, text)
        arm.settle()
    while arm._front.state['undo']:
        arm.undo()
        assert arm.not_restored == {}
    now = ParameterClient(NODE).get_parameters(arm.names)
    assert [name for name in first if not values.same(first[name], now[name])] == []


def test_what_is_pressed_while_the_node_thinks_is_done_in_that_order(ros):
    node = ros.add(Gate)
    panel = ParameterPanel('/gate')
    node.open.release(2)
    enter(panel, 'x', '1')
    panel.settle()
    enter(panel, 'y', '2')
    panel.settle()
    press(panel, 'reset', name='x')
    for button in ('undo', 'undo', 'redo'):
        press(panel, button)
    node.open.release(4)
    wait_until(lambda: len(node.seen) == 6, 'all of it')
    assert node.seen == [1, 2, 0, 1, 0, 2]


# -- many parameters ------------------------------------------------------------------------------------


class Many(Node):
    """Has parameters in groups within groups."""

    def __init__(self):
        super().__init__('many')
        for plugin in range(10):
            for number in range(50):
                self.declare_parameter(f'layers.plugin_{plugin}.costs.weight_{number}', number)
        self.declare_parameter('rate_hz', 10)


@pytest.mark.slow
def test_hundreds_of_parameters_stand_in_a_tree_that_can_be_searched(ros):
    ros.add(Many)
    panel = ParameterPanel('/many')
    assert panel.names[0] == 'rate_hz' and len(panel.names) == 503
    headings = re.findall(r'aria-level="4">(.+?)</span>', panel._front.markup)
    assert headings == ['layers', *(f'plugin_{number}.costs' for number in range(10)), 'In every node']
    assert '<input type="search" class="param-search" placeholder="Search 503 parameters"' in panel._front.markup
    enter(panel, 'layers.plugin_3.costs.weight_7', '99')
    panel.settle()
    assert panel.changed == {'layers.plugin_3.costs.weight_7': 7}


def test_a_value_that_a_rule_chooses_is_chosen_from_a_list(ros):
    class Colored(Node):
        def __init__(self):
            super().__init__('colored')
            self.declare_parameters('', [('color', 'red'), ('free', 'red')])
            Rules(self).one_of('color', ['red', 'gre;en', "it's; blue"]).length('color', 1, 20)

    ros.add(Colored)
    panel = ParameterPanel('/colored')
    assert (panel['color'].row.editor, panel['color'].row.choices) == ('choice', ('red', 'gre;en', "it's; blue"))
    assert panel['free'].row.editor == 'text'
    assert '<option selected>red</option><option>gre;en</option>' in panel._front.markup
    enter(panel, 'color', 'gre;en')
    panel.settle()
    assert panel['color'].value == 'gre;en'


def test_what_can_change_only_while_another_parameter_has_a_value_is_locked_until_then(ros):
    class Arm(Node):
        def __init__(self):
            super().__init__('arm')
            self.declare_parameters('', [('moving', False), ('reach_m', 2)])
            Rules(self).only_while('reach_m', 'moving', False)

    node = ros.add(Arm)
    panel = ParameterPanel('/arm')
    assert not panel._front.state['rows']['reach_m'].get('is_locked')
    node.set_parameters([Parameter('moving', value=True)])  # whatever does it
    wait_until(lambda: panel._front.state['rows']['reach_m'].get('is_locked'), 'the panel to lock it')
    assert says(panel, 'reach_m') == ('locked', 'It can change only while moving is False; now moving = True.')
    assert not panel._front.state['rows']['moving'].get('is_locked')
    # Gathered, both go together.
    panel.gather()
    panel['moving'].value = False
    panel.settle()
    assert not panel._front.state['rows']['reach_m'].get('is_locked')
    panel['reach_m'].value = 3
    assert panel.apply() == ''
    assert (panel['moving'].value, panel['reach_m'].value) == (False, 3)


# -- together -------------------------------------------------------------------------------------------


def press_gather(panel):
    press(panel, 'gather')
    wait_until(lambda: panel.gathered == {}, 'the panel to gather')


def test_gathered_changes_are_one_request(ros):
    node = ros.add(Band)
    panel = ParameterPanel('/band')
    press_gather(panel)
    enter(panel, 'low', '10')
    enter(panel, 'high', '20')
    enter(panel, 'name', 'other')
    enter(panel, 'name', 'band')  # what the node has anyway
    panel.settle()
    assert panel.gathered == {'low': 10, 'high': 20}
    assert (shows(panel, 'low'), says(panel, 'low')) == (('10',), ('gathering', 'Now 1; not sent yet.'))
    assert panel._front.state['note'] == '2 changes gathered, not sent yet.'
    assert node.get_parameter('low').value == 1
    assert panel.apply() == ''
    assert (panel.gathered, panel['low'].value, panel['high'].value) == (None, 10, 20)
    panel.undo()
    assert panel.not_restored == {}
    assert (panel['low'].value, panel['high'].value) == (1, 2)


def test_a_cell_does_what_it_says_whatever_button_was_pressed_before(ros):
    node = ros.add(Band)
    panel = ParameterPanel('/band')
    press_gather(panel)
    enter(panel, 'high', '20')
    panel['low'].value = 0
    panel.settle()
    assert (node.get_parameter('low').value, panel.gathered) == (0, {'high': 20})
    panel.gather()
    panel['low'].value = 3
    assert panel.gathered == {'high': 20, 'low': 3}
    assert panel.apply() == ''
    press_gather(panel)
    panel['low'].value = 4
    panel.settle()
    assert (node.get_parameter('low').value, panel.gathered) == (4, {})


@pytest.mark.slow
def test_what_is_rejected_stays_gathered_until_it_is_mended_or_discarded(ros):
    ros.add(Band)
    panel = ParameterPanel('/band')
    panel.gather()
    panel['low'].value = 30
    panel['high'].value = 20
    assert panel.apply() == '30 is not below 20'
    assert panel._front.state['note'] == '2 changes gathered, not sent yet.\nRejected: 30 is not below 20'
    panel['low'].value = 5
    assert panel.apply() == ''
    assert (panel['low'].value, panel['high'].value) == (5, 20)
    panel.gather()
    panel['low'].value = 6
    press(panel, 'discard')
    wait_until(lambda: panel.gathered is None and shows(panel, 'low') == ('5',), 'it to be forgotten')
    ros.remove_all()
    panel.gather()
    panel['low'].value = 6
    assert 'there is no node /band' in panel.apply()


# -- arrays and units -------------------------------------------------------------------------------------


def enter_items(panel, name, *texts):
    """Do what the browser does when someone edits the elements of an array."""
    panel._front._handle_custom_msg({'do': 'enter', 'name': name, 'client': 'test', 'number': 1, 'items': texts}, [])
    panel.settle()


def items(panel, name):
    return panel._front.state['rows'][name].get('items')


def test_the_elements_of_an_array_are_edited_one_by_one(arm):
    assert items(arm, 'order') == ['3', '1', '2']
    assert items(arm, 'names') == ['base', 'elbow, left'], 'a box of its own needs no quotes'
    assert items(arm, 'firmware') == ['0x00', '0xff']
    assert (items(arm, 'tool'), items(arm, 'payload')) == (None, None)
    strange = [' a ', '"', "'", 'x, y', '[', '', '\\n', 'ü']
    enter_items(arm, 'names', *strange)
    assert arm['names'].value == strange
    assert items(arm, 'names') == strange
    enter_items(arm, 'limits', '1', 'inf', '-.5')
    assert values.same(arm['limits'].value, [1.0, float('inf'), -0.5])
    enter_items(arm, 'flags')
    assert (arm['flags'].value, items(arm, 'flags')) == ([], [])
    assert arm['flags'].descriptor.type is values.BOOL_ARRAY
    arm.undo()
    assert arm['flags'].value == [True, False]


def test_an_element_that_cannot_be_read_is_named_and_the_array_stays(arm):
    enter_items(arm, 'order', '3', '1.5', '2')
    assert says(arm, 'order') == ('rejected', "element 2, '1.5', cannot be read: order takes integers, e.g. [1, 2, 3]")
    assert arm['order'].value == [3, 1, 2]


def test_a_unit_stands_behind_the_box_where_one_is_known(ros):
    ros.add(SimpleParamNode)
    panel = ParameterPanel('/simple_param_node')
    assert {name: panel[name].row.unit for name in panel.names if panel[name].row.unit} == {
        'max_speed_rpm': 'rpm', 'max_acceleration_mps2': 'm/s²', 'sensor_offset_meters': 'm',
        'min_operating_temperature_c': '°C'}
    assert '<span class="param-unit">m/s²</span>' in panel._front.markup


def test_a_panel_without_tools_has_no_button_but_reset(arm):
    head = ParameterPanel(arm.node, tools=False)._front.markup.partition('class="param-rows"')[0]
    # The second group is that of the file.
    assert re.findall(r'class="param-(\w+)"[^>]* hidden\b', head) == ['gather', 'undo', 'redo', 'tools', 'bar']
