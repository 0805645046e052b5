"""The system's Firefox, driven by WebDriver BiDi, the little of it that tests need: https://w3c.github.io/webdriver-bidi/.

    with firefox(tmp_path) as page:
        page.open(address)
        page.evaluate('document.title')

Playwright's BiDi needs a newer Firefox than Debian's ESR, and Debian has no geckodriver for Selenium.
"""

import contextlib
import itertools
import json
import re
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from websocket import WebSocket, create_connection

from tests.support.lab import TIMEOUT_SEC, wait_for
from tests.support.processes import wait_or_kill

FIREFOX = next(filter(None, map(shutil.which, ('firefox-esr', 'firefox'))), None)
# It finds no server on the internet.
PREFERENCES = 'user_pref("network.dns.disabled", true);\n'


class FirefoxPage:
    """The one tab of a Firefox."""

    def __init__(self, connection: WebSocket) -> None:
        self._connection = connection
        self._numbers = itertools.count(1)
        self.complaints: list[str] = []
        """The errors that pages wrote to the console, and those that their scripts raised."""
        self._ask('session.new', capabilities={})
        self._ask('session.subscribe', events=['log.entryAdded'])
        self._tab = self._ask('browsingContext.getTree')['contexts'][0]['context']

    def open(self, address: str) -> None:
        """Open a page, and wait until it is loaded."""
        self._ask('browsingContext.navigate', context=self._tab, url=address, wait='complete')

    def reload(self) -> None:
        """Load the page again, as F5 does."""
        self._ask('browsingContext.reload', context=self._tab, wait='complete')

    def resize(self, width: int, height: int) -> None:
        """Give the page another size, in pixels."""
        self._ask('browsingContext.setViewport', context=self._tab, viewport={'width': width, 'height': height})

    def evaluate(self, expression: str) -> Any:
        """Return the value of an expression, or of what it promises, through JSON."""
        value = self._run(f'(async () => JSON.stringify(await ({expression})))()').get('value')
        return None if value is None else json.loads(value)

    def wait_for(self, expression: str) -> None:
        """Wait until an expression is true."""
        wait_for(lambda: self.evaluate(f'Boolean({expression})'), expression)

    def press(self, *keys: str) -> None:
        """Press keys one after another, each by its letter or by its code point in WebDriver's table."""
        self._act('key', [{'type': kind, 'value': key} for key in keys for kind in ('keyDown', 'keyUp')])

    def click(self, selector: str) -> None:
        """Press the mouse's button in the middle of an element, after scrolling there."""
        # What is drawn follows the scrolling a frame later, and the mouse hits what is drawn.
        found = self._run(f"""(async each => {{
            each.scrollIntoView({{block: 'center', behavior: 'instant'}});
            for (let frame = 0; frame < 3; frame += 1) await new Promise(requestAnimationFrame);
            return each; }})(document.querySelector({json.dumps(selector)}))""")
        origin = {'type': 'element', 'element': {'sharedId': found['sharedId']}}
        self._act('pointer', [{'type': 'pointerMove', 'x': 0, 'y': 0, 'origin': origin},
                              {'type': 'pointerDown', 'button': 0}, {'type': 'pointerUp', 'button': 0}])

    def _act(self, device: str, actions: list[dict[str, Any]]) -> None:
        self._ask('input.performActions', context=self._tab,
                  actions=[{'type': device, 'id': device, 'actions': actions}])

    def _run(self, expression: str) -> dict[str, Any]:
        """Return the value of an expression, in BiDi's terms."""
        answer = self._ask('script.evaluate', expression=expression, target={'context': self._tab}, awaitPromise=True,
                           userActivation=True)
        assert answer['type'] == 'success', answer
        return dict(answer['result'])

    def _ask(self, method: str, **parameters: Any) -> Any:
        number = next(self._numbers)
        self._connection.send(json.dumps({'id': number, 'method': method, 'params': parameters}))
        while True:
            answer = json.loads(self._connection.recv())
            if answer.get('method') == 'log.entryAdded' and answer['params']['level'] == 'error':
                self.complaints.append(str(answer['params']['text']))
            if answer.get('id') == number:
                assert answer['type'] == 'success', (method, answer)
                return answer['result']


@contextlib.contextmanager
def firefox(folder: Path) -> Iterator[FirefoxPage]:
    """Start a Firefox without windows, with a profile of its own in a folder, and end it."""
    assert FIREFOX, 'there is no Firefox on the PATH'
    (folder / 'user.js').write_text(PREFERENCES)
    # A suite that is interrupted kills its workers, and this must not outlive them.
    process = subprocess.Popen(
        ['setpriv', '--pdeathsig', 'KILL', '--', FIREFOX, '--headless', '--no-remote', '--profile', folder,
         '--remote-debugging-port=0', 'about:blank'],
        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    assert process.stderr
    try:
        found = next(filter(None, (re.search(r'BiDi listening on (ws://\S+)', line) for line in process.stderr)))
        with contextlib.closing(create_connection(f'{found[1]}/session', timeout=TIMEOUT_SEC,
                                                  suppress_origin=True)) as connection:
            yield FirefoxPage(connection)
    finally:
        process.terminate()
        wait_or_kill(process)
        process.stderr.close()
