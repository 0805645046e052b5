"""The parameter panel: the parameters of any node as controls that show what the node confirmed.

``node.live`` follows the node, ``drawing`` draws the controls, and ``panel.js`` lets a person use them, in the browser;
here the three are kept in step, and what was done is kept for undo.

What a person enters comes in a thread of the kernel's, often while a cell runs in another (see ``beside_cells``), and
goes straight to ``LiveParameters.ask``, before anything is drawn. Everything is drawn in ``_show``, which ``live``
calls in the thread of ``schedule`` or in that of ``settle``, with the panel's lock held. No lock is held while a
request is sent; the executor's thread takes no lock of a panel at all.
"""

import contextlib
import functools
import queue
import threading
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import ipywidgets as widgets
import traitlets
from rcl_interfaces.msg import ParameterValue
from rclpy.node import Node

from param_tools import values
from param_tools.errors import (
    ExecutorError,
    ParameterFileError,
    ParameterNotDeclaredError,
    ParameterToolError,
    WaitTimeoutError,
    describe_error,
)
from param_tools.files.parameter_files import Dump, as_path, render
from param_tools.markup.scripts import bundle
from param_tools.markup.styles import sheet, style
from param_tools.markup.wording import format_count
from param_tools.node.client import ParameterClient, node_name
from param_tools.node.live import FIRST_LOOK_TIMEOUT_SEC, LiveParameters
from param_tools.node.live_state import ParameterState
from param_tools.node.text import format_value
from param_tools.panel.control import Control
from param_tools.panel.drawing import PanelRow, arrange, panel_markup
from param_tools.panel.edits import Edits, State
from param_tools.panel.front import Front
from param_tools.panel.view import FollowingView, ParameterView
from param_tools.ros import host, stage
from param_tools.ros.executor import BackgroundExecutor
from param_tools.ros.services import TIMEOUT_SEC
from param_tools.systems.catalog import Catalog, CatalogNode

if TYPE_CHECKING:  # what reads and checks files is imported when a file is first named: most panels never need it
    from param_tools.systems.file_preview import FilePreview, Loaded

_STYLE = style('param_tools/panel/panel.css')
# Of a node in which a search finds more, these are shown; its panel shows all.
_HITS = 8


class _Front(Front):
    """The panel in the browser: markup, and what changes in it."""

    _esm = bundle('param_tools/panel/panel_widget.js')
    markup = traitlets.Unicode().tag(sync=True)
    state = traitlets.Dict().tag(sync=True)
    search = traitlets.Unicode().tag(sync=True)


class _BrowserFront(Front):
    """The list of nodes in the browser."""

    _esm = bundle('param_tools/panel/browser.js')
    _css = sheet('param_tools/panel/panel.css') + sheet('param_tools/panel/browser.css')
    state = traitlets.Dict().tag(sync=True)


class ParameterPanel(ParameterView):
    """The parameters of a node as controls, as long as it is not closed.

    Show it as the last line of a cell. ``panel['max_speed_rpm']`` is one Control. Without a node it is a
    ``ParameterBrowser``: the nodes that there are.
    """

    def __new__(cls, node: str | Node | ParameterClient | None = None, **options: Any) -> Any:
        """Return a panel, or a ParameterBrowser if no node is named."""
        return ParameterBrowser(**options) if node is None else super().__new__(cls)

    def __init__(self, node: str | Node | ParameterClient, *, names: Iterable[str] | None = None, tools: bool = True,
                 timeout_sec: float = TIMEOUT_SEC, patience_sec: float = FIRST_LOOK_TIMEOUT_SEC, search: str = ''):
        """
        :param node: The node or its name; it may be on a robot far away, and it may be absent now.
        :param names: Only these parameters, in this order; by default all that the node has.
        :param tools: Whether its head has more buttons than *Reset*: *Gather*, *Undo*, *Redo*, *Save…* and *Load…*.
        :param timeout_sec: How long the node may take for each answer.
        :param patience_sec: How long to wait for the first answers; later ones are shown when they come.
        :param search: What its search field begins with.
        """
        self._controls: dict[str, Control] = {}
        self._in_order, self._tools = names is not None, tools
        self._edits = Edits(self._state, self._bring)
        # What a person presses is done in that order, each when the one before has its answers.
        self._jobs: queue.SimpleQueue[Callable[[], object]] = queue.SimpleQueue()
        self._acting = threading.RLock()
        self._followed: list[tuple[str, ParameterState]] = []
        self._rows: list[PanelRow] | None = None
        self._first_values: dict[str, ParameterValue] | None = None
        # What is wanted together, by name; None if each change is sent at once.
        self._gathered: State | None = None
        self._is_code_gathered = False
        self._note = ''
        self._not_restored: dict[str, str] = {}
        self._front = _Front(search=search)
        self._front.on_msg(self._on_message)
        self._live = LiveParameters(node_name(node), self._show, names=names, timeout_sec=timeout_sec)
        super().__init__([self._front], 'param-panel')
        self._begin(patience_sec)

    def __repr__(self) -> str:
        if self._closed:
            fact = 'closed'
        elif self._live.status:
            fact = 'not available'
        else:
            fact = format_count(len(self._controls), 'parameter')
        return f'<ParameterPanel: {self.node}, {fact}>'

    def __getitem__(self, name: str) -> Control:
        """Return the control of a parameter.

        :raises ParameterNotDeclaredError: there is none.
        """
        try:
            return self._controls[name]
        except KeyError:
            raise ParameterNotDeclaredError(self.node, str(name), self.names) from None

    def __contains__(self, name: str) -> bool:
        return name in self._controls

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    @property
    def names(self) -> list[str]:
        """The parameters that have a control, as they stand on the page."""
        return list(self._controls)

    @property
    def status(self) -> str:
        """Why nothing can be changed now, e.g. because the node is not running; empty if it can."""
        return self._live.status

    @property
    def changed(self) -> dict[str, Any]:
        """What differs from its first values: these, by the parameters' names."""
        return {name: control.first for name, control in self._controls.items() if control.is_changed}

    @property
    def gathered(self) -> State | None:
        """The changes that ``apply`` will send, by the parameters' names; None if each change is sent at once."""
        return None if self._gathered is None else dict(self._gathered)

    def gather(self) -> None:
        """From now on gather changes, until ``apply`` sends them together or ``discard`` forgets them."""
        self._gather(is_code_gathered=True)

    def _gather(self, *, is_code_gathered: bool) -> None:
        if self._gathered is None:
            self._gathered, self._note, self._is_code_gathered = {}, '', is_code_gathered
            self._show()
        elif is_code_gathered:
            self._is_code_gathered = True

    def discard(self) -> None:
        """Forget what was gathered, and send each change at once again."""
        self._gathered = None
        self._show()

    def apply(self) -> str:
        """Send what was gathered as one request, which the node accepts or rejects as a whole.

        :return: Why the node rejected it, in which case it stays gathered; empty if it was accepted.
        :raises WaitTimeoutError: the node does not answer in time.
        """
        with self._acting:
            wanted = self._gathered or {}
            self.settle()
            with self._as_one_edit():
                try:
                    self._note = self._set_together(wanted)
                except ParameterToolError as error:
                    self._note = describe_error(error)
                if not self._note:
                    self._gathered = None
                self.settle()
            return self._note

    def dump(self, *, changed_only: bool = False) -> Dump:
        """Return the values that the panel shows as a parameter file.

        :param changed_only: Only what differs from its first value.
        :raises ParameterFileError: there is nothing to write.
        """
        present = {name: control.value for name, control in self._controls.items()
                   if control.is_changed or not changed_only}
        if not present:
            raise ParameterFileError(f'no parameter of {self.node} differs from its first value' if self._controls
                                     else f'no parameter of {self.node} is known: {self.status}')
        return render(self.node, present)

    def save(self, path: str | Path, changed_only: bool = False) -> Dump:
        """Write what the node has now, as far as it is on the panel, to a parameter file.

        :param path: An existing file is replaced as a whole, or not at all.
        :param changed_only: Only what differs from its first value.
        :return: The text, and which parameters no file can hold (``left_out``), with the reason.
        :raises ParameterFileError: there is nothing to write, no such path.
        :raises OSError: the file cannot be written.
        :raises WaitTimeoutError: the node does not answer in time.
        """
        self.settle()
        dump = self.dump(changed_only=changed_only)
        dump.save(as_path(path, is_typed=True))
        return dump

    def preview(self, path: str | Path) -> 'FilePreview':
        """Return what loading a parameter file would do, row by row; nothing is asked of the node.

        :raises ParameterFileError: the file cannot be read, or rcl would reject it.
        """
        from param_tools.systems.file_preview import preview_file

        with self._drawing:
            descriptors = {name: control.descriptor for name, control in self._controls.items()}
            present = {name: control.value for name, control in self._controls.items()}
        return preview_file(as_path(path, is_typed=True), self.node, descriptors, present, is_partial=self._in_order)

    def load(self, path: str | Path) -> 'Loaded':
        """Ask the node for the values that a parameter file holds for it; ``undo`` takes them back together.

        They go in one request. If the node rejects that, each is asked for by itself. While changes are gathered,
        these are gathered, too.

        :return: What was not loaded and why, by the parameters' names.
        :raises ParameterFileError: the file cannot be read, or rcl would reject it; nothing was asked for.
        :raises NodeError: the node is not there, or does not answer.
        :raises WaitTimeoutError: the node does not answer in time.
        """
        with self._acting:
            self.settle()
            return self._load(self.preview(path))

    def _load(self, preview: 'FilePreview') -> 'Loaded':
        from param_tools.systems.file_preview import Loaded

        wanted = preview.accepted
        left = preview.left_out
        if self._gathered is not None:
            self._gathered, self._note = {**self._gathered, **wanted}, ''
            self._show()
            return Loaded(left, wanted, is_gathered=True)
        with self._as_one_edit():
            if self._set_together(wanted):
                left |= self._bring(wanted)
            self.settle()
        left |= {name: f'the node has stored {self[name].value!r}' for name, value in wanted.items()
                 if name not in left and self._differs(name, value)}
        return Loaded(left, [name for name in wanted if name not in left])

    @contextlib.contextmanager
    def _as_one_edit(self) -> Iterator[None]:
        try:
            with self._edits.as_one():
                yield
        finally:
            self._show()  # what can be undone now

    def _set_together(self, wanted: State) -> str:
        """Ask for values in one request, and return why the node rejected it; empty if it did not."""
        results = self._live.client().set_parameters_atomically(wanted) if wanted else []
        return next((each.reason or 'The node gave no reason.' for each in results if not each.successful), '')

    @property
    def not_restored(self) -> dict[str, str]:
        """What the last ``undo``, ``redo`` or ``reset`` could not bring back, and why, by the parameters' names."""
        return dict(self._not_restored)

    def undo(self) -> None:
        """Take back what was done last in this panel, and wait until the node has done so; see ``not_restored``.

        :raises WaitTimeoutError: the node does not answer in time.
        """
        with self._acting:
            self.settle()
            self._not_restored = self._edits.undo()

    def redo(self) -> None:
        """Do again what was taken back last, and wait until the node has done so; see ``not_restored``.

        :raises WaitTimeoutError: the node does not answer in time.
        """
        with self._acting:
            self.settle()
            self._not_restored = self._edits.redo()

    def reset(self, *names: str) -> None:
        """Set parameters back to their first values, and wait until the node has it; see ``not_restored``.

        A value that the node rejects stays as it is, and the panel shows the reason.

        :param names: By default all.
        :raises WaitTimeoutError: the node does not answer in time.
        """
        with self._acting:
            self.settle()  # what was entered just now may still be on its way
            wanted = {name: value for name, value in self.changed.items() if not names or name in names}
            with self._as_one_edit():
                self._not_restored = self._bring(wanted)

    def _bring(self, wanted: State) -> dict[str, str]:
        """Ask for values until the node has them; return the reasons for those that it does not take."""
        # In any order: a value that a rule rejects at first may be accepted once the others are there.
        for _ in range(len(wanted)):
            different = [name for name, value in wanted.items() if self._differs(name, value)]
            if not different:
                break
            for name in different:
                self._live.ask(self[name].parameter, wanted[name])
            self.settle()
        return {name: self[name].message or 'the node has another value' if name in self else 'it is no longer there'
                for name, value in wanted.items() if name not in self or self._differs(name, value)}

    def _differs(self, name: str, value: Any) -> bool:
        return name in self and not values.same(self[name].value, value)

    def _state(self) -> State:
        return {name: each.value for name, each in self._followed if not each.descriptor.read_only}

    # -- the browser ------------------------------------------------------------------------------------

    def _on_message(self, _: Any, content: dict[str, Any], __: Any) -> None:
        """Do what a person did in the browser; called by ipywidgets."""
        if content['do'] == 'enter':
            self._enter(content)
        elif content['do'] in ('look', 'act'):
            host.host.run(functools.partial(self._serve_form, content), f'file of {self.node}')
        else:
            names = [content['name']] if content.get('name') else []
            job: Callable[[], object] = {'undo': self.undo, 'redo': self.redo,
                                         'reset': lambda: self.reset(*names),
                                         'gather': lambda: self._gather(is_code_gathered=False),
                                         'discard': self.discard, 'apply': self.apply}[content['do']]
            self._jobs.put(job)
            # It waits for the node, and the kernel must not.
            host.host.run(self._do_next, f'{content["do"]} on the panel of {self.node}')

    def _do_next(self) -> None:
        with self._acting, contextlib.suppress(WaitTimeoutError):  # the panel shows what was not answered
            self._jobs.get()()

    def _enter(self, content: dict[str, Any]) -> None:
        control = self._controls.get(content['name'])
        if control is not None:  # and not deleted meanwhile
            if 'position' in content:
                control.slide(content['position'], (content['client'], content['grip']))
            else:
                control.enter(content['items'] if 'items' in content else content['text'])
        self._show()
        self._front.send({each: content[each] for each in ('client', 'name', 'number')})

    def _serve_form(self, content: dict[str, Any]) -> None:
        """Answer the form for parameter files: what a path would do, or what was done."""
        from param_tools.panel import file_form

        wish = {'is_save': content['is_save'], 'path': content['path'].strip(), 'changed_only': content['changed_only']}
        answer: dict[str, Any] = {'client': content['client'], 'form': content['number']}
        if content['do'] == 'look':
            answer |= {'offered': file_form.offered_files(), 'suggested': file_form.suggested_file(self.node),
                       **file_form.look(self, **wish)}
        else:
            answer |= {'said': file_form.act(self, **wish)}
        with self._drawing:
            if not self._closed:
                self._front.send(answer)

    def _show(self) -> None:
        with self._drawing:
            if self._closed:
                return
            live = self._live
            if list(live.parameters.items()) != self._followed:
                self._rebuild(live.parameters)
            self._learn_first_values()
            if not live.is_busy:
                self._edits.end()
            gathered = self._gathered or {}
            known = {name: control.value for name, control in self._controls.items()} | gathered
            states = {name: control.state(is_locked=bool(live.status), known=known, gathered=gathered.get(name, ...))
                      for name, control in self._controls.items()}
            rows = [control.row for control in self._controls.values()]
            with self._front.hold_sync():  # the script needs both at once
                if rows != self._rows:
                    self._rows = rows
                    self._front.markup = _STYLE + panel_markup(
                        self.node, rows, states, status=live.status, in_order=self._in_order, tools=self._tools)
                self._front.state = {
                    'status': live.status, 'undo': self._edits.can_undo, 'redo': self._edits.can_redo,
                    'rows': {name: state.as_json() for name, state in states.items()},
                    **self._gathering()}

    def _gathering(self) -> dict[str, Any]:
        """Return what the script has to know of what is gathered; nothing if each change is sent at once."""
        if self._gathered is None:
            return {}
        count = len(self._gathered)
        told = f'{format_count(count, "change")} gathered, not sent yet.'
        return {'gathered': count, 'note': f'{told}\nRejected: {self._note}' if self._note else told}

    def _take(self, control: Control, value: Any, grip: object = None, *, is_code: bool = False) -> None:
        """Ask for a value, or gather it.

        :param grip: See ``Control.slide``.
        :param is_code: True if code wants it: a cell does what it says, so its value is gathered only if code said so.
        """
        if self._gathered is None or (is_code and not self._is_code_gathered):
            # A drawing ends the edit if nothing is under way, and nothing is between these two lines.
            with self._drawing:
                self._edits.begin(control.name, grip)
                self._live.ask(control.parameter, value)
            return
        self._gathered = {**self._gathered, control.name: value}
        if values.same(value, control.value):
            del self._gathered[control.name]
        self._note = ''
        self._show()

    def _learn_first_values(self) -> None:
        """Let each control of a node on the stage go back to what the node began with.

        The panel may have been made again since, by a cell that ran again.
        """
        try:
            first_values = stage.current().first_values(self.node)
        except ExecutorError:
            return
        if first_values is not None and first_values is not self._first_values:
            self._first_values = first_values
            for name, control in self._controls.items():
                if name in first_values:
                    control.first = values.to_python_or_none(first_values[name])

    def _rebuild(self, parameters: dict[str, ParameterState]) -> None:
        """Make the controls that are missing and drop those whose parameter is gone; keep all others as they are."""
        self._followed = list(parameters.items())
        old, controls = self._controls, {}
        for name, parameter in parameters.items():
            control = old.get(name)
            if control is None or control.parameter is not parameter:
                control = Control(self._live, parameter, self._take)
                if name in old:
                    control.first = old[name].first
            controls[name] = control
        self._first_values = None
        rows = [control.row for control in controls.values()]
        self._controls = {row.name: controls[row.name] for row in (rows if self._in_order else arrange(rows))}


class ParameterBrowser(FollowingView):
    """The nodes of a robot as they come and go, a search over all their parameters, and panels of what is opened.

    Show it as the last line of a cell; ``ParameterPanel()`` makes one. ``browser['/node']`` is the node's panel.
    """

    def __init__(self, *, timeout_sec: float = TIMEOUT_SEC):
        """:param timeout_sec: How long a node may take for each answer."""
        self._timeout_sec = timeout_sec
        self._catalog: Catalog | None = None
        self._search = ''
        self._panels: dict[str, ParameterPanel] = {}
        self._front = _BrowserFront(state={'nodes': [], 'status': ''})
        self._front.add_class('param-panel')
        self._front.add_class('param-nodes')
        self._front.on_msg(self._on_message)
        self._box = widgets.Box()
        self._box.add_class('node-panels')
        super().__init__([self._front, self._box], 'param-browser')
        self._begin()

    def __repr__(self) -> str:
        return f'<ParameterBrowser{": closed" if self._closed else ""}>'

    def __getitem__(self, node: str) -> ParameterPanel:
        """Return the panel of a node that is open.

        :raises KeyError: it is not open.
        """
        return self._panels[node]

    @property
    def node(self) -> str:
        """What it shows, in the place of one node's name."""
        return 'all nodes'

    @property
    def nodes(self) -> list[str]:
        """The fully qualified names of the nodes that are there."""
        return list(self._catalog.nodes) if self._catalog else []

    def find(self, text: str) -> dict[str, list[str]]:
        """Find parameters by words in their node, name, description or value; return their names by node."""
        return self._catalog.find(text) if self._catalog else {}

    def show(self, node: str, *, search: str = '') -> ParameterPanel:
        """Open the panel of a node, without waiting for its answers.

        :param search: What the panel's search field begins with.
        """
        with self._drawing:
            if node in self._panels and search:
                self.hide(node)
            if node not in self._panels:
                self._panels[node] = ParameterPanel(node, search=search, timeout_sec=self._timeout_sec,
                                                    patience_sec=0.0)
                self._box.children = tuple(self._panels.values())
        self._job.wake()
        return self._panels[node]

    def hide(self, node: str) -> None:
        """Close the panel of a node, if it is open."""
        with self._drawing:
            if panel := self._panels.pop(node, None):
                self._box.children = tuple(self._panels.values())
                panel.close()
        self._job.wake()

    def _on_message(self, _: Any, content: dict[str, Any], __: Any) -> None:
        """Do what a person did in the browser; called by ipywidgets."""
        if content['do'] == 'find':
            self._search = content['text']
            self._job.wake()
        elif content['do'] == 'toggle' and content['node'] in self._panels:
            self.hide(content['node'])
        else:
            self.show(content['node'], search=content.get('search', ''))

    def _subscribe(self, executor: BackgroundExecutor) -> Callable[[], object]:
        self._catalog = Catalog(executor, self._job.wake, timeout_sec=self._timeout_sec)
        return self._catalog.close

    def _lose(self) -> None:
        self._catalog = None

    def _show(self) -> None:
        catalog = self._catalog
        nodes = catalog.nodes if catalog else {}
        found = catalog.find(self._search, nodes) if catalog and self._search.strip() else dict.fromkeys(nodes, ())
        lines = {}
        for name, node in nodes.items():
            if name in found or name in self._panels:
                hits = [[hit, format_value(node.descriptors[hit], node.values[hit])]
                        for hit in list(found.get(name, ()))[:_HITS]]
                lines[name] = {'name': name, 'is_open': name in self._panels, 'is_bad': bool(node.problem),
                               'says': _says(node), 'hits': hits}
        # A panel outlives its node, and should still be closed where it was opened. The node may also be there: one
        # that was stopped for longer than DDS waits answers again, but ROS lists it no more.
        lines |= {name: {'name': name, 'is_open': True, 'is_bad': True, 'says': 'not in the graph', 'hits': []}
                  for name in self._panels if name not in nodes}
        status = 'no executor is running' if catalog is None else format_count(len(nodes), 'node')
        if self._search.strip():
            count = sum(map(len, found.values()))
            status += f', {format_count(count, "parameter")} found in {len(found)}'
        self._front.state = {'status': status, 'nodes': [lines[name] for name in sorted(lines)]}

    def _end(self) -> None:
        super()._end()
        for node in list(self._panels):
            self._panels.pop(node).close()


def _says(node: CatalogNode) -> str:
    if node.problem:
        return node.problem
    return format_count(len(node.descriptors), 'parameter') if node.is_read else 'asking …'
