"""What a kernel keeps of a chapter whose cells run again and again."""

import ast
from collections import Counter
from pathlib import Path

import nbformat

from tests.support.kernels import Kernel

# IPython keeps all that was typed, shown and returned, for good and by design, and Jupyter the signatures of the last
# 65,536 messages; that is not the course's.
_FORGET = '''
def _forget():
    import re
    shell = get_ipython()
    history = shell.history_manager
    for kept in (history.outputs, history.exceptions, history.output_hist_reprs, shell.user_ns['Out']):
        kept.clear()
    for typed in (history.input_hist_parsed, history.input_hist_raw):
        del typed[1:]
    for names in (shell.user_ns, shell.user_ns_hidden):
        for name in [name for name in names if re.fullmatch('_[_i]*[0-9]*', name)]:
            del names[name]
    shell.displayhook._ = shell.displayhook.__ = shell.displayhook.___ = None
    shell.kernel.session.digest_history.clear()
_forget()
'''
_COUNT = '''
def _count():
    import collections, gc, threading
    from param_tools.ros import stage
    executor = stage.current()
    # It holds the lines of one run. How many of them came from processes that end at once is luck.
    executor.node_log.clear()
    gc.collect()
    named = ((str(type(each).__module__), type(each).__qualname__) for each in gc.get_objects())
    counted = collections.Counter(f'{module}.{name}' for module, name in named if module.startswith(
        ('param_tutorial', 'rclpy', 'ipywidgets', 'ipykernel.comm')))
    # rclpy leaves one behind of each node that a cell creates without the executor: in 9.2 and 10.2.
    observer = executor.tool_node
    services = sum(observer.count_services(name) for name, _ in observer.get_service_names_and_types()
                   if name not in ('/lonely/get_type_description', '/dozing/get_type_description'))
    return {**counted, 'threads': threading.active_count(), 'services in the graph': services}
print(_count())
'''
_RESIDENT = '''
def _resident():
    import ctypes, gc, psutil, time
    from param_tools.ros.services import _RetiredClient
    # The clients of a node that has left are kept for some seconds, 0.1 MiB each: how many just now is luck.
    while any(type(each) is _RetiredClient for each in gc.get_objects()):
        time.sleep(0.1)
    gc.collect()
    ctypes.CDLL(None).malloc_trim(0)
    return psutil.Process().memory_info().rss
print(_resident())
'''


class Chapter:
    """A chapter in a kernel of its own, whose working directory is that of the notebooks."""

    def __init__(self, path: Path, kernel: Kernel) -> None:
        self._kernel = kernel
        self._cells = [(cell.id, cell.source) for cell in nbformat.read(path, as_version=4).cells
                       if cell.cell_type == 'code']
        kernel.run(f'import os\nos.chdir({str(path.parent)!r})')

    def run(self) -> None:
        """Run all its cells, in order; some raise errors."""
        for cell, source in self._cells:
            self._kernel.run(source, cell=cell)

    def forget(self) -> None:
        """Let IPython forget the cells, and what they showed and returned."""
        self._kernel.run(_FORGET)

    def objects(self) -> Counter[str]:
        """Count the objects of the course, rclpy and the widgets that are alive, by their classes; threads; services.

        What only IPython keeps is forgotten first.
        """
        self.forget()
        return Counter(ast.literal_eval(self._kernel.run(_COUNT)))

    def resident_bytes(self) -> int:
        """Return how much memory the kernel holds."""
        return int(self._kernel.run(_RESIDENT))
