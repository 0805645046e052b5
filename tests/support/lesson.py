"""A notebook in the shape of a chapter, for tests that must not depend on any one chapter."""

from pathlib import Path

import nbformat
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook

LESSON = (
    '# A lesson\nStart ROS in the background, and a node in it:',
    'import param_tutorial\nfrom param_tutorial.nodes.simple_param_node import SimpleParamNode\n\n'
    'executor = param_tutorial.start()\nnode = executor.add(SimpleParamNode)',
    'Its parameters, as controls:',
    "panel = param_tutorial.ParameterPanel('/simple_param_node')\npanel",
    'What it says:',
    'param_tutorial.LogView()',
)

# Every type, groups, read-only, unset, and text that must not be taken for HTML.
ALL_TYPES = (
    '# All types of parameters',
    '''import param_tutorial
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor as D, SetParametersResult
from rclpy.node import Node
from rclpy.parameter import Parameter

class Arm(Node):
    def __init__(self):
        super().__init__('arm', namespace='/clawbot')
        declare = self.declare_parameter
        declare('enabled', True, D(description='Motors on.'))
        declare('joints', 5, D(description='Number of joints.',
            integer_range=[IntegerRange(from_value=1, to_value=12, step=4)]))
        declare('serial', 2**62 + 1, D(description='Beyond what JavaScript can count.'))
        declare('tool', 'grip <b>"per"</b> & ü 机械', D(
            description='Name of the <i>tool</i>.', additional_constraints='At most 40 characters.'))
        declare('notes', 'first line\\nsecond line', D(description='Free text.'))
        declare('gains.kp', 1.25, D(description='Proportional gain.',
            floating_point_range=[FloatingPointRange(from_value=0.0, to_value=10.0, step=0.25)]))
        declare('gains.ki', 0.1, D(description='Integral gain.',
            floating_point_range=[FloatingPointRange(from_value=0.0, to_value=1.0)]))
        declare('gains.kd', 0.0, D(description='Derivative gain.'))
        declare('limits.lower', [-1.5, -2.0, float('-inf')], D(description='Lower joint limits in rad.'))
        declare('limits.homed', [True, False, False])
        declare('limits.order', [3, 1, 2])
        declare('limits.names', ['base', 'elbow, left', 'wrist'])
        declare('firmware', [b'\\x00', b'\\xff'], D(description='Raw bytes.', read_only=True))
        declare('payload', 1.5, D(description='May hold any type.', dynamic_typing=True))
        declare('calibrated_at', Parameter.Type.STRING, D(description='Declared without a value.'))

executor = param_tutorial.start()
arm = executor.add(Arm)''',
    "panel = param_tutorial.ParameterPanel('/clawbot/arm')\npanel",
)


# Names and descriptions too long for a line, with no place where it could break.
LONG_NAMES = (
    '# Long names',
    '''import param_tutorial
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor as D
from rclpy.node import Node

class Long(Node):
    def __init__(self):
        super().__init__('long' * 12, namespace='/name' * 12)
        self.declare_parameter('check' * 12, True, D(description='x' * 200))
        self.declare_parameter('text' * 20, 'word ' * 200, D(read_only=True))
        self.declare_parameter('group.' * 20 + 'number' * 12, 0.5, D(
            floating_point_range=[FloatingPointRange(from_value=0.0, to_value=1.0)]))

param_tutorial.ParameterPanel(param_tutorial.start().add(Long))''',
)


def write(path: Path, cells: tuple[str, ...] = LESSON) -> Path:
    """Write a notebook, not executed: text that starts like a sentence is Markdown, the rest code."""
    notebook = new_notebook(cells=[
        (new_markdown_cell if text.startswith('#') or text.endswith(':') else new_code_cell)(text) for text in cells])
    notebook.metadata.kernelspec = {'name': 'python3', 'display_name': 'Python 3', 'language': 'python'}
    nbformat.write(notebook, path)
    return path
