"""What comes after --ros-args: overrides, parameter files, wild cards, and what is rejected."""

import pytest
from rclpy.context import Context
from rclpy.impl.implementation_singleton import rclpy_implementation as layer
from rclpy.utilities import remove_ros_args


def overrides(node):
    return {name: (each.type_.name, each.value) for name, each in node._parameter_overrides.items()}


@pytest.mark.parametrize('text, kind, value', [
    ('1', 'INTEGER', 1), ('0x10', 'INTEGER', 16), ('010', 'INTEGER', 8), ('-1', 'INTEGER', -1), ('1.', 'DOUBLE', 1.0),
    ('1e3', 'DOUBLE', 1000.0), ('.inf', 'DOUBLE', float('inf')), ('true', 'BOOL', True), ('off', 'BOOL', False),
    ('text', 'STRING', 'text'), ('"1"', 'STRING', '1'), ("''", 'STRING', ''), ('a b', 'STRING', 'a b'),
    ('!!str 1', 'STRING', '1'), ('~', 'STRING', '~'), ('x:=y', 'STRING', 'x:=y'),
    ('[1, 2]', 'INTEGER_ARRAY', [1, 2]), ('[1.5]', 'DOUBLE_ARRAY', [1.5]), ('[true]', 'BOOL_ARRAY', [True]),
    ('[a, "2"]', 'STRING_ARRAY', ['a', '2']), ('[]', 'NOT_SET', None), ('# nothing', 'NOT_SET', None)])
def test_value_of_an_override(ros, text, kind, value):
    ros.init('-p', f'a:={text}')
    assert overrides(ros.node()) == {'a': (kind, value)}


def test_an_override_may_be_for_one_node_and_the_last_one_counts(ros):
    ros.init('-p', 'a:=1', '-p', 'node:b:=2', '-p', 'other:b:=3', '-p', 'a:=4', '-p', 'x.y:=5', '-p', 'qos./a.b:=6')
    assert overrides(ros.node()) == {
        'a': ('INTEGER', 4), 'b': ('INTEGER', 2), 'x.y': ('INTEGER', 5), 'qos./a.b': ('INTEGER', 6)}
    own = ['--ros-args', '-p', 'a:=text']
    assert overrides(ros.node('mine', cli_args=own))['a'] == ('STRING', 'text')
    assert overrides(ros.node('alone', cli_args=own, use_global_arguments=False)) == {'a': ('STRING', 'text')}


FILE = '''
/**: {ros__parameters: {everywhere: 1, twice: 1}}
/ns/*: {ros__parameters: {in_ns: 1}}
/ns/**/deep: {ros__parameters: {deep: 1}}
node: {ros__parameters: {root_only: 1, twice: 2}}
/ns/node: {ros__parameters: {nested: {a: [1, 2], b: {c: text}}, twice: 3}}
/**/node: {ros__parameters: {all_nodes: 1}}
'''


@pytest.mark.parametrize('namespace, name, expected', [
    ('', 'node', ['all_nodes', 'everywhere', 'root_only', 'twice']),
    ('/ns', 'node', ['all_nodes', 'everywhere', 'in_ns', 'nested.a', 'nested.b.c', 'twice']),
    ('/ns/sub', 'deep', ['deep', 'everywhere', 'twice']),
    ('/ns', 'deep', ['deep', 'everywhere', 'in_ns', 'twice']),
    ('/else', 'x', ['everywhere', 'twice'])])
def test_wild_cards_in_a_file(ros, tmp_path, namespace, name, expected):
    (tmp_path / 'file.yaml').write_text(FILE)
    ros.init('--params-file', str(tmp_path / 'file.yaml'))
    assert sorted(overrides(ros.node(name, namespace=namespace))) == expected


def test_files_and_overrides_count_in_their_order(ros, tmp_path):
    for number in (1, 2):
        (tmp_path / f'{number}.yaml').write_text(f'/**: {{ros__parameters: {{a: {number}, b{number}: 0}}}}\n')
    ros.init('--params-file', str(tmp_path / '2.yaml'), '-p', 'a:=7', '--params-file', str(tmp_path / '1.yaml'))
    assert overrides(ros.node()) == {'a': ('INTEGER', 1), 'b1': ('INTEGER', 0), 'b2': ('INTEGER', 0)}


WRONG = [
    (('-r', 'no_rule'), "Couldn't parse remap rule: '-r no_rule'. Error: "),
    (('-r', 'a:=b c'), "Couldn't parse remap rule: '-r a:=b c'. Error: "),
    (('-r', '__ns:=relative'), "Couldn't parse remap rule: '-r __ns:=relative'. Error: "),
    (('-r',), "Couldn't parse trailing -r flag. No remap rule found."),
    (('-p', 'a'), "Couldn't parse parameter override rule: '-p a'. Error: Expected lexeme type (22) not found"),
    (('-p', 'a:='), "Couldn't parse parameter override rule: '-p a:='. Error: error not set"),
    (('-p', 'a:={b: 1}'), "Couldn't parse parameter override rule: '-p a:={b: 1}'. Error: Unknown YAML event"),
    (('-p', 'a:=[b:c]'), "Couldn't parse parameter override rule: '-p a:=[b:c]'. Error: Error parsing an event"),
    (('-p', 'a:=[1'), "Couldn't parse parameter override rule: '-p a:=[1'. Error: Error parsing an event"),
    (('-p', 'a:=[1, x]'), "Couldn't parse parameter override rule: '-p a:=[1, x]'. Error: "),
    (('-p',), "Couldn't parse trailing -p flag. No parameter override rule found."),
    (('--params-file', '/no/such.yaml'),
     "Couldn't parse params file: '--params-file /no/such.yaml'. Error: Error opening YAML file"),
    (('--params-file',), "Couldn't parse trailing --params-file flag. No file path provided."),
    (('--log-level', 'loud'), "Couldn't parse log level: '--log-level loud'. Error: Argument does not use a valid sev"),
    (('--log-level',), "Couldn't parse trailing log level flag: '--log-level'. No log level provided."),
    (('-e', 'relative'), "Enclave name is not valid: 'context name must be absolute, it must lead with a '/''. Inval"),
    (('-e',), "Couldn't parse trailing -e flag. No enclave path provided."),
]


@pytest.mark.parametrize('words, why', WRONG)
def test_rejected_arguments(words, why):
    with pytest.raises(layer.RCLError) as raised:
        Context().init(['program', '--ros-args', *words])
    assert str(raised.value).startswith(f'failed to initialize rcl: {why}')


@pytest.mark.parametrize('words, why', [each for each in WRONG if each[0][0] != '-e' or len(each[0]) == 1])
def test_rejected_arguments_of_one_node(ros, words, why):
    for reject in (lambda: ros.node(cli_args=['--ros-args', *words]), lambda: remove_ros_args(['--ros-args', *words])):
        with pytest.raises(layer.RCLInvalidROSArgsError) as raised:
            reject()
        assert str(raised.value).startswith(f'Failed to parse ROS arguments: {why}')


@pytest.mark.parametrize('text, why', [
    ('a:\n  b: 1\n', 'Cannot have a value before ros__parameters at line 2, at '),
    ('ros__parameters: {a: 1}\n', 'There are no node names before ros__parameters at line 1, at '),
    ('a:\n  ros__parameters:\n    b: [1, x]\n',
     "Sequence should be of same type. Value type 'string' do not belong at line_num 3, at "),
    ('a:\n  ros__parameters:\n    b: [x, 2.5]\n',
     "Sequence should be of same type. Value type 'double' do not belong at line_num 3, at "),
    ('a: {ros__parameters: {b: }}\n', 'No value at line 1, at '),
    ('a: {ros__parameters: {b: &x 1, c: *x}}\n', 'Will not support aliasing at line 1'),
    ('a: {ros__parameters: {[b]: 1}}\n', 'Sequences cannot be key at line 1, at '),
    ('a: [ros__parameters]\n', 'Sequences can only be values and not keys in params. Error at line 1'),
    ('a: {ros__parameters: {b: "1}}\n', 'Error parsing a event near line 1, at '),
    ('a:\n  ros__parameters: {b: 12:30}\n', 'Error parsing a event near line 2, at '),
    ('a: {ros__parameters:\n    {b: "x:y", c: [d?]}}\n', 'Error parsing a event near line 2, at '),
    ('%YAML 1.2\n--- {a: {ros__parameters: {b: 1}}}\n', 'Error parsing a event near line 1, at ')])
def test_why_a_file_is_rejected(tmp_path, text, why):
    (tmp_path / 'file.yaml').write_text(text)
    with pytest.raises(layer.RCLError) as raised:
        Context().init(['--ros-args', '--params-file', str(tmp_path / 'file.yaml')])
    assert f"Couldn't parse params file: '--params-file {tmp_path}/file.yaml'. Error: {why}" in str(raised.value)


def test_unknown_arguments(ros):
    for words in (['--bogus'], ['bogus'], ['__ns:=/a'], ['--bogus', 'x']):
        with pytest.raises(layer.UnknownROSArgsError) as raised:
            Context().init(['program', '--ros-args', *words])
        assert str(raised.value) == repr(words)
    with pytest.raises(layer.UnknownROSArgsError):
        ros.node(cli_args=['--ros-args', '--bogus'])


def test_arguments_that_are_not_for_ros():
    words = ['program', '--ros-args', '-r', 'a:=b', '--', 'x', '--ros-args', '-p', 'a:=1', '--enable-rosout-logs']
    assert remove_ros_args(words) == ['program', 'x']
    assert remove_ros_args(['a', '--ros-args', '--', '--', 'b']) == ['a', '--', 'b']
    assert remove_ros_args(['a', '--ros-args']) == ['a']
