"""A cell that can't run where there is no shell: which ones these are, and what is shown in their place."""

import subprocess
import sys

import pytest

from param_tutorial.notebook import stored

PAGE = """
import subprocess
from param_tools.rcl_in_python.install import install
install(even_beside_the_real_one=True)
from param_tools.ros import turns
turns.install()
subprocess.Popen.__init__ = None
from IPython.core.interactiveshell import InteractiveShell
from param_tutorial.notebook import stored
ipython = InteractiveShell.instance()
"""


def cell(source, *outputs, name='a'):
    return {'cell_type': 'code', 'id': name, 'source': source, 'outputs': list(outputs)}


def printed(text):
    return {'output_type': 'stream', 'name': 'stdout', 'text': [text]}


CELLS = [
    cell('%load_ext param_tutorial\nfrom param_tutorial import Shell, Terminal\nbuilder = Shell()\n'
         'runner = Shell(builder)'),
    {'cell_type': 'markdown', 'source': 'builder'},
    cell('%%shell builder\npwd', printed('~\n')),
    cell("robot = Terminal('ros2 run a b', shell=runner)\nprint(robot.text)", printed('I am a robot.\n')),
    cell('robot.interrupt()', {'output_type': 'execute_result', 'data': {'text/plain': ['0']}}),
    cell('robot = 1\nprint(robot)', printed('1\n')),
    cell('print(robot)', printed('1\n')),
    cell('%%ros2\nnode list', printed('builder\n')),
    cell('runner.close()')]


@pytest.mark.parametrize(('source', 'does'), [
    ('%%shell x', True), ('%%shell y', False), ('f(y=x.z)', True), ('x = 1\nprint(x)', False), ('x = g(x)', True)])
def test_a_cell_depends_on_what_it_uses_before_it_names_something_else_so(source, does):
    assert stored.depends_on(source, {'x'}) is does


def test_in_a_page_each_of_them_says_why_and_shows_what_is_stored(tmp_path):
    done = subprocess.run([sys.executable, '-c', (
        f'{PAGE}CELLS = {CELLS!r}\nstored.offer(stored.collect({{"cells": CELLS}}))\n'
        'for each in CELLS:\n    if each["cell_type"] == "code" and "ros2\\n" not in each["source"]:\n'
        '        assert ipython.run_cell(each["source"]).success\n'
        'ipython.run_cell("%%shell builder\\nls")\nipython.run_cell("robot = runner.run(\'ls\')")\n'
        'ipython.run_cell("%mkdir -p a/b")\nprint(repr(robot := ipython.user_ns["robot"]))\n'
        'try: robot.read()\nexcept Exception as error: print(error)')], capture_output=True, text=True, check=True,
                          cwd=tmp_path)
    why = 'There is no shell in a web page, so this cell does not run here.'
    stored_below = 'This is what it printed where there is one:'
    assert (tmp_path / 'a' / 'b').is_dir()
    assert done.stdout == (
        f'{why} {stored_below}\n~\n{why} {stored_below}\nI am a robot.\n{why} {stored_below}\n0\n1\n1\n'
        f'{why}\n{why}\n{why}\n'
        '<missing: there is no shell in a web page>\n'
        'there is no shell in a web page, so the cell that makes this has not run\n')


def test_cells_of_the_same_text_are_told_apart_by_their_ids(monkeypatch, capsys, ipython):
    monkeypatch.setattr(stored, '_offered', [])
    pwd = '%%shell builder\npwd'
    stored.offer(stored.collect({'cells': [
        CELLS[0], cell(pwd, printed('first\n')), cell(pwd, printed('second\n'), name='b')]}))
    monkeypatch.setattr(stored, 'this_cell', lambda: ('b', 'run 1'))
    stored._stand_in(ipython, '', pwd)
    assert capsys.readouterr().out.splitlines()[1:] == ['second']
