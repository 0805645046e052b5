"""The kernel of a web page by itself: what it is, and what it says where it has no shell, no threads and no network."""

import nbformat
import pytest

pytestmark = pytest.mark.thorough


@pytest.fixture
def run(run_in_a_page, tmp_path):
    """Return a function that runs cells in the kernel of a page, and returns what each prints to stdout and stderr."""
    def run(*cells: str) -> list[tuple[str, str]]:
        notebook = nbformat.v4.new_notebook(cells=list(map(nbformat.v4.new_code_cell, cells)))
        nbformat.write(notebook, tmp_path / 'notebook.ipynb')
        return [tuple(''.join(each['text'] for each in ran['outputs'] if each.get('name') == name)
                      for name in ('stdout', 'stderr')) for ran in run_in_a_page(tmp_path / 'notebook.ipynb')]

    return run


def test_it_says_what_it_is_and_has_no_shell(run):
    (name, _), (shell, _), (unknown, _) = run(
        'import rclpy\nprint(rclpy.get_rmw_implementation_identifier())',
        'import param_tutorial\n%load_ext param_tutorial\nbuilder = param_tutorial.Shell()',
        '%%shell builder\nls')
    assert name == 'rclpy_in_python_without_network\n'
    assert not shell
    assert unknown == 'There is no shell in a web page, so this cell does not run here.\n'


def test_what_a_page_can_not_do_is_said_with_the_reason(run):
    no_shell = 'there is no shell in a web page'
    said = {
        '!ls': f"{no_shell}, so 'ls'", 'found = !ls': f"{no_shell}, so 'ls'",
        "get_ipython().run_cell_magic('bash', '', 'ls')": f"{no_shell}, so '%%bash'",
        '%pip install numpy': "there is no network in a web page, so '%pip'",
        'import os; os._exit(3)': "it would end this page's Python, so 'os._exit()'"}
    assert run(*(f'try:\n    {line}\nexcept Exception as error:\n    print(error)' for line in said)) == [
        (f'{words} does not run here\n', '') for words in said.values()]
    missing = "Nothing can be installed in a web page, so {} isn't here. "
    for (_, complaint), words in zip(run(
            'import numpy as np\nnp.arange(3)', 'from numpy import sqrt', 'import requests',
            'import threading\nthreading.Thread(target=print).start()'),
            (*map(missing.format, ('numpy', 'numpy', 'requests')), 'A web page has no threads. '), strict=True):
        assert complaint.startswith(words)


def test_input_says_what_to_do_without_it(run):
    (said, _), = run("try:\n    input('Speed? ')\nexcept NotImplementedError as error:\n    print(error)")
    assert said == "input() can't ask in a web page: write the answer into the cell, e.g. answer = 'yes'\n"


def test_a_traceback_shows_the_lines_of_the_one_who_wrote_them(run):
    (_, of_callback), (of_program, _) = run(
        "import param_tutorial, time\nros = param_tutorial.start()\nfrom rclpy.node import Node\n"
        "def tick():\n    timer.cancel()\n    1 / 0\n"
        "timer = ros.add(Node, 'ticker').create_timer(0.01, tick)\ntime.sleep(1)",
        "from pathlib import Path\nPath('broken.py').write_text('1 / 0')\n"
        "print(param_tutorial.Terminal('python3 broken.py').read('ZeroDivisionError'))")
    for said in (of_callback, of_program):
        assert 'ZeroDivisionError' in said
        assert said.count('File "') == 1
