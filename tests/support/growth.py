"""What a kernel keeps of a chapter whose cells run again and again."""

import ast
from collections import Counter
from pathlib import Path

import nbformat

from tests.support.kernels import Kernel

# IPython keeps what cells showed and returned, for good and by design; that is not the course's.
_FORGET = '''
def _forget():
    shell = get_ipython()
    shell.history_manager.outputs.clear()
    shell.history_manager.exceptions.clear()
    shell.user_ns['Out'].clear()
    for names in (shell.user_ns, shell.user_ns_hidden):
        for name in [name for name in names if name.strip('_').isdigit() or set(name) == {'_'}]:
            del names[name]
    shell.displayhook._ = shell.displayhook.__ = shell.displayhook.___ = None
_forget()
'''
_COUNT = '''
def _count():
    import collections, gc, threading
    gc.collect()
    named = ((str(type(each).__module__), type(each).__qualname__) for each in gc.get_objects())
    counted = collections.Counter(f'{module}.{name}' for module, name in named if module.startswith(
        ('param_tutorial', 'rclpy', 'ipywidgets', 'ipykernel.comm')))
    return {**counted, 'threads': threading.active_count()}
print(_count())
'''
_RESIDENT = '''
def _resident():
    import ctypes, gc, psutil
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
        """Let IPython forget what the cells showed and returned."""
        self._kernel.run(_FORGET)

    def objects(self) -> Counter[str]:
        """Count the objects of the course, rclpy and the widgets that are alive, by their classes, and the threads.

        What only IPython keeps is forgotten first.
        """
        self.forget()
        return Counter(ast.literal_eval(self._kernel.run(_COUNT)))

    def resident_bytes(self) -> int:
        """Return how much memory the kernel holds."""
        return int(self._kernel.run(_RESIDENT))
