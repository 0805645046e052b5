"""What is known while a launch file is carried out, and the error that ends the launch."""

import tempfile
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from param_tools.cli.session import CommandFailed

FULL_INSTALLATION = 'A full installation knows more: environment/README.md says how to get one'


class LaunchFailed(CommandFailed):
    """A launch file asks for something that cannot be done."""


@dataclass
class Context:
    """What actions and substitutions know, and what the actions before them have set."""

    arguments: dict[str, str]
    """The launch configurations: the arguments that were given, and the defaults of the others."""
    folder: Path
    """Where parameter files are written."""
    warn: Callable[[str], object]
    """Prints a warning."""
    parameters: list[tuple[str, Any]] = field(default_factory=list)
    """Names and values that ``SetParameter`` gives to every later node."""
    log_error: Callable[[str], object] = lambda _: None
    """Prints an error of the declaration of an argument, which ends the launch."""

    def write(self, text: str) -> Path:
        """Write a parameter file, and return its path."""
        with tempfile.NamedTemporaryFile('w', prefix='launch_params_', dir=self.folder, delete=False,
                                         encoding='utf-8') as file:
            file.write(text)
        return Path(file.name)
