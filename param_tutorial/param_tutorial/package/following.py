"""The reader's package on the stage: the robot's base, and the nodes of the files as soon as they are saved."""

import difflib
import os
import threading
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple, cast

from IPython import get_ipython
from rclpy.node import Node

from param_tools.ros import host, stage
from param_tools.ros.environment import PACKAGE_IN_WORK
from param_tools.ros.executor import Failure
from param_tools.ros.listeners import Listeners
from param_tools.ros.schedule import Job
from param_tutorial.learner.package_files import (
    PackageFiles,
    changed_in,
    last_step_before,
    our_copy,
    ours,
    passed,
    steps,
)
from param_tutorial.learner.progress import own_progress
from param_tutorial.nodes.base_node import BaseNode
from param_tutorial.package.loading import LoadError, describe, load_node_class, within_limit

# How soon a file is looked at that another program has saved.
_LOOK_SEC = 0.5
_open: 'FollowedPackage | None' = None


class Status(NamedTuple):
    """What became of a file, for the reader."""

    words: str
    is_error: bool = False
    line: int = 0
    """Of the reader's file; 0 if it is about no line."""


class _Program:
    """One of the reader's files, and the node that the stage runs for it."""

    def __init__(self, name: str):
        self.name = name
        self.seen: str | None = None
        """The text that was looked at last; None before the first look."""
        self.node_class: type[Node] | None = None
        self.node: Node | None = None
        self.words: tuple[str, ...] = ()
        """What it was started with."""
        self.status = Status('')
        self.is_older = False  # True while the node is of an earlier text, since the present one makes none
        self.failure: Failure | None = None


class FollowedPackage:
    """The reader's package on the stage, for one chapter. Opening it closes the one that was open before."""

    def __init__(self, chapter: str, *names: str):
        """
        :param chapter: Its number, such as '3' or '5.2'. The package has at least what the chapters before ask for:
            files that are missing are ours. Chapter 2 makes the package, and no node is in it yet.
        :param names: The files whose nodes the stage runs; by default that of the driver.
        :raises ParameterToolError: a file cannot be written, or there is no such chapter.
        :raises ExecutorError: the stage has not been started.
        """
        global _open
        if _open is not None:
            _open.close()
        self.files = PackageFiles.of_learner()
        makes_package = chapter == steps()[0]
        if makes_package and 'rclpy' in self.files.text('driver_node.py'):
            print(f'Your {self.files.root.name} is further than this chapter, and stays as it is. The chapter works in '
                  'another folder, which is empty and goes with the kernel.')
            self.files = PackageFiles.apart()
        self._step = '' if makes_package else last_step_before(chapter)
        self.home = self.files.lessons
        """The folder of the lessons, in which a chapter's shells begin."""
        # In chapter 2 a shell finds the package after it has been built, and not before.
        self._is_followed = bool(self._step) or not host.host.has_processes
        self._lock = threading.RLock()
        self._listeners: Listeners[[]] = Listeners()
        self._words: tuple[str, ...] | None = ()
        self._programs = [_Program(name) for name in names or ('driver_node.py',)] if self._step else []
        # Where there is a shell, the reader types the command that writes the first step.
        if not (makes_package and host.host.has_processes):
            self.files.lay_out(self._step or chapter)
        self.base = cast(BaseNode, stage.current().add(BaseNode))
        self._work_in(self.files.root)
        if self._step:
            self.need(self._step)
        _open = self
        self._job = Job(self._look_again, _LOOK_SEC)
        self._job.wake()
        if shell := get_ipython():
            shell.events.register('post_run_cell', self._after_cell)

    def __repr__(self) -> str:
        return f'<{type(self).__name__}: {self.files.root.name}>'

    def close(self) -> None:
        """Follow the files no longer; what is on the stage stays there. Safe to call more than once."""
        global _open
        with self._lock:  # a file may be looked at just now
            if _open is not self:
                return
            _open = None
            os.environ.pop(PACKAGE_IN_WORK, None)
        self._job.end()
        if shell := get_ipython():
            shell.events.unregister('post_run_cell', self._after_cell)

    # -- what a chapter does with it ---------------------------------------------------------------------

    def need(self, step: str) -> None:
        """Let the stage run nodes that have passed a step: the reader's if they have, ours if not.

        After ``stop`` it still runs none. The reader's files stay as they are, and run as soon as they are saved.

        :raises ParameterToolError: there is no such step.
        """
        copy = our_copy(step)
        with self._lock:
            self._step = step
            has_passed = self._has_passed()
            for root in (self.files.root, copy) if has_passed else (copy,):
                self._work_in(root)
                for program in self._programs:
                    program.seen = self.files.text(program.name)
                    self._run(program)
                # What has passed may have been changed since; and a later step may be about another file.
                if not any(status.is_error for status in self.statuses):
                    break
            if self.root == copy and self._words is not None:
                why = 'does not run' if has_passed else 'has not passed that step'
                for program in self._programs:
                    program.status = Status(
                        f'The stage runs our {program.name} as it is after step {step}. Yours {why}; it stays as it '
                        'is, and runs when you save it.')
        self._listeners.call()

    def start(self, *words: str) -> None:
        """Start the nodes again, as a new process would.

        :param words: What would come after ``--ros-args``, now and at each later start: '-p', 'max_speed_mps:=0.8'.
        """
        with self._lock:
            self._words = words
            for program in self._programs:
                self._run(program)
        self._listeners.call()

    def stop(self) -> None:
        """Take the nodes off the stage, for a program to take their place; the base stays. A saved file waits."""
        with self._lock:
            self._words = None
            for program in self._programs:
                if program.node in stage.current().nodes:
                    stage.current().remove(program.node)
                program.node, program.status = None, Status(f'{program.name} does not run on the stage.')
        self._listeners.call()

    def _work_in(self, root: Path) -> None:
        """Run what is in a folder, and let the chapter's commands find the package there."""
        self.root = root
        """The folder of the package that the stage runs: the reader's, or a copy of ours."""
        if self._is_followed:
            os.environ[PACKAGE_IN_WORK] = str(root)
        else:
            os.environ.pop(PACKAGE_IN_WORK, None)

    def _has_passed(self) -> bool:
        """True if the reader's package has passed the step, or is ours from after it."""
        progress = own_progress()
        solved = passed | set(progress.read()[0].solved if progress else ())
        later = steps()[steps().index(self._step):]
        # A step may be about a file that is no node, such as a launch file.
        places = {*(self.files.place(each.name) for each in self._programs), *changed_in(self._step)}
        return self._step in solved or (bool(self._programs) and any(
            all(self.files.text(each) == ours(step).get(each, '') for each in places) for step in later))

    def take_ours(self, step: str = '') -> None:
        """Put ours in the place of the reader's files, which are kept in ``ros2_ws/backups/``, and run it.

        :param step: As it stands after this one; by default after the one that the chapter has come to.
        :raises ParameterToolError: there is no such step, or a file cannot be written.
        """
        kept = self.files.take(step or self._step)
        self.refresh()
        print(f'{self.files.root.name} is now ours, as it is after step {step or self._step}.'
              + (f' Yours is in {kept.relative_to(self.files.backups.parents[1])}.' if kept else ''))

    def save(self, name: str, text: str, base: str | None = None) -> None:
        """Write one of the files, and run it.

        :param base: The text that was changed, if that may no longer be what is there; see ``PackageFiles.write``.
        :raises ParameterToolError: it cannot be written; what was there is there still.
        """
        self.files.write(name, text, self.files.text(name) if base is None else base)
        self.refresh(name)

    def changes(self, since: str, name: str = 'driver_node.py') -> None:
        """Print how a file differs from ours as it was after a step, as ``diff`` does.

        :raises ParameterToolError: there is no such step.
        """
        place = self.files.place(name)
        before = ours(since).get(place, '').splitlines()
        now = (self.root / place).read_text(encoding='utf-8').splitlines()
        print('\n'.join(list(difflib.unified_diff(before, now, lineterm='', n=1))[2:]))

    def node(self, name: str = 'driver_node.py') -> Node | None:
        """Return the node that the stage runs for a file; None if there is none."""
        return next((each.node for each in self._programs if each.name == name), None)

    def status(self, name: str = 'driver_node.py') -> Status:
        """Return what became of a file when it was run last."""
        return next((each.status for each in self._programs if each.name == name),
                    Status('Saved.' if self.files.text(name) else f'There is no {name} yet.'))

    @property
    def statuses(self) -> list[Status]:
        """What became of each file."""
        return [each.status for each in self._programs]

    def on_change(self, listener: Callable[[], None]) -> Callable[[], None]:
        """Call a listener when a file or what the stage runs has changed, in any thread.

        :return: Call it to stop listening.
        """
        return self._listeners.add(listener)

    # -- following the files -----------------------------------------------------------------------------

    def refresh(self, name: str = '') -> None:
        """Run the files whose text has changed.

        :param name: One that is to be run in any case.
        """
        changed = bool(name)
        with self._lock:
            if _open is not self:
                return
            for program in self._programs:
                text = self.files.text(program.name)
                if text != program.seen or name == program.name:
                    program.seen, changed = text, True
                    self._work_in(self.files.root)
                    self._run(program)
                changed = self._note_failure(program) or changed
        if changed:
            self._listeners.call()

    def _after_cell(self, _result: object) -> None:
        self.refresh()

    def _look_again(self) -> float:
        self.refresh()
        return _LOOK_SEC

    def _run(self, program: _Program) -> None:
        """Put the node of a file onto the stage, in the place of the one before; if that fails, that one again."""
        before, path = program.node_class, self.root / self.files.place(program.name)
        if not path.exists():
            program.status = Status(f'There is no {program.name} yet.')
            return
        if self._words is None:
            return
        try:
            node_class = load_node_class(path, self.root)
            node = self._add(node_class, path, self._words)
            program.is_older = False
        except LoadError as error:
            program.is_older = True
            if before is None or program.node in stage.current().nodes:
                unchanged = ' Nothing has changed on the stage.' if before else ''
                program.status = Status(f'{error}{unchanged}', bool(before or error.line), error.line)
                return
            self._words = program.words
            node_class, node = before, self._add(before, path, self._words)
            program.status = Status(f'{error} The version before runs again.', True, error.line)
        else:
            begins = f'as `{" ".join(self._words)}` says' if self._words else 'with the defaults'
            again = f' It begins {begins}: what was set before is lost.' if before else ''
            program.status = Status(f'{program.name} runs as {node.get_fully_qualified_name()}.{again}')
        if program.node is not node and program.node in stage.current().nodes:  # it has another namespace now
            stage.current().remove(program.node)
        program.node_class, program.node, program.words = node_class, node, self._words

    def _add(self, node_class: type[Node], path: Path, words: tuple[str, ...]) -> Node:
        return within_limit(lambda: stage.current().add(node_class, ros_args=words), path)

    def _note_failure(self, program: _Program) -> bool:
        """Show what a callback of a node has raised last; return whether that is new."""
        found = next((each for each in reversed(stage.current().failures)
                      if each.callback and each.callback.node is program.node), None)
        if found is program.failure or program.is_older:
            return False
        program.failure = found
        if found:
            error = describe(found.error, self.root / self.files.place(program.name))
            gone = ''
            if program.node and not isinstance(found.error, Exception):  # it would keep the only thread again
                stage.current().remove(program.node)
                program.node, program.node_class, gone = None, None, ' The stage runs it no longer.'
            program.status = Status(f'{found}: {error}{gone}', True, error.line)
        return True
