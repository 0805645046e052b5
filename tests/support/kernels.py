"""Real kernels, and what their cells print. They are reached through sockets in a folder, and not through ports.

Jupyter chooses five free ports, and the kernel takes them a second later. Where hundreds of kernels and browsers start,
another process is there first once in a while. The kernel then dies, or its client waits forever.
"""

import tempfile
import time
import uuid
from collections.abc import Iterator
from typing import Any

import zmq
from jupyter_client import manager
from traitlets import default

from param_tools.ros.waiting import wait_until
from tests.support.processes import environment_without_domain

# Less than a test may take.
DEADLINE_SEC = 170
PRESS_AGAIN_SEC = 5


class KernelManager(manager.KernelManager):
    """A kernel manager for tests."""

    def _transport_default(self) -> str:
        return 'ipc'

    @default('ip')
    def _folder_default(self) -> str:
        # The path of a socket may have 107 characters at most.
        return f'{tempfile.gettempdir()}/{uuid.uuid4().hex[:12]}'


class Kernel:
    """A kernel, and what its cells printed."""

    def __init__(self) -> None:
        """Start it, with a ROS domain of its own."""
        self.manager = KernelManager(kernel_name='python3')
        self.manager.start_kernel(env=environment_without_domain())
        self.client = self.manager.blocking_client()
        self.client.start_channels()
        self.client.wait_for_ready(DEADLINE_SEC)
        # What was printed for a cell that had ended; a page shows it below that cell.
        self.late = ''

    def run(self, code: str, *, cell: str = '', interrupt_on: str = '') -> str:
        """Run a cell; return its printed and shown text, with an error's name at the end.

        :param cell: Which one it is, as front ends say with each run, so that what it showed before goes.
        :param interrupt_on: Press "interrupt" when this text has been printed, and again while nothing comes of it: of
            1,500 times, ipykernel 7 lost one that came while print() was flushing, also without this package.
        :raises TimeoutError: the cell has not ended after DEADLINE_SEC.
        """
        text: list[str] = []
        waiting = bool(interrupt_on)
        self.client.session.metadata = {'cellId': cell} if cell else {}
        # By default, a cell that raises has the kernel drop what it gets within the next moment, on a busy machine too.
        request = self.client.execute(code, allow_stdin=False, stop_on_error=False)
        for message in self._messages(request, text, interrupt_on):
            content = message['content']
            if message['msg_type'] == 'stream':
                text.append(content['text'])
                if waiting and interrupt_on in ''.join(text):
                    waiting = False
                    self.manager.interrupt_kernel()
            elif message['msg_type'] == 'execute_result':
                text.append(content['data']['text/plain'])
            elif message['msg_type'] == 'error':
                text.append(f'{content["ename"]}: {content["evalue"]}')
        return ''.join(text)

    def _messages(self, request: str, text: list[str], interrupt_on: str) -> Iterator[dict[str, Any]]:
        """Yield the messages about a request until it is done with.

        :param text: What has been printed by then.
        """
        channels = (self.client.stdin_channel, self.client.iopub_channel)
        poller = zmq.Poller()
        for channel in channels:
            poller.register(channel.socket, zmq.POLLIN)
        deadline = time.monotonic() + DEADLINE_SEC
        while time.monotonic() < deadline:
            if not poller.poll(1000 * PRESS_AGAIN_SEC):
                if interrupt_on and interrupt_on in ''.join(text):
                    self.manager.interrupt_kernel()
                continue
            message = next(channel for channel in channels if channel.msg_ready()).get_msg(timeout=0)
            if message['parent_header'].get('msg_id') == request:
                if message['content'].get('execution_state') == 'idle':
                    break
                yield message
            elif message['msg_type'] == 'stream':
                self.late += message['content']['text']
        else:
            raise TimeoutError(f'the cell has not ended after {DEADLINE_SEC} s; what came:\n'
                               f'{"".join(text) or "(nothing)"}')
        while self.client.get_shell_msg(timeout=DEADLINE_SEC)['parent_header'].get('msg_id') != request:
            pass

    def end(self) -> int:
        """Shut the kernel down as JupyterLab does, and return its exit status."""
        process = self.manager.provisioner.process
        self.client.shutdown()
        wait_until(lambda: process.poll() is not None, 'the kernel to end', DEADLINE_SEC)
        self.client.stop_channels()
        self.manager.cleanup_resources()
        return process.returncode

    def kill(self) -> None:
        """Kill the kernel, whatever it is doing."""
        if self.manager.has_kernel:
            self.client.stop_channels()
            self.manager.shutdown_kernel(now=True)
