"""The parameter panel and the log view, on real nodes and without a browser.

What a hand does in the browser arrives as ``set_state`` of a widget; ``by_hand`` calls just that.
"""

import gc
import math
import signal
import subprocess
import sys
import textwrap
import threading
import weakref

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from ipywidgets.widgets.widget import _instances as widget_registry
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterEvent, SetParametersResult
from rcl_interfaces.msg import ParameterDescriptor as Describe
from rclpy.node import Node
from rclpy.parameter import Parameter

import param_tutorial
from param_tutorial import EventView, RobotView, StepResponseView
from param_tutorial.errors import ExecutorError, ParameterNotDeclaredError, WaitTimeoutError
from param_tutorial.nodes.pid_controller_node import PidControllerNode
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from param_tutorial.parameters import text as typed
from param_tutorial.parameters import values
from param_tutorial.parameters.client import Descriptor, ParameterClient, Range
from param_tutorial.runtime import stage
from param_tutorial.runtime.waiting import wait_until
from param_tutorial.widgets import cells, editors
from param_tutorial.widgets.log import LogView
from param_tutorial.widgets.panel import ParameterPanel

NODE = '/arm'
INT64_MAX = 2**63 - 1


class Arm(Node):
    """Has a parameter of every type and shape."""

    def __init__(self):
        super().__init__('arm')
        declare = self.declare_parameter
        declare('enabled', True)
        declare('serial', 2**62 + 1)
        declare('joints', 5, Describe(integer_range=[IntegerRange(from_value=1, to_value=12, step=4)]))
        declare('offset', 0.5)
        declare('reach', 0.5, Describe(floating_point_range=[FloatingPointRange(from_value=0.01, to_value=2.0)]))
        declare('gains.kp', 0.3, Describe(
            floating_point_range=[FloatingPointRange(from_value=0.0, to_value=1.0, step=0.3)]))
        declare('gains.ki', 0.0)
        declare('tool', 'gripper')
        declare('notes', 'one\ntwo')
        declare('flags', [True, False])
        declare('order', [3, 1, 2])
        declare('limits', [-1.5, math.inf])
        declare('names', ['base', 'elbow, left'])
        declare('firmware', [b'\x00', b'\xff'])
        declare('model', 'A1', Describe(read_only=True))
        declare('payload', 1.5, Describe(dynamic_typing=True))
        declare('calibrated_at', Parameter.Type.STRING)
        declare('endless', 1.0, Describe(
            floating_point_range=[FloatingPointRange(from_value=0.0, to_value=math.inf)]))
        declare('fixed', 7, Describe(integer_range=[IntegerRange(from_value=7, to_value=7, step=1)]))
        declare('huge', 0, Describe(
            integer_range=[IntegerRange(from_value=-INT64_MAX, to_value=INT64_MAX, step=1)]))


class Gate(Node):
    """Lets each value through only when the test opens the gate, and keeps what it saw."""

    def __init__(self):
        super().__init__('gate')
        self.declare_parameter('x', 0)
        self.declare_parameter('y', 0)
        self.seen = []
        self.entered = threading.Semaphore(0)
        self.open = threading.Semaphore(0)
        self.add_on_set_parameters_callback(self.check)

    def check(self, parameters):
        """Wait at the gate."""
        self.seen.append(parameters[0].value)
        self.entered.release()
        self.open.acquire(timeout=20)
        return SetParametersResult(successful=parameters[0].value >= 0, reason='must not be negative')


class Counter(Node):
    """Counts the values that it is asked for."""

    def __init__(self):
        super().__init__('counter')
        self.declare_parameter('x', 0)
        self.seen = []
        self.add_on_set_parameters_callback(self.check)

    def check(self, parameters):
        """Take everything."""
        self.seen += [each.value for each in parameters]
        return SetParametersResult(successful=True)


@pytest.fixture(autouse=True)
def _close_all():
    yield
    for widget in list(widget_registry.values()):
        if isinstance(widget, (ParameterPanel, LogView)):
            widget.close()
    wait_until(lambda: not worker_threads(), 'the threads of closed panels to end')


def worker_threads():
    """Give the names of the threads that serve panels and views."""
    return [each.name for each in threading.enumerate() if each.name.startswith(('panel of', 'log view'))]


@pytest.fixture
def arm(ros):
    """Give a panel of an Arm."""
    ros.add(Arm)
    return ParameterPanel(NODE)


def by_hand(widget, value):
    """Do what a front end does when a hand has changed a widget."""
    widget.set_state({'value': value})


def texts(panel):
    """Give all the HTML of a panel or view."""
    pieces, waiting = [], list(panel.children)
    while waiting:
        widget = waiting.pop()
        waiting += getattr(widget, 'children', ())
        if type(widget).__name__ == 'HTML':
            pieces.append(widget.value)
    return '\n'.join(pieces)


def shows(panel, name):
    """Give what the widgets of a control hold."""
    return tuple(widget.value for widget in panel[name].editors)


def wait_for_value(panel, name, value):
    """Wait, without asking the panel to hurry."""
    wait_until(lambda: values.same(panel[name].value, value), f'{name} to become {value!r}')


# -- editors --------------------------------------------------------------------------------------------


EDITORS = {
    'enabled': ['_Checkbox'], 'serial': ['_Text'], 'joints': ['_Text', '_IntSlider'], 'offset': ['_Text'],
    'reach': ['_Text', '_IntSlider'], 'gains.kp': ['_Text', '_IntSlider'], 'gains.ki': ['_Text'],
    'tool': ['_Text'], 'notes': ['_Textarea'], 'flags': ['_Text'], 'order': ['_Text'], 'limits': ['_Text'],
    'names': ['_Text'], 'firmware': ['_Text'], 'model': ['_Text'], 'payload': ['_Text'], 'calibrated_at': ['_Text'],
    'endless': ['_Text'], 'fixed': ['_Text'], 'huge': ['_Text'],
}


def test_every_parameter_gets_the_editor_of_its_type_and_range(arm):
    assert {name: [type(widget).__name__ for widget in arm[name].editors] for name in EDITORS} == EDITORS


def test_what_the_widgets_hold_at_first(arm):
    assert {name: shows(arm, name) for name in EDITORS} == {
        'enabled': (True,), 'serial': ('4611686018427387905',), 'joints': ('5', 5), 'offset': ('0.5',),
        'reach': ('0.5', 49), 'gains.kp': ('0.3', 1), 'gains.ki': ('0.0',), 'tool': ('gripper',),
        'notes': ('one\ntwo',), 'flags': ('[true, false]',), 'order': ('[3, 1, 2]',), 'limits': ('[-1.5, inf]',),
        'names': ('[base, "elbow, left"]',), 'firmware': ('[0x00, 0xff]',), 'model': ('A1',), 'payload': ('1.5',),
        'calibrated_at': ('',), 'endless': ('1.0',), 'fixed': ('7',), 'huge': ('0',)}


@pytest.mark.parametrize(('name', 'entered', 'stored', 'shown'), [
    ('enabled', False, False, (False,)),
    ('serial', str(INT64_MAX), INT64_MAX, (str(INT64_MAX),)),
    ('serial', ' -0x10 ', -16, ('-16',)),
    ('serial', '007', 7, ('7',)),
    ('offset', '3', 3.0, ('3.0',)),
    ('offset', '.nan', math.nan, ('nan',)),
    ('offset', '-inf', -math.inf, ('-inf',)),
    ('offset', '1e-300', 1e-300, ('1e-300',)),
    ('reach', '0.123456789', 0.123456789, ('0.123456789', 11)),
    ('tool', '', '', ('',)),
    ('tool', '  <b>ü 机械</b> "quoted" ', '  <b>ü 机械</b> "quoted" ', ('  <b>ü 机械</b> "quoted" ',)),
    ('notes', 'a\nb\n', 'a\nb\n', ('a\nb\n',)),
    ('notes', 'one line', 'one line', ('one line',)),
    ('flags', '[]', [], ('[]',)),
    ('flags', 'true, TRUE, false', [True, True, False], ('[true, true, false]',)),
    ('order', '[1, 0xff,]', [1, 255], ('[1, 255]',)),
    ('order', '', [], ('[]',)),
    ('limits', '[1, -.inf, nan]', [1.0, -math.inf, math.nan], ('[1.0, -inf, nan]',)),
    ('limits', '[]', [], ('[]',)),
    ('names', '[a, "b, c", \'d\'\'e\', 007, true]', ['a', 'b, c', "d'e", '007', 'true'],
     ('[a, "b, c", "d\'e", 007, true]',)),
    ('names', '[]', [], ('[]',)),
    ('firmware', '[0, 0x7f, 255]', [b'\x00', b'\x7f', b'\xff'], ('[0x00, 0x7f, 0xff]',)),
    ('firmware', '[]', [], ('[]',)),
    ('payload', '2', 2, ('2',)),
    ('payload', 'off', False, ('false',)),
    ('payload', '"off"', 'off', ('"off"',)),
    ('payload', '[1.5, .nan]', [1.5, math.nan], ('[1.5, .nan]',)),
    ('payload', 'some words', 'some words', ('some words',)),
    ('calibrated_at', 'today', 'today', ('today',)),
    ('endless', '1e9', 1e9, ('1000000000.0',)),
    ('huge', str(-INT64_MAX), -INT64_MAX, (str(-INT64_MAX),)),
])
def test_what_a_hand_enters_reaches_the_node_with_its_type(arm, name, entered, stored, shown):
    by_hand(arm[name].editors[0], entered)
    arm.settle()
    assert values.same(ParameterClient(NODE).get_parameter(name), stored)
    assert arm[name].message == ''
    assert shows(arm, name) == shown


@pytest.mark.parametrize(('name', 'entered', 'reason'), [
    ('serial', '1.5', "'1.5' cannot be read: serial wants a whole number, e.g. 42"),
    ('serial', '', "'' cannot be read: serial wants a whole number, e.g. 42"),
    ('serial', str(2**63), '9223372036854775808 does not fit into the 64 bits of a ROS integer '
                           '(-9223372036854775808 to 9223372036854775807)'),
    ('offset', '1,5', "'1,5' cannot be read: offset wants a number, e.g. 0.5"),
    ('flags', '[yes]', "'[yes]' cannot be read: flags wants booleans, e.g. [true, false]"),
    ('order', '[1, 2', "'[1, 2' cannot be read: order wants whole numbers, e.g. [1, 2, 3]"),
    ('order', '[1,,2]', "'[1,,2]' cannot be read: order wants whole numbers, e.g. [1, 2, 3]"),
    ('limits', '[a]', "'[a]' cannot be read: limits wants numbers, e.g. [0.5, 1.0]"),
    ('names', '["a]', '\'["a]\' cannot be read: names wants texts, e.g. [left, "right, far"]'),
    ('firmware', '[256]', "'[256]' cannot be read: firmware wants bytes, e.g. [0x00, 0xff]"),
    ('tool', 'a\0b', 'a ROS string ends at its first NUL character, so it cannot hold one'),
])
def test_what_is_no_value_springs_back_and_says_why(arm, name, entered, reason):
    before = shows(arm, name)
    by_hand(arm[name].editors[0], entered)
    arm.settle()
    assert shows(arm, name) == before
    assert arm[name].message == reason


def test_a_slider_reaches_its_valid_positions_and_both_ends(arm):
    slider = arm['joints'].editors[1]
    assert (slider.min, slider.max, slider.step) == (1, 12, 4)
    for position in (9, 12, 1):
        by_hand(slider, position)
        arm.settle()
        assert arm['joints'].value == position
        assert arm['joints'].message == ''
        assert shows(arm, 'joints') == (str(position), position)


def test_a_double_slider_counts_round_numbers_up_to_the_end(arm):
    slider = arm['reach'].editors[1]
    assert (slider.min, slider.max, slider.step) == (0, 199, 1)
    for position, stored in ((29, 0.3), (199, 2.0), (0, 0.01)):
        by_hand(slider, position)
        arm.settle()
        assert shows(arm, 'reach') == (repr(stored), position)
    slider = arm['gains.kp'].editors[1]
    assert (slider.min, slider.max, slider.step) == (0, 4, 1)
    for position, stored in ((3, 0.9), (4, 1.0), (0, 0.0)):
        by_hand(slider, position)
        arm.settle()
        assert arm['gains.kp'].message == ''
        assert values.same(arm['gains.kp'].value, stored)


def test_a_slider_that_is_only_drawn_changes_nothing(ros, arm):
    changes = []
    ros.on_parameter_event(changes.append)
    by_hand(arm['reach'].editors[0], '0.123456')
    arm.settle()
    by_hand(arm['reach'].editors[1], 11)  # where it stands
    arm.settle()
    assert shows(arm, 'reach') == ('0.123456', 11)
    by_hand(arm['joints'].editors[1], 5)
    by_hand(arm['joints'].editors[1], 9)
    arm.settle()
    wait_until(lambda: len(changes) >= 2, 'the two changes')
    assert [event.changed_parameters[0].name for event in changes] == ['reach', 'joints']


@given(st.floats(-1e6, 1e6), st.floats(1e-3, 1e6), st.floats(0, 1), st.booleans())
def test_every_position_of_a_slider_is_valid_to_rclpy(low, width, where, stepped):
    limits = Range(low, low + width, width / 7 if stepped else 0.0)
    assume(limits.from_value < limits.to_value)
    positions = editors.Positions(limits)
    position = round(where * positions.last)
    value = positions.value(position)
    assert low <= value <= limits.to_value
    assert abs(positions.nearest(value) - position) <= 1
    assert math.isclose(positions.value(positions.nearest(value)), value)
    if stepped and value != limits.to_value:
        steps = round((value - low) / limits.step)
        assert math.isclose(value, low + steps * limits.step, rel_tol=1e-9, abs_tol=1e-9)


@given(st.floats(-1e9, 1e9))
def test_a_slider_stands_at_the_nearest_position(value):
    positions = editors.Positions(Range(0.0, 1.0, 0.3))
    assert abs(positions.value(positions.nearest(value)) - value) == min(
        abs(each - value) for each in (0.0, 0.3, 0.6, 0.9, 1.0))


_texts = st.text(st.characters(exclude_categories=['Cs'], exclude_characters='\0'))
_WRITTEN = {
    values.INTEGER: st.integers(-2**63, INT64_MAX),
    values.DOUBLE: st.floats(),
    values.BYTE_ARRAY: st.lists(st.binary(min_size=1, max_size=1)),
    values.BOOL_ARRAY: st.lists(st.booleans()),
    values.INTEGER_ARRAY: st.lists(st.integers(-2**63, INT64_MAX)),
    values.DOUBLE_ARRAY: st.lists(st.floats()),
    values.STRING_ARRAY: st.lists(_texts),
}


@pytest.mark.parametrize('parameter_type', _WRITTEN, ids=repr)
@given(data=st.data())
def test_what_a_text_box_shows_is_read_back_the_same(parameter_type, data):
    value = data.draw(_WRITTEN[parameter_type])
    form = typed.form_of(Descriptor('x', parameter_type, '', '', False, False, None))
    text = form.format(value)
    assert '\n' not in text
    assert values.same(form.parse(text), value)


@given(st.one_of(_texts, st.booleans(), *(strategy for kind, strategy in _WRITTEN.items()
                                          if kind is not values.BYTE_ARRAY)))
def test_so_is_a_value_whose_type_may_be_any(value):
    form = typed.form_of(Descriptor('x', values.STRING, '', '', False, True, None))
    text = form.format(value)
    assert '\n' not in text
    assert values.same(form.parse(text), value)


def test_python_code_moves_a_widget_as_a_hand_does(arm):
    arm['joints'].editors[1].value = 9
    arm['enabled'].editors[0].value = False
    arm.settle()
    assert ParameterClient(NODE).get_parameters(['joints', 'enabled']) == {'joints': 9, 'enabled': False}


def test_a_control_takes_python_values(arm):
    arm['offset'].value = 2
    arm['limits'].value = (1, 2)
    arm['names'].value = []
    arm.settle()
    client = ParameterClient(NODE)
    assert values.same(client.get_parameter('offset'), 2.0)
    assert values.same(client.get_parameter('limits'), [1.0, 2.0])
    assert client.get_parameter_types(['names']) == {'names': values.STRING_ARRAY}


def test_a_locked_parameter_is_locked_and_the_node_has_the_last_word(arm):
    assert arm['model'].editors[0].disabled
    assert not arm['tool'].editors[0].disabled
    assert 'read only' in texts(arm)
    arm['model'].value = 'B2'
    arm.settle()
    assert 'read-only' in arm['model'].message
    assert shows(arm, 'model') == ('A1',)


def test_an_unset_parameter_says_so_until_it_is_set(arm):
    box = arm['calibrated_at'].editors[0]
    assert (box.value, box.placeholder) == ('', 'not set')
    by_hand(box, 'now')
    arm.settle()
    box = arm['calibrated_at'].editors[0]
    assert (box.value, box.placeholder) == ('now', '')


# -- what the node confirmed ----------------------------------------------------------------------------


def test_a_refused_value_springs_back_with_the_nodes_reason_until_the_next_change(ros):
    ros.add(SimpleParamNode)
    panel = ParameterPanel('/simple_param_node')
    control = panel['max_speed_rpm']
    by_hand(control.editors[0], '-5')
    panel.settle()
    assert shows(panel, 'max_speed_rpm') == ('100',)
    assert control.value == 100
    assert control.message == 'max_speed_rpm must not be negative, got -5'
    assert 'role="alert"' in texts(panel)
    panel.settle()
    assert control.message == 'max_speed_rpm must not be negative, got -5'
    by_hand(control.editors[0], '120')
    panel.settle()
    assert (control.message, shows(panel, 'max_speed_rpm')) == ('', ('120',))
    assert 'role="alert"' not in texts(panel)


def test_out_of_range_and_off_the_step_come_with_rclpys_words(arm):
    arm['reach'].value = 2.5
    arm['joints'].value = 6
    arm.settle()
    assert 'out of range' in arm['reach'].message
    assert 'not a valid step' in arm['joints'].message
    assert shows(arm, 'reach') == ('0.5', 49)


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
    by_hand(panel['x'].editors[0], '99')
    by_hand(panel['deaf'].editors[0], '5')
    # Nobody asks the panel to settle: it reads back by itself, also where no event tells of a change.
    wait_until(lambda: (panel['x'].value, shows(panel, 'x')) == (10, ('10',)), 'what was stored')
    wait_until(lambda: (panel['deaf'].value, shows(panel, 'deaf')) == (0, ('0',)), 'what was stored')


def test_a_change_made_elsewhere_shows_without_being_asked_for(arm):
    client = ParameterClient(NODE)
    client.set_parameter('joints', 9)
    wait_until(lambda: shows(arm, 'joints') == ('9', 9), 'the panel to follow')
    client.set_parameters({'tool': 'saw', 'enabled': False})
    wait_until(lambda: shows(arm, 'tool') == ('saw',) and shows(arm, 'enabled') == (False,),
                          'the panel to follow')


def test_two_panels_stay_in_step(arm):
    other = ParameterPanel(NODE)
    by_hand(arm['joints'].editors[1], 9)
    wait_until(lambda: shows(other, 'joints') == ('9', 9), 'the second panel to follow the first')
    by_hand(other['joints'].editors[0], '1')
    wait_until(lambda: shows(arm, 'joints') == ('1', 1), 'the first panel to follow the second')


def test_a_dynamic_parameter_follows_its_type(arm):
    ParameterClient(NODE).set_parameter('payload', ['a', 'b'])
    wait_until(lambda: shows(arm, 'payload') == ('[a, b]',), 'the panel to follow')
    wait_until(lambda: arm['payload'].descriptor.type is values.STRING_ARRAY, 'the new type')


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


# -- a fast hand and a slow node ------------------------------------------------------------------------


@pytest.mark.parametrize('move', [
    lambda panel, value: setattr(panel['x'], 'value', value),
    lambda panel, value: setattr(panel['x'].editors[0], 'value', str(value)),
], ids=['control', 'widget'])
def test_a_flood_is_thinned_out_and_its_last_value_arrives(ros, move):
    node = ros.add(Counter)
    panel = ParameterPanel('/counter')
    for value in range(1, 1001):
        move(panel, value)
    panel.settle()
    assert (node.seen[-1], panel['x'].value, shows(panel, 'x')) == (1000, 1000, ('1000',))
    assert len(node.seen) < 500
    assert node.seen == sorted(node.seen)


def test_while_an_answer_is_outstanding_the_newest_value_waits_and_nothing_jumps_back(ros):
    node = ros.add(Gate)
    panel = ParameterPanel('/gate')
    box = panel['x'].editors[0]
    by_hand(box, '1')
    assert node.entered.acquire(timeout=10)
    for value in ('2', '3', '4'):
        by_hand(box, value)
        assert box.value == value
    by_hand(panel['y'].editors[0], '7')
    node.open.release()
    assert node.entered.acquire(timeout=10)
    # The first value is confirmed now, and the last one asked for. A late event must not call the hand back.
    late = Parameter('x', value=1).to_parameter_msg()
    panel._live._on_event(ParameterEvent(node='/gate', changed_parameters=[late]))
    panel._live._reader.call_now(10)
    panel._live._shower.call_now(10)
    assert box.value == '4'
    for _ in range(10):
        node.open.release()
    panel.settle()
    assert [value for value in node.seen if value != 7] == [1, 4]
    assert (panel['x'].value, box.value, panel['y'].value) == (4, '4', 7)


def test_after_a_refusal_of_the_newest_the_last_accepted_value_stands(ros):
    node = ros.add(Gate)
    panel = ParameterPanel('/gate')
    panel['x'].value = 5
    assert node.entered.acquire(timeout=10)
    panel['x'].value = -1
    for _ in range(10):
        node.open.release()
    panel.settle()
    assert (panel['x'].value, panel['x'].message) == (5, 'must not be negative')


def test_settle_says_what_it_waited_for(ros):
    node = ros.add(Gate)
    panel = ParameterPanel('/gate')
    panel['x'].value = 1
    assert node.entered.acquire(timeout=10)
    with pytest.raises(WaitTimeoutError, match=r'waited 0.05 s for /gate to answer x'):
        panel.settle(timeout_sec=0.05)
    node.open.release()
    panel.settle()
    assert panel['x'].value == 1


def test_a_callback_that_raises_is_told_beside_the_control(ros):
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
    by_hand(panel['x'].editors[0], '2')
    by_hand(panel['y'].editors[0], '2')
    panel.settle()
    assert 'raised ZeroDivisionError while it served set_parameters: not <b>that</b> way' in panel['x'].message
    assert shows(panel, 'x') == ('1',)
    # Raised after the value was stored: the panel shows what the node has.
    assert 'raised KeyError' in panel['y'].message
    assert shows(panel, 'y') == ('2',)


def test_a_callback_cannot_wait_for_a_panel(arm):
    with pytest.raises(ExecutorError, match='a callback cannot wait for a panel'):
        stage.current().run(arm.settle, 'settle')


# -- nodes in processes of their own --------------------------------------------------------------------


REMOTE = '''
    import signal, sys, threading, rclpy
    from rclpy.node import Node
    rclpy.init()
    node = Node(sys.argv[1])
    node.declare_parameter('x', 1)
    print('ready', flush=True)
    if 'asleep' in sys.argv:
        sys.stdin.readline()
    reader = threading.Thread(target=sys.stdin.read)
    reader.start()
    while reader.is_alive():
        rclpy.spin_once(node, timeout_sec=0.05)
    node.destroy_node()
    # A process that ends while the news of its node is under way can leave a ghost in the graph.
    signal.pause()
'''


@pytest.fixture
def remote(ros):
    """Give a function that starts a node in a process of its own."""
    started = []

    def start(*arguments):
        process = subprocess.Popen([sys.executable, '-c', textwrap.dedent(REMOTE), *arguments],
                                   stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        started.append(process)
        assert process.stdout.readline() == 'ready\n'
        return process

    yield start
    for process in started:
        process.send_signal(signal.SIGCONT)
        process.stdin.close()  # which ends the node
    # The next test may expect an empty stage.
    ros.remove_all()
    wait_until(lambda: not ros.services.node_names(), 'the nodes to leave the graph', 20)
    for process in started:
        process.kill()
        process.wait()
        process.stdout.close()


@pytest.mark.slow
def test_a_node_elsewhere_that_goes_and_comes_back(ros, remote):
    process = remote('comes_and_goes')
    panel = ParameterPanel('comes_and_goes')
    wait_until(lambda: 'x' in panel, 'the panel to find the node', 20)
    by_hand(panel['x'].editors[0], '5')
    panel.settle()
    assert panel['x'].value == 5
    process.stdin.close()
    wait_until(lambda: panel.status, 'the panel to miss the node', 20)
    wait_until(lambda: panel['x'].editors[0].disabled, 'the control to be locked')
    assert panel.status == '/comes_and_goes is not running. Its controls come back when it does.'
    assert panel.status in texts(panel)
    assert repr(panel) == '<ParameterPanel: /comes_and_goes, not available>'
    panel['x'].value = 6
    panel.settle()
    assert panel['x'].message.startswith(('there is no node /comes_and_goes', '/comes_and_goes is running but offers'))
    remote('comes_and_goes')
    wait_until(lambda: not panel.status and not panel['x'].editors[0].disabled, 'the panel to revive', 20)
    assert (panel['x'].value, shows(panel, 'x'), panel['x'].message) == (1, ('1',), '')


def test_a_node_that_does_not_answer(ros, remote):
    process = remote('drowsy', 'asleep')
    panel = ParameterPanel('drowsy', timeout_sec=0.5)
    assert 'did not answer' in panel.status
    assert panel.names == []
    process.stdin.write('\n')
    process.stdin.flush()
    wait_until(lambda: 'x' in panel and shows(panel, 'x') == ('1',), 'the panel to try again', 20)
    assert panel.status == ''


@pytest.mark.slow
def test_no_answer_to_a_change_springs_back_and_says_so(ros, remote):
    process = remote('stopped')
    panel = ParameterPanel('stopped', timeout_sec=2.0)
    wait_until(lambda: 'x' in panel, 'the panel to find the node', 20)
    process.send_signal(signal.SIGSTOP)  # it stands still in mid-work
    by_hand(panel['x'].editors[0], '5')
    wait_until(lambda: 'Waiting for the node' in texts(panel), 'the panel to say that it waits')
    wait_until(lambda: panel['x'].message, 'the panel to give up', 20)
    assert '/stopped did not answer set_parameters within 2 s' in panel['x'].message
    wait_until(lambda: shows(panel, 'x') == ('1',), 'the control to spring back')
    process.send_signal(signal.SIGCONT)  # it does what it was asked to, late
    wait_until(lambda: shows(panel, 'x') == ('5',), 'the panel to hear of it', 20)
    panel.close()


# -- restarts -------------------------------------------------------------------------------------------


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
    by_hand(panel['max_speed_rpm'].editors[0], '120')
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
    assert [type(widget).__name__ for widget in panel['joints'].editors] == ['_Text']
    assert shows(panel, 'joints') == ('many',)


@pytest.mark.parametrize('view', [ParameterPanel, StepResponseView])
def test_a_panel_without_an_executor_says_so_and_comes_alive_with_one(view):
    param_tutorial.stop()
    panel = view('/pid_controller_node')
    assert 'no executor is running' in (panel.status if view is ParameterPanel else panel.text)
    param_tutorial.start().add(PidControllerNode)
    panel.settle()
    assert panel.names if view is ParameterPanel else 'rise time' in panel.text
    panel.close()
    param_tutorial.start()


@pytest.mark.parametrize('view', [ParameterPanel, LogView, EventView, RobotView, StepResponseView])
def test_a_view_of_nonsense_says_so_and_nothing_else(ros, view, monkeypatch):
    others = []
    monkeypatch.setattr(sys, 'unraisablehook', lambda each: others.append(each.exc_value))
    with pytest.raises(TypeError, match='3 is no node'):
        view(3)
    gc.collect()  # and ipywidgets closes what was never built
    assert others == []


def test_a_panel_outlives_the_executor(ros):
    ros.add(SimpleParamNode)
    panel = ParameterPanel('/simple_param_node')
    param_tutorial.stop()
    wait_until(lambda: panel['robot_name'].editors[0].disabled, 'the control to be locked')
    assert 'no executor is running' in panel.status
    panel['robot_name'].value = 'X'
    panel.settle()
    assert 'no executor is running' in panel['robot_name'].message
    executor = param_tutorial.start()
    executor.add(SimpleParamNode)
    panel.settle()
    assert panel.status == ''
    by_hand(panel['robot_name'].editors[0], 'Y')
    panel.settle()
    assert ParameterClient('/simple_param_node').get_parameter('robot_name') == 'Y'
    executor.remove_all()


def test_a_request_under_way_when_the_executor_stops(ros):
    node = ros.add(Gate)
    panel = ParameterPanel('/gate')
    panel['x'].value = 1
    assert node.entered.acquire(timeout=10)
    node.open.release()
    param_tutorial.stop()
    panel.settle()
    assert panel.status


@pytest.mark.slow
def test_a_panel_of_a_node_that_is_not_there_waits_for_it(ros):
    ros.add(SimpleParamNode)
    panel = ParameterPanel('simple_parm_node')
    assert 'there is no node /simple_parm_node. Did you mean /simple_param_node?' in panel.status
    assert panel.status in texts(panel)

    class Late(Node):
        def __init__(self):
            super().__init__('simple_parm_node')
            self.declare_parameter('x', 1)

    ros.add(Late)
    wait_until(lambda: 'x' in panel, 'the panel to find the node')
    panel.close()


# -- the page -------------------------------------------------------------------------------------------


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


def test_a_node_or_a_client_will_do_for_a_name(ros):
    node = ros.add(SimpleParamNode)
    for each in (node, ParameterClient('/simple_param_node')):
        panel = ParameterPanel(each)
        assert panel.node == '/simple_param_node'


def test_groups_have_headings_and_every_nodes_parameters_come_last(arm):
    assert arm.names[-2:] == ['use_sim_time', 'start_type_description_service']
    kinds = [getattr(child, 'value', '') for child in arm.children]
    assert [text for text in kinds if 'role="heading"' in text] == [
        '<div role="heading" aria-level="4">gains</div>', '<div role="heading" aria-level="4">In every node</div>']
    assert arm['gains.kp'].editors[0].description == 'kp'


def test_text_from_a_node_is_not_taken_for_html(ros):
    evil = '<img src=x onerror=alert(1)>'

    class Evil(Node):
        def __init__(self):
            super().__init__('evil')
            self.declare_parameter('x', 1, Describe(description=evil, additional_constraints=evil))
            self.declare_parameter('<img src=y>.z', evil)
            self.add_on_set_parameters_callback(
                lambda parameters: SetParametersResult(successful=False, reason=evil))
            self.get_logger().warning(evil)

    ros.add(Evil)
    panel, view = ParameterPanel('/evil'), LogView('/evil')
    panel['x'].value = 2
    panel.settle()
    wait_until(lambda: '&lt;img src=x' in texts(view), 'the log')
    assert panel['x'].message == evil
    assert texts(panel).count('&lt;img src=x onerror=alert(1)&gt;') == 3
    assert '<img' not in texts(panel) + texts(view)
    assert not panel['x'].editors[0].description_allow_html


def test_after_closing_nothing_listens_any_more(ros):
    ros.add(SimpleParamNode)
    def listeners():
        return [len(each) for each in (ros._event_listeners, ros._graph_listeners, stage._change_listeners,
                                       ros.node_log._listeners)]
    before = listeners()
    panel, view = ParameterPanel('/simple_param_node'), LogView()
    assert listeners() == [before[0] + 1, before[1] + 1, before[2] + 2, before[3] + 1]
    gone = weakref.ref(panel), weakref.ref(view)
    panel.close()
    panel.close()
    view.close()
    assert listeners() == before
    del panel, view

    def all_gone():
        gc.collect()
        return not any(reference() for reference in gone)
    wait_until(all_gone, 'the closed widgets to be collected')


def test_a_cell_that_runs_again_closes_what_it_made(ros, monkeypatch):
    ros.add(SimpleParamNode)
    run = [('cell 1', 'run 1')]
    monkeypatch.setattr(cells, '_this_cell', lambda: run[0])
    monkeypatch.setattr(cells, '_made', {})
    first, second = ParameterPanel('/simple_param_node'), LogView()
    run[0] = ('cell 2', 'run 2')
    elsewhere = ParameterPanel('/simple_param_node')
    assert 'closed' not in repr(first)
    run[0] = ('cell 1', 'run 3')
    ParameterPanel('/simple_param_node').close()
    assert repr(first) == '<ParameterPanel: /simple_param_node, closed>'
    assert second.comm is None
    assert repr(elsewhere) == '<ParameterPanel: /simple_param_node, 9 parameters>'


def test_the_worker_threads_end(arm):
    arm['tool'].value = 'saw'
    arm.settle()
    wait_until(lambda: not worker_threads(), 'the panel to have no thread while there is nothing to do')
    by_hand(arm['tool'].editors[0], 'drill')
    wait_for_value(arm, 'tool', 'drill')


# -- the log --------------------------------------------------------------------------------------------


def test_the_log_view_follows_all_nodes_or_one(ros):
    view, one = LogView(), LogView('simple_param_node')
    assert repr(view) == '<LogView: all nodes>'
    assert repr(one) == '<LogView: /simple_param_node>'
    assert 'nothing logged yet' in texts(view)
    ros.add(SimpleParamNode)
    node = ros.add(Node, 'other')
    node.get_logger().error('from another')
    wait_until(lambda: '<span class="param-log-loud">[ERROR] [other]: from another</span>' in texts(view),
                          'the line')
    wait_until(lambda: 'robot_serial_number: SN-CLAW-001' in texts(one), 'the lines of the one node')
    assert 'from another' not in texts(one)
    assert 'role="log"' in texts(one)


def test_a_chatty_node_is_shown_its_last_lines_in_few_updates(ros):
    node = ros.add(Node, 'chatty')
    view = LogView()
    updates = []
    view._content.observe(lambda change: updates.append(change['new']), 'value')
    for number in range(1000):
        node.get_logger().info(f'line {number}')
    wait_until(lambda: 'line 999' in texts(view), 'the last line')
    assert len(updates) < 100
    assert max(update.count('\n') for update in updates) < 300


def test_the_log_view_follows_a_new_executor(ros):
    view = LogView()
    param_tutorial.stop()
    param_tutorial.start().add(SimpleParamNode)
    wait_until(lambda: 'Parameters declared' in texts(view), 'the line')
