"""The ROS domain of the newest kernel, for the course's own ``ros2`` in a terminal of JupyterLab.

Each kernel that ``make lab`` starts notes its domain in JupyterLab's folder of what runs, in a file that ends with the
kernel's process number.
"""

import atexit
import contextlib
import json
import os
import sys
from pathlib import Path

from param_tools.ros import domain

# Jupyter's own name for the folder.
_FOLDER = 'JUPYTER_RUNTIME_DIR'


def note_domain() -> None:
    """Choose a ROS domain for this kernel, and let terminals know it as long as the kernel lives."""
    domain.choose()
    if folder := os.environ.get(_FOLDER):
        note = Path(folder, f'ros-domain-{os.getpid()}')
        note.write_text(json.dumps(domain.settings()), encoding='utf-8')
        atexit.register(note.unlink, missing_ok=True)


def _newest_domain(folder: Path) -> dict[str, str] | None:
    """Return the settings of the kernel that was started last; None if no kernel runs."""
    notes = sorted(folder.glob('ros-domain-*'), key=lambda note: note.stat().st_mtime, reverse=True)
    for note in notes:
        with contextlib.suppress(OSError):
            os.kill(int(note.name.rpartition('-')[2]), 0)  # raises if there is no such process
            return dict(json.loads(note.read_text(encoding='utf-8')))
    return None


def join() -> None:
    """Let this process be in the domain of the newest kernel, and say so if it is new to this terminal.

    A cell's commands, and a terminal that has joined another domain, are in one already.
    """
    if os.environ.get('ROS_DOMAIN_ID') or _FOLDER not in os.environ:
        return
    folder = Path(os.environ[_FOLDER])
    settings = _newest_domain(folder)
    os.environ.update(settings or {})
    _say_once(folder / f'ros2-told-{os.getppid()}', (
        f"This is the course's own ros2, in the ROS domain of the notebook started last "
        f"({settings['ROS_DOMAIN_ID']}). A notebook's %ros2_terminal shows a line to join another one's."
    ) if settings else 'No notebook is running whose nodes this command could find.')


def _say_once(told: Path, words: str) -> None:
    with contextlib.suppress(OSError):
        if told.read_text(encoding='utf-8') == words:
            return
    print(words, file=sys.stderr, flush=True)
    with contextlib.suppress(OSError):
        told.write_text(words, encoding='utf-8')
