"""The tools without threads: everything that they do beside a cell is done while the cell waits.

Each test is a process of its own, because the waits of the whole process change. The layer below is the real one, which
has threads, so the process can be watched; Python starts none.
"""

import subprocess
import sys

import pytest

pytestmark = pytest.mark.slow

BEGIN = """
import threading, time
from param_tools.ros import turns
host = turns.install()
threading.Thread.start = None
import param_tutorial
from param_tutorial import ParameterClient, ParameterPanel, wait_until
from param_tutorial.nodes.simple_param_node import SimpleParamNode
ros = param_tutorial.start()
node = ros.add(SimpleParamNode)
client = ParameterClient(node)
"""


def run(source):
    """Run a program after BEGIN, and return what it prints."""
    done = subprocess.run([sys.executable, '-c', BEGIN + source + '\nparam_tutorial.stop()\n'], capture_output=True,
                          text=True)
    assert done.returncode == 0, done.stderr
    assert done.stderr == ''
    return done.stdout


def test_a_client_asks_and_is_answered():
    assert run("print(client.set_parameter('max_speed_rpm', 150))\nprint(client.get_parameter('max_speed_rpm'))\n"
               "print(client.set_parameter('max_speed_rpm', -5).reason)") == (
        '/simple_param_node accepted max_speed_rpm = 150\n150\nmax_speed_rpm must not be negative, got -5\n')


def test_a_sleep_lets_the_node_live():
    assert run('ticks = []\nnode.create_timer(0.01, lambda: ticks.append(1))\ntime.sleep(0.5)\n'
               'print(len(ticks) > 10)') == 'True\n'


def test_a_client_of_rclpy_can_be_called_from_the_cell():
    assert run("from rcl_interfaces.srv import ListParameters\n"
               "asking = node.create_client(ListParameters, '/simple_param_node/list_parameters')\n"
               "print('max_speed_rpm' in asking.call(ListParameters.Request()).result.names)") == 'True\n'


def test_a_callback_that_waits_for_its_own_executor_waits_in_vain():
    assert run('said = []\n'
               "def ask():\n"
               "    timer.cancel()\n"
               "    try: client.get_parameter('max_speed_rpm')\n"
               "    except Exception as error: said.append(str(error))\n"
               'timer = node.create_timer(0.01, ask)\n'
               "print('keeps busy' in wait_until(lambda: said, 'a word')[0])") == 'True\n'


def test_a_panel_follows_and_leads():
    assert run("panel = ParameterPanel(node)\nclient.set_parameter('max_speed_rpm', 130)\n"
               "wait_until(lambda: panel['max_speed_rpm'].value == 130, 'the panel')\n"
               "panel['max_speed_rpm'].value = 140\npanel.settle()\nprint(client.get_parameter('max_speed_rpm'))\n"
               "panel._on_message(None, {'do': 'undo'}, None)\nprint(client.get_parameter('max_speed_rpm'))\n"
               'panel.close()') == '140\n130\n'


def test_changes_are_heard_of():
    assert run('from param_tools import ChangeFollower\nheard = []\n'
               'with ChangeFollower(heard.extend):\n'
               "    client.set_parameter('robot_name', 'Berta')\n"
               "    wait_until(lambda: any(each.new == 'Berta' for each in heard), 'the change')\n"
               "print(heard[-1].old)") == 'Clawbot\n'


def test_asyncio_gives_turns_between_the_cells():
    assert run('import asyncio\nticks = []\nnode.create_timer(0.01, lambda: ticks.append(1))\n'
               'async def between():\n'
               '    pump = asyncio.ensure_future(host.pump())\n'
               '    while len(ticks) < 10: await asyncio.sleep(0.01)\n'
               "    param_tutorial.stop()\n    await pump\n    print('ended')\n"
               'asyncio.run(between())') == 'ended\n'
