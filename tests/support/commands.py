"""Commands of the embedded ros2 in this process, and packages that they find."""

import io

from param_tools.cli import command
from param_tools.cli.session import Session
from param_tools.ros import stage


def run(*words, in_notebook=True, get_executor=stage.current):
    """Run a command in this process: standard output, standard error, exit status."""
    stdout, stderr = io.StringIO(), io.StringIO()
    status = command.main([str(word) for word in words], Session(stdout, stderr, get_executor, in_notebook))
    return stdout.getvalue(), stderr.getvalue(), status


def source_package(name, folder, monkeypatch):
    """Make a folder an install space that holds a package, and source it."""
    marker = folder / 'share/ament_index/resource_index/packages' / name
    marker.parent.mkdir(parents=True, exist_ok=True)
    marker.touch()
    monkeypatch.setenv('AMENT_PREFIX_PATH', str(folder))
