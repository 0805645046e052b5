"""The executor in a real Jupyter kernel: an interrupt, and what a person does on the page while cells run."""

import threading

import pytest
from ipykernel.comm.comm import BaseComm

from param_tutorial import wait_until
from tests.support.kernels import DEADLINE_SEC, Kernel

START = '''
%load_ext param_tutorial
import time
import param_tutorial
from param_tutorial import ParameterClient, ParameterPanel
from param_tutorial.nodes.simple_param_node import SimpleParamNode
ros = param_tutorial.start()
node = ros.add(SimpleParamNode)
panel = ParameterPanel(node)
'''


@pytest.fixture
def kernel():
    kernel = Kernel()
    yield kernel
    kernel.kill()


def test_interrupt_ends_the_cell_and_not_the_node(kernel):
    kernel.run(START)
    assert 'KeyboardInterrupt' in kernel.run("print('busy', flush=True)\ntime.sleep(1000)", interrupt_on='busy')
    assert kernel.run("ParameterClient(node).set_parameter('max_speed_rpm', 3)") == (
        '/simple_param_node accepted max_speed_rpm = 3')
    assert kernel.end() == 0


class Page:
    """What a kernel sees of a page in a browser: a subshell, which handles what a person does with widgets."""

    def __init__(self, kernel):
        self._client = kernel.client
        self._model_id = kernel.run('print(panel._front.model_id)').strip()
        self._subshell = self._ask('create_subshell_request', {})['subshell_id']

    def _ask(self, kind, content):
        self._client.control_channel.send(self._client.session.msg(kind, content))
        return self._client.control_channel.get_msg(timeout=DEADLINE_SEC)['content']

    def enter(self, speed):
        """Send what the script of the panel sends when a person enters a speed."""
        message = self._client.session.msg('comm_msg', {'comm_id': self._model_id, 'data': {
            'method': 'custom', 'content': {
                'do': 'enter', 'client': 'page', 'name': 'max_speed_rpm', 'number': 1, 'text': str(speed)}}})
        message['header']['subshell_id'] = self._subshell
        self._client.shell_channel.send(message)

    def close(self):
        self._ask('delete_subshell_request', {'subshell_id': self._subshell})


def test_a_panel_answers_while_a_cell_waits_for_it(kernel, tmp_path):
    waits = tmp_path / 'waits'

    def enter_when_the_cell_waits():
        wait_until(waits.exists, 'the cell to wait', DEADLINE_SEC)
        page.enter(55)

    def wait_for(speed):
        return f"param_tutorial.wait_until(lambda: panel['max_speed_rpm'].value == {speed}, 'it', {DEADLINE_SEC})"

    kernel.run(START)
    page = Page(kernel)
    hand = threading.Thread(target=enter_when_the_cell_waits)
    hand.start()
    assert kernel.run(f"open('{waits}', 'w').close()\n{wait_for(55)}") == 'True'
    hand.join()
    # The next page has another subshell, and the one of this page is gone.
    page.close()
    Page(kernel).enter(60)
    assert kernel.run(wait_for(60)) == 'True'


@pytest.mark.skipif(not hasattr(BaseComm, '_reply_subshell_for'),
                    reason='ipykernel before 7.4, which Python 3.10 gets, does not say that a message has come')
def test_a_cell_begins_when_all_is_done_that_was_done_on_the_page_before_it(kernel):
    kernel.run(START)
    page = Page(kernel)
    # The thread beside the cells is slow.
    kernel.run('enter = panel._enter; panel._enter = lambda content: [time.sleep(0.1), enter(content)]')
    for speed in (55, 56):
        page.enter(speed)
    assert kernel.run("panel.settle(); panel['max_speed_rpm'].value") == '56'
