"""backlog: a cell waits for what came before it, and not forever."""

import threading

from param_tools.panel.pending_clicks import Backlog


def test_it_waits_for_all_that_has_come():
    backlog = Backlog()
    assert backlog.wait(0)
    backlog.add()
    backlog.add()
    hands = [threading.Thread(target=backlog.take) for _ in range(2)]
    for hand in hands:
        hand.start()
    assert backlog.wait(60)
    for hand in hands:
        hand.join()


def test_a_message_that_is_lost_is_waited_for_once():
    backlog = Backlog()
    backlog.add()
    assert not backlog.wait(0)
    assert backlog.wait(0)
    # The late one arrives after all, and does not count as the next one.
    backlog.take()
    backlog.add()
    assert not backlog.wait(0)
