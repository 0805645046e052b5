"""The recording of ROS 1: the real one still says so, and a lesson can show it beside ROS 2."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from param_tutorial.views.drawing import ros1
from param_tutorial.views.drawing.ros1 import Step
from tests.support import missing
from tests.support.paths import ROOT
from tests.tools import ros1_record

RECORD = Path(ros1_record.__file__)
# ROS 1 comes as packages of Debian, for Debian's own Python.
DEBIANS_PYTHON = '/usr/bin/python3'


def asked(*arguments, python=DEBIANS_PYTHON):
    """Run the recorder with --check."""
    return subprocess.run([python, str(RECORD), '--check', *map(str, arguments)], capture_output=True, text=True,
                          timeout=240, env={**os.environ, 'PYTHONDONTWRITEBYTECODE': '1'})


@pytest.fixture(scope='module')
def needs_ros1(tmp_path_factory):
    """Skip where there is no ROS 1, and say what to install; in CI, where .ci/run installs it, fail."""
    path = tmp_path_factory.mktemp('ros1') / 'empty.txt'
    path.write_text('nothing is asked\n')
    done = asked(path) if Path(DEBIANS_PYTHON).exists() else None
    if done is None or done.returncode == 2:
        missing.skip(done.stderr if done else f'there is no {DEBIANS_PYTHON}')


@pytest.fixture
def scene_file(tmp_path):
    """Return a function that writes a recording of one scene."""
    def write(steps):
        path = tmp_path / 'recording.txt'
        path.write_text(f'a head\n\n== a scene\n{steps}\n')
        return path
    return write


@pytest.mark.slow
@pytest.mark.thorough
def test_the_real_ros1_says_what_was_recorded(needs_ros1):
    done = asked()
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.slow
@pytest.mark.thorough
def test_another_answer_is_a_difference(needs_ros1, scene_file):
    done = asked(scene_file("/robot>>> rospy.set_param('~gain', 1)\n... rospy.get_param('~gain')\n2"))
    assert done.returncode == 1
    assert done.stdout.splitlines()[-2:] == ['-2', '+1']


@pytest.mark.slow
@pytest.mark.thorough
def test_what_cannot_be_done_is_reported_and_leaves_no_process(needs_ros1, scene_file):
    done = asked(scene_file('/robot>>> 1\n1\n! the robot sings'))
    assert done.returncode == 2
    assert done.stderr == "in the scene \"a scene\": 'the robot sings' is no event that this recorder knows\n"


def test_without_ros1_it_says_what_to_install():
    done = asked(python=sys.executable)
    assert done.returncode == 2
    assert 'finds no python3-rosmaster' in done.stderr
    assert f'apt-get install --no-install-recommends {" ".join(ros1_record.PACKAGES)}' in done.stderr


def test_ci_installs_the_packages():
    script = (ROOT / '.ci/run').read_text()
    assert all(package in script for package in ros1_record.PACKAGES)


@pytest.mark.parametrize('file', ['pyproject.toml', 'param_tutorial/setup.py'])
def test_the_recording_is_installed(file):
    assert f'views/drawing/{ros1.RECORDING.name}' in (ROOT / file).read_text()


def test_a_recording_is_read_and_written_alike():
    text = ros1.RECORDING.read_text()
    assert ros1_record.render(*ros1.parse(text)) == text


def test_a_step_has_lines_and_its_answer_too():
    head, scenes = ros1.parse('a\n\nb\n\n== one\n/r>>> if 1:\n...     2\n...\n... 3\n3\n\n4\n! it ends\n$ ls\n')
    assert head == 'a\n\nb'
    assert scenes == {'one': (
        Step('/r>>>', 'if 1:\n    2\n\n3', '3\n\n4'), Step('!', 'it ends'), Step('$', 'ls'))}


def test_an_unknown_scene_raises_an_error_with_the_likeliest_one():
    with pytest.raises(KeyError, match=r"there is no scene 'type'. Did you mean types"):
        ros1.scene('type')
    with pytest.raises(KeyError, match='there is no scene 3'):
        ros1.scene(3)


def test_a_scene_is_shown_as_it_was_typed():
    shown = ros1.Recorded((Step('/r>>>', "x = '<'\nx", "'<'"), Step('!', '/r is killed')))
    assert repr(shown) == "/r>>> x = '<'\n      x\n'<'\n(/r is killed)"
    assert '&lt;' in shown._repr_html_() and "'<'" not in shown._repr_html_()
    assert shown.answers == ["'<'", '']
    assert repr(shown[1:]) == '(/r is killed)'
    with pytest.raises(TypeError, match=r'e.g. \[1:2\] and not \[1\]'):
        shown[1]


def test_answers_stand_beside_the_steps():
    steps = (Step('/r>>>', 'a', '1'), Step('/r>>>', 'b'), Step('!', 'c'))
    shown = ros1.Recorded(steps).beside(None, lambda: {}['no'], ...)
    assert shown.answers == ['None', "KeyError: 'no'", '—']
    rows = [line.split() for line in repr(shown).splitlines()[2:]]
    assert rows == [['/r>>>', 'a', 'None'], ['1'], ['/r>>>', 'b', 'KeyError:', "'no'"], ['(done)'], ['(c)', '—']]
    assert '<th scope="col">ROS 1, recorded</th><th scope="col">ROS 2, now</th>' in shown._repr_html_()


def test_long_lines_stay_in_their_column():
    shown = repr(ros1.Recorded((Step('/r>>>', 'word ' * 40),)).beside('word ' * 40))
    assert max(map(len, shown.splitlines())) <= 2 * 58 + 2


@pytest.mark.parametrize('answers', [(), (1,), (1, 2, 3)])
def test_an_answer_too_few_or_too_many_is_told(answers):
    two = ros1.Recorded((Step('/r>>>', 'a'), Step('/r>>>', 'b')))
    with pytest.raises(ValueError, match=f'2 steps were recorded, so beside.. takes 2 answers and not {len(answers)}'):
        two.beside(*answers)
