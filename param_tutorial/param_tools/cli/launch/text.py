"""Texts with substitutions in them, such as ``$(var speed)``: in parameter files, and in launch files in XML and YAML.

The grammar is launch's (grammar.lark): a backslash keeps the character after it, and an argument may be in quotes.
"""

import re
from collections.abc import Callable

from param_tools.cli.launch import substitutions as known
from param_tools.cli.launch.context import LaunchFailed, reject
from param_tools.cli.launch.substitutions import Substitution, TextSubstitution

_BEGINNING = re.compile(r'\$\(([A-Za-z][\w-]*)')
# Plain text outside substitutions, and as a part of an argument: without quotes, and inside each kind of quotes.
_PLAIN = {quote: re.compile(rf'(?:\\.|[^$\\{quote}]|\\|\$(?!\())+', re.DOTALL) for quote in ('', "'", '"')}
_PART = {quote: re.compile(rf'(?:\\[^ ]|[^ $\\(){quote or chr(34) + chr(39)}]|\$(?!\())+') for quote in ('', "'", '"')}


# What each name stands for, called with the arguments.
KINDS: dict[str, Callable[..., Substitution]] = {
    'var': lambda name, default=None: known.LaunchConfiguration(name, default=default),
    'env': lambda name, default=None: known.EnvironmentVariable(name, default_value=default),
    'find-pkg-share': known.FindPackageShare,
    'find-pkg-prefix': known.FindPackagePrefix,
    'exec-in-pkg': known.ExecutableInPackage,
    'find-exec': lambda name: known.FindExecutable(name=name),
    'dirname': known.ThisLaunchFileDir,
    'eval': known.PythonExpression,
    'command': known.Command,
    'file-content': known.FileContent,
    'param': lambda name, default=None: known.Parameter(name, default=default),
    'if': known.IfElseSubstitution,
    'not': known.NotSubstitution,
    'and': known.AndSubstitution,
    'equals': known.EqualsSubstitution,
    'not-equals': known.NotEqualsSubstitution,
}
# Substitutions of ROS 1, and what they are called in ROS 2.
ROS_1 = {'arg': 'var', 'find': 'find-pkg-share', 'optenv': 'env'}


def parse_text(text: str) -> list[Substitution]:
    """Return the parts of a text: plain ones and substitutions."""
    return _Reader(text).template('') or [TextSubstitution(text='')]


def unescape(text: str) -> str:
    """Return a text without the backslashes that keep the characters after them."""
    return re.sub(r'\\(.)', r'\1', text)


class _Reader:
    def __init__(self, text: str):
        self._text = text
        self._place = 0

    def template(self, quote: str) -> list[Substitution]:
        """Read up to a quotation mark, or to the end."""
        found: list[Substitution] = []
        while self._place < len(self._text) and not (quote and self._is_at(quote)):
            if plain := self._take(_PLAIN[quote]):
                found.append(TextSubstitution(text=unescape(plain)))
            else:
                found.append(self._substitution(quote))
        return found

    def _substitution(self, quote: str) -> Substitution:
        start = self._place
        beginning = _BEGINNING.match(self._text, start)
        if beginning is None:
            raise self._unreadable(start)
        self._place = beginning.end()
        arguments = []
        while self._is_at(' '):
            self._place += 1
            arguments.append(self._argument(quote, start))
        if not self._is_at(')'):
            raise self._unreadable(start)
        self._place += 1
        name = beginning[1]
        if name in ROS_1:
            raise LaunchFailed(f'launch has no substitution {self._text[start:self._place]}, which is of ROS 1: ROS 2 '
                               f'has $({ROS_1[name]} ...)')
        if name not in KINDS:
            reject(f'substitution {self._text[start:self._place]}')
        try:
            return KINDS[name](*arguments)
        except TypeError:
            raise LaunchFailed(f'{self._text[start:self._place]} has too many arguments or too few') from None

    def _argument(self, quote: str, start: int) -> list[Substitution]:
        if not quote and self._text[self._place:self._place + 1] in ('"', "'"):
            own = self._text[self._place]
            self._place += 1
            found = self.template(own)
            if not self._is_at(own):
                raise self._unreadable(start)
            self._place += 1
            return found
        found = []
        while True:
            if part := self._take(_PART[quote]):
                found.append(TextSubstitution(text=unescape(part)))
            elif self._is_at('$('):
                found.append(self._substitution(quote))
            elif found:
                return found
            else:
                raise self._unreadable(start)

    def _take(self, pattern: re.Pattern[str]) -> str:
        found = pattern.match(self._text, self._place)
        if found is None:
            return ''
        self._place = found.end()
        return found[0]

    def _is_at(self, text: str) -> bool:
        return self._text.startswith(text, self._place)

    def _unreadable(self, start: int) -> LaunchFailed:
        line = self._text[start:].splitlines()[0]
        return LaunchFailed(f'a substitution cannot be read: {line[:80]}; it has to be $(name argument …), with one '
                            f'space before each argument and quotes around one that holds spaces')
