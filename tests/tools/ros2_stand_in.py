"""The ``ros2`` of ``beside_ros``: the embedded command, which says what the genuine one says where the two differ.

A chapter that needs words of the embedded command fails beside it, as it would on an engineer's machine:

- A command whose recording (tests/cli/transcripts) has other words gets the recorded answer.
- ``pkg create`` leaves the setup.py that ros2pkg 0.32.2 makes of its template (resource/ament_python/setup.py.em).
- ``launch`` begins with the line about its log files and, where its input is no terminal, passes Ctrl+C on twice, as
  launch 3.4.3 does (``--noninteractive``).

It takes the words of the embedded command up to ``--``, and after it what follows ``ros2``.
"""

import json
import os
import re
import shlex
import signal
import subprocess
import sys
from pathlib import Path

import psutil

RECORDED = Path(__file__).parents[1] / 'cli' / 'transcripts' / 'transcripts.json'
SETUP = """from setuptools import find_packages, setup

package_name = '{package}'

setup(
    name=package_name,
    version='0.0.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages',
            ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='{maintainer}',
    maintainer_email='{email}',
    description='{description}',
    license='{license}',
    tests_require=['pytest'],
    entry_points={{
        'console_scripts': [
{scripts}        ],
    }},
)
"""


def recorded(words: list[str]) -> 'dict[str, object] | None':
    """Return the recorded answer to a command that the embedded one answers in other words."""
    steps = (step for each in json.loads(RECORDED.read_text())['scenarios'] for step in each['steps'])
    return next((step for step in steps if step['match'] == 'meaning' and not step['stderr'].startswith('(')
                 and step['command'] == shlex.join(['ros2', *words])), None)


def rewrite_setup(folder: Path) -> None:
    """Write the setup.py of a new package as the genuine command does."""
    for path in folder.glob('*/setup.py'):
        text = path.read_text()
        named = {name: re.search(rf"\n {{4}}{name}='(.*)',", text) for name in (
            'maintainer', 'maintainer_email', 'description', 'license')}
        package = re.search("package_name = '(.*)'", text)
        if package and all(named.values()):
            maintainer, email, description, licensed = (each[1] for each in named.values())
            path.write_text(SETUP.format(
                package=package[1], maintainer=maintainer, email=email, description=description, license=licensed,
                scripts=''.join(re.findall(r" {12}'\w+ = .*\n", text))))


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
    if words[:2] == ['pkg', 'create'] and '--help' not in words:
        status = subprocess.run([*embedded, *words], check=False).returncode
        rewrite_setup(Path())
        return status
    os.execv(embedded[0], [*embedded, *words])


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
