"""Fixtures of the tests of widgets."""

import subprocess
import sys
import textwrap

import pytest
from ipywidgets.widgets.widget import _instances as widget_registry

from param_tools.panel.panel import ParameterPanel
from param_tools.panel.view import View
from param_tools.ros.waiting import wait_until
from tests.support.nodes import Arm
from tests.support.processes import CAN_STAND_STILL
from tests.support.widgets import due_jobs


@pytest.fixture(autouse=True)
def _close_all():
    yield
    for widget in list(widget_registry.values()):
        if isinstance(widget, View):
            widget.close()
    wait_until(lambda: not due_jobs(), 'the threads of closed views to end')


@pytest.fixture
def arm(ros):
    """Return a panel of an Arm."""
    ros.add(Arm)
    panel = ParameterPanel('/arm')
    assert panel.status == ''
    return panel


REMOTE = CAN_STAND_STILL + textwrap.dedent('''
    import signal, sys, threading, rclpy
    from rclpy.node import Node
    rclpy.init()
    node = Node(sys.argv[1])
    node.declare_parameter('x', 1)
    print('ready', flush=True)
    reader = threading.Thread(target=sys.stdin.read)
    reader.start()
    while reader.is_alive():
        rclpy.spin_once(node, timeout_sec=0.05)
    node.destroy_node()
    # A process that ends while the news of its node is under way can leave a ghost in the graph.
    signal.pause()
''')


@pytest.fixture
def remote(ros):
    """Return a function that starts a node of a name in its own process."""
    started = []

    def start(name):
        process = subprocess.Popen([sys.executable, '-c', REMOTE, name],
                                   stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        started.append(process)
        assert process.stdout.readline() == 'ready\n'
        return process

    yield start
    for process in started:
        process.stdin.close()  # which ends the node
    # The next test may expect an empty stage.
    ros.remove_all()
    wait_until(lambda: not ros.services.node_names(), 'the nodes to leave the graph', 20)
    for process in started:
        process.kill()
        process.wait()
        process.stdout.close()
