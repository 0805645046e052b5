"""What tests of widgets do and look at: input, the page, and what is left to draw."""

from param_tools.ros import schedule


def due_jobs():
    """Return what panels and views have yet to draw, or to ask again."""
    return list(schedule._due)


def enter(panel, name, text):
    """Do what the browser does when someone types text or clicks a check box."""
    _send(panel, name, text=text)


def slide(panel, name, position, grip=0):
    """Do what the browser does when someone drags a slider; positions count from 0."""
    _send(panel, name, position=position, grip=grip)


def press(panel, button, **details):
    """Do what the browser does when someone presses one of the buttons of a panel or another view."""
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
    """Return what the control of a parameter shows: its text, and the position of its slider, if it has one."""
    state = _row(panel, name)
    return tuple(state[each] for each in ('text', 'position') if each in state)


def says(panel, name):
    """Return the message beside the control of a parameter: its kind, and its words."""
    return _row(panel, name).get('message')


def is_locked(panel, name):
    """True if the control of a parameter is disabled."""
    return _row(panel, name).get('is_locked', False)
