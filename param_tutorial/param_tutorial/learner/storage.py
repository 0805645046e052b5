"""Files that are written whole or not at all, and folders in which one process at a time works."""

import contextlib
import datetime
import os
from collections.abc import Iterator
from pathlib import Path


def write_whole(path: Path, content: bytes) -> None:
    """Write a file whole or not at all, and its folders where they are missing.

    :raises OSError: it can't be written; what was there is there still.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    new = path.with_name(f'.{path.name}.new')
    try:
        with new.open('wb') as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        new.replace(path)
    finally:
        new.unlink(missing_ok=True)


def time_stamp() -> str:
    """Return the date and time, for the name of something that nothing else is called yet."""
    return f'{datetime.datetime.now():%Y-%m-%d_%H-%M-%S-%f}'


@contextlib.contextmanager
def only_one(folder: Path) -> Iterator[None]:
    """Let one thread of one process at a time work in a folder; the others wait.

    :raises OSError: there is no such folder.
    """
    try:
        from fcntl import LOCK_EX, flock
    except ImportError:  # neither Windows nor a web page has it
        yield
        return
    number = os.open(folder, os.O_RDONLY)
    try:
        flock(number, LOCK_EX)
        yield
    finally:
        os.close(number)
