"""Parameter files against rcl's own parser: it must read whatever we write or read in the same way."""

import contextlib
import os
import re
import stat
import sys
import tempfile
from pathlib import Path

import hypothesis.strategies as st
import pytest
import yaml
from hypothesis import example, given, settings
from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node

from param_tools import values
from param_tools.errors import ParameterFileError
from param_tools.files import parsing
from param_tools.files.parameter_files import read, render
from param_tools.files.rcl_parser import first_rejection
from param_tutorial import ParameterClient
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from tests.support.strategies import TEXT, VALUES

property_test = settings(max_examples=150)


class Reader(Node):
    """Declares whatever a parameter file holds for it."""

    def __init__(self, name, namespace):
        super().__init__(name, namespace=namespace, start_parameter_services=False, enable_rosout=False,
                         automatically_declare_parameters_from_overrides=True)


@contextlib.contextmanager
def file_of(text):
    """Yield the path of a file that holds a text, for one reading."""
    with tempfile.NamedTemporaryFile('wb', suffix='.yaml') as file:
        file.write(text if isinstance(text, bytes) else text.encode())
        file.flush()
        yield file.name


def rcl_reads(ros, text, node='/lab/reader'):
    """Return the values that a real node gets from a parameter file; None if it does not start."""
    namespace, _, name = node.rpartition('/')
    with file_of(text) as path:
        try:
            reader = ros.add(Reader, name, namespace or '/', ros_args=['--params-file', path])
        # RCLInvalidROSArgsError for a file that does not parse, ValueError for a parameter without a type.
        except Exception:
            return None
    found = {name: values.normalize(parameter.value) for name, parameter in reader.get_parameters_by_prefix('').items()}
    own = {'use_sim_time': False, 'start_type_description_service': True}
    return {name: value for name, value in found.items() if name not in own or not values.same(value, own[name])}


def we_read(text, node='/lab/reader'):
    """Return what ``read`` finds in a text; None if it rejects the text."""
    with file_of(text) as path:
        try:
            return read(path, node)
        except ParameterFileError as error:
            assert path in str(error)
            return None


def same(left, right):
    return left.keys() == right.keys() and all(values.same(left[name], right[name]) for name in left)


# -- what is written comes back -----------------------------------------------------------------------------

PART = st.one_of(st.sampled_from(['a', 'b', 'true', '1', '', 'x y', '/tf', '#', '1e5', '~', 'ros__parameters']), TEXT)
NAMES = st.lists(PART, min_size=1, max_size=4).map('.'.join).filter(bool)
PARAMETERS = st.dictionaries(NAMES, VALUES, max_size=8)
TRICKY = [
    '', ' ', 'y', 'n', 'Yes', 'off', '1e5', '1.0e5', 'inf', 'Infinity', 'nan', 'NaN', '0x10', '017', '0b1', '1_000',
    '12:30', '2024-01-01', 'null', '~', '=', '<<', '- a', 'a: b', 'a #b', '@x', '`x', '!tag', '*alias', '%x', '[1]',
    '{a: b}', "it's", '"', '\\', 'two\nlines', '\n', 'tab\t', '\x07', '\x85', '\u2028', '\ufeff', 'Größe', '😀', '.5',
    '.', '-', '--', '---', '...', '? x', '|', '>', 'x' * 2000, '+1', '.inf', '0x', '1.', '-0', 'e5', 'true ']


@property_test
@given(PARAMETERS)
@example({text or 'empty': text for text in TRICKY})
@example({'texts': TRICKY})
@example({'doubles': [0.0, -0.0, 1e-7, 1e22, 1e300, float('inf'), -float('inf'), float('nan'), sys.float_info.min]})
@example({'a': 1, 'a.b': 2, 'a.b.c': 3, 'a.b.c.d': 4, 'x.a': 1, 'x.a.b': 2, 'x.y.z': 5})
@example({'.': 1, '..': 2, 'a.': 3, 'a..b': 4, '.a': 5, 'a.b': 6, 'a.b.': 7})
@example({'k' * 1100: 1, 'é' * 600: [1], 'long': list(range(1000))})
def test_what_is_written_comes_back_with_the_same_types_and_values(ros, parameters):
    dump = render('/lab/reader', parameters)
    expected = {name: value for name, value in parameters.items() if name not in dump.left_out}
    assert same(rcl_reads(ros, dump.text), expected)
    assert same(we_read(dump.text) or {}, expected)
    # Any other YAML program gets the same types, too.
    yaml.safe_load(dump.text)


@given(PARAMETERS)
def test_only_what_rcl_cannot_express_is_left_out(parameters):
    for name, reason in render('/lab/reader', parameters).left_out.items():
        value = parameters[name]
        assert reason
        assert values.type_of(value) is values.BYTE_ARRAY or any(
            isinstance(item, float) and 0 < abs(item) < sys.float_info.min
            for item in (value if isinstance(value, list) else [value]))


def test_what_cannot_be_written_is_named_with_its_reason_and_stands_in_the_text_as_a_comment(ros):
    unwritable = {'empty': [], 'bytes': [b'\x01'], 'tiny': 5e-324, 'tiny_one_of_many': [1.0, -1e-310], 'unset': None,
                  'nul': 'a\0b', 'nul\0name': 1, '': 1, 'half': '\ud800', 'new\nline': []}
    dump = render('/lab/reader', {**unwritable, 'fine': 1})
    assert dump.left_out.keys() == unwritable.keys()
    assert 'no type' in dump.left_out['empty']
    assert 'byte' in dump.left_out['bytes']
    assert '5e-324' in dump.left_out['tiny']
    assert 'no value' in dump.left_out['unset']
    assert '# left out: "empty": ' in dump.text
    assert '# left out: "new\\nline": ' in dump.text
    assert rcl_reads(ros, dump.text) == we_read(dump.text) == {'fine': 1}
    assert str(dump) == dump.text
    assert repr(dump).startswith(dump.text.rstrip('\n'))
    assert 'left out:' in repr(dump).splitlines()[-1]


# -- read agrees with rcl ------------------------------------------------------------------------------------

NUMBERS = st.from_regex(r'[+-]?(0[xX])?[0-9a-fA-F_]{0,5}(\.[0-9a-f]{0,3})?([eEpP][+-]?[0-9]{1,4})?', fullmatch=True)
# From ordinary characters only: what YAML itself makes of the others is not ours to test.
WORDS = st.text('abnyxoeinfNOYE019.+-_~:', max_size=7)
SCALARS = st.one_of(NUMBERS, WORDS, st.floats().map(repr), st.integers().map(str), st.sampled_from(TRICKY))


@property_test
@given(st.lists(SCALARS, max_size=20))
@example(['08', '0x', '-0x10', '9223372036854775807', '9223372036854775808', '-9223372036854775809', '1e400',
          '4.9e-324', '0x1p-1074', '0x1p-1075', '2.2250738585072011e-308', '0e999999999', '1e-999999999', 'nan(1)',
          '-nan', '+.INF', '-.nan', '1' * 5000])
def test_scalars_are_typed_as_rcl_types_them(ros, scalars):
    lines = []
    for number, text in enumerate(scalars):
        plain = text
        try:
            events = list(yaml.parse(f'a: {plain}\n', Loader=yaml.CSafeLoader))
            usable = len(events) == 8 and isinstance(events[4], yaml.ScalarEvent) and '\n' not in plain
        except yaml.YAMLError:
            usable = False
        if usable:
            lines.append(f'    p{number}: {plain}\n')
    text = '/**:\n  ros__parameters:\n' + ''.join(lines)
    expected, found = rcl_reads(ros, text), we_read(text)
    assert (expected is None) == (found is None)
    assert found is None or same(found, expected)


VALUE = st.sampled_from([
    '1', '1.5', 'x', 'true', "''", '"y"', '[]', '[1, 2]', '[a, b]', '[1, x]', '[1.0, 2]', '{}', '[[1]]', '[[1], [2]]',
    '[1, [2], 3]', '[{a: 1}]', '~', '', '!!str 5', '!!float 5', '!x 5', '.inf', '1e400', '*x', '&x 3', '"a\\0b"', '-5',
    'é', 'a: b', '[', '{a: 1, b: {c: 2}}', '? x'])
KEY = st.sampled_from(['a', 'b', 'c.d', 'a.b', 'x.y.z', '"k l"', '1', 'ros__parameters', 'a', '"a\\0b"', '""'])
MAPS = st.recursive(VALUE, lambda inner: st.lists(st.tuples(KEY, inner), max_size=4).map(
    lambda items: '{' + ', '.join(f'{key}: {value}' for key, value in items) + '}'), max_leaves=6)
BLOCK = st.one_of(st.builds('{{ros__parameters: {}}}'.format, MAPS), MAPS)
NODE = st.sampled_from([
    '/lab/reader', 'lab/reader', '/lab', 'reader', '/**', '**', '/*', '/*/reader', '/lab/*', '/**/reader', '/*/*',
    '/lab/**', '/reader', '/**/**', '/lab/reader/', '//reader', '/a b', '/1', '/n*', '""'])
DOCUMENTS = st.lists(st.tuples(NODE, BLOCK), max_size=3).map(
    lambda items: ''.join(f'{node}: {block}\n' for node, block in items))


@settings(max_examples=200)
@given(DOCUMENTS)
@example('/**: {ros__parameters: {a: 1}}\n/lab/reader: {ros__parameters: {a: 2}}\n/**: {ros__parameters: {a: 3}}')
@example('/**: {ros__parameters: {1: b, 1: {a: 1, b: 1.5, b: {p: 3}, b: true}}}')
@example('/lab: {reader: {ros__parameters: {a: 1}}}\n---\n/**: {ros__parameters: {a: x}}')
@example('/**: {ros__parameters: {s: {c: {}, d: 1}, e: 2}}')
@example('/**: {ros__parameters: [{a: 1}]}\n/lab/reader: {ros__parameters: [{a: 1}]}')
@example('hello')
@example('')
def test_documents_are_read_or_rejected_as_rcl_reads_or_rejects_them(ros, text):
    expected, found = rcl_reads(ros, text), we_read(text)
    if found is None:
        # We also reject a file that holds nothing for the node.
        assert not expected
    elif any(value == [] for value in found.values()):
        assert expected is None  # rcl makes an untyped parameter of it, which no node can declare
    else:
        assert expected is not None and same(found, expected)


@settings(max_examples=200)
@given(DOCUMENTS)
@example('/n:\n  ros__parameters:\n    a: [1, x]\n')
@example('/n:\n  ros__parameters:\n    a: 1\n    b: *x\n')
@example('/n:\n  ros__parameters:\n    a:\n    b: 1\n')
@example('/n:\n  ros__parameters:\n    a: [[1], [2]]\n')
@example('/n:\n  a: 1\n')
@example('ros__parameters:\n  a: 1\n')
@example('/n: {ros__parameters: 1}\n/n: 1\n')
def test_a_rejection_names_the_line_that_rcl_names(text):
    ours, theirs = rejection_of(text), rcl_rejection_of(text)
    named = re.search(r'line(?:_num)? (\d+)', theirs)
    # rcl names no line for the name of a node, and often the wrong one for what is not YAML.
    # What should be the header, or stands beside it, is named itself.
    if named and 'Error parsing a event near line' not in theirs and ': rcl rejects the file' not in ours:
        assert f', line {named[1]}: ' in ours


def rejection_of(text):
    with file_of(text) as path:
        try:
            read(path, '/lab/reader')
        except ParameterFileError as error:
            return str(error)
    return ''


def rcl_rejection_of(text):
    """Return what rcl's parser says against a file, or nothing."""
    with file_of(text) as path:
        rejection = first_rejection([path])
    return rejection[1] if rejection else ''


@pytest.mark.parametrize('block', ['/reader', 'reader', '/lab/reader', '/**', '/*', '/*/reader', '/**/reader', '/lab/*',
                                   '/lab/**', '/a/*/reader', '/*/*', '/reader/**', '/readers', '/lab'])
@pytest.mark.parametrize('node', ['/reader', '/lab/reader', '/a/lab/reader'])
def test_a_block_is_for_the_nodes_that_rcl_gives_it_to(ros, block, node):
    text = f'{block}:\n  ros__parameters:\n    a: 1\n'
    assert (we_read(text, node) or {}) == rcl_reads(ros, text, node)


@pytest.mark.parametrize(('text', 'complaint'), [
    ('/my node:\n  ros__parameters:\n    a: 1\n', "line 1: '/my node' is not a node name"),
    ('/other:\n  ros__parameters:\n    a: 1\n', 'holds nothing for /n; it is for /other'),
    ('', 'holds nothing for /n; it is for no node at all'),
])
def test_a_file_that_is_not_for_a_node_says_so(write, text, complaint):
    with pytest.raises(ParameterFileError, match=rf'robot\.yaml.*{complaint}'):
        read(write(text), '/n')


LISTS = ''.join(f'{after}: &{after} [{", ".join([f"*{before}"] * 10)}]\n'
                for before, after in zip('abcdefgh', 'bcdefghi'))


@pytest.mark.parametrize('text', [
    pytest.param('/n: {ros__parameters: {a: &a [1], b: *a}}', id='an alias'),
    pytest.param(f'/n:\n ros__parameters:\n  a: &a [1]\n  {LISTS}'.replace('\n', '\n  '), id='aliases that explode'),
    pytest.param('/n: &n {ros__parameters: *n}', id='an alias of itself'),
    pytest.param('/n: {ros__parameters: {a: \x07}}', id='a control character'),
])
def test_what_would_harm_the_reader_is_rejected(write, text):
    path = write(text, 'hostile.yaml')
    with pytest.raises(ParameterFileError, match=r'hostile\.yaml, line \d'):
        read(path, '/n')


def test_no_tag_makes_an_object(write, tmp_path):
    path = write('/n: {ros__parameters: {a: !!python/object/apply:os.mkdir ["made"]}}', 'hostile.yaml')
    assert read(path, '/n') == {'a': ['made']}
    assert [each.name for each in tmp_path.iterdir()] == ['hostile.yaml']


def test_a_deep_file_is_read(write):
    path = write('/n: {ros__parameters: ' + '{a: ' * 500 + '1' + '}' * 501, 'deep.yaml')
    assert read(path, '/n') == {'.'.join('a' * 500): 1}


def test_without_libyaml_the_same_is_read(monkeypatch):
    monkeypatch.setattr(parsing, 'LOADER', yaml.SafeLoader)
    assert we_read('/**: {ros__parameters: {a: {b: "x"}, c: [0x10]}}') == {'a.b': 'x', 'c': [16]}


# -- saving ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize('step', [(os, 'fsync'), (Path, 'replace')], ids=['write', 'replace'])
def test_a_failed_save_leaves_the_old_file_and_nothing_else(write, tmp_path, monkeypatch, step):
    path = write('old')

    def full(*_):
        raise OSError(28, 'No space left on device')

    monkeypatch.setattr(*step, full)
    with pytest.raises(OSError, match=r'No space left on device; the parameters were not written.*robot\.yaml'):
        render('/n', {'a': 1}).save(path)
    assert path.read_text() == 'old'
    assert [path.name for path in tmp_path.iterdir()] == ['robot.yaml']


def test_saving_keeps_permissions_and_links(tmp_path):
    path, link = tmp_path / 'robot.yaml', tmp_path / 'link.yaml'
    path.write_text('old')
    path.chmod(0o640)
    link.symlink_to(path)
    dump = render('/n', {'a': 1})
    dump.save(link)
    assert link.is_symlink()
    assert path.read_text() == dump.text
    assert stat.S_IMODE(path.stat().st_mode) == 0o640


@pytest.mark.parametrize('path', ['.', 'no/such/folder/robot.yaml'])
def test_where_nothing_can_be_written_the_error_says_so(tmp_path, path):
    with pytest.raises(OSError, match='the parameters were not written'):
        render('/n', {}).save(tmp_path / path)
    assert [path.name for path in tmp_path.iterdir()] == []


# -- the client, on live nodes ------------------------------------------------------------------------------


class Lists(Node):
    def __init__(self):
        super().__init__('lists')
        self.declare_parameters('', [('counts', [1, 2]), ('texts', ['y', ''])])


def test_an_empty_array_in_a_file_takes_the_type_of_the_parameter(ros, write):
    client = ParameterClient(ros.add(Lists))
    assert client.load(write('/**:\n  ros__parameters:\n    counts: []\n    texts: []\n')).successful
    types = client.get_parameter_types(['counts', 'texts'])
    assert types == {'counts': values.INTEGER_ARRAY, 'texts': values.STRING_ARRAY}


class Locked(Node):
    def __init__(self):
        super().__init__('locked')
        self.declare_parameter('serial', 'A', ParameterDescriptor(read_only=True))
        self.declare_parameter('speed', 1)


@pytest.mark.parametrize(('serial', 'kinds'), [('A', {'speed': 'accepted'}),
                                               ('B', {'serial': 'read only', 'speed': 'accepted'})])
def test_a_read_only_parameter_is_loaded_only_if_the_file_has_another_value(ros, write, serial, kinds):
    client = ParameterClient(ros.add(Locked))
    results = client.load(write(f'/locked:\n  ros__parameters:\n    serial: {serial}\n    speed: 2\n'))
    assert {each.name: each.kind for each in results} == kinds
    assert client.get_parameter('speed') == 2


def test_a_bad_file_sets_nothing(ros, tmp_path):
    ros.add(SimpleParamNode)
    client = ParameterClient('/simple_param_node')
    (tmp_path / 'bad.yaml').write_text('/**:\n  ros__parameters:\n    max_speed_rpm: 7\n    robot_name:\n')
    with pytest.raises(ParameterFileError, match='line 4'):
        client.load(tmp_path / 'bad.yaml')
    assert client.get_parameter('max_speed_rpm') == 100
