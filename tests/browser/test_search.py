"""What the search of the website finds in the chapters of the course, which are read as they are and not run."""

import json
import re

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
    writing.write_pages(source, folder / 'html', folder / 'doctrees', processes=2)
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


def test_a_command_leads_to_the_chapter_about_it(search):
    assert pages_of(search('dump'))[0] == '7.1'


def test_a_word_with_a_hyphen_is_a_word(search):
    """The pages that say "read" often are not what is meant."""
    hits = search('read-only', 5)
    assert '6.2' in pages_of(hits)[:2] and '4' not in pages_of(hits)
    assert all(marked and set(marked) == {'read-only'} for _, _, marked in hits)
    assert all('read-only' not in marked for _, _, marked in search('read', 10))
    assert [hit[:2] for hit in search('read only')] == [hit[:2] for hit in hits[:3]]


@pytest.mark.parametrize('words, page', [
    ('namespace', '7.3'), ('events', '10.1'), ('declare', '3'), ('qos', '10.1'), ('launch file', '7.2'),
    ('range', '6.1'), ('on-set callback', '5.2'), ('--params-file', '7.1'), ('rosparam', '9.1')])
def test_the_chapter_about_it_comes_first(search, words, page):
    assert pages_of(search(words))[0] == page


@pytest.mark.parametrize('word', ['set', 'read'])
def test_whole_words_and_their_other_forms_come_before_parts_of_words(search, site, word):
    index = json.loads((site / 'searchindex.js').read_text().partition(' = ')[2].rstrip().rstrip(';'))
    texts = {(each['heading'], '' if each['heading'] == page['title'] else page['title']):
             ' '.join((page['title'], each['heading'], each['prose'], each['code']))
             for page in index for each in page['sections']}
    whole = re.compile(rf'(?<!\w)(?<!\w-){word}(s|es|d|ed|ing)?(?!\w)(?!-\w)', re.IGNORECASE)
    hits = [bool(whole.search(texts[heading, page])) for heading, page, _ in search(word, 1000)]
    assert True in hits and False in hits
    assert hits == sorted(hits, reverse=True)


def test_other_forms_of_a_word(search):
    assert 'declared' in search('declaring', 1)[0][2]


def test_code_and_its_output_are_found(search):
    assert pages_of(search('qos_profile_parameter_events'))[0] == '10.1'
    found = {heading: marked for heading, _, marked in search('ParameterNotDeclaredException', 5)}
    assert set(found['Break it: a name that was never declared']) == {'parameternotdeclaredexception'}


def test_all_words_are_wanted_and_some_are_better_than_none(search):
    found = search('launch namespace', 30)
    assert found and len(found) < min(len(search('launch', 100)), len(search('namespace', 100)))
    assert search('namespace nobodywroteit', 1)[0][1].startswith('7.3')
