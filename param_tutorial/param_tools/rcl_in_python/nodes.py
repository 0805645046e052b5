"""Nodes: their names, their overrides, and what they know of the graph."""

from collections.abc import Iterable, Sequence
from typing import Any

from param_tools.files import node_names
from param_tools.rcl_in_python import logs, names, qos
from param_tools.rcl_in_python.arguments import parse_for_node, remapped
from param_tools.rcl_in_python.contexts import Context
from param_tools.rcl_in_python.exceptions import NodeNameNonExistentError, RCLError
from param_tools.rcl_in_python.graph import NodeEntry, Writer, dds_service, dds_topic
from param_tools.rcl_in_python.messages import dds_name
from param_tools.rcl_in_python.waiting import Destroyable, changed, check_context

NamesAndTypes = list[tuple[str, list[str]]]


class Node(Destroyable):
    """A node, as it was named in the end."""

    def __init__(self, name: str, namespace: str, context: Context, cli_args: Sequence[str] | None,
                 use_global_arguments: bool, enable_rosout: bool):
        own = parse_for_node(cli_args)
        self.context = context
        self._sources = [own, context.arguments] if use_global_arguments else [own]
        check_context(context, 'error creating node')
        if flaw := node_names.flaw_of_node_name(name):
            raise ValueError(f'invalid node name: {flaw[0]}')
        namespace = namespace if namespace.startswith('/') else f'/{namespace}'
        if flaw := node_names.flaw_of_namespace(namespace):
            raise ValueError(f'invalid node namespace: {flaw[0]}')
        name = remapped(self._sources, 'name', name, name, namespace)
        namespace = remapped(self._sources, 'namespace', namespace, name, namespace)
        self.entry = NodeEntry(name, namespace, context.arguments.enclave, context)
        self._rosout: Writer | None = None
        with changed:
            context.domain.nodes.append(self.entry)
            super().__init__()
            changed.notify_all()
        if enable_rosout and context.arguments.has_rosout:
            self._start_rosout()

    def _start_rosout(self) -> None:
        from rcl_interfaces.msg import Log

        topic = dds_topic(self.resolve('/rosout', 'topic'), qos.ROSOUT)
        writer = self._rosout = Writer(self.context.domain, self.entry, topic, Log, qos.ROSOUT)

        def publish(record: logs.Record) -> None:
            log = Log(level=record.severity, name=record.name, msg=record.message, file=record.file,
                      function=record.function, line=record.line)
            log.stamp.sec, log.stamp.nanosec = divmod(record.time_ns, 10**9)
            writer.write(log)

        logs.add_rosout(self.logger_name(), publish)

    def _destroy(self) -> None:
        if self._rosout is not None:
            logs.remove_rosout(self.logger_name())
            self._rosout.leave()
        self.context.domain.nodes.remove(self.entry)
        changed.notify_all()

    def get_node_name(self) -> str:
        return self.entry.name

    def get_namespace(self) -> str:
        return self.entry.namespace

    def get_fully_qualified_name(self) -> str:
        return names.fully_qualified(self.entry.name, self.entry.namespace)

    def logger_name(self) -> str:
        return self.get_fully_qualified_name()[1:].replace('/', logs.SEPARATOR)

    def resolve(self, name: str, kind: str, *, only_expand: bool = False) -> str:
        """Return what a name of a topic or service stands for here.

        :raises InvalidNameError: it is no name.
        """
        name = names.expand(name, self.entry.name, self.entry.namespace)
        if not only_expand:
            name = remapped(self._sources, kind, name, self.entry.name, self.entry.namespace)
        if flaw := names.flaw_of_full_topic_name(name):
            raise names.InvalidNameError('topic name', flaw[0])
        return name

    def remap_topic(self, name: str) -> str:
        """Return the other name that a topic, whose name is written out, has here."""
        return remapped(self._sources, 'topic', name, self.entry.name, self.entry.namespace)

    def get_parameters(self, parameter_class: Any) -> dict[str, Any]:
        """Return the overrides for this node: those of the program, and then its own."""
        found: dict[str, Any] = {}
        for source in reversed(self._sources):
            found |= source.parameters(self.get_fully_qualified_name())
        types = parameter_class.Type
        return {name: parameter_class(name, types.NOT_SET if value in (None, []) else
                                      types.from_parameter_value(value), None if value == [] else value)
                for name, value in found.items()}

    def check_valid(self, what: str) -> None:
        """:raises RCLError: the context has been shut down."""
        if not self.context.ok():
            raise RCLError(f"{what}: rcl node's context is invalid")

    # -- the graph ------------------------------------------------------------------------------------------------

    def get_node_names_and_namespaces(self) -> list[tuple[str, str]]:
        self.check_valid('Failed to get node names')
        return [(each.name, each.namespace) for each in list(self.context.domain.nodes)]

    def get_node_names_and_namespaces_with_enclaves(self) -> list[tuple[str, str, str]]:
        self.check_valid('Failed to get node names')
        return [(each.name, each.namespace, each.enclave) for each in list(self.context.domain.nodes)]

    def endpoints(self, *, of: NodeEntry | None = None, is_writer: bool | None = None) -> list[Any]:
        """Return what is in the graph: of one node or of all, of one direction or of both."""
        return [each for each in list(self.context.domain.endpoints)
                if of in (None, each.node) and is_writer in (None, each.is_writer)]

    def _count(self, what: str, name: str, topic: str, is_writer: bool) -> int:
        self.check_valid(f'Error in {what}')
        if flaw := names.flaw_of_full_topic_name(name):
            raise RCLError(f'Error in {what}: topic_name argument is invalid: {flaw[0]}')
        return sum(each.topic == topic for each in self.endpoints(is_writer=is_writer))

    def get_count_publishers(self, topic: str) -> int:
        return self._count('rcl_count_publishers', topic, dds_topic(topic, qos.DEFAULT), True)

    def get_count_subscribers(self, topic: str) -> int:
        return self._count('rcl_count_subscribers', topic, dds_topic(topic, qos.DEFAULT), False)

    def get_count_clients(self, service: str) -> int:
        return self._count('rcl_count_clients', service, dds_service(service)[0], True)

    def get_count_services(self, service: str) -> int:
        return self._count('rcl_count_services', service, dds_service(service)[1], True)

    def find(self, name: str, namespace: str, what: str) -> NodeEntry:
        """Return a node of the graph.

        :param what: What is wanted of it, for the error.
        :raises NodeNameNonExistentError: there is none of that name.
        """
        self.check_valid(f'failed to get {what}')
        names.check_node_of_graph(name, namespace, f'failed to get {what}')
        wanted = (name, namespace or '/')
        for each in list(self.context.domain.nodes):
            if (each.name, each.namespace) == wanted:
                return each
        raise NodeNameNonExistentError(f'cannot get {what} for nonexistent node: error not set')


# -- names and types ------------------------------------------------------------------------------------------

def _ros_type(message_type: type) -> str:
    """Return what ROS calls a type, by what DDS calls it."""
    return dds_name(message_type).replace('::dds_::', '::').replace('::', '/').removesuffix('_')


def _listed(found: Iterable[tuple[str, str]]) -> NamesAndTypes:
    types: dict[str, set[str]] = {}
    for name, message_type in found:
        types.setdefault(name, set()).add(message_type)
    return [(name, sorted(types[name])) for name in sorted(types)]


def _topics(endpoints: list[Any], no_demangle: bool) -> NamesAndTypes:
    if no_demangle:
        return _listed((each.topic, dds_name(each.message_type)) for each in endpoints)
    return _listed((each.topic[2:], _ros_type(each.message_type)) for each in endpoints
                   if each.topic.startswith('rt/'))


def _services(endpoints: list[Any], prefixes: Sequence[str]) -> NamesAndTypes:
    ends = {'rq/': ('Request', '_Request'), 'rr/': ('Reply', '_Response')}
    return _listed((each.topic[2:].removesuffix(ends[prefix][0]),
                    _ros_type(each.message_type).removesuffix(ends[prefix][1]))
                   for each in endpoints for prefix in prefixes if each.topic.startswith(prefix))


def rclpy_get_topic_names_and_types(node: Node, no_demangle: bool) -> NamesAndTypes:
    node.check_valid('failed to get topic names and types')
    return _topics(node.endpoints(), no_demangle)


def rclpy_get_service_names_and_types(node: Node) -> NamesAndTypes:
    node.check_valid('failed to get service names and types')
    return _services(node.endpoints(), ('rq/', 'rr/'))


def rclpy_get_publisher_names_and_types_by_node(node: Node, no_demangle: bool, name: str, namespace: str,
                                                ) -> NamesAndTypes:
    entry = node.find(name, namespace, 'publisher names and types')
    return _topics(node.endpoints(of=entry, is_writer=True), no_demangle)


def rclpy_get_subscriber_names_and_types_by_node(node: Node, no_demangle: bool, name: str, namespace: str,
                                                 ) -> NamesAndTypes:
    entry = node.find(name, namespace, 'subscriber names and types')
    return _topics(node.endpoints(of=entry, is_writer=False), no_demangle)


def rclpy_get_service_names_and_types_by_node(node: Node, name: str, namespace: str) -> NamesAndTypes:
    entry = node.find(name, namespace, 'service names and types')
    return _services(node.endpoints(of=entry, is_writer=False), ('rq/',))


def rclpy_get_client_names_and_types_by_node(node: Node, name: str, namespace: str) -> NamesAndTypes:
    entry = node.find(name, namespace, 'client names and types')
    return _services(node.endpoints(of=entry, is_writer=False), ('rr/',))


# -- endpoints ------------------------------------------------------------------------------------------------

_PUBLISHER, _SUBSCRIPTION = 1, 2


def rclpy_get_publishers_info_by_topic(node: Node, topic: str, no_mangle: bool) -> list[dict[str, Any]]:
    return _infos(node, topic, no_mangle, is_writer=True)


def rclpy_get_subscriptions_info_by_topic(node: Node, topic: str, no_mangle: bool) -> list[dict[str, Any]]:
    return _infos(node, topic, no_mangle, is_writer=False)


def _infos(node: Node, topic: str, no_mangle: bool, *, is_writer: bool) -> list[dict[str, Any]]:
    what = 'publishers' if is_writer else 'subscriptions'
    node.check_valid(f'Failed to get information by topic for {what}')
    name = topic if no_mangle else dds_topic(topic, qos.DEFAULT)
    return [_info(each, no_mangle) for each in node.endpoints(is_writer=is_writer) if each.topic == name]


def _info(endpoint: Any, no_mangle: bool) -> dict[str, Any]:
    return {
        'node_name': endpoint.node.name,
        'node_namespace': endpoint.node.namespace,
        'topic_type': dds_name(endpoint.message_type) if no_mangle else _ros_type(endpoint.message_type),
        'topic_type_hash': {'version': 0, 'value': bytes(32)},
        'endpoint_type': _PUBLISHER if endpoint.is_writer else _SUBSCRIPTION,
        'endpoint_gid': list(endpoint.gid),
        'qos_profile': endpoint.profile.discovered().to_dict(),
    }


# -- names ----------------------------------------------------------------------------------------------------

def rclpy_remap_topic_name(node: Node, name: str) -> str:
    return node.remap_topic(name)


def rclpy_resolve_name(node: Node, name: str, only_expand: bool, is_service: bool) -> str:
    try:
        return node.resolve(name, 'service' if is_service else 'topic', only_expand=only_expand)
    except names.InvalidNameError as error:
        raise RCLError(f'failed to resolve name: {error}') from None
