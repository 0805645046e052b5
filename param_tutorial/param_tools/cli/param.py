"""ros2 param list, get, set, describe, dump, load and delete.

A value that a node rejects is no failure of the command: the reason goes to standard error, the exit status
is 0. That is so in the genuine command, and scripts rely on it.
"""

import argparse
import functools
import math
import re
from collections.abc import Callable, Sequence
from typing import Any

import yaml
from rcl_interfaces.msg import Parameter, ParameterDescriptor
from rcl_interfaces.srv import DescribeParameters, GetParameters, ListParameters, SetParameters
from rclpy.parameter import Parameter as NodeParameter
from rclpy.parameter import parameter_dict_from_yaml_file

from param_tools import values
from param_tools.cli.session import (
    SERVICE_TIMEOUT_SEC,
    CommandFailed,
    CommandParser,
    Commands,
    NodeName,
    Session,
    add_node_options,
    add_parameter_options,
    add_verbs,
    without_services,
)
from param_tools.errors import ParameterToolError
from param_tools.ros import graph, waiting
from param_tools.ros.executor import TOOL_NODE_NAME


def add_to(commands: Commands) -> None:
    verbs = add_verbs(commands, 'param', 'parameters of nodes')
    listing = verbs.add_parser('list', help='list the parameters of a node, or of all nodes')
    add_parameter_options(listing)
    listing.add_argument('--param-prefixes', nargs='+', default=[], metavar='PREFIX',
                         help='only parameters below these prefixes')
    listing.add_argument('--param-type', action='store_true', help='print the types, too')
    listing.add_argument('--filter', metavar='REGEX', help='only parameters that match this regular expression')
    listing.add_argument('node_name', nargs='?', help='name of the node')
    listing.set_defaults(verb=list_parameters)

    def add_verb(name: str, function: Callable[[Session, argparse.Namespace], int | None],
                 explanation: str) -> CommandParser:
        verb = verbs.add_parser(name, help=explanation)
        add_node_options(verb)
        verb.set_defaults(verb=function)
        return verb

    get = add_verb('get', get_parameter, 'print the value of a parameter')
    get.add_argument('--hide-type', action='store_true', help='print the value only')
    get.add_argument('parameter_name', help='name of the parameter')

    set_ = add_verb('set', set_parameter, 'set a parameter')
    set_.add_argument('parameter_name', help='name of the parameter')
    set_.add_argument('value', help='the value, written as in YAML')

    describe = add_verb('describe', describe_parameters, 'print what a node tells about parameters')
    describe.add_argument('parameter_names', nargs='+', help='names of the parameters')

    add_verb('dump', dump_parameters, 'print all parameters of a node as a parameter file')

    load = add_verb('load', load_parameters, 'set the parameters that a file holds')
    load.add_argument('parameter_file', help='the parameter file')
    load.add_argument('--no-use-wildcard', action='store_true', help="ignore what the file says for '/**'")

    delete = add_verb('delete', delete_parameter, 'undeclare a parameter with dynamic typing')
    delete.add_argument('parameter_name', help='name of the parameter')


def list_parameters(session: Session, args: argparse.Namespace) -> None:
    try:
        wanted = re.compile(args.filter or '')
    except re.error as error:
        raise CommandFailed(f'{args.filter!r} is not a regular expression: {error}') from None
    if args.node_name:
        nodes = [NodeName.parse(session.find(args))]
        session.executor.services.find(nodes[0].full_name, 'list_parameters')  # without it, that is what is printed
    else:
        session.wait_for_graph(args)
        # Each name once, in the order of the genuine command, when their services are known.
        nodes = sorted({each for each in session.node_names(hidden=args.include_hidden_nodes)
                        if each.name != TOOL_NODE_NAME})
        waiting.wait(lambda: all([_has_services(session, each) for each in nodes]), graph.DISCOVERY_SEC)
    answers = _ask_all(session, [each.full_name for each in nodes if _has_services(session, each)],
                       ListParameters.Request(prefixes=args.param_prefixes))
    for each in nodes:
        node = each.full_name
        if node not in answers:
            session.print(without_services(each))
            continue
        if isinstance(answers[node], Exception):
            session.complain(f"Exception while calling service of node '{node}': {answers[node]}")
            continue
        names = [name for name in sorted(answers[node].result.names) if wanted.match(name)]
        if names and not args.node_name:
            session.print(f'{node}:')
        types = {}
        if args.param_type and names:
            request = DescribeParameters.Request(names=names)
            types = {each.name: f' (type: {values.TYPES[each.type].label})'
                     for each in session.call(node, 'describe_parameters', request).descriptors}
        for name in names:
            session.print(f'  {name}{types.get(name, "")}')


def _ask_all(session: Session, nodes: Sequence[str], request: ListParameters.Request) -> dict[str, Any]:
    """Return for each node its answer, or the ParameterToolError that came instead."""
    services = session.executor.services
    answers: dict[str, Any] = {}

    def keep(node: str, future: Any) -> None:
        answers[node] = future.exception() or future.result()

    for node in nodes:
        try:
            services.call_async(node, 'list_parameters', request, timeout_sec=SERVICE_TIMEOUT_SEC
                                ).add_done_callback(functools.partial(keep, node))
        except ParameterToolError as error:
            answers[node] = error
    # Each call has a time limit of its own, so each finishes.
    waiting.wait(lambda: len(answers) == len(nodes), math.inf)
    return answers


def _has_services(session: Session, node: NodeName) -> bool:
    return session.executor.services.is_ready(node.full_name, 'list_parameters')


def get_parameter(session: Session, args: argparse.Namespace) -> None:
    node = session.find(args)
    answer = session.call(node, 'get_parameters', GetParameters.Request(names=[args.parameter_name])).values
    if not answer:
        raise CommandFailed('Parameter not set')
    parameter_type, value = values.TYPES[answer[0].type], values.to_python(answer[0])
    if args.hide_type:
        session.print(value)
    elif parameter_type is values.NOT_SET:
        session.print('Parameter not set.')
    else:
        label = parameter_type.label.removesuffix(' array').capitalize()
        session.print(f'{label} values are:' if parameter_type.is_array else f'{label} value is:', value)


def set_parameter(session: Session, args: argparse.Namespace) -> None:
    node = session.find(args)
    value = values.parse(args.value)
    # The genuine command knows nothing of the node's types, and takes an empty list for one of booleans.
    kind = values.BOOL_ARRAY if values.is_empty_array(value) else values.type_of(value)
    parameter = NodeParameter(args.parameter_name, NodeParameter.Type(kind.number), value)
    _set(session, node, parameter.to_parameter_msg(), 'Set parameter successful', 'Setting parameter failed')


def delete_parameter(session: Session, args: argparse.Namespace) -> None:
    """Ask a node to undeclare one parameter."""
    _set(session, session.find(args), Parameter(name=args.parameter_name),
         'Deleted parameter successfully', 'Deleting parameter failed')


def _set(session: Session, node: str, parameter: Parameter, success: str, failure: str) -> None:
    result = session.call(node, 'set_parameters', SetParameters.Request(parameters=[parameter])).results[0]
    _report(session, result, success, failure)


def _report(session: Session, result: Any, success: str, failure: str) -> None:
    text = (success if result.successful else failure) + (f': {result.reason}' if result.reason else '')
    (session.print if result.successful else session.complain)(text)


def describe_parameters(session: Session, args: argparse.Namespace) -> None:
    """Print descriptors; nothing at all if the node does not know one of the names, like the genuine command."""
    node = session.find(args)
    request = DescribeParameters.Request(names=args.parameter_names)
    for descriptor in session.call(node, 'describe_parameters', request).descriptors:
        _print_descriptor(session, descriptor)


def _print_descriptor(session: Session, descriptor: ParameterDescriptor) -> None:
    session.print('Parameter name:', descriptor.name)
    session.print('  Type:', values.TYPES[descriptor.type].label)
    if descriptor.description:
        session.print('  Description:', descriptor.description)
    session.print('  Constraints:')
    if descriptor.read_only:
        session.print('    Read only: true')
    for limits in [*descriptor.floating_point_range, *descriptor.integer_range][:1]:
        session.print('    Min value:', limits.from_value)
        session.print('    Max value:', limits.to_value)
        if limits.step:
            session.print('    Step:', limits.step)
    if descriptor.additional_constraints:
        session.print('    Additional constraints:', descriptor.additional_constraints)


def dump_parameters(session: Session, args: argparse.Namespace) -> None:
    """Print all parameters of a node, as the genuine command writes them.

    Its traps are kept, because learners will meet them: some texts are not quoted that rcl reads as numbers,
    and one parameter without a value empties the whole dump. ``ParameterClient.dump`` has no such traps.
    """
    node = session.find(args)
    if not session.executor.services.find(node, 'list_parameters'):
        # With exit status 0, as the genuine command.
        session.complain(without_services(node))
        return
    names = sorted(session.call(node, 'list_parameters', ListParameters.Request()).result.names)
    answer = session.call(node, 'get_parameters', GetParameters.Request(names=names)).values
    parameters: dict[str, Any] = {}
    for name, value in zip(names, map(values.to_python, answer)):
        _insert(parameters, name, value)
    session.print(yaml.dump({node: {'ros__parameters': parameters}}, default_flow_style=False))


def _insert(tree: dict[str, Any], name: str, value: Any) -> None:
    """Nest ``a.b`` below ``a``; where ``a`` has a value of its own, the genuine command would crash."""
    head, dot, rest = name.partition('.')
    if dot and isinstance(tree.setdefault(head, {}), dict):
        _insert(tree[head], rest, value)
    else:
        tree[name] = value


def load_parameters(session: Session, args: argparse.Namespace) -> None:
    """Set the parameters of a file one by one; which node the file names makes no difference."""
    node = session.find(args)
    try:
        parameters = list(parameter_dict_from_yaml_file(args.parameter_file, not args.no_use_wildcard).values())
        for parameter in parameters:
            values.type_of(values.to_python(parameter.value))
    except RuntimeError as error:
        raise CommandFailed(error) from None
    except OSError as error:
        raise CommandFailed(f'cannot read {args.parameter_file}: {error.strerror}') from None
    except UnicodeDecodeError as error:
        raise CommandFailed(f'{args.parameter_file} is not in UTF-8, the only encoding that `param load` reads: '
                            f'{error}') from None
    except (yaml.YAMLError, ValueError, TypeError, AttributeError, AssertionError) as error:
        # rclpy reads every value twice, as YAML and as what `param set` is given; dates and the like fail then.
        raise CommandFailed(f'{args.parameter_file} holds something that is not a parameter: {error}') from None
    answer = session.call(node, 'set_parameters', SetParameters.Request(parameters=parameters)).results
    for parameter, result in zip(parameters, answer):
        _report(session, result, f'Set parameter {parameter.name} successful', f'Set parameter {parameter.name} failed')
