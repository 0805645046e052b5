"""The course that a site is made of: the state it is in, and all of it as an archive that readers download."""

import io
import os
import platform
import subprocess
import zipfile
from importlib.metadata import version
from pathlib import Path

PACKAGE_ROOT = Path(__file__).parents[2]
ROOT = PACKAGE_ROOT.parent


def provenance() -> dict[str, str]:
    """Return from which state of the course, and on what, the lessons ran: the same for each build of a commit."""
    facts = {'Python': platform.python_version(), 'rclpy': version('ros-jazzy-rclpy')}
    if commit := _git('log', '-1', '--format=%h %cs'):
        name, date = commit.split()
        changed = _git('status', '--porcelain', '--', 'notebooks', 'param_tutorial', 'config')
        facts |= {'date': date, 'commit': name, 'changed': 'with changes since' if changed else ''}
    return facts


def course_archive(folder: str) -> bytes:
    """Return the course as a zip file, the same for each build of a commit.

    :param folder: In which all files are.
    """
    names = [name for name in _git('ls-files', '-z').split('\0') if name and (ROOT / name).is_file()]
    if not names:  # no clone: what a clone has, as far as one can tell
        names = [str(path.relative_to(ROOT)) for path in ROOT.rglob('*') if path.is_file() and not any(
            part.startswith(('.', '__')) or part.endswith('.egg-info')
            or part in ('build', 'my_lessons', 'node_modules')
            for part in path.relative_to(ROOT).parts)]
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, 'w', zipfile.ZIP_DEFLATED) as archive:
        for name in sorted(names):
            path = ROOT / name
            entry = zipfile.ZipInfo(f'{folder}/{name}', (1980, 1, 1, 0, 0, 0))
            entry.external_attr = (0o755 if os.access(path, os.X_OK) else 0o644) << 16
            archive.writestr(entry, path.read_bytes(), zipfile.ZIP_DEFLATED, 9)
    return buffer.getvalue()


def _git(*arguments: str) -> str:
    """Return what git prints about the course; nothing if it is not a clone, or there is no git."""
    try:
        return subprocess.run(['git', *arguments], cwd=ROOT, capture_output=True, text=True, check=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return ''
