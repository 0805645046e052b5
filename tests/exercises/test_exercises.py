"""The exercises: no blank is done, each solution is, and a check answers anything else in a sentence."""

import re
import shutil
import threading
import time

import pytest
from rclpy.node import Node

import param_tutorial
from param_tools.errors import ExecutorError
from param_tools.ros import graph, stage
from param_tutorial import ParameterClient, exercises
from param_tutorial.exercises import EXERCISES, trial
from param_tutorial.exercises.chapters import ch05_3
from param_tutorial.exercises.results import Finding, Result
from param_tutorial.learner.progress import FILE, VARIABLE, own_progress
from param_tutorial.nodes.base_node import BaseNode
from tests.support.answers import blank, cell, not_yet, solution
from tests.support.kernels import Kernel


def test_the_stored_answer_to_each_blank_is_that_nothing_is_done_and_the_first_hint_unless_it_begins_with_what_works():
    """The chapters' own tests run the blanks, and compare."""
    for number, exercise in EXERCISES.items():
        text = ' '.join(cell(number, 'check').outputs[0].data['text/plain'].split())
        done = {'4a': 3, '4c': 1, '6.1a': 1, '7.1b': 2, '7.1c': 2, '8d': 1, '11a': 1}.get(number, 0)
        assert text.startswith(f'Exercise {number}: not yet, {done} of {len(exercise.requirements)} done')
        assert done or ' '.join(exercise.hints[0].split()) in text


def own_names(ros):
    """Return the nodes in the graph that can come from this process; other processes may have nodes, too."""
    return [name for name in ros.services.node_names(hidden=True)
            if name.startswith(f'{trial.CORNER}/') or name in ('/rover', '/gripper', '/heater')]


# Things that are not work at all, and what the answer says about them.
class NeedsArguments(Node):
    def __init__(self, name, speed):
        super().__init__(name)


class Raises(Node):
    def __init__(self):
        super().__init__('rover')
        raise ValueError('no wheels')


class Unreadable:
    def __repr__(self):
        raise RuntimeError('do not look')


@pytest.mark.parametrize(('work', 'word'), [
    (None, 'the check was given `None`'), (5, '`5`'), ('Rover', "`'Rover'`"), (Unreadable, 'the class `Unreadable`'),
    (Unreadable(), 'a `Unreadable`'), (NeedsArguments, 'missing 2 required positional arguments'),
    (Raises, 'ValueError: no wheels'),
    (BaseNode, 'the check was given the class `BaseNode`'),
    (type('Rover', (BaseNode,), {}), 'the check was given the class `Rover`'),
])
def test_the_check_of_a_rover_names_anything_else(ros, work, word):
    result = exercises.check('3b', work)
    assert (result.done, result.count) == (False, 0)
    assert word in ' '.join(not_yet(result).values())
    assert not ros.nodes
    assert not own_names(ros)


# The first exercise of each kind of work.
KINDS = {exercise.takes.name: number for number, exercise in reversed(EXERCISES.items())}


@pytest.mark.parametrize('work', [5, Node, len, lambda: None, {}, '', []], ids=[
    'number', 'Node', 'builtin', 'lambda', 'dictionary', 'text', 'list'])
def test_nonsense_never_raises(ros, monkeypatch, work):
    monkeypatch.setattr(trial, 'TIME_LIMIT_SEC', 1.0)
    number = next((number for number in KINDS.values() if EXERCISES[number].takes.fits(work)), '3b')
    result = exercises.check(number, work)
    assert (result.done, result.count) == (False, 0)
    assert repr(result) and result._repr_html_()


def test_a_node_in_place_of_its_class_is_named_and_stays_on_the_stage(ros):
    node = ros.add(solution('3b'))
    result = exercises.check('3b', node)
    assert 'by its name alone and without parentheses' in repr(result)
    assert ros.nodes == (node,)


def test_a_program_that_is_not_there_is_named(ros, tmp_path):
    result = exercises.check('1c', str(tmp_path / 'winch_node.py'))
    assert 'there is none beside this notebook: run the cell above' in result.findings[0].happened
    assert [finding.word for finding in result.findings] == ['not yet', *['not tried'] * (len(result.findings) - 1)]


def test_a_copy_that_is_older_than_the_readers_file_is_found_and_one_that_is_not_there(ros):
    files = solution('2d')
    copy = files.lessons / 'ros2_ws/install/my_robot/lib/python3.11/site-packages/my_robot/driver_node.py'
    copy.parent.mkdir(parents=True)
    copy.write_text('pass')
    assert list(not_yet(exercises.check('2d', files)).values()) == ['the copy there is older. A build replaces it']
    shutil.rmtree(files.lessons / 'ros2_ws/install')
    assert list(not_yet(exercises.check('2d', files)).values()) == ['it is not there: a build makes it']


def test_a_tuner_that_is_further_still_passes_its_first_step(ros):
    result = exercises.check('5.3a', solution('5.3b'))
    assert result.done, result


@pytest.mark.rare
def test_a_program_may_lose_a_race_that_is_rclpys_own_but_not_each_time(ros, tmp_path):
    """Rclpy's handler of signals can shut the context down in the middle of ``spin``, which then raises an RCLError."""
    lost = ('        pass', """        from pathlib import Path
        from rclpy._rclpy_pybind11 import RCLError
        lost = Path(__file__).with_suffix('.lost')
        if lost.exists() == %s:
            lost.touch()
            raise RCLError('the given context is not valid')""")
    files = solution('3d', (lost[0], lost[1] % False))
    assert exercises.check('3d', files).done
    tries = files.path('driver_node.py').with_suffix('.lost')
    assert tries.exists()
    tries.unlink()
    happened = ' '.join(not_yet(exercises.check('3d', solution('3d', (lost[0], lost[1] % 'lost.exists()')))).values())
    assert happened.count('it ended with `rclpy._rclpy_pybind11.RCLError: the given context is not valid`') == 2


def test_a_wrong_name_in_the_learners_lines_is_not_searched_for(ros, monkeypatch):
    """The lines can only mean nodes of this process. Waiting for discovery could take longer than the check allows."""
    monkeypatch.setattr(graph, 'DISCOVERY_SEC', 1000)
    result = exercises.check('10.3b', solution('10.3b', ('/wheel_controller', '/wheel')))
    assert 'there is no node /wheel. No node is running' in result.findings[0].happened


class Supervisor(Node):
    """A node whose subclasses say what its button does."""

    def __init__(self):
        super().__init__('supervisor')
        self.client = self.create_client(ch05_3.SetParameters, 'driver/set_parameters')


class Sleeps(Supervisor):
    def slow_down(self):
        threading.Event().wait()


@pytest.mark.rare
def test_a_button_callback_that_cannot_be_interrupted_is_reported_and_start_begins_anew(ros):
    result = exercises.check('5.4a', Sleeps)
    assert 'does not return and cannot be interrupted. Call start() again' in result.findings[0].happened
    assert [finding.word for finding in result.findings] == ['not yet', 'not tried', 'not tried']
    stage.start()
    assert exercises.check('5.4a', solution('5.4a')).done


@pytest.mark.rare
def test_a_callback_that_keeps_the_thread_is_named_and_not_the_constructor(ros, monkeypatch):
    monkeypatch.setattr(trial, 'TIME_LIMIT_SEC', 2.5)
    ros.add(BaseNode).create_timer(0.1, lambda: [time.sleep(0.01) for _ in iter(int, 1)])  # for ever
    assert 'the timer callback <lambda> of /base' in str(exercises.check('3a', solution('3a')))


def test_a_wrong_node_name_is_one_finding_and_the_rest_counts(ros):
    result = exercises.check('3b', solution('3b', ("'rover'", "'rovr'")))
    assert (result.done, result.count, result.score) == (False, 4, '4 of 4 done')
    assert not_yet(result) == {'the node is called `rover`': 'it is called `rovr`'}
    assert 'not yet' in result.heading


def test_a_check_leaves_the_stage_as_it_was(ros):
    own = ros.add(solution('3b'))
    client = ParameterClient(own)
    client.set_parameter('max_speed_mps', 1.5)
    for number in ('3b', '5.2a', '5.3c', '5.4b', '7.1c'):  # one for each kind of work
        exercises.check(number, solution(number))
        exercises.check(number, blank(number))
    assert ros.nodes == (own,)
    assert own_names(ros) == ['/rover']
    assert not any(each.srv_name.startswith(f'{trial.CORNER}/') for each in ros.tool_node.clients)
    assert client.get_parameter('max_speed_mps') == 1.5


class AddsAnother(Node):
    def __init__(self):
        super().__init__('rover')
        stage.current().add(BaseNode)


def test_nodes_that_a_node_adds_are_removed_too(ros):
    exercises.check('3b', AddsAnother)
    assert not ros.nodes


@pytest.mark.parametrize('touch', [param_tutorial.start, param_tutorial.stop])
def test_work_that_starts_or_stops_the_stage_gets_a_hint_to_leave_that_out(ros, touch):
    def next_stop(node):
        touch()
        return 1, [2, 3]

    own = ros.add(solution('3b'))
    happened = not_yet(exercises.check('4c', next_stop)).values()
    assert 'would take the check’s own nodes off the stage: leave this line out' in ' '.join(happened)
    assert ros.nodes == (own,)
    assert param_tutorial.start() is ros  # after the check, everything is as before
    assert not ros.nodes


def test_without_a_stage_there_is_one_for_the_time_of_the_check():
    param_tutorial.stop()
    assert exercises.check('3b', solution('3b')).done
    with pytest.raises(ExecutorError):
        stage.current()


def test_a_finding_quotes_the_line_that_raised(ros, tmp_path):
    path = tmp_path / 'cell.py'
    path.write_text('def rejected(parameters, results):\n    return results[9]\n')
    space = {'__name__': '__main__'}
    exec(compile(path.read_text(), str(path), 'exec'), space)
    assert 'in the line `return results[9]`' in ' '.join(repr(exercises.check(
        '5.3c', space['rejected'])).split())


# Prints what a check displays, the last line of each, and what its result offers in addition.
SHOWN = '''
import os
from IPython.utils.capture import capture_output
from param_tutorial import exercises
os.environ['PARAM_TUTORIAL_PROGRESS'] = {file!r}
with capture_output() as captured:
    html = exercises.check('5.4b', {{}})._repr_html_()
print([str(each.data.get('text/plain')).splitlines()[-1] for each in captured.outputs])
print([each.partition('<')[0] for each in html.split('<summary>')[1:]])
'''


def test_a_learner_sees_what_a_check_tries_and_gets_its_hints_and_nothing_of_that_is_stored(tmp_path):
    kernel = Kernel()
    try:
        stored, said = (kernel.run(SHOWN.format(file=file), cell='a') for file in ('', str(tmp_path / FILE)))
    finally:
        kernel.kill()
    tried = [f'Trying {number} of 7: {each.sentence}' for number, each in enumerate(EXERCISES['5.4b'].requirements, 1)]
    assert said == f"{['None', *tried, 'None']}\n['Hint 2 of 3', 'Hint 3 of 3', 'A worked solution']\n"
    assert stored == '[]\n[]\n'


def test_hints_come_one_by_one_and_end_at_the_solution(monkeypatch):
    monkeypatch.setattr(exercises, '_hints_given', {})
    hints = EXERCISES['4b'].hints
    for position, text in enumerate(hints, start=1):
        shown = ' '.join(repr(exercises.hint('4b')).split())
        assert shown.startswith(f'Hint {position} of {len(hints)}')
        assert text in shown
    assert 'solutions/04_solutions.ipynb' in repr(exercises.hint('4b'))


@pytest.mark.parametrize(('ask', 'number', 'said'), [
    (exercises.check, '', "There is no exercise ''. There is: 1a"),
    (exercises.check, '5.2', "There is no exercise '5.2'. Did you mean 5.2"),
    (exercises.hint, 3, 'There is no exercise 3. Did you mean 3'),
    (exercises.hint, [], 'There is no exercise []. There is: 1a'),
    (exercises.predict, '6.1-99', "There is no prediction '6.1-99'. Did you mean 6.1-"),
    (exercises.recall, '4-r3', "There is no question '4-r3'. Did you mean 4-r"),
    (exercises.progress, '12', "There is no chapter '12'. Did you mean 2")])
def test_a_number_that_there_is_not_gets_suggestions(ask, number, said):
    assert repr(ask(number)).startswith(said)


def test_a_check_without_work_shows_how_to_call_it():
    for number in KINDS.values():
        shown = ' '.join(repr(exercises.check(number)).split())
        assert re.search(f"exercises.check\\({number!r}, ('?my_|package)", shown.lower().replace('mynode', 'my_node'))
        assert EXERCISES[number].takes.name in shown


def test_the_first_answer_to_a_recall_is_remembered_and_marked(monkeypatch, tmp_path):
    monkeypatch.setenv(VARIABLE, str(tmp_path / FILE))
    question = exercises.RECALLS['4-r1']
    for each in question.choices:
        exercises.recall('4-r1').commit(each.text)
    made = own_progress().read()[0].predicted['4-r1']
    assert (made.choice, made.right) == (question.choices[0].text, question.choices[0].is_right)
    assert f'4-r1 {"✓" if made.right else "✗"}' in repr(exercises.progress('4'))


def test_a_result_has_a_text_and_an_html_form():
    findings = [Finding('`a` < `b`', False, 'x', '<b>', 'See it'), Finding('fine', True), Finding('?', None)]
    result = Result('3b', findings, 3, 'the end')
    assert repr(result) == '''Exercise 3b: not yet, 1 of 3 done

not yet    `a` < `b`
           expected  x
           happened  <b>
           look at   “See it”
done       fine
not tried  ?

the end'''
    page = result._repr_html_()
    for text in ('not yet', '<code>a</code> &lt; <code>b</code>', '&lt;b&gt;', '<b>done</b>', '<b>not tried</b>',
                 '<a href="#See-it">“See it”</a>'):
        assert text in page


def test_in_the_corner_a_parameter_file_names_its_nodes_however_it_is_written():
    for text, expected in (
            ('/a: {x: 1}\nb:\n  /c: 1\n', f'{trial.CORNER}/a: {{x: 1}}\n{trial.CORNER}/b:\n  /c: 1\n'),
            ('  "/a": 1\n  \'b\': 1', f'  "{trial.CORNER}/a": 1\n  \'{trial.CORNER}/b\': 1'),
            ('{/a: {/x: 1}, /*/b: 1}', f'{{{trial.CORNER}/a: {{/x: 1}}, {trial.CORNER}/*/b: 1}}'),
            ('# ü\n---\n/a: 1', f'# ü\n---\n{trial.CORNER}/a: 1')):
        assert trial._in_corner(text) == expected
    for text in ('/**: 1', '**/a: 1', f'{trial.CORNER}/a: 1', '/a: [', '', 'a', '- /a', '/a: 1\n---\n/b: 1'):
        assert trial._in_corner(text) == text
