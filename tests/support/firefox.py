"""Drive the system's Firefox by WebDriver BiDi, the little of it that tests need: https://w3c.github.io/webdriver-bidi/.

    with firefox(tmp_path) as page:
        page.open(address)
        page.evaluate('document.title')

Playwright brings a Firefox of its own, which cannot be had here; the one that readers have speaks BiDi by itself.
"""

import base64
import contextlib
import itertools
import json
import re
import shutil
import subprocess
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from websocket import WebSocket, create_connection

from tests.support.processes import wait_or_kill

FIREFOX = next(filter(None, map(shutil.which, ('firefox-esr', 'firefox'))), None)
TIMEOUT_SEC = 120.0
# It asks no server on the internet, and shows no page of its own.
_PREFERENCES = {
    'app.normandy.enabled': False, 'app.update.enabled': False, 'browser.aboutwelcome.enabled': False,
    'browser.newtabpage.enabled': False, 'browser.safebrowsing.downloads.remote.enabled': False,
    'browser.shell.checkDefaultBrowser': False, 'browser.startup.homepage_override.mstone': 'ignore',
    'datareporting.policy.dataSubmissionEnabled': False, 'extensions.update.enabled': False,
    'network.captive-portal-service.enabled': False, 'network.connectivity-service.enabled': False,
    'network.dns.disabled': True, 'services.settings.server': 'data:,', 'toolkit.telemetry.enabled': False,
}


class FirefoxError(Exception):
    """Firefox rejected a command, or a script in the page raised an error."""


class FirefoxPage:
    """The one tab of a Firefox."""

    def __init__(self, connection: WebSocket) -> None:
        self._connection = connection
        self._numbers = itertools.count(1)
        self.complaints: list[str] = []
        """The errors that pages wrote to the console, and those that their scripts raised."""
        self._ask('session.new', capabilities={})
        self._tab = self._ask('browsingContext.getTree')['contexts'][0]['context']
        self._ask('session.subscribe', events=['log.entryAdded'])

    def open(self, address: str) -> None:
        """Open a page, and wait until it is loaded."""
        self._ask('browsingContext.navigate', context=self._tab, url=address, wait='complete')

    def reload(self) -> None:
        """Load the page again, as F5 does."""
        self._ask('browsingContext.reload', context=self._tab, wait='complete')

    def resize(self, width: int, height: int) -> None:
        """Resize the page, in CSS pixels."""
        self._ask('browsingContext.setViewport', context=self._tab, viewport={'width': width, 'height': height})

    def evaluate(self, expression: str) -> Any:
        """Return the value of an expression, or of what it promises, through JSON.

        :raises FirefoxError: it raises.
        """
        value = self._run(f'(async () => JSON.stringify(await ({expression})))()').get('value')
        return None if value is None else json.loads(value)

    def wait_for(self, expression: str) -> None:
        """Wait until an expression is true.

        :raises FirefoxError: it isn't in time, or raises.
        """
        deadline = time.monotonic() + TIMEOUT_SEC
        while not self.evaluate(f'Boolean({expression})'):
            if time.monotonic() > deadline:
                raise FirefoxError(f'timed out after {TIMEOUT_SEC:.0f} s waiting for {expression}')
            time.sleep(0.05)

    def press(self, *keys: str) -> None:
        """Press keys one after another, each by its letter or by its code point in WebDriver's table."""
        actions = [{'type': kind, 'value': key} for key in keys for kind in ('keyDown', 'keyUp')]
        self._ask('input.performActions', context=self._tab,
                  actions=[{'type': 'key', 'id': 'keyboard', 'actions': actions}])

    def click(self, selector: str) -> None:
        """Press the mouse's button in the middle of an element, after scrolling there."""
        # What is drawn follows the scrolling a frame later, and the mouse hits what is drawn.
        found = self._run(f"""(async each => {{
            each.scrollIntoView({{block: 'center', behavior: 'instant'}});
            for (let frame = 0; frame < 3; frame += 1) await new Promise(requestAnimationFrame);
            return each; }})(document.querySelector({json.dumps(selector)}))""")
        origin = {'type': 'element', 'element': {'sharedId': found['sharedId']}}
        self._ask('input.performActions', context=self._tab, actions=[{'type': 'pointer', 'id': 'mouse', 'actions': [
            {'type': 'pointerMove', 'x': 0, 'y': 0, 'origin': origin}, {'type': 'pointerDown', 'button': 0},
            {'type': 'pointerUp', 'button': 0}]}])

    def screenshot(self, path: Path) -> None:
        """Save a picture of the visible part."""
        path.write_bytes(base64.b64decode(self._ask('browsingContext.captureScreenshot', context=self._tab)['data']))

    def _run(self, expression: str) -> dict[str, Any]:
        """Return the value of an expression, in BiDi's terms."""
        answer = self._ask('script.evaluate', expression=expression, target={'context': self._tab}, awaitPromise=True,
                           userActivation=True)
        if answer['type'] != 'success':
            raise FirefoxError(answer['exceptionDetails']['text'])
        return dict(answer['result'])

    def _ask(self, method: str, **parameters: Any) -> Any:
        number = next(self._numbers)
        self._connection.send(json.dumps({'id': number, 'method': method, 'params': parameters}))
        while True:
            answer = json.loads(self._connection.recv())
            if answer.get('method') == 'log.entryAdded' and answer['params']['level'] == 'error':
                self.complaints.append(str(answer['params']['text']))
            if answer.get('id') == number:
                if answer['type'] == 'error':
                    raise FirefoxError(f'{method}: {answer["message"]}')
                return answer['result']


@contextlib.contextmanager
def firefox(folder: Path) -> Iterator[FirefoxPage]:
    """Start a Firefox without windows, with a profile of its own in a folder, and end it.

    :raises FirefoxError: it does not start.
    """
    assert FIREFOX, 'there is no Firefox on the PATH'
    profile = folder / 'firefox'
    profile.mkdir(parents=True)
    (profile / 'user.js').write_text(''.join(
        f'user_pref({json.dumps(name)}, {json.dumps(value)});\n' for name, value in _PREFERENCES.items()))
    # A suite that is interrupted kills its workers, and this must not outlive them.
    process = subprocess.Popen(
        ['setpriv', '--pdeathsig', 'KILL', '--', FIREFOX, '--headless', '--no-remote', '--profile', profile,
         '--remote-debugging-port=0', 'about:blank'],
        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    assert process.stderr
    try:
        for line in process.stderr:
            if found := re.search(r'WebDriver BiDi listening on (ws://\S+)', line):
                break
        else:
            raise FirefoxError(f'Firefox ended with status {process.wait()} before it listened.')
        with contextlib.closing(create_connection(f'{found[1]}/session', timeout=TIMEOUT_SEC,
                                                  suppress_origin=True)) as connection:
            yield FirefoxPage(connection)
    finally:
        process.terminate()
        wait_or_kill(process)
        process.stderr.close()
