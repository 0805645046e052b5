"""What the form of a panel shows before a parameter file is written or loaded, and what it says afterwards."""

import itertools
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from param_tools.errors import ParameterFileError, ParameterToolError, describe_error
from param_tools.files import parameter_files
from param_tools.files.parsing import matches
from param_tools.markup.wording import format_count
from param_tools.panel.drawing import file_markup
from param_tools.systems.file_preview import CHANGES, OTHER_NODE, SAME

# A ParameterPanel, whose file imports this one.
FilePanel = Any

# Where parameter files usually are: in the notebook's folder, in that of its package, in its workspace.
_PLACES = ('config', '.', '../config')
_MOST_OFFERED = 100


def offered_files() -> list[str]:
    """Return the parameter files that are nearby, relative to the current folder, those in config/ first."""
    found = (str(path) for place in _PLACES for path in sorted(Path(place).glob('*.yaml')) if _is_parameter_file(path))
    return list(itertools.islice(found, _MOST_OFFERED))


def suggested_file(node: str) -> str:
    """Return the name of the file that a node's parameters may be saved to: its own, as ``ros2 param dump`` had it."""
    return f'{node.strip("/").replace("/", "__")}.yaml'


def _is_parameter_file(path: Path) -> bool:
    try:
        return b'ros__parameters' in path.read_bytes()
    except OSError:
        return False


def look(panel: FilePanel, *, is_save: bool, path: str, changed_only: bool) -> dict[str, Any]:
    """Return what the form shows for a path: markup, the word on its button, and whether that can be pressed."""
    word = 'Save' if is_save else 'Load'
    if not path:
        return {'markup': '', 'button': word, 'can': False}
    try:
        return _look_before_saving(panel, path, changed_only) if is_save else _look_before_loading(panel, path)
    except (ParameterToolError, OSError, ValueError) as error:
        return {'markup': file_markup(sentence(error), is_bad=True), 'button': word, 'can': False}


def act(panel: FilePanel, *, is_save: bool, path: str, changed_only: bool) -> str:
    """Save or load, and return what the form says then, as HTML."""
    try:
        if is_save:
            target = _with_ending(path)
            left = panel.save(target, changed_only).left_out
            return file_markup(f'Saved to {target}.', reasons('Left out', left))
        loaded = panel.load(path)
        return file_markup(f'{format_count(len(loaded.names), "value")} of {path} '
                           f'{"gathered" if loaded.is_gathered else "loaded"}.', reasons('Not loaded', loaded))
    except (ParameterToolError, OSError, ValueError) as error:
        return file_markup(sentence(error), is_bad=True)


def _look_before_saving(panel: FilePanel, path: str, changed_only: bool) -> dict[str, Any]:
    dump = panel.dump(changed_only=changed_only)
    count = len(panel.changed if changed_only else panel.names) - len(dump.left_out)
    target = parameter_files.as_path(_with_ending(path), is_typed=True)
    notes, word = reasons('Left out', dump.left_out), 'Save'
    if target.is_dir():
        raise ParameterFileError(f'{path} is a folder; add the name of a file')
    if not target.parent.is_dir():
        raise ParameterFileError(f'there is no folder {target.parent}')
    if target.exists():
        word = 'Replace'
        notes.insert(0, f'{target} is there already, and will be replaced{_what_it_holds(target, panel.node)}.')
    told = f'{format_count(count, "value")} of {panel.node} will be written to {target.resolve()}.'
    return {'markup': file_markup(told, notes), 'button': word, 'can': True}


def _with_ending(path: str) -> str:
    """Return a path as it is saved: with an ending, or it would not be offered when a file is loaded."""
    return path if Path(path).suffix or Path(path).is_dir() else f'{path}.yaml'


def _what_it_holds(path: Path, node: str) -> str:
    try:
        others = [name for name in parameter_files.parse(path).blocks if not matches(name, node)]
    except ParameterFileError:
        return '. It is not a parameter file'
    return f'. Its parameters for {", ".join(others)} would be lost' if others else ''


def _look_before_loading(panel: FilePanel, path: str) -> dict[str, Any]:
    preview = panel.preview(path)
    others: dict[str, int] = {}
    for row in preview:
        if row.verdict == OTHER_NODE:
            others[row.block] = others.get(row.block, 0) + 1
    notes = [f'{format_count(count, "value")} for {block}: not for this node.' for block, count in others.items()]
    rows = [words for row, words in zip(preview, preview.rows()) if row.verdict not in (SAME, OTHER_NODE)]
    # What will change stands first.
    rows.sort(key=lambda words: words[3] != CHANGES)
    return {'markup': file_markup(preview.summary.capitalize() + '.', [*preview.notes, *notes], preview.columns, rows),
            'button': 'Load', 'can': bool(preview.accepted)}


def reasons(word: str, left: Mapping[str, str]) -> list[str]:
    """Return why parameters are left out, as sentences."""
    return [f'{word}: {name}, {reason}.' for name, reason in left.items()]


def sentence(error: Exception) -> str:
    """Return what is wrong, for a person who works with files."""
    if isinstance(error, OSError) and error.strerror:
        return f'{error.filename}: {error.strerror}'
    return describe_error(error)
