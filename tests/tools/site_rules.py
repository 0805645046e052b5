"""What holds for every page of the HTML lessons: nothing from elsewhere, no complaint, and open to everybody.

Run by itself it holds a whole site to that: `.venv/bin/python -m tests.tools.site_rules build/html`.
"""

import contextlib
import sys
from pathlib import Path

from playwright.sync_api import TimeoutError as PlaywrightTimeoutError

from tests.support.axe import violations
from tests.support.lab import chromium

MAX_LESSON_BYTES = 3_000_000
# Up to here web.dev calls a page good: https://web.dev/articles/cls.
MAX_LAYOUT_SHIFT = 0.1
MIN_LETTERS_PX = 11
_SUM_UP_LAYOUT_SHIFTS = '''
    window.layoutShift = 0;
    new PerformanceObserver(list => { for (const each of list.getEntries()) window.layoutShift += each.value; })
        .observe({type: 'layout-shift', buffered: true});'''

# The sizes of all letters that are drawn, each with the words; those of a picture are as large as its scale makes them.
_SIZES_OF_LETTERS = '''() => {
    const found = [];
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    while (walker.nextNode()) {
        const words = walker.currentNode.data.trim();
        const element = walker.currentNode.parentElement;
        if (!words || !element.checkVisibility() || !element.getClientRects().length) continue;
        const scale = element.ownerSVGElement ? element.getScreenCTM() : {a: 1, b: 0};
        found.push([parseFloat(getComputedStyle(element).fontSize) * Math.hypot(scale.a, scale.b), words]);
    }
    return found }'''

# Texts and pictures that scroll sideways, and don't show it at their edge or can't be reached by the keyboard.
_SCROLLS_UNNOTICED = '''() => [...document.querySelectorAll('.bd-article :is(pre, :has(> svg))')].filter(each => {
    const {backgroundImage, maskImage, overflowX} = getComputedStyle(each);
    return overflowX === 'auto' && each.scrollWidth > each.clientWidth
        && (each.tabIndex !== 0 || !`${backgroundImage}${maskImage}`.includes('gradient')) })
    .map(each => each.outerHTML.slice(0, 100))'''


@contextlib.contextmanager
def open_page(browser, address, *, scheme='light', width=1280):
    """Open a page of the site, and check afterward that it asked no other server and reported no error."""
    context = browser.new_context(viewport={'width': width, 'height': 900}, color_scheme=scheme)
    page = context.new_page()
    complaints = []
    here = address.partition('?')[0].rpartition('/')[0]
    page.on('console', lambda said: said.type == 'error' and complaints.append(said.text))
    page.on('pageerror', lambda error: complaints.append(error.stack or str(error)))
    page.on('request', lambda request: request.url.startswith((here, 'data:', 'blob:'))
            or complaints.append(f'requested {request.url}'))
    # Who leaves a page breaks off what it still loads.
    page.on('requestfailed', lambda request: request.failure == 'net::ERR_ABORTED'
            or complaints.append(f'failed {request.url}: {request.failure}'))
    page.add_init_script(_SUM_UP_LAYOUT_SHIFTS)
    page.goto(address)
    page.wait_for_function("document.documentElement.dataset.lesson === 'ready'")
    yield page
    assert not complaints, '; '.join(complaints)
    context.close()


def check_page(page):
    """Return in words what makes a page unusable for some people."""
    shift = page.evaluate('window.layoutShift')
    # What is closed would not be looked at.
    page.evaluate("document.querySelectorAll('details').forEach(each => each.open = true)")
    page.evaluate("document.querySelectorAll('.lesson-look button').forEach(each => each.click())")
    # Who may scroll is told in the next frame, and by the theme's script in 300 ms.
    with contextlib.suppress(PlaywrightTimeoutError):
        page.wait_for_function(f'!({_SCROLLS_UNNOTICED})().length', timeout=5000)
    unnoticed = page.evaluate(_SCROLLS_UNNOTICED)
    # Axe judges no colors before a gradient, and one lies behind all code: the sign that it scrolls.
    page.add_style_tag(content='.bd-article * { background-image: none !important; }')
    found = violations(page)
    found += [f'{each} scrolls sideways without a sign, or out of the keyboard’s reach' for each in unnoticed]
    too_wide = page.evaluate('document.documentElement.scrollWidth > innerWidth')
    undrawn = page.evaluate('''() => [...document.querySelectorAll('.live-view')]
        .filter(each => each.checkVisibility() && !each.offsetHeight).map(each => each.innerHTML.slice(0, 100))''')
    lost = page.evaluate('''() => [...document.querySelectorAll('a[href^="#"]')].filter(each => each.hash.length > 1
        && !document.getElementById(decodeURIComponent(each.hash.slice(1)))).map(each => each.hash)''')
    found += [f'a link leads to {each}, which is not on the page' for each in lost]
    found += [f'“{words[:60]}” has letters of {size:.1f} px' for size, words in page.evaluate(_SIZES_OF_LETTERS)
              if size < MIN_LETTERS_PX]
    # On a phone's screen one line more is a tenth, and a browser may draw a paragraph before it has read its end.
    if shift > MAX_LAYOUT_SHIFT and page.viewport_size['width'] > 1000:
        found.append(f'what stands on it moves while it is loaded: a layout shift of {shift:.2f}')
    return found + ['the page is wider than the window'] * too_wide + [f'{each} is not drawn' for each in undrawn]


def main(folder):
    """Check every page of a site, and print what is wrong."""
    problems = []
    with chromium() as browser:
        for path in sorted(folder.glob('*.html')):
            if path.stat().st_size > MAX_LESSON_BYTES:
                problems.append(f'{path.name}: {path.stat().st_size / 1e6:.1f} MB')
            # 320 px are a window of 1280 px at 400 %.
            for scheme, width in (('light', 1280), ('dark', 390), ('light', 320)):
                try:
                    with open_page(browser, path.absolute().as_uri(), scheme=scheme, width=width) as page:
                        problems += [f'{path.name}, {scheme}, {width} px: {each}' for each in check_page(page)]
                except AssertionError as error:
                    problems.append(f'{path.name}, {scheme}, {width} px: {error}')
            print(f'{path.name} checked', flush=True)
    print(*problems, sep='\n')
    print(f'{len(list(folder.glob("*.html")))} pages checked, {len(problems)} problems')
    return 1 if problems else 0


if __name__ == '__main__':
    sys.exit(main(Path(sys.argv[1])))
