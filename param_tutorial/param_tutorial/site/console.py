"""What a build prints."""

from pathlib import Path


def say(text: str) -> None:
    """Print progress at once."""
    print(text, flush=True)


def format_path(path: Path) -> str:
    """Return a path as short as it can be: from the current folder if it is below that."""
    return str(path.relative_to(Path.cwd()) if path.is_relative_to(Path.cwd()) else path)
