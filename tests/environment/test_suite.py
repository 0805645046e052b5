"""The suite itself: a test that hangs is ended and the others run, however `make test` was started."""

import re
import subprocess
import sys

import psutil
import pytest

from tests.support.paths import ROOT

HANGING = '''
import subprocess, sys, time

def test_before():
    pass

def test_that_hangs():
    print('said before')
    # In a session of its own, as a terminal's command.
    child = subprocess.Popen([sys.executable, '-c', 'import time; time.sleep(1000)'], start_new_session=True)
    print('started', child.pid)
    child.wait()

def test_that_fails_and_hangs_in_its_teardown(request):
    request.addfinalizer(lambda: time.sleep(1000))
    raise ValueError('seen all the same')

def test_after():
    pass
'''


@pytest.mark.slow
@pytest.mark.thorough
def test_what_hangs_is_named_and_ended_and_the_others_run(tmp_path):
    (tmp_path / 'test_earlier.py').write_text('def test_that_is_done():\n    pass\n')
    (tmp_path / 'test_hanging.py').write_text(HANGING)
    done = subprocess.run(
        [sys.executable, '-m', 'pytest', '-p', 'tests.support.time_limit', '-p', 'no:randomly', '--timeout', '3',
         '-n', '1', '--dist', 'loadscope', str(tmp_path)], cwd=ROOT, capture_output=True, text=True)
    assert '3 failed, 3 passed' in done.stdout
    assert 'ValueError: seen all the same' in done.stdout
    for name in ('test_that_hangs', 'test_that_fails_and_hangs_in_its_teardown'):
        assert done.stderr.count(f'test_hanging.py::{name} is still running after 3 s') == 1
        assert re.search(f"crashed while running '.*::{name}'", done.stdout)
    assert 'said before' in done.stderr
    assert 'in test_that_hangs\n' in done.stderr
    child = int(done.stderr.partition('started ')[2].split()[0])
    assert child not in [process.pid for process in psutil.process_iter() if process.status() != psutil.STATUS_ZOMBIE]


@pytest.mark.slow
@pytest.mark.thorough
@pytest.mark.parametrize('workers', ['0', '1'])
def test_tests_run_where_stdin_is_closed(workers):
    tests = 'tests/notebook/test_magics.py'  # they import IPython, which looks at stdin
    done = subprocess.run(['sh', '-c', 'exec "$@" <&-', 'sh', sys.executable, '-m', 'pytest', '-n', workers, '-k',
                           'an_answer_goes', tests], cwd=ROOT, capture_output=True, text=True)
    assert re.search(r'[1-9]\d* passed', done.stdout), done.stdout + done.stderr
    assert done.returncode == 0
