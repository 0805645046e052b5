"""ros2 service list."""

import argparse

from rclpy.topic_or_service_is_hidden import topic_or_service_is_hidden

from param_tools.cli.param import listed_nodes
from param_tools.cli.session import Commands, Session, add_discovery_options


def add_to(commands: Commands) -> None:
    service = commands.add_parser('service', help='services in the graph')
    service.set_defaults(help_of=service)
    service.add_argument('--include-hidden-services', action='store_true', help='hidden services, too')
    listing = service.add_subparsers(metavar='verb', title='verbs').add_parser('list', help='list the services')
    add_discovery_options(listing)
    listing.add_argument('-t', '--show-types', action='store_true', help='print the types, too')
    listing.add_argument('-c', '--count-services', action='store_true', help='only how many there are')
    listing.set_defaults(verb=list_services)


def list_services(session: Session, args: argparse.Namespace) -> None:
    session.wait_for_graph(args)
    listed_nodes(session, hidden=args.include_hidden_services)  # waits for the services of each
    services = [(name, types) for name, types in session.executor.tool_node.get_service_names_and_types()
                if (args.include_hidden_services or not topic_or_service_is_hidden(name))
                and not _is_asked_by_us_alone(session, name)]
    session.print_names_and_types(services, only_count=args.count_services, show_types=args.show_types)


def _is_asked_by_us_alone(session: Session, service: str) -> bool:
    """True for a service without a server, for which only the executor keeps a client: its node has ended."""
    tool = session.executor.tool_node
    return tool.count_services(service) == 0 and tool.count_clients(service) <= sum(
        client.srv_name == service for client in tool.clients)
