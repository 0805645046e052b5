"""What the live views have in common in the browser: each is an anywidget that goes on hearing on a slow machine."""

import threading
import uuid
from typing import Any

import anywidget
import traitlets


class Front(anywidget.AnyWidget):
    """A view in the browser. ``front.js`` says what it adds to an anywidget."""

    own_id = traitlets.Unicode().tag(sync=True)

    def __init__(self, **state: Any) -> None:
        """:param state: What its traits are at first."""
        own_id = uuid.uuid4().hex
        # Held by the thread that writes to it; a View puts its own lock here.
        self.drawing = threading.RLock()
        super().__init__(model_id=own_id, own_id=own_id, **state)

    def _handle_custom_msg(self, content: dict[str, Any], buffers: Any) -> None:
        if content != {'do': 'tell again'}:
            super()._handle_custom_msg(content, buffers)
            return
        with self.drawing:  # or what is written meanwhile would arrive before this, which is older
            self.send_state([name for name in self.keys if not name.startswith('_')])
