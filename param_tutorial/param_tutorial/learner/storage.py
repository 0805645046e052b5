"""Files that are written whole or not at all, and folders in which one process at a time works."""

import contextlib
import datetime
import itertools
import os
from collections.abc import Callable, Iterator
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


def named_after_now(path_for: Callable[[str], Path]) -> Path:
    """Return a path that is not there yet, named after the date and time.

    :param path_for: Returns the path with a date and time in it.
    """
    now = f'{datetime.datetime.now():%Y-%m-%d_%H-%M-%S}'
    times = itertools.chain([now], (f'{now}_{number}' for number in itertools.count(2)))
    return next(path for path in map(path_for, times) if not path.exists())


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
