"""The kernel of a web page by itself: what it is, and what it does where it has no threads and no signals."""

import nbformat
import pytest

pytestmark = [pytest.mark.slow, pytest.mark.thorough]

ENDLESS = '''
import time
import param_tutorial
from rclpy.node import Node

class Endless(Node):
    def __init__(self):
        super().__init__('endless')
        self.once = self.create_timer(0.01, self.loop)

    def loop(self):
        self.once.cancel()
        while True:
            pass

ros = param_tutorial.start()
ros.add(Endless)
time.sleep(0.5)
print('and on it goes')
'''


@pytest.fixture
def run(run_in_a_page, tmp_path):
    """Return a function that runs cells in the kernel of a page, and returns what each prints to stdout and stderr."""
    def run(*cells: str) -> list[tuple[str, str]]:
        notebook = nbformat.v4.new_notebook(cells=list(map(nbformat.v4.new_code_cell, cells)))
        nbformat.write(notebook, tmp_path / 'notebook.ipynb')
        return [tuple(''.join(each['text'] for each in ran['outputs'] if each.get('name') == name)
                      for name in ('stdout', 'stderr')) for ran in run_in_a_page(tmp_path / 'notebook.ipynb')]

    return run


def test_an_endless_callback_is_ended_and_named(run):
    (printed, complaint), = run(ENDLESS)
    assert printed == 'and on it goes\n'
    assert '/endless' in complaint
    assert 'this callback did not return, so it was interrupted' in complaint


def test_it_says_what_it_is_and_has_no_shell(run):
    (name, _), (shell, _), (unknown, _) = run(
        'import rclpy\nprint(rclpy.get_rmw_implementation_identifier())',
        'import param_tutorial\n%load_ext param_tutorial\nbuilder = param_tutorial.Shell()',
        '%%shell builder\nls')
    assert name == 'rclpy_in_python_without_network\n'
    assert not shell
    assert unknown == 'There is no shell in a web page, so this cell does not run here.\n'


def test_a_command_after_an_exclamation_mark_says_why_it_does_not_run(run):
    (direct, _), (assigned, _) = run(*(
        f'try:\n    {line}\nexcept Exception as error:\n    print(error)' for line in ('!ls', 'found = !ls')))
    assert direct == assigned == "there is no shell in a web page, so 'ls' does not run here\n"


def test_input_says_what_to_do_without_it(run):
    (said, _), = run("try:\n    input('Speed? ')\nexcept NotImplementedError as error:\n    print(error)")
    assert said == "input() can't ask in a web page: write the answer into the cell, e.g. answer = 'yes'\n"


CLOCK = '''
import asyncio
import param_tutorial
from rclpy.node import Node

class Clock(Node):
    def __init__(self):
        super().__init__('clock')
        self.ticks = 0
        self.create_timer(0.005, self.tick)

    def tick(self):
        self.ticks += 1

clock = param_tutorial.start().add(Clock)
await asyncio.sleep(0.5)  # as long as somebody reads
'''


def test_nodes_live_between_the_cells_and_files_stay(run):
    _, (heard, _), (read, _) = run(CLOCK, "print(clock.ticks > 5)\nkept = open('note.txt', 'w').write('kept')",
                                   "print(open('/drive/note.txt').read())")
    assert (heard, read) == ('True\n', 'kept\n')
