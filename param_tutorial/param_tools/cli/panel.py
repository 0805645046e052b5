"""panel: the parameter panel as a page in the browser, without a notebook.

Voilà serves the page to browsers that have the token: it runs a notebook of one cell in a kernel, shows what the cell
shows, and takes no code from the browser. It listens on the loopback interface only, unless ``--host`` names another
address. Each browser has a kernel of its own; with ``--read-only``, none of them can set a parameter (``Services``).
"""

import argparse
import contextlib
import functools
import json
import os
import secrets
import socket
import ssl
import tempfile
import webbrowser
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from rclpy.exceptions import NameValidationException
from rclpy.validate_namespace import validate_namespace
from rclpy.validate_node_name import validate_node_name

from param_tools.cli.session import CommandFailed, Commands, Session
from param_tools.ros.services import full_name

_HOST = '127.0.0.1'
_ANY_HOST = ('0.0.0.0', '::')
_PORT = 8866
# The page asks for its own, whatever a template of Voilà's would load from elsewhere, and stands in nobody's frame.
_POLICY = ("default-src 'self' 'unsafe-inline' 'unsafe-eval' data: blob:; connect-src 'self' data: blob: "
           "{sockets}:*; frame-ancestors 'none'")
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
.param-where { margin: 0 14px; color: var(--jp-ui-font-color2); font-size: var(--jp-ui-font-size1); }
@media (min-height: 500px) {
  .param-head { position: sticky; top: calc(-1 * var(--jp-notebook-padding, 10px)); z-index: 1; }
  :is(.param-row, .param-file) :is(input, textarea, select, button), .param-group > summary { scroll-margin-top: 11em; }
}
</style>
{%- endblock notebook_css -%}
'''
_CODE = '''import html, os
import param_tools
from IPython.display import HTML, display
from param_tools import ParameterPanel
from param_tools.ros import domain
os.chdir({folder!r})
param_tools.start().services.is_read_only = {is_read_only}
display(HTML(f'<p class="param-where">{{html.escape(domain.describe())}}.{note}</p>'))
{show}'''


def add_to(commands: Commands) -> None:
    parser = commands.add_parser('panel', help='show and change parameters on a page in the browser')
    parser.add_argument('nodes', nargs='*', metavar='NODE', help='the nodes to open; by default a list of all nodes')
    parser.add_argument('--port', type=int, default=_PORT, help=f'where to listen, or near it; default: {_PORT}')
    parser.add_argument('--no-browser', action='store_true', help='only print the address')
    parser.add_argument('--read-only', action='store_true', help='only show: nothing can be set or saved from the page')
    parser.add_argument('--host', default=_HOST, metavar='ADDRESS',
                        help=f'serve other machines, too: an address of this one, or {_ANY_HOST[0]} for all it has; '
                             f'default: {_HOST}, which no other machine reaches')
    parser.add_argument('--certfile', type=Path, metavar='FILE', help='serve over TLS, with this certificate (PEM)')
    parser.add_argument('--keyfile', type=Path, metavar='FILE',
                        help='the private key of the certificate, if it is not in the same file')
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

    token, encryption = secrets.token_urlsafe(24), _encryption(args.certfile, args.keyfile)
    name = socket.gethostname() if args.host in _ANY_HOST else args.host
    address = f'http{"s" if encryption else ""}://{f"[{name}]" if ":" in name else name}'
    policy = _POLICY.format(sockets=address.replace('http', 'ws', 1))
    with _files(_notebook(nodes, is_read_only=args.read_only)) as folder:
        config: dict[str, Any] = {
            'Voila': {'ip': args.host, 'port': args.port, 'token': token, 'log_level': 'ERROR',
                      'open_browser': False, 'notebook_path': str(folder / 'Parameters.ipynb'),
                      'connection_dir_root': str(folder),
                      # Jupyter Server counts these in milliseconds and Tornado in seconds: with what suits the one,
                      # the other closes the page's connection twice a minute, or warns.
                      'tornado_settings': {'ws_ping_interval': 0, 'headers': {'Content-Security-Policy': policy}}},
            'VoilaConfiguration': {'template': 'panel', 'theme': 'light',
                                   'allow_template_override': 'NO', 'allow_theme_override': 'NO',
                                   'show_tracebacks': True, 'prelaunch_hook': _let_page_end_its_kernel}}

        class Page(Voila):  # type: ignore[misc]
            def listen(self) -> None:
                # Voilà passes no certificate on to Tornado.
                self.app.listen = functools.partial(self.app.listen, ssl_options=encryption)
                super().listen()

        app = Page(config=Config(config))
        app.initialize([])

        def announce() -> None:
            url = f'{address}:{app.port}/?token={token}'
            session.print(f'The panel is at {url}\n{_who_can_reach(args.host, is_encrypted=bool(encryption))} '
                          f'Ctrl+C ends it.')
            session.stdout.flush()
            if not args.no_browser:
                _open(url, folder)

        IOLoop.current().add_callback(announce)
        try:
            app.start()
        except OSError as error:
            raise CommandFailed(f'cannot listen at {args.host}: {error.strerror}. --host takes an address of this '
                                f'machine') from None


def _let_page_end_its_kernel(handler: Any, **_: Any) -> None:
    """Set the cookie that a page must show when it is closed and has its kernel ended; Voilà sets none."""
    handler.xsrf_token  # noqa: B018 - Tornado sets the cookie when its value is asked for


def _encryption(certificate: Path | None, key: Path | None) -> ssl.SSLContext | None:
    """Return what encrypts the page; None if no certificate is given."""
    if certificate is None:
        if key is not None:
            raise CommandFailed('--keyfile is the key of a certificate: name that with --certfile')
        return None
    encryption = ssl.create_default_context(ssl.Purpose.CLIENT_AUTH)
    try:
        encryption.load_cert_chain(certificate, key)
    except ssl.SSLError as error:  # an OSError, too
        raise CommandFailed(f'{certificate} and {key or "the key in it"} are not a certificate and its private key in '
                            f'PEM format: {error.reason or error}') from None
    except OSError as error:
        raise CommandFailed(f'cannot read {certificate}{f" or {key}" if key else ""}: {error.strerror}') from None
    return encryption


def _who_can_reach(host: str, *, is_encrypted: bool) -> str:
    if host in (_HOST, 'localhost', '::1'):
        return 'Only programs on this machine can reach it.'
    warning = '' if is_encrypted else (' It is not encrypted, so anyone who listens in on the network sees the token: '
                                       '--certfile and --keyfile change that.')
    return f'Anyone on the network who has this address with its token can reach it.{warning}'


def _open(url: str, folder: Path) -> None:
    """Open the page in the browser, by a file that only this user can read: others see the words of a command."""
    (folder / 'open.html').write_text(f'<meta http-equiv="refresh" content="0;url={url}">')
    webbrowser.open((folder / 'open.html').as_uri())


def _require_name(node: str) -> str:
    """Return the fully qualified name of a node."""
    name = full_name(node)
    namespace, _, last = name.rpartition('/')
    try:
        validate_namespace(namespace or '/')
        validate_node_name(last)
    except NameValidationException as error:
        raise CommandFailed(f'no node can be called {node!r}: {" ".join(str(error).split())}') from None
    return name


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


def _notebook(nodes: Sequence[str], *, is_read_only: bool) -> dict[str, Any]:
    """Return a notebook that shows the page."""
    show = '\n'.join(f'display(ParameterPanel({node!r}))' for node in nodes) or 'display(ParameterPanel())'
    # Relative paths in the panel's form for files are those of the shell.
    code = _CODE.format(folder=os.getcwd(),  # noqa: PTH109 - a text for the cell
                        is_read_only=is_read_only, show=show,
                        note=' Read-only: nothing can be set from this page.' if is_read_only else '')
    return {'nbformat': 4, 'nbformat_minor': 5,
            'metadata': {'kernelspec': {'name': 'python3', 'display_name': 'Python 3', 'language': 'python'}},
            'cells': [{'id': 'panel', 'cell_type': 'code', 'metadata': {}, 'execution_count': None, 'outputs': [],
                       'source': code}]}
