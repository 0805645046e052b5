"""Contexts: from ``rclpy.init`` to ``rclpy.shutdown``, and what Ctrl+C does to them.

Python handles signals in its main thread, between two steps of a program; so does this.
"""

import os
import signal
import threading
import weakref
from collections.abc import Sequence
from types import FrameType
from typing import Any

from param_tools.files.node_names import flaw_of_namespace
from param_tools.rcl_in_python import logs
from param_tools.rcl_in_python.arguments import Arguments, InvalidArgumentsError, parse
from param_tools.rcl_in_python.enums import SignalHandlerOptions
from param_tools.rcl_in_python.exceptions import RCLError
from param_tools.rcl_in_python.graph import Domain, domains
from param_tools.rcl_in_python.waiting import Destroyable, GuardCondition, changed

DEFAULT_DOMAIN_ID = 2**64 - 1
_MAX_DOMAIN_ID = 232


class Context(Destroyable):
    """What was given to ``rclpy.init``, until ``rclpy.shutdown``."""

    def __init__(self, args: Sequence[str], domain_id: int):
        super().__init__()
        self._is_ok = False
        self.arguments = _parsed(args)
        self._domain_id = _domain_id() if domain_id == DEFAULT_DOMAIN_ID else domain_id
        if self._domain_id > _MAX_DOMAIN_ID:
            raise RCLError(f'failed to initialize rcl: Domain id {self._domain_id} exceeds {_MAX_DOMAIN_ID}')
        is_alone = os.environ.get('ROS_AUTOMATIC_DISCOVERY_RANGE', '').upper() == 'OFF'
        self.domain = Domain() if is_alone else domains.setdefault(self._domain_id, Domain())
        self.arguments.check()
        self._is_ok = True
        known.add(self)

    def ok(self) -> bool:
        return self._is_ok

    def get_domain_id(self) -> int:
        if not self._is_ok:
            raise RCLError('Failed to get domain id: error not set')
        return self._domain_id

    def shutdown(self) -> None:
        with changed:
            if not self._is_ok:
                raise RCLError('failed to shutdown: rcl_shutdown already called on the given context')
            self._is_ok = False
            changed.notify_all()

    def _destroy(self) -> None:
        self._is_ok = False


known: 'weakref.WeakSet[Context]' = weakref.WeakSet()


def _parsed(args: Sequence[str]) -> Arguments:
    """Return what a program's arguments say.

    :raises RCLError: rcl would reject them.
    """
    try:
        arguments = parse(args)
    except InvalidArgumentsError as error:
        logs.error('rcl', 'Failed to parse global arguments')
        raise RCLError(f'failed to initialize rcl: {error}') from None
    if flaw := flaw_of_namespace(arguments.enclave):
        raise RCLError(f"failed to initialize rcl: Enclave name is not valid: "
                       f"'{flaw[0].replace('namespace', 'context name', 1)}'. Invalid index: {flaw[1]}")
    return arguments


def _domain_id() -> int:
    """Return the domain that the environment names."""
    text = os.environ.get('ROS_DOMAIN_ID', '')
    if text and not (text.isascii() and text.isdigit()):
        raise RCLError('failed to initialize rcl: ROS_DOMAIN_ID is not an integral number')
    return int(text or 0)


def rclpy_logging_configure(context: Context) -> None:
    arguments = context.arguments
    if arguments.log_config_file:
        raise RCLError("failed to initialize logging: spdlog logging backend doesn't currently support external "
                       'configuration')
    logs.configure(arguments.levels, has_terminal=arguments.has_stdout, has_rosout=arguments.has_rosout)


# -- signals --------------------------------------------------------------------------------------------------

_SIGNALS = {signal.SIGINT: SignalHandlerOptions.SIGINT, signal.SIGTERM: SignalHandlerOptions.SIGTERM}
guards: list[GuardCondition] = []
# The handlers that there were before ours.
replaced: dict[int, Any] = {}


def _handle(number: int, frame: FrameType | None) -> None:
    """Shut down all contexts, wake all executors, and do what would have been done without this."""
    with changed:
        for context in list(known):
            if context.ok():
                context.shutdown()
        for guard in guards:
            guard.trigger_guard_condition()
    if callable(before := replaced.get(number)):
        before(number, frame)


def install_signal_handlers(options: SignalHandlerOptions) -> None:
    if threading.current_thread() is not threading.main_thread():
        return  # Python lets only the main thread do this
    for number, option in _SIGNALS.items():
        if options & option and number not in replaced:
            replaced[number] = signal.signal(number, _handle)


def uninstall_signal_handlers() -> None:
    if threading.current_thread() is not threading.main_thread():
        return
    while replaced:
        number, before = replaced.popitem()
        # Somebody may have set a handler since, and None stands for one that Python cannot give back.
        if signal.getsignal(number) is _handle:
            signal.signal(number, signal.SIG_DFL if before is None else before)


def get_current_signal_handlers_options() -> SignalHandlerOptions:
    return SignalHandlerOptions(sum(_SIGNALS[signal.Signals(number)] for number in replaced))


def register_sigint_guard_condition(guard: GuardCondition) -> None:
    if guard in guards:
        raise ValueError('Guard condition was already registered')
    guards.append(guard)


def unregister_sigint_guard_condition(guard: GuardCondition) -> None:
    if guard.is_gone:  # with the program that it belonged to
        return
    if guard not in guards:
        raise ValueError('Guard condition was not registered')
    guards.remove(guard)
