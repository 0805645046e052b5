"""What a kernel of `make lab` has before its first cell: a sentence below an error about a name."""

import pytest
from IPython.core.interactiveshell import InteractiveShell

from param_tutorial.notebook import kernel_start

ABOVE = 'run it first (in JupyterLab: Run → Run All Above Selected Cell).'


@pytest.fixture
def shell(monkeypatch):
    monkeypatch.setattr(kernel_start.newest_kernel, 'note_domain', lambda: None)
    shell = InteractiveShell()
    kernel_start.load_ipython_extension(shell)
    return shell


@pytest.mark.parametrize(('cell', 'words'), [
    ('panel.reset()', f'If a cell above defines panel, {ABOVE}\n'),
    ('%ros2 param list', f'The first cell of the notebook makes %ros2 known; {ABOVE}\n'),
    ('import rclpy.node\nget_logger()', 'A Node has get_logger: do you mean self.get_logger?\n'),
    ('import rclpy.task\nimport rclpy.node\nrclpy.task.Future().result().values',
     '`None` is an answer that has not come: `result()` of a future does not wait for it.\n'),
    ('def f():\n    print(x)\n    x = 1\nf()', ''),
    ('%unheard_of', ''),
    ('print(1', ''),
    ('1\nros2 param list', 'A command begins with a percent sign: %ros2 param list\n'),
])
def test_what_a_cell_says_on_standard_error(shell, capsys, cell, words):
    shell.run_cell(cell)
    printed, said = capsys.readouterr()
    # IPython says itself which magic there is not.
    assert said.endswith(words) and (ABOVE in said) == (ABOVE in words)
    assert 'incomplete input' not in printed
