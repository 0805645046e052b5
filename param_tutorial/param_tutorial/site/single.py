"""One lesson as one file: whatever its page would load stands in it, and nothing leads out but the web's own links."""

import shutil
from pathlib import Path

import nbformat

from param_tutorial.site.archive import provenance
from param_tutorial.site.build import Site, format_path
from param_tutorial.site.pages.chapter import chapter_source
from param_tutorial.site.pages.inlining import inline_page
from param_tutorial.site.pages.writing import BuildError, write_pages, write_static

# A page by itself has nothing to search in, and no neighbors.
_SETTINGS = {
    'html_sidebars': {'**': []},
    'html_theme_options.navbar_persistent': [],
    'html_theme_options.disable_search': True,
    'html_theme_options.show_prev_next': False,
}


def build(site: Site) -> Path:
    """Make the file of the one chapter of a site.

    :return: The file, in build/.
    :raises ChapterError: the chapter fails, or does not do what is stored in it.
    :raises BuildError: there are several such chapters, or Sphinx is not content.
    """
    if len(site.chapters) > 1:
        names = ', '.join(path.stem for path in site.chapters)
        raise BuildError(f'this means more than one chapter: {names}. Write more of its name.')
    path, = site.chapters
    site.live.run(site.chapters, site.notebooks)
    folder = site.work / 'single' / path.stem
    shutil.rmtree(folder, ignore_errors=True)
    source = folder / 'source'
    source.mkdir(parents=True)
    write_static(source, site.live.scripts())
    chapter = chapter_source(path, site.live.chapters[path], {path.stem}, alone=provenance())
    (source / path.name).write_text(nbformat.writes(chapter), encoding='utf-8')
    write_pages(source, folder / 'html', folder / 'doctrees',
                settings={'root_doc': path.stem, **site.live.settings(), **_SETTINGS})
    target = site.target.parent / f'{path.stem}.html'
    target.write_text(inline_page(folder / 'html' / f'{path.stem}.html'), encoding='utf-8')
    print(f'The lesson is in {format_path(target)}, {target.stat().st_size / 1e6:.1f} MB')
    return target
