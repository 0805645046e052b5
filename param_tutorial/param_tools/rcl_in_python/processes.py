"""What of this layer belongs to one process, for a host that runs several programs in one interpreter.

Contexts, handlers of signals, and all that has to do with logs. The graph is common to all of them.
"""

import weakref
from collections import Counter
from collections.abc import Callable
from typing import Any

from param_tools.rcl_in_python import contexts, logs, waiting

_OWN: tuple[tuple[Any, str, Callable[[], Any]], ...] = (
    (contexts, 'known', weakref.WeakSet), (contexts, 'guards', list), (contexts, 'replaced', dict),
    (logs, 'state', logs.State), (logs, 'output', logs.Output), (logs, 'rosout', dict),
    (logs, 'subloggers', Counter), (logs, 'publisher_of_sublogger', dict), (waiting, 'handles', weakref.WeakSet))


def process_globals() -> list[tuple[Any, str, Any]]:
    """Return the layer's module-level state as (module, attribute, initial value); ``programs.Program`` swaps it."""
    return [(module, name, make()) for module, name, make in _OWN]


def end() -> None:
    """Take everything of this process out of the graph, as its end would."""
    for context in list(contexts.known):
        if context.ok():
            context.shutdown()
    with waiting.changed:
        for handle in list(waiting.handles):
            handle.end()
