"""Drive the real JupyterLab in the system's Chromium, for tests, recordings and benchmarks.

    with Lab(tmp_path, [notebook]) as lab, chromium() as browser:
        page = LabPage(lab, browser, notebook.name)
        page.run_all()

Waits only for conditions, each with a deadline. Nothing leaves the machine: the server listens on 127.0.0.1, and
Chromium resolves no other name.
"""

import ast
import contextlib
import json
import os
import re
import shutil
import subprocess
import sys
import urllib.request
from collections.abc import Iterator
from pathlib import Path

from jupyter_client import BlockingKernelClient
from playwright.sync_api import Browser, Locator, Page, expect, sync_playwright

from param_tools.ros.waiting import wait_until
from tests.support.paths import ROOT
from tests.support.processes import wait_or_kill

# The shell is the same browser without its window, and takes a quarter of the processor time.
CHROMIUM = next(filter(None, map(shutil.which, ('chromium-headless-shell', 'chromium', 'chromium-browser',
                                                'google-chrome'))), None)
# A machine with two cores that runs other tests beside is slow, and a deadline that passes costs a whole run.
TIMEOUT_SEC = 120.0
expect.set_options(timeout=TIMEOUT_SEC * 1000)

# What JupyterLab itself complains about in a browser without the internet; none of it is ours.
KNOWN_ERRORS = (
    # The page asks for its own favicon in a busy variant that this server does not have.
    r'favicon',
    # When cells are run again, JupyterLab removes an output from the page that it has replaced already.
    r"Failed to execute 'removeChild' on 'Node'",
    # It asks each kernel for its debugger, which the course leaves out, when a page is loaded again.
    r'Could not restore the debugger state',
    # anywidget gives a script two seconds to load. Our views go on without: see panel/front.js.
    r'\[anywidget\] Failed to initialize model',
)

# As JupyterLab's menu does.
RESTART_KERNEL = 'jupyterapp.shell.currentWidget.sessionContext.session.kernel.restart()'


class Lab:
    """A JupyterLab server on copies of some notebooks, which are in ``folder``; ``environment`` is the server's."""

    def __init__(self, folder: Path, notebooks: list[Path]):
        self._scratch, self.folder, self.runtime = folder, folder / 'work', folder / 'runtime'
        self.folder.mkdir(parents=True)
        # These have the server load all of nbconvert's exporters for a menu, each time a page is opened.
        page_config = folder / 'config' / 'labconfig' / 'page_config.json'
        page_config.parent.mkdir(parents=True)
        page_config.write_text(json.dumps({'disabledExtensions': {
            f'@jupyterlab/notebook-extension:{name}': True for name in ('export', 'update-raw-mimetype')}}))
        for notebook in notebooks:
            self.add(notebook)
        self.token = os.urandom(16).hex()
        # Each test's kernels choose a domain of their own, as a learner's do.
        inherited = {name: value for name, value in os.environ.items()
                     if name == 'ROS_LOG_DIR' or not name.startswith(('JUPYTER', 'ROS_', 'FASTRTPS_', 'PYTEST'))}
        self.environment = {
            **inherited,
            'JUPYTER_CONFIG_PATH': str(ROOT / 'environment' / 'jupyter'),
            'JUPYTER_CONFIG_DIR': str(folder / 'config'),
            'JUPYTER_DATA_DIR': str(folder / 'data'),
            'JUPYTER_RUNTIME_DIR': str(self.runtime),
            'JUPYTERLAB_SETTINGS_DIR': str(folder / 'settings'),
            'JUPYTERLAB_WORKSPACES_DIR': str(folder / 'workspaces'),
            'IPYTHONDIR': str(folder / 'ipython'),
        }

    def add(self, notebook: Path) -> None:
        """Put a fresh copy of a notebook into the server's folder."""
        shutil.copy(notebook, self.folder)

    def _command(self) -> list[str]:
        return [sys.executable, '-m', 'jupyterlab', '--allow-root', f'--ServerApp.root_dir={self.folder}',
                '--LabApp.extension_manager=readonly', *self._options()]

    def _options(self) -> list[str]:
        """Return what a test needs and a learner doesn't."""
        return ['--no-browser', '--ip=127.0.0.1', '--port=0', f'--IdentityProvider.token={self.token}']

    def __enter__(self) -> 'Lab':
        self._log = (self._scratch / 'server.log').open('w')
        self._process = subprocess.Popen(
            self._command(), env=self.environment, stdin=subprocess.DEVNULL, stdout=self._log,
            stderr=subprocess.STDOUT)
        try:
            self.url = wait_for(self._find_url, 'the JupyterLab server')
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_) -> None:
        # On SIGTERM the server ends its kernels too.
        self._process.terminate()
        wait_or_kill(self._process)
        self._log.close()

    def _find_url(self) -> str | None:
        if self._process.poll() is not None:
            raise RuntimeError(f'JupyterLab ended with status {self._process.returncode}:\n{self.log()}')
        info = self.runtime / f'jpserver-{self._process.pid}.json'
        with contextlib.suppress(OSError, ValueError):
            url = json.loads(info.read_text())['url']
            with urllib.request.urlopen(f'{url}api/status?token={self.token}', timeout=5):
                return url
        return None

    def log(self) -> str:
        """Return what the server printed."""
        return (self._scratch / 'server.log').read_text()

    def kernels(self) -> list[dict]:
        """Return what the server says about its kernels."""
        with urllib.request.urlopen(f'{self.url}api/kernels?token={self.token}', timeout=20) as answer:
            return json.load(answer)

    def end_kernels(self) -> None:
        """End all kernels, and wait until they have ended."""
        for kernel in self.kernels():
            request = urllib.request.Request(f'{self.url}api/kernels/{kernel["id"]}?token={self.token}',
                                             method='DELETE')
            urllib.request.urlopen(request, timeout=TIMEOUT_SEC).close()

    def ask_kernel(self, expression: str) -> str:
        """Return the repr of an expression in the only kernel, without the browser."""
        kernel, = self.kernels()
        client = BlockingKernelClient(
            connection_file=str(self.runtime / f'kernel-{kernel["id"]}.json'))
        client.load_connection_file()
        client.start_channels(iopub=False, stdin=False, hb=False)
        try:
            answer = client.execute('', silent=True, user_expressions={'it': expression}, reply=True,
                                    timeout=TIMEOUT_SEC)['content']['user_expressions']['it']
        finally:
            client.stop_channels()
        if answer['status'] != 'ok':
            raise RuntimeError(f'{expression}: {answer["ename"]}: {answer["evalue"]}')
        return answer['data']['text/plain']

    def ros_environment(self) -> dict[str, str]:
        """Return the environment for a process that should see the kernel's nodes."""
        environment = ast.literal_eval(self.ask_kernel("dict(__import__('os').environ)"))
        return {**self.environment, **{name: value for name, value in environment.items()
                                        if name.startswith(('ROS_', 'FASTRTPS_'))}}


@contextlib.contextmanager
def chromium() -> Iterator[Browser]:
    """Start Chromium, which can reach this machine and nothing else, and end it afterwards."""
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=[
            '--disable-gpu', '--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1'])
        try:
            yield browser
        finally:
            browser.close()


# environment/lab.py, with JupyterLab's own files in a folder of the test's.
MAKE_LAB = '''
import sys
from pathlib import Path
sys.path.insert(0, sys.argv[1])
import lab
lab.STATE = Path(sys.argv[2])
lab.main(sys.argv[3:])
'''


class CourseLab(Lab):
    """JupyterLab as `make lab` starts it, in a checkout that has only some of the chapters."""

    def __init__(self, folder: Path, notebooks: list[Path]):
        super().__init__(folder, [])
        self.course = folder / 'course'
        self.copies = self.course / 'my_lessons'
        shutil.copytree(ROOT / 'environment', self.course / 'environment',
                        ignore=shutil.ignore_patterns('node_modules'))
        (self.course / 'notebooks').mkdir()
        for notebook in [ROOT / 'notebooks' / 'index.md', *notebooks]:
            shutil.copy(notebook, self.course / 'notebooks')

    def _command(self) -> list[str]:
        return [sys.executable, '-c', MAKE_LAB, str(self.course / 'environment'), str(self._scratch), *self._options()]

    def start_again(self) -> str:
        """Type `make lab` while it runs; return what it prints."""
        return subprocess.run(self._command(), env=self.environment, stdin=subprocess.DEVNULL, capture_output=True,
                              text=True, timeout=TIMEOUT_SEC).stdout


class LabPage:
    """One notebook, open in JupyterLab in a browser."""

    def __init__(self, lab: Lab, browser: Browser, notebook: str, mode: str = 'doc'):
        # "simple", doc, shows one document, without the file browser.
        self.page: Page = browser.new_page(viewport={'width': 1280, 'height': 900})
        self.page.set_default_timeout(TIMEOUT_SEC * 1000)
        self.errors: list[str] = []
        self.page.on('console', lambda message: message.type == 'error' and self.errors.append(message.text))
        self.page.on('pageerror', lambda error: self.errors.append(error.stack or str(error)))
        # Reset, so that no earlier layout is restored.
        self.page.goto(f'{lab.url}{mode}/tree/{notebook}?token={lab.token}&reset')
        self.wait_for_kernel()

    def reload(self) -> None:
        """Save the notebook and reload the page, as a learner does with F5."""
        self.command('docmanager:save')
        self.page.reload()
        self.wait_for_kernel()

    def strange_errors(self) -> list[str]:
        """Return what the browser complained about, apart from what is known."""
        return [error for error in self.errors if not any(re.search(known, error) for known in KNOWN_ERRORS)]

    def complaints(self) -> list[str]:
        """Return the strange errors, and what the kernel has printed as errors, as of an exception in a thread."""
        printed = self.page.locator('[data-mime-type="application/vnd.jupyter.stderr"]')
        return self.strange_errors() + printed.all_inner_texts()

    def wait_for_kernel(self) -> None:
        self.page.wait_for_function('() => window.jupyterapp && window.jupyterapp.restored.then(() => true)')
        # The kernel is there when the notebook's session says so; running cells before would ask for one.
        self.page.wait_for_function('''() => {
            const panel = window.jupyterapp.shell.currentWidget;
            const kernel = panel && panel.sessionContext && panel.sessionContext.session &&
                panel.sessionContext.session.kernel;
            return kernel && kernel.connectionStatus === 'connected' && panel.content.widgets.length > 0 &&
                ['idle', 'starting', 'unknown'].includes(kernel.status);
        }''')

    def command(self, name: str, **arguments: object) -> None:
        """Execute one of JupyterLab's commands, as its menus do."""
        self.page.evaluate('([name, args]) => window.jupyterapp.commands.execute(name, args).then(() => null)',
                           [name, arguments])

    def run_all(self) -> None:
        """Run all cells and wait until each has its number."""
        self.command('notebook:run-all-cells')
        self.page.wait_for_function("""() => window.jupyterapp.shell.currentWidget.content.widgets
            .filter(cell => cell.model.type === 'code' && cell.model.sharedModel.source.trim())
            .every(cell => cell.model.executionCount !== null && cell.model.executionState !== 'running')""")

    def select_cell(self, index: int) -> None:
        """Make a cell, counted from 0 and with the Markdown ones, the one that commands work on."""
        self.page.evaluate(
            'index => { window.jupyterapp.shell.currentWidget.content.activeCellIndex = index; }', index)

    def run_cell(self, index: int) -> None:
        """Run one cell, counted as in select_cell, and wait until it has another number."""
        number = f'window.jupyterapp.shell.currentWidget.content.widgets[{index}].model.executionCount'
        before = self.page.evaluate(number) or 0
        self.select_cell(index)
        self.command('notebook:run-cell')
        self.page.wait_for_function(f'() => {number} > {before}')

    def row(self, name: str) -> Locator:
        """Find a parameter's row on the panel that is seen."""
        return self.page.locator(f'.param-row[data-name="{name}"]:visible').first

    def box(self, name: str) -> Locator:
        """Find a parameter's text box, or check box, as a screen reader does: by its label."""
        return self.row(name).get_by_label(name, exact=True)

    def slider(self, name: str) -> Locator:
        """Find a parameter's slider, which counts its positions from 0."""
        return self.row(name).get_by_role('slider')

    def message(self, name: str) -> Locator:
        """Find the message beside a parameter's control."""
        return self.row(name).locator('.param-message')


def wait_for(condition, what: str, timeout_sec: float = TIMEOUT_SEC):
    """Wait until a condition is true, and return its value: wait_until, with as long a limit as a browser's waits."""
    return wait_until(condition, what, timeout_sec)
