"""Sphinx's configuration of the lessons' website; see ``param_tutorial.site``.

Nothing may come from elsewhere: no widgets' JavaScript, no fonts, no mathematics from a network of servers.
"""

from pathlib import Path
from typing import Any

from docutils import nodes  # type: ignore[import-untyped]
from sphinx.application import Sphinx

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
# A page on a disk may not fetch the pages that are found, nor may those on the web.
html_show_search_summary = False
html_search_scorer = str(Path(__file__).with_name('search.js'))
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
    'article_header_start': ['lesson-tools.html'],
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


def hide_outputs_from_search(_: Sphinx, document: nodes.document, __: str) -> None:
    """Keep outputs out of the search's index: predictions, hints and solutions are among them."""
    for node in document.findall(nodes.container):
        if node.get('nb_element') == 'cell_code_output':
            node['classes'].append('no-search')


def setup(app: Sphinx) -> None:
    """Called by Sphinx."""
    app.connect('doctree-resolved', hide_outputs_from_search)
    app.connect('html-page-context', describe)
