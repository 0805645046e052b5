"""The tests of rclpy's behavior, which run on the real one elsewhere, on the layer in Python."""

import subprocess
import sys

import pytest

from tests.support.paths import ROOT

PLUGIN = 'tests.support.rcl_in_python'


@pytest.mark.slow
def test_rclpy_does_the_same_on_both_layers():
    done = subprocess.run([sys.executable, '-m', 'pytest', '-p', PLUGIN, '-q', '--timeout', '120', 'tests/conformance'],
                          cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    assert ' passed' in done.stdout
