"""The commands snapshot, diff and restore, and one parameter of all nodes."""

import pytest
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools.files.parameter_files import read_all
from param_tutorial import ParameterClient
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from tests.support.commands import run


class Camera(Node):
    """Stands for any node of a robot."""

    def __init__(self, robot):
        super().__init__('camera', namespace=robot)
        self.declare_parameter('rate', 30)


def test_all_nodes_are_saved_changed_compared_and_restored(ros, tmp_path):
    ros.add(SimpleParamNode)
    ros.add(Camera, '/left')
    path = tmp_path / 'monday.yaml'
    assert run('snapshot', '--save', path) == (f'Saved 12 parameters of 2 nodes to {path}\n', '', 0)
    ParameterClient('/left/camera').set_parameter('rate', 15)
    ParameterClient('/simple_param_node').set_parameter('robot_name', 'Berta')
    stdout, stderr, status = run('diff', path, '/**')
    assert stdout == f'''\
{path} → /**: 2 differences in 2 nodes, 0 nodes the same

node                parameter   difference     {"before":9}  after
/left/camera        rate        changed value  30         15
/simple_param_node  robot_name  changed value  'Clawbot'  'Berta'
'''
    assert (stderr, status) == ('', 1)
    stdout, stderr, status = run('restore', path, '/left/camera', '--dry-run')
    assert stdout == f'''\
/left/camera from {path}: 1 of 1 parameter would be set

parameter  wanted  outcome       reason
rate       30      would be set
'''
    assert (stderr, status) == ('', 0)
    assert ParameterClient('/left/camera').get_parameter('rate') == 15
    stdout, stderr, status = run('restore', path)
    assert stdout == f'''\
2 nodes from {path}: complete, 2 parameters set

node                parameter   wanted     outcome  reason
/left/camera        rate        30         set
/simple_param_node  robot_name  'Clawbot'  set
'''
    assert (stderr, status) == ('', 0)
    assert run('diff', path, '/**') == (f'{path} → /**: 0 differences in 0 nodes, 2 nodes the same\n', '', 0)


class Sparse(Node):
    """Has what a parameter file cannot hold."""

    def __init__(self):
        super().__init__('sparse')
        self.declare_parameter('gain', 1.0)
        self.declare_parameter('raw', [b'\x01'])
        self.declare_parameter('unset', Parameter.Type.DOUBLE)


def test_what_a_snapshot_cannot_hold_is_no_difference_from_it(ros, tmp_path):
    ros.add(Sparse)
    path = tmp_path / 'monday.yaml'
    stdout, stderr, _ = run('snapshot', '--save', path)
    assert stdout.startswith('Saved 3 parameters of 1 node')
    assert 'left out: /sparse: unset: it has no value\n' in stderr
    for words in ((path, '/sparse'), ('/sparse', path)):
        stdout, stderr, status = run('diff', *words)
        assert ': 0 differences, ' in stdout
        assert (stderr, status) == ('', 0)
    # As soon as it has a value that the file could hold, it is new.
    ParameterClient('/sparse').set_parameter('unset', 0.5)
    stdout, stderr, status = run('diff', path, '/sparse')
    assert stdout.splitlines()[-1].split() == ['unset', 'added', '-', '0.5']
    assert (stderr, status) == ('', 1)


def test_two_nodes_of_one_name_are_pointed_out(ros, silent):
    ros.add(Camera, '/left')
    ros.add(Node, 'silent')
    warning = ('WARNING: 2 nodes are called /silent. What is said or done here is about one of them, and ROS does not '
               'tell which.\n')
    for words in (('snapshot', '/silent'), ('snapshot',), ('diff', '/silent', '/left/camera')):
        assert run(*words)[1].startswith(warning)
    assert run('snapshot', '/left/camera')[1] == ''
    assert run('snapshot', '/silen')[1] == 'there is no node /silen. Did you mean /silent?\n'


def test_a_node_that_hangs_is_reported_and_the_rest_is_complete(ros, silent, tmp_path):
    ros.add(Camera, '/left')
    path = tmp_path / 'monday.yaml'
    stdout, stderr, status = run('snapshot', '--timeout', '0.5', '--save', path)
    assert stdout.startswith('Saved 3 parameters of 1 node')
    assert stderr.startswith('/silent did not answer')
    assert status == 1
    assert list(read_all(path)) == ['/left/camera']
    assert run('diff', path, '/**', '--timeout', '0.5')[2] == 2
    path.write_text(path.read_text() + '/silent:\n  ros__parameters:\n    a: 1\n')
    for words in ((), ('--dry-run',)):
        stdout, stderr, status = run('restore', path, '--timeout', '0.5', *words)
        assert stdout.splitlines()[0].endswith('1 without an answer')
        assert '/silent did not answer' in stderr
        assert status == 1


@pytest.mark.parametrize(('words', 'complaint', 'expected'), [
    (['diff', '/nobody', '/nobody'], 'there is no node /nobody', 2),
    (['diff', 'nowhere.yaml', '/**'], 'no node is running', 2),
    (['diff', 'nowhere.yaml', 'nowhere.yaml'], 'cannot read nowhere.yaml', 2),
    (['restore', 'nowhere.yaml'], 'cannot read nowhere.yaml', 1),
    (['snapshot', '/nobody'], 'there is no node /nobody', 1),
    (['diff', '/a'], 'the following arguments are required: AFTER', 2),
])
def test_what_is_not_there_gets_a_sentence(ros, words, complaint, expected):
    stdout, stderr, status = run(*words)
    assert (stdout, status) == ('', expected)
    assert complaint in stderr
    assert 'Traceback' not in stderr
