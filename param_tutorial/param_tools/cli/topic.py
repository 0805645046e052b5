"""ros2 topic list."""

import argparse

from rclpy.topic_or_service_is_hidden import topic_or_service_is_hidden

from param_tools.cli.session import Commands, Session, add_discovery_options, add_verbs


def add_to(commands: Commands) -> None:
    """Add the command ``topic`` and its verb."""
    listing = add_verbs(commands, 'topic', 'topics in the graph').add_parser('list', help='list the topics')
    add_discovery_options(listing)
    listing.add_argument('-t', '--show-types', action='store_true', help='print the types, too')
    listing.add_argument('-c', '--count-topics', action='store_true', help='only how many there are')
    listing.add_argument('--include-hidden-topics', action='store_true', help='hidden topics, too')
    listing.set_defaults(verb=list_topics)


def list_topics(session: Session, args: argparse.Namespace) -> None:
    """Print the names of all topics, or their number."""
    session.wait_for_graph(args)
    topics = [(name, types) for name, types in session.executor.tool_node.get_topic_names_and_types()
              if args.include_hidden_topics or not topic_or_service_is_hidden(name)]
    session.print_names_and_types(topics, only_count=args.count_topics, show_types=args.show_types)
