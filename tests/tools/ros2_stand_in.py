"""The ``ros2`` of ``beside_ros``: the embedded command, which says what the genuine one says where the two differ.

A chapter that needs words of the embedded command fails beside it, as it would on an engineer's machine:

- A command whose recording (tests/cli/transcripts) has other words gets the recorded answer.
- ``launch`` begins with the line about its log files and, where its input is no terminal, passes Ctrl+C on twice, as
  launch 3.4.3 does (``--noninteractive``).

It takes the words of the embedded command up to ``--``, and after it what follows ``ros2``.
"""

import json
import os
import shlex
import signal
import subprocess
import sys
from pathlib import Path

import psutil

RECORDED = Path(__file__).parents[1] / 'cli' / 'transcripts' / 'transcripts.json'


def recorded(words: list[str]) -> 'dict[str, object] | None':
    """Return the recorded answer to a command that the embedded one answers in other words."""
    steps = (step for each in json.loads(RECORDED.read_text())['scenarios'] for step in each['steps'])
    return next((step for step in steps if step['match'] == 'meaning' and not step['stderr'].startswith('(')
                 and step['command'] == shlex.join(['ros2', *words])), None)


def launch(command: list[str]) -> int:
    """Run the embedded launch as the genuine one would show it."""
    child = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)

    def pass_on(number: int, _frame: object) -> None:
        if number == signal.SIGTERM:
            child.send_signal(number)
        elif not sys.stdin.isatty():  # the nodes have had Ctrl+C once, from the launch
            for node in psutil.Process(child.pid).children():
                node.send_signal(number)

    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, pass_on)
    for line in child.stdout or ():
        if line.startswith('[INFO] [launch]: Default logging'):
            print('[INFO] [launch]: All log files can be found below /tmp/ros/log')
        print(line, end='', flush=True)
    return child.wait()


def main(arguments: list[str]) -> int:
    """Answer a command, and return its exit status."""
    end = arguments.index('--')
    embedded, words = arguments[:end], arguments[end + 1:]
    if answer := recorded(words):
        sys.stdout.write(str(answer['stdout']))
        sys.stderr.write(str(answer['stderr']) + '\n')
        return int(str(answer['returncode']))
    os.environ['PARAM_TOOLS_PROVIDED'] = '0'
    if words[:1] == ['launch'] and not {'-s', '--show-args', '--show-arguments'} & set(words):
        return launch([*embedded, *words])
    os.execv(embedded[0], [*embedded, *words])


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
