"""What a program is told after ``--ros-args``: other names, parameters, levels of logging.

rcl's arguments.c. Values of parameters are read by ``files.parsing``, which reads as rcl does.
"""

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import yaml

from param_tools.files.parsing import KEY, LOADER, Parser, Place, Rejected, effective, typed
from param_tools.rcl_in_python import logs
from param_tools.rcl_in_python.exceptions import RCLInvalidROSArgsError, UnknownROSArgsError
from param_tools.rcl_in_python.names import expand

_TOKEN = r'(?!__)[A-Za-z_](?:[A-Za-z0-9]|_(?!_))*'
_NAME = rf'(?:~/|/)?{_TOKEN}(?:/{_TOKEN})*'
_REMAP = re.compile(
    rf'(?:(?P<node>{_TOKEN}):)?'
    rf'(?:(?:__node|__name):=(?P<name>{_TOKEN})|__ns:=(?P<namespace>/(?:{_TOKEN}(?:/{_TOKEN})*/?)?)|'
    rf'(?:(?P<kind>rostopic|rosservice)://)?(?P<match>{_NAME}):=(?P<to>{_NAME}))')
_PARAMETER_PART = r'(?!__)[A-Za-z_][A-Za-z0-9_]*'
_PARAMETER = re.compile(
    rf'(?:(?P<node>{_TOKEN}):)?(?P<name>(?:/|{_PARAMETER_PART})(?:\.?/|(?:\.|(?<=/)){_PARAMETER_PART})*)'
    r':=(?P<value>.*)', re.DOTALL)
_ALL_NODES = '/**'
_LEVEL = re.compile(r'(?:(?P<logger>.*):=)?(?P<level>[^:=]*)', re.DOTALL)


class InvalidArgumentsError(Exception):
    """rcl would reject the arguments; the text is its reason."""


class Overrides(Parser):
    """The parameters of files, and of ``-p``, in the order in which they were given.

    YAML is read as by libyaml 0.1.7, which the wheels of rclpy have: in brackets and braces, a text that holds a colon
    or a question mark needs quotes. ROS has 0.2.5 on Ubuntu 24.04, which takes it without, and YAML 1.2 too.
    """

    _depth_in_brackets = 0

    def _handle(self, event: yaml.Event, place: Place) -> None:
        if isinstance(event, yaml.CollectionStartEvent):
            self._depth_in_brackets += bool(event.flow_style)
        elif isinstance(event, yaml.CollectionEndEvent):
            self._depth_in_brackets -= bool(self._depth_in_brackets)
        elif (isinstance(event, yaml.ScalarEvent) and self._depth_in_brackets and event.style not in ("'", '"')
              and re.search('[:?]', event.value)) or getattr(event, 'version', None) not in (None, (1, 1)):
            raise yaml.MarkedYAMLError(problem='unexpected character', problem_mark=event.start_mark)  # type: ignore[arg-type]
        super()._handle(event, place)

    def override(self, node: str, name: str, text: str) -> None:
        """Read the value of one parameter.

        :param node: Whose parameter it is: the name of a node, or a pattern for some.
        :raises Rejected: rcl would reject it.
        """
        if not text:
            raise Rejected(Place(), 'error not set')
        self._begin('')
        self.block_name, self.in_parameters = node, True
        self._enter(node)
        self._select(name, Place())
        try:
            for event in yaml.parse(text, Loader=LOADER):
                if isinstance(event, yaml.MappingStartEvent | yaml.AliasEvent):
                    raise Rejected(Place(), 'Unknown YAML event')
                self.expects_key = False
                self._handle(event, Place())
        except yaml.YAMLError:
            raise Rejected(Place(), 'Error parsing an event') from None


@dataclass(frozen=True)
class _Remap:
    """A rule that gives a node, a namespace, a topic or a service another name."""

    kinds: tuple[str, ...]
    node: str | None
    """Only in nodes of this name, without their namespace."""
    match: str
    to: str


def parse_remap(text: str) -> _Remap | None:
    """Return the rule that a text is, None if it is none."""
    found = _REMAP.fullmatch(text)
    if found is None:
        return None
    for kind in ('name', 'namespace'):
        if found[kind]:
            return _Remap((kind,), found['node'], '', found[kind])
    kinds = {'rostopic': ('topic',), 'rosservice': ('service',)}.get(found['kind'], ('topic', 'service'))
    return _Remap(kinds, found['node'], found['match'], found['to'])


@dataclass
class Arguments:
    """What a program or a node was told."""

    remaps: list[_Remap] = field(default_factory=list)
    overrides: Overrides = field(default_factory=Overrides)
    others: list[str] = field(default_factory=list)
    """Those that are not ROS's."""
    unknown: list[str] = field(default_factory=list)
    """Those after ``--ros-args`` that ROS does not know."""
    levels: dict[str, int] = field(default_factory=dict)
    """By logger; '' for all."""
    enclave: str = '/'
    has_rosout: bool = True
    has_stdout: bool = True
    log_config_file: str = ''

    def check(self) -> None:
        """:raises UnknownROSArgsError: ROS does not know some of them."""
        if self.unknown:
            raise UnknownROSArgsError(repr(self.unknown))

    def parameters(self, node: str) -> dict[str, Any]:
        """Return the overrides for a node, None for one without a value.

        :param node: Fully qualified name.
        """
        return {name: entry.value() for name, entry in effective(self.overrides, node).items()}


def remapped(sources: Sequence[Arguments], kind: str, name: str, node: str, namespace: str) -> str:
    """Return the name that the first rule for it gives, or the name as it is.

    :param sources: The first one goes first: a node's own before those of the program.
    :param name: Written out, for a topic or service.
    """
    for rule in (rule for source in sources for rule in source.remaps):
        if kind not in rule.kinds or rule.node not in (None, node):
            continue
        if kind in ('name', 'namespace'):
            return rule.to
        if expand(rule.match, node, namespace) == name:
            return expand(rule.to, node, namespace)
    return name


def parse(words: Sequence[str]) -> Arguments:
    """Return what a list of words says.

    :raises InvalidArgumentsError: rcl would reject it.
    """
    for word in words:
        word.encode()  # raises for what C has no text for
    arguments = Arguments()
    rest = iter(words)
    is_ros = False
    for word in rest:
        if word == '--ros-args':
            is_ros = True
        elif word == '--' and is_ros:
            is_ros = False
        elif is_ros:
            _parse_ros_word(arguments, word, rest)
        elif rule := parse_remap(word):
            logs.warn('rcl', f"Found remap rule '{word}'. This syntax is deprecated. Use '--ros-args --remap {word}' "
                             f'instead.')
            arguments.remaps.append(rule)
        else:
            arguments.others.append(word)
    return arguments


def _parse_ros_word(arguments: Arguments, word: str, rest: Iterator[str]) -> None:
    """Take what a flag says, and the word after it if it needs one."""
    if word in _FLAGS:
        take, nothing_after = _FLAGS[word]
        value = next(rest, None)
        if value is None:
            raise InvalidArgumentsError(nothing_after.format(word))
        take(arguments, word, value)
    elif found := re.fullmatch('--(enable|disable)-(rosout|stdout|external-lib)-logs', word):
        if found[2] != 'external-lib':
            setattr(arguments, f'has_{found[2]}', found[1] == 'enable')
    else:
        arguments.unknown.append(word)


def _take_override(arguments: Arguments, flag: str, text: str) -> None:
    found = _PARAMETER.fullmatch(text)
    try:
        if found is None:
            raise Rejected(Place(), _why_no_rule(text, 22))
        arguments.overrides.override(found['node'] or _ALL_NODES, found['name'], found['value'])
    except Rejected as rejected:
        raise InvalidArgumentsError(
            f"Couldn't parse parameter override rule: '{flag} {text}'. Error: {rejected}") from None


def _take_remap(arguments: Arguments, flag: str, text: str) -> None:
    rule = parse_remap(text)
    if rule is None:
        raise InvalidArgumentsError(f"Couldn't parse remap rule: '{flag} {text}'. Error: {_why_no_rule(text, 19)}")
    arguments.remaps.append(rule)


def _why_no_rule(text: str, separator: int) -> str:
    """Return rcl's words for the commonest reason why a text is no rule.

    :param separator: rcl's number for what stands between the two sides of one.
    """
    left, assigned, _ = text.partition(':=')
    return 'error not set' if assigned else (
        f'Expected lexeme type ({separator}) not found, search ended at index {len(left)}')


# Why a file is rejected, in the words of files.parsing and in those of rcl.
_WORDS = (
    ('ROS reads no aliases', 'Will not support aliasing at line {}'),
    ('a list cannot stand here', 'Sequences cannot be key at line {}'),
    ('a list cannot stand before', 'Sequences can only be values and not keys in params. Error at line {}'),
    ('there is no node name before', f'There are no node names before {KEY} at line {{}}'),
    ('there is a value before|a space must follow', f'Cannot have a value before {KEY} at line {{}}'),
    ('.* has no value', 'No value at line {}'),
    ('there is a value without a name', 'No key at line {}'),
    ('this is not', 'Error parsing a event near line {}'),
)
_TYPES = {bool: 'bool', int: 'integer', float: 'double', str: 'string'}


def _in_words_of_rcl(rejected: Rejected) -> str:
    """Return why a file is rejected as rcl says it, where it has words for that."""
    reason, line = str(rejected), rejected.place.line
    if found := re.match("the elements of .* must all be of one type; '(.*?)' is an? ", reason):
        kind = _TYPES[type(typed(found[1], False))]
        return f"Sequence should be of same type. Value type '{kind}' do not belong at line_num {line}"
    return next((words.format(line) for ours, words in _WORDS if re.match(ours, reason)), f'{reason} at line {line}')


def _take_file(arguments: Arguments, flag: str, path: str) -> None:
    try:
        arguments.overrides.parse(Path(path).read_bytes(), path)
    except OSError:
        reason = 'Error opening YAML file'
    except Rejected as rejected:
        reason = f'{_in_words_of_rcl(rejected)}, at {path}:{rejected.place.line}'
    else:
        return
    raise InvalidArgumentsError(f"Couldn't parse params file: '{flag} {path}'. Error: {reason}")


def _take_level(arguments: Arguments, flag: str, text: str) -> None:
    found = _LEVEL.fullmatch(text)
    level = logs.level_from_name(found['level']) if found else None
    if found is None or level is None:
        raise InvalidArgumentsError(f"Couldn't parse log level: '{flag} {text}'. Error: "
                                    f'Argument does not use a valid severity level')
    arguments.levels[found['logger'] or ''] = level


_Take = Callable[[Arguments, str, str], None]
_NO_RULE = "Couldn't parse trailing {} flag. No "
_FLAGS: dict[str, tuple[_Take, str]] = {
    flag: (take, nothing_after) for flags, take, nothing_after in (
        (('-p', '--param'), _take_override, _NO_RULE + 'parameter override rule found.'),
        (('-r', '--remap'), _take_remap, _NO_RULE + 'remap rule found.'),
        (('--params-file',), _take_file, _NO_RULE + 'file path provided.'),
        (('--log-level',), _take_level, "Couldn't parse trailing log level flag: '{}'. No log level provided."),
        (('--log-file-name',), lambda *_: None, _NO_RULE + 'string prefix provided.'),
        (('--log-config-file',), lambda arguments, _, text: setattr(arguments, 'log_config_file', text),
         _NO_RULE + 'file path provided.'),
        (('-e', '--enclave'), lambda arguments, _, text: setattr(arguments, 'enclave', text),
         _NO_RULE + 'enclave path provided.'),
    ) for flag in flags}


def parse_for_node(words: Sequence[str] | None) -> Arguments:
    """Return what the arguments of one node, or of none, say.

    :raises RCLInvalidROSArgsError: rcl would reject them.
    :raises UnknownROSArgsError: ROS does not know some of them.
    """
    try:
        arguments = parse(words or ())
    except InvalidArgumentsError as error:
        raise RCLInvalidROSArgsError(f'Failed to parse ROS arguments: {error}') from None
    arguments.check()
    return arguments


def rclpy_remove_ros_args(words: Sequence[str] | None) -> list[str]:
    return parse_for_node(words).others


