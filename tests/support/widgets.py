"""What tests of widgets do and look at: a hand, the page, and the threads behind it."""

import threading

from param_tutorial.parameters import values
from param_tutorial.runtime.waiting import wait_until
from param_tutorial.runtime.worker import THREAD_NAME_PREFIX


def worker_threads():
    """Return the names of the threads that serve panels and views."""
    return [each.name for each in threading.enumerate() if each.name.startswith(THREAD_NAME_PREFIX)]


def enter(panel, name, text):
    """Do what the browser does when somebody has typed a text, or clicked a check box."""
    _send(panel, name, text=text)


def slide(panel, name, position, grip=0):
    """Do what the browser does when somebody has pulled a slider; positions count from 0."""
    _send(panel, name, position=position, grip=grip)


def press(panel, button, **details):
    """Do what the browser does when somebody has pressed one of the panel's buttons."""
    panel._front._handle_custom_msg({'do': button, **details}, [])


def _send(panel, name, **entry):
    panel._front._handle_custom_msg({'do': 'enter', 'name': name, 'client': 'test', 'number': 1, **entry}, [])


def texts(panel):
    """Return all the HTML of a view."""
    pieces, waiting = [], list(panel.children)
    while waiting:
        widget = waiting.pop()
        waiting += getattr(widget, 'children', ())
        if type(widget).__name__ == 'HTML':
            pieces.append(widget.value)
    return '\n'.join(pieces)


def _row(panel, name):
    """Return the state of a control; a panel knows a parameter a moment before it is drawn."""
    return panel._front.state['rows'].get(name, {})


def shows(panel, name):
    """Return what the control of a parameter shows: its text, and where its slider stands, if it has one."""
    state = _row(panel, name)
    return tuple(state[each] for each in ('text', 'position') if each in state)


def says(panel, name):
    """Return what stands beside the control of a parameter: what kind of message, and its words."""
    return _row(panel, name).get('message')


def is_locked(panel, name):
    """Return whether nobody can use the control of a parameter."""
    return _row(panel, name).get('is_locked', False)


def wait_for_value(panel, name, value):
    """Wait, without asking the panel to hurry."""
    wait_until(lambda: values.same(panel[name].value, value), f'{name} to become {value!r}')
