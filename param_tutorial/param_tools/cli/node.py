"""ros2 node list."""

import argparse

from param_tools.cli.session import Commands, Session, add_discovery_options, add_verbs


def add_to(commands: Commands) -> None:
    verbs = add_verbs(commands, 'node', 'nodes in the graph')
    listing = verbs.add_parser('list', help='list the nodes')
    add_discovery_options(listing)
    listing.add_argument('-a', '--all', action='store_true', help='hidden nodes, too')
    listing.add_argument('-c', '--count-nodes', action='store_true', help='only how many there are')
    listing.set_defaults(verb=list_nodes)


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
