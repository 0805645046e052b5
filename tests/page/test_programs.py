"""Whole programs as answers in the kernel of a web page: tried in the same Python, and judged as in a process."""

import nbformat
import pytest

from tests.support.answers import cell

pytestmark = pytest.mark.thorough

LOOP = 'kettle = Kettle()\n        while True:\n            pass'


@pytest.fixture
def check(run_in_a_page, tmp_path):
    """Return a function that checks solutions, each with some words replaced, and returns what is said to each."""
    def check(number, *answers):
        cells = ['import param_tutorial\nfrom param_tutorial import exercises\nros = param_tutorial.start()']
        for old, new in answers:
            source = cell(number, 'solution').source
            assert old in source
            cells += [source.replace(old, new), f'print(repr({cell(number, "check").source}))']
        cells.append('print(ros.nodes)')
        notebook = nbformat.v4.new_notebook(cells=list(map(nbformat.v4.new_code_cell, cells)))
        nbformat.write(notebook, tmp_path / 'notebook.ipynb')
        printed = [' '.join(''.join(each.get('text', '') for each in ran['outputs']).split())
                   for ran in run_in_a_page(tmp_path / 'notebook.ipynb')]
        assert printed[-1] == '()'
        return printed[2::2]

    return check


def test_a_program_is_done_or_gets_a_finding_that_fits(check):
    answers = {
        ('main()', 'main()'): 'Exercise 3d: done, ',
        ('rclpy.spin(Kettle())', 'kettle = Kettle()'): 'Nothing spins the node',
        ('ExternalShutdownException):', 'ZeroDivisionError):'): 'That is what SIGTERM raises',
        ('KeyboardInterrupt,', 'ZeroDivisionError,'): 'That is what Ctrl+C raises',
        ("'kettle'", "'kettel'"): 'it is called `kettel`',
        ('get_logger()', 'get_loger()'): 'in line 14, `self.get_loger().info(',
        ('        rclpy.init()\n', ''): 'Call `rclpy.init()` before',
        ('rclpy.spin(Kettle())', LOOP): 'still running after some seconds without a `spin`',
        ("self.get_logger().info(f'heating to {target_c} degrees')", 'pass'): 'it prints nothing',
    }
    for said, words in zip(check('3d', *answers), answers.values(), strict=True):
        assert words in said
