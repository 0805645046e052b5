"""The whole way of a reader, from an empty folder through each step: in a kernel, in a page, with ours in the middle.

What is written differs from ours in a comment, so that no step counts as passed without its check.
"""

import contextlib
import subprocess
import sys
from pathlib import Path

import nbformat
import pytest

from param_tutorial import ParameterClient, Shell, Terminal
from param_tutorial.exercises import EXERCISES
from param_tutorial.learner.package_files import NAME, ours, steps
from param_tutorial.learner.progress import FILE, VARIABLE

pytestmark = pytest.mark.thorough

FIRST, *STEPS = steps()
MINE = '# Mine.\n'
BEGIN = """
import os
import pathlib
import param_tutorial
from param_tutorial import Package, Shell, exercises
ros = param_tutorial.start()
package = Package('2')
shell = Shell(home=package.home)
if shell.can_run:
    shell.run('mkdir -p ros2_ws/src; cd ros2_ws/src; ros2 pkg create --build-type ament_python --node-name driver_node '
              'my_robot; rm -r my_robot/test')
"""


def cells(taken=''):
    """Yield the cells that a reader would run, step by step, who takes ours at one of them."""
    yield BEGIN
    for before, step in zip([FIRST, *STEPS], STEPS, strict=False):
        if step == '3a':
            yield "package = Package('3')"
        if step == taken:
            yield f"package.take_ours('{step}')"
        else:
            changed = {name: text for name, text in ours(step).items() if ours(before).get(name) != text}
            for name, text in changed.items():
                yield f'package.save({name!r}, {text + MINE * name.endswith(".py")!r})'
        if step == '2d':
            yield "if shell.can_run:\n    shell.run('cd ~/ros2_ws && colcon build')"
        yield f"print(exercises.check('{step}', package))"
    yield 'print(package.status().words)'


@pytest.mark.parametrize('taken', ['', STEPS[len(STEPS) // 2]], ids=['alone', 'with ours in the middle'])
def test_each_step_passes_in_a_kernel(ros, monkeypatch, tmp_path, capsys, taken):
    monkeypatch.setenv(VARIABLE, str(tmp_path / FILE))
    space = {}
    for each in cells(taken):
        exec(each, space)
        said = capsys.readouterr().out
        assert ': not yet' not in said, f'{each}\n{said}'
    assert 'runs as /driver' in said


def test_each_step_passes_in_a_page_and_the_program_runs_there(run_in_a_page, tmp_path):
    run = ("ros.remove('/driver')\n"
           "program = param_tutorial.Terminal('ros2 run my_robot driver_node --ros-args -p max_speed_mps:=0.75')\n"
           "print(param_tutorial.ParameterClient('/driver').get_parameter('max_speed_mps'))\nprint(program.interrupt())")
    notebook = nbformat.v4.new_notebook(cells=list(map(nbformat.v4.new_code_cell, [*cells(), run])))
    nbformat.write(notebook, tmp_path / 'walk.ipynb')
    said = [''.join(each.get('text', '') or str(each) for each in ran['outputs'])
            for ran in run_in_a_page(tmp_path / 'walk.ipynb')]
    assert [each for each in said if ': not yet' in each or 'ename' in each] == []
    assert sum(': done' in each for each in said) == len(STEPS)
    assert 'runs as /driver' in said[-2]
    assert said[-1].split() == ['0.75', '0']


def test_every_step_is_an_exercise():
    assert set(STEPS) <= set(EXERCISES)


def test_the_finished_package_builds_and_runs(ros):
    with contextlib.closing(Shell()) as shell:
        folder = Path(shell.home, 'ws', 'src', NAME)
        subprocess.run([sys.executable, '-m', 'param_tutorial.learner.finished', folder], check=True)
        said = shell.run('cd ~/ws && colcon build && source install/setup.bash && colcon test && colcon test-result')
        assert shell.status == 0, said
        assert 'Summary: 5 tests, 0 errors, 0 failures' in said
        driver = Terminal(f'ros2 run {NAME} driver_node --ros-args -p max_speed_mps:=0.75', shell=shell)
        assert ParameterClient('/driver', timeout_sec=30).get_parameter('max_speed_mps') == 0.75
        assert driver.interrupt() == 0
