"""Streams: what is printed is limited, and input() is answered at once where nobody can type."""

import builtins
import contextlib
import io
import sys
import threading
from types import SimpleNamespace

import pytest
from rclpy.node import Node

import param_tutorial
from param_tools.errors import ExecutorError
from param_tools.ros import output_guard
from param_tools.ros.output_guard import Allowance, guarded


@pytest.fixture
def ros(ros):
    """Leave no executor: after a flood it leaves out, and then counts, what the next test's callbacks print."""
    yield ros
    param_tutorial.stop()


def test_so_many_lines_pass_and_the_others_are_counted():
    allowance = Allowance(3)
    printed = io.StringIO()
    for number in range(1000):
        for text in (str(number), '\n'):  # as print() writes
            printed.write(allowance.take(text))
    assert printed.getvalue() == '0\n1\n2\n'
    assert allowance.left_out() == 997
    assert allowance.left_out() == 0


@pytest.mark.parametrize(('text', 'passed'), [
    ('a\nb\nc\nd', 'a\nb\n'), ('a\nb\n', 'a\nb\n'), ('a\nb', 'a\nb'), ('', ''), ('x' * 201, 'x' * 200)])
def test_a_text_is_cut_after_so_many_lines_or_characters(text, passed):
    assert Allowance(2).take(text) == passed


def test_a_renewed_allowance_lets_lines_pass_again_and_still_knows_what_it_left_out():
    allowance = Allowance(1)
    assert [allowance.take('a\n') for _ in range(3)] == ['a\n', '', '']
    allowance.renew()
    assert [allowance.take('b\n') for _ in range(2)] == ['b\n', '']
    assert allowance.left_out() == 3


def test_a_guarded_block_prints_its_first_lines_and_cannot_ask(capsys):
    stdout, ask = sys.stdout, builtins.input
    with guarded(lambda: ZeroDivisionError('nobody')):
        for number in range(1000):
            print(number)
        print('lost', file=sys.stderr)
        assert sys.stdout.encoding == stdout.encoding
        with pytest.raises(ZeroDivisionError, match='nobody'):
            input('speed? ')
    assert (sys.stdout, builtins.input) == (stdout, ask)
    printed = capsys.readouterr()
    assert printed.out == ''.join(f'{number}\n' for number in range(output_guard.CHECK_LINES)) + (
        f'… and {1001 - output_guard.CHECK_LINES} more lines, which are left out here.\n')
    assert printed.err == ''


def test_what_fits_is_printed_and_nothing_added(capsys):
    with guarded(ZeroDivisionError):
        print('one line')
    assert capsys.readouterr().out == 'one line\n'


def printed_until_told(capsys):
    """Return all that was printed until the word that lines were left out."""
    text = ''

    def told():
        nonlocal text
        text += ''.join(capsys.readouterr())
        return 'more lines from callbacks' in text

    param_tutorial.wait_until(told, 'the word', timeout_sec=30)
    return text


@pytest.mark.slow
def test_a_flood_in_the_executors_thread_is_cut_and_told_of(ros, capsys):
    ros.run(lambda: [print('flood', number) for number in range(5000)], 'print')
    print('from the cell')
    text = printed_until_told(capsys)
    # What other callbacks printed in the same second counts as well.
    shown = text.count('flood')
    assert 0 < shown <= output_guard.STAGE_LINES
    assert f'… and {5000 - shown:,} more lines from callbacks' in text
    assert text.count('from the cell') == 1


def test_a_flood_is_not_held_against_the_nodes_that_come_after_a_new_start(ros, capsys):
    ros.run(lambda: [print('flood', number) for number in range(5000)], 'print')
    param_tutorial.start().run(lambda: print('from a new node'), 'print')
    assert 'from a new node' in capsys.readouterr().out


def test_what_the_executor_says_is_not_left_out_after_a_flood(ros, capsys):
    def flood_and_fail():
        for number in range(5000):
            print('flood', number)
        raise ZeroDivisionError('said after the flood')

    node = ros.add(Node, 'flooding')
    timer = node.create_timer(0.001, lambda: (timer.cancel(), flood_and_fail()))
    text = printed_until_told(capsys)
    assert 'ZeroDivisionError: said after the flood' in text


def test_a_callback_that_prints_for_seconds_shows_its_first_lines_only(monkeypatch):
    now = [0.0]
    monkeypatch.setattr(output_guard, 'time', SimpleNamespace(monotonic=lambda: now[0]))
    guard, stdout = output_guard.Guard(lambda: True, lambda: None), io.StringIO()
    with contextlib.redirect_stdout(stdout):
        for _ in range(2):
            now[0] += 1.0
            guard.look()
            for _ in range(3):
                now[0] += 1.0
                print('flood\n' * output_guard.STAGE_LINES, end='')
        guard.leave()
    assert stdout.getvalue().count('\n') == 2 * output_guard.STAGE_LINES
    assert guard.left_out() == 4 * output_guard.STAGE_LINES
    assert guard.left_out() == 0


class Asking(Node):
    """Calls input() once, in a timer callback."""

    def __init__(self):
        super().__init__('asking')
        self.outcome = None
        self.timer = self.create_timer(0.001, self.tick)

    def tick(self):
        self.timer.cancel()
        try:
            self.outcome = input('speed? ')
        except Exception as error:
            self.outcome = error


def test_a_callback_cannot_ask_and_a_cell_can(ros, monkeypatch):
    monkeypatch.setattr(builtins, 'input', lambda *prompt: f'an answer to {prompt}')  # as Jupyter does for each cell
    node = ros.add(Asking)
    param_tutorial.wait_until(lambda: node.outcome is not None, 'the callback')
    assert isinstance(node.outcome, ExecutorError)
    assert 'Ask in a cell' in str(node.outcome)
    assert input('speed? ') == "an answer to ('speed? ',)"


def test_whoever_captures_output_meanwhile_gets_it_and_nobody_afterwards(ros):
    def say(word):
        ros.run(lambda: print(word), 'print')

    outer, inner = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(outer):
        say('one')
        with contextlib.redirect_stdout(inner):
            say('two')
        say('three')
        print('four')
    assert (outer.getvalue(), inner.getvalue()) == ('one\nthree\nfour\n', 'two\n')


def test_stop_leaves_the_output_guard_and_input_as_they_were():
    param_tutorial.stop()
    before = sys.stdout, sys.stderr, builtins.input
    ros = param_tutorial.start()
    assert ros.run(threading.current_thread, 'look') is not threading.current_thread()
    assert all(now is not then for now, then in zip((sys.stdout, sys.stderr, builtins.input), before, strict=True))
    param_tutorial.stop()
    assert (sys.stdout, sys.stderr, builtins.input) == before
