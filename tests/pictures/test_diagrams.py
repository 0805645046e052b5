"""The pictures of a running system: their words, that they are well-formed, and that what is named stays text."""

from xml.etree import ElementTree

import pytest

from param_tutorial.pictures.diagrams import NodeGraph, Step, Timeline

STEPS = [Step('asked', 'set speed to 2', '1', comes_from='you'), Step('on-set', 'judge sees 2, accepts', '1'),
         Step('stored', 'the value is written', '2'), Step('answer', 'successful', '2', goes_to='you')]


def drawn(picture):
    return ElementTree.fromstring(picture._repr_html_())


def texts(picture):
    return [text.text for text in drawn(picture).iter('text')]


def test_a_timeline_tells_in_words_what_it_draws():
    timeline = Timeline('/robot', 'speed', STEPS)
    assert timeline.text == (
        'speed of /robot, step by step. 1, asked: set speed to 2; stored is 1. 2, on-set: judge sees 2, accepts; '
        'stored is 1. 3, stored: the value is written; stored is 2. 4, answer: successful; stored is 2')
    assert drawn(timeline).get('aria-label') == timeline.text
    assert repr(timeline).splitlines() == [
        '/robot: speed                    stored',
        '  asked   set speed to 2         1',
        '  on-set  judge sees 2, accepts  1',
        '  stored  the value is written   2',
        '  answer  successful             2']


def test_a_timeline_marks_the_one_moment_of_the_change_without_colour():
    fills = [circle.get('fill') for circle in drawn(Timeline('/robot', 'speed', STEPS)).iter('circle')]
    assert len(set(fills)) == 2
    assert fills.count(fills[2]) == 1


def test_messages_have_arrows_in_their_direction():
    lines = [(float(line.get('x1')), float(line.get('x2'))) for line in drawn(Timeline('/r', 's', STEPS)).iter('line')]
    asked, answered = lines[1:]
    assert asked[0] < asked[1] and answered[0] > answered[1]


def test_a_long_step_is_wrapped_and_a_long_value_is_cut():
    timeline = Timeline('/robot', 'speed', [Step('answer', 'rejected: ' + 'because ' * 20, "'" + 'x' * 60 + "'")])
    shown = texts(timeline)
    assert ' '.join(shown).count('because') == 20
    assert max(map(len, shown)) <= 60
    assert 'x' * 60 in timeline.text


def test_a_timeline_of_nothing_is_rejected():
    with pytest.raises(ValueError, match='one step'):
        Timeline('/robot', 'speed', [])


GRAPH = NodeGraph(serves=['/b', '/a'], asks=[('/b', '/a'), ('me', '/a'), ('me', '/gone')], tells=['/a', '/b'],
                  listens=['/b'])


def test_a_graph_tells_in_words_what_it_draws():
    assert repr(GRAPH).splitlines() == [
        'offer parameter services: /a, /b', '/b asks: /a', 'me asks: /a, /gone', 'asked for, and not there: /gone',
        'publish on /parameter_events: /a, /b', 'listen to /parameter_events: /b']
    assert drawn(GRAPH).get('aria-label') == '. '.join(repr(GRAPH).splitlines())
    boxes = [text for text in texts(GRAPH) if text.startswith('/') or text == 'me']
    assert sorted(boxes) == ['/a', '/b', '/b', '/b', '/gone', '/parameter_events', 'me']


def test_each_relation_has_its_arrow():
    # Three questions, two publishers, one listener.
    assert len(list(drawn(GRAPH).iter('polygon'))) == 6


def test_what_is_not_there_is_dashed():
    assert sum('stroke-dasharray' in box.attrib for box in drawn(GRAPH).iter('rect')) == 1


def test_the_order_of_what_is_given_does_not_matter():
    other = NodeGraph(serves=['/a', '/b', '/a'], asks=[('me', '/gone'), ('me', '/a'), ('/b', '/a')],
                      tells=['/b', '/a', '/a'], listens=['/b'])
    assert other._repr_html_() == GRAPH._repr_html_()


def test_an_empty_graph_is_drawn_too():
    empty = NodeGraph(serves=[], asks=[], tells=[], listens=[])
    assert '/parameter_events' in texts(empty)
    assert 'nobody' in repr(empty)


@pytest.mark.parametrize('picture', [
    Timeline('<b>', 'a & "b"', [Step('<i>', '</svg>', '<', comes_from='&')]),
    NodeGraph(serves=['/<b>'], asks=[('"', '/<b>')], tells=['/<b>'], listens=['&'])], ids=['timeline', 'graph'])
def test_names_are_text(picture):
    assert {'<b>', '</svg>', '"', '/<b>', '&'} & set(texts(picture))
