"""The HTML lessons without a browser: chapters are run and compared, and answers are recorded, not worked out."""

import html
import json
import re

import nbformat
import pytest
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook, new_output
from rcl_interfaces.msg import IntegerRange, ParameterDescriptor, SetParametersResult
from rclpy.node import Node

from param_tools.descriptor import Range
from param_tools.panel.editors import Scale
from param_tutorial import ParameterPanel
from param_tutorial.exercises import RECALLS, predicting
from param_tutorial.notebook.glossary import Glossary, GlossaryEntry
from param_tutorial.site.pages import chapter, drawing, front_page, links, terms, writing
from param_tutorial.site.recording import recorder, run
from param_tutorial.site.recording.questions import set_to, stops
from tests.support.paths import NOTEBOOKS


def write(path, *cells):
    """Write a notebook that has been run: pairs of source and what it printed."""
    code = [new_code_cell(source, execution_count=number, outputs=[new_output('stream', name='stdout', text=printed)]
                          if printed else []) for number, (source, printed) in enumerate(cells, 1)]
    nbformat.write(new_notebook(cells=[new_markdown_cell('# 1 · A chapter'), *code]), path)
    return path


@pytest.mark.slow
@pytest.mark.thorough
def test_a_chapter_that_does_what_is_stored(tmp_path):
    path = write(tmp_path / '1_a.ipynb', ('print(1)', '1\n'), ('# NBVAL_IGNORE_OUTPUT\nprint(id(print))', '2\n'))
    assert list(run.cells_with_widgets(run.read_notebook(path))) == []
    assert run.record_chapter(path) == {}


@pytest.mark.slow
@pytest.mark.thorough
def test_a_chapter_whose_output_is_not_the_stored_one(tmp_path):
    path = write(tmp_path / '1_a.ipynb', ('x = 1', ''), ('print(x)\nprint(2)', '7\n2\n'))
    with pytest.raises(run.ChapterError) as error:
        run.record_chapter(path)
    assert str(error.value).splitlines()[0] == (
        '1_a.ipynb, cell 3 (print(x)): its output differs from the stored one.')
    assert '    -7\n    +1\n     2' in str(error.value)


@pytest.mark.slow
@pytest.mark.thorough
def test_a_chapter_that_fails(tmp_path):
    path = write(tmp_path / '1_a.ipynb', ('1 / 0', ''))
    with pytest.raises(run.ChapterError, match=r'1_a\.ipynb, cell 2 \(1 / 0\): it raises ZeroDivisionError: division'):
        run.record_chapter(path)


@pytest.mark.slow
@pytest.mark.thorough
def test_a_chapter_that_does_not_end(tmp_path, monkeypatch):
    monkeypatch.setattr(run, '_CELL_TIMEOUT_SEC', 1)
    path = write(tmp_path / '1_a.ipynb', ('while True: pass', ''))
    with pytest.raises(run.ChapterError, match=r'cell 2 \(while True: pass\): it is still running after 1 s'):
        run.record_chapter(path)


@pytest.mark.slow
@pytest.mark.thorough
def test_a_chapter_that_was_not_run(tmp_path):
    path = write(tmp_path / '1_a.ipynb', ('x = 1', ''))
    notebook = nbformat.read(path, as_version=4)
    notebook.cells[1].execution_count = None
    nbformat.write(notebook, path)
    with pytest.raises(run.ChapterError, match=r'1_a\.ipynb, cell 2 \(x = 1\): it was saved without being run'):
        run.record_chapter(path)


def test_a_chapter_that_cannot_be_read(tmp_path):
    (tmp_path / '1_a.ipynb').write_text('{')
    with pytest.raises(run.ChapterError, match=r'1_a\.ipynb: it cannot be read: '):
        run.read_notebook(tmp_path / '1_a.ipynb')


def test_what_a_chapter_speaks_of():
    notebook = new_notebook(cells=[new_code_cell("panel['speed'].value = -7\nx = [1, 2.5]\ny = 'Rex'"),
                                   new_code_cell('%magic no python 12'), new_markdown_cell('99'),
                                   new_code_cell("from x import exercises\n\nexercises.predict('6.1-1')")])
    found = run.literals_of(notebook)
    assert -7 in found and [1, 2.5] in found and 'Rex' in found
    assert 12 not in found and 99 not in found and '6.1-1' not in found


# -- recording ----------------------------------------------------------------------------------------------


class Fan(Node):
    """A node with a range, a rule for two parameters, a parameter that is trimmed, and a log."""

    def __init__(self):
        super().__init__('fan')
        self.declare_parameter('least', 2, ParameterDescriptor(
            integer_range=[IntegerRange(from_value=0, to_value=10, step=1)]))
        self.declare_parameter('most', 8)
        self.declare_parameter('label', 'fan')
        self.declare_parameter('serial', 7, ParameterDescriptor(read_only=True))
        self.add_on_set_parameters_callback(self.judge)
        self.add_post_set_parameters_callback(self.tell)

    def judge(self, parameters):
        new = {each.name: each.value for each in parameters}
        least, most = (new.get(name, self.get_parameter(name).value) for name in ('least', 'most'))
        return SetParametersResult(successful=least <= most, reason=f'{least} is above {most}')

    def tell(self, parameters):
        self.get_logger().info(f'{parameters[0].name} has changed')


# Of a page with no words and no other view.
NO_PAGE = {'literals': [], 'source': '', 'views': [], 'albums': []}


def rows_of(recording):
    return {row['name']: row for row in recording['rows']}


@pytest.fixture
def recorded(ros):
    node = ros.add(Fan)
    panel = ParameterPanel(node)
    recording = recorder.record(panel.model_id, {**NO_PAGE, 'literals': ['a word of the lesson', 12345]})
    yield node, recording
    panel.close()


@pytest.mark.slow
@pytest.mark.thorough
def test_answers_are_the_nodes_and_the_node_is_as_before(recorded):
    node, recording = recorded
    least, most, label = (rows_of(recording)[name]['answers'] for name in ('least', 'most', 'label'))
    assert least['5'] == {'value': '5', 'log': ['[INFO] [fan]: least has changed']}
    assert least['9'] == {'reason': '9 is above 8', 'log': []}
    assert least['11']['reason'].startswith('Parameter least out of range')
    assert least['fast']['reason'] == "'fast' cannot be read: least takes an integer, e.g. 42"
    assert most['12345']['value'] == '12345'
    assert label['a word of the lesson']['value'] == 'a word of the lesson'
    assert 'answers' not in rows_of(recording)['serial']
    assert [node.get_parameter(name).value for name in ('least', 'most', 'label')] == [2, 8, 'fan']
    assert 'incomplete' not in recording


@pytest.mark.slow
@pytest.mark.thorough
def test_who_depends_on_whom_is_found_out_and_recorded(recorded):
    _, recording = recorded
    rows = rows_of(recording)
    assert {name: row.get('depends') for name, row in rows.items() if row.get('depends')} == {
        'least': ['most'], 'most': ['least']}
    contexts = rows['most']['contexts']
    assert {f'least={number}' for number in (0, 5, 10)} <= contexts.keys()
    for state, answers in contexts.items():
        assert ('reason' in answers['8']) == (int(state.removeprefix('least=')) > 8)
    # 10 is rejected while ``most`` is 8: the node came there by way of another ``most``.
    assert 'reason' in rows['least']['answers']['10'] and contexts['least=10']['20']['value'] == '20'


class OneWay(Node):
    """Accepts a change and does not revert it."""

    def __init__(self):
        super().__init__('one_way')
        self.declare_parameter('count', 0)
        self.add_on_set_parameters_callback(
            lambda parameters: SetParametersResult(
                successful=parameters[0].value >= self.get_parameter('count').value, reason='never back'))


def test_a_node_that_takes_nothing_back_is_not_asked_further(ros):
    panel = ParameterPanel(ros.add(OneWay))
    recording = recorder.record(panel.model_id, NO_PAGE)
    panel.close()
    assert recording['incomplete'] is True
    assert 'did not take one value back' in drawing.Drawer('page').draw(recording)


@pytest.mark.slow
@pytest.mark.thorough
def test_a_panel_whose_node_is_not_there(ros):
    panel = ParameterPanel('/nobody')
    recording = recorder.record(panel.model_id, NO_PAGE)
    panel.close()
    assert recording['rows'] == [] and 'nobody' in recording['status']
    assert 'could not be asked' in drawing.Drawer('page').draw(recording)


@pytest.mark.parametrize('scale, value, own, at_most, expected', [
    (Scale(Range(0, 10, 1)), 3, [], 11, list(range(11))),
    (Scale(Range(0, 10, 1)), 3, [9], 6, [0, 2, 3, 4, 5, 6, 8, 9, 10]),
    (Scale(Range(1, 9, 4)), 5, [2], 50, [1, 5, 9]),
    (Scale(Range(0, 300, 1)), 100, [77, 400], 11, [0, 50, 77, 100, 150, 200, 250, 300]),
    (Scale(Range(0.01, 2.0, 0.0)), 0.5, [], 5, [0.01, 0.5, 1.0, 1.5, 2.0]),
    # A gain: small values are what one tries.
    (Scale(Range(0.0, 5.0, 0.0)), 0.0, [0.1], 8, [0.0, 0.1, 0.3, 0.5, 1.0, 2.0, 3.0, 5.0]),
])
def test_stops_of_a_slider_are_round_numbers_the_ends_and_what_the_lesson_sets(scale, value, own, at_most, expected):
    assert stops(scale, value, own, at_most) == expected


@pytest.mark.parametrize('source', [
    "panel['gains.wheel.p'].value = 0.4", 'tune(p=0.4)', "{f'{group}.p': 0.4}", "set_parameter('gains.wheel.p', 0.4)",
    '%ros2 param set /wheel gains.wheel.p 0.4', "ros_args=['-p', 'gains.wheel.p:=0.4']"])
def test_what_a_lesson_sets_a_parameter_to(source):
    assert set_to('gains.wheel.p', source + '\nother.up = 7; stop(7); p7 = 3') == [0.4]


# -- pages --------------------------------------------------------------------------------------------------


def test_what_a_node_says_is_text_and_not_markup():
    row = {'name': '<b>', 'text': '"<script>', 'message': '<i>', 'locked': False, 'quiet': False, 'editor': 'text',
           'row': {'name': '<b>', 'editor': 'text', 'kind': 'string', 'facts': [], 'choices': []},
           'answers': {'x': {'reason': '</script><i>'}}}
    recording = {'kind': 'panel', 'node': '/<n>', 'status': '', 'in_order': False, 'rows': [row]}
    drawn = drawing.Drawer('page').draw(recording)
    assert '<b>' not in drawn.replace('<b>Rejected:</b>', '') and '<i>' not in drawn and '/<n>' not in drawn
    assert drawn.count('<script') == drawn.count('</script>') == 1


FACTS = {'Python': '3.12.1', 'rclpy': '7.1.6', 'date': '2026-01-02', 'commit': 'abc1234', 'changed': ''}


def linked(folder, text, pages, **options):
    """Return what Sphinx reads of a chapter with a text; there are other notebooks beside it."""
    (folder / 'solutions').mkdir()
    for name in ('2_b', '9_z', 'solutions/3_c'):
        (folder / f'{name}.ipynb').touch()
    path = folder / '3_c.ipynb'
    nbformat.write(new_notebook(cells=[new_markdown_cell(f'# 3 · C\n{text}')]), path)
    return chapter.chapter_source(path, {}, pages, **options).cells


LINKS = '[b](2_b.ipynb#Top) [z](9_z.ipynb) [s](solutions/3_c.ipynb) [w](https://example.org/x.md)'


def test_links_of_a_chapter(tmp_path):
    text = linked(tmp_path, LINKS, {'2_b', '3_c'})[0].source
    assert '[b](2_b.ipynb#Top) z <a href="notebooks/solutions/3_c.ipynb" download>s</a> [w](https:' in text


def test_links_of_a_chapter_alone(tmp_path):
    cells = linked(tmp_path, LINKS, {'3_c'}, alone=FACTS)
    assert 'b z s [w](https:' in cells[0].source
    assert 'as of 2026-01-02 (abc1234). It ran on Python 3.12.1' in cells[1].outputs[0].data['text/html']


def test_links_of_a_chapter_alone_lead_to_the_site_if_one_knows_where_that_is(tmp_path):
    text = linked(tmp_path, LINKS, {'3_c'}, alone=FACTS, address='https://x.org/')[0].source
    assert ('[b](https://x.org/2_b.html#Top) [z](https://x.org/9_z.html) '
            '<a href="https://x.org/notebooks/solutions/3_c.ipynb" download>s</a> [w]') in text


def test_a_link_to_a_notebook_that_is_not_there_stops_the_build(tmp_path):
    with pytest.raises(writing.BuildError, match=r'^3_c\.ipynb links to 4_d\.ipynb, which is not there\.$'):
        linked(tmp_path, '[d](4_d.ipynb)', {'3_c', '4_d'})


@pytest.mark.parametrize('path', sorted(NOTEBOOKS.glob('[0-9]*.ipynb')), ids=lambda path: path.stem)
def test_what_a_check_says_to_look_at_is_a_link(path):
    notebook = run.read_notebook(path)
    shown = links.Links(path, notebook, {path.stem})
    outputs = [shown.in_output(output.data['text/html']) for cell in notebook.cells if cell.id.startswith('check-')
               for output in cell.outputs]
    named = [each for output in outputs for each in re.findall('<dt>look at</dt><dd>(.*?)</dd>', output)]
    assert named and [each for each in named if not re.fullmatch('<a href="#[^"]+">“.*”</a>', each)] == []
    assert shown.in_check('to compare: solutions/x.ipynb') == 'to compare: solutions/x.ipynb'
    assert shown.in_check(f'to compare: solutions/{path.name}') == (
        f'to compare: <a href="notebooks/solutions/{path.name}" download>solutions/{path.name}</a>')


def test_the_first_page_lists_the_chapters_that_there_are_and_says_what_ran(tmp_path):
    index = tmp_path / 'index.md'
    for name in ('1_a', '2_b', '3_c'):
        (tmp_path / f'{name}.ipynb').touch()
    index.write_text('| 1 | [One](1_a.ipynb) | Why? | 20 |\n| 2 | [Two](2_b.ipynb) | How? | 30 |\n'
                     '| 3 | [Three](3_c.ipynb) | When? | 30 + 25 |\n')
    text = front_page.front_page_source(index, {tmp_path / '1_a.ipynb': {}, tmp_path / '3_c.ipynb': {}}, FACTS)
    assert 'href="1_a.html"' in text and 'Why?' in text and 'Two' not in text
    assert '20 minutes' in text and 'href="3_c.html"' in text and '30 + 25 minutes' in text
    assert re.search(r'2026-01-02 \(`abc1234`\), on Python 3\.12\.1\s+with rclpy 7\.1\.6', text)
    assert 'Drive' not in text


def test_the_first_page_has_the_groups_and_the_ways_of_the_notebooks_start_page(tmp_path):
    recordings = {path: {} for path in sorted(NOTEBOOKS.glob('[0-9]*.ipynb'))}
    text = front_page.front_page_source(NOTEBOOKS / 'index.md', recordings, FACTS)
    original = (NOTEBOOKS / 'index.md').read_text()
    groups = re.findall('^### .*$', original, re.MULTILINE)
    assert len(groups) > 3 and [each for each in groups if f'\n{each}\n' not in text] == []
    assert all(f'href="{path.stem}.html"' in text for path in recordings)
    assert text.count('Afterwards you can ') == len(recordings)
    for who in ('a student', 'a teacher', 'an engineer'):
        assert f'**{who}**' in text
    assert 'its exercises check themselves in JupyterLab' in text
    assert '.ipynb' not in text.partition('## The lessons')[2]


@pytest.mark.slow
@pytest.mark.parametrize('number', RECALLS)
def test_the_verdict_on_a_recall_links_to_the_section_that_answers_it(number):
    notebooks = {path.stem: run.read_notebook(path) for path in sorted(NOTEBOOKS.glob('[0-9]*.ipynb'))}
    path = next(NOTEBOOKS.glob('01_*.ipynb'))
    shown = links.Links(path, notebooks[path.stem], set(notebooks))
    recall = RECALLS[number]
    for choice in recall.choices:
        said = shown.in_verdict(predicting.verdict(recall, choice.text))
        (page, place), = re.findall(r'<a href="(\w+)\.html#([^"]+)">“', said)
        there = links.Links(NOTEBOOKS / f'{page}.ipynb', notebooks[page], set())
        assert html.unescape(place) in there.anchors
        assert chapter.title(NOTEBOOKS / f'{page}.ipynb').startswith(f'{recall.chapter} · ')
    nowhere = links.Links(path, notebooks[path.stem], {path.stem}, is_alone=True)
    assert '<a ' not in nowhere.in_verdict('You learned it in chapter 3, “Declare”.')
    assert shown.in_verdict('You learned it in chapter 99, “Declare”.') == 'You learned it in chapter 99, “Declare”.'


def test_a_page_explains_words_as_its_chapter_uses_them_and_no_everyday_ones():
    glossary = Glossary(GlossaryEntry(*each, 'x.ipynb') for each in (
        ('snapshot', 'an early one', '2'), ('snapshot', 'its own', '10.2'), ('snapshot', 'a </script> later', '10.5'),
        ('to declare', 'to create', '3'), ('`await`', 'wait', '5.3'), ('left', 'not changed', '1')))

    def told(chapter):
        script = terms.terms_script(glossary, chapter)
        assert script.count('</script>') == 1
        known = json.loads(re.sub('<[^>]+>$|^<[^>]+>', '', script))
        return {each['word']: (each['code'], each['meaning']) for each in known}

    assert told('10.2')['snapshot'] == (False, '<b>snapshot</b> · its own (chapter 10.2)')
    assert told('9.1')['snapshot'][1].endswith('an early one (chapter 2)')
    assert 'later (chapter 10.5)' in told('11')['snapshot'][1]
    assert told('1').keys() == {'snapshot', 'declare', 'await'}
    assert told('1')['await'] == (True, '<b><code>await</code></b> · wait (chapter 5.3)')
    assert terms.terms_script(Glossary([]), '1') == ''
