"""Kernels that are reached through sockets in a folder, and not through ports.

Jupyter chooses five free ports, and the kernel takes them a second later. Where hundreds of kernels and browsers start,
another process is there first once in a while. The kernel then dies, or its client waits forever.
"""

import tempfile
import uuid

from jupyter_client.manager import KernelManager as KernelManagerOnPorts
from traitlets import default


class KernelManager(KernelManagerOnPorts):
    """A kernel manager for tests."""

    def _transport_default(self) -> str:
        return 'ipc'

    @default('ip')
    def _folder_default(self) -> str:
        # The path of a socket may have 107 characters at most.
        return f'{tempfile.gettempdir()}/{uuid.uuid4().hex[:12]}'
