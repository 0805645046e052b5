"""panel: the parameter panel as a page in the browser, without a notebook.

Voilà serves the page to browsers of this machine that have the token: it runs a notebook of one cell in a kernel, shows
what the cell shows, and takes no code from the browser. Each browser has a kernel of its own.
"""

import argparse
import contextlib
import json
import os
import secrets
import tempfile
import webbrowser
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from param_tools.cli.session import CommandFailed, Commands, Session

_HOST = '127.0.0.1'
_PORT = 8866
# The page asks for its own, whatever a template of Voilà's would load from elsewhere, and stands in nobody's frame.
_POLICY = ("default-src 'self' 'unsafe-inline' 'unsafe-eval' data: blob:; connect-src 'self' data: blob: "
           f"ws://{_HOST}:*; frame-ancestors 'none'")
# Voilà's own page, without the icons that it fetches from another server. It is dark where the system is.
_TEMPLATE = '''{%- extends 'voila/templates/lab/index.html.j2' -%}
{% import 'spinner.macro.html.j2' as spinner %}
{%- block notebook_css -%}
{{ resources.include_js('static/voila-style.js') }}
{{ spinner.css() }}
{{ super.super() }}
{{ resources.include_css('static/theme-dark.css') }}
<script>document.currentScript.previousElementSibling.media = '(prefers-color-scheme: dark)'</script>
{%- endblock notebook_css -%}
'''
_CODE = '''import param_tools
from IPython.display import display
from param_tools import ParameterPanel
param_tools.start()
{show}'''


def add_to(commands: Commands) -> None:
    parser = commands.add_parser('panel', help='show and change parameters on a page in the browser')
    parser.add_argument('nodes', nargs='*', metavar='NODE', help='the nodes to show; by default the first and a list')
    parser.add_argument('--port', type=int, default=_PORT, help=f'where to listen, or near it; default: {_PORT}')
    parser.add_argument('--no-browser', action='store_true', help='only print the address')
    parser.set_defaults(verb=panel)


def panel(session: Session, args: argparse.Namespace) -> None:
    """Serve the page until Ctrl+C."""
    if session.in_notebook:
        raise CommandFailed('in a notebook, the panel needs no page: ParameterPanel() shows it in a cell')
    try:
        from voila.app import Voila
    except ModuleNotFoundError:
        raise CommandFailed('the page is served by Voilà, which is not installed: pip install voila') from None
    from tornado.ioloop import IOLoop
    from traitlets.config import Config

    token = secrets.token_urlsafe(24)
    with _files(_notebook(args.nodes)) as folder:
        config: dict[str, Any] = {
            'Voila': {'ip': _HOST, 'port': args.port, 'token': token, 'log_level': 'ERROR',
                      'open_browser': False, 'notebook_path': str(folder / 'Parameters.ipynb'),
                      'connection_dir_root': str(folder),
                      # Jupyter Server counts these in milliseconds and Tornado in seconds: with what suits the one,
                      # the other closes the page's connection twice a minute, or warns.
                      'tornado_settings': {'ws_ping_interval': 0, 'headers': {'Content-Security-Policy': _POLICY}}},
            'VoilaConfiguration': {'template': 'panel', 'theme': 'light',
                                   'allow_template_override': 'NO', 'allow_theme_override': 'NO',
                                   'show_tracebacks': True, 'prelaunch_hook': _let_page_end_its_kernel}}
        app = Voila(config=Config(config))
        app.initialize([])

        def announce() -> None:
            url = f'http://{_HOST}:{app.port}/?token={token}'
            session.print(f'The panel is at {url}\nOnly programs on this machine can reach it. Ctrl+C ends it.')
            session.stdout.flush()
            if not args.no_browser:
                _open(url, folder)

        IOLoop.current().add_callback(announce)
        app.start()


def _let_page_end_its_kernel(handler: Any, **_: Any) -> None:
    """Set the cookie that a page must show when it is closed and has its kernel ended; Voilà sets none."""
    handler.xsrf_token  # noqa: B018 - Tornado sets the cookie when its value is asked for


def _open(url: str, folder: Path) -> None:
    """Open the page in the browser, by a file that only this user can read: others see the words of a command."""
    (folder / 'open.html').write_text(f'<meta http-equiv="refresh" content="0;url={url}">')
    webbrowser.open((folder / 'open.html').as_uri())


@contextlib.contextmanager
def _files(notebook: dict[str, Any]) -> Iterator[Path]:
    """Make the notebook and the template in a folder that nobody else can read, and remove it afterwards."""
    with tempfile.TemporaryDirectory(prefix='param_tools_panel_') as name:
        folder = Path(name)
        template = folder / 'data' / 'voila' / 'templates' / 'panel'
        template.mkdir(parents=True)
        (template / 'conf.json').write_text(json.dumps({'base_template': 'lab'}))
        (template / 'index.html.j2').write_text(_TEMPLATE)
        (folder / 'Parameters.ipynb').write_text(json.dumps(notebook))
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


def _notebook(nodes: Sequence[str]) -> dict[str, Any]:
    """Return a notebook that shows the panels of nodes, or the list of all nodes with the first one open."""
    show = '\n'.join(f'display(ParameterPanel({node!r}))' for node in nodes) or (
        'display(ParameterPanel(open_first=True))')
    return {'nbformat': 4, 'nbformat_minor': 5,
            'metadata': {'kernelspec': {'name': 'python3', 'display_name': 'Python 3', 'language': 'python'}},
            'cells': [{'id': 'panel', 'cell_type': 'code', 'metadata': {}, 'execution_count': None, 'outputs': [],
                       'source': _CODE.format(show=show)}]}
