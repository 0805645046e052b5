"""The course for any browser, as learners work with it: the built site in real Chromium and Firefox, with clicks.

What cells put out under *Run All*, the page around the kernel, the files that stay in the browser, and the network that
nobody reaches.
"""

import contextlib
import json
import re

import nbformat
import pytest

from param_tutorial.exercises import PREDICTIONS
from param_tutorial.learner.progress import VARIABLE
from param_tutorial.site.browser import lite
from param_tutorial.site.build import Site
from param_tutorial.site.live.running import EXPLAINED, differing_cells
from tests.support import lab, lesson, missing
from tests.support.firefox import FIREFOX, firefox
from tests.support.lab import chromium
from tests.support.paths import ROOT
from tests.support.server import Server

# Sphinx and its extensions tell each other, in each release, what the next one will bring.
pytestmark = [
    pytest.mark.thorough, pytest.mark.timeout(600),  # each wait may take lab.TIMEOUT_SEC
    *(pytest.mark.filterwarnings(f'ignore::{kind}Warning') for kind in ('Deprecation', 'PendingDeprecation'))]

# Before JupyterLab finds the start page's pictures among the reader's files, the browser asks for them beside the page.
# And the browser names each request that the policy forbids; the tests make some to this machine, and none may go to
# another one.
KNOWN = r"lab/images/\w+\.svg|http://127\.0\.0\.1:\d+/'? because it violates|Fetch API cannot load http://127|" \
        r"Connecting to 'http://127|Failed to load 'http://127"


FIRST, UNTOUCHED = '01_what_are_parameters.ipynb', '04_retrieving.ipynb'
PREDICTION, EXERCISE = '1-1', '1b'
NOTEBOOKS = sorted((ROOT / 'notebooks').glob('[0-9]*.ipynb'))
RUN_OFTEN = ('03_declaring', '05_2_with_a_callback')  # with the most intended errors

# In the page: the open notebook, and what a test asks of it.
HELP = '''window.test = {
    get panel() { return [...jupyterapp.shell.widgets('main')].find(widget => widget.sessionContext); },
    get kernel() { return test.panel?.sessionContext?.session?.kernel; },
    get cells() { return test.panel.content.widgets; },
    isCode: cell => cell.model.type === 'code',
    cell: text => test.cells.findIndex(cell => test.isCode(cell) && cell.model.sharedModel.source.includes(text)),
    // What a cell shows may stand beside the text.
    output: index => {
        const {node} = test.cells[index];
        // It is on its way there.
        if (node.querySelector('[data-has-room]:not([data-is-beside])')) return document.createElement('div');
        return node.querySelector('[data-is-beside]') ? document.querySelector('.beside-text') : node;
    },
    isReady: name => test.panel?.context?.path === name && test.kernel?.status === 'idle' && test.cells?.length > 1,
    run: async index => {
        // Firefox without a window gives the focus to none.
        jupyterapp.shell.activateById(test.panel.id);
        test.panel.content.activeCellIndex = index;
        await jupyterapp.commands.execute('notebook:run-cell');
        return test.cells[index].outputArea.node.innerText;
    },
    ask: async code => {
        const future = test.kernel.requestExecute({code, store_history: false});
        let said = '';
        future.onIOPub = message => { said += message.content.text ?? message.content.evalue ?? ''; };
        await future.done;
        return said;
    },
    mark: element => {
        document.querySelector('#marked')?.removeAttribute('id');
        element.id = 'marked';
    },
};'''


class ChromiumPage:
    """A page of Chromium, asked as ``FirefoxPage`` is."""

    def __init__(self, page):
        self._page = page
        self.complaints = []
        page.set_default_timeout(lab.TIMEOUT_SEC * 1000)
        page.on('console', lambda said: said.type == 'error' and self.complaints.append(
            f'{said.text} {said.location["url"]}'))
        page.on('pageerror', lambda error: self.complaints.append(error.stack or str(error)))
        page.context.on('request', lambda request: not re.match('(blob:)?http://127.0.0.1:|data:', request.url)
                        and self.complaints.append(f'It asks another host: {request.url}'))
        self.open, self.click, self.reload = page.goto, page.click, page.reload

    def evaluate(self, expression):
        return self._page.evaluate(f'async () => await ({expression})')

    def wait_for(self, expression):
        self._page.wait_for_function(f'() => Boolean({expression})')


@pytest.fixture(scope='module')
def built(tmp_path_factory):
    """Return the folder of the built site."""
    folder = tmp_path_factory.mktemp('lite') / 'site'
    lite.build(folder)
    return folder


class Visit:
    """A learner in one browser, from the first page on."""

    def __init__(self, page, site):
        self.page, self.site = page, site

    def load(self, address):
        """Open an address of the site."""
        self.page.open(f'{self.site.url}/{address}')

    def wait_for_kernel(self, name):
        """Wait until a notebook is open and its kernel idle."""
        self.page.wait_for('window.jupyterapp?.commands.hasCommand("docmanager:open")')
        self.page.evaluate(f'(() => {{ {HELP} }})()')
        self.page.wait_for(f'test.isReady({json.dumps(name)})')

    def ask(self, code):
        """Return what the kernel prints."""
        return self.page.evaluate(f'test.ask({json.dumps(code)})').strip()

    def cell(self, text):
        """Return the position of the first code cell with this text."""
        index = self.page.evaluate(f'test.cell({json.dumps(text)})')
        assert index >= 0, text
        return index

    def run(self, index):
        """Run a cell, and return what is below it."""
        return self.page.evaluate(f'test.run({index})')

    def run_all(self):
        """Run all cells, and return the outputs of each as ``differing_cells`` takes them."""
        self.page.evaluate('jupyterapp.commands.execute("notebook:run-all-cells").then(() => null)')
        self.page.wait_for('test.cells.filter(test.isCode).every(({model}) => model.executionCount)')
        # Pyodide's kernel names an error as in <class 'ValueError'>.
        return self.page.evaluate("""test.cells.filter(test.isCode).map(({model}) => ({
            outputs: model.outputs.toJSON().map(each =>
                each.ename ? {...each, ename: each.ename.match(/\\w+(?='>)/)[0]} : each)}))""")

    def run_between(self, start, end):
        """Run the code cells from one position up to another, and that one."""
        for index in range(start, end + 1):
            if self.page.evaluate(f'test.isCode(test.cells[{index}])'):
                self.run(index)

    def write(self, index, source):
        self.page.evaluate(f'test.cells[{index}].model.sharedModel.setSource({json.dumps(source)})')

    def read(self, path):
        """Return the text of one of the learner's files."""
        return self.page.evaluate(f'jupyterapp.serviceManager.contents.get({json.dumps(path)}, '
                                  f'{{content: true, format: "text"}}).then(file => file.content)')

    def click(self, index, selector, nth=0):
        """Click something in a cell's output, once it is there."""
        found = f'test.output({index}).querySelectorAll({json.dumps(selector)})[{nth}]'
        self.page.wait_for(f'{found} && !{found}.disabled')
        self.page.evaluate(f'test.mark({found})')
        self.page.click('#marked')

    def wait_for_text(self, index, text):
        self.page.wait_for(f'test.output({index}).innerText.includes({json.dumps(text)})')

    def complaints(self):
        """Return what the browser complained about, apart from what is known."""
        return [each for each in self.page.complaints if not re.search(KNOWN, each)]


@contextlib.contextmanager
def in_chromium(_folder):
    if lab.CHROMIUM is None:
        missing.skip('there is no Chromium on the PATH: apt-get install chromium-headless-shell')
    with chromium() as browser:
        yield ChromiumPage(browser.new_context(viewport={'width': 1280, 'height': 800}).new_page())


@contextlib.contextmanager
def in_firefox(folder):
    if FIREFOX is None:
        missing.skip('there is no Firefox on the PATH: apt-get install firefox-esr')
    with firefox(folder) as page:
        page.resize(1280, 1200)  # the robot stays in view above the controls that are clicked
        yield page


@pytest.mark.parametrize('browser', [in_chromium, in_firefox])
def test_a_chapter_worked_through_and_gone_on_with_without_a_network(browser, built, tmp_path):
    """The first visit of a learner, from the link on, as one test: a kernel takes long to come."""
    with Server(built) as site, browser(tmp_path) as page:
        visit = Visit(page, site)
        visit.load('')
        page.wait_for("document.querySelector('.jp-MarkdownViewer img')?.naturalWidth > 0")
        page.click('.jp-MarkdownViewer a[href*="01_what"]')
        visit.wait_for_kernel(FIRST)
        # Now, since no service worker stood between page and server when the page came.
        reach_nobody(visit, tmp_path)
        work_through(visit)
        pull_the_cable(visit, built)
        go_on(visit)
        if browser is in_chromium:  # Firefox names no source, so what is JupyterLab's own can't be told apart
            assert visit.complaints() == []


def test_a_link_runs_no_code(built, tmp_path):
    with Server(built) as site, in_chromium(tmp_path) as page:
        visit = Visit(page, site)
        visit.load(f'lab/index.html?path={UNTOUCHED}')
        visit.wait_for_kernel(UNTOUCHED)
        assert visit.page.evaluate("""test.cells.filter(
            cell => cell.model.executionCount || cell.model.outputs?.length).length""") == 0
        assert visit.ask("print('param_tutorial' in globals())") == 'False'
        assert visit.complaints() == []


@pytest.mark.parametrize('chapter', [
    pytest.param(path, id=path.stem, marks=[] if path.stem in RUN_OFTEN else pytest.mark.rare) for path in NOTEBOOKS])
def test_run_all_goes_on_after_intended_errors_and_puts_out_what_is_stored(chapter, built, tmp_path):
    with Server(built) as site, in_chromium(tmp_path) as page:
        visit = Visit(page, site)
        visit.load(f'lab/index.html?path={chapter.name}')
        visit.wait_for_kernel(chapter.name)
        # The stored outputs are those of somebody whose progress is not kept.
        visit.ask(f"import os; os.environ.pop('{VARIABLE}')")
        known = tuple(EXPLAINED.get(chapter.stem, ()))
        assert {cell.cell.source: difference for cell, difference in differing_cells(chapter, visit.run_all())
                if not cell.cell.source.startswith(known)} == {}


def reach_nobody(visit, folder):
    with Server(folder) as outside:
        for code in (f'import js; await js.fetch({outside.url!r})',
                     f'import pyodide.http; await pyodide.http.pyfetch({outside.url!r})',
                     f'import pyodide.http; pyodide.http.open_url({outside.url!r})',
                     f'import urllib.request; urllib.request.urlopen({outside.url!r})'):
            assert visit.ask(f'{code}\nprint("reached")') not in ('', 'reached'), code
        assert visit.page.evaluate(
            f'fetch({json.dumps(outside.url)}).then(() => "reached", error => "forbidden")') == 'forbidden'
    assert outside.asked == []


def work_through(visit):
    assert visit.ask('import os; print(os.getcwd(), os.path.exists("index.md"))') == '/drive True'
    panel, question = visit.cell('ParameterPanel('), visit.cell(f"predict('{PREDICTION}')")
    visit.run_between(0, panel)
    use_panel(visit, panel)
    visit.run_between(panel + 1, question)
    predict(visit, question)
    solve(visit)


def use_panel(visit, index):
    ask = "import param_tutorial as it\nprint(it.ParameterClient('/driver').get_parameter('max_speed_mps'))"
    before = visit.ask(ask)
    visit.click(index, '.param-row[data-name="max_speed_mps"] input[type=range]')
    lab.wait_for(lambda: visit.ask(ask) != before, 'the node to have what its control says')
    visit.click(index, '.robot-view button, .robot-stage button')
    visit.wait_for_text(index, 'the wall')


def predict(visit, index):
    right = next(each for each in PREDICTIONS[PREDICTION].choices if each.is_right)
    is_veiled = f'test.cells[{index + 1}].hasClass("param-veiled")'
    assert visit.page.evaluate(is_veiled)
    line = f'test.cells[{index}].node.querySelector("input[type=range]")'
    visit.page.evaluate(f'({line}.value = {right.text}, {line}.dispatchEvent(new Event("input", {{bubbles: true}})))')
    visit.click(index, 'button')
    # That runs the next cell, in which the robot drives.
    visit.wait_for_text(index, 'Right.')
    visit.page.wait_for(f'!{is_veiled}')


def solve(visit):
    solutions = nbformat.read(ROOT / 'notebooks' / 'solutions' / '01_solutions.ipynb', as_version=4).cells
    imports, *code = [cell.source for cell in solutions if cell.cell_type == 'code']
    check = next(position for position, source in enumerate(code) if f"check('{EXERCISE}'" in source)
    index = visit.cell(f"check('{EXERCISE}'")
    given = visit.page.evaluate(f'test.cells[{index - 1}].model.sharedModel.source')
    for work, verdict in ((given, 'not yet'), (code[check - 1], 'done')):
        visit.write(index - 1, f'{imports}\n{work}')
        visit.run(index - 1)
        visit.run(index)
        visit.wait_for_text(index, f'Exercise {EXERCISE}: {verdict}')


def pull_the_cable(visit, built):
    files = re.search(r'FILES = .*?(\[".*?"\])', (built / 'service-worker.js').read_text())[1]
    lab.wait_for(lambda: visit.page.evaluate(
        'caches.keys().then(([name]) => caches.open(name)).then(kept => Promise.all('
        f'{files}.map(file => kept.match(new URL(file, {json.dumps(visit.site.url)})))'
        ')).then(all => all.every(Boolean))'
    ), 'the browser to keep all files')
    visit.site.stop()


def go_on(visit):
    index = visit.cell(f"check('{EXERCISE}'")
    visit.write(index - 1, '# mine')
    visit.page.evaluate('test.panel.context.save().then(() => null)')
    visit.page.reload()
    visit.wait_for_kernel(FIRST)
    assert visit.page.evaluate('navigator.serviceWorker.getRegistrations().then(all => all.length)') == 1
    assert visit.page.evaluate(f'test.cells[{index - 1}].model.sharedModel.source') == '# mine'
    visit.run(visit.cell('import param_tutorial'))
    assert '1 of 3 exercises solved, 1 of ' in visit.run(visit.cell('exercises.progress('))
    progress = json.loads(visit.read('progress.json'))
    assert list(progress['solved']) == [EXERCISE]
    assert {number: each['right'] for number, each in progress['predicted'].items()} == {PREDICTION: True}
    assert '| 1 1/3 | [What parameters are]' in visit.read('index.md')


DRIVER = 'ros2_ws/src/my_robot/my_robot/driver_node.py'
WRITTEN = 'print("5 °")'
SETTING = f'import asyncio\nfrom pathlib import Path\n\ndriver = Path({DRIVER!r})'
WRITE = f'driver.parent.mkdir(parents=True, exist_ok=True)\nlength = driver.write_text({WRITTEN!r})'
READ = "for path in sorted(Path('ros2_ws').rglob('*.py')):\n    print(path.name, path.read_text())"
# What JupyterLab's drive has, by the paths of the files.
KEPT = """new Promise(resolve => {
    indexedDB.open('JupyterLite Storage - /lite/').onsuccess = ({target: {result: database}}) => {
        const asking = database.transaction('files').objectStore('files').getAll();
        asking.onsuccess = () => resolve(Object.fromEntries(asking.result.filter(
            each => each.type === 'file').map(each => [each.path, atob(each.content)])));
        database.close();
    };
})"""


@pytest.fixture(scope='module')
def lessons(built, tmp_path_factory):
    """Return the folder of a site of two lessons and JupyterLab."""
    folder = tmp_path_factory.mktemp('lessons')
    (folder / 'notebooks').mkdir()
    (folder / 'notebooks' / 'index.md').write_text('# Start\n\n[Write](3_write.ipynb)\n\n[Read](4_read.ipynb)\n')
    lesson.write(folder / 'notebooks' / '3_write.ipynb', ('# 3 · Write', SETTING, 'It writes:', WRITE))
    lesson.write(folder / 'notebooks' / '4_read.ipynb', ('# 4 · Read', SETTING, 'It reads:', READ))
    site = Site(folder / 'notebooks', folder / 'html', folder / 'work')
    site.build()
    (site.target / 'lite').symlink_to(built)
    return site.target


def run_in_lesson(page, code):
    """Run a cell of a lesson, and return what it puts out."""
    cell = f'[...document.querySelectorAll("div.cell")].find(each => each.innerText.includes({json.dumps(code)}))'
    page.wait_for(f'{cell}?.querySelector(".live-button")')
    page.evaluate(f'void ({cell}.querySelector(".live-button").id = "run")')
    page.click('#run')
    page.wait_for('document.documentElement.dataset.node === "awake" && !document.querySelector("[aria-busy]")')
    return page.evaluate('document.querySelector(".cell:has(#run)").querySelector(".cell_output")?.innerText')


def write_in_lesson(page, code):
    """Run code in place of a lesson's last cell, and don't wait."""
    cell = page._page.locator('div.cell:has(.live-tools)').last
    cell.get_by_role('button', name='Edit the code of this cell').click()
    cell.get_by_role('textbox', name='The code of this cell').fill(code)
    cell.get_by_role('button', name='Run this cell').click()


def wait_until_kept(page, content, path=DRIVER):
    lab.wait_for(lambda: page.evaluate(KEPT).get(path) == content, f'the browser to keep {content!r}')


@pytest.mark.parametrize('browser', [in_chromium, in_firefox])
def test_lessons_and_jupyterlab_have_one_package_of_the_reader(browser, lessons, tmp_path):
    with Server(lessons) as site, browser(tmp_path) as page:
        page.open(f'{site.url}/3_write.html')
        run_in_lesson(page, 'length =')
        wait_until_kept(page, WRITTEN.encode().decode('latin-1'))
        page.open(f'{site.url}/4_read.html')
        assert run_in_lesson(page, 'rglob').strip() == f'driver_node.py {WRITTEN}'
        visit = Visit(page, site)
        visit.load(f'lite/lab/index.html?path={UNTOUCHED}')
        visit.wait_for_kernel(UNTOUCHED)
        assert visit.read(DRIVER) == WRITTEN
        assert visit.ask(f'from pathlib import Path\nprint(Path({DRIVER!r}).read_text())') == WRITTEN
        visit.ask(f"Path({DRIVER!r}).with_name('tuner_node.py').write_text('of Lab')")
        page.evaluate(f'jupyterapp.serviceManager.contents.save({json.dumps(DRIVER)}, '
                      '{type: "file", format: "text", content: "Lab’s"}).then(() => null)')
        page.open(f'{site.url}/4_read.html')
        assert run_in_lesson(page, 'rglob').split('\n') == ['driver_node.py Lab’s', 'tuner_node.py of Lab', '']


def test_a_page_loses_no_file_of_the_reader(lessons, tmp_path):
    with Server(lessons) as site, in_chromium(tmp_path) as page:
        other = ChromiumPage(page._page.context.new_page())
        for each in (page, other):
            each.open(f'{site.url}/3_write.html')
            run_in_lesson(each, 'length =')
        # Also what a callback writes after its cell, and what a cell writes that never ends.
        write_in_lesson(page, "later = asyncio.get_running_loop().call_later(0.5, driver.write_text, 'first')")
        wait_until_kept(page, 'first')
        write_in_lesson(other, "driver.write_text('second')\nwhile True:\n    pass")
        wait_until_kept(page, 'second')
        page.open(f'{site.url}/4_read.html')
        assert run_in_lesson(page, 'rglob').split('\n') == ['driver_node.py first', 'driver_node.py second', '']
        write_in_lesson(page, 'driver.unlink()')
        wait_until_kept(page, None)
        assert sorted(page.evaluate(KEPT).values()) == ['first', 'second']
