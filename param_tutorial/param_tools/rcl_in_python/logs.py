"""Logging: levels by logger, the lines on the terminal, and /rosout.

rcutils' logging.c and rcl's logging_rosout.c. A logger without a level has that of the next one above it, and the root
has INFO. No file is written.
"""

import os
import sys
import time
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from datetime import datetime
from pathlib import Path
from typing import NamedTuple

from param_tools.rcl_in_python.enums import RCUTILS_LOG_SEVERITY as SEVERITY

SEPARATOR = '.'
_PREFIX = 'RCUTILS_LOG_SEVERITY_'
_LEVELS = {each.name.removeprefix(_PREFIX): int(each) for each in SEVERITY}
_NAMES = {level: name for name, level in _LEVELS.items()}
_FORMAT = '[{severity}] [{time}] [{name}]: {message}'


class Record(NamedTuple):
    """One message."""

    severity: int
    name: str
    message: str
    function: str
    file: str
    line: int
    time_ns: int


Publish = Callable[[Record], None]


@dataclass
class State:
    """What has been set, until the logging system is shut down."""

    levels: dict[str, int] = field(default_factory=dict)
    format: str = field(default_factory=lambda: os.environ.get('RCUTILS_CONSOLE_OUTPUT_FORMAT') or _FORMAT)
    uses_stdout: bool = field(default_factory=lambda: os.environ.get('RCUTILS_LOGGING_USE_STDOUT') == '1')


@dataclass
class Output:
    """Where messages go besides, as the first context's arguments say."""

    has_terminal: bool = True
    has_rosout: bool = False


state = State()
output = Output()
# Publishers on /rosout, by the name of a node's logger, and how often each logger below one has been asked for.
rosout: dict[str, Publish] = {}
subloggers: Counter[str] = Counter()
publisher_of_sublogger: dict[str, Publish] = {}


# -- levels ---------------------------------------------------------------------------------------------------

def level_from_name(name: str) -> int | None:
    """Return the number of a level, None if there is none of that name, in whichever case."""
    return _LEVELS.get(name.upper())


def effective_level(name: str) -> int:
    """Return the level of a logger, or that of the nearest one above it that has one."""
    while name:
        if level := state.levels.get(name):
            return level
        name = name.rpartition(SEPARATOR)[0]
    return state.levels.get('', SEVERITY.RCUTILS_LOG_SEVERITY_INFO)


def rclpy_logging_get_logger_effective_level(name: str) -> int:
    return effective_level(name)


def rclpy_logging_get_logger_level(name: str) -> int:
    return state.levels.get(name, 0) if name else effective_level('')


def rclpy_logging_logger_is_enabled_for(name: str, severity: int) -> bool:
    return int(severity) >= effective_level(name)


def rclpy_logging_set_logger_level(name: str, level: int, detailed_error: bool = False) -> None:
    if int(level) not in _NAMES:
        reason = ('Invalid severity level specified for logger' if level < 0 else
                  'Unable to determine severity_string for severity')
        raise RuntimeError(f'Failed reason: {reason}' if detailed_error else 'Failed to set level for logger')
    state.levels[name] = int(level)


def rclpy_logging_severity_level_from_string(name: str) -> int:
    level = level_from_name(name)
    if level is None:
        raise RuntimeError('Failed to get severity name')
    return level


def rclpy_logging_get_separator_string() -> str:
    return SEPARATOR


# -- beginning and end ----------------------------------------------------------------------------------------

def rclpy_logging_initialize() -> None:
    """There is nothing to do: what is set is kept from the first use on."""


def rclpy_logging_shutdown() -> None:
    global state
    state = State()


def configure(levels: dict[str, int], *, has_terminal: bool, has_rosout: bool) -> None:
    """Do as the arguments of the first context say."""
    global output
    for name, level in levels.items():
        rclpy_logging_set_logger_level(name, level)
    output = Output(has_terminal, has_rosout)


def rclpy_logging_fini() -> None:
    global output
    output = Output()


def rclpy_logging_get_logging_directory() -> str:
    """Return where the real one would write its files."""
    if folder := os.environ.get('ROS_LOG_DIR'):
        return str(Path(folder).expanduser())
    return str(Path(os.environ.get('ROS_HOME') or '~/.ros').expanduser() / 'log')


# -- messages -------------------------------------------------------------------------------------------------

def rclpy_logging_rcutils_log(severity: int, name: str, message: str | None, function: str, file: str, line: int,
                              ) -> None:
    if message is None:
        message = '(null)'  # as C prints it
    elif not isinstance(message, str):
        raise TypeError(f'rclpy_logging_rcutils_log(): incompatible function arguments: the message is {message!r}')
    if not rclpy_logging_logger_is_enabled_for(name, severity):
        return
    record = Record(int(severity), name, message, function, file, line, time.time_ns())
    if output.has_terminal:
        _write(record)
    if output.has_rosout and (publish := rosout.get(name) or publisher_of_sublogger.get(name)):
        publish(record)


def warn(name: str, message: str) -> None:
    """Log a warning of ROS's own."""
    rclpy_logging_rcutils_log(SEVERITY.RCUTILS_LOG_SEVERITY_WARN, name, message, '', '', 0)


def error(name: str, message: str) -> None:
    """Log an error of ROS's own."""
    rclpy_logging_rcutils_log(SEVERITY.RCUTILS_LOG_SEVERITY_ERROR, name, message, '', '', 0)


def _write(record: Record) -> None:
    stream = sys.stdout if state.uses_stdout else sys.stderr
    if stream is None:
        return
    stream.write(_formatted(record) + '\n')
    stream.flush()


def _formatted(record: Record) -> str:
    seconds, nanoseconds = divmod(record.time_ns, 10**9)
    moment = datetime.fromtimestamp(seconds)
    values = {
        'severity': _NAMES.get(record.severity, ''), 'name': record.name, 'message': record.message,
        'function_name': record.function, 'file_name': record.file, 'line_number': record.line,
        'time': f'{seconds}.{nanoseconds:09}', 'time_as_nanoseconds': record.time_ns,
        'date_time_with_ms': f'{moment:%Y-%m-%d %H:%M:%S}.{nanoseconds // 10**6:03}',
    }
    text = state.format
    # The message last: what it holds is no format.
    for key in sorted(values, key='message'.__eq__):
        text = text.replace(f'{{{key}}}', str(values[key]))
    return text


# -- /rosout --------------------------------------------------------------------------------------------------

def add_rosout(logger: str, publish: Publish) -> None:
    """Publish the logs of this logger on /rosout."""
    if logger in rosout:
        warn('rcl.logging_rosout', (
            f"Publisher already registered for node name: '{logger}'. If this is due to multiple nodes with the same "
            f"name then all logs for the logger named '{logger}' will go out over the existing publisher. As soon as "
            f'any node with that name is destructed it will unregister the publisher, preventing any further logs for '
            f'that name from being published on the rosout topic.'))
        return
    rosout[logger] = publish


def remove_rosout(logger: str) -> None:
    """Stop publishing the logs of this logger and its children on /rosout."""
    publish = rosout.pop(logger, None)
    for name in [name for name, each in publisher_of_sublogger.items() if each is publish]:
        del publisher_of_sublogger[name], subloggers[name]


def rclpy_logging_rosout_add_sublogger(logger: str, sublogger: str) -> bool:
    """Return whether the logger publishes, and so does the one below it from now on."""
    publish = rosout.get(logger) or publisher_of_sublogger.get(logger)
    if publish is None:
        return False
    name = f'{logger}{SEPARATOR}{sublogger}'
    publisher_of_sublogger[name] = publish
    subloggers[name] += 1
    return True


def rclpy_logging_rosout_remove_sublogger(logger: str, sublogger: str) -> None:
    name = f'{logger}{SEPARATOR}{sublogger}'
    if name in subloggers:
        subloggers[name] -= 1
        if not subloggers[name]:
            del publisher_of_sublogger[name], subloggers[name]
