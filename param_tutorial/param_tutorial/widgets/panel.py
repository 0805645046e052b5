"""The parameter panel: the parameters of any node as controls that show what the node confirmed.

``parameters.live`` follows the node, ``editors`` has the controls; here they are put on the page and kept in step.

Threads. A hand's changes come in the kernel's main thread and go straight to ``LiveParameter.ask``, before
anything is drawn. Everything that is drawn is drawn in ``_show``, which ``live`` calls in its worker's thread or
in that of ``settle``. Both write to widgets with the panel's lock held, and ``Editor.quietly`` keeps what the
panel writes apart from what a hand enters, so nothing goes round in circles. No lock is held while a request is
sent; the executor's thread takes no lock of a panel at all.
"""

import html
import threading
from collections.abc import Iterable
from typing import Any

import ipywidgets as widgets
from rclpy.node import Node

from param_tutorial.errors import ParameterNotDeclaredError
from param_tutorial.parameters import values
from param_tutorial.parameters.client import Descriptor, ParameterClient, is_housekeeping, node_name
from param_tutorial.parameters.live import LiveParameter, LiveParameters
from param_tutorial.parameters.text import fit
from param_tutorial.pictures.styles import style
from param_tutorial.runtime.executor import BackgroundExecutor
from param_tutorial.runtime.services import TIMEOUT_SEC
from param_tutorial.widgets.cells import close_with_cell
from param_tutorial.widgets.editors import (
    CheckBoxEditor,
    DoubleSliderEditor,
    Editor,
    IntegerSliderEditor,
    LinesEditor,
    Positions,
    editor_class,
    range_of,
    whole_positions,
)
from param_tutorial.widgets.recordable import ControlFacts, Scale, WholeNumbers
from param_tutorial.widgets.view import View

# Seldom what one came for, and of qos_overrides.… there may be dozens.
HOUSEKEEPING_HEADING = 'In every node'

_STYLE = style('widgets/panel.css')


class Control:
    """One parameter on a panel: ``panel['max_speed_rpm']``."""

    def __init__(self, parameter: LiveParameter, label: str, lock: threading.RLock):
        self._parameter = parameter
        self._label = label
        self._lock = lock
        self._shape: Any = None
        self._editor: Editor
        self._line = widgets.HBox()
        self._line.add_class('param-line')
        self._help, self._message = widgets.HTML(), widgets.HTML()
        self._help.add_class('param-note')
        self._message.add_class('param-note')
        self.widget = widgets.VBox([self._line, self._help, self._message])
        self.widget.add_class('param-row')
        self.show(enabled=False)

    def __repr__(self) -> str:
        return f'<Control: {self.name} = {self.value!r}>'

    @property
    def name(self) -> str:
        """The parameter's full name."""
        return self._parameter.name

    @property
    def value(self) -> Any:
        """The value that the node confirmed last. Assigning to it moves the control the way a hand would."""
        return self._parameter.value

    @value.setter
    def value(self, value: Any) -> None:
        self._parameter.ask(fit(self._parameter.descriptor, value))

    @property
    def message(self) -> str:
        """Why the last change was not taken, in the node's words; empty if it was."""
        return self._parameter.message

    @property
    def descriptor(self) -> Descriptor:
        """What the node tells about the parameter."""
        return self._parameter.descriptor

    @property
    def editors(self) -> tuple[widgets.Widget, ...]:
        """The widgets that a hand can change: a check box, a text box, or a text box and a slider."""
        return self._editor.widgets

    def show(self, *, enabled: bool) -> None:
        """Draw what is known of the parameter."""
        parameter = self._parameter
        descriptor, value = parameter.descriptor, parameter.value
        shape = descriptor, editor_class(descriptor, value)
        if shape != self._shape:
            self._shape = shape
            self._build(*shape)
        if not parameter.busy:
            self._editor.show(value)
        self._editor.enable(enabled and not descriptor.read_only)
        self._message.value = _message_markup(parameter)

    def _build(self, descriptor: Descriptor, editor: type[Editor]) -> None:
        parameter = self._parameter
        self._editor = editor(descriptor, self._label, self._lock, parameter.ask, parameter.reject, parameter.give_way)
        old, self._line.children = self._line.children, self._editor.widgets
        for widget in old:
            widget.close()
        is_number = descriptor.type in (values.INTEGER, values.DOUBLE) and not descriptor.dynamic_typing
        (self._line.remove_class if is_number else self._line.add_class)('param-long')
        self._help.value = help_markup(descriptor)

    def close(self) -> None:
        """Remove the control from the page."""
        for widget in (*self._line.children, *self.widget.children, self.widget):
            widget.close()


class ParameterPanel(View):
    """The parameters of a node as controls, as long as it is not closed.

    Show it as the last line of a cell. ``panel['max_speed_rpm']`` is one Control.
    """

    def __init__(self, node: str | Node | ParameterClient, *, names: Iterable[str] | None = None,
                 executor: BackgroundExecutor | None = None, timeout_sec: float = TIMEOUT_SEC):
        """
        :param node: The node or its name; it may be on a robot far away, and it may be absent now.
        :param names: Only these parameters, in this order; by default all that the node has.
        :param executor: Carries the requests; by default whichever runs in the background.
        :param timeout_sec: How long the node may take for each answer.
        """
        self._node = node_name(node)
        self._controls: dict[str, Control] = {}
        # What each parameter had when the panel first saw it.
        self._first: dict[str, Any] = {}
        self._headings: dict[str, widgets.HTML] = {}
        self._in_order = names is not None
        self._style, self._head = widgets.HTML(_STYLE), widgets.HTML()
        self._head.add_class('param-head')
        super().__init__([self._style, self._head], 'param-panel')
        self._live = LiveParameters(self._node, self._show, names=names, executor=executor, timeout_sec=timeout_sec)
        self._live.first_look()
        close_with_cell(self)

    def __repr__(self) -> str:
        if self._closed:
            fact = 'closed'
        elif self._live.status:
            fact = 'not available'
        else:
            fact = _format_count(len(self._controls))
        return f'<ParameterPanel: {self._node}, {fact}>'

    def __getitem__(self, name: str) -> Control:
        """Return the control of a parameter.

        :raises ParameterNotDeclaredError: there is none.
        """
        try:
            return self._controls[name]
        except KeyError:
            raise ParameterNotDeclaredError(self._node, name, self.names) from None

    def __contains__(self, name: str) -> bool:
        return name in self._controls

    @property
    def node(self) -> str:
        """The fully qualified name of the node."""
        return self._node

    @property
    def names(self) -> list[str]:
        """The parameters that have a control, as they stand on the page."""
        return list(self._controls)

    @property
    def status(self) -> str:
        """Why nothing can be changed now, e.g. because the node is not running; empty if it can."""
        return self._live.status

    def settle(self, timeout_sec: float = 10.0) -> None:
        """Wait until the node has answered every change made so far and the panel shows what the node has now.

        :raises WaitTimeoutError: it took too long; the message names the parameters.
        """
        self._live.settle(timeout_sec)

    def reset(self) -> None:
        """Set every parameter back to what the panel first saw, and wait until the node has it.

        A value that the node rejects stays as it is, and the panel shows the reason.

        :raises WaitTimeoutError: the node does not answer in time.
        """
        self.settle()  # what a hand did just now may still be on its way
        changed = self._changed()
        # In any order: a value that a rule rejects at first may be accepted once the others are back.
        for _ in range(len(changed)):
            for name in changed:
                self[name].value = self._first[name]
            self.settle()
            changed = self._changed()

    def _changed(self) -> list[str]:
        return [name for name, control in self._controls.items() if not control.descriptor.read_only
                and self._first[name] is not None and not values.same(control.value, self._first[name])]

    def _end(self) -> None:
        self._live.close()

    def _show(self) -> None:
        with self._drawing:
            if self._closed:
                return
            live = self._live
            if list(self._controls) != self._arrange(live.parameters):
                self._rebuild(live.parameters)
            for name, control in self._controls.items():
                if name in live.parameters:
                    control.show(enabled=not live.status)
            self._head.value = _head_markup(self._node, live.status, len(self._controls))
            self._place()

    def _arrange(self, names: Iterable[str]) -> list[str]:
        """Put the names in the order of the page: groups together, what every node has last."""
        names = list(names)
        if self._in_order:
            return names
        first_of_group: dict[str, int] = {}
        for index, name in enumerate(names):
            first_of_group.setdefault(group_of(name), index)
        return sorted(names, key=lambda name: (is_housekeeping(name), first_of_group[group_of(name)],
                                               names.index(name)))

    def _rebuild(self, parameters: dict[str, LiveParameter]) -> None:
        """Make the controls that are missing and drop those whose parameter is gone; keep all others as they are."""
        old, controls = self._controls, {}
        for name in self._arrange(parameters):
            control = old.pop(name, None)
            if control is None or control._parameter is not parameters[name]:
                if control is not None:
                    control.close()
                group = group_of(name)
                control = Control(parameters[name], name.removeprefix(f'{group}.') if group else name, self._drawing)
                if is_housekeeping(name):
                    control.widget.add_class('param-quiet')
            controls[name] = control
            self._first.setdefault(name, control.value)
        self._controls = controls
        for control in old.values():
            control.close()

    def _place(self) -> None:
        """Put the controls onto the page, each group under its heading."""
        children: list[widgets.Widget] = [self._style, self._head]
        headings: dict[str, widgets.HTML] = {}
        group = ''
        for name, control in self._controls.items():
            wanted = HOUSEKEEPING_HEADING if is_housekeeping(name) else group_of(name)
            if wanted and wanted != group:
                heading = headings.get(wanted) or self._headings.pop(wanted, None) or _heading(wanted)
                headings[wanted] = heading
                children.append(heading)
            group = wanted
            children.append(control.widget)
        for heading in self._headings.values():
            heading.close()
        self._headings = headings
        if tuple(children) != self.children:
            self.children = tuple(children)

    # -- recording: see ``recordable`` -------------------------------------------------------------------

    def snapshot(self) -> dict[str, Any]:
        """Return what a page without a kernel needs to draw it as it stands, beside its controls."""
        return {'kind': 'panel', 'node': self.node, 'status': self.status, 'rows': []}

    def controls(self) -> dict[str, ControlFacts]:
        """Return what a hand can change, by the parameters' names."""
        return {name: _control_facts(control, bool(self.status)) for name, control in self._controls.items()}


def _control_facts(control: Control, unavailable: bool) -> ControlFacts:
    name, descriptor = control.name, control.descriptor
    editor, group, quiet = editor_class(descriptor, control.value), group_of(name), is_housekeeping(name)
    scale: Scale | None = None
    if issubclass(editor, DoubleSliderEditor):
        scale = Positions(range_of(descriptor))
    elif issubclass(editor, IntegerSliderEditor):
        first, last, step = whole_positions(range_of(descriptor))
        scale = WholeNumbers(first, step, (last - first) // step)
    return ControlFacts(
        descriptor=descriptor, value=control.value, message=control.message,
        label=name.removeprefix(f'{group}.') if group else name,
        heading=HOUSEKEEPING_HEADING if quiet else group, quiet=quiet,
        locked=descriptor.read_only or unavailable, help_html=help_markup(descriptor),
        editor='check' if editor is CheckBoxEditor else 'lines' if editor is LinesEditor else 'text', scale=scale)


def group_of(name: str) -> str:
    """Return what a parameter's name has before its last dot, which is the heading of its group."""
    return '' if is_housekeeping(name) else name.rpartition('.')[0]


def _format_count(count: int) -> str:
    return f'{count} parameter{"" if count == 1 else "s"}'


def _heading(group: str) -> widgets.HTML:
    heading = widgets.HTML(f'<div role="heading" aria-level="4">{html.escape(group)}</div>')
    heading.add_class('param-group')
    return heading


def _head_markup(node: str, status: str, count: int) -> str:
    words = (f'<span class="param-status">{_format_count(count)}</span>' if not status else
             f'<span class="param-status param-status-bad">&#9888; {html.escape(status)}</span>')
    return f'<div role="status"><span class="param-node">{html.escape(node)}</span>{words}</div>'


def help_markup(descriptor: Descriptor) -> str:
    facts = [descriptor.type.label]
    if descriptor.range:
        facts.append(f'{descriptor.range.from_value} to {descriptor.range.to_value}'
                     + (f' in steps of {descriptor.range.step}' if descriptor.range.step else ''))
    facts += ['any type'] * descriptor.dynamic_typing + ['<b>read only</b>'] * descriptor.read_only
    texts = [html.escape(text) for text in (descriptor.description, descriptor.additional_constraints) if text]
    return f'<div class="param-help">{" ".join(texts)} <span class="param-facts">({", ".join(facts)})</span></div>'


def _message_markup(parameter: LiveParameter) -> str:
    # An alert is read out when it comes onto the page, which is how ipywidgets updates HTML.
    if parameter.late:
        return '<div class="param-message param-waiting" role="status">Waiting for the node to answer…</div>'
    if not parameter.message:
        return ''
    return f'<div class="param-message" role="alert"><b>Rejected:</b> {html.escape(parameter.message)}</div>'
