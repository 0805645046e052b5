"""ros2 topic list and echo."""

import argparse
import queue
import sys
from typing import Any

import yaml
from rclpy.topic_or_service_is_hidden import topic_or_service_is_hidden

from param_tools.cli.session import CommandFailed, Commands, Session, add_discovery_options, add_verbs
from param_tools.ros.topics import matching_qos, message_class
from param_tools.ros.waiting import Steps

# Of what is longer, the genuine one shows so much, too.
_SHOWN_LENGTH = 128


def add_to(commands: Commands) -> None:
    verbs = add_verbs(commands, 'topic', 'topics in the graph')
    listing = verbs.add_parser('list', help='list the topics')
    add_discovery_options(listing)
    listing.add_argument('-t', '--show-types', action='store_true', help='print the types, too')
    listing.add_argument('-c', '--count-topics', action='store_true', help='only how many there are')
    listing.add_argument('--include-hidden-topics', action='store_true', help='hidden topics, too')
    listing.set_defaults(verb=list_topics)
    echoing = verbs.add_parser('echo', help='print the messages of a topic')
    add_discovery_options(echoing)
    echoing.add_argument('topic_name', help='name of the topic')
    echoing.add_argument('message_type', nargs='?',
                         help='its type, such as std_msgs/msg/String (default: what the graph says)')
    echoing.add_argument('--once', action='store_true', help='end after one message')
    echoing.add_argument('-f', '--full-length', action='store_true',
                         help=f'print arrays and texts in full (default: {_SHOWN_LENGTH} elements or characters)')
    echoing.set_defaults(verb=echo)


def list_topics(session: Session, args: argparse.Namespace) -> None:
    session.wait_for_graph(args)
    topics = [(name, types) for name, types in session.executor.tool_node.get_topic_names_and_types()
              if args.include_hidden_topics or not topic_or_service_is_hidden(name)]
    session.print_names_and_types(topics, only_count=args.count_topics, show_types=args.show_types)


def echo(session: Session, args: argparse.Namespace) -> Steps:
    """Print messages until somebody ends it."""
    if session.in_notebook and not args.once:
        instead = session.instead_of(['topic', 'echo', args.topic_name])
        raise CommandFailed(f'{instead} Or end after one message: --once')
    session.wait_for_graph(args)
    executor, node = session.executor, session.executor.tool_node
    topic = f'/{args.topic_name.lstrip("/")}'
    kind = args.message_type or _type_of(session, topic)
    message_type = message_class(kind)
    if message_type is None:
        raise CommandFailed(f"The message type '{kind}' is invalid")
    heard: queue.SimpleQueue[Any] = queue.SimpleQueue()
    subscription = executor.run(
        lambda: node.create_subscription(message_type, topic, heard.put, matching_qos(node, topic)), f'hear {topic}')
    try:
        while True:
            yield lambda: not heard.empty()
            message = _plain(heard.get(), None if args.full_length else _SHOWN_LENGTH)
            text = yaml.dump(message, allow_unicode=True, width=sys.maxsize, default_flow_style=False, sort_keys=False)
            session.print(f'{text}---')
            session.stdout.flush()
            if args.once:
                return 0
    finally:
        if executor.is_running:
            executor.run(lambda: node.destroy_subscription(subscription), f'hear no more of {topic}')


def _type_of(session: Session, topic: str) -> str:
    types = dict(session.executor.tool_node.get_topic_names_and_types()).get(topic)
    if types is None:
        session.print(f'WARNING: topic [{topic}] does not appear to be published yet')
        raise CommandFailed('Could not determine the type for the passed topic')
    if len(types) > 1:
        raise CommandFailed(f"Cannot echo topic '{topic}', as it contains more than one type: [{', '.join(types)}]")
    return types[0]


def _plain(value: Any, length: int | None) -> Any:
    """Return a message as YAML has it, with so many elements of an array, or characters of a text; None for all."""
    if isinstance(value, bytes):
        value = value.decode('latin-1')
    if isinstance(value, (bool, int, float)):
        return value
    if isinstance(value, str):
        return value if length is None or len(value) <= length else f'{value[:length]}...'
    if hasattr(value, 'get_fields_and_field_types'):
        return {name: _plain(getattr(value, name), length) for name in value.get_fields_and_field_types()}
    items = value.tolist() if hasattr(value, 'tolist') else list(value)
    shown = [_plain(each, length) for each in items[:length]]
    return shown if len(shown) == len(items) else [*shown, '...']
