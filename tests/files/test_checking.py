"""Checking parameter files: every seeded error is found where it stands, and correct files are left alone."""

import codecs
import re
from pathlib import Path

import hypothesis.strategies as st
import pytest
from hypothesis import example, given

from param_tools import values
from param_tools.descriptor import Descriptor
from param_tools.files import descriptions
from param_tools.files.checking import check_files
from param_tools.files.descriptions import DescribedParameter, Descriptions, NodeDescription
from param_tools.files.parsing import Parser, effective, matches
from param_tools.files.rcl_parser import first_rejection
from tests.files.test_parameter_files import DOCUMENTS
from tests.support.paths import CONFIG

FILES = Path(__file__).parent / 'parameter_files'
LIFT_HEADER = '/hall_3/lift:\n  ros__parameters:\n'


def described_by(path, *nodes):
    """Return descriptions of nodes whose parameters have the types that a file gives them."""
    parser = Parser()
    parser.parse(path.read_bytes())
    result = []
    for node in nodes:
        result.append(NodeDescription(node, {
            name: DescribedParameter(Descriptor(name, values.type_of(entry.value())), entry.value())
            for name, entry in effective(parser, node).items()}))
    return Descriptions(result, complete=True)


NAVIGATION = described_by(
    FILES / 'navigation.yaml', '/localizer', '/navigator', '/controller_server', '/local_costmap/local_costmap',
    '/local_costmap/local_costmap_client', '/global_costmap/global_costmap', '/map_server')
CONTROLLERS = described_by(FILES / 'controllers.yaml', '/cell_1/controller_manager', '/cell_2/gripper_controller',
                           '/arm_controller')
LIFT = descriptions.read(FILES / 'lift_description.yaml')
AGAINST = {'navigation.yaml': NAVIGATION, 'controllers.yaml': CONTROLLERS, 'lift.yaml': LIFT}


def read_blocks(path):
    """Return what a file holds, by block."""
    return Parser().parse(path.read_bytes())


# -- no false alarm -------------------------------------------------------------------------------------------


@pytest.mark.parametrize('name', AGAINST)
def test_a_correct_file_is_left_alone(name):
    assert check_files(FILES / name, AGAINST[name]) == ()
    blocks = list(read_blocks(FILES / name))
    for description in AGAINST[name].values():
        findings = check_files(FILES / name, Descriptions([description]))
        assert findings == ()
        assert findings.passed_over == tuple(block for block in blocks if not matches(block, description.node))


@pytest.mark.parametrize('path', sorted(CONFIG.glob('*.yaml')), ids=lambda path: path.name)
def test_the_files_of_the_course_are_left_alone(path):
    assert check_files(path) == ()


LIKE_USERS = sorted((FILES / 'as_users_write').glob('*.yaml'))
FOR_LAUNCH = FILES / 'as_users_write' / 'of_a_launch_file.yaml'
# A node for each block that names no single one.
ROBOT = {'two_cells.yaml': ('/cell_1/controller_manager', '/cell_1/forward_controller', '/cell_2/forward_controller',
                            '/cell_1/trajectory_controller', '/cell_3/trajectory_controller'),
         'planning.yaml': ('/move_group', '/demo')}


@pytest.mark.parametrize('path', [each for each in LIKE_USERS if each != FOR_LAUNCH], ids=lambda path: path.stem)
def test_what_users_write_is_left_alone(path):
    nodes = ROBOT.get(path.name) or ['/' + block.strip('/') for block in read_blocks(path)]
    assert first_rejection([path]) is None
    assert check_files(path) == ()
    assert check_files(path, described_by(path, *nodes)) == ()


def test_what_a_launch_file_fills_in_is_named_and_not_judged(write):
    findings = check_files(FOR_LAUNCH, LIFT)
    assert findings == ()
    assert findings.left_to_launch == tuple(f'{FOR_LAUNCH}:{line}' for line in (1, 7, 9))
    spoiled = write(FOR_LAUNCH.read_text().replace('steps: 40', 'steps: 45'))
    assert [(each.line, each.kind) for each in check_files(spoiled, LIFT)] == [(10, 'off the step')]


# -- every seeded error is found ------------------------------------------------------------------------------

# File, what is replaced and by what, the finding, the text that its line begins or holds, its column, and words in its
# message.
SEEDED = [
    # the node's name, and what leads to it
    ('lift.yaml', '/hall_3/lift:', '/hall_3/lfit:', 'unknown node', '/hall_3/lfit', 1, 'Did you mean /hall_3/lift?'),
    ('lift.yaml', '/hall_3/lift:', 'lift:', 'never matched', 'lift:', 1, '"/**/lift:"'),
    ('lift.yaml', '/hall_3/lift:', '/*/lifts:', 'unknown node', '/*/lifts:', 1, 'no node matches /*/lifts'),
    ('navigation.yaml', '  local_costmap:\n    ros__p', '  costmap:\n    ros__p', 'unknown node', '  costmap:', 3,
     'Did you mean'),
    # the header
    ('lift.yaml', '/hall_3/lift:\n  ros__parameters', '/hall_3/lift:\n  ros_parameters', 'no header',
     'ros_parameters', 3, "should be 'ros__parameters'"),
    ('controllers.yaml', 'arm_controller:\n  ros__parameters:', 'arm_controller:\n  parameters:', 'no header',
     '  parameters:', 3, "should be 'ros__parameters'"),
    # names
    ('lift.yaml', 'steps: 40', 'step: 40', 'unknown parameter', 'step: 40', 5, 'Did you mean steps?'),
    ('lift.yaml', 'tool: {', 'tools: {', 'unknown parameter', 'kind: fork', 13, 'tool.kind'),
    # types
    ('lift.yaml', 'speed: 0.25', 'speed: 1', 'wrong type', 'speed: 1', 12, 'write 1.0'),
    ('lift.yaml', 'speed: 0.25', 'speed: "0.25"', 'wrong type', 'speed: "', 12, 'write 0.25'),
    ('lift.yaml', 'steps: 40', 'steps: 99999999999999999999', 'wrong type', 'steps: 9', 12, 'is a double'),
    ('lift.yaml', 'gains: [1.0, 0.5]', 'gains: [1, 2]', 'wrong type', 'gains:', 12, 'write [1.0, 2.0]'),
    ('lift.yaml', 'gains: [1.0, 0.5]', 'gains: 1.0', 'wrong type', 'gains:', 12, 'write [1.0]'),
    ('lift.yaml', 'gains: [1.0, 0.5]', 'gains: []', 'wrong type', 'gains:', 12, 'an empty array has no type'),
    ('lift.yaml', 'name: lift', 'name: y', 'wrong type', 'name: y', 11, "write 'y'"),
    ('lift.yaml', "'0123'", '0123', 'wrong type', 'code: 0123', 11, "cannot be 83: it is of type string, and 83 is an "
     "integer; write '0123'"),
    # ranges and steps
    ('lift.yaml', 'speed: 0.25', 'speed: 1.25', 'out of range', 'speed: 1.25', 12, 'between 0.0 and 1.0'),
    ('lift.yaml', 'steps: 40', 'steps: 45', 'off the step', 'steps: 45', 12, '10 apart'),
    # twice, and overridden
    ('lift.yaml', 'steps: 40', 'steps: 40\n    tool.kind: fork', 'duplicate', 'kind: fork,', 12, 'line 12'),
    ('lift.yaml', '    tool:', '/hall_3/lift:\n  ros__parameters:\n    tool:', 'duplicate',
     '/hall_3/lift:\n  ros__parameters:\n    tool', 1, 'line 7 already'),
    ('lift.yaml', 'length: 1.2}', 'length: 1.2}\n/*/lift:\n  ros__parameters:\n    speed: 0.75\n', 'overridden',
     'speed: 0.25', 12, 'gets 0.75 for speed, from line 20'),
    # what rcl rejects
    ('lift.yaml', 'gains: [1.0, 0.5]', 'gains: [[1.0], [0.5]]', 'unreadable', 'gains', 20, 'list of lists'),
]


@pytest.mark.parametrize(('name', 'old', 'new', 'kind', 'line', 'column', 'words'), SEEDED,
                         ids=[f'{each[0].partition(".")[0]}: {each[2].strip()}'[:60] for each in SEEDED])
def test_a_seeded_error_is_found_where_it_stands(write, name, old, new, kind, line, column, words):
    text = (FILES / name).read_text().replace(old, new, 1)
    findings = check_files(write(text, name), AGAINST[name])
    expected = [text.count('\n', 0, found.start()) + 1 for found in re.finditer(re.escape(line), text)]
    assert expected, 'the seed is not in the file'
    found = [each for each in findings if each.kind == kind and each.line in expected]
    assert found, findings
    assert words in found[0].message
    assert found[0].column == column, findings
    # No finding is about a correct value, apart from the same one again for the values beside it.
    assert {each.kind for each in findings} == {kind}, findings


# What stands below the header of /hall_3/lift, the finding, its line and column, and words in its message.
LINES = [
    # what is not YAML
    ('    speed: 0.25\n\tname: lift\n', 'unreadable', 4, 1, 'Indent with spaces'),
    ('    name: lift\n    speed:0.25\n', 'unreadable', 4, 5, 'A name ends with a colon and a space'),
    ('    steps: 40\n   name: lift\n', 'unreadable', 4, 4, 'The names of one block begin in the same column'),
    ('    name: @home\n', 'unreadable', 3, 11, 'A text that begins with @ needs quotes'),
    ("    name: 'it's'\n", 'unreadable', 3, 15, 'a quote inside quotes is written twice'),
    ('    gains: [1.0, 0.5\n    steps: 40\n', 'unreadable', 4, 10, 'in what begins in line 3'),
    (b'    name: gr\xfcn\n', 'unreadable', 3, 13, "the byte 0xfc would be 'ü' in Windows-1252"),
    ('    name: a\x07\n', 'unreadable', 3, 12, 'control characters are not allowed'),
    # what is YAML, and not for rcl
    ('    speed: &s 0.25\n    tool.length: *s\n', 'unreadable', 4, 18, 'write the value itself instead of *s'),
    ('    gains:\n      - 1.0\n      - true\n', 'unreadable', 5, 9, 'must all be of one type'),
    ('    name: #lift\n', 'unreadable', 3, 10, 'name has no value'),
    ('', 'unreadable', 2, 19, 'ros__parameters has no parameters below it: indent them'),
    # a value that is beside its header, or has none
    ('    steps: 40\n  speed: 0.25\n  name: a\n', 'no header', 4, 3, "speed stands beside 'ros__parameters'"),
    ('    steps: 40\n  tool: {kind: fork}\n', 'no header', 4, 3, "tool stands beside 'ros__parameters'"),
    ('    steps: 40\n/hall_3/gate:\n  speed: 0.25\n', 'no header', 5, 10, 'there is a value before ros__parameters'),
    # a block once more, by another name
    ('    speed: 0.25\nhall_3:\n  lift:\n    ros__parameters:\n      steps: 40\n', 'duplicate', 5, 3,
     'a block for /hall_3/lift in line 1 already'),
]


@pytest.mark.parametrize(('lines', 'kind', 'line', 'column', 'words'), LINES,
                         ids=[ascii(each[0])[:40] for each in LINES])
def test_a_mistake_is_found_whatever_the_editor(write, lines, kind, line, column, words):
    content = LIFT_HEADER.encode() + (lines if isinstance(lines, bytes) else lines.encode())
    for written in (content, codecs.BOM_UTF8 + content.replace(b'\n', b'\r\n')):
        path = write(written)
        finding = check_files(path, LIFT)[0]
        assert (finding.kind, finding.line, finding.column) == (kind, line, column), finding
        assert words in finding.message
        assert finding.message.isprintable()
        assert (first_rejection([path]) is not None) is (kind != 'duplicate')


def test_all_errors_of_a_file_are_found_at_once(write):
    path = write(f'{LIFT_HEADER}    speed: 1\n    gains: [1, x]\n    length: a\n    name:\n'
                 '/hall_3/lft:\n  ros_parameters:\n    steps: 1\n')
    assert [(each.line, each.kind) for each in check_files(path, LIFT)] == [
        (3, 'wrong type'), (4, 'unreadable'), (5, 'unknown parameter'), (6, 'unreadable'),
        (8, 'no header')]


WORDS = st.one_of(st.sampled_from([
    'null', '~', 'AAEC', 'true', 'yes', '1', '2.5', '1e3', '0x10', '1.0, 2.0', '[1, 2]', 'a', "it's", '- a\n- b', '',
    'a: b', '#', '12:30', '[]', ',', '"x"', '.nan', 'é']), st.text(alphabet='ab1 .,:[]-\'"\n', max_size=8))


@given(st.sampled_from(values.TYPES[1:]), WORDS, st.booleans())
@example(values.STRING_ARRAY, 'null', False)
@example(values.DOUBLE_ARRAY, '1', False)
def test_what_a_finding_says_to_write_loads(write, wanted, text, is_quoted):
    against = Descriptions([NodeDescription('/n', {'x': DescribedParameter(Descriptor('x', wanted))})])
    value = "'" + text.replace("'", "''") + "'" if is_quoted else text
    for each in check_files(write(f'/n:\n  ros__parameters:\n    x: {value}\n'), against):
        assert '\n' not in each.message
        if remedy := re.search(r'; write (.+?)$', each.message):
            assert check_files(write(f'/n:\n  ros__parameters:\n    x: {remedy[1]}\n'), against) == ()


# -- several files --------------------------------------------------------------------------------------------


@pytest.mark.parametrize(('first', 'second', 'loser'), [
    # A block keeps the place where its name first appeared.
    (['/**: speed: 0.1', '/hall_3/lift: speed: 0.2'], ['/**: speed: 0.3'], 'second.yaml'),
    (['/hall_3/lift: speed: 0.1'], ['/**: speed: 0.3'], 'first.yaml'),
    # Of values of two types, the first of boolean, integer, double, string stays.
    (['/hall_3/lift: steps: 40'], ['/hall_3/lift: steps: many'], 'second.yaml'),
])
def test_a_value_that_another_file_overrides_unexpectedly_is_found(write, first, second, loser):
    text = '{}:\n  ros__parameters:\n    {}: {}\n'
    paths = [write(''.join(text.format(*block.split(': ')) for block in blocks), name)
             for name, blocks in (('first.yaml', first), ('second.yaml', second))]
    finding, = (each for each in check_files(paths, LIFT) if each.kind == 'overridden')
    assert Path(finding.file).name == loser


def test_files_in_layers_are_left_alone(write):
    assert check_files([FILES / 'lift.yaml', write(f'{LIFT_HEADER}    speed: 0.75\n')], LIFT) == ()


BESIDE_THE_LIFT = '/hall_3/lift: {{ros__parameters: {{steps: 10}}}}\n{}: {{ros__parameters: {{name: a}}}}\n'


@pytest.mark.parametrize(('block', 'is_typo'), [
    ('/hall_3/lifft', True), ('/hall_3/list', True), ('/hall_3/lift_2', False), ('/hall_4/lift', False),
    ('/hall_3/left_lift', False), ('/hall_3/crane', False)])
def test_a_typo_is_found_beside_the_right_name_and_another_node_is_none(write, block, is_typo):
    found = check_files(write(BESIDE_THE_LIFT.format(block)), Descriptions(LIFT.values()))
    assert [(each.line, each.message) for each in found] == [
        (2, f'there is no node {block}, so rcl ignores this block. Did you mean /hall_3/lift?')] * is_typo


# -- whatever comes -------------------------------------------------------------------------------------------


def test_findings_as_text_and_as_annotations(write):
    path = write(f'{LIFT_HEADER}    name: "100 %"\n    steps: 10\n    steps: 10\n', 'a,b.yaml')
    findings = check_files(path, LIFT)
    assert findings.text() == f'{path}:5:5: duplicate: steps has a value in line 4 already'
    assert re.fullmatch(r'::warning file=[^,:]*a%2Cb\.yaml,line=5,col=5,title=duplicate::.+', findings.as_github())


@pytest.mark.parametrize('content', ['', '# nothing\n', 'a', '[]', b'\xff\xfe\x00', '\x00', '{' * 3000])
def test_what_is_no_parameter_file_is_a_finding(write, content):
    assert len(check_files(write(content), LIFT)) == 1


@given(st.one_of(DOCUMENTS, st.text(max_size=60), st.binary(max_size=60)))
def test_a_file_is_rejected_by_the_strict_reader_just_where_a_finding_says_so(write, content):
    path = write(content)
    findings = check_files(path, LIFT)
    strict = Parser()
    try:
        strict.parse(path.read_bytes())
        is_rejected = False
    except Exception as error:
        assert type(error).__name__ == 'Rejected'
        is_rejected = True
    assert is_rejected == any(each.kind in ('unreadable', 'no header') for each in findings)
    assert (findings.text() and findings.as_github()) or not findings


@pytest.mark.parametrize(('text', 'places', 'words'), [
    ('a: [{x: 1}, {x: 2}]', [(3, 8)], 'no lists of lists or of maps: rcl makes a.x.x = [1, 2] of this'),
    ('a: [1.0, [2.0]]', [(3, 8)], 'no lists of lists or of maps: rcl makes a = [2.0] of this'),
    ('inner:\n      ros__parameters: {a: 1, b: 2}', [(4, 25)],
     'so /lift gets a parameter inner.ros__parameters.a: the block of a node begins in the first column'),
    ('a: \u22121.5', [(3, 8)], 'a: there is a MINUS SIGN (U+2212)'),
    ('a: 2.0\xa0', [(3, 8)], 'a NO-BREAK SPACE (U+00A0)'), ('a\u200b: 2.0', [(3, 5)], 'a ZERO WIDTH SPACE'),
    ('a: \u201cbase\u201d', [(3, 8)], 'a LEFT DOUBLE QUOTATION MARK'),
    ('a: "\u201cbase\u201d \u22121"', [], ''), ('a: 5\xa0\n    b: x \u2212 y', [(3, 8)], ''),
])
def test_what_rcl_reads_otherwise_than_it_looks_is_found(write, text, places, words):
    found = check_files(write(f'/lift:\n  ros__parameters:\n    {text}\n'))
    assert [(each.line, each.column) for each in found] == places
    assert all(each.kind == 'likely mistake' and words in each.message for each in found)
