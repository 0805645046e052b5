"""Editing a file by its places: the value changes, and not one character beside it."""

import difflib

import hypothesis.strategies as st
import pytest
from hypothesis import example, given
from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node

from param_tools.errors import ParameterFileError
from param_tools.files.editing import edit, update_file
from param_tools.files.parameter_files import read_all
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
    ('lift.yaml', '/hall_3/lift', {'gains': 2}, ['-     gains: [1.0, 0.5]', '+     gains: 2']),
    ('lift.yaml', '/hall_3/lift', {'tool.kind': 'fork'}, []),
    ('controllers.yaml', '/any/controller_manager', {'update_rate': 200}, [
        '-     update_rate: 100  # Hz', '+     update_rate: 200  # Hz']),
    ('navigation.yaml', '/elsewhere', {'use_sim_time': False}, [
        '-     use_sim_time: True', '+     use_sim_time: false']),
])
def test_only_the_value_changes(write, name, node, new, lines):
    text = (FILES / name).read_text()
    path = write(text, name)
    before = read_all(path, [node])
    assert update_file(path, node, new) == (list(new) if lines else [])
    assert sorted(changed_lines(text, path.read_text())) == sorted(lines)
    assert same(read_all(path, [node])[node], {**before[node], **new})


@given(DOCUMENTS, st.dictionaries(NAMES, VALUES, min_size=1, max_size=3))
@example('/lab/reader:\r\n  ros__parameters:\r\n    a: x\r\n    b: 2\r\n', {'a': 'z', 'b': [1, 2]})
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


@pytest.mark.parametrize(('text', 'new', 'complaint'), [
    ('/n:\n  a: 1\n', {'a': 1}, 'line 2: there is a value before'),
    ('/n: {ros__parameters: {a: 1}}', {'a': []}, 'a of /n: an empty array in a parameter file has no type'),
    ('/n: {ros__parameters: {a: 1}}', {'a': [b'x']}, 'byte arrays'),
    ('/n: {ros__parameters: {a: 1, a: x}}', {'a': 'y'}, 'without changing the file otherwise: change it by hand'),
    ('/n: {ros__parameters: {a: 1}}', {'b': 1}, 'it holds no b for /n: add it by hand'),
    ('/n:\n  ros__parameters:\n    a:\n      - 1\n', {'a': [2]},
     'the value of a in line 4 is one of several lines: change it by hand'),
    ('/n:\n  ros__parameters:\n    a: [1,\n        2]\n', {'a': [2]}, 'line 3 is one of several lines'),
    ('/n:\n  ros__parameters:\n    a: |\n      x\n', {'a': 'y'}, 'line 3 is one of several lines'),
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
    with pytest.raises(ParameterFileError, match='it holds no serial for /locked'):
        client.update_file(path, ['serial'])


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
