"""Launch files in XML and YAML: the same actions as in Python, with substitutions written as ``$(var name)``."""

import shlex
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any, List, get_args  # noqa: UP035  # as the types of parameters are written
from xml.parsers import expat

import yaml

from param_tools.cli.launch import actions, ros_actions
from param_tools.cli.launch.actions import Action, LaunchDescription
from param_tools.cli.launch.conditions import IfCondition, UnlessCondition
from param_tools.cli.launch.context import LaunchFailed, Origin, blaming, reject
from param_tools.cli.launch.parameters import ParameterFile, Parameters, ParameterValue
from param_tools.cli.launch.substitutions import TextSubstitution, as_bool
from param_tools.cli.launch.text import parse_text, unescape

_SCALARS = {'int': int, 'float': float, 'bool': bool, 'str': str}
# What type= of a parameter may be.
_TYPES: dict[str, Any] = {'yaml': None, **_SCALARS, **{f'list_of_{name}': List[each]  # type: ignore[valid-type]  # noqa: UP006
                                         for name, each in _SCALARS.items()}}
# What launch files of ROS 1 have, and ROS 2 has not, each with what to write.
_ROS_1 = {
    'type': 'exec="..."', 'ns': 'namespace="..." of a <node>, and <push_ros_namespace> in a <group>',
    'rosparam': '<param from="file.yaml"/> in a <node>', 'param': '<param> in a <node>, and <set_parameter> for all '
    'later nodes', 'remap': '<remap> in a <node>, and <set_remap> for all later nodes', 'env': '<set_env>',
    'required': 'on_exit="shutdown"'}


class Entity:
    """An element of XML, or a key of YAML with what is below it."""

    def __init__(self, tag: str, attributes: Mapping[str, Any], children: 'Iterable[Entity]', origin: Origin, *,
                 is_text: bool):
        self.tag, self.origin = tag, origin
        self._attributes = dict(attributes)
        self._children = list(children)
        self.is_text = is_text
        """True if all values are texts, as in XML, and not what YAML makes of them."""

    def take(self, name: str) -> Any:
        """Return an attribute, which then counts as read; None if there is none."""
        return self._attributes.pop(name, None)

    def need(self, name: str) -> Any:
        """Return an attribute that has to be there."""
        found = self.take(name)
        if found is None:
            with blaming(self.origin):
                _expect_ros_2(self.tag, self._attributes if name == 'exec' else ())
                raise LaunchFailed(f"Attribute '{name}' not found in Entity '{self.tag}'")
        return found

    def children(self, tag: str | None = None) -> 'list[Entity]':
        """Return the entities below it with a name, or all that are left; they then count as read."""
        found = [each for each in self._children if tag in (None, each.tag)]
        self._children = [each for each in self._children if each not in found]
        return found

    def end(self) -> None:
        """Expect that all of it was read."""
        with blaming(self.origin):
            left = [*self._attributes, *(each.tag for each in self._children)]
            _expect_ros_2(self.tag, left)
            if left:
                reject(f'attribute or nested tag {", ".join(map(repr, left))} in `{self.tag}`')


def _expect_ros_2(tag: str, names: Iterable[str]) -> None:
    for name in names:
        if name in _ROS_1:
            raise LaunchFailed(f'launch rejects {name!r} in `{tag}`, which is syntax of ROS 1: ROS 2 has '
                               f'{_ROS_1[name]}')


def _from_xml(path: Path) -> Entity:
    # What is open, each with the arguments of its Entity; below all of them, a place for the root.
    elements: list[tuple[str, dict[str, str], list[Entity], Origin]] = [('', {}, [], Origin(path, 1))]

    def end(_tag: str) -> None:
        entity = Entity(*elements.pop(), is_text=True)
        elements[-1][2].append(entity)

    parser = expat.ParserCreate()
    parser.StartElementHandler = lambda tag, attributes: elements.append(
        (tag, attributes, [], Origin(path, parser.CurrentLineNumber)))
    parser.EndElementHandler = end
    parser.Parse(path.read_text(encoding='utf-8'), True)
    return elements[0][2][0]


class _LineLoader(yaml.SafeLoader):
    """Keeps the line of each map, counted from 1, under the key None."""

    def construct_mapping(self, node: yaml.MappingNode, deep: bool = False) -> dict[Any, Any]:
        return super().construct_mapping(node, deep) | {None: node.start_mark.line + 1}


def _from_yaml(path: Path) -> Entity:
    def children(found: Any, where: str) -> list[Entity]:
        if not isinstance(found, list) or not all(isinstance(each, dict) and len(each) == 2 for each in found):
            raise LaunchFailed(f'what is below {where!r} has to be a list of entries with one key each')
        return [entity(key, below, each[None]) for each in found for key, below in each.items() if key is not None]

    def entity(tag: str, content: Any, line: int) -> Entity:
        origin = Origin(path, line)
        if isinstance(content, list):
            return Entity(tag, {}, children(content, tag), origin, is_text=False)
        if not isinstance(content, dict):
            raise LaunchFailed(f'{tag!r} needs keys below it, and has {content!r}')
        attributes, below = {}, []
        for key, value in content.items():
            if key == 'children':
                below += children(value, tag)
            elif isinstance(value, list) and value and isinstance(value[0], dict):
                below += [entity(key, each, each[None]) for each in value]
            elif key is not None:
                attributes[key] = value
        return Entity(tag, attributes, below, origin, is_text=False)

    found = yaml.load(path.read_text(encoding='utf-8'), _LineLoader)
    if not isinstance(found, dict) or len(found) != 2:
        raise LaunchFailed("a launch file in YAML has one key at the top, which is 'launch'")
    return children([found], '')[0]


READERS: dict[str, Callable[[Path], Entity]] = {'.xml': _from_xml, '.yaml': _from_yaml, '.yml': _from_yaml}


def load(path: Path) -> LaunchDescription:
    """Return what a launch file describes."""
    try:
        root = READERS[path.suffix](path)
        if root.tag != 'launch':
            raise LaunchFailed(f"Expected 'launch' as root tag, and {path.name} has {root.tag!r}")
        return LaunchDescription(_actions(root.children()), deprecated_reason=root.take('deprecated'))
    except LaunchFailed as error:
        error.origin = error.origin or Origin(path, None)
        raise
    # The last one is a quotation mark that nothing closes, in a command line, or a file that is no text.
    except (OSError, expat.ExpatError, yaml.YAMLError, ValueError) as error:
        mark, kind = getattr(error, 'problem_mark', None), path.suffix[1:]
        with blaming(Origin(path, mark.line + 1 if mark else getattr(error, 'lineno', None))):
            raise LaunchFailed(f'Caught exception when trying to load file of format [{kind}]: {error}') from None


def _actions(entities: Iterable[Entity]) -> list[Action]:
    found = []
    for entity in entities:
        with blaming(entity.origin):
            if entity.tag not in _ACTIONS:
                _expect_ros_2('launch', [entity.tag])
                reject(f'action `{entity.tag}`')
            action = _ACTIONS[entity.tag](entity)
            action.origin = entity.origin
            _add_condition(entity, action)
            entity.end()
        found.append(action)
    return found


def _add_condition(entity: Entity, action: Any) -> None:
    wanted, unwanted = entity.take('if'), entity.take('unless')
    if wanted is not None and unwanted is not None:
        raise LaunchFailed("if and unless conditions can't be used simultaneously")
    if wanted is not None:
        action.condition = IfCondition(_text(entity, wanted))
    if unwanted is not None:
        action.condition = UnlessCondition(_text(entity, unwanted))


def _text(entity: Entity, value: Any) -> Any:
    """Return the substitutions that are in an attribute; None if there is no attribute."""
    if value is None:
        return None
    if not isinstance(value, str):
        raise LaunchFailed(f'an attribute of {entity.tag!r} has to be a text, and is {value!r}: put quotes around it')
    return parse_text(value)


def _number(entity: Entity, name: str) -> float | None:
    found = entity.take(name)
    try:
        return None if found is None else float(found)
    except ValueError:
        raise LaunchFailed(f"Attribute '{name}' of Entity '{entity.tag}' has to be a number, not {found!r}") from None


def _flag(entity: Entity, name: str) -> bool | None:
    found = entity.take(name)
    return found if found is None or isinstance(found, bool) else as_bool(found)


def _given(**options: Any) -> dict[str, Any]:
    """Return the options that are not None."""
    return {name: value for name, value in options.items() if value is not None}


def _pairs(entities: Iterable[Entity], first: str, second: str) -> list[tuple[Any, Any]]:
    found = []
    for entity in entities:
        with blaming(entity.origin):
            found.append((tuple(_text(entity, entity.need(first))), _text(entity, entity.need(second))))
            entity.end()
    return found


def _words(entity: Entity, text: str | None) -> list[Any] | None:
    """Return the words of a command line, each with the substitutions in it."""
    words: list[list[Any]] = []
    is_open = False  # what comes next belongs to the last word
    for part in [] if text is None else _text(entity, text):
        if not isinstance(part, TextSubstitution):
            if not is_open:
                words.append([])
            words[-1].append(part)
            is_open = True
            continue
        split = shlex.split(part.text)
        is_open = is_open and not part.text[:1].isspace()
        for number, word in enumerate(split):
            if not is_open or number:
                words.append([])
            words[-1].append(TextSubstitution(text=word))
        is_open = bool(part.text) and not part.text[-1].isspace()
    return None if text is None else words


def _process(entity: Entity) -> dict[str, Any]:
    on_exit = entity.take('on_exit')
    if on_exit not in (None, 'shutdown'):
        raise LaunchFailed(f'Attribute on_exit of Entity {entity.tag} expected to be shutdown but got `{on_exit}`')
    respawn = entity.take('respawn')
    return _given(
        on_exit=None if on_exit is None else actions.Shutdown(), prefix=_text(entity, entity.take('launch-prefix')),
        respawn=respawn if isinstance(respawn, bool) else _text(entity, respawn),
        respawn_max_retries=_number(entity, 'respawn_max_retries'), shell=_flag(entity, 'shell'),
        sigterm_timeout=_number(entity, 'sigterm_timeout'), sigkill_timeout=_number(entity, 'sigkill_timeout'),
        respawn_delay=_number(entity, 'respawn_delay'), output=_text(entity, entity.take('output')),
        cwd=_text(entity, entity.take('cwd')), emulate_tty=_flag(entity, 'emulate_tty'),
        additional_env=dict(_pairs(entity.children('env'), 'name', 'value')) or None)


def _node_options(entity: Entity) -> dict[str, Any]:
    return _process(entity) | _given(
        package=_text(entity, entity.take('pkg')), executable=_text(entity, entity.need('exec')),
        name=_text(entity, entity.take('name')), namespace=_text(entity, entity.take('namespace')),
        arguments=_words(entity, entity.take('args')),
        ros_arguments=_words(entity, entity.take('ros_args')), parameters=_parameters(entity),
        remappings=_pairs(entity.children('remap'), 'from', 'to'))


def _parameters(entity: Entity) -> list[Any]:
    found: list[Any] = []
    for each in entity.children('param'):
        with blaming(each.origin):
            found.append(_parameter(each))
    return found


def _parameter(entity: Entity) -> Any:
    path = entity.take('from')
    if path is None:
        return Parameters(_named_value(entity), entity.origin)
    allows = _flag(entity, 'allow_substs')
    entity.end()
    return ParameterFile(_text(entity, path), allow_substs=bool(allows))


def _named_value(entity: Entity) -> dict[Any, Any]:
    """Return a parameter with its value, or with the parameters below it."""
    name = tuple(_text(entity, entity.need('name')))
    word, value = entity.take('type'), entity.take('value')
    if word is not None and word not in _TYPES:
        raise LaunchFailed(f'a parameter has the type {word!r}; the types are {", ".join(_TYPES)}')
    below = entity.children('param')
    entity.end()
    if value is None and not below:
        raise LaunchFailed('either a value attribute or nested params are needed')
    if below and (value is not None or word is not None):
        raise LaunchFailed('nested parameters exclude value and type')
    if below:
        return {name: {key: each for inner in below for key, each in _named_value(inner).items()}}
    wanted = None if word is None else _TYPES[word]
    return {name: ParameterValue(_value(value, entity, wanted), value_type=wanted)}


def _value(value: Any, entity: Entity, wanted: Any) -> Any:
    """Return a value, or the substitutions that stand for one."""
    if isinstance(value, list):
        _expect_one_type(value)
        return [_value(each, entity, *(get_args(wanted) or [None])) for each in value]
    found = _converted(value, wanted) if entity.is_text else value
    if isinstance(found, list):
        _expect_one_type(found)
        return [_parsed(each) for each in found]
    return _parsed(found)


def _expect_one_type(found: list[Any]) -> None:
    """Expect a list as launch takes it in XML and in YAML: beside texts of one type, where True is an integer, too."""
    kind = next((type(each) for each in found if not isinstance(each, str)), str)
    if not all(isinstance(each, (kind, str)) for each in found):
        remedy = 'write each number with a dot' if {*map(type, found)} <= {int, float} else 'one type for all'
        raise LaunchFailed(f'launch rejects the list {found!r}, whose elements are of several types: {remedy}')


def _converted(text: str, wanted: Any) -> Any:
    """Return what launch makes of an attribute in XML; a text that is nothing else stays one."""
    if wanted is str or not text:
        return text
    try:
        if wanted in (int, float):
            return wanted(text)
        if wanted is bool and text in ('1', '0'):
            return text == '1'
        found = yaml.safe_load(text)
    except (ValueError, yaml.YAMLError):
        return text
    if not isinstance(found, (bool, int, float, str, list)):
        raise LaunchFailed(f"Attribute 'value' of Entity 'param' cannot be {text!r}: as YAML that is no value of a "
                           f"parameter; type='str' keeps it a text")
    return found


def _parsed(value: Any) -> Any:
    """Return the substitutions in a text; a text without any, and another value, as it is."""
    if not isinstance(value, str):
        return value
    parts = parse_text(value)
    first, = parts if len(parts) == 1 else [None]
    return first.text if isinstance(first, TextSubstitution) else parts


def _composable(entity: Entity) -> list[ros_actions.ComposableNode]:
    found = []
    for each in entity.children('composable_node'):
        with blaming(each.origin):
            node = ros_actions.ComposableNode(**_given(
                package=_text(each, each.need('pkg')), plugin=_text(each, each.need('plugin')),
                name=_text(each, each.take('name')), namespace=_text(each, each.take('namespace')),
                parameters=_parameters(each), remappings=_pairs(each.children('remap'), 'from', 'to')))
            node.origin = each.origin
            each.children('extra_arg')
            _add_condition(each, node)
            each.end()
        found.append(node)
    return found


def _argument(entity: Entity) -> Action:
    choices = [unescape(each.need('value')) for each in entity.children('choice')]
    description = entity.take('description')
    return actions.DeclareLaunchArgument(
        unescape(entity.need('name')), default_value=_text(entity, entity.take('default')), choices=choices or None,
        description=None if description is None else unescape(description))


def _group(entity: Entity) -> Action:
    scoped = _flag(entity, 'scoped')
    return actions.GroupAction(_actions(entity.children()), **_given(scoped=scoped))


def _timer(entity: Entity) -> Action:
    period = entity.need('period')
    return actions.TimerAction(period=_text(entity, period) if isinstance(period, str) else float(period),
                               actions=_actions(entity.children()))


def _with_texts(make: Callable[..., Action], *names: str, **optional: str) -> Callable[[Entity], Action]:
    """Return a function that makes an action of attributes that are texts.

    :param names: The attributes that have to be there, in the order in which the action takes them.
    :param optional: The name of an option of the action, and the attribute for it.
    """
    def made(entity: Entity) -> Action:
        return make(*(_text(entity, entity.need(name)) for name in names),
                    **_given(**{option: _text(entity, entity.take(name)) for option, name in optional.items()}))

    return made


# What each tag stands for.
_ACTIONS: dict[str, Callable[[Entity], Action]] = {
    'arg': _argument,
    'let': _with_texts(actions.SetLaunchConfiguration, 'name', 'value'),
    'include': lambda entity: actions.IncludeLaunchDescription(
        _text(entity, entity.need('file')), launch_arguments=_pairs(entity.children('arg'), 'name', 'value')),
    'group': _group,
    'node': lambda entity: ros_actions.Node(**_node_options(entity)),
    'executable': lambda entity: actions.ExecuteProcess(
        cmd=_words(entity, entity.need('cmd')) or [], **_process(entity),
        **_given(name=_text(entity, entity.take('name')))),
    'push_ros_namespace': _with_texts(ros_actions.PushROSNamespace, 'namespace'),
    'push-ros-namespace': _with_texts(ros_actions.PushROSNamespace, 'namespace'),
    'set_parameter': _with_texts(ros_actions.SetParameter, 'name', 'value'),
    'set_parameters_from_file': _with_texts(ros_actions.SetParametersFromFile, 'filename'),
    'set_remap': _with_texts(ros_actions.SetRemap, 'from', 'to'),
    'set_env': _with_texts(actions.SetEnvironmentVariable, 'name', 'value'),
    'append_env': _with_texts(actions.AppendEnvironmentVariable, 'name', 'value', separator='separator',
                              prepend='prepend'),
    'log': _with_texts(actions.LogInfo, 'message'),
    'timer': _timer,
    'node_container': lambda entity: ros_actions.ComposableNodeContainer(
        composable_node_descriptions=_composable(entity), **_node_options(entity)),
    'load_composable_node': lambda entity: ros_actions.LoadComposableNodes(
        composable_node_descriptions=_composable(entity), target_container=_text(entity, entity.need('target'))),
}
