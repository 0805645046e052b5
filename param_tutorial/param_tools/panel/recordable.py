"""What a view tells about itself, so that a page without a kernel can show what it shows.

The recorder of the HTML lessons names no view. It finds one by the id in a cell's output, and asks for what each
``View`` tells: a new view is recorded as it stands, and overrides what it knows better. A view that pictures its node
is also a ``Portrait``.
"""

import weakref
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Protocol, runtime_checkable

import ipywidgets as widgets

from param_tools.descriptor import Descriptor
from param_tools.panel.drawing import PanelRow, RowState
from param_tools.panel.editors import Scale

LOG = 'log'
EVENTS = 'events'


@dataclass(frozen=True)
class ControlFacts:
    """What a view shows of one parameter that a hand can change."""

    descriptor: Descriptor
    value: Any
    """What the node confirmed last."""
    row: PanelRow
    state: RowState
    scale: Scale | None
    """Of the slider beside the text; None if there is no slider."""


@runtime_checkable
class Portrait(Protocol):
    """A view that pictures its node: a page wants to see what each answer changes in the picture.

    Its class can be called with the name of a node.
    """

    in_motion: bool
    """True if the picture moves, so that a film shows more than a look."""

    def rest(self) -> None:
        """Wait, or see to it, that the node and its picture change no more by themselves."""

    def look(self) -> Any:
        """Return the picture of the node at rest, as JSON; None if there is nothing to see."""

    def film(self, *, start: Any = None) -> dict[str, Any] | None:
        """Let the node move, and return what there is to see, as JSON; None if nothing moves. It is at rest then.

        :param start: One of the ``moments``: the node goes on from there, with the parameters that it has now.
        """

    def moments(self, step_sec: float) -> Sequence[Any]:
        """Return where the node is after each so many seconds of its ``film``, until that ends."""

    def close(self) -> None:
        """Remove it."""


_views: 'weakref.WeakValueDictionary[str, Any]' = weakref.WeakValueDictionary()


def register(model_id: str, view: Any) -> None:
    """Let a view be found by its model's id, which is all that an output tells; ipywidgets has no public way."""
    _views[model_id] = view


def find(model_id: str) -> Any:
    """Return the view with a model's id, or a widget with several views, its ``parts``; None if there is neither."""
    return _views.get(model_id)


def html_of(widget: widgets.Widget) -> str:
    """Return the HTML that a tree of widgets holds, as it stands; controls leave no trace."""
    # The views' style sheets go by these names.
    names = ' '.join(widget.get_state('_dom_classes').get('_dom_classes', ()))
    if isinstance(widget, widgets.Box):
        return f'<div class="{names}">{"".join(map(html_of, widget.children))}</div>'
    if isinstance(widget, (widgets.HTML, widgets.HTMLMath)):
        return f'<div class="{names}">{widget.value}</div>'
    return ''
