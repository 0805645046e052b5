"""Lets Sphinx write pages; its configuration, and the site's style and script, are in ``site/theme``."""

import os
import re
import shutil
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx
from sphinx.util.docutils import docutils_namespace

from param_tools.markup.styles import sheet
from param_tutorial.site.bundling import bundle

THEME = Path(__file__).parents[1] / 'theme'
# The styles of the notebook's own views.
SHEETS = ('param_tutorial/views/drawing/track.css', 'param_tools/panel/panel.css',
          'param_tutorial/views/side_by_side.css')
_COLOR = re.compile(r'\x1b\[[0-9;]*m')


class BuildError(Exception):
    """The site cannot be made; the message is for the person who builds it."""


def write_static(source: Path, live: Mapping[str, str]) -> None:
    """Write the scripts of all pages, and the styles of the notebook's own views, beside Sphinx's sources.

    :param live: The scripts that the pages' kernels need, by their names.
    """
    (source / 'static').mkdir(exist_ok=True)
    for name, text in live.items():
        (source / 'static' / name).write_text(text, encoding='utf-8')
    (source / 'static' / 'lessons.js').write_text(bundle('scripts/main.js'), encoding='utf-8')
    for path in SHEETS:
        (source / 'static' / Path(path).name).write_text(sheet(path), encoding='utf-8')


def write_pages(source: Path, target: Path, doctrees: Path, *,
                settings: dict[str, Any] | None = None) -> None:
    """Let Sphinx write pages.

    :param settings: Sphinx's, in place of those in its configuration.
    :raises BuildError: it warns of something; the message is what it says.
    """
    target.mkdir(parents=True, exist_ok=True)
    extra = source / 'extra'
    settings = {'html_static_path': [str(THEME / '_static'), str(source / 'static')],
                'html_extra_path': [str(extra)] if extra.exists() else [], **(settings or {})}
    warnings = Path(f'{doctrees}.warnings')
    warnings.parent.mkdir(parents=True, exist_ok=True)
    with warnings.open('w+', encoding='utf-8') as said, docutils_namespace():
        app = Sphinx(str(source), str(THEME), str(target), str(doctrees), 'html', confoverrides=settings,
                     status=None, warning=said, parallel=os.cpu_count() or 1)
        app.build()
        said.seek(0)
        text = _COLOR.sub('', said.read()).strip()
    if app.statuscode or text:
        # A page with a warning is in Sphinx's memory already and would not be warned of again.
        shutil.rmtree(doctrees, ignore_errors=True)
        raise BuildError(f'Sphinx is not content with the pages:\n{text}')
