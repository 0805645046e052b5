"""Presets: snapshots in one folder, by their names. Each is a file that ``restore`` and ``diff`` take, too."""

import datetime
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from param_tools.errors import ParameterFileError
from param_tools.systems.snapshot import Snapshot, read_heading, read_saved

_ENDING = '.yaml'


@dataclass(frozen=True)
class Preset:
    """One preset, without its values."""

    name: str
    taken: datetime.datetime
    holds: str
    """How many nodes it holds, in words."""


class Presets:
    """The snapshots in a folder. Other files in it are left alone."""

    def __init__(self, folder: Path):
        self.folder = folder

    def all(self) -> list[Preset]:
        """Return the presets that are there, the newest first."""
        found = [Preset(path.stem, heading[1].astimezone(), heading[0]) for path in self.folder.glob(f'*{_ENDING}')
                 if (heading := read_heading(path))]
        return sorted(found, key=lambda each: each.taken, reverse=True)

    def read(self, name: str, nodes: Iterable[str] = ()) -> dict[str, dict[str, Any]]:
        """Return the values in a preset, by node.

        :param nodes: As for ``parameter_files.read_all``.
        :raises ParameterFileError: it cannot be read.
        """
        return read_saved(self._existing(name), nodes)

    def save(self, name: str, snapshot: Snapshot) -> dict[str, str]:
        """Write a preset, and return what no file can hold, and why; one of the same name is replaced.

        :raises ParameterFileError: it cannot have this name, or there are no values.
        :raises OSError: it cannot be written.
        """
        path = self._path(name)
        if not snapshot:
            raise ParameterFileError('; '.join(map(str, snapshot.unanswered.values())) or 'there are no nodes to save')
        if path.exists() and not read_heading(path):
            raise ParameterFileError(f'{path.name} is there already, and is no snapshot: it was not replaced')
        self.folder.mkdir(parents=True, exist_ok=True)
        dump = snapshot.dump()
        dump.save(path)
        return dump.left_out

    def rename(self, name: str, to: str) -> None:
        """Give a preset another name.

        :raises ParameterFileError: there is no such preset, or the other name can't be used.
        :raises OSError: the file cannot be renamed.
        """
        path = self._path(to)
        if path.exists():
            raise ParameterFileError(f'{path.name} is there already: choose another name')
        self._existing(name).rename(path)

    def delete(self, name: str) -> None:
        """Remove a preset.

        :raises ParameterFileError: there is no such preset.
        :raises OSError: the file cannot be removed.
        """
        self._existing(name).unlink()

    def _path(self, name: str) -> Path:
        stem = name.strip().removesuffix(_ENDING)
        if not stem or stem.startswith('.') or any(letter in '/\\\0' or not letter.isprintable() for letter in stem):
            raise ParameterFileError(f'{name!r} is no name for a preset: it is the name of a file, so use letters, '
                                     f'digits, blanks, - and _')
        return self.folder / f'{stem}{_ENDING}'

    def _existing(self, name: str) -> Path:
        path = self._path(name)
        if not read_heading(path):
            raise ParameterFileError(f'there is no preset {name} in {self.folder.resolve()} any more')
        return path
