"""What tests of widgets do and look at: a hand, the page, and the threads behind it."""

import threading

from param_tutorial.parameters import values
from param_tutorial.runtime.waiting import wait_until
from param_tutorial.runtime.worker import THREAD_NAME_PREFIX


def worker_threads():
    """Return the names of the threads that serve panels and views."""
    return [each.name for each in threading.enumerate() if each.name.startswith(THREAD_NAME_PREFIX)]


def by_hand(widget, value):
    """Do what a front end does when a hand has changed a widget."""
    widget.set_state({'value': value})


def texts(panel):
    """Return all the HTML of a panel or view."""
    pieces, waiting = [], list(panel.children)
    while waiting:
        widget = waiting.pop()
        waiting += getattr(widget, 'children', ())
        if type(widget).__name__ == 'HTML':
            pieces.append(widget.value)
    return '\n'.join(pieces)


def shows(panel, name):
    """Return what the widgets of a control hold."""
    return tuple(widget.value for widget in panel[name].editors)


def wait_for_value(panel, name, value):
    """Wait, without asking the panel to hurry."""
    wait_until(lambda: values.same(panel[name].value, value), f'{name} to become {value!r}')
