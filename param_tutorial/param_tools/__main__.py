"""``python -m param_tools param list`` and so on: the embedded ``ros2`` as a process of its own."""

import errno
import io
import os
import signal
import sys
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from param_tools.ros.executor import BackgroundExecutor


def main() -> int:
    """Run the command that the process's arguments say, in the domain that its environment says."""
    # Where the shell has closed one (`>&-`), nothing is printed; a socket must not take its number.
    sys.stdout, sys.stderr = (each or os.fdopen(os.open(os.devnull, os.O_WRONLY), 'w')
                              for each in (sys.stdout, sys.stderr))
    if isinstance(sys.stdout, io.TextIOWrapper):
        # Of a terminal that knows no more than ASCII; names and descriptions may hold any letter.
        sys.stdout.reconfigure(errors='backslashreplace')
    # A terminal of its own joins the domain where everybody is, like the genuine command; a notebook's kernel,
    # which chooses a domain for itself, passes it on to the processes that it starts.
    if not os.environ.get('ROS_DOMAIN_ID'):
        os.environ['ROS_DOMAIN_ID'] = '0'
    try:
        from param_tools.cli import command
        from param_tools.cli.session import Session

        status = command.main(sys.argv[1:], Session(sys.stdout, sys.stderr, _start, in_notebook=False))
        sys.stdout.flush()  # at the interpreter's end a broken pipe could only be complained of
        return status
    except KeyboardInterrupt:
        return signal.SIGINT
    except BrokenPipeError:  # e.g. `| head -1`
        _print_no_more()
        return 1
    except OSError as error:
        if error.errno not in (errno.ENOSPC, errno.EDQUOT):
            raise
        _print_no_more()
        print(f'cannot write the output: {error.strerror}', file=sys.stderr)
        return 2
    finally:
        # All that is left is to tidy up, where a second Ctrl+C would only cause a traceback.
        signal.signal(signal.SIGINT, signal.SIG_IGN)


def _print_no_more() -> None:
    """Send the rest of the output nowhere."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _start() -> 'BackgroundExecutor':
    from param_tools.ros import stage

    return stage.start()


if __name__ == '__main__':
    sys.exit(main())
