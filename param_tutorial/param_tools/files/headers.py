"""Why a value stands before ``ros__parameters``, as the author of the file would name it. No ROS, no Jupyter."""

import difflib
from collections.abc import Iterable

from param_tools.files.parsing import KEY, BlockStart, Place, Rejected


def cause_of(rejected: Rejected, starts: Iterable[BlockStart]) -> tuple[Place, str]:
    """Return where the cause of a rejection stands, and what it is, with a remedy for the two commonest mistakes.

    :param starts: The blocks of the file.
    """
    for name, place in rejected.keys:
        if name != KEY and difflib.SequenceMatcher(None, name.lower(), KEY).ratio() > 0.75:
            return place, f'{name!r} should be {KEY!r}: rcl rejects the file'
    headers = [start.end for start in starts if start.end.start < rejected.place.start]
    if headers:
        # What stands after the header, in its column and in the same map.
        name, place = next(((name, place) for name, place in rejected.keys if place.start > headers[-1].start),
                           ('', Place()))
        if name and place.column == headers[-1].column:
            return place, f'{name} stands beside {KEY!r}, not below it: rcl rejects the file. Indent this line'
    return rejected.place, str(rejected)
