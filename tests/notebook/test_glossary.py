"""The glossary of the course says what the chapters say, all of it and in order."""

import json

import pytest

from param_tutorial.notebook.glossary import Glossary
from tests.support.paths import NOTEBOOKS


def chapter(folder, name, *cells):
    (folder / name).write_text(json.dumps({'cells': [
        {'cell_type': 'markdown', 'source': cell.splitlines(keepends=True)} for cell in cells]}))


@pytest.fixture
def folder(tmp_path):
    chapter(tmp_path, '02_first.ipynb', '# 2 · First', '## End\n\n| word | meaning |\n| --- | --- |\n'
            '| to set | to give a value, a `x | y` or < 3 |\n| `-p` | an option |\n\nNext')
    chapter(tmp_path, '10_1_second.ipynb', '# 10.1 · Second',
            '| word | meaning |\n| --- | --- |\n| node | a program |\n| to set | to ask for it |')
    chapter(tmp_path, 'index.ipynb', '| word | meaning |\n| --- | --- |\n| none | no chapter |')
    return tmp_path


def test_words_come_in_their_order_with_each_meaning(folder):
    assert repr(Glossary.of(folder)) == '''\
-p      an option (2)
node    a program (10.1)
to set  to give a value, a x | y or < 3 (2)
to set  to ask for it (10.1)'''


def test_a_page_shows_code_text_and_a_link_to_the_chapter(folder):
    page = Glossary.of(folder)._repr_html_()
    assert '<table class="param-glossary">' in page
    assert '.param-glossary th, .param-glossary td { text-align: left' in page
    assert '<th scope="row"><code>-p</code></th>' in page
    assert 'a <code>x | y</code> or &lt; 3' in page
    assert '<a href="10_1_second.ipynb">10.1</a>' in page


def test_no_line_of_a_chapter_is_missed():
    chapters = list(NOTEBOOKS.glob('[0-9]*.ipynb'))
    glossary = Glossary.of(NOTEBOOKS)
    assert {entry.notebook for entry in glossary.entries} == {path.name for path in chapters}
    text = '\n'.join(path.read_text() for path in chapters)
    assert all(json.dumps(f'| {entry.word} | {entry.meaning} |', ensure_ascii=False)[1:-1] in text
               for entry in glossary.entries)
    # In each chapter at least the four that a chapter has.
    assert len(glossary.entries) >= 4 * len(chapters)
