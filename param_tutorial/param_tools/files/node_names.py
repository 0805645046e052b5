"""Names of nodes and namespaces, and what is wrong with one. No ROS, no Jupyter.

Texts and positions are those of rmw's validators; a test compares with rcl's parser which names of blocks it takes.
"""

import re

# What is wrong with a name, and where; None if nothing is.
Flaw = tuple[str, int] | None

_MAX_NODE_NAME, _MAX_NAMESPACE = 255, 245


def as_in_c(name: str) -> str:
    """Return a name with one character for each of its bytes, which is how C counts."""
    if not isinstance(name, str):
        raise TypeError(f'a name must be a str, not {type(name).__name__}')
    return name.encode().decode('latin-1')


def flaw_of_node_name(name: str) -> Flaw:
    """Return what is wrong with the name of a node, without its namespace."""
    name = as_in_c(name)
    if not name:
        return 'node name must not be empty', 0
    if found := re.search('[^A-Za-z0-9_]', name):
        return "node name must not contain characters other than alphanumerics or '_'", found.start()
    if name[0].isdigit():
        return 'node name must not start with a number', 0
    if len(name) > _MAX_NODE_NAME:
        return "node name length should not exceed '255'", _MAX_NODE_NAME - 1
    return None


def flaw_of_namespace(name: str) -> Flaw:
    """Return what is wrong with a namespace, which begins with a slash."""
    name = as_in_c(name)
    if not name:
        return 'namespace must not be empty', 0
    if name == '/':
        return None
    if flaw := flaw_of_path(name, 'namespace', ", unless only a '/'"):
        return flaw
    if len(name) > _MAX_NAMESPACE:
        return "namespace should not exceed 'RMW_NAMESPACE_MAX_NAME_LENGTH'", _MAX_NAMESPACE - 1
    return None


def flaw_of_path(name: str, what: str, exception: str) -> Flaw:
    """Return what is wrong with a namespace or a topic's full name, its length aside."""
    if name[0] != '/':
        return f"{what} must be absolute, it must lead with a '/'", 0
    if name[-1] == '/':
        return f"{what} must not end with a '/'{exception}", len(name) - 1
    if found := re.search('[^A-Za-z0-9_/]', name):
        return f"{what} must not contain characters other than alphanumerics, '_', or '/'", found.start()
    if found := re.search('//|/[0-9]', name):
        if found[0] == '//':
            return f"{what} must not contain repeated '/'", found.start() + 1
        return f'{what} must not have a token that starts with a number', found.start() + 1
    return None


def flaw_of_block_name(name: str) -> str:
    """Return what rcl rejects in the name of a block; nothing if it can be that of a node or a pattern for some.

    rcl judges the last part as the name of a node, and each part before it as a namespace, so only a part can be too
    long, and never the whole.
    """
    # Half a character, as Python can hold it, is no letter either.
    *namespaces, node = name.encode(errors='replace').decode().removeprefix('/').split('/')
    for part in namespaces:
        if not part:
            return "namespace must not contain repeated '/'"
        if part not in ('*', '**') and (flaw := flaw_of_namespace(f'/{part}')):
            return flaw[0]
    flaw = None if node in ('*', '**') else flaw_of_node_name(node)
    return flaw[0] if flaw else ''
