"""What a recording is: what a page needs of a chapter's views, as JSON can hold it."""

from collections.abc import Mapping
from typing import Any, TypedDict

# Of one view; 'kind' says how a page draws it, and what else it holds. Which view knows which kind is in the views.
Recording = dict[str, Any]
# For the id of each cell that shows views, the recordings of these in order.
Recordings = dict[str, list[Recording]]


class RecordedAnswer(TypedDict, total=False):
    """What a node said to one text: either 'value' or 'reason'."""

    value: str
    """As the view then shows it."""
    reason: str
    """Why the node rejected the text."""
    also: dict[str, str]
    """What else has changed."""
    log: list[str] | None
    """The lines that the node logged; None if nobody can know."""
    events: list[list[str]]
    """What it published on /parameter_events, if that is wanted: what, parameter, value."""


class _Shown(TypedDict):
    name: str
    text: str
    message: str
    """Why the node rejected the last change; empty if it did not."""
    locked: bool
    quiet: bool
    editor: str
    row: dict[str, Any]
    """The fields of a PanelRow."""
    own: list[str]
    """What the lesson sets it to."""


class Row(_Shown, total=False):
    """One parameter: how its control stands, and the answers to what was typed into it."""

    positions: list[str]
    answers: dict[str, RecordedAnswer]
    readings: dict[str, str]
    """What texts are read as, where the control writes that in another way."""
    depends: list[str]
    """The parameters on which the answers depend, possibly itself among them."""
    contexts: dict[str, dict[str, RecordedAnswer]]
    """Answers where these have changed: by the ``key`` of what has."""
    log_depends: bool
    unasked: bool
    """True if it is locked on the page because the panel has too many to ask for all."""


def key(changed: Mapping[str, str]) -> str:
    """Return a name for a set of parameters and their texts, whatever their order, as the page's script does."""
    return '\n'.join(f'{name}={text}' for name, text in sorted(changed.items()))


class ViewFacts(TypedDict):
    """What a chapter tells of a view on its page, for the recordings of the others."""

    node: str
    follows: list[str]
    portrait: str | None
    """Where to import the class from, 'module:name', if the view pictures its node."""


class Page(TypedDict):
    """What the recorder has to know of the page for which it records a view."""

    literals: list[Any]
    """Values that the chapter's code speaks of: its readers will try them."""
    source: str
    """The code of the chapter and of its solutions."""
    albums: list[str]
    """The names of the albums that the page has already."""
    views: list[ViewFacts]
