"""ros2 node list."""

import argparse

from param_tutorial.ros2.session import Commands, Session, add_discovery_options


def add_to(commands: Commands) -> None:
    """Add the command ``node`` and its verb."""
    node = commands.add_parser('node', help='nodes in the graph')
    node.set_defaults(help_of=node)
    listing = node.add_subparsers(metavar='verb', title='verbs').add_parser('list', help='list the nodes')
    add_discovery_options(listing)
    listing.add_argument('-a', '--all', action='store_true', help='hidden nodes, too')
    listing.add_argument('-c', '--count-nodes', action='store_true', help='only how many there are')
    listing.set_defaults(verb=list_nodes)


def list_nodes(session: Session, args: argparse.Namespace) -> None:
    """Print the names of all nodes, or their number."""
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
