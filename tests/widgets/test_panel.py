"""The parameter panel, on real nodes and without a browser.

What a person does in the browser arrives as a message; ``enter`` and ``slide`` send just that.
"""

import html
import math
import shlex

import pytest
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools import values
from param_tools.errors import ParameterNotDeclaredError
from param_tools.files import parameter_files
from param_tools.node.client import ParameterClient
from param_tools.panel.panel import ParameterPanel
from param_tools.ros import stage
from param_tools.ros.waiting import wait_until
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from tests.support.commands import run
from tests.support.nodes import Arm, Band, Gate
from tests.support.widgets import enter, is_locked, press, says, shows, slide

NODE = '/arm'


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
    assert arm.names[-3:] == ['gains.kd', 'use_sim_time', 'start_type_description_service']
    ParameterClient(NODE).delete_parameter('payload')
    wait_until(lambda: 'payload' not in arm, 'the deleted parameter to go')
    with pytest.raises(ParameterNotDeclaredError, match="has no parameter 'payload'"):
        arm['payload']


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


def test_a_node_that_comes_back_is_read_afresh_also_with_other_parameters(ros):
    class Other(Node):
        def __init__(self):
            super().__init__('simple_param_node')
            self.declare_parameter('robot_name', 7)

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
    ros.add(Other)
    panel.settle()
    assert panel.names == ['robot_name', 'use_sim_time', 'start_type_description_service']
    assert (panel['robot_name'].row.kind, shows(panel, 'robot_name')) == ('integer', ('7',))


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
    # What every node has is folded away, but not from a caller who asks for it; names break where words end.
    assert [f'<details class="param-group"{so}>' in each._front.markup
            for each in (panel, ParameterPanel(NODE)) for so in (' open', '')] == [True, False, False, True]
    assert '>use_<wbr>sim_<wbr>time</label>' in panel._front.markup


def test_a_value_where_none_was_is_marked_and_stays(arm):
    for value, take_back in (('noon', arm.undo), ('night', arm.reset)):
        enter(arm, 'calibrated_at', value)
        arm.settle()
        assert arm._front.state['rows']['calibrated_at'] == {'text': value, 'is_changed': True}
        take_back()
        arm.settle()
        kind, words = says(arm, 'calibrated_at')
        assert (kind, shows(arm, 'calibrated_at')) == ('rejected', (value,))
        assert words.startswith('it had no value at first, and ROS cannot unset a parameter')


CHANGED = {'enabled': False, 'serial': -5, 'offset': -1e-9, 'tool': '-it\'s "off"', 'notes': 'off',
           'limits': [math.nan, -0.5], 'names': ['', 'a, b', '1'], 'calibrated_at': 'a\u202eb\n', 'payload': [True],
           'firmware': [b'\x01']}


def test_what_has_changed_can_be_copied_as_a_parameter_file_and_as_commands(arm, tmp_path):
    assert arm._front.state['copies'] == []
    for name, value in CHANGED.items():
        arm[name].value = value
    arm.settle()
    text, commands = arm._front.state['copies']
    (tmp_path / 'file.yaml').write_text(text)
    # ROS has no bytes there.
    known = {name: value for name, value in CHANGED.items() if name != 'firmware'}
    read = parameter_files.read(tmp_path / 'file.yaml', NODE)
    assert read.keys() == known.keys() and all(values.same(read[name], known[name]) for name in known)
    *lines, left_out = sorted(commands.splitlines(), reverse=True)
    assert left_out == '# left out: "firmware": ros2 param set has no words for its value'
    client = ParameterClient(stage.current().add(Arm))
    for line in lines:
        assert run(*shlex.split(line)[1:])[2] == 0, line
    assert all(values.same(client.get_parameter(name), value) for name, value in known.items())


def test_reset_brings_back_what_the_panel_first_saw_of_a_node_elsewhere(ros):
    node = Band()
    ros.run(lambda: ros._executor.add_node(node), 'spin a node that is not on the stage')
    try:
        ParameterClient('/band').set_parameter('high', 5)
        panel = ParameterPanel('/band')
        first = {name: panel[name].value for name in panel.names}
        for name, value in (('high', 20), ('low', 10), ('name', 'other')):
            panel[name].value = value
            panel.settle()
        panel['high'].value = 30  # still on its way
        panel.reset()
        assert {name: panel[name].value for name in panel.names} == first
        assert not any(panel[name].message for name in panel.names)
    finally:
        ros.run(lambda: ros._executor.remove_node(node), 'let go of it')
        node.destroy_node()


def test_undo_takes_back_the_last_change_or_a_whole_pull_of_a_slider(arm):
    enter(arm, 'tool', 'saw')
    arm.settle()
    for position in (50, 60, 70):
        slide(arm, 'reach', position, grip=1)
        arm.settle()
    enter(arm, 'serial', 'x')  # no number, so it changes nothing
    arm.settle()
    assert arm.changed == {'tool': 'gripper', 'reach': 0.5}
    assert arm._front.state['undo']
    press(arm, 'undo')
    wait_until(lambda: shows(arm, 'reach') == ('0.5', 49), 'the value before the pull')
    assert (arm['tool'].value, arm._front.state['undo']) == ('saw', False)
    arm.reset('tool')
    assert arm.changed == {}
    arm.undo()
    assert ParameterClient(NODE).get_parameter('tool') == 'saw'


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


def test_while_the_node_thinks_the_panel_says_that_it_waits(ros):
    node = ros.add(Gate)
    panel = ParameterPanel('/gate')
    enter(panel, 'x', '5')
    waiting = 'waiting', 'Waiting for the node to answer…'
    wait_until(lambda: says(panel, 'x') == waiting, 'the panel to say that it waits')
    node.open.release()
    wait_until(lambda: (shows(panel, 'x'), says(panel, 'x')) == (('5',), None), 'the answer')
