"""Names of topics and services: what is wrong with one, and what a short one stands for.

Texts and positions are those of rmw's and rcl's validators, as in ``files.node_names``.
"""

import re

from param_tools.files.node_names import Flaw, as_in_c, flaw_of_namespace, flaw_of_node_name, flaw_of_path
from param_tools.rcl_in_python.exceptions import RCLError

_MAX_TOPIC = 247
_NUMBER_AFTER_SLASH = re.compile('/[0-9]')


def flaw_of_full_topic_name(name: str) -> Flaw:
    """Return what is wrong with a name of a topic or service that has been written out."""
    name = as_in_c(name)
    if not name:
        return 'topic name must not be empty', 0
    if flaw := flaw_of_path(name, 'topic name', ''):
        return flaw
    if len(name) > _MAX_TOPIC:
        return "topic length should not exceed '255U - 8U'", _MAX_TOPIC - 1
    return None


def flaw_of_topic_name(name: str) -> Flaw:
    """Return what is wrong with a name of a topic or service as somebody writes it: ``chatter``, ``~/{node}``."""
    name = as_in_c(name)
    if not name:
        return 'topic name must not be empty string', 0
    if name[0].isdigit():
        return 'topic name token must not start with a number', 0
    if name[-1] == '/':
        return 'topic name must not end with a forward slash', len(name) - 1
    return _flaw_of_characters(name) or _flaw_of_tokens(name)


def _flaw_of_characters(name: str) -> Flaw:
    """Return the first character that may not stand where it does."""
    opened: int | None = None
    for index, char in enumerate(name):
        if char == '{' and opened is None:
            opened = index
        elif char == '}':
            if opened is None:
                return "topic name must not have unmatched (unbalanced) curly braces '{}'", index
            opened = None
        elif char == '~':
            if index:
                return "topic name must not have tilde '~' unless it is the first character", index
        elif not re.match('[A-Za-z0-9_/]', char):
            if opened is not None:
                return "substitution name must not contain characters other than alphanumerics or '_'", index
            return ("topic name must not contain characters other than alphanumerics, '_', '~', '{', or '}'", index)
        elif opened is not None and char == '/':
            return "substitution name must not contain characters other than alphanumerics or '_'", index
        elif opened is not None and char.isdigit() and index == opened + 1:
            return 'substitution name must not start with a number', index
    if opened is not None:
        return "topic name must not have unmatched (unbalanced) curly braces '{}'", opened
    return None


def _flaw_of_tokens(name: str) -> Flaw:
    if name[0] == '~' and len(name) > 2 and name[1] != '/':  # rcl doesn't look at the last character here
        return "topic name must not have a tilde '~' that is not followed by a forward slash '/'", 1
    if found := _NUMBER_AFTER_SLASH.search(name):
        return 'topic name token must not start with a number', found.start() + 1
    return None


class InvalidNameError(Exception):
    """An argument is not a valid ROS name; ``subject`` names the argument."""

    def __init__(self, subject: str, reason: str):
        super().__init__(reason)
        self.subject = subject


def fully_qualified(node: str, namespace: str) -> str:
    """Return the name of a node with its namespace."""
    return f'{namespace.rstrip("/")}/{node}'


def expand(topic: str, node: str, namespace: str) -> str:
    """Return what a name of a topic or service stands for in a node.

    :raises InvalidNameError: one of the three is not valid.
    """
    for subject, flaw in (('topic name', flaw_of_topic_name(topic)), ('node name', flaw_of_node_name(node)),
                          ('node namespace', flaw_of_namespace(namespace))):
        if flaw:
            raise InvalidNameError(subject, flaw[0])
    if topic[0] == '/' and '{' not in topic:
        return topic
    if topic[0] == '~':
        topic = fully_qualified(node, namespace) + topic[1:]
    known = {'{node}': node, '{ns}': namespace, '{namespace}': namespace}

    def replace(match: re.Match[str]) -> str:
        if match[0] not in known:
            raise InvalidNameError('topic name', f'unknown substitution: {match[0]}')
        return known[match[0]]

    topic = re.sub('{.*?}', replace, topic)
    return topic if topic[0] == '/' else f'{namespace.rstrip("/")}/{topic}'


def rclpy_expand_topic_name(topic: str, node: str, namespace: str) -> str:
    try:
        return expand(topic, node, namespace)
    except InvalidNameError as error:
        name = {'topic name': topic, 'node name': node, 'node namespace': namespace}[error.subject]
        raise ValueError(f"{error.subject} '{name}' is invalid: {error}") from None


def check_node_of_graph(node: str, namespace: str, what: str) -> None:
    """:raises RCLError: these cannot be the name and the namespace of a node in the graph."""
    for flaw in (namespace and flaw_of_namespace(namespace), flaw_of_node_name(node)):
        if flaw:
            raise RCLError(f'{what}: {flaw[0]}, result: 2')
