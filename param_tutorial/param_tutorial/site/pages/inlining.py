"""One page as one file: whatever the page would load stands in it."""

import base64
import mimetypes
import re
from pathlib import Path

from bs4 import BeautifulSoup, Tag

_URL = re.compile(r'url\((["\']?)(?!data:)([^)"\'?#]+)[^)"\']*\1\)')
_IMPORT = re.compile(r'@import "([^"]+)";')


def inline_page(page: Path) -> str:
    """Return a page with everything that it loads put into it."""
    soup = BeautifulSoup(page.read_text(encoding='utf-8'), 'html.parser')
    body = soup.body or soup
    for link in soup.select('link[href]'):
        target = page.parent / _attribute(link, 'href').split('?')[0]
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
        code = (page.parent / _attribute(script, 'src').split('?')[0]).read_text(encoding='utf-8')
        inline = soup.new_tag('script')
        inline.string = re.sub(r'</(script)', r'<\\/\1', re.sub(r'\n//# sourceMappingURL=.*', '', code))
        if script.has_attr('defer'):
            script.decompose()
            body.append(inline)
        else:
            script.replace_with(inline)
    for part in soup.select('script[data-source]'):
        part.string = (page.parent / _attribute(part, 'data-source')).read_text(encoding='utf-8')
        del part['data-source']
    for image in soup.select('img[src]'):
        if not (source := _attribute(image, 'src')).startswith('data:'):
            image['src'] = _data(page.parent / source)
    for link in soup.select(f'a[href^="{page.name}"]'):
        link['href'] = _attribute(link, 'href').removeprefix(page.name) or '#'
    return str(soup)


def _attribute(tag: Tag, name: str) -> str:
    """Return an attribute that has one value; Beautiful Soup splits others, such as class, into a list."""
    value = tag[name]
    assert isinstance(value, str)
    return value


def _style(path: Path) -> str:
    """Return a style sheet with those that it imports, and with the fonts and pictures of all."""
    text = re.sub(r'/\*# sourceMappingURL=.*?\*/', '', path.read_text(encoding='utf-8'))
    text = _URL.sub(lambda found: f'url({_data(path.parent / found[2])})', text)
    return _IMPORT.sub(lambda found: _style(path.parent / found[1]), text)


def _data(path: Path) -> str:
    """Return a file as a data URL."""
    kind = mimetypes.guess_type(path.name)[0] or 'application/octet-stream'
    return f'data:{kind};base64,{base64.b64encode(path.read_bytes()).decode()}'
