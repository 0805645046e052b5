"""What the tools assume of rclpy beyond its documentation stands in rclpy_private; what uses it is tested elsewhere."""

import ast
import re

import rclpy
from rcl_interfaces.srv import GetParameters
from rclpy.node import Node

from tests.support.paths import PACKAGE, TOOLS


class CallsNodeByName(Node):
    def __init__(self):
        Node.__init__(self, 'named')


def test_a_class_that_calls_the_constructor_of_node_by_name_is_added_with_its_arguments(ros):
    ros.add(CallsNodeByName, ros_args=['-r', '__node:=turned'])
    assert ros.services.node_names() == ['/turned']


def test_no_other_file_uses_private_names_of_rclpy(ros):
    node = ros.add(Node, 'lamp')
    client = node.create_client(GetParameters, '/nobody/get_parameters')
    private = {name for thing in (node, client, node._parameter_service, rclpy.task.Future(), *node.services)
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
