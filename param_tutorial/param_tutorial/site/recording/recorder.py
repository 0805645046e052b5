"""Inside a lesson's kernel: records what a page needs of a view, right after the cell that has shown it.

The recorder asks the view (see ``widgets.recordable``) and the node behind it, and knows neither by name. It sets,
reads and restores the node's parameters through the same services as everybody; nothing is worked out that the node can
be asked. The kernel is thrown away afterwards, so the lesson's own outputs never know.
"""

import contextlib
import pkgutil
from collections.abc import Iterable, Iterator, Sequence

from param_tools.panel import recordable
from param_tools.panel.recordable import Portrait
from param_tools.panel.view import View
from param_tutorial.site.recording import taps
from param_tutorial.site.recording.interview import interview
from param_tutorial.site.recording.recorded import Page, Recording, ViewFacts


def describe(model_ids: Iterable[str]) -> list[ViewFacts]:
    """Return what the recordings of a page's views have to know of one another.

    :param model_ids: Of the widgets that a chapter has shown; those that are no views are left out.
    """
    return [{'node': view.node, 'follows': sorted(view.follows),
             'portrait': f'{type(view).__module__}:{type(view).__qualname__}' if isinstance(view, Portrait) else None}
            for model_id in model_ids for view in _views_in(model_id)]


def record(model_id: str, page: Page) -> Recording | None:
    """Record what a page needs of a view.

    :param model_id: Of the widget that a cell has shown.
    :return: What JSON can hold; None if the widget is no view.
    """
    found = recordable.find(model_id)
    if hasattr(found, 'parts'):
        return {**found.snapshot(), 'parts': _record(found.parts, page)}
    return None if found is None else _record((found,), page)[0]


def record_still(model_id: str, page: Page) -> Recording | None:
    """Record a view right away if that changes nothing for what the lesson does next.

    :return: What ``record`` does; an empty dictionary if the view has to be recorded in a kernel of its own.
    """
    if any(view.controls() or view.follows or (isinstance(view, Portrait) and view.in_motion)
           for view in _views_in(model_id)):
        return {}
    return record(model_id, page)


def _views_in(model_id: str) -> Sequence[View]:
    """Return the view with a model's id, or those in it; nothing if the widget is no view."""
    found = recordable.find(model_id)
    return () if found is None else getattr(found, 'parts', (found,))


def _record(views: Sequence[View], page: Page) -> list[Recording]:
    """Record views that stand together: all as they stand, then what their nodes say, and then what moves."""
    recordings = [_as_it_stands(view) for view in views]
    for view, recording in zip(views, recordings):
        if controls := view.controls():
            with _portrait_of(view, page) as portrait:
                events = any(recordable.EVENTS in each['follows'] for each in page['views'])
                recording.update(interview(view.node, controls, page, events=events, portrait=portrait))
    for view, recording in zip(views, recordings):
        if isinstance(view, Portrait) and (film := view.film()):
            recording['films'] = [{'changed': {}, 'look': recording['look'], **film}]
    return recordings


def _as_it_stands(view: View) -> Recording:
    if recordable.LOG in view.follows:
        taps.wait_for_logs()
    if isinstance(view, Portrait):
        view.rest()
    recording = view.snapshot()
    if 'lines' in recording:
        recording['lines'] = taps.without_marks(recording['lines'])
    return recording


@contextlib.contextmanager
def _portrait_of(view: View, page: Page) -> Iterator[Portrait | None]:
    """Make a view like the one with which the page pictures the node, which may stand in a later cell."""
    found = next((each['portrait'] for each in page['views'] if each['portrait'] and each['node'] == view.node), None)
    if found is None:
        yield None
        return
    portrait = pkgutil.resolve_name(found)(view.node)
    try:
        yield portrait
    finally:
        portrait.close()
