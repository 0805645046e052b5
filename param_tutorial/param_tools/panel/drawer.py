"""The drawer below the panels of a page: presets, and the history of the session with a way back to each moment.

It works on nodes, not on panels, and asks them as ``restore`` does on the command line. ``systems.presets`` keeps the
files, ``systems.change_log`` hears of the changes, and ``drawer.js`` shows both.
"""

import datetime
import functools
import threading
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import traitlets

from param_tools import values
from param_tools.errors import NodeError, ParameterToolError
from param_tools.markup.scripts import bundle
from param_tools.markup.styles import sheet
from param_tools.markup.wording import format_count
from param_tools.panel.drawing import file_markup
from param_tools.panel.file_form import reasons, sentence
from param_tools.panel.front import Front
from param_tools.panel.view import FollowingView
from param_tools.ros import host
from param_tools.ros.executor import BackgroundExecutor
from param_tools.ros.services import full_name
from param_tools.systems.change_log import ChangeLog, LoggedChange, follow_soon
from param_tools.systems.presets import Presets
from param_tools.systems.restoring import Preview, Restored, preview_all, restore_all
from param_tools.systems.snapshot import all_parameters

# The history shows so many lines, and keeps so many changes: what happened before these is folded into the values that
# the nodes had then.
_LINES = 100
_MOST_KEPT, _KEPT = 20_000, 10_000
# Changes of one parameter that follow each other so fast are one line: somebody pulls a slider.
_ONE_PULL = datetime.timedelta(seconds=1)
_LETTERS = 60


class _DrawerFront(Front):
    """The drawer in the browser."""

    _esm = bundle('param_tools/panel/drawer.js')
    _css = sheet('param_tools/panel/panel.css') + sheet('param_tools/panel/drawer.css')
    state = traitlets.Dict().tag(sync=True)


class ParameterDrawer(FollowingView):
    """Presets of nodes, and what has changed since the drawer was made. Show it as the last line of a cell.

    The page of the command ``panel`` has one.
    """

    def __init__(self, nodes: Iterable[str] = (), *, folder: str | Path = '.'):
        """
        :param nodes: Only these nodes; by default all.
        :param folder: Where the presets are. The folder is made when the first preset is saved.
        """
        self._nodes = tuple(map(full_name, nodes))
        self._presets = Presets(Path(folder))
        self._tab = ''
        self._listed: list[dict[str, str]] = []
        # Guards what the follower's thread writes.
        self._log_lock = threading.Lock()
        self._log: list[LoggedChange] = []
        self._front = _DrawerFront(state={})
        self._front.add_class('param-panel')
        self._front.on_msg(self._on_message)
        self._acting = threading.Lock()
        super().__init__([self._front], 'param-drawer')
        self._begin()

    def __repr__(self) -> str:
        return f'<ParameterDrawer: {self.node}{", closed" if self._closed else ""}>'

    @property
    def node(self) -> str:
        """The names of its nodes."""
        return ', '.join(self._nodes) or 'all nodes'

    # -- following --------------------------------------------------------------------------------------

    def _subscribe(self, executor: BackgroundExecutor) -> Callable[[], object]:
        return follow_soon(self._hear, executor, self._nodes)

    def _hear(self, changes: list[LoggedChange]) -> None:
        with self._log_lock:
            self._log += changes
            if len(self._log) > _MOST_KEPT:
                old, new = self._log[:-_KEPT], self._log[-_KEPT:]
                self._log = [LoggedChange(old[-1].time, 'seen', node, name, None, value)
                             for node, each in ChangeLog(old).at().items() for name, value in each.items()] + new
        self._job.wake()

    def _running(self) -> list[str]:
        names = self._executor.services.node_names() if self._executor else []
        return sorted({name for name in names if not self._nodes or name in self._nodes})

    # -- showing ----------------------------------------------------------------------------------------

    def _show(self) -> None:
        with self._log_lock:
            log = list(self._log)
        self._front.state = {
            'folder': str(self._presets.folder.resolve()), 'nodes': self._running(), 'presets': self._listed,
            'changes': _lines(log) if self._tab == 'history' else [], 'heard': len(log),
            'is_read_only': self._is_read_only()}

    def _is_read_only(self) -> bool:
        """True if nothing may be set or written from here."""
        return bool(self._executor and self._executor.services.is_read_only)

    def _list(self) -> None:
        self._listed = [{'name': each.name, 'taken': each.taken.isoformat(), 'holds': each.holds}
                        for each in self._presets.all()]
        self._job.wake()

    # -- the browser ------------------------------------------------------------------------------------

    def _on_message(self, _: Any, content: dict[str, Any], __: Any) -> None:
        """Do what a person did in the browser; called by ipywidgets."""
        if content['do'] == 'open':
            self._tab = content['tab']
        # It may wait for nodes, and the kernel must not.
        host.host.run(functools.partial(self._serve, content), f'{content["do"]} in the drawer')

    def _serve(self, content: dict[str, Any]) -> None:
        with self._acting:
            answer: dict[str, Any] = {}
            try:
                answer = self._do(content)
            except (ParameterToolError, OSError, ValueError) as error:
                answer = {'said': file_markup(sentence(error), is_bad=True)}
            self._list()
        with self._drawing:
            if not self._closed:
                self._front.send({'client': content['client'], 'number': content['number'], **answer})

    def _do(self, content: dict[str, Any]) -> dict[str, Any]:
        do, name = content['do'], content.get('name', '')
        if do == 'look':
            wanted, label, notes = self._wanted(content)
            preview = preview_all(wanted, label, executor=self._executor)
            return {'markup': _told(preview, notes), 'can': bool(preview.count('would be set'))}
        if do == 'open' or self._is_read_only():
            return {}
        if do == 'apply':
            wanted, label, _ = self._wanted(content)
            return {'said': _done(restore_all(wanted, label, one_by_one=True, skip_read_only=True,
                                              executor=self._executor))}
        if do == 'save':
            snapshot = all_parameters([content['node']] if content['node'] else self._running(),
                                      executor=self._executor)
            left = self._presets.save(name, snapshot)
            count = format_count(sum(map(len, snapshot.values())) - len(left), 'value')
            notes = [*_silent(snapshot.unanswered), *reasons('Left out', left)]
            return {'said': file_markup(f'Saved {count} of {format_count(len(snapshot), "node")}.', notes)}
        if do == 'rename':
            self._presets.rename(name, content['to'])
        else:
            self._presets.delete(name)
        return {}

    def _wanted(self, content: Mapping[str, Any]) -> tuple[dict[str, Mapping[str, Any]], str, list[str]]:
        """Return the values that a preset or a moment holds for the running nodes, what it is called, and notes."""
        running = self._running()
        held: Mapping[str, Mapping[str, Any]]
        if name := content.get('name'):
            label, held = name, self._presets.read(name, running)
        else:
            time = datetime.datetime.fromisoformat(content['time'])
            with self._log_lock:
                label, held = f'{time:%H:%M:%S}', ChangeLog(self._log).at(time)
        mine = {node: each for node, each in held.items() if not self._nodes or node in self._nodes}
        absent = [node for node in mine if node not in running]
        notes = [f'Not running: {", ".join(absent)}.'] if absent else []
        return {node: each for node, each in mine.items() if node in running}, label, notes


def _lines(log: Sequence[LoggedChange]) -> list[dict[str, Any]]:
    """Return what the history shows, newest first. One line each: the beginning, a node's start, a pull of a slider."""
    lines: list[tuple[LoggedChange, LoggedChange, int]] = []
    known: set[str] = set()
    for each in log:
        is_new, is_value = each.node not in known, each.kind in ('seen', 'declared')
        (known.discard if each.kind == 'gone' else known.add)(each.node)
        if lines:
            first, last, count = lines[-1]
            is_soon = each.time - last.time < _ONE_PULL
            if ((first.kind == 'begin' and each.kind == 'seen')
                    or (first.kind == 'seen' and first.node == each.node and is_value and is_soon)
                    or (each.kind == 'changed' and is_soon
                        and (last.kind, last.node, last.name) == (each.kind, each.node, each.name))):
                lines[-1] = first, each, count + 1
                continue
            if is_new and is_value:
                lines.append((LoggedChange(each.time, 'seen', each.node), each, 1))
                continue
        if each.kind != 'seen':
            lines.append((each, each, 1))
    return [_line(*each) for each in reversed(lines[-_LINES:])]


def _line(first: LoggedChange, last: LoggedChange, count: int) -> dict[str, Any]:
    old, new = values.format_change(first.old, last.new, _LETTERS)
    says = {'begin': 'What the nodes had at the beginning', 'gone': 'is gone', 'seen': 'has come',
            'declared': f'{new} (declared)', 'deleted': f'{old} → deleted'}.get(
        first.kind, f'{old} → {new}' + (f' in {count} changes' if count > 1 else ''))
    whose = f'{first.node} {first.name}'.strip()
    return {'time': last.time.isoformat(), 'whose': whose, 'says': says}


def _told(preview: Preview, notes: Sequence[str]) -> str:
    """Return what would change, as HTML: in one sentence, and value by value."""
    would = preview.count('would be set')
    others = [each for each in preview if each.word != 'would be set']
    words = f'{format_count(would, "value")} would be set' if would else 'No value would be set'
    if not preview.records:
        words = 'Nothing would change: the nodes have these values'
    elif len(others) == 1:
        words += f'{", 1 would not" if would else ""}, because {others[0].reason}'
    elif others:
        words += f', {len(others)} would not'
    # What will change stands first; where all does, no column says so.
    rows = sorted(((f'{node} {name}', *rest) for node, outcomes in preview.nodes.items()
                   for name, *rest in map(preview.words, outcomes)), key=lambda row: row[3] != 'would be set')
    width = 5 if others else 3
    return file_markup(f'{words}.', [*notes, *_silent(preview.unanswered)],
                       ('parameter', 'now', 'then', 'expected', 'reason')[:width], [row[:width] for row in rows])


def _done(restored: Restored) -> str:
    """Return what was changed, as HTML, and which values the nodes did not take, with the reasons."""
    left = [f'{node} {each.name}: {each.word}{f", {each.reason}" if each.reason else ""}.'
            for node, outcomes in restored.nodes.items() for each in outcomes if each.word != 'set']
    return file_markup(f'{format_count(restored.count("set"), "value")} set.', [*left, *_silent(restored.unanswered)])


def _silent(unanswered: Mapping[str, NodeError]) -> list[str]:
    return [f'{error}.' for error in unanswered.values()]
