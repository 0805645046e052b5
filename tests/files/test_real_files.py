"""What people have in their parameter files and schemas: `check` names the cause, and a remedy that loads."""

import re

import hypothesis.strategies as st
import pytest
import yaml
from hypothesis import example, given
from rclpy.node import Node

from param_tools import values
from param_tools.descriptor import Descriptor
from param_tools.files import descriptions
from param_tools.files.checking import check_files
from param_tools.files.descriptions import DescribedParameter, Descriptions, NodeDescription
from param_tools.files.parsing import Parser, effective
from param_tools.files.rcl_parser import first_rejection
from tests.files.test_parameter_files import rcl_reads, same, we_read
from tests.support.commands import run

HEADER = '/lab/reader:\n  ros__parameters:\n'


def check(tmp_path, text, against=None, **options):
    """Return the findings in a text."""
    path = tmp_path / 'any.yaml'
    path.write_text(text)
    found = check_files(path, against, **options)
    assert all(each.message.isprintable() for each in found)
    return found


def read_schemas(tmp_path, *texts, node='/lab/reader'):
    """Return the description of a node that schemas give."""
    result = Descriptions()
    for number, text in enumerate(texts):
        path = tmp_path / f'schema_{number}.yaml'
        path.write_text(text)
        result.add(descriptions.read(path, node))
    return result


# -- what every node declares ---------------------------------------------------------------------------------


@pytest.mark.parametrize('known', [True, False])
@pytest.mark.parametrize(('line', 'words'), [
    ('use_sim_time: true', ''), ('use_sim_time: off', ''), ('start_type_description_service: false', ''),
    ('qos_overrides./tf.publisher.depth: many', ''), ('qos_overrides: {/tf: {publisher: {depth: 5}}}', ''),
    ('use_sim_time: "true"', 'leave the quotes out'), ('use_sim_time: 1', 'it is of type boolean, and 1 is an integer'),
    ('use_sim_time: 0.0', 'is a double'), ('use_sim_time: [true]', 'write true'),
    ('use_sim_time: tRue', 'rcl reads tRue as the string'),
    ('start_type_description_service: "no"', 'leave the quotes'),
])
def test_what_every_node_declares_has_the_type_that_every_node_gives_it(ros, write, tmp_path, line, words, known):
    text = f'{HEADER}    {line}\n'
    path = write(text)
    try:
        ros.add(Node, 'reader', namespace='/lab', cli_args=['--ros-args', '--params-file', str(path)])
        starts = True
    except Exception as error:
        assert type(error).__name__ == 'InvalidParameterTypeException'
        starts = False
    against = Descriptions([NodeDescription('/lab/reader', {})]) if known else None
    found = [each for each in check(tmp_path, text, against) if each.severity == 'error']
    assert starts is (words == '') is (not found)
    assert not found or (words in found[0].message and (found[0].kind, found[0].line) == ('wrong type', 3))


# -- names that are there twice -------------------------------------------------------------------------------


@pytest.mark.parametrize(('text', 'places'), [
    ('area:\n  pump: {ros__parameters: {a: 1}}\narea:\n  lamp: {ros__parameters: {b: 1}}\n', [(3, 1)]),
    ('/x:\n  area:\n    pump: {ros__parameters: {a: 1}}\n  area:\n    lamp: {ros__parameters: {b: 1}}\n', [(4, 3)]),
    ('a: {b: {ros__parameters: {x: 1}}}\na: {c: {ros__parameters: {x: 1}}}\na: {d: {ros__parameters: {x: 1}}}\n',
     [(2, 1), (3, 1)]),
    ('/n:\n  ros__parameters:\n    gains: {p: 1.0}\n    gains: {d: 1.0}\n', [(4, 5)]),
    ('/n:\n  ros__parameters:\n    m: {gains: {p: 1.0}}\n    n: {gains: {d: 1.0}}\n', []),
    ('/n:\n  a: {ros__parameters: {x: 1}}\n/m:\n  a: {ros__parameters: {x: 1}}\n', []),
    ('/n:\n  ros__parameters:\n    x: [{a: 1}]\n    y: [{a: 1}]\n', []),
])
def test_a_name_with_a_map_that_is_there_twice_is_found(tmp_path, text, places):
    found = check(tmp_path, text)
    assert [(each.line, each.column) for each in found if each.kind == 'duplicate'] == places
    # rcl loses nothing; what `ros2 param load` reads a file with does.
    read = sum(map(len, Parser().parse(text.encode()).values()))
    assert (str(yaml.safe_load(text)).count(': 1') < read) is bool(places)
    assert all('`ros2 param load` only the last' in each.message for each in found)


# -- maps in lists --------------------------------------------------------------------------------------------


@pytest.mark.parametrize('value', [
    '[{a: 1}]', '[{a: [1, 2]}]', '[1, {a: 2}]', '[{a: 1}, {b: 2}]', '[{a: {b: 1}}]', '[{n: s, v: t}]',
    '\n      - interfaces:\n          - vacuum\n          - pressure'])
def test_a_list_that_holds_a_map_is_named_as_rcl_names_it(ros, tmp_path, value):
    text = f'{HEADER}    first: 1\n    x: {value}\n    last: 2\n'
    assert same(rcl_reads(ros, text), we_read(text))
    assert check(tmp_path, text) == ()
    parser = Parser()
    parser.parse(text.encode())
    assert {each.name for each in parser.assignments} >= effective(parser, '/lab/reader').keys()
    described = {name: DescribedParameter(Descriptor(name, values.type_of(entry.value())))
                 for name, entry in effective(parser, '/lab/reader').items()}
    assert check(tmp_path, text, Descriptions([NodeDescription('/lab/reader', described)])) == ()


# -- remedies -------------------------------------------------------------------------------------------------

WORDS = st.one_of(st.sampled_from([
    'null', '~', 'None', 'AAEC', 'true', 'yes', '1', '2.5', '2,5', '1e3', '0x10', '1.0, 2.0', '1 2 3', '[1, 2]', 'a',
    'a, b', "it's", '- a\n- b', '', ' ', 'a: b', '#', '12:30', '1_000', '[a', '[]', ',', '"x"', '.nan', 'é']),
    st.text(alphabet='ab1 .,:[]-\'"\n', max_size=8))


def written(text, style):
    """Return a text as a value in a file: plain, in quotes, in a block, or as a tagged one."""
    lines = ''.join(f'\n      {line}' for line in text.split('\n'))
    return {'plain': text, 'quotes': "'" + text.replace("'", "''") + "'", 'block': f'|{lines}', 'folded': f'>-{lines}',
            'binary': f'!!binary |{lines}'}[style]


@pytest.mark.slow
@given(st.sampled_from(values.TYPES[1:]), WORDS, st.sampled_from(['plain', 'quotes', 'block', 'folded', 'binary']))
@example(values.BYTE_ARRAY, 'AAEC', 'binary')
@example(values.STRING_ARRAY, 'null', 'plain')
@example(values.STRING_ARRAY, 'east', 'block')
@example(values.DOUBLE_ARRAY, '2.0, 0.0, 2.5', 'quotes')
@example(values.DOUBLE_ARRAY, '1', 'plain')
@example(values.DOUBLE, '2.0', 'block')
def test_what_a_finding_says_to_write_is_one_line_and_loads(tmp_path, wanted, text, style):
    against = Descriptions([NodeDescription('/lab/reader', {
        'x': DescribedParameter(Descriptor('x', wanted))})])
    found = [each for each in check(tmp_path, f'{HEADER}    x: {written(text, style)}\n', against)
             if each.kind == 'wrong type']
    for each in found:
        assert '\n' not in each.message
        if remedy := re.search(r'; (?:.*: )?write (.+?)(, with a point)?$', each.message):
            if remedy[1] == 'a list in brackets, or leave the line out':
                continue
            assert [other for other in check(tmp_path, f'{HEADER}    x: {remedy[1]}\n', against)
                    if other.severity == 'error'] == []
        assert wanted is not values.BYTE_ARRAY or re.search('no byte arrays|empty array', each.message)


# -- headers --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(('text', 'line', 'column', 'words'), [
    ('/n:\n  ros__parameters:\n  a: 1\n  b: 2\n', 3, 3, 'a and b stand beside'),
    ('/n:\n  ros__parameters:\n    a: 1\n  b: {c: 2}\n', 4, 3, 'b stands beside'),
    ('/n:\n  ros__parameters:\n    a: 1\nb: [2]\n', 4, 1, 'b stands left of'),
    ('/n:\n  ros__parameters:\na: 1\nb: 1\nc: 1\nd: 1\n', 3, 1, 'a, b, c and 1 more stand left of'),
    ('/n:\n  a: 1\n  ros__parameters:\n    b: 1\n', 2, 3, 'Move it below ros__parameters, and indent it'),
    ('/x:\n  n:\n    ros__parameters:\n      a: 1\n    b: 1\n', 5, 5, 'Indent this line'),
    ('/**:\n  ros__parameters:\n    a: 1\n  pump:\n    ros__parameters:\n      b: 2\n', 4, 3,
     'pump is a node inside /**, and rcl rejects a node after'),
    ('x:\n  y:\n    ros__parameters:\n      a: 1\n    b:\n      ros__parameters:\n        c: 2\n', 5, 5,
     'write "/x/y/b:" at the left edge'),
    ('/n:\n  ros__parameters:\n    x: {}\n    y: 1\n', 3, 5, 'x is an empty map'),
    ('/n:\n  ros__parameters:\n    x: 1\n  ros__parameters:\n    y: 1\n', 4, 3, 'stands in line 2 already'),
    ('/area:\n  pump: {ros__parameters: {a: 1}}\n  lamp:\n    b: {c: 1}\n', 3, 3, "between 'lamp' and the values"),
    ('/area:\n  pump: {gains: {p: 1, i: 2}}\n', 1, 1, "between '/area' and the values"),
])
def test_the_cause_is_named_where_the_header_is_not_above_the_parameters(tmp_path, text, line, column, words):
    finding, = check(tmp_path, text)
    assert (finding.kind, finding.line, finding.column) == ('no header', line, column)
    assert words in finding.message
    assert first_rejection([tmp_path / 'any.yaml']) is not None


@pytest.mark.parametrize('text', ['/n:\n  ros__parameters:\n', '/n: {ros__parameters: }\n'])
def test_a_header_without_parameters_is_named(tmp_path, text):
    finding, = check(tmp_path, text)
    assert 'ros__parameters has no parameters below it: write ros__parameters: {} for none' in finding.message
    assert first_rejection([tmp_path / 'any.yaml']) is not None


def test_an_empty_map_that_rcl_accepts_is_no_cause(tmp_path):
    text = '/n:\n  ros__parameters:\n    a: 1\n    x: {}\n'
    assert check(tmp_path, text) == ()
    assert first_rejection([tmp_path / 'any.yaml']) is None
    finding, = check(tmp_path, f'/m:\n  ros__parameters:\n    b:\n{text}')
    assert (finding.line, finding.kind) == (3, 'unreadable')


def test_a_node_before_the_header_is_fine(tmp_path):
    assert check(tmp_path, '/**:\n  pump:\n    ros__parameters:\n      b: 2\n  ros__parameters:\n    a: 1\n') == ()
    assert first_rejection([tmp_path / 'any.yaml']) is None


@pytest.mark.slow
@given(st.lists(st.sampled_from(['1', 'x', '[1, 2]', '{b: 1}', '{b: {c: [x]}}']), min_size=1, max_size=5), st.data())
def test_lines_too_far_left_are_found_where_they_begin(tmp_path, items, data):
    begin = data.draw(st.integers(0, len(items) - 1))
    column = data.draw(st.sampled_from([0, 2] if not any(item.startswith('{') for item in items) else [2]))
    lines = [f'{" " * (4 if number < begin else column)}p{number}: {item}\n' for number, item in enumerate(items)]
    finding, = check(tmp_path, HEADER + ''.join(lines))
    assert (finding.kind, finding.line, finding.column) == ('no header', begin + 3, column + 1)
    assert 'Indent' in finding.message
    assert first_rejection([tmp_path / 'any.yaml']) is not None


# -- schemas --------------------------------------------------------------------------------------------------

WHEELS = 'wheels:\n  radius: {type: double, default_value: 0.1, validation: {gt<>: [0.0]}}\n'


@pytest.mark.parametrize(('schema', 'text', 'found'), [
    (WHEELS, 'type: some/Wheels\n    update_rate: 50\n    is_async: false\n    thread_priority: 10', []),
    (WHEELS, 'type: some/Wheels\n    fallback_controllers: [a]\n    async_parameters: {thread_priority: 5}', []),
    (WHEELS, 'type: some/Wheels\n    update_rate: 50.0', ['wrong type: update_rate']),
    (WHEELS, 'type: some/Wheels\n    is_async: 1', ['wrong type: is_async']),
    (WHEELS, 'type: some/Wheels\n    updaterate: 50', ['unknown parameter: updaterate']),
    (WHEELS, 'update_rate: 50\n/cm:\n  ros__parameters:\n    reader.type: some/Wheels', []),
    (WHEELS, 'update_rate: 50\n/cm:\n  ros__parameters:\n    other.type: some/Wheels',
     ['unknown parameter: update_rate']),
    (WHEELS, 'update_rate: 50', ['unknown parameter: update_rate']),
    (WHEELS, 'type: large\n    update_rate: 50', ['unknown parameter: type', 'unknown parameter: update_rate']),
    (WHEELS.replace('wheels', 'wheel_controller'), 'update_rate: 50\n    is_async: true', []),
    (WHEELS.replace('wheels', 'imu_broadcaster'), 'update_rate: 50\n    radiu: 1.0', ['unknown parameter: radiu']),
])
def test_a_controller_has_the_parameters_that_ros2_control_gives_it(tmp_path, schema, text, found):
    against = read_schemas(tmp_path, schema)
    assert [f'{each.kind}: {each.parameter}' for each in check(tmp_path, f'{HEADER}    {text}\n', against)] == found


def test_a_running_controller_declares_no_type(tmp_path):
    names = {'update_rate': values.INTEGER, 'is_async': values.BOOL}
    running = Descriptions([NodeDescription('/lab/reader', {
        name: DescribedParameter(Descriptor(name, kind)) for name, kind in names.items()})])
    assert check(tmp_path, f'{HEADER}    type: some/Wheels\n', running) == ()
    other = Descriptions([NodeDescription('/lab/reader', {})])
    assert [each.kind for each in check(tmp_path, f'{HEADER}    type: some/Wheels\n', other)] == ['unknown parameter']


def test_several_schemas_of_one_node_are_one_description(write):
    paths = [write(WHEELS, 'one.yaml'), write('gains:\n  p: {type: double, default_value: 1.0}\n', 'two.yaml')]
    robot = write(f'{HEADER}    radius: 0.5\n    p: 2.0\n')
    words = ['check', robot, *(word for path in paths for word in ('--against', f'/lab/reader={path}'))]
    assert run(*words) == ('', '', 0)
    robot.write_text(f'{HEADER}    radius: -0.5\n    p: 2\n    d: 1.0\n')
    assert [line.split(': ')[1] for line in run(*words)[0].splitlines()] == [
        'out of range', 'wrong type', 'unknown parameter']
    described = run('describe', *(f'/lab/reader={path}' for path in paths))[0]
    assert {'radius', 'p'} == yaml.safe_load(described)['nodes']['/lab/reader']['parameters'].keys()


def test_a_running_node_keeps_its_types_and_gets_the_validators_of_its_schema(tmp_path):
    schema = read_schemas(tmp_path, WHEELS)['/lab/reader']
    declared = Descriptor('radius', values.DOUBLE, 'from the node', read_only=True)
    running = NodeDescription('/lab/reader', {'radius': DescribedParameter(declared, 0.3)})
    both = running.joined(schema)
    assert both.parameters['radius'].descriptor is declared
    assert both.parameters['radius'].objection(-1.0).kind == 'out of range'
    assert list(both.missing({})) == []


@pytest.mark.parametrize(('names', 'template', 'given_names', 'entry', 'is_known'), [
    ('wheel.names', 'wheel.__map_names.radius', '[left]', 'wheel.left.radius', True),
    ('wheel.names', 'wheel.__map_names.radius', '[left]', 'wheel.right.radius', False),
    ('a.b.names', 'a.b.c.__map_names.x', '[left]', 'a.b.c.left.x', True),
    ('a.b.names', 'a.b.c.__map_names.x', '[left]', 'a.b.c.right.x', False),
    ('names', 'wheel.__map_names.radius', '[left]', 'wheel.right.radius', False),
    ('other.names', 'wheel.__map_names.radius', '[left]', 'wheel.right.radius', True),
])
def test_the_names_of_a_map_may_be_in_its_group(tmp_path, names, template, given_names, entry, is_known):
    tree = {}
    for name, leaf in ((names, {'type': 'string_array', 'default_value': ['z']}),
                       (template, {'type': 'double', 'default_value': 1.0})):
        branch = tree
        for part in name.split('.'):
            branch = branch.setdefault(part, {})
        branch.update(leaf)
    against = read_schemas(tmp_path, yaml.safe_dump({'cart': tree}))
    text = f'{HEADER}    {names}: {given_names}\n    {entry}: 2.0\n'
    assert [each.kind for each in check(tmp_path, text, against)] == ['unknown parameter'] * (not is_known)


CART = '''cart:
  label: {type: string, default_value: ''}
  radius: {type: double}
  names: {type: string_array, default_value: [], validation: {not_empty<>: []}}
  limits: {__map_names: {low: {type: double, validation: {gt<>: [0.0]}}}}
  free: {type: none}
'''


@pytest.mark.parametrize(('text', 'names'), [
    ('label: x', ['radius', 'names']), ('radius: 1.0', ['names']), ('radius: 1.0\n    names: [a]', ['limits.a.low']),
    ('radius: 1.0\n    names: [a, b]\n    limits: {b: {low: 1.0}}', ['limits.a.low']),
    ('radius: 1.0\n    names: [a]\n    limits.a.low: 1.0', []),
    ('radius: $(var r)\n    names: [a]\n    limits.a.low: 1.0', []),
])
def test_a_parameter_without_which_the_node_does_not_start_is_missed(tmp_path, text, names):
    against = read_schemas(tmp_path, CART)
    found = [each for each in check(tmp_path, f'{HEADER}    {text}\n', against) if each.kind == 'missing']
    assert [each.parameter for each in found] == names
    assert all((each.line, each.column) == (1, 1) for each in found)
    # A file that is loaded meets a node that has started, and one for other nodes is not about this one.
    assert [each for each in check(tmp_path, f'{HEADER}    {text}\n', against, loading=True)
            if each.kind == 'missing'] == []
    elsewhere = check(tmp_path, '/other:\n  ros__parameters:\n    a: 1\n', against)
    assert [each.kind for each in elsewhere] == ['unknown node']


def test_what_is_missed_may_be_in_another_file_and_comes_back_with_a_saved_schema(write, tmp_path):
    against = read_schemas(tmp_path, CART)
    saved = tmp_path / 'saved.yaml'
    against.dump().save(saved)
    first = write(f'{HEADER}    label: x\n    names: [a]\n', 'first.yaml')
    second = write('/**:\n  ros__parameters:\n    radius: 1.0\n    limits.a.low: 1.0\n', 'second.yaml')
    for description in (against, descriptions.read(saved)):
        assert check_files([first, second], description) == ()
        assert [each.parameter for each in check_files(first, description)] == ['radius', 'limits.a.low']


@pytest.mark.parametrize(('schema', 'complaint'), [
    ('blinker:\n  period: {description: "Seconds", default_value: 1.0}\n', 'period has no type; the types are'),
    ('blinker:\n  a: {type: int}\n  gain: {description: "x"}\n', 'gain has no type'),
    ('blinker:\n  a: {b: {type: int}, c: {read_only: true}}\n', 'a.c has no type'),
    ('blinker:\n  a: {type: int}\n  gain: {type: null}\n', 'gain has the type None'),
    ('blinker:\n  a: {type: int}\n  gain: {type: float}\n', "gain has the type 'float'"),
    ('blinker:\n  period: {default_value: 1.0, validation: {gt<>: [0.0]}}\n', 'period has no type'),
])
def test_a_parameter_of_a_schema_without_a_type_is_named(write, schema, complaint):
    path = write(schema)
    stdout, stderr, status = run('describe', path)
    assert (stdout, status) == ('', 1)
    assert stderr.startswith(f'{path}: {complaint}')


def test_a_group_may_be_named_like_a_property(tmp_path):
    schema = 'n:\n  type: {type: {type: int, default_value: 1}, description: {type: string, default_value: x}}\n'
    assert list(read_schemas(tmp_path, schema)['/lab/reader'].parameters) == ['type.type', 'type.description']
