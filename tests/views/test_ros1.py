"""The recording of ROS 1, and how a lesson shows it beside ROS 2."""

import pytest

from param_tutorial.views.drawing import ros1
from param_tutorial.views.drawing.ros1 import Step


def test_a_step_has_lines_and_its_answer_too():
    scenes = ros1.parse('Who says what.\n\n== one\n/r>>> if 1:\n...     2\n...\n... 3\n3\n\n4\n! it ends\n$ ls\n')
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


def test_answers_stand_beside_the_steps():
    steps = (Step('/r>>>', 'a', '1'), Step('/r>>>', 'b'), Step('!', 'c'))
    shown = ros1.Recorded(steps).beside(None, lambda: {}['no'], ...)
    assert shown.answers == ['None', "KeyError: 'no'", '—']
    rows = [line.split() for line in repr(shown).splitlines()[2:]]
    assert rows == [['/r>>>', 'a', 'None'], ['1'], ['/r>>>', 'b', 'KeyError:', "'no'"], ['(done)'], ['(c)', '—']]
    assert '<th scope="col">ROS 1, recorded</th><th scope="col">ROS 2, now</th>' in shown._repr_html_()


def test_an_answer_too_few_is_told():
    with pytest.raises(ValueError, match=r'1 steps were recorded, so beside\(\) takes 1 answers and not 0'):
        ros1.Recorded((Step('/r>>>', 'a'),)).beside()
