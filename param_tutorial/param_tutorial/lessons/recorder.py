"""Asks a running node what a reader of a page without a kernel could ask it, and writes the answers down.

``record`` runs inside a lesson's kernel, right after the cell that has shown a widget, and gives what the page needs
as JSON. It sets, reads and restores the node's parameters through the same services as everybody; nothing is worked
out that the node can be asked. The kernel is thrown away afterwards, so the lesson's own outputs never know.

A node's answer may depend on its other parameters, or on the one that is asked for. Each answer is therefore recorded
from the state in which the lesson shows the node, and then samples of them are asked for again from other states.
Where these differ the page is told so, and gives an answer only in the states in which it was recorded.
"""

import itertools
import math
import re
import threading
from collections.abc import Iterable, Iterator
from typing import Any

import ipywidgets as widgets
from rcl_interfaces.msg import ParameterEvent
from rclpy.node import Node

from param_tutorial.errors import ParameterToolError
from param_tutorial.nodes.clawbot_node import ClawbotNode
from param_tutorial.nodes.pid_controller_node import PidControllerNode
from param_tutorial.parameters import values
from param_tutorial.parameters.client import Descriptor, ParameterClient, is_housekeeping
from param_tutorial.parameters.live import words_of
from param_tutorial.parameters.text import format_value, parse_value
from param_tutorial.runtime import stage
from param_tutorial.runtime.node_log import LogLine
from param_tutorial.widgets.editors import (
    CheckBoxEditor,
    DoubleSliderEditor,
    IntegerSliderEditor,
    LinesEditor,
    Positions,
    editor_class,
)
from param_tutorial.widgets.events import EventView, told_by
from param_tutorial.widgets.log import LogView
from param_tutorial.widgets.panel import HOUSEKEEPING_HEADING, ParameterPanel, group_of, help_markup
from param_tutorial.widgets.robot import RobotView, film, still
from param_tutorial.widgets.step_response import StepResponseView

# How many positions of a slider are asked for; beyond that, a spread with both ends.
_POSITIONS = 201
_POSITIONS_OF_MANY = 51
_MANY_SLIDERS = 4
# How many combinations of values a robot drives with.
_DRIVES_TOGETHER = 160
_SPREADS = (7, 5, 4, 3, 2)
_SAMPLES = 5
_CONTEXTS = 2
_CONTEXTS_OF_DEPENDENT = 11
_SAMPLES_OF_DEPENDENT = 41
_MARK = 'param_tutorial: end of an answer'

# What hands type: a few of everything, and what no parameter of the type can be.
_TYPED = {
    values.INTEGER: [*map(str, range(-20, 201)), *map(str, range(-100, 401, 10)), '500', '600', '900', '999', '1000',
                     '2000', '5000', '10000', '', 'fast', '1.5', '0x10', '99999999999999999999'],
    values.DOUBLE: [*(f'{each / 20:.2f}'.removesuffix('0') for each in range(-20, 61)),
                    *(f'{each / 2:.1f}' for each in range(-20, 41)), *map(str, range(-10, 101)),
                    '-20.0', '-100.0', '1000.0', 'nan', 'inf', '-inf', '1e3', '1,5', '', 'fast'],
    values.STRING: ['', ' ', 'Clawbot', 'clawbot', 'Rex', 'Max', 'Robot', 'R2D2', 'test', 'hello', 'fast', 'slow',
                    'off', 'on', 'true', '0', '1', '42'],
    values.BOOL: ['true', 'false', '1', '0', 'yes', ''],
    values.BYTE_ARRAY: ['[]', '[0x00]', '[0x00, 0xff]', '[0x100]', 'x', ''],
    values.BOOL_ARRAY: ['[]', '[true]', '[false]', '[true, false]', '[true, true]', '[false, false]', '[1]', 'x', ''],
    values.INTEGER_ARRAY: ['[]', '[0]', '[1]', '[1, 2]', '[1, 2, 3]', '[1, 2, 3, 4]', '[-1]', '[1.5]', '[a]',
                           '1, 2', ''],
    values.DOUBLE_ARRAY: ['[]', '[0.0]', '[1.0]', '[0.5, 1.0]', '[1, 2]', '[1.0, 2.0, 3.0]', '[-1.0]', '[a]', ''],
    values.STRING_ARRAY: ['[]', '[left]', '[left, right]', '[left, right, middle]', '[""]', '[1, 2]', ''],
    values.NOT_SET: ['', '1', '1.5', 'true', 'text', '[1, 2]', '[a, b]'],
}


def record(model_id: str, literals: Iterable[Any], *, events: bool = False) -> dict[str, Any]:
    """Record what a page needs of a widget.

    :param model_id: Of the widget that a cell has shown.
    :param literals: Values that the lesson speaks of; a parameter of a fitting type is asked for them too.
    :param events: Record also what a panel's node tells on /parameter_events.
    :return: What JSON can hold; ``kind`` is 'panel', 'robot', 'log', 'steps', 'events' or 'still'.
    """
    # There is no public way from a model's id, which is all that an output tells, to its widget.
    widget = widgets.widget._instances[model_id]
    if isinstance(widget, ParameterPanel):
        return PanelRecorder(widget, list(literals), events=events).record()
    if isinstance(widget, RobotView):
        return record_robot(widget)
    if isinstance(widget, LogView):
        return record_log(widget)
    if isinstance(widget, StepResponseView):
        widget.settle()
        return {'kind': 'steps', 'node': name_in(widget), 'html': still_html(widget)}
    if isinstance(widget, EventView):
        return {'kind': 'events', 'node': name_in(widget), 'html': still_html(widget)}
    # A widget that speaks for itself shows something that is of this machine, or of this moment.
    speaks = type(widget).__repr__ is not widgets.Widget.__repr__ and not isinstance(widget, widgets.Box)
    return {'kind': 'still', 'html': '' if speaks else still_html(widget), 'text': repr(widget)}


def name_in(view: Any) -> str:
    """Give the name of the node that a view names in its repr, or what it says in its place."""
    return re.match(r'<\w+: ([^,>]+)', repr(view))[1]


def still_html(widget: Any) -> str:
    """Give the HTML that a tree of widgets holds, as it stands."""
    if isinstance(widget, widgets.Box):
        # The views' style sheets go by these names.
        return f'<div class="{" ".join(widget._dom_classes)}">{"".join(map(still_html, widget.children))}</div>'
    if isinstance(widget, (widgets.HTML, widgets.HTMLMath)):
        return f'<div class="{" ".join(widget._dom_classes)}">{widget.value}</div>'
    return ''


class NodeLogTap:
    """Tells which lines a node logged since it was asked last; for nodes of this process only."""

    def __init__(self, node: Node):
        self._node = node
        self._lines: list[LogLine] = []
        self._arrived = threading.Event()
        self.stop = stage.current().node_log.on_line(self._take)

    def _take(self, line: LogLine) -> None:
        if line.logger != self._node.get_logger().name:
            return
        if line.text == _MARK:
            self._arrived.set()
        else:
            self._lines.append(line)

    def lines(self) -> list[str]:
        """Give the lines that have come since the last call, oldest first."""
        # What one publisher sends keeps its order: when the mark is here, so is all that came before.
        self._arrived.clear()
        self._node.get_logger().fatal(_MARK)
        if not self._arrived.wait(5.0):
            raise RuntimeError(f'the log of {self._node.get_name()} does not arrive')
        lines, self._lines = self._lines, []
        return list(map(str, lines))


class EventTap:
    """Tells what a node has published on /parameter_events since it was asked last."""

    def __init__(self, node: str):
        self._node = node
        self._events: list[ParameterEvent] = []
        self._arrived = threading.Condition()
        self.stop = stage.current().on_parameter_event(self._take)

    def _take(self, event: ParameterEvent) -> None:
        if event.node == self._node:
            with self._arrived:
                self._events.append(event)
                self._arrived.notify_all()

    def rows(self, count: int) -> list[list[str]]:
        """Wait for so many messages, and give what they tell as an EventView writes it: what, parameter, value."""
        with self._arrived:
            if not self._arrived.wait_for(lambda: len(self._events) >= count, 5.0):
                raise RuntimeError(f'{self._node} has told of {len(self._events)} changes and not of {count}')
            events, self._events = self._events, []
        return [[change.kind, change.name, '' if change.kind == 'deleted' else repr(change.value)]
                for event in events for change in told_by(event)]


def node_here(name: str) -> Node | None:
    """Give the node of this process that has a full name, if there is one."""
    return next((node for node in stage.current().nodes if node.get_fully_qualified_name() == name), None)


def record_log(view: LogView) -> dict[str, Any]:
    """Record the lines that a log view shows, when all that the nodes have logged so far has arrived."""
    for node in stage.current().nodes:
        tap = NodeLogTap(node)
        tap.lines()
        tap.stop()
    return {'kind': 'log', 'node': name_in(view), 'lines': [line for line in view.lines if _MARK not in line]}


def record_robot(view: RobotView) -> dict[str, Any]:
    """Record the robot as it stands, and its drive."""
    name = name_in(view)
    robot = node_here(name)
    if not isinstance(robot, ClawbotNode):
        return {'kind': 'still', 'html': still_html(view), 'text': view.text}
    robot.step(math.inf)
    shown = look_of(robot)
    return {'kind': 'robot', 'node': name, 'look': shown, 'films': [{'changed': {}, 'look': shown, **drive(robot)}]}


Film = dict[str, Any]


def look_of(robot: ClawbotNode) -> dict[str, str]:
    """Give the robot as it stands."""
    picture, text, sentence = still(robot)
    return {'picture': picture, 'text': text, 'sentence': sentence}


def drive(robot: ClawbotNode) -> Film:
    """Let the robot drive with the parameters that it has, and give what there is to see; it is at its goal then."""
    robot.drive()
    seen = film(robot, 'robot-NAME')
    robot.step(math.inf)
    return {'picture': seen.picture, 'end': seen.end, 'scenes': [list(scene) for scene in seen.scenes]}


class CannotRestoreError(Exception):
    """A node does not take back a value that it had."""


class PanelRecorder:
    """Records the answers of the node behind one panel."""

    def __init__(self, panel: ParameterPanel, literals: list[Any], *, events: bool = False):
        self._panel = panel
        self._literals = literals
        self._client = ParameterClient(panel.node)
        self._node = node_here(panel.node)
        self._tap = NodeLogTap(self._node) if self._node else None
        self._events = EventTap(panel.node) if events else None
        self._robot = self._node if isinstance(self._node, ClawbotNode) else None
        self._all_names: list[str] = []
        self._shown: dict[str, Any] = {}
        self._descriptors: dict[str, Descriptor] = {name: panel[name].descriptor for name in panel.names}
        # A view like those of the lesson's, of which the page wants a picture for each answer.
        self._steps = StepResponseView(panel.node) if isinstance(self._node, PidControllerNode) else None
        self._looks: Any = None
        self._asked = 0

    def record(self) -> dict[str, Any]:
        """Ask for everything, and give the answers."""
        recording: dict[str, Any] = {'kind': 'panel', 'node': self._panel.node, 'status': self._panel.status,
                                     'rows': [self._row(name) for name in self._panel.names]}
        if self._panel.status:
            return recording
        self._all_names = self._client.list_parameters()
        self._shown = self._read()
        if self._robot:
            self._robot.step(math.inf)
        if self._tap:
            self._tap.lines()
        try:
            self._ask_all(recording)
        except CannotRestoreError:
            recording['incomplete'] = True
        recording['asked'] = self._asked
        for tap in (self._tap, self._events):
            if tap:
                tap.stop()
        return recording

    def _ask_all(self, recording: dict[str, Any]) -> None:
        looks: dict[str, Any] = {}
        for row in recording['rows']:
            if row['locked']:
                continue
            row['answers'] = {}
            for text in self._candidates(row):
                row['answers'][text] = answer = self._ask(row['name'], text, self._shown)
                if self._looks and 'value' in answer:
                    looks[text_key({row['name']: answer['value']})] = self._looks
        self._find_dependence(recording['rows'])
        choices = list(self._choices(recording['rows'])) if self._robot or self._steps else []
        # All pictures of the robot where it stands come first: from its first drive on it stands elsewhere.
        self._look_at(choices, looks)
        pictures = [{'changed': changed, 'look': looks[text_key(changed)]} for changed in choices]
        if self._robot:
            recording['films'] = [{**picture, **film} for picture, film in zip(pictures, self._drives(choices))]
        if self._steps:
            recording['pictures'] = pictures
            self._steps.close()

    # -- one question ----------------------------------------------------------------------------------

    def _read(self) -> dict[str, Any]:
        return dict(self._client.get_parameters(self._all_names))

    def _ask(self, name: str, text: str, state: dict[str, Any]) -> dict[str, Any]:
        """Ask for what a hand would have typed, and give the node back what it had.

        :param state: The values that the node has.
        :return: 'value', as the panel then shows it, or the 'reason' of a refusal; 'also', what else has changed;
            'log', the lines that the node logged, None if nobody can know; 'events', what it told on
            /parameter_events, if that is wanted.
        :raises CannotRestoreError: the node does not take back what it had.
        """
        self._asked += 1
        descriptor = self._descriptors[name]
        try:
            value = parse_value(descriptor, text)
        except ValueError as error:
            return {'reason': str(error), 'log': []}
        try:
            result = self._client.set_parameter(name, value)
            reason = '' if result.successful else result.reason or 'The node gave no reason.'
        except ParameterToolError as error:
            reason = words_of(error)
        after = self._read()
        answer: dict[str, Any] = {'reason': reason} if reason else {'value': format_value(descriptor, after[name])}
        also = {other: format_value(self._descriptors[other], after[other]) for other in self._descriptors
                if (other != name or reason) and not values.same(state[other], after[other])}
        if also:
            answer['also'] = also
        answer['log'] = self._tap.lines() if self._tap else None
        if self._events:
            answer['events'] = self._events.rows(0 if reason else 1)
        if not reason:
            # Before it is given back: what the node's picture looks like with this value.
            self._looks = self._look()
        self._restore(state, after)
        return answer

    def _restore(self, wanted: dict[str, Any], now: dict[str, Any]) -> None:
        for attempt in (self._client.set_parameters, self._client.set_parameters_atomically):
            different = {name: value for name, value in wanted.items() if not values.same(now[name], value)}
            if not different:
                return
            attempt(different)
            now = self._read()
            if self._events:
                self._events.rows(len(different) if attempt == self._client.set_parameters else 1)
            if self._tap:
                self._tap.lines()
        if any(not values.same(now[name], value) for name, value in wanted.items()):
            raise CannotRestoreError

    def _enter(self, changed: dict[str, str]) -> dict[str, Any]:
        """Bring the node into another state, and give it."""
        for name, text in changed.items():
            self._client.set_parameter(name, parse_value(self._descriptors[name], text))
        if self._tap:
            self._tap.lines()
        if self._events:
            self._events.rows(len(changed))
        return self._read()

    # -- what to ask for -------------------------------------------------------------------------------

    def _row(self, name: str) -> dict[str, Any]:
        control = self._panel[name]
        descriptor, value = control.descriptor, control.value
        editor, group = editor_class(descriptor, value), group_of(name)
        row = {'name': name, 'label': name.removeprefix(f'{group}.') if group else name,
               'group': HOUSEKEEPING_HEADING if is_housekeeping(name) else group, 'quiet': is_housekeeping(name),
               'help': help_markup(descriptor), 'text': format_value(descriptor, value), 'message': control.message,
               'type': descriptor.type.label, 'locked': descriptor.read_only or bool(self._panel.status),
               'editor': 'check' if editor is CheckBoxEditor else 'lines' if editor is LinesEditor else 'text'}
        if issubclass(editor, IntegerSliderEditor):
            many = sum(self._panel[each].descriptor.range is not None for each in self._panel.names) > _MANY_SLIDERS
            row['positions'] = [format_value(descriptor, each) for each in
                                positions(descriptor, value, issubclass(editor, DoubleSliderEditor),
                                          _POSITIONS_OF_MANY if many else _POSITIONS)]
        return row

    def _candidates(self, row: dict[str, Any]) -> list[str]:
        """Give what is asked for, as a hand types it."""
        if row['editor'] == 'check':
            return ['true', 'false']
        descriptor, value = self._descriptors[row['name']], self._shown[row['name']]
        # Where any type goes, those of all types may be tried; the range's ends, and what lies just beyond them.
        texts = [row['text'], *row.get('positions', ()), *_near_the_ends(descriptor),
                 *_TYPED[values.NOT_SET if descriptor.dynamic_typing else descriptor.type]]
        texts += [text for literal in self._literals if (text := _as_typed(descriptor, literal)) is not None]
        if isinstance(value, list) and value:
            texts += [format_value(descriptor, each) for each in (value[:-1], [*value, value[-1]], value[::-1])]
        return list(dict.fromkeys(texts))

    # -- does it depend on the others? -----------------------------------------------------------------

    def _find_dependence(self, rows: list[dict[str, Any]]) -> None:
        rows = [row for row in rows if 'answers' in row]
        samples = {row['name']: _samples(row) for row in rows}
        for changed in rows:
            if changed['quiet']:
                continue
            for text in _spread(_accepted(changed), _CONTEXTS):
                state = self._enter({changed['name']: text})
                for row in rows:
                    if not row['quiet'] and changed['name'] not in row.get('depends', ()):
                        self._compare(row, samples[row['name']], state, changed['name'])
                self._restore(self._shown, state)
        for row in rows:
            for other in row.get('depends', ()):
                self._record_dependent(row, next(each for each in rows if each['name'] == other))

    def _compare(self, row: dict[str, Any], samples: list[str], state: dict[str, Any], changed: str) -> None:
        """Ask for samples from another state, and note whether that makes a difference."""
        for sample in samples:
            answer, before = self._ask(row['name'], sample, state), row['answers'][sample]
            if _gist(answer) != _gist(before):
                row.setdefault('depends', []).append(changed)
                return
            if answer['log'] != before['log']:
                row['log_depends'] = True

    def _record_dependent(self, row: dict[str, Any], other: dict[str, Any]) -> None:
        """Record the answers once more, from some of the states in which the other parameter may be."""
        contexts = row.setdefault('contexts', {}).setdefault(other['name'], {})
        # Where it stands, the stretch of the slider, and one of each kind of answer.
        texts = list(dict.fromkeys([row['text'], *_spread(row.get('positions') or list(row['answers']),
                                                          _SAMPLES_OF_DEPENDENT), *_samples(row)]))
        for text in _spread(_accepted(other), _CONTEXTS_OF_DEPENDENT):
            state = self._enter({other['name']: text})
            contexts[other['answers'][text]['value']] = {each: self._ask(row['name'], each, state) for each in texts}
            self._restore(self._shown, state)

    # -- pictures of the node --------------------------------------------------------------------------

    def _look(self) -> Any:
        """Give what a view of the node shows now; None if the course has no view of such a node."""
        if self._robot:
            return look_of(self._robot)
        if self._steps:
            self._steps.settle()
            return re.sub(r'<style>.*?</style>', '', still_html(self._steps), flags=re.DOTALL)
        return None

    def _look_at(self, choices: list[dict[str, str]], looks: dict[str, Any]) -> None:
        """Take the pictures that no answer has brought yet."""
        for changed in choices:
            if text_key(changed) not in looks:
                state = self._enter(changed)
                looks[text_key(changed)] = self._look()
                self._restore(self._shown, state)

    def _drives(self, choices: list[dict[str, str]]) -> Iterator[Film]:
        for changed in choices:
            state = self._enter(changed)
            yield drive(self._robot)
            self._restore(self._shown, state)
            # One that had to wait goes on by itself now; the next one must not find it on its way.
            self._robot.step(math.inf)

    def _choices(self, rows: list[dict[str, Any]]) -> Iterator[dict[str, str]]:
        """Give the sets of changed parameters that are to be seen: none, each alone, and some together."""
        shown = {row['name']: row['text'] for row in rows}
        moving = {row['name']: row for row in rows if 'answers' in row and not row['quiet']
                  and (row['editor'] == 'check' or 'positions' in row)}
        seen = set()
        for choice in itertools.chain([{}], self._single(moving), _together(moving)):
            changed = {name: text for name, text in choice.items() if text != shown[name]}
            if text_key(changed) not in seen:
                seen.add(text_key(changed))
                yield changed

    def _single(self, rows: dict[str, dict[str, Any]]) -> Iterator[dict[str, str]]:
        for name, row in rows.items():
            texts = ['true', 'false'] if row['editor'] == 'check' else row['positions']
            for text in texts:
                if 'value' in row['answers'][text]:
                    yield {name: row['answers'][text]['value']}


def text_key(changed: dict[str, str]) -> str:
    """Give a name for a set of changed parameters, whatever their order."""
    return '\n'.join(f'{name}={text}' for name, text in sorted(changed.items()))


def positions(descriptor: Descriptor, value: Any, double: bool, at_most: int) -> list[Any]:
    """Give the values at which a page's slider can stand: those of the panel's, or a spread of them."""
    limits = descriptor.range
    if double:
        scale = Positions(limits)
        count, give = scale.last + 1, scale.value
    else:
        step = max(1, limits.step)
        count, give = (limits.to_value - limits.from_value) // step + 1, lambda index: limits.from_value + index * step
    # Whole strides, so that the values stay round; the end and the value shown are always among them.
    stride = max(1, math.ceil((count - 1) / (at_most - 1)))
    stride = next(each for each in _round_numbers() if each >= stride)
    chosen = {give(index) for index in range(0, count, stride)} | {give(count - 1), value}
    return sorted(chosen)


def _round_numbers() -> Iterator[int]:
    for power in itertools.count():
        yield from (10**power, 2 * 10**power, 5 * 10**power)


def _near_the_ends(descriptor: Descriptor) -> list[str]:
    limits = descriptor.range
    if limits is None:
        return []
    step = limits.step or (1 if descriptor.type is values.INTEGER else 0.01)
    near = [end + sign * distance for end in (limits.from_value, limits.to_value) for sign in (-1, 1)
            for distance in (0, step, step / 2)]
    if descriptor.type is values.INTEGER:
        near = [math.floor(each) for each in near]
    else:
        near = [round(float(each), 9) for each in near]
    return [format_value(descriptor, each) for each in near]


def _as_typed(descriptor: Descriptor, literal: Any) -> str | None:
    """Write a value of the lesson's as a hand would, if the parameter could have it."""
    if descriptor.type is values.DOUBLE and type(literal) is int:
        literal = float(literal)
    try:
        normal = values.normalise(literal)
        if values.type_of(normal) is not descriptor.type and not descriptor.dynamic_typing:
            return None
        return format_value(descriptor, normal)
    except Exception:  # whatever it is that the lesson speaks of, it is no value
        return None


def _accepted(row: dict[str, Any]) -> list[str]:
    """Give the texts that the node accepted and that change something."""
    return [text for text, answer in row['answers'].items() if answer.get('value', row['text']) != row['text']]


def _spread(texts: list[str], count: int) -> list[str]:
    if len(texts) <= count:
        return list(texts)
    return [texts[round(index * (len(texts) - 1) / (count - 1))] for index in range(count)]


def _samples(row: dict[str, Any]) -> list[str]:
    """Choose texts with all kinds of answers."""
    refused: dict[str, str] = {}
    for text, answer in row['answers'].items():
        if answer.get('reason'):
            # One for each wording: reasons that differ in numbers are alike.
            refused.setdefault(''.join(each for each in answer['reason'] if each.isalpha() or each == ' '), text)
    return [row['text'], *_spread(_accepted(row), _SAMPLES), *_spread(list(refused.values()), _SAMPLES)]


def _gist(answer: dict[str, Any]) -> tuple:
    return answer.get('value'), answer.get('reason'), answer.get('also')


def _together(rows: dict[str, dict[str, Any]]) -> Iterator[dict[str, str]]:
    """Give combinations of values: of all parameters if they are few, of each two otherwise."""
    def some(row: dict[str, Any], count: int) -> list[str]:
        texts = ['true', 'false'] if row['editor'] == 'check' else row['positions']
        taken = [text for text in texts if 'value' in row['answers'][text]]
        return list(dict.fromkeys([row['text'], *_spread(taken, count)]))

    for count in _SPREADS:
        choices = {name: some(row, count) for name, row in rows.items()}
        if math.prod(map(len, choices.values())) <= _DRIVES_TOGETHER:
            for chosen in itertools.product(*choices.values()):
                yield dict(zip(choices, chosen))
            return
    for (one, first), (two, second) in itertools.combinations(rows.items(), 2):
        for chosen in itertools.product(some(first, 3), some(second, 3)):
            yield dict(zip((one, two), chosen))
