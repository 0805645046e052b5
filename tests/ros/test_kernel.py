"""The executor in a real Jupyter kernel: re-run cells, interrupts, errors, restarts and the end."""

import signal
import threading
from pathlib import Path

import psutil
import pytest
from ipykernel.comm.comm import BaseComm

from param_tools.ros import domain
from param_tutorial import wait_until
from param_tutorial.exercises import PREDICTIONS
from tests.support.kernels import DEADLINE_SEC, Kernel

pytestmark = pytest.mark.slow

START = '''
import param_tutorial
from param_tutorial import ParameterClient, ParameterPanel
from param_tutorial.nodes.simple_param_node import SimpleParamNode
ros = param_tutorial.start()
node = ros.add(SimpleParamNode)
client = ParameterClient(node)
'''


@pytest.fixture
def kernel():
    kernel = Kernel()
    yield kernel
    kernel.kill()


def test_cells_may_be_run_again_in_any_order(kernel):
    kernel.run(START)
    kernel.run(START)
    kernel.run('node = ros.add(SimpleParamNode)')
    kernel.run('panel = ParameterPanel(node)')
    kernel.run('panel = ParameterPanel(node)')
    kernel.run('param_tutorial.stop()')
    assert 'start()' in kernel.run('client.list_parameters()')
    kernel.run(START)
    assert kernel.run('ros.services.node_names()') == "['/simple_param_node']"
    assert kernel.run("client.set_parameter('max_speed_rpm', 3)") == '/simple_param_node accepted max_speed_rpm = 3'
    assert kernel.end() == 0


def test_interrupt_ends_the_cell_and_not_the_node(kernel):
    text = kernel.run(f"{START}import time\nprint('busy', flush=True)\ntime.sleep(60)", interrupt_on='busy')
    assert 'KeyboardInterrupt' in text
    assert kernel.run("client.set_parameter('max_speed_rpm', 3)") == '/simple_param_node accepted max_speed_rpm = 3'
    assert kernel.end() == 0


def claims(number: int) -> set[str]:
    """Return the sockets on this machine that claim a ROS domain, by their numbers in Linux: at most one."""
    rows = [line.split() for line in Path('/proc/net/unix').read_text().splitlines()]
    return {row[6] for row in rows if row[7:] == [f'@param_tools/ros_domain/{number}']}


def test_a_callback_that_ends_the_process_takes_all_of_it_along(kernel):
    """os._exit runs no handler. What the kernel had started, its domain and its name in the graph go with it."""
    kernel.run(START)
    kernel.run("""
        import os
        from rclpy.node import Node
        class Ends(Node):
            def __init__(self):
                super().__init__('ends')
                self.declare_parameter('x', 1)
                self.add_on_set_parameters_callback(lambda _: os._exit(7))
        ros.add(Ends)
        terminal = param_tutorial.Terminal('ros2 run param_tutorial cart_node')
        param_tutorial.wait_until(lambda: '/cart_node' in ros.services.node_names(), 'the cart', 60)
    """)
    number = int(kernel.run('ros.domain_id'))
    claim = claims(number)
    assert domain._is_used(number) and claim
    process = kernel.manager.provisioner.process
    started = psutil.Process(process.pid).children(recursive=True)
    assert started
    kernel.client.execute("ParameterClient('/ends').set_parameter('x', 2)")
    assert process.wait() == 7
    wait_until(lambda: not any(each.is_running() and each.status() != psutil.STATUS_ZOMBIE for each in started),
               'what the kernel started to end')
    assert not claim & claims(number)


def when_exists(path, act):
    """Do something in a thread as soon as a file exists; return the thread."""
    def wait_and_act():
        wait_until(path.exists, f'{path}', timeout_sec=DEADLINE_SEC)
        act()

    hand = threading.Thread(target=wait_and_act)
    hand.start()
    return hand


SHELL = START + """
import ipywidgets
%load_ext param_tutorial
first = param_tutorial.Shell()
button = ipywidgets.Button()
button.on_click(lambda _: (first.home / 'clicked').touch())
"""
# Only a click ends it.
WAITS_FOR_CLICK = """%%shell first
touch begun
until [ -e clicked ]; do sleep 0.05; done
echo clicked; false"""


def test_a_button_works_while_a_shell_cell_waits(kernel):
    kernel.run(SHELL)
    model_id, home = kernel.run('print(button.model_id, first.home)').split()

    def click():
        content = {'comm_id': model_id, 'data': {'method': 'custom', 'content': {'event': 'click'}}}
        kernel.client.shell_channel.send(kernel.client.session.msg('comm_msg', content))

    hand = when_exists(Path(home) / 'begun', click)
    assert kernel.run(WAITS_FOR_CLICK) == 'clicked\n'
    hand.join()
    assert kernel.run('_exit_code') == '1'


def test_interrupt_ends_what_a_shell_cell_waits_for_and_not_the_shell(kernel):
    kernel.run(SHELL)
    home = Path(kernel.run('print(first.home)').strip())
    hand = when_exists(home / 'begun', lambda: kernel.manager.provisioner.process.send_signal(signal.SIGINT))
    assert 'Error' not in kernel.run("%%shell first\nbash -c ': > begun; exec sleep 1000'")
    hand.join()
    assert kernel.run('_exit_code') == '130'
    assert kernel.run('%%shell first\necho goes on') == 'goes on\n'


class Page:
    """What a kernel sees of a page in a browser: a subshell, which handles what a person does with widgets."""

    def __init__(self, kernel):
        self._client = kernel.client
        self.subshell = self._ask('create_subshell_request', {})['subshell_id']

    def _ask(self, kind, content):
        request = self._client.session.msg(kind, content)
        self._client.control_channel.send(request)
        reply = self._client.control_channel.get_msg()
        assert reply['parent_header']['msg_id'] == request['header']['msg_id']
        return reply['content']

    def touch(self, model_id, content):
        """Send what the script of a widget sends when a person uses it."""
        message = self._client.session.msg('comm_msg', {
            'comm_id': model_id, 'data': {'method': 'custom', 'content': content}})
        message['header']['subshell_id'] = self.subshell
        self._client.shell_channel.send(message)

    def close(self):
        self._ask('delete_subshell_request', {'subshell_id': self.subshell})


PANEL = START + """
from pathlib import Path
panel = ParameterPanel(node)
"""
ENTER = {'do': 'enter', 'client': 'page', 'name': 'max_speed_rpm', 'number': 1}


def test_a_panel_answers_while_a_cell_waits_for_it(kernel, tmp_path):
    wait = "ros.node_log.read(until='max_speed_rpm is now 55', timeout_sec=30)"
    kernel.run(PANEL)
    page, model_id = Page(kernel), kernel.run('print(panel._front.model_id)').strip()
    hand = when_exists(tmp_path / 'waits', lambda: page.touch(model_id, {**ENTER, 'text': '55'}))
    assert 'Error' not in kernel.run(f"Path('{tmp_path}/waits').touch()\n{wait}")
    hand.join()
    # The next page has another subshell, and the one of this page is gone.
    page.close()
    Page(kernel).touch(model_id, {**ENTER, 'text': '60'})
    assert kernel.run(wait.replace('55', '60')) == "'[INFO] [simple_param_node]: max_speed_rpm is now 60'"


@pytest.mark.skipif(not hasattr(BaseComm, '_reply_subshell_for'),
                    reason='ipykernel before 7.4, which Python 3.10 gets, does not say that a message has come')
def test_a_cell_begins_when_all_is_done_that_was_done_on_the_page_before_it(kernel):
    kernel.run('%load_ext param_tutorial' + PANEL)
    page, model_id = Page(kernel), kernel.run('print(panel._front.model_id)').strip()
    # The thread beside the cells is slow.
    kernel.run('import time; ask = panel._enter; panel._enter = lambda content: [time.sleep(0.1), ask(content)]')
    for speed in (55, 56):
        page.touch(model_id, {**ENTER, 'text': f'{speed}'})
    assert kernel.run("panel.settle(); panel['max_speed_rpm'].value") == '56'


def test_a_prediction_is_committed_while_the_cell_that_decides_it_runs(kernel, tmp_path):
    model_id = kernel.run("""
import param_tutorial
from pathlib import Path
from param_tutorial import exercises
view = exercises.predict('3-1')
print(view.model_id)
""").strip()
    page = Page(kernel)
    answer = PREDICTIONS['3-1'].choices[0].text
    hand = when_exists(tmp_path / 'waits', lambda: page.touch(model_id, {'do': 'commit', 'answer': answer}))
    text = kernel.run(f"Path('{tmp_path}/waits').touch()\n"
                      "param_tutorial.wait_until(lambda: view.answer, 'the hand', 30)\nview.is_decided")
    hand.join()
    assert text == 'False'
    assert kernel.run('view.is_decided') == 'True'
