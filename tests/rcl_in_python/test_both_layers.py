"""Tests that run on the real rclpy elsewhere, on the layer in Python: those of rclpy's behavior, and of parameters."""

import re
import subprocess
import sys

import pytest

from tests.support.paths import ROOT

PATHS = [
    'tests/conformance', 'tests/node', 'tests/systems', 'tests/files/test_parameter_files.py',
    'tests/ros/test_rclpy_private.py', 'tests/ros/test_services.py', 'tests/widgets/test_panel.py',
    'tests/widgets/test_panel_files.py']


@pytest.mark.slow
@pytest.mark.thorough
@pytest.mark.timeout(300)
# How many there are at least: a selection that has become empty, or nearly so, would prove nothing.
@pytest.mark.parametrize(('choice', 'at_least'), [('not slow', 750), ('slow', 35)])
def test_the_same_tests_pass_on_both_layers(choice, at_least):
    # Stops at the first that fails: of a broken layer, many would wait for a minute each.
    done = subprocess.run([sys.executable, '-m', 'pytest', '-p', 'tests.support.rcl_in_python', '-x', '-n', '2',
                           '--dist', 'loadscope', '-m', choice, *PATHS], cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    counts = {what: int(number) for number, what in re.findall(r'(\d+) (\w+)', done.stdout.splitlines()[-1])}
    assert counts['passed'] >= at_least
    assert 'skipped' not in counts
