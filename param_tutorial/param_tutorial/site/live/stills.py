"""The first picture of a live view: what its widgets hold, as HTML, without a script."""

import html
from collections.abc import Mapping
from typing import Any

from param_tutorial.site.live.running import LiveCell, children


def still(cell: LiveCell, root: str) -> str:
    """Return a view of a cell as the cell left it; the page's script puts the live one in its place.

    :param root: The name of the widget that is shown.
    """
    return (f'<div class="live-view" data-root="{html.escape(root)}">'
            f'{_draw(root, cell.states, root.replace("/", "-"))}</div>')


def _draw(name: str, states: Mapping[str, Mapping[str, Any]], prefix: str) -> str:
    """Return a widget and all within it, as ``widgets.js`` draws them.

    :param prefix: Begins each id.
    """
    state = states[name]
    kind = state['_model_name'].removesuffix('Model')
    classes = [*state.get('_dom_classes', ())]
    if kind.endswith('Box'):
        classes.append(f'widget-{kind.lower()}')
        content = ''.join(_draw(child, states, prefix) for child in children(state))
    elif kind == 'HTML':
        classes.append('widget-html')
        content = state['value']
    else:
        picture = state.get('picture', '').replace('robot-NAME', f'robot-{prefix}')
        content = state.get('markup', '').replace('panel-NAME', f'panel-{prefix}').replace(
            '<div class="robot-picture"></div>', f'<div class="robot-picture">{picture}</div>')
    return f'<div class="{" ".join(classes)}">{content}</div>'
