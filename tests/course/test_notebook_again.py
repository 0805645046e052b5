"""Cells that run again keep nothing of the runs before, but for what IPython keeps of any cell."""

import ast
import os
from collections import Counter

import nbformat
import pytest

from param_tutorial import wait_until
from tests.support.kernels import Kernel
from tests.support.paths import NOTEBOOKS

# IPython keeps all that was typed, shown and returned, for good and by design; that is not the course's.
FORGET_AND_COUNT = '''
def _count():
    import collections, gc, re, threading
    from param_tools.ros import stage
    shell = get_ipython()
    history = shell.history_manager
    for kept in (history.outputs, history.exceptions, history.output_hist_reprs, shell.user_ns['Out']):
        kept.clear()
    for names in (shell.user_ns, shell.user_ns_hidden):
        for name in [name for name in names if re.fullmatch('_[_i]*[0-9]*', name)]:
            del names[name]
    shell.displayhook._ = shell.displayhook.__ = shell.displayhook.___ = None
    # ipywidgets keeps each widget that nobody closes, and chapter 4 makes one.
    slider = shell.user_ns.get('slider')
    for each in (slider, slider.layout, slider.style) if slider else ():
        each.close()
    executor = stage.current()
    # It holds the lines of one run. How many of them came from processes that end at once is luck.
    executor.node_log.clear()
    # It keeps a client for each service that was called, as long as the node is there. Which these are is luck, too.
    executor.run(lambda: executor.services.forget(''), 'clients end')
    gc.collect()
    named = (f'{type(each).__module__}.{type(each).__qualname__}' for each in gc.get_objects())
    counted = collections.Counter(name for name in named if name.startswith(
        ('param_tutorial', 'rclpy', 'ipywidgets', 'ipykernel.comm')))
    # rclpy leaves one behind of each node that a cell creates without the executor: in 8 and 10.2.
    left = {f'/{name}/get_type_description' for name in ('hasty', 'patient', 'dozing')}
    observer = executor.tool_node
    services = sum(observer.count_services(name) for name, _ in observer.get_service_names_and_types()
                   if name not in left)
    return {**counted, 'threads': threading.active_count(), 'services in the graph': services}
print(_count())
'''


@pytest.mark.rare
# Chapter 2 builds its workspace in each of the four runs.
@pytest.mark.timeout(600)
@pytest.mark.parametrize('path', sorted(NOTEBOOKS.glob('*.ipynb')), ids=lambda path: path.stem)
def test_cells_that_run_again_leave_nothing_behind(path):
    cells = [cell for cell in nbformat.read(path, as_version=4).cells if cell.cell_type == 'code']
    kernel = Kernel()

    def run_all():
        for cell in cells:
            kernel.run(cell.source, cell=cell.id)

    def count():
        """Count what is alive of the course, rclpy and the widgets, by class; threads; services."""
        return Counter(ast.literal_eval(kernel.run(FORGET_AND_COUNT)))

    try:
        kernel.run(f'import os\nos.chdir({os.fspath(path.parent)!r})')
        run_all()
        # What is made once and for all is there after the second run at the latest.
        run_all()
        second = count()
        run_all()
        third = count()
        run_all()

        def more_with_each_run():
            return {name: (second[name], third[name], fourth) for name, fourth in count().items()
                    if second[name] < third[name] < fourth}

        # Some things end a few seconds later.
        wait_until(lambda: not more_with_each_run(), f'an end of {more_with_each_run()}', 30)
    finally:
        kernel.kill()
