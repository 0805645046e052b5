"""``%ros2`` and ``%%ros2``: the ``ros2`` command in a notebook; ``%%shell`` and ``%ros2_terminal``.

The course's own ``ros2`` answers, from the executor in the background and without a process, with the output of the
genuine one.
"""

import html
import re
import shlex
import sys
import warnings
from collections.abc import Sequence
from contextlib import ExitStack, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from IPython.core.error import UsageError
from IPython.core.getipython import get_ipython
from IPython.core.interactiveshell import ExecutionInfo, InteractiveShell
from IPython.core.magic import Magics, cell_magic, line_magic, magics_class, no_var_expand

from param_tools.cli import command as embedded
from param_tools.cli.session import Session, TextStream
from param_tools.errors import ExecutorError
from param_tools.panel.front import from_pages
from param_tools.ros import domain, host, stage
from param_tutorial.notebook import stored
from param_tutorial.notebook.shell import Shell

if TYPE_CHECKING:
    from param_tutorial.notebook.personal_line import PersonalLine


def load_ipython_extension(ipython: InteractiveShell) -> None:
    """Make the magics known, and let errors show their last line only: ``%load_ext param_tutorial``.

    Most errors in a lesson are meant, and a page of rclpy's source above each would bury what it says.
    ``%xmode Context`` brings the whole traceback back.
    """
    # IPython keeps all instances until the shell ends, and each run of a first cell loads again.
    known = next((each for each in ipython.configurables if isinstance(each, Ros2Magics)), None)
    ipython.register_magics(known or Ros2Magics)
    ipython.user_ns.update(exit=_NoExit(), quit=_NoExit())
    ipython.InteractiveTB.set_mode('Minimal')
    # A client that has only just come, or has gone, is no affair of the cell that runs.
    warnings.filterwarnings('ignore', 'failed to send response', RuntimeWarning)
    ipython.events.register('pre_run_cell', _before_cell)
    if _await_shell not in ipython.input_transformers_post:
        ipython.input_transformers_post.append(_await_shell)
    if not host.host.has_processes:
        stored.install(ipython)
    if hasattr(ipython, 'kernel'):
        # Imported here: a shell without a page needs no widgets.
        from param_tutorial.notebook import veil

        veil.begin()


_SHELL_CALL = "get_ipython().run_cell_magic('shell', "


def _await_shell(lines: list[str]) -> list[str]:
    """Let a cell of ``%%shell`` await its commands.

    Where a page has no subshell for its widgets, ipykernel hears of sliders and buttons while a cell awaits something,
    and not before the end of any other cell.
    """
    return [f'await {line}' if line.startswith(_SHELL_CALL) else line for line in lines]


def _before_cell(info: ExecutionInfo) -> None:
    """Let the cell that is about to run find all done that a hand did before it, and read its own log lines only."""
    from_pages.wait()
    with suppress(ExecutorError):  # raised before the first start()
        stage.current().node_log.mark()
    ipython = get_ipython()
    # A first cell may be run again, and loading again does no harm. IPython would print that it has been done already.
    manager = getattr(ipython, 'extension_manager', None)
    if manager is not None and '%load_ext param_tutorial' in (info.raw_cell or ''):
        manager.loaded.discard('param_tutorial')


class _NoExit:
    """Stands in for ``exit`` and ``quit``, which end a kernel: programs that are pasted into a cell contain them."""

    def __repr__(self) -> str:
        return ('exit() would end this kernel with every node in it, so it does nothing here: leave this line out')

    def __call__(self, *_status: object) -> None:
        raise UsageError(repr(self))


@magics_class
class Ros2Magics(Magics):
    """The magics; what is typed after ``%ros2`` is what would be typed after ``ros2`` in a terminal."""

    @no_var_expand
    @line_magic('ros2')
    def line(self, line: str) -> None:
        """Run one ros2 command: ``%ros2 param list /simple_param_node``.

        Quotes and ``> file`` work as in a shell; IPython's ``$name`` and ``{name}`` do not, because braces are
        common in values. The exit status is in ``_exit_code`` afterwards.
        """
        self._run([line])

    @no_var_expand
    @cell_magic('ros2')
    def cell(self, line: str, cell: str) -> None:
        """Run several ros2 commands, one to a line; like a shell, go on after one that fails."""
        lines = re.sub(r'\\\r?\n', '', cell).splitlines()
        self._run([line, *lines])

    @no_var_expand
    @cell_magic('shell')
    async def shell_cell(self, line: str, cell: str) -> None:
        """Type the cell's lines into a Shell: ``%%shell first``, where ``first`` is the notebook's name for it.

        The exit status is in ``_exit_code`` afterwards. The kernel is free meanwhile.
        """
        name = line.strip()
        shell = self._names.get(name)
        if not isinstance(shell, Shell):
            raise UsageError(f'%%shell takes the name of a Shell, as in: first = param_tutorial.Shell(), and then '
                             f'%%shell first. {name or "(nothing)"} is none')
        if output := await shell.run_awaited(cell.rstrip('\n')):
            print(output)
        self._names['_exit_code'] = shell.status

    @line_magic('ros2_terminal')
    def terminal(self, line: str) -> 'PersonalLine':
        """Show the line that makes a terminal join the ROS domain of this notebook."""
        return terminal_hint()

    @property
    def _names(self) -> dict[str, Any]:
        """The notebook's variables."""
        assert self.shell is not None  # register_magics has set it
        names: dict[str, Any] = self.shell.user_ns
        return names

    def _run(self, lines: list[str]) -> None:
        for line in lines:
            try:
                command = _parse(line)
                if command.words:
                    self._names['_exit_code'] = _run(command)
            except (_NotUnderstood, OSError) as error:
                print(error, file=sys.stderr)
                self._names['_exit_code'] = 1


class _Command(NamedTuple):
    words: list[str]
    target: str | None
    """The file to which standard output goes."""
    append: bool


class _NotUnderstood(Exception):
    """The line is more than one command; the message says so."""


_OPERATORS = '|;&<>`'
# shlex does not tell which of its words were in quotes. There, and after a backslash, the characters of operators are
# others while it reads, from the range that Unicode leaves to private use.
_DISGUISE = {ord(char): 0xE000 + ord(char) for char in _OPERATORS}
_NO_DISGUISE = {disguised: char for char, disguised in _DISGUISE.items()}
_LITERAL_OR_COMMENT = re.compile(r'''(?P<comment>(?<!\S)#.*)|\\.|'[^']*'|"(?:\\.|[^"\\])*"''')
_OTHER_STREAM = re.compile(r'(?<!\S)[12]>')


def _parse(line: str) -> _Command:
    """Split a line into words as a shell would, without being one."""
    disguised = _LITERAL_OR_COMMENT.sub(lambda match: '' if match['comment'] else match[0].translate(_DISGUISE), line)
    lexer = shlex.shlex(disguised, posix=True, punctuation_chars=_OPERATORS)
    lexer.whitespace_split, lexer.commenters = True, ''
    try:
        words = list(lexer)
    except ValueError as error:
        raise _NotUnderstood(f'{line!r} cannot be split into words: {error}') from None
    # An empty word is one in quotes.
    operators = [word for word in words if word and not word.strip(_OPERATORS)]
    if others := ''.join(operators).replace('>', ''):
        raise _NotUnderstood(f'{others[0]!r} needs a shell, which %ros2 is not: one command, and > for a file, is '
                             'all. Put it in quotes if it is part of a value, or type the line into a '
                             'param_tutorial.Shell()')
    if operators[1:] or not {'>', '>>'}.issuperset(operators) or _OTHER_STREAM.search(disguised):
        raise _NotUnderstood('only one > or >> is understood, and it takes what goes to standard output')
    at = words.index(operators[0]) if operators else len(words)
    if operators and not words[at + 1:]:
        raise _NotUnderstood('a file name must follow >')
    words = [word.translate(_NO_DISGUISE) for word in words]
    target, rest = words[at + 1:at + 2], words[:at] + words[at + 2:]
    return _Command(rest[1:] if rest[:1] == ['ros2'] else rest, target[0] if target else None, operators == ['>>'])


def _advise_terminal(words: Sequence[str]) -> str:
    """Return a sentence on what to do instead of a command that would not let the cell end."""
    # Not param_tutorial.start(), which would first remove the nodes that are there.
    return (f'This would keep the cell busy until you interrupt it. Run it beside the notebook: '
            f'terminal = param_tutorial.Terminal({shlex.join(["ros2", *words])!r}); or add its node to the executor '
            f'in the notebook: ros.add(...)')


def _run(command: _Command) -> int:
    with ExitStack() as stack:
        output: TextStream = sys.stdout
        if command.target is not None:
            path = Path(command.target).expanduser()
            output = stack.enter_context(path.open('a' if command.append else 'w', encoding='utf-8'))
        streams = _Stream(output, sys.stderr), _Stream(sys.stderr, output)
        try:
            return embedded.main(command.words, Session(*streams, stage.current, in_notebook=True,
                                                        advise_instead=_advise_terminal))
        finally:
            for stream in streams:
                stream.flush()


class _Stream:
    """A stream that is written after another one has been flushed, so that a cell keeps the order of the two."""

    def __init__(self, stream: TextStream, other: TextStream):
        self._stream, self._other = stream, other

    def write(self, text: str) -> int:
        self._other.flush()
        return self._stream.write(text)

    def flush(self) -> None:
        self._stream.flush()


def terminal_hint() -> 'PersonalLine':
    """Return a widget with the line that makes a terminal join the ROS domain of this notebook, if any could."""
    from param_tutorial.notebook.personal_line import PersonalLine

    if not host.host.has_processes:
        return PersonalLine('The nodes of this notebook live in a web page, and no terminal finds them there. On your '
                            'own computer, this cell shows a line to paste into a terminal.',
                            '(no terminal finds the nodes of a web page)')
    return PersonalLine(
        f'Paste this line into a terminal, and <code>ros2</code> there finds the nodes of this notebook:'
        f'<pre style="user-select: all; white-space: pre-wrap">{html.escape(terminal_line())}</pre>',
        '(a line to paste into a terminal, so that it joins this notebook)')


def terminal_line() -> str:
    """Return the line of shell that makes a terminal join the ROS domain of this process."""
    domain.choose()
    settings = ' '.join(f'{name}={shlex.quote(value)}' for name, value in domain.settings().items())
    embedded_ros2 = shlex.join([sys.executable, '-m', 'param_tutorial'])
    return f'export {settings}; command -v ros2 >/dev/null || alias ros2={shlex.quote(embedded_ros2)}'
