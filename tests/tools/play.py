"""Play with each chapter as a learner does, and look whether its cells still say the truth: `make play`.

Before every cell, a hand moves controls on each panel, presses Drive, and leaves the changes on their way. Then the
cell runs, and its outputs must be the stored ones: what a lesson says may not depend on what was done before it. Cells
with the tag `present-state` show what the node or the learner has now, so they may differ.
"""

import argparse
import random
import sys
from pathlib import Path

import nbformat

from param_tutorial.site.recording import run
from tests.support.paths import NOTEBOOKS

PRESENT_STATE = 'present-state'
# In the kernel's main thread, as what a browser sends. Assigning to a control moves it the way a hand would.
HAND = '''
def _play(seed):
    import random
    from ipywidgets.widgets.widget import _instances
    from param_tools import values
    from param_tutorial.views.driving import DrivingView
    from param_tools.panel.panel import ParameterPanel
    chance = random.Random(seed)
    for view in [each for each in list(_instances.values()) if isinstance(each, (ParameterPanel, DrivingView))]:
        if isinstance(view, DrivingView):
            view.drive()
            continue
        for name in chance.sample(view.names, min(3, len(view.names))):
            control = view[name]
            kind, limits = control.descriptor.type, control.descriptor.range
            if name.startswith(('use_sim_time', 'start_type')) or control.descriptor.read_only or view.status:
                continue
            if kind == values.BOOL:
                control.value = not control.value
            elif kind == values.INTEGER:
                control.value = chance.randint(limits.from_value, limits.to_value) if limits else chance.randint(1, 250)
            elif kind == values.DOUBLE:
                control.value = round(chance.uniform(limits.from_value, limits.to_value), 2) if limits else 1.5
            elif kind == values.STRING:
                control.value = f'played {seed}'
'''


def play(path: Path, seed: int) -> list[str]:
    """Run a chapter and play with it before each cell.

    :return: What cells said in place of the stored output.
    """
    found: list[str] = []
    with run.started(path, allow_errors=True) as client:
        def do(source: str) -> None:
            cells = client.nb.cells
            cells.append(nbformat.v4.new_code_cell(source))
            client.execute_cell(cells[-1], len(cells) - 1, store_history=False)
            for output in cells.pop().outputs:
                if output.output_type == 'error':
                    found.append(f'{path.name}: the hand itself failed: {output.ename}: {output.evalue}')
        do(HAND)
        for index, cell, stored in run.cells_to_run(client.nb, path):
            do(f'_play({seed + index})')
            cell.outputs = []
            client.execute_cell(cell, index)
            if (difference := stored.difference(cell.outputs)) and PRESENT_STATE not in cell.metadata.get('tags', []):
                found.append(f'{path.name}, cell {index}:\n{cell.source}\n--\n{difference}')
    return found


def main(arguments: list[str]) -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('chapters', nargs='*', help='beginnings of file names, such as 05_2; by default all')
    parser.add_argument('--seed', type=int, default=random.randrange(10**6), help='repeats what a hand did')
    options = parser.parse_args(arguments)
    beginnings = tuple(options.chapters or [''])
    paths = [path for path in sorted(NOTEBOOKS.glob('*.ipynb')) if path.name.startswith(beginnings)]
    print(f'seed {options.seed}')
    status = 0
    for path in paths:
        found = play(path, options.seed)
        print(f'{path.name}: {len(found)} cells say something else', flush=True)
        print(*found, sep='\n\n', end='\n\n' if found else '')
        status |= bool(found)
    return status


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
