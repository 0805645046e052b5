"""What makes a page unusable for some people, by the rules of axe-core."""

from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import expect

_WCAG = ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa']
# Without preload axe fetches no style sheets, which a page on a disk may not do.
OPTIONS = {'runOnly': {'type': 'tag', 'values': _WCAG}, 'resultTypes': ['violations'], 'preload': False}


def violations(page, context=None, options=OPTIONS):
    """Return what axe finds on a page, or in a part of it."""
    found = Axe().run(page, context=context, options=options).response['violations']
    return [f'{rule["id"]}: {node["html"][:200]} {node["failureSummary"]}' for rule in found for node in rule['nodes']]


def violations_in_both_themes(page, context, options=OPTIONS):
    """Return what axe finds in a part of a page of JupyterLab, which has its light theme afterwards."""
    found = []
    for scheme, theme in (('dark', 'JupyterLab Dark'), ('light', 'JupyterLab Light')):
        page.emulate_media(color_scheme=scheme)  # which JupyterLab follows
        expect(page.locator('body')).to_have_attribute('data-jp-theme-name', theme)
        found += [f'{scheme}, {each}' for each in violations(page, context, options)]
    return found
