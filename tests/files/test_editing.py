"""Editing a file by its places: the value changes, and not one character beside it."""

import difflib
import re

import hypothesis.strategies as st
import pytest
from hypothesis import example, given, settings
from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node

from param_tools import values
from param_tools.errors import ParameterFileError
from param_tools.files.editing import edit, update_file
from param_tools.files.parameter_files import read_all, why_not_expressible
from param_tutorial import ParameterClient
from tests.files.test_checking import FILES
from tests.files.test_parameter_files import DOCUMENTS, NAMES, same, we_read
from tests.support.strategies import VALUES


def changed_lines(before, after):
    return [line for line in difflib.ndiff(before.splitlines(), after.splitlines()) if line[0] in '-+']


@pytest.mark.parametrize(('name', 'node', 'new', 'lines'), [
    ('lift.yaml', '/hall_3/lift', {'steps': 50}, ['-     steps: 40', '+     steps: 50']),
    ('lift.yaml', '/hall_3/lift', {'password': 'yes'}, ["-     password: 'no'", "+     password: 'yes'"]),
    ('lift.yaml', '/hall_3/lift', {'unit': 'mm'}, ['-     unit: "m"', '+     unit: "mm"']),
    ('lift.yaml', '/hall_3/lift', {'name': 'no'}, ['-     name: lift', "+     name: 'no'"]),
    ('lift.yaml', '/hall_3/lift', {'tool.length': 1.5}, [
        '-     tool: {kind: fork, length: 1.2}', '+     tool: {kind: fork, length: 1.5}']),
    ('lift.yaml', '/hall_3/lift', {'gains': [1.0, 2.5, 3.0]}, [
        '-     gains: [1.0, 0.5]', '+     gains: [1.0, 2.5, 3.0]']),
    ('lift.yaml', '/hall_3/lift', {'gains': [2.0]}, ['-     gains: [1.0, 0.5]', '+     gains: [2.0]']),
    ('lift.yaml', '/hall_3/lift', {'gains': 2}, ['-     gains: [1.0, 0.5]', '+     gains: 2']),
    ('lift.yaml', '/hall_3/lift', {'new': True}, ['+     new: true']),
    ('lift.yaml', '/hall_3/lift', {'tool.kind': 'fork'}, []),
    ('controllers.yaml', '/arm_controller', {'state_publish_rate': 60.0}, [
        '-     state_publish_rate: 50.0 # Defaults to 50', '+     state_publish_rate: 60.0 # Defaults to 50']),
    ('controllers.yaml', '/arm_controller', {'joints': ['shoulder', 'wrist', 'hand']}, [
        '-       - elbow', '+       - wrist', '+       - hand']),
    ('controllers.yaml', '/arm_controller', {'joints': ['elbow']}, ['-       - shoulder']),
    ('controllers.yaml', '/any/controller_manager', {'update_rate': 200}, [
        '-     update_rate: 100  # Hz', '+     update_rate: 200  # Hz']),
    ('navigation.yaml', '/navigator', {'plugin_lib_names': ['a', 'b', 'c', 'd']}, [
        '-     - compute_path_action', '-     - follow_path_action', '+     - a', '+     - b', '-     - wait_action',
        '+     - c', '+     - d']),
    ('navigation.yaml', '/local_costmap/local_costmap', {'obstacles.scan.max_range': 4.0}, [
        '-           max_range: 3.0', '+           max_range: 4.0']),
    ('navigation.yaml', '/elsewhere', {'use_sim_time': False}, [
        '-     use_sim_time: True', '+     use_sim_time: false']),
    ('controllers.yaml', '/elsewhere', {'a': 1}, ['+ /elsewhere:', '+   ros__parameters:', '+     a: 1']),
])
def test_only_the_value_changes(write, name, node, new, lines):
    text = (FILES / name).read_text()
    path = write(text, name)
    before = read_all(path, [node])
    assert update_file(path, node, new) == (list(new) if lines else [])
    assert sorted(changed_lines(text, path.read_text())) == sorted(lines)
    after = read_all(path, [node])
    assert same(after[node], {**before.get(node, {}), **new})
    if '/**' not in text or node != '/elsewhere':
        assert {other: each for other, each in after.items() if other != node} == {
            other: each for other, each in before.items() if other != node}


@pytest.mark.slow
@settings(max_examples=300)
@given(DOCUMENTS, st.dictionaries(NAMES, VALUES, min_size=1, max_size=3))
@example('/lab/reader: {ros__parameters: {a: 1}}\n', {'b.c': 'x'})
@example('/lab/reader:\r\n  ros__parameters:\r\n    a: |\r\n      x\r\n    b: 2\r\n', {'a': 'z', 'c': [1, 2]})
@example('\ufeff/lab/reader:\n  ros__parameters:\n    a: "ä\U0001f600"  # ö\n', {'a': 'x'})
def test_a_node_gets_what_was_asked_for_and_all_else_or_nothing_happens(text, new):
    before = we_read(text)
    try:
        after, changed = edit(text, '/lab/reader', new)
    except ParameterFileError:
        return
    if changed and before is not None:
        assert same(we_read(after), {**before, **new})
    assert set(changed) <= set(new)
    assert all(why_not_expressible(name, value) is None for name, value in new.items())


@pytest.mark.parametrize('value', [False, 'x', ['a']])
def test_an_array_in_the_column_of_its_name_can_become_any_value(value):
    text = (FILES / 'navigation.yaml').read_text()
    assert 'plugin_lib_names:\n    - ' in text
    edited, _ = edit(text, '/navigator', {'plugin_lib_names': value})
    assert same(we_read(edited, '/navigator'), {**we_read(text, '/navigator'), 'plugin_lib_names': value})


@pytest.mark.slow
@given(st.sampled_from(['navigation.yaml', 'controllers.yaml', 'lift.yaml']), st.data())
def test_any_value_of_a_file_by_hand_can_be_changed(name, data):
    text = (FILES / name).read_text()
    node, held = data.draw(st.sampled_from(sorted(read_all(FILES / name).items(), key=str)))
    parameter = data.draw(st.sampled_from(sorted(held)))
    value = data.draw(VALUES.filter(lambda value: why_not_expressible('x', value) is None))
    edited, _ = edit(text, node, {parameter: value})
    if not isinstance(held[parameter], list) and not isinstance(value, list):
        assert len(changed_lines(text, edited)) <= 2


@pytest.mark.parametrize(('text', 'new', 'complaint'), [
    ('/n:\n  a: 1\n', {'a': 1}, 'line 2: there is a value before'),
    ('/n: {ros__parameters: {a: 1}}', {'a': []}, 'a of /n: an empty array in a parameter file has no type'),
    ('/n: {ros__parameters: {a: 1}}', {'a': [b'x']}, 'byte arrays'),
    ('/n: {ros__parameters: {a: 1, a: x}}', {'a': 'y'}, 'change it by hand'),
])
def test_what_cannot_be_done_leaves_the_file(write, text, new, complaint):
    path = write(text)
    with pytest.raises(ParameterFileError, match=r'robot\.yaml') as rejection:
        update_file(path, '/n', new)
    assert complaint in str(rejection.value)
    assert path.read_text() == text


def test_what_is_no_text_is_left(write, tmp_path):
    path = write(b'\xff\xfe')
    with pytest.raises(ParameterFileError, match='is not UTF-8'):
        update_file(path, '/n', {'a': 1})
    with pytest.raises(ParameterFileError, match='cannot read'):
        update_file(tmp_path / 'nowhere.yaml', '/n', {'a': 1})


class Locked(Node):
    """Has a read-only parameter."""

    def __init__(self):
        super().__init__('locked')
        self.declare_parameter('serial', 'A', ParameterDescriptor(read_only=True))
        self.declare_parameter('speed', 1)


def test_a_node_writes_its_values_into_a_file_of_a_person(ros, write):
    client = ParameterClient(ros.add(Locked))
    path = write('# mine\n/**:\n  ros__parameters:\n    speed: 5   # fast\n')
    assert client.update_file(path) == ['speed']
    assert path.read_text() == '# mine\n/**:\n  ros__parameters:\n    speed: 1   # fast\n'
    assert client.update_file(path, ['serial']) == ['serial']
    assert values.same(read_all(path, ['/locked'])['/locked'], {'speed': 1, 'serial': 'A'})


@pytest.mark.parametrize('skip', [True, False])
def test_read_only_values_are_loaded_and_dumped_as_the_user_chooses(ros, write, skip):
    client = ParameterClient(ros.add(Locked))
    path = write('/locked:\n  ros__parameters:\n    serial: B\n    speed: 2\n')
    kinds = {each.name: each.kind for each in client.load(path, skip_read_only=skip)}
    assert kinds == ({'speed': 'accepted'} if skip else {'serial': 'read only', 'speed': 'accepted'})
    assert client.get_parameter('speed') == 2
    dump = client.dump(skip_read_only=skip)
    assert ('serial' in dump.left_out) is skip
    assert ('# left out: "serial": it is read-only' in dump.text) is skip


# What stands below the header of /n, what is changed, and what stands there then.
COMMENTED = [
    # texts in blocks
    ('a: | # why\n  x\nb: 1\n', {'a': 'w'}, 'a: w # why\nb: 1\n'),
    ('a: >- # why\n  x\n  y\n\nb: 1\n', {'a': 2}, 'a: 2 # why\nb: 1\n'),
    ('a: |2+   # why # not\n    x\nb: 1\n', {'a': 'w'}, 'a: w # why # not\nb: 1\n'),
    ('a: !!str | # why\n  x\nb: 1\n', {'a': 'y\nz'}, 'a: "y\\nz" # why\nb: 1\n'),
    ("a: '| # no'\n", {'a': 'y'}, "a: 'y'\n"),
    ('a:\n  - | # why\n    x\n  - z # end\n', {'a': ['w', 'z']}, 'a:\n  - w # why\n  - z # end\n'),
    # lists in brackets that get shorter, longer, or become something else
    ('a: [1, # dim\n    2] # bright\n', {'a': [1]}, 'a: [1 # dim\n    ] # bright\n'),
    ('a: [1, 2, # two\n    3, 4,\n    5, # five\n   ]\n', {'a': [1]}, 'a: [1  # two\n    , # five\n   ]\n'),
    ('a: [1, # one\n    2, # two\n    3 # three\n   ]\n', {'a': [1]}, 'a: [1 # one\n     # two\n     # three\n   ]\n'),
    ('a: [1, 2, 3] # all\n', {'a': [1]}, 'a: [1] # all\n'),
    ('a: [1, # dim\n    2] # bright\n', {'a': [1, 2, 3]}, 'a: [1, # dim\n    2, 3] # bright\n'),
    ('a: [1, # dim\n    2, # bright\n   ]\n', {'a': [1, 2, 3]}, 'a: [1, # dim\n    2, # bright\n    3\n   ]\n'),
    ('a: [1, # dim\n    2] # bright\n', {'a': 7}, 'a: 7 # dim # bright\n'),
    # lists in lines
    ('a:\n  - 1 # one\n  # between\n  - 2 # two\n  - 3 # three\nb: 1\n', {'a': [1]},
     'a:\n  - 1 # one\n  # between\n  # two\n  # three\nb: 1\n'),
    ('a:\n- 1\n- 2 # two\nb: 1\n', {'a': [4]}, 'a:\n- 4\n# two\nb: 1\n'),
    ('a:\n  - 1 # one\n  - 2\nb: 1\n', {'a': 'x'}, 'a:\n  x # one\nb: 1\n'),
    # parameters that are added where the first one is nested
    ('topics:\n  stick: {timeout: 0.5} # s\nperiod: 3.0\n', {'verbose': True},
     'topics:\n  stick: {timeout: 0.5} # s\nperiod: 3.0\nverbose: true\n'),
    ('topics:\n  stick:\n    timeout: 0.5 # s\n', {'topics.stick.name': 'x', 'b': 1},
     'topics:\n  stick:\n    timeout: 0.5 # s\ntopics.stick.name: x\nb: 1\n'),
    ('a: # list\n  - b: [1]\n', {'c': 1}, 'a: # list\n  - b: [1]\nc: 1\n'),
]


@pytest.mark.parametrize('ends', ['\n', '\r\n'], ids=['LF', 'CRLF'])
@pytest.mark.parametrize(('lines', 'new', 'edited'), COMMENTED, ids=[each[0].strip() for each in COMMENTED])
def test_every_comment_stays_where_it_belongs(lines, new, edited, ends):
    def block(text):
        indented = ''.join(f'    {line}\n' for line in text.splitlines())
        return f'/n:\n  ros__parameters:\n{indented}'.replace('\n', ends)
    after, _ = edit(block(lines), '/n', new)
    assert after == block(edited)


@pytest.mark.parametrize(('text', 'edited'), [
    ('/n:\n  ros__parameters: {}\n', '/n:\n  ros__parameters:\n    a: 1\n'),
    ('/n:\n  ros__parameters: { } # none\n', '/n:\n  ros__parameters: # none\n    a: 1\n'),
    ('/n: {ros__parameters: {}}\n', '/n: {ros__parameters: {a: 1}}\n'),
    ('/n: {ros__parameters: {b: {c: 1}}}\n', '/n: {ros__parameters: {a: 1, b: {c: 1}}}\n'),
    ('/n:\n  ros__parameters: {b: {c: 1}}\n', '/n:\n  ros__parameters: {a: 1, b: {c: 1}}\n'),
])
def test_a_parameter_is_added_to_a_block_in_braces(text, edited):
    assert edit(text, '/n', {'a': 1})[0] == edited


ITEMS = st.lists(st.integers(0, 9), min_size=1, max_size=4)


@pytest.mark.slow
@settings(max_examples=300)
@given(ITEMS, ITEMS, st.sampled_from(['brackets', 'lines', 'lines at the name']), st.booleans(), st.data())
def test_a_list_of_any_length_keeps_every_comment(before, after, style, is_first, data):
    comments = [f' # c{number}' * data.draw(st.booleans()) for number in range(len(before))]
    if style == 'brackets':
        rows = [f'{item}{"," * (number < len(before) - 1)}{comment}\n         '
                for number, (item, comment) in enumerate(zip(before, comments))]
        text = f'    a: [{"".join(rows)}] # end\n'
    else:
        indent = 6 if style == 'lines' else 4
        rows = [f'{" " * indent}- {item}{comment}\n' for item, comment in zip(before, comments)]
        text = f'    a: # end\n{"".join(rows)}'
    text = '/n:\n  ros__parameters:\n' + '    z: {y: 1}\n' * is_first + text + '    b: 2 # two\n'
    edited, _ = edit(text, '/n', {'a': after})
    assert we_read(edited, '/n')['a'] == after
    kept = min(len(before), len(after))
    for number, (item, comment) in enumerate(zip(after, comments)):
        assert not comment or number >= kept or re.search(rf'\b{item},?{comment}\b', edited), edited
    assert sorted(re.findall('#.*', edited)) == sorted(re.findall('#.*', text))
