"""Tables as HTML: their parts, and that the text in them stays text."""

from xml.etree import ElementTree

import pytest

from param_tools.markup.tables import Markup, grouped_table, table, with_code


def parsed(markup):
    return ElementTree.fromstring(markup)


def test_a_table_has_headings_rows_a_caption_and_a_class():
    found = parsed(table(('name', 'value'), [('speed', '3'), ('mode', 'fast')], css_class='ours', caption='Two'))
    assert found.get('class') == 'ours'
    assert found.findtext('caption') == 'Two'
    assert [(head.text, head.get('scope')) for head in found.findall('thead/tr/th')] == [
        ('name', 'col'), ('value', 'col')]
    assert [[cell.text for cell in row] for row in found.findall('tbody/tr')] == [['speed', '3'], ['mode', 'fast']]
    assert {cell.tag for cell in found.iter()} == {'table', 'caption', 'thead', 'tbody', 'tr', 'th', 'td'}


def test_a_table_with_headings_has_a_body_that_takes_rows_later():
    assert [part.tag for part in parsed(table(('name',), []))] == ['thead', 'tbody']


def test_a_group_has_one_heading_beside_all_its_rows():
    found = parsed(grouped_table(('node', 'name'), {'/a': [('speed',), ('mode',)], '/b': [('speed',)]}))
    bodies = found.findall('tbody')
    assert [[[cell.text for cell in row] for row in body] for body in bodies] == [
        [['/a', 'speed'], ['mode']], [['/b', 'speed']]]
    heads = [body.find('tr/th') for body in bodies]
    assert [(head.get('scope'), head.get('rowspan')) for head in heads] == [('rowgroup', '2'), ('rowgroup', '1')]


def test_text_stays_text_wherever_it_stands():
    plain = table(['<a>'], [['<b>', '"&']], caption='<c>', row_headers=True)
    grouped = grouped_table(['<a>'], {'<b>': [['<c>']]})
    assert [each.text for each in parsed(plain).iter() if each.text] == ['<c>', '<a>', '<b>', '"&']
    assert [each.text for each in parsed(grouped).iter() if each.text] == ['<a>', '<b>', '<c>']


def test_markup_goes_in_as_it_is():
    found = parsed(table(['a'], [[Markup('<pre>x</pre>'), with_code('see `<x>` & go')]]))
    assert found.findtext('tbody/tr/td/pre') == 'x'
    assert found.findtext('tbody/tr/td/code') == '<x>'
    assert ''.join(found.findall('tbody/tr/td')[1].itertext()) == 'see <x> & go'


@pytest.mark.parametrize(('text', 'shown'), [
    ('see `a * b * c` & go', 'see <code>a * b * c</code> &amp; go'),
    ('it says *Must be positive.* twice', 'it says <em>Must be positive.</em> twice'),
    ('in `*` and *bold*, `*`', 'in <code>*</code> and <em>bold</em>, <code>*</code>'),
    *[(each, each) for each in ('2*x*3', '/*/a and /*', 'f(*args, **more)', '*.yaml and *.txt')],
])
def test_code_and_words_that_stand_out(text, shown):
    assert with_code(text) == shown
