"""Run a node of the course as a process of its own: ``python -m param_tutorial.nodes simple_param_node``.

The programs that colcon installs run the nodes this way, too. Ctrl+C and SIGTERM end the process with status 0: rclpy
shuts the context down once ``rclpy.init()`` has installed its handlers, which ends ``spin()`` in the node's ``main()``,
and fails the calls of a constructor that is still at work. Before that, there is nothing to tidy up.
"""

import importlib
import os
import signal
import sys
import threading
import time
from pathlib import Path
from typing import Any

# launch waits 5 s before it resorts to the next signal.
PATIENCE_SEC = 4.0


def main() -> int:
    """Run the node that the process's first argument names."""
    return _run(sys.argv.pop(1))


def program() -> int:
    """Run the node after which the program is called."""
    return _run(Path(sys.argv[0]).name)


def _run(name: str) -> int:
    came: list[int] = []

    def end(number: int, _frame: object) -> None:
        came.append(number)
        if not _is_rclpy_listening():
            os._exit(0)
        # On a busy machine, rclpy's shutdown did not return in 1 of 200 ends.
        watchdog = threading.Timer(PATIENCE_SEC, os._exit, [0])
        watchdog.daemon = True
        watchdog.start()

    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, end)
    # Executor.__del__ of rclpy 7.1 fails if its constructor found the context shut down.
    sys.unraisablehook = lambda unraisable: None if came else sys.__unraisablehook__(unraisable)
    try:
        importlib.import_module(f'{__package__}.{name}').main()
    except Exception:
        time.sleep(0.1)  # rclpy may have heard of a signal before Python has run the handler above
        if not came:
            raise
    return 0


def _is_rclpy_listening() -> bool:
    signals: Any = sys.modules.get('rclpy.signals')
    get_options = getattr(signals, 'get_current_signal_handlers_options', None)
    return get_options is not None and get_options() != signals.SignalHandlerOptions.NO


if __name__ == '__main__':
    sys.exit(main())
