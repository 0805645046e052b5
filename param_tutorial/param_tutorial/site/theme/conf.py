"""Sphinx's configuration of the lessons' website; see ``param_tutorial.site``.

Nothing may come from elsewhere: no widgets' JavaScript, no fonts, no mathematics from a network of servers.
"""

from pathlib import Path
from typing import Any

from docutils import nodes  # type: ignore[import-untyped]
from sphinx.application import Sphinx

from param_tutorial.site.pages.search_index import FILE_NAME, index_script
from param_tutorial.site.pages.writing import SHEETS

project = 'Mastering ROS 2 Parameters with Python'
author = 'the course'
copyright = ''

extensions = ['myst_nb']
exclude_patterns = ['extra', 'static']
language = 'en'

# The notebooks have been run, and compared, when Sphinx gets them.
nb_execution_mode = 'off'
# By default it links two servers, for widgets; ours are drawn without them.
nb_ipywidgets_js: dict[str, dict[str, str]] = {}
nb_merge_streams = True
myst_heading_anchors = 3
myst_heading_slug_func = 'param_tutorial.site.pages.links.anchor'

html_theme = 'pydata_sphinx_theme'
html_title = 'ROS 2 Parameters'
html_favicon = '_static/icon.svg'
templates_path = ['_templates']
html_css_files = [*(Path(path).name for path in SHEETS), 'lesson.css']
html_js_files = ['lessons.js']
html_additional_pages = {'search': 'search.html'}
html_sidebars = {'**': ['lessons.html']}
html_copy_source = False
html_show_sourcelink = False
html_show_sphinx = False
html_show_copyright = False
html_use_index = False
html_domain_indices = False
html_theme_options = {
    'logo': {'text': 'ROS 2 Parameters'},
    'navbar_center': [],
    'navbar_persistent': ['search-button-field'],
    'navbar_end': ['lesson-tools.html', 'theme-switcher'],
    'article_header_start': [],
    'secondary_sidebar_items': [],
    'footer_start': ['about.html'],
    'footer_end': [],
    'show_toc_level': 1,
    'search_bar_text': 'Search the lessons …',
    'back_to_top_button': False,
    'pygments_light_style': 'a11y-high-contrast-light',
    'pygments_dark_style': 'a11y-high-contrast-dark',
}
# For pages without scripts: the others follow the reader's system, see layout.html.
html_context = {'default_mode': 'light'}


def describe(_: Sphinx, __: str, ___: str, context: dict[str, Any], page: nodes.document | None) -> None:
    """Give a page the sentence by which search engines and messengers introduce it: the chapter's question."""
    if page is not None:
        found = next(page.findall(nodes.strong), None) or next(page.findall(nodes.paragraph), None)
        context['description'] = found.astext().replace('\n', ' ')[:200] if found else ''


def leave_out_search(app: Sphinx) -> None:
    """Let Sphinx make no index: the site has its own."""
    app.builder.search = False  # type: ignore[attr-defined]


def write_index(app: Sphinx, error: Exception | None) -> None:
    """Write what the search knows."""
    if not error and 'search' in app.config.html_additional_pages:
        lessons, others = ({name: app.env.get_doctree(name) for name in names} for names in (
            app.env.toctree_includes.get(app.config.root_doc, []), app.env.found_docs & {'claims'}))
        Path(app.outdir, FILE_NAME).write_text(index_script(lessons, others), encoding='utf-8')


def setup(app: Sphinx) -> None:
    """Called by Sphinx."""
    app.connect('builder-inited', leave_out_search)
    app.connect('build-finished', write_index)
    app.connect('html-page-context', describe)
