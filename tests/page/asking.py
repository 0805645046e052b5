"""Asks a node what a hand would: runs in the kernel of a page, with ``QUESTIONS`` there, and leaves ``ANSWERS``.

Each question is a parameter, what is typed, and what was typed into others before; the node gets back what it had.
"""

from param_tools import values
from param_tools.errors import ParameterToolError, describe_error
from param_tools.node.client import ParameterClient
from param_tools.node.text import format_value, parse_value


def ask_all(node, questions):
    """Return what a node says to each question: a value as a panel shows it, or a reason."""
    client = ParameterClient(node)
    names = client.list_parameters()
    descriptors, first = client.describe_and_get(names)

    def read():
        return dict(client.get_parameters(names))

    def differing(one, other):
        return {name: value for name, value in one.items() if not values.same(other[name], value)}

    def put_back(now):
        for set_all in (client.set_parameters, client.set_parameters_atomically):
            if different := differing(first, now):
                set_all(different)
                now = read()

    def ask(name, text, changed):
        for other, typed in changed.items():
            client.set_parameter(other, parse_value(descriptors[other], typed))
        before = read() if changed else first
        try:
            result = client.set_parameter(name, parse_value(descriptors[name], text))
            reason = '' if result.successful else result.reason or 'The node gave no reason.'
        except ValueError as error:
            put_back(before)
            return {'reason': str(error)}
        except ParameterToolError as error:
            reason = describe_error(error)
        after = read()
        put_back(after)
        answer = {'reason': reason} if reason else {'value': format_value(descriptors[name], after[name])}
        also = {other: format_value(descriptors[other], value) for other, value in differing(after, before).items()
                if other != name or reason}
        return answer | ({'also': also} if also else {})

    return [ask(*question) for question in questions]


ANSWERS = ask_all(*QUESTIONS)  # noqa: F821  # the test has put them there
