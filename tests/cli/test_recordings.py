"""The README's pictures of terminals show what the commands print today."""

import subprocess
import sys

import pytest

from param_tools.ros import domain
from tests.tools import recordings


@pytest.mark.slow
@pytest.mark.thorough
def test_the_terminals_in_the_readme_show_what_the_commands_print(tmp_path):
    # In a domain where no other test has left a node.
    subprocess.run([sys.executable, '-m', 'tests.tools.recordings', '--terminals', tmp_path], cwd=recordings.ROOT,
                   env=domain.environment_without_domain(), check=True)
    made = {path.name: path.read_text() for path in tmp_path.iterdir()}
    assert made.keys() == {f'{name}.svg' for name in recordings.TERMINALS}
    stored = {name: (recordings.FOLDER / name).read_text() for name in made}
    assert made == stored, 'python -m tests.tools.recordings makes them again'
