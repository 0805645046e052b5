"""A node as a process of its own, which ends well at any moment.

``python -m param_tutorial.nodes simple_param_node`` runs one, and so does each program that colcon has installed.

A node's own ``main()`` hears of SIGINT and SIGTERM through rclpy, once ``rclpy.init()`` has installed its handlers and
``spin()`` waits. Before that, Ctrl+C is a KeyboardInterrupt while Python still imports rclpy, and SIGTERM ends the
process with status -15; in the node's constructor, either shuts the context down under its feet, which is an RCLError.
That is so in every node of rclpy 7.1, and here it is none of the node's business.
"""

import importlib
import os
import signal
import sys
import threading
import time
from pathlib import Path
from types import FrameType
from typing import Any

SIGNALS = (signal.SIGINT, signal.SIGTERM)
# launch waits 5 s before it resorts to the next signal.
PATIENCE_SEC = 4.0


def main() -> int:
    """Run the node that the process's first argument names, until a signal ends it."""
    return _run(sys.argv.pop(1))


def program() -> int:
    """Run the node after which the program is called, until a signal ends it."""
    return _run(Path(sys.argv[0]).name)


def _run(name: str) -> int:
    told: list[int] = []

    def end(number: int, _frame: FrameType | None) -> None:
        told.append(number)
        if not _is_rclpy_listening():
            os._exit(0)  # nothing is there yet that would have to be tidied up
        # Once in hundreds of ends on a busy machine, rclpy's shutdown did not return.
        watchdog = threading.Timer(PATIENCE_SEC, os._exit, [0])
        watchdog.daemon = True
        watchdog.start()

    def is_told() -> bool:
        return bool(told)  # a call, because Python runs the handler of a signal that has come when a function begins

    def complain(unraisable: Any) -> None:
        # Executor.__del__ of rclpy 7.1 fails if there was no context any more for its constructor.
        if not is_told():
            sys.__unraisablehook__(unraisable)

    sys.unraisablehook = complain
    for number in SIGNALS:
        signal.signal(number, end)
    # The program that starts this process may have held them back until now: see ros2.run.
    signal.pthread_sigmask(signal.SIG_UNBLOCK, SIGNALS)
    try:
        importlib.import_module(f'{__package__}.{name}').main()
    except Exception:
        # rclpy's handler shuts the context down before Python hears of the signal: on a busy machine, long before.
        deadline = time.monotonic() + PATIENCE_SEC
        while not is_told() and _has_rclpy_been_shut_down() and time.monotonic() < deadline:
            time.sleep(0.01)
        if not is_told():
            raise
    finally:
        # A second one, while all that is left is to end. Held back in this thread, it would come to one of the
        # middleware's, and Python, which ends, no longer has a handler for it.
        for number in SIGNALS:
            signal.signal(number, signal.SIG_IGN)
    return 0


def _is_rclpy_listening() -> bool:
    """True if rclpy has been imported, and has installed the handlers that shut its context down."""
    signals: Any = sys.modules.get('rclpy.signals')
    get_options = getattr(signals, 'get_current_signal_handlers_options', None)
    return get_options is not None and get_options() != signals.SignalHandlerOptions.NO


def _has_rclpy_been_shut_down() -> bool:
    """True if the context has been shut down, but not by ``rclpy.shutdown()``, which takes the handlers away too."""
    return _is_rclpy_listening() and not sys.modules['rclpy'].ok()


if __name__ == '__main__':
    sys.exit(main())
