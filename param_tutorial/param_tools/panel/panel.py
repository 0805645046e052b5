"""The parameter panel: the parameters of any node as controls that show what the node confirmed.

``node.live`` follows the node, ``drawing`` draws the controls, and ``panel.js`` lets a person use them, in the browser;
here the three are kept in step, and the last change is kept for undo.

What a person enters comes in a thread of the kernel's, often while a cell runs in another (see ``front``), and goes
straight to ``LiveParameters.ask``. Nothing is drawn before the node has answered, or is late: the script shows what was
entered until then. Everything is drawn in ``_show``, which ``live`` calls in the thread of ``schedule`` or in that of
``settle``, with the panel's lock held. No lock is held while a request is sent; the executor's thread takes no lock of
a panel at all.
"""

import contextlib
import threading
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

import traitlets
from rcl_interfaces.msg import ParameterValue
from rclpy.node import Node

from param_tools import values
from param_tools.errors import ExecutorError, ParameterNotDeclaredError, WaitTimeoutError
from param_tools.files import parameter_files
from param_tools.markup.scripts import bundle
from param_tools.markup.styles import style
from param_tools.markup.wording import format_count
from param_tools.node.client import ParameterClient, node_name
from param_tools.node.live import FIRST_LOOK_TIMEOUT_SEC, LiveParameters
from param_tools.node.live_state import ParameterState
from param_tools.node.text import format_commands
from param_tools.panel.control import Control, PanelRow
from param_tools.panel.drawing import arrange, panel_markup
from param_tools.panel.front import Front
from param_tools.panel.view import ParameterView
from param_tools.ros import host, stage
from param_tools.ros.services import TIMEOUT_SEC

# Values by the parameters' names.
State = dict[str, Any]

_NO_WAY_BACK = ('it had no value at first, and ROS cannot unset a parameter: it can only delete one, if its type is '
                'dynamic')

_STYLE = style('param_tools/panel/panel.css')


class _Front(Front):
    """The panel in the browser: markup, and what changes in it."""

    _esm = bundle('param_tools/panel/panel.js')
    markup = traitlets.Unicode().tag(sync=True)
    state = traitlets.Dict().tag(sync=True)
    search = traitlets.Unicode().tag(sync=True)


@dataclass
class _Edit:
    """A change made in the panel, to be undone: it begins with a request, and ends when the node has answered all.

    What the node changes meanwhile belongs to it, also another parameter that a callback sets.
    """

    pull: object
    """Edits in a row with the same one are one edit; None for an edit by itself."""
    before: State
    """The values that it replaced."""


class ParameterPanel(ParameterView):
    """The parameters of a node as controls, as long as it is not closed.

    Show it as the last line of a cell. ``panel['max_speed_rpm']`` is one Control. Without a node it is a
    ``ParameterBrowser``: the nodes that there are.
    """

    def __new__(cls, node: str | Node | ParameterClient | None = None, **options: Any) -> Any:
        """Return a panel, or a ParameterBrowser if no node is named."""
        if node is not None:
            return super().__new__(cls)
        from param_tools.panel.browser import ParameterBrowser
        return ParameterBrowser(cls, **options)

    def __init__(self, node: str | Node | ParameterClient, *, names: Iterable[str] | None = None, tools: bool = True,
                 timeout_sec: float = TIMEOUT_SEC, patience_sec: float = FIRST_LOOK_TIMEOUT_SEC, search: str = ''):
        """
        :param node: The node or its name; it may be on a robot far away, and it may be absent now.
        :param names: Only these parameters, in this order; by default all that the node has.
        :param tools: Whether its head has *Undo* and *Copy* beside *Reset*.
        :param timeout_sec: How long the node may take for each answer.
        :param patience_sec: How long to wait for the first answers; later ones are shown when they come.
        :param search: What its search field begins with.
        """
        name = node_name(node)
        self._controls: dict[str, Control] = {}
        self._in_order, self._tools = names is not None, tools
        self._edit: _Edit | None = None
        self._last_edit: _Edit | None = None
        # What is pressed is done by one thread after the other.
        self._acting = threading.RLock()
        self._followed: list[tuple[str, ParameterState]] = []
        self._rows: list[PanelRow] | None = None
        self._first_values: dict[str, ParameterValue] | None = None
        # Of each script that shows the panel, the number of the last entry that has been passed on.
        self._passed_on: dict[str, int] = {}
        self._front = _Front(search=search)
        self._front.on_msg(self._on_message)
        super().__init__([self._front], 'param-panel')
        self._live = LiveParameters(name, self._show, names=names, timeout_sec=timeout_sec, showing=self._drawing)
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
    def changed(self) -> State:
        """What differs from its first values: these, by the parameters' names; None for one that had no value."""
        return {name: control.first for name, control in self._controls.items() if control.is_changed}

    def undo(self) -> None:
        """Take back the last change made in this panel, and wait until the node has done so.

        A value that the node rejects stays as it is, and the panel shows the reason.

        :raises WaitTimeoutError: the node does not answer in time.
        """
        with self._acting:
            self.settle()  # what was entered just now may still be on its way
            edit, self._last_edit = self._last_edit, None
            if edit is not None:
                self._bring_back(edit.before)

    def reset(self, *names: str) -> None:
        """Set parameters back to their first values, and wait until the node has it.

        A value that the node rejects stays as it is, and the panel shows the reason.

        :param names: By default all.
        :raises WaitTimeoutError: the node does not answer in time.
        """
        with self._as_one_edit():
            self._bring_back({name: value for name, value in self.changed.items() if not names or name in names})

    @contextlib.contextmanager
    def _as_one_edit(self) -> Iterator[None]:
        """Take what is changed meanwhile as one edit, also if the node has answered everything in between."""
        with self._acting:
            self.settle()
            before = self._values()
            try:
                yield
            finally:
                with self._drawing:
                    self._end_edit(_Edit(None, before))
                    self._show()  # what can be undone now

    def _bring_back(self, wanted: State) -> None:
        """Ask for values until the node has them, or takes no more of them; say of None that there is no way."""
        for name in [name for name, value in wanted.items() if value is None]:
            del wanted[name]
            if name in self and self[name].value is not None:
                self._live.reject(self[name].parameter, _NO_WAY_BACK)
        # In any order: a value that a rule rejects at first may be accepted once the others are there.
        for _ in range(len(wanted)):
            different = [name for name, value in wanted.items()
                         if name in self and not values.same(self[name].value, value)]
            if not different:
                return
            for name in different:
                self._live.ask(self[name].parameter, wanted[name])
            self.settle()

    def _values(self) -> State:
        """Return what can be set."""
        return {name: each.value for name, each in self._followed if not each.descriptor.read_only}

    def _end_edit(self, edit: _Edit) -> None:
        """Keep an edit for undo, if it has changed anything."""
        now = self._values()
        edit.before = {name: value for name, value in edit.before.items()
                       if name in now and not values.same(value, now[name])}
        last = self._last_edit
        if last is not None and edit.pull is not None and last.pull == edit.pull:
            last.before = edit.before | last.before
        elif edit.before:
            self._last_edit = edit

    # -- what is wanted -----------------------------------------------------------------------------------

    def _ask(self, control: Control, value: Any, grip: object = None) -> None:
        """Ask for a value; see ``Control.slide`` for the grip."""
        # A drawing ends the edit if nothing is under way, and nothing is between these two lines.
        with self._drawing:
            if self._edit is None:
                self._edit = _Edit(None if grip is None else (control.name, grip), self._values())
            self._live.ask(control.parameter, value)

    def _on_message(self, _: Any, content: dict[str, Any], __: Any) -> None:
        """Do what a person did in the browser; called by ipywidgets."""
        if content['do'] == 'enter':
            self._enter(content)
        else:
            # It waits for the node, and the kernel must not.
            host.host.run(lambda: self._press(**content), f'{content["do"]} on the panel of {self.node}')

    def _enter(self, content: dict[str, Any]) -> None:
        control = self._controls.get(content['name'])
        self._passed_on[content['client']] = content['number']
        if control is None:
            return  # it was deleted meanwhile
        if 'position' in content:
            control.slide(content['position'], (content['client'], content['grip']))
        else:
            control.enter(content['text'])

    def _press(self, do: str, name: str = '', **_: Any) -> None:
        with contextlib.suppress(WaitTimeoutError):  # the panel shows what was not answered
            if do == 'undo':
                self.undo()
            else:
                self.reset(*[name] * bool(name))

    # -- what is shown ------------------------------------------------------------------------------------

    def _show(self) -> None:
        if self._closed:
            return
        live = self._live
        if list(live.parameters.items()) != self._followed:
            self._rebuild(live.parameters)
        self._learn_first_values()
        if self._edit is not None and not live.is_busy:
            edit, self._edit = self._edit, None
            self._end_edit(edit)
        states = {name: control.state(is_locked=bool(live.status)) for name, control in self._controls.items()}
        rows = [control.row for control in self._controls.values()]
        with self._front.hold_sync():  # the script needs both at once
            if rows != self._rows:
                self._rows = rows
                self._front.markup = _STYLE + panel_markup(
                    self.node, rows, states, status=live.status, tools=self._tools, is_open=self._in_order)
            self._front.state = {
                'status': live.status, 'undo': self._last_edit is not None, 'passed_on': dict(self._passed_on),
                'copies': self._copies(), 'rows': {name: state.as_json() for name, state in states.items()}}

    def _copies(self) -> list[str]:
        """Return what has changed, as a parameter file and as commands."""
        changed = {name: self[name].value for name in self.changed}
        return [parameter_files.render(self.node, changed).text, format_commands(self.node, changed)] if changed else []

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
                control = Control(self._live, parameter, self._ask)
                if name in old:
                    control.first = old[name].first
            controls[name] = control
        self._first_values = None
        rows = [control.row for control in controls.values()]
        self._controls = {row.name: controls[row.name] for row in (rows if self._in_order else arrange(rows))}
