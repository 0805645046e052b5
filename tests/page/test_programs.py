"""Whole programs as answers in the kernel of a web page: tried in the same Python, and judged as in a process."""

import nbformat
import pytest

from param_tutorial.learner.package_files import ours, steps
from tests.support.answers import cell

pytestmark = pytest.mark.thorough

LOOP = 'driver = Driver()\n        while True:\n            pass'


@pytest.fixture
def check(run_in_a_page, tmp_path):
    """Return a function that checks solutions, each with some words replaced, and returns what is said to each."""
    def check(number, *answers):
        cells = ['import param_tutorial\nfrom param_tutorial import Package, exercises\nros = param_tutorial.start()\n'
                 "package = Package('3')"]
        for old, new in answers:
            is_step = number in steps()
            source = ours(number)['my_robot/driver_node.py'] if is_step else cell(number, 'solution').source
            assert old in source
            source = source.replace(old, new)
            cells += [f"package.save('driver_node.py', {source!r})" if is_step else source,
                      f'print(repr({cell(number, "check").source}))']
        cells.append("print([each for each in ros.nodes if each.get_namespace() != '/'])")
        notebook = nbformat.v4.new_notebook(cells=list(map(nbformat.v4.new_code_cell, cells)))
        nbformat.write(notebook, tmp_path / 'notebook.ipynb')
        printed = [' '.join(''.join(each.get('text', '') for each in ran['outputs']).split())
                   for ran in run_in_a_page(tmp_path / 'notebook.ipynb')]
        assert printed[-1] == '[]'
        return printed[2::2]

    return check


def test_a_program_is_done_or_gets_a_finding_that_fits(check):
    answers = {
        ('main()', 'main()'): 'Exercise 3d: done, ',
        ('rclpy.spin(Driver())', 'driver = Driver()'): 'Nothing spins the node',
        ('ExternalShutdownException):', 'ZeroDivisionError):'): 'That is what SIGTERM raises',
        ('KeyboardInterrupt,', 'ZeroDivisionError,'): 'That is what Ctrl+C raises',
        ("'driver'", "'pilot'"): 'it is called `pilot`',
        ('create_timer', 'create_tmer'): 'in line 16, `self.create_tmer(',
        ('        rclpy.init()\n', ''): 'Call `rclpy.init()` before',
        ('rclpy.spin(Driver())', LOOP): 'still running after some seconds without a `spin`',
    }
    for said, words in zip(check('3d', *answers), answers.values(), strict=True):
        assert words in said
