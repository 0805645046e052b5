"""What is known while a launch file is carried out, and the error that ends the launch."""

import contextlib
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator, Mapping, MutableMapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from types import FrameType
from typing import Any, NamedTuple, NoReturn

from param_tools.cli.index import PackageNotFound
from param_tools.cli.run import ProgramNotFound, find_program
from param_tools.cli.session import CommandFailed

# Whose lines no author of a launch file knows.
PACKAGE = Path(__file__).parents[2]


class Origin(NamedTuple):
    """Where a person has written what launch hands on."""

    file: Path
    line: int | None
    """None if it is the same as in what launch has made of the file."""
    number: int = 0
    """Of a dictionary of parameters, its place in the list of them."""
    lines: Mapping[str, int] = {}
    """In a file that launch has read itself, the line of each parameter."""
    is_filled_in: bool = True
    """False for a file in which launch leaves substitutions as they are."""


def written_here() -> Origin | None:
    """Return the line of a launch file in Python that is being carried out; None if there is none."""
    frame: FrameType | None = sys._getframe(1)
    while frame is not None and (frame.f_code.co_filename.startswith('<')
                                 or PACKAGE in Path(frame.f_code.co_filename).parents):
        # Above it stands who has started the launch.
        frame = None if frame.f_code.co_name == 'carry_out' else frame.f_back
    return None if frame is None else Origin(Path(frame.f_code.co_filename), frame.f_lineno)


class LaunchFailed(CommandFailed):
    """A launch file asks for something that cannot be done."""

    origin: Origin | None = None
    """Where it asks, if that is known."""

    def place(self) -> str:
        """Return the beginning of a line that names the place; empty if it is not known."""
        if self.origin is None:
            return ''
        return f'{self.origin.file}:{self.origin.line}: ' if self.origin.line else f'{self.origin.file}: '


@contextlib.contextmanager
def blaming(origin: Origin | None) -> Iterator[None]:
    """Add the place to an error that has none."""
    try:
        yield
    except LaunchFailed as error:
        error.origin = error.origin or origin
        raise


def reject(what: str) -> NoReturn:
    """Reject what is left out here.

    :param what: Its name.
    :raises LaunchFailed: always.
    """
    raise LaunchFailed(f"the course's own ros2 launch has no {what}: the genuine `ros2 launch` has, which comes with "
                       f'ROS (environment/README.md)')


@dataclass
class Context:
    """What actions and substitutions know, and what the actions before them have set.

    ``launch_configurations``, ``environment`` and ``perform_substitution`` have the names that the functions in launch
    files use.
    """

    launch_configurations: dict[str, Any] = field(default_factory=dict)
    """The arguments that were given, and the defaults of the others. As in launch_ros, ``ros_namespace``,
    ``ros_remaps`` and ``global_params`` are among them: what PushROSNamespace, SetRemap and SetParameter have set."""
    folder: Path = Path(tempfile.gettempdir())
    """Where parameter files are written."""
    log: Callable[[str, str, str], object] = lambda _level, _name, _text: None
    """Prints a line, of a level and a logger."""
    launch_file: Path | None = None
    """The launch file that was included last."""
    environment: MutableMapping[str, str] = field(default_factory=lambda: os.environ)
    """The environment variables: those of this process, which launch files in Python change, too."""
    environment_before: Mapping[str, str] = field(default_factory=lambda: dict(os.environ))
    """The environment variables before the launch file was carried out."""
    origins: dict[str, Origin] = field(default_factory=dict)
    """For the path of each parameter file that launch writes, and each word after ``-p``, where it comes from."""
    given: dict[str, Any] = field(default_factory=dict)
    """For each word after ``-p``, the value in the launch file."""
    postponed: list[Sequence[Any]] = field(default_factory=list)
    """In a rehearsal, the actions of timers and event handlers."""

    def perform_substitution(self, substitution: Any) -> str:
        """Return the string that a substitution stands for."""
        return str(substitution.perform(self))

    @contextlib.contextmanager
    def scope(self) -> Iterator[None]:
        """Undo, in the end, what is set in the meantime."""
        configurations, environment = dict(self.launch_configurations), dict(self.environment)
        try:
            yield
        finally:
            self.launch_configurations = configurations
            if self.environment != environment:
                self.environment.clear()
                self.environment.update(environment)

    def write(self, text: str, origin: Origin | None) -> Path:
        """Write a parameter file, and return its path.

        :param origin: Where its content comes from, if that is known.
        """
        with tempfile.NamedTemporaryFile('w', prefix='launch_params_', dir=self.folder, delete=False,
                                         encoding='utf-8') as file:
            file.write(text)
        if origin is not None:
            self.origins[file.name] = origin
        return Path(file.name)

    def warn(self, text: str, origin: Origin | None, kind: str = 'unreadable') -> None:
        """Warn of something that the launch file says there.

        :param kind: As of a finding of ``check``.
        """
        self.log('WARNING', 'launch_ros.actions.node', text)

    # -- what a rehearsal does otherwise ------------------------------------------------------------------------------

    def find_program(self, package: str, executable: str) -> list[str]:
        """Return the words that start a package's program."""
        try:
            return find_program(package, executable)
        except PackageNotFound:
            searched = [each for each in os.environ.get('AMENT_PREFIX_PATH', '').split(os.pathsep) if each]
            where = f', searching: {searched}' if searched else ''
            raise LaunchFailed(f"package '{package}' not found{where}. Correct its name, or build it and source its "
                               f'workspace in this shell') from None
        except ProgramNotFound as error:
            raise LaunchFailed(f"executable '{executable}' not found in package '{package}', which has "
                               f'{", ".join(sorted(error.names)) or "none"}') from None

    def find_executable(self, name: str) -> str:
        """Return the path of a program on the PATH."""
        if path := shutil.which(name, path=self.environment.get('PATH')):
            return path
        raise LaunchFailed(f"executable '{name}' not found on the PATH")

    def output_of(self, command: Sequence[str]) -> str:
        """Run a command, and return what it prints."""
        try:
            done = subprocess.run(command, capture_output=True, text=True, env=dict(self.environment), check=False)
        except OSError as error:
            raise LaunchFailed(f'cannot run {command[0]}: {error.strerror}') from None
        if done.returncode or done.stderr:
            failed = 'executed command failed' if done.returncode else 'executed command showed stderr output'
            raise LaunchFailed(f'{failed}. Command: {" ".join(command)}\nCaptured stderr output: {done.stderr}')
        return done.stdout

    def expect_launchable(self, what: str) -> None:
        """Expect to carry out what only the genuine launch can start; a rehearsal can."""
        reject(what)
