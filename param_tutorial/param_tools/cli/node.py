"""ros2 node list and info."""

import argparse
from collections.abc import Sequence

from rclpy.node import HIDDEN_NODE_PREFIX, NodeNameNonExistentError

from param_tools.cli.session import CommandFailed, Commands, NodeName, Session, add_discovery_options, add_verbs


def add_to(commands: Commands) -> None:
    verbs = add_verbs(commands, 'node', 'nodes in the graph')
    listing = verbs.add_parser('list', help='list the nodes')
    add_discovery_options(listing)
    listing.add_argument('-a', '--all', action='store_true', help='hidden nodes, too')
    listing.add_argument('-c', '--count-nodes', action='store_true', help='only how many there are')
    listing.set_defaults(verb=list_nodes)
    info = verbs.add_parser('info', help='print the topics, services and actions of a node')
    add_discovery_options(info)
    info.add_argument('--include-hidden', action='store_true', help='hidden topics, services and actions, too')
    info.add_argument('node_name', help='full name of the node')
    info.set_defaults(verb=print_info)


def list_nodes(session: Session, args: argparse.Namespace) -> None:
    session.wait_for_graph(args)
    names = sorted(each.full_name for each in session.node_names(hidden=args.all))
    if args.count_nodes:
        session.print(len(names))
        return
    if len(set(names)) < len(names):
        session.complain('WARNING: Be aware that there are nodes in the graph that share an exact name, '
                         'which can have unintended side effects.')
    if names:
        session.print(*names, sep='\n')


def print_info(session: Session, args: argparse.Namespace) -> None:
    session.wait_for_graph(args)
    # With actions come many messages, which a list of nodes does without.
    from rclpy.action.graph import get_action_client_names_and_types_by_node as clients_of
    from rclpy.action.graph import get_action_server_names_and_types_by_node as servers_of

    count = [each.full_name for each in session.node_names(hidden=args.include_hidden)].count(args.node_name)
    if not count:
        raise CommandFailed(f"Unable to find node '{args.node_name}'")
    if count > 1:
        session.complain(f'There are {count} nodes in the graph with the exact name "{args.node_name}". '
                         f'You are seeing information about only one of them.')
    # What a node has is announced apart from its name.
    session.executor.services.find(args.node_name, 'list_parameters')
    name, namespace, _ = NodeName.parse(args.node_name)
    tool = session.executor.tool_node
    try:
        parts = [
            ('Subscribers', tool.get_subscriber_names_and_types_by_node(name, namespace)),
            ('Publishers', tool.get_publisher_names_and_types_by_node(name, namespace)),
            ('Service Servers', tool.get_service_names_and_types_by_node(name, namespace)),
            ('Service Clients', tool.get_client_names_and_types_by_node(name, namespace)),
            ('Action Servers', servers_of(tool, name, namespace)),
            ('Action Clients', clients_of(tool, name, namespace))]
    except NodeNameNonExistentError:  # it has left meanwhile
        raise CommandFailed(f"Unable to find node '{args.node_name}'") from None
    session.print(args.node_name)
    for title, entries in parts:
        session.print(f'  {title}:')
        session.print(*_lines(entries, args.include_hidden), sep='\n')  # an empty line where there are none


def _lines(entries: Sequence[tuple[str, Sequence[str]]], include_hidden: bool) -> list[str]:
    return [f'    {name}: {", ".join(types)}' for name, types in entries
            if include_hidden or f'/{HIDDEN_NODE_PREFIX}' not in name]
