"""One lesson as one file: whatever its page would load stands in it, and nothing leads out but the web's own links."""

import base64
import mimetypes
import re
import shutil
from pathlib import Path

import nbformat
from bs4 import BeautifulSoup

from param_tutorial.lessons import build as site_build
from param_tutorial.lessons import chapter

_URL = re.compile(r'url\((["\']?)(?!data:)([^)"\'?#]+)[^)"\']*\1\)')
_IMPORT = re.compile(r'@import "([^"]+)";')
# A page by itself has nothing to search in, and no neighbours.
_SETTINGS = {
    'html_sidebars': {'**': []},
    'html_theme_options.navbar_persistent': [],
    'html_theme_options.disable_search': True,
    'html_theme_options.show_prev_next': False,
}


def build(site: 'site_build.Site') -> Path:
    """Make the file of the one chapter of a site.

    :return: The file, in build/.
    :raises ChapterError: the chapter fails, or does not do what is stored in it.
    :raises BuildError: there are several such chapters, or Sphinx is not content.
    """
    if len(site.chapters) > 1:
        names = ', '.join(path.stem for path in site.chapters)
        raise site_build.BuildError(f'this means more than one chapter: {names}. Write more of its name.')
    path, = site.chapters
    recordings = site.record()
    folder = site.work / 'single' / path.stem
    shutil.rmtree(folder, ignore_errors=True)
    source = folder / 'source'
    source.mkdir(parents=True)
    site_build.write_static(source)
    (source / path.name).write_text(
        nbformat.writes(chapter.source(path, recordings[path], {path.stem}, alone=True)), encoding='utf-8')
    site_build.sphinx(source, folder / 'html', folder / 'doctrees', settings={'root_doc': path.stem, **_SETTINGS})
    target = site.target.parent / f'{path.stem}.html'
    target.write_text(inlined(folder / 'html' / f'{path.stem}.html'), encoding='utf-8')
    site_build.say(f'The lesson is in {site_build.shown(target)}, {target.stat().st_size / 1e6:.1f} MB')
    return target


def inlined(page: Path) -> str:
    """Give a page with everything that it loads put into it."""
    soup = BeautifulSoup(page.read_text(encoding='utf-8'), 'html.parser')
    for link in soup.select('link[href]'):
        target = page.parent / link['href'].split('?')[0]
        if 'stylesheet' in link['rel']:
            style = soup.new_tag('style')
            style.string = _style(target)
            link.replace_with(style)
        elif 'icon' in link['rel']:
            link['href'] = _data(target)
        else:
            link.decompose()
    for script in soup.select('script[src]'):
        # What is deferred runs when the page is read, and a script in the page runs where it stands: so, at the end.
        code = (page.parent / script['src'].split('?')[0]).read_text(encoding='utf-8')
        inline = soup.new_tag('script')
        inline.string = re.sub(r'</(script)', r'<\\/\1', re.sub(r'\n//# sourceMappingURL=.*', '', code))
        if script.has_attr('defer'):
            script.decompose()
            soup.body.append(inline)
        else:
            script.replace_with(inline)
    for image in soup.select('img[src]'):
        if not image['src'].startswith('data:'):
            image['src'] = _data(page.parent / image['src'])
    for link in soup.select(f'a[href^="{page.name}"]'):
        link['href'] = link['href'].removeprefix(page.name) or '#'
    return str(soup)


def _style(path: Path) -> str:
    """Give a style sheet with those that it imports, and with the fonts and pictures of all."""
    text = re.sub(r'/\*# sourceMappingURL=.*?\*/', '', path.read_text(encoding='utf-8'))
    text = _URL.sub(lambda found: f'url({_data(path.parent / found[2])})', text)
    return _IMPORT.sub(lambda found: _style(path.parent / found[1]), text)


def _data(path: Path) -> str:
    kind = mimetypes.guess_type(path.name)[0] or 'application/octet-stream'
    return f'data:{kind};base64,{base64.b64encode(path.read_bytes()).decode()}'
