"""Make pictures of a notebook in JupyterLab, with real pixels.

    .venv/bin/python -m tests.tools.screenshots notebooks/03_declaring.ipynb build/screenshots

Without a notebook it takes two small ones, in all themes and widths: that is for looking at the panel.
"""

import argparse
import tempfile
from pathlib import Path

from playwright.sync_api import expect

from tests.support import lesson
from tests.support.lab import Lab, LabPage, chromium

LOOKS = {
    'light': {'width': 1280, 'height': 1000},
    'dark': {'width': 1280, 'height': 1000, 'theme': 'JupyterLab Dark'},
    'narrow': {'width': 480, 'height': 1400},
}


def shoot(notebook: Path, folder: Path, looks: list[str], scale: float, scroll_to: str) -> None:
    """Save one picture of the notebook for each look."""
    with tempfile.TemporaryDirectory() as scratch, Lab(Path(scratch) / 'lab', [notebook]) as lab, \
            chromium() as browser:
        for look in looks:
            page = LabPage(lab, browser, notebook.name, scale=scale, **LOOKS[look])
            page.run_all()
            panel = page.page.locator(scroll_to).first
            expect(panel).to_be_visible()
            panel.scroll_into_view_if_needed()
            page.page.wait_for_function('document.fonts.ready.then(() => true)')
            path = folder / f'{notebook.stem}_{look}.png'
            page.page.screenshot(path=path)
            print(path, *page.errors, sep='\n  ')
            page.page.close()


def main() -> None:
    """Read the command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('notebook', nargs='?', type=Path)
    parser.add_argument('folder', nargs='?', type=Path, default=Path('build/screenshots'))
    parser.add_argument('--look', action='append', choices=LOOKS, help='by default all')
    parser.add_argument('--scale', type=float, default=1.0, help='pixels of the picture for each of the page')
    parser.add_argument('--scroll-to', default='.param-panel', help='a CSS selector that should be in the picture')
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    looks = options.look or list(LOOKS)
    if options.notebook:
        shoot(options.notebook, options.folder, looks, options.scale, options.scroll_to)
        return
    with tempfile.TemporaryDirectory() as scratch:
        for name, cells in (('lesson', lesson.LESSON), ('all_types', lesson.ALL_TYPES)):
            notebook = lesson.write(Path(scratch) / f'{name}.ipynb', cells)
            shoot(notebook, options.folder, looks, options.scale, options.scroll_to)


if __name__ == '__main__':
    main()
