"""The tools without threads: everything that they do beside a cell is done while the cell waits.

Each test is a process of its own, because the waits of the whole process change. The layer below is the real one, which
has threads, so the process can be watched; Python starts none.
"""

from tests.support.processes import output_of

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
    return output_of(f'{BEGIN}{source}\nparam_tutorial.stop()\n')


def test_a_panel_follows_and_leads():
    assert run("panel = ParameterPanel(node)\nclient.set_parameter('max_speed_rpm', 130)\n"
               "wait_until(lambda: panel['max_speed_rpm'].value == 130, 'the panel')\n"
               "panel['max_speed_rpm'].value = 140\npanel.settle()\nprint(client.get_parameter('max_speed_rpm'))\n"
               "panel._on_message(None, {'do': 'undo'}, None)\nprint(client.get_parameter('max_speed_rpm'))\n"
               'panel.close()') == '140\n130\n'


def test_asyncio_gives_turns_between_the_cells():
    assert run('import asyncio\nticks = []\nnode.create_timer(0.01, lambda: ticks.append(1))\n'
               'async def between():\n'
               '    pump = asyncio.ensure_future(host.pump())\n'
               '    while len(ticks) < 10: await asyncio.sleep(0.01)\n'
               "    param_tutorial.stop()\n    await pump\n    print('ended')\n"
               'asyncio.run(between())') == 'ended\n'


def test_what_comes_of_a_callback_is_done_in_the_same_turn():
    # Or a robot would brake a turn late for each message between its sensor and its motors.
    assert run('done = []\n'
               'host.settle()\n'
               'ros.create_task(lambda: ros.create_task(lambda: done.append(time)))\n'
               'host.turn()\nprint(len(done))') == '1\n'


def test_an_endless_loop_in_a_callback_is_ended_and_the_stage_goes_on():
    said = run('import sys\nsys.stderr = sys.stdout\n'
               'def loop():\n'
               '    timer.cancel()\n'
               '    while True:\n'
               '        try: 1 / 0\n'
               '        except Exception: pass\n'
               'def doze():\n'
               '    dozing.cancel()\n'
               '    while True: time.sleep(0.01)\n'
               'timer, dozing = node.create_timer(0.01, loop), node.create_timer(0.01, doze)\n'
               "wait_until(lambda: len(ros.errors) == 2, 'both to be ended', 30.0)\n"
               "print(client.get_parameter('max_speed_rpm'))")
    words = 'this callback did not return, so it was interrupted: the executor has one thread for all nodes'
    assert said.count(words) == 2
    for name in ('loop', 'doze'):
        assert f'The timer callback {name} of /simple_param_node raised an exception; the node keeps running.' in said
    assert 'interrupts.py' not in said
    assert said.endswith('\n100\n')


def test_an_endless_loop_that_wants_an_answer_again_and_again_is_ended():
    """Its own limit is up while callbacks run, which have another one."""
    assert run('from param_tutorial import exercises\nfrom param_tutorial.exercises import trial\n'
               'trial.TIME_LIMIT_SEC = 0.5\n'
               'def work(parameters, results):\n'
               "    while True: client.set_parameter('max_speed_rpm', 150)\n"
               "print('it was still running after 0.5 s' in repr(exercises.check('5.3c', work)))") == 'True\n'


def test_a_callback_is_not_ended_when_the_limit_of_the_cell_is_up():
    assert run('from param_tools.ros.interrupts import time_limit\n'
               'done = []\n'
               'def tick():\n'
               '    timer.cancel()\n'
               '    time.sleep(0.5)\n'
               '    done.append(True)\n'
               'timer = node.create_timer(0.001, tick)\n'
               'try:\n'
               '    with time_limit(0.2, KeyError): time.sleep(60)\n'
               'except KeyError: print(done, ros.errors)') == '[True] []\n'
