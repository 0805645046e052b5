"""What the page of the command ``panel`` shows: the panels of nodes, and the drawer below them."""

import functools
from collections.abc import Sequence

import ipywidgets as widgets

from param_tools.panel.drawer import ParameterDrawer
from param_tools.panel.panel import ParameterBrowser, ParameterPanel
from param_tools.ros import graph, host, stage, waiting

# The process of the page has just joined, and on a busy machine it takes a while to hear of a node. A node that
# somebody starts within this time is opened, too.
_DISCOVERY_SEC = 30.0


def show_page(nodes: Sequence[str], presets: str) -> widgets.Box:
    """Return the panel of one node, or the list of all with the panels of some; and the drawer.

    :param nodes: Which panels to open. Without any, that of the only node that is running.
    :param presets: The folder of the presets.
    """
    shown: ParameterPanel | ParameterBrowser
    if len(nodes) == 1:
        shown = ParameterPanel(nodes[0])
    else:
        shown = ParameterBrowser()
        for node in nodes:
            shown.show(node)
        if not nodes:
            host.host.run(functools.partial(_open_the_only_node, shown), 'the only node')
    page = widgets.VBox([shown, ParameterDrawer(nodes, folder=presets)])
    page.add_class('param-page')
    return page


def _open_the_only_node(browser: ParameterBrowser) -> None:
    """Open the only node, once it is known that there is no other."""
    if waiting.wait(lambda: browser.nodes, _DISCOVERY_SEC):
        graph.wait_until_quiet(stage.current().tool_node, graph.JOINING_SEC)
        browser.show_only()
