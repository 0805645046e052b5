"""panel: the parameter panel as a page in the browser, without a notebook.

Voilà serves the page to browsers that have the token: it runs a notebook of one cell in a kernel, shows what the cell
shows, and takes no code from the browser. It listens on the loopback interface only.
"""

import argparse
import contextlib
import json
import os
import secrets
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from rclpy.exceptions import NameValidationException
from rclpy.validate_namespace import validate_namespace
from rclpy.validate_node_name import validate_node_name

from param_tools.cli.session import CommandFailed, Commands, Session
from param_tools.ros.services import full_name

_HOST = '127.0.0.1'
_PORT = 8866
# The page asks for its own, whatever a template of Voilà's would load from elsewhere, and stands in nobody's frame.
_POLICY = ("default-src 'self' 'unsafe-inline' 'unsafe-eval' data: blob:; connect-src 'self' data: blob: "
           f"ws://{_HOST}:*; frame-ancestors 'none'")
# Voilà's own page, without the icons that it fetches from another server. A panel of hundreds of parameters is many
# windows long, so its head stays in sight, with the node's name, Undo and the search. It is dark where the system is.
_TEMPLATE = '''{%- extends 'voila/templates/lab/index.html.j2' -%}
{% import 'spinner.macro.html.j2' as spinner %}
{%- block notebook_css -%}
{{ resources.include_js('static/voila-style.js') }}
{{ spinner.css() }}
{{ super.super() }}
{{ resources.include_css('static/theme-dark.css') }}
<script>document.currentScript.previousElementSibling.media = '(prefers-color-scheme: dark)'</script>
<style>
/* Between the head of a panel and what scrolls, nothing may cut it off. */
.jp-Cell-outputWrapper :is(.lm-Widget, .jp-OutputArea, .jp-OutputArea-child) { overflow: visible; }
.jp-Cell-outputWrapper .lm-Widget.param-panel { overflow: clip; }
@media (min-height: 500px) {
  .param-head { position: sticky; top: calc(-1 * var(--jp-notebook-padding, 10px)); z-index: 1; }
  :is(.param-row, .param-file) :is(input, textarea, select, button), .param-group > summary { scroll-margin-top: 11em; }
}
</style>
{%- endblock notebook_css -%}
'''
_CODE = '''import os
import param_tools
from param_tools.panel.page import show_page
os.chdir({folder!r})
param_tools.start()
{show}'''


def add_to(commands: Commands) -> None:
    """Add the command ``panel``."""
    parser = commands.add_parser('panel', help='show and change parameters on a page in the browser')
    parser.add_argument('nodes', nargs='*', metavar='NODE', help='the nodes to open; by default a list of all nodes')
    parser.add_argument('--port', type=int, default=_PORT, help=f'where to listen, or near it; default: {_PORT}')
    parser.add_argument('--presets', default='.', metavar='FOLDER',
                        help='where the presets of the page are kept; default: the current folder')
    parser.add_argument('--no-browser', action='store_true', help='only print the address')
    parser.set_defaults(verb=panel)


def panel(session: Session, args: argparse.Namespace) -> None:
    """Serve the page until Ctrl+C."""
    nodes = [_require_name(node) for node in args.nodes]
    if session.in_notebook:
        raise CommandFailed('in a notebook, the panel needs no page: ParameterPanel() shows it in a cell')
    try:
        from voila.app import Voila
    except ModuleNotFoundError:
        raise CommandFailed('the page is served by Voilà, which is not installed: pip install voila') from None
    from tornado.ioloop import IOLoop
    from traitlets.config import Config

    token = secrets.token_urlsafe(24)
    with _files(nodes, args.presets) as folder:
        config: dict[str, Any] = {
            'Voila': {'ip': _HOST, 'port': args.port, 'token': token, 'log_level': 'ERROR',
                      'open_browser': not args.no_browser, 'notebook_path': str(folder / 'Parameters.ipynb'),
                      'connection_dir_root': str(folder),
                      'tornado_settings': {'ws_ping_timeout': 30_000, 'headers': {'Content-Security-Policy': _POLICY}}},
            'VoilaConfiguration': {'template': 'panel', 'theme': 'light',
                                   'allow_template_override': 'NO', 'allow_theme_override': 'NO',
                                   'show_tracebacks': True}}
        app = Voila(config=Config(config))
        app.initialize([])

        def announce() -> None:
            session.print(f'The panel is at http://{_HOST}:{app.port}/?token={token}\n'
                          f'Only programs on this machine can reach it. Ctrl+C ends it.')
            session.stdout.flush()

        IOLoop.current().add_callback(announce)
        app.start()


def _require_name(node: str) -> str:
    """Return the fully qualified name of a node.

    :raises CommandFailed: no node can have such a name.
    """
    name = full_name(node)
    namespace, _, last = name.rpartition('/')
    try:
        validate_namespace(namespace or '/')
        validate_node_name(last)
    except NameValidationException as error:
        raise CommandFailed(f'no node can be called {node!r}: {" ".join(str(error).split())}') from None
    return name


@contextlib.contextmanager
def _files(nodes: Sequence[str], presets: str) -> Iterator[Path]:
    """Make the notebook and the template in a folder that nobody else can read, and remove it afterwards."""
    with tempfile.TemporaryDirectory(prefix='param_tools_panel_') as name:
        folder = Path(name)
        template = folder / 'data' / 'voila' / 'templates' / 'panel'
        template.mkdir(parents=True)
        (template / 'conf.json').write_text(json.dumps({'base_template': 'lab'}))
        (template / 'index.html.j2').write_text(_TEMPLATE)
        (folder / 'Parameters.ipynb').write_text(json.dumps(_notebook(nodes, presets)))
        # The kernel says at its start that it speaks to the server through loopback without encryption.
        profile = folder / 'ipython' / 'profile_default'
        profile.mkdir(parents=True)
        (profile / 'ipython_kernel_config.json').write_text(json.dumps({'IPKernelApp': {'log_level': 40}}))
        # The user's own settings, kernels and templates take no part.
        os.environ |= {'JUPYTER_CONFIG_DIR': str(folder / 'config'), 'JUPYTER_DATA_DIR': str(folder / 'data'),
                       'JUPYTER_RUNTIME_DIR': str(folder / 'runtime'), 'JUPYTER_NO_CONFIG': '1',
                       'IPYTHONDIR': str(folder / 'ipython')}
        for variable in ('JUPYTER_PATH', 'JUPYTER_CONFIG_PATH', 'JUPYTER_TOKEN'):
            os.environ.pop(variable, None)
        yield folder


def _notebook(nodes: Sequence[str], presets: str) -> dict[str, Any]:
    """Return a notebook that shows the page."""
    show = f'show_page({list(nodes)!r}, {presets!r})'
    # Relative paths in the panel's form for files are those of the shell.
    code = _CODE.format(folder=os.getcwd(), show=show)  # noqa: PTH109 - a text for the cell
    return {'nbformat': 4, 'nbformat_minor': 5,
            'metadata': {'kernelspec': {'name': 'python3', 'display_name': 'Python 3', 'language': 'python'}},
            'cells': [{'id': 'panel', 'cell_type': 'code', 'metadata': {}, 'execution_count': None, 'outputs': [],
                       'source': code}]}
