"""What the search of the website finds in the chapters of the course, which are read as they are and not run."""

import nbformat
import pytest

from param_tutorial.site.live.running import LiveChapter
from param_tutorial.site.pages import chapter, writing
from tests.support.paths import NOTEBOOKS
from tests.tools.site_rules import open_page

pytestmark = [
    pytest.mark.slow, pytest.mark.thorough, pytest.mark.timeout(600),
    *(pytest.mark.filterwarnings(f'ignore::{kind}Warning') for kind in ('Deprecation', 'PendingDeprecation'))]


@pytest.fixture(scope='module')
def site(tmp_path_factory):
    """Return the folder of a site whose views are empty."""
    folder = tmp_path_factory.mktemp('course')
    source = folder / 'source'
    source.mkdir()
    paths = sorted(NOTEBOOKS.glob('[0-9]*.ipynb'))
    pages = {path.stem for path in paths}
    for path in paths:
        page = chapter.chapter_source(path, LiveChapter([], {}), pages)
        (source / path.name).write_text(nbformat.writes(page))
    names = '\n'.join(path.stem for path in paths)
    (source / 'index.md').write_text(f'# Start\n\n```{{toctree}}\n{names}\n```\n')
    claims = (NOTEBOOKS / 'claims.md').read_text()
    (source / 'claims.md').write_text(f'---\norphan: true\n---\n{claims}')
    writing.write_static(source, {})
    writing.write_pages(source, folder / 'html', folder / 'doctrees')
    return folder / 'html'


@pytest.fixture(scope='module')
def search(site, browser):
    """Return a function that searches and returns the first hits: heading, page, and what is marked."""
    with open_page(browser, (site / 'search.html').as_uri()) as page:
        def search(words, count=3):
            page.get_by_role('combobox').fill(words)
            page.wait_for_function('words => location.search === `?q=${encodeURIComponent(words)}`', arg=words)
            return page.locator('.search-hit').evaluate_all('''(hits, count) => hits.slice(0, count).map(hit => [
                hit.querySelector('.search-heading').textContent, hit.querySelector('.search-page')?.textContent || '',
                [...hit.querySelectorAll('mark')].map(mark => mark.textContent.toLowerCase())])''', count)
        yield search


def pages_of(hits):
    return [page.split(' · ')[0] for _, page, _ in hits]


def test_a_word_with_a_hyphen_is_a_word(search):
    """The pages that say "read" often are not what is meant."""
    hits = search('read-only', 5)
    assert '6.2' in pages_of(hits)[:2] and '4' not in pages_of(hits)
    assert all(marked and set(marked) == {'read-only'} for _, _, marked in hits)
    assert all('read-only' not in marked for _, _, marked in search('read', 10))
    assert [hit[:2] for hit in search('read only')] == [hit[:2] for hit in hits[:3]]


@pytest.mark.parametrize('words, page', [
    ('dump', '7.1'), ('namespace', '7.3'), ('events', '10.1'), ('declare', '3'), ('qos', '10.1'),
    ('launch file', '7.2'), ('range', '6.1'), ('on-set callback', '5.2'),
    ('--params-file', '7.1'), ('rosparam', '9.1')])
def test_the_chapter_about_it_comes_first(search, words, page):
    assert pages_of(search(words))[0] == page


def test_code_and_its_output_are_found(search):
    assert pages_of(search('qos_profile_parameter_events'))[0] == '10.1'
    found = {heading: marked for heading, _, marked in search('ParameterNotDeclaredException', 5)}
    assert set(found['Break it: a name that was never declared']) == {'parameternotdeclaredexception'}
