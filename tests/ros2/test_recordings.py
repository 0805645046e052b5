"""The README's pictures of terminals show what the commands print today."""

import pytest

from param_tutorial.runtime import domain
from tests.tools import recordings


@pytest.mark.slow
@pytest.mark.thorough
def test_the_terminals_in_the_readme_show_what_the_commands_print(tmp_path):
    domain.choose()
    environment = recordings.shell_environment()
    with recordings.robot(environment):
        pictures = recordings.terminals(tmp_path, environment)
    stored = {name: (recordings.FOLDER / name).read_text() for name in pictures}
    assert pictures == stored, 'python -m tests.tools.recordings makes them again'
