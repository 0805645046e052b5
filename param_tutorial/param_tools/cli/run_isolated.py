"""Start a program in a ROS domain of its own, ask its nodes what they declare, and stop it.

Nothing that runs on this machine hears of it. A process is in one domain, so a process of its own does this, and saves
the descriptions to a file.
"""

import os
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path

from param_tools.cli.genuine import embedded_words
from param_tools.cli.run import find_program
from param_tools.cli.session import CommandFailed
from param_tools.errors import ParameterToolError
from param_tools.files import descriptions
from param_tools.files.descriptions import AS_DECLARED, Descriptions
from param_tools.ros import domain, host, stage
from param_tools.systems.describe import describe

START_TIMEOUT_SEC = 40.0
# A program doesn't say when its last node is there. Two looks of the same, so far apart, must do.
_LOOK_PERIOD_SEC = 0.5
_STOP_TIMEOUT_SEC = 10.0
_PROGRAM = ('import sys; sys.path.insert(0, sys.argv.pop(1)); from param_tools.cli.run_isolated import main; '
            'sys.exit(main(sys.argv[1], sys.argv[2:]))')


def describe_program(package: str, executable: str) -> Descriptions:
    """Return what the nodes of a program declare when it is started without any parameters."""
    program = find_program(package, executable)
    if not host.host.has_processes:
        raise CommandFailed(f'{package}/{executable} would be started in a process of its own, and there is none in a '
                            f'web page: run it, and name its node instead')
    root = embedded_words()[-1]
    with tempfile.TemporaryDirectory(prefix='param_tools_') as folder, tempfile.TemporaryFile('w+') as complaint:
        path = Path(folder, 'descriptions.yaml')
        child = subprocess.Popen([sys.executable, '-c', _PROGRAM, root, str(path), *program],
                                 env=domain.environment_without_domain(), stdin=subprocess.DEVNULL,
                                 stdout=subprocess.DEVNULL, stderr=complaint)
        try:
            child.wait(2 * START_TIMEOUT_SEC)
        except BaseException as error:  # also Ctrl+C: the child stops the program when it is asked to end
            child.send_signal(signal.SIGINT)
            child.wait()
            if isinstance(error, subprocess.TimeoutExpired):
                raise CommandFailed(f'{package}/{executable} could not be described in time') from None
            raise
        if child.returncode:
            complaint.seek(0)
            said = complaint.read().strip().splitlines()
            raise CommandFailed(f'{package}/{executable} could not be described: {said[-1] if said else "no reason"}')
        return descriptions.read(path)


def main(path: str, program: Sequence[str]) -> int:
    """Describe a program in the domain that this process chooses for itself; save that; return the exit status."""
    try:
        _describe(program).dump().save(path)
    except (ParameterToolError, CommandFailed) as error:
        print(error, file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return signal.SIGINT
    return 0


def _describe(program: Sequence[str]) -> Descriptions:
    ros = stage.start()  # which puts the domain into the environment
    with tempfile.TemporaryFile('w+') as output:
        try:
            process = subprocess.Popen(program, stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT,
                                       start_new_session=True)
        except OSError as error:
            raise CommandFailed(f'it cannot be started: {error.strerror}') from None
        try:
            deadline = time.monotonic() + START_TIMEOUT_SEC
            before: Descriptions | None = None
            while True:
                found = describe(defaults_from=AS_DECLARED, executor=ros)
                if found and not found.unanswered and found == before:
                    return Descriptions(found.values())
                before = found
                if _ends_within(_LOOK_PERIOD_SEC, process):
                    output.seek(0)
                    said = output.read().strip().splitlines()
                    raise CommandFailed(f'it ended with exit status {process.returncode}'
                                        + (f': {said[-1]}' if said else ''))
                if time.monotonic() > deadline:
                    raise CommandFailed(f'no node of it answered within {START_TIMEOUT_SEC:g} s')
        finally:
            _stop(process)


def _ends_within(seconds: float, process: 'subprocess.Popen[bytes]') -> bool:
    try:
        process.wait(seconds)
    except subprocess.TimeoutExpired:
        return False
    return True


def _stop(process: 'subprocess.Popen[bytes]') -> None:
    """Stop a program and all that it has started."""
    for how in (signal.SIGINT, signal.SIGTERM, signal.SIGKILL):
        try:
            os.killpg(process.pid, how)
        except ProcessLookupError:
            return
        if _ends_within(_STOP_TIMEOUT_SEC, process):
            return
