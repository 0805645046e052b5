"""%ros2 and %%ros2 in an IPython shell: what is typed, where it goes, and which ros2 answers."""

import os
import subprocess
import textwrap
import warnings

import pytest
from IPython.utils.capture import capture_output

from param_tools.ros import domain
from param_tutorial import ParameterClient
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from param_tutorial.notebook import magics


@pytest.fixture
def shell(ipython):
    return ipython


@pytest.fixture
def cell(shell):
    """Run a cell; return what it printed on standard output and standard error, and the exit status."""
    def run(text):
        with capture_output() as captured:
            result = shell.run_cell(text)
        result.raise_error()
        return captured.stdout, captured.stderr, shell.user_ns.get('_exit_code')

    return run


@pytest.fixture
def node(ros):
    return ros.add(SimpleParamNode)


def test_an_answer_goes_to_standard_output_and_a_rejection_to_standard_error(cell, node):
    assert cell('%ros2 param set /simple_param_node max_speed_rpm 150') == ('Set parameter successful\n', '', 0)
    assert cell('%ros2 param get /simple_param_node max_speed_rpm') == ('Integer value is: 150\n', '', 0)
    stdout, stderr, status = cell('%ros2 param set /simple_param_node max_speed_rpm -1')
    assert (stdout, status) == ('', 0)
    assert stderr == 'Setting parameter failed: max_speed_rpm must not be negative, got -1\n'
    assert cell('%ros2 param get /nobody x') == ('', 'Node not found\n', 1)


def test_values_in_quotes_arrive_as_they_are_typed(cell, shell, node):
    shell.user_ns['robot'] = 'EXPANDED'
    for value in ('{robot}', '$robot', 'a > b', 'back\\slash'):
        # Quoted twice, as learners are told to: once for the command line, once for YAML.
        assert cell(f"""%ros2 param set /simple_param_node robot_name "'{value}'" """)[1:] == ('', 0)
        assert ParameterClient('/simple_param_node').get_parameter('robot_name') == value


def test_a_cell_runs_one_command_a_line_and_goes_on_after_a_failure(cell, node):
    stdout, stderr, status = cell(textwrap.dedent('''\
        %%ros2
        # The word ros2 may be there, as in a terminal.
        ros2 param get /nobody x

        param set /simple_param_node \\
            max_speed_rpm 170   # and a comment here
        param get /simple_param_node max_speed_rpm
        '''))
    assert stdout == 'Set parameter successful\nInteger value is: 170\n'
    assert stderr == 'Node not found\n'
    assert status == 0


def test_output_goes_into_a_file(cell, node, tmp_path):
    path = tmp_path / 'my file.yaml'
    assert cell(f'%ros2 param dump /simple_param_node > "{path}"') == ('', '', 0)
    assert path.read_text().startswith('/simple_param_node:\n  ros__parameters:\n')
    assert cell(f'%ros2 param get /simple_param_node robot_name >>"{path}"') == ('', '', 0)
    assert path.read_text().endswith('\nString value is: Clawbot\n')
    assert cell(f'%ros2 param get /nobody robot_name > "{path}"') == ('', 'Node not found\n', 1)
    assert path.read_text() == ''


@pytest.mark.parametrize(('line', 'complaint'), [
    ('param list>a|sort', "'|' needs a shell"),
    ('param list >', 'a file name must follow'),
    ('param list 2> a', 'only one >'),
    ("param set /n a 'x", 'cannot be split'),
    ('param list > no/such/folder/file', 'No such file or directory'),
    # The advice leaves the other nodes alone: start() would remove them.
    ('run param_tutorial simple_param_node', "Run it beside the notebook: terminal = param_tutorial.Terminal('ros2 run "
     "param_tutorial simple_param_node'); or add its node to the executor in the notebook: ros.add(...)\n"),
])
def test_what_is_not_one_command_is_rejected_with_a_sentence(cell, ros, line, complaint):
    stdout, stderr, status = cell(f'%ros2 {line}')
    assert (stdout, status) == ('', 1)
    assert complaint in stderr
    assert stderr.count('\n') == 1


@pytest.mark.parametrize(('line', 'words', 'target'), [
    ("param set /n a '>'", ['param', 'set', '/n', 'a', '>'], None),
    (r'param set /n a \>', ['param', 'set', '/n', 'a', '>'], None),
    (r'param set /n a "\"|\"" # a comment > f', ['param', 'set', '/n', 'a', '"|"'], None),
    ("param set /n a 'x #1'>f", ['param', 'set', '/n', 'a', 'x #1'], 'f'),
    ('ros2 param > f dump /n', ['param', 'dump', '/n'], 'f'),
    ("param list > '>'", ['param', 'list'], '>'),
    (' # ros2 param list | sort', [], None),
])
def test_a_line_is_split_as_bash_splits_it(tmp_path, line, words, target):
    assert magics._parse(line) == (words, target, False)
    functions = """ros2() { printf '%s\\0' "$@"; }; param() { ros2 param "$@"; }"""
    done = subprocess.run(['bash', '-c', f'{functions}\n{line}'], cwd=tmp_path, capture_output=True, check=True)
    output = done.stdout if target is None else (tmp_path / target).read_bytes()
    assert output.decode().split('\0')[:-1] == words
    assert [path.name for path in tmp_path.iterdir()] == ([] if target is None else [target])


# -- a terminal beside the notebook ----------------------------------------------------------------------------


def test_the_line_for_a_terminal_makes_it_see_the_nodes_and_a_genuine_command_stays_the_one(node, tmp_path):
    line = magics.terminal_line()
    plain = {name: value for name, value in os.environ.items() if not name.startswith(('ROS_', 'FAST'))}
    done = subprocess.run(['bash', '-O', 'expand_aliases', '-c', f'{line}\nros2 node list'], env=plain,
                          capture_output=True, text=True)
    assert (done.stdout, done.stderr) == ('/simple_param_node\n', '')
    genuine = tmp_path / 'ros2'
    genuine.write_text('#!/bin/sh\necho genuine')
    genuine.chmod(0o755)
    plain['PATH'] = f'{tmp_path}{os.pathsep}{plain["PATH"]}'
    done = subprocess.run(['bash', '-O', 'expand_aliases', '-c', f'{line}\nros2 node list'], env=plain,
                          capture_output=True, text=True)
    assert (done.stdout, done.stderr) == ('genuine\n', '')


def test_the_hint_shows_the_line_and_is_the_same_in_every_stored_output(shell):
    hint = shell.run_line_magic('ros2_terminal', '')
    assert f'ROS_DOMAIN_ID={domain.choose()}' in hint.value
    assert str(domain.choose()) not in repr(hint)


def test_a_cell_reads_only_what_was_logged_since_it_began(shell, ros):
    node = ros.add(SimpleParamNode)
    node.get_logger().info('before the cell')
    shell.user_ns.update(ros=ros, node=node)
    with capture_output() as captured:
        shell.run_cell("node.get_logger().info('in the cell')\nprint(ros.node_log.read(until='in the cell'))")
    assert captured.stdout == '[INFO] [simple_param_node]: in the cell\n'


def test_a_client_that_has_gone_says_nothing_in_the_cell_that_runs(cell):
    words = 'failed to send response (timeout): client will not receive response'
    with warnings.catch_warnings(record=True) as seen:
        warnings.simplefilter('always')
        cell(f'%reload_ext param_tutorial\nimport warnings\nfor each in ("{words}", "another"):\n'
             '    warnings.warn(each, RuntimeWarning)')
    assert [str(each.message) for each in seen] == ['another']
