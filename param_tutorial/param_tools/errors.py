"""Every exception that the tools raise on purpose, and the causes of some that others raise. No ROS, no Jupyter.

    ParameterToolError
    ├── ExecutorError               the background executor cannot do what was asked
    │   └── StuckError              because it does not return
    ├── NoProcessError              this needs a process of its own, and a web page can start none
    ├── LayerError                  rclpy cannot stand on its layer in Python here  (also ImportError)
    ├── WaitTimeoutError            a condition did not come true in time           (also TimeoutError)
    ├── InvalidValueError           this Python value cannot be a ROS parameter     (also ValueError)
    ├── ParameterFileError          a YAML file cannot be read or written faithfully (also ValueError)
    └── NodeError                   about one node; carries ``.node``
        ├── NodeNotFoundError       there is no node of that name                   (also LookupError)
        ├── NoServiceError          the node is there, without this parameter service
        ├── NoAnswerError           the node is there and did not answer in time    (also TimeoutError)
        ├── NodeGoneError           the node went away in mid-call                  (also ConnectionError)
        ├── CallbackError           the node's own callback raised instead of answering
        ├── ParameterNotDeclaredError  the node has no parameter of that name       (also LookupError)
        └── ParameterRejectedError   the node said no; carries ``.result``

A rejected value is not an exception by itself: it is a result with a reason (see ``client.SetResult``), and
becomes a ParameterRejectedError on request.
"""

import copyreg
import difflib
import linecache
import re
import traceback
from collections.abc import Sequence
from typing import Any, Protocol

# What to think of if an exception, with its line, is like this.
_CAUSES = (
    (r'takes \d+ positional arguments? but \d+ w', 'The first parameter of a method is `self`: the object itself'),
    (r"'NoneType' object is not callable|\.(\w+)\(\) missing .*self\.\1\(\)",
     'A callback is given by its name alone, without parentheses'),
    (r"SetParametersResult' object is not iter", 'A pre-set callback returns a list; a judge is an on-set callback'),
    (r"'(NoneType|bool)' object has no attribute 'successful'", 'A judge returns a `SetParametersResult` in any case'),
    (r"'(function|method|Future)' object has no attribute '(successful|results?|values|names)'",
     'It is a future, whose answer has still to come'),
    (r"'NoneType' object has no attribute '(results?|values|types|descriptors)'",
     '`None` is an answer that has not come: `result()` of a future does not wait for it'),
    (r"Range' object is not subs", 'A descriptor has its range in a list, in brackets'),
    (r'create (publisher|subscription): ', 'That topic may have messages of another type'),
)


class ParameterToolError(Exception):
    """Base of everything below: ``except ParameterToolError`` catches whatever these tools raise."""

    def __reduce__(self) -> tuple[Any, ...]:
        """Let a snapshot that holds errors be copied: Python would pass the message to ``__init__``."""
        return copyreg.__newobj__, (type(self),), {**self.__dict__, 'args': self.args}  # type: ignore[attr-defined]


class ExecutorError(ParameterToolError):
    """The background executor cannot do what was asked; the message says what to do."""


class StuckError(ExecutorError):
    """What the background executor was to do does not return, and cannot be interrupted."""


class NoProcessError(ParameterToolError):
    """This can't run without a process of its own, and where we are, no process can be started."""


class LayerError(ParameterToolError, ImportError):
    """rclpy cannot stand on its layer in Python in this process; the message says why."""


class WaitTimeoutError(ParameterToolError, TimeoutError):
    """A condition did not come true before its deadline; the message says which."""


class InvalidValueError(ParameterToolError, ValueError):
    """This Python value cannot be stored in a ROS parameter."""


class ParameterFileError(ParameterToolError, ValueError):
    """A parameter file cannot be read, or a value cannot be written so that rcl reads it back."""


class NodeError(ParameterToolError):
    """Something about one node, whose fully qualified name is in ``.node``."""

    def __init__(self, node: str, message: str):
        super().__init__(message)
        self.node = node


class NodeNotFoundError(NodeError, LookupError):
    """There is no node of that name."""

    def __init__(self, node: str, existing: Sequence[str], *, on_network: bool = False):
        """:param on_network: True if it was looked for on other machines as well."""
        self.existing = existing
        where = ', neither on this machine nor on the network' if on_network else ''
        super().__init__(node, f'there is no node {node}{where}{nearest(node, existing, "No node is running")}')


class NoServiceError(NodeError):
    """The node is there and doesn't offer a parameter service."""

    def __init__(self, node: str, service: str):
        super().__init__(node, f'{node} is running but offers no {service} service: it was created with '
                               f'start_parameter_services=False, or is just leaving')


class NoAnswerError(NodeError, TimeoutError):
    """The node is there but did not answer in time: it is busy, stopped, or nobody spins it."""

    def __init__(self, node: str, service: str, timeout_sec: float, *, on_network: bool = False, culprit: str = ''):
        """
        :param on_network: True if the node may live on another machine.
        :param culprit: Says which callback has kept the executor's thread, if one has.
        """
        why = (f': {culprit}' if culprit else
               '. It is there, but busy in a callback, stopped in a debugger, or not spun by any executor'
               f'{", or the network to its machine is slow or down" if on_network else ""}')
        super().__init__(node, f'{node} did not answer {service} within {timeout_sec:g} s{why}')


class NodeGoneError(NodeError, ConnectionError):
    """The node was there when the call began and left before it answered."""

    def __init__(self, node: str, service: str):
        super().__init__(node, f'{node} went away before it answered {service}: whether it did what was '
                               f'asked is not known')


class CallbackError(NodeError):
    """A callback of the node raised an exception, so the caller will never get an answer.

    The original exception, with its traceback, is the ``__cause__``.
    """

    def __init__(self, node: str, service: str, cause: BaseException):
        super().__init__(node, (
            f'{node} raised {type(cause).__name__} while it served {service}: {cause}. In a node of its own '
            f'this would have ended executor.spin(), and the caller would have waited forever'))
        self.__cause__ = cause


class ParameterNotDeclaredError(NodeError, LookupError):
    """The node has no parameter of that name."""

    def __init__(self, node: str, name: str, existing: Sequence[str]):
        self.name = name
        super().__init__(
            node, f'{node} has no parameter {name!r}{nearest(name, existing, "It has no parameters at all")}')


class Rejection(Protocol):
    """What a node said no to; a ``client.SetResult`` is one."""

    @property
    def node(self) -> str:
        """The fully qualified name of the node."""

    @property
    def name(self) -> str:
        """The name of the parameter."""

    @property
    def value(self) -> Any:
        """What it was to be set to."""

    @property
    def kind(self) -> str:
        """Which of the node's checks said no."""

    @property
    def reason(self) -> str:
        """The node's own words."""


class ParameterRejectedError(NodeError):
    """The node rejected a value; ``.result`` holds the parameter, the value and the reason."""

    def __init__(self, result: Rejection):
        super().__init__(result.node, str(result))
        self.result = result


def describe_error(error: BaseException) -> str:
    """Return an error as a sentence for learners; one that is not ours keeps its class, since its text may be terse."""
    return str(error) if isinstance(error, ParameterToolError) else f'{type(error).__name__}: {error}'


def cause(error: BaseException) -> str:
    """Return what to think of if an exception does not name its cause, as a sentence without its period; or nothing."""
    line = ''
    owner = getattr(error, 'obj', None)
    if isinstance(error, AttributeError) and hasattr(owner, 'declare_parameter') and not hasattr(owner, 'handle'):
        return 'Before this line, `__init__` has to call `super().__init__(…)`'
    for frame, number in [*traceback.walk_tb(error.__traceback__)][-1:]:
        line = linecache.getline(frame.f_code.co_filename, number, frame.f_globals)
        name, owner = getattr(error, 'name', None), frame.f_locals.get('self')
        if isinstance(error, NameError) and hasattr(owner, str(name)):
            return f'`self.` is missing before `{name}`'
        code = getattr(getattr(type(owner), '__init__', None), '__code__', None)
        if isinstance(error, (NameError, AttributeError)) and code and name in code.co_varnames:
            return f'In `__init__`, `{name}` has no `self.` in front, so no other method sees it'
    return next((words for pattern, words in _CAUSES if re.search(pattern, f'{error} {line}')), '')


def nearest(name: str, existing: Sequence[str], none_at_all: str) -> str:
    """End the sentence "there is no NAME" with the likeliest names that do exist.

    :param name: The name that was asked for.
    :param existing: The names that there are.
    :param none_at_all: What to say when there are none, without a full stop.
    """
    existing = list(dict.fromkeys(existing))  # two nodes may have one name
    if not existing:
        return f'. {none_at_all}'
    # difflib compares whole strings; a learner who forgets the namespace or types a part is helped too.
    bare = name.strip('/')
    near = difflib.get_close_matches(name, existing, n=3, cutoff=0.6)
    near += [other for other in existing if bare and bare in other and other not in near]
    if near:
        return '. Did you mean ' + ' or '.join(near[:3]) + '?'
    shown = ', '.join(existing[:8])
    return f'. There is: {shown}' + (f' and {len(existing) - 8} more' if len(existing) > 8 else '')
