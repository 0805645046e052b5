"""Checking parameter files: every seeded error is found where it stands, and correct files are left alone."""

import codecs
import json
import re
from pathlib import Path

import hypothesis.strategies as st
import pytest
from hypothesis import given, settings

from param_tools import values
from param_tools.descriptor import Descriptor
from param_tools.files import descriptions
from param_tools.files.checking import KINDS, check_files
from param_tools.files.descriptions import DescribedParameter, Descriptions, NodeDescription
from param_tools.files.parsing import Parser, effective, matches
from tests.files.test_parameter_files import DOCUMENTS, rcl_rejection_of

FILES = Path(__file__).parent / 'parameter_files'
CONFIG = Path(__file__).parents[2] / 'config'


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
CONTROLLERS = described_by(FILES / 'controllers.yaml', '/cell_1/controller_manager', '/cell_2/gripper_controller')
CONTROLLERS.update(descriptions.read(FILES / 'arm_controller_schema.yaml'))
LIFT = descriptions.read(FILES / 'lift_description.yaml')
AGAINST = {'navigation.yaml': NAVIGATION, 'controllers.yaml': CONTROLLERS, 'lift.yaml': LIFT}


def read_blocks(path):
    """Return what a file holds, by block."""
    return Parser().parse(path.read_bytes())


# -- no false alarm -------------------------------------------------------------------------------------------


@pytest.mark.parametrize('name', AGAINST)
@pytest.mark.parametrize('complete', [True, False])
def test_a_correct_file_is_left_alone(name, complete):
    against = Descriptions(AGAINST[name].values(), complete=complete)
    assert check_files(FILES / name, against) == ()


@pytest.mark.parametrize('name', AGAINST)
def test_a_correct_file_is_left_alone_where_only_one_of_its_nodes_is_known(name):
    blocks = list(read_blocks(FILES / name))
    for description in AGAINST[name].values():
        findings = check_files(FILES / name, Descriptions([description]))
        assert findings == ()
        assert findings.passed_over == tuple(block for block in blocks if not matches(block, description.node))


@pytest.mark.parametrize('path', [*sorted(CONFIG.glob('*.yaml')), FILES / 'controllers.yaml'],
                         ids=lambda path: path.name)
def test_without_a_description_a_correct_file_is_left_alone(path):
    assert check_files(path) == ()


def test_files_in_layers_are_left_alone(write):
    special = write('/hall_3/lift:\n  ros__parameters:\n    speed: 0.75\n')
    assert check_files([FILES / 'lift.yaml', special], LIFT) == ()


LIKE_USERS = sorted((FILES / 'as_users_write').glob('*.yaml'))
FOR_LAUNCH = FILES / 'as_users_write' / 'of_a_launch_file.yaml'
# A node for each block that names no single one.
ROBOT = {'two_cells.yaml': ('/cell_1/controller_manager', '/cell_1/forward_controller', '/cell_2/forward_controller',
                            '/cell_1/trajectory_controller', '/cell_3/trajectory_controller'),
         'planning.yaml': ('/move_group', '/demo')}


@pytest.mark.parametrize('begins', [b'', codecs.BOM_UTF8], ids=['', 'BOM'])
@pytest.mark.parametrize('ends', [b'\n', b'\r\n'], ids=['LF', 'CRLF'])
@pytest.mark.parametrize('path', [each for each in LIKE_USERS if each != FOR_LAUNCH], ids=lambda path: path.stem)
def test_what_users_write_is_left_alone(write, path, begins, ends):
    nodes = ROBOT.get(path.name) or ['/' + block.strip('/') for block in read_blocks(path)]
    against = described_by(path, *nodes)
    written = write(begins + path.read_bytes().replace(b'\n', ends))
    assert rcl_rejection_of(written.read_bytes()) == ''
    assert check_files(written) == ()
    assert check_files(written, against) == ()
    for description in against.values():
        assert check_files(written, Descriptions([description])) == ()


def test_what_a_launch_file_fills_in_is_named_and_not_judged(write):
    findings = check_files(FOR_LAUNCH, LIFT)
    assert findings == ()
    assert findings.left_to_launch == tuple(f'{FOR_LAUNCH}:{line}' for line in (1, 7, 8, 9))
    spoiled = write(FOR_LAUNCH.read_text().replace('steps: 40', 'steps: 45'))
    assert [(each.line, each.kind) for each in check_files(spoiled, LIFT)] == [(10, 'off the step')]


# -- every seeded error is found ------------------------------------------------------------------------------

# File, what is replaced and by what, the finding, the text that its line begins or holds, its column, and words in its
# message.
SEEDED = [
    # the node's name, and what leads to it
    ('lift.yaml', '/hall_3/lift:', '/hall_3/lfit:', 'unknown node', '/hall_3/lfit', 1, 'Did you mean /hall_3/lift?'),
    ('lift.yaml', '/hall_3/lift:', '/lift:', 'never matched', '/lift:', 1, 'there is /hall_3/lift'),
    ('lift.yaml', '/hall_3/lift:', 'lift:', 'never matched', 'lift:', 1, '"/**/lift:"'),
    ('lift.yaml', '/hall_3/lift:', '/*:', 'never matched', '/*:', 1, '** for any number'),
    ('lift.yaml', '/hall_3/lift:', '/*/lifts:', 'never matched', '/*/lifts:', 1, 'no node matches'),
    ('navigation.yaml', 'localizer:', 'localiser:', 'unknown node', 'localiser', 1, '/localizer'),
    ('navigation.yaml', '  local_costmap:\n    ros__p', '  costmap:\n    ros__p', 'unknown node', '  costmap:', 3,
     'Did you mean'),
    ('controllers.yaml', '/**/controller_manager', 'controller_manager', 'never matched', 'controller_manager:', 1,
     '/cell_1/controller_manager'),
    # the header
    ('lift.yaml', '/hall_3/lift:\n  ros__parameters', '/hall_3/lift:\n  ros_parameters', 'no header',
     'ros_parameters', 3, "should be 'ros__parameters'"),
    ('controllers.yaml', 'arm_controller:\n  ros__parameters:', 'arm_controller:\n  parameters:', 'no header',
     '  parameters:', 3, "should be 'ros__parameters'"),
    # names
    ('lift.yaml', 'steps: 40', 'step: 40', 'unknown parameter', 'step: 40', 5, 'Did you mean steps?'),
    ('lift.yaml', 'kind: fork', 'knid: fork', 'unknown parameter', 'knid', 12, 'tool.kind'),
    ('lift.yaml', 'tool: {', 'tools: {', 'unknown parameter', 'kind: fork', 13, 'tool.kind'),
    ('navigation.yaml', 'PathAlign.scale', 'PathAllign.scale', 'unknown parameter', 'PathAllign', 7,
     'FollowPath.PathAlign.scale'),
    ('navigation.yaml', 'cost_power: 1', 'cost_powr: 1', 'unknown parameter', 'cost_powr', 9, 'cost_power'),
    ('controllers.yaml', '  elbow: {p: 5.0', '  elbw: {p: 5.0', 'unknown parameter', 'elbw', 14, 'gains.elbow.p'),
    # types
    ('lift.yaml', 'speed: 0.25', 'speed: 1', 'wrong type', 'speed: 1', 12, 'write 1.0'),
    ('lift.yaml', 'speed: 0.25', 'speed: "0.25"', 'wrong type', 'speed: "', 12, 'leave the quotes out'),
    ('lift.yaml', 'steps: 40', 'steps: 40.0', 'wrong type', 'steps: 40.0', 12, 'write 40'),
    ('lift.yaml', 'steps: 40', 'steps: [40]', 'wrong type', 'steps: [', 12, 'type integer'),
    ('lift.yaml', 'steps: 40', 'steps: 1_000', 'wrong type', 'steps: 1_000', 12, 'rcl reads 1_000 as the string'),
    ('lift.yaml', 'steps: 40', 'steps: 99999999999999999999', 'wrong type', 'steps: 9', 12, 'is a double'),
    ('lift.yaml', 'gains: [1.0, 0.5]', 'gains: [1, 2]', 'wrong type', 'gains:', 12, 'write [1.0, 2.0]'),
    ('lift.yaml', 'gains: [1.0, 0.5]', 'gains: 1.0', 'wrong type', 'gains:', 12, 'write [1.0]'),
    ('lift.yaml', 'gains: [1.0, 0.5]', 'gains: []', 'wrong type', 'gains:', 12, 'an empty array has no type'),
    ('lift.yaml', 'name: lift', 'name: y', 'wrong type', 'name: y', 11, "write 'y'"),
    ('lift.yaml', 'name: lift', 'name: nan', 'wrong type', 'name: nan', 11, "write 'nan'"),
    ('lift.yaml', "'0123'", '0123', 'wrong type', 'code: 0123', 11, 'the integer 83'),
    ('lift.yaml', 'enabled: true', 'enabled: 1', 'wrong type', 'enabled: 1', 14, 'type boolean'),
    ('navigation.yaml', 'width: 3', 'width: 3.5', 'wrong type', 'width: 3.5', 14, 'type integer'),
    ('navigation.yaml', '["obstacles", "inflation"]', 'obstacles', 'wrong type', 'plugins: obst', 16,
     'write [obstacles]'),
    # ranges, steps and validators
    ('lift.yaml', 'speed: 0.25', 'speed: 1.25', 'out of range', 'speed: 1.25', 12, 'between 0.0 and 1.0'),
    ('lift.yaml', 'speed: 0.25', 'speed: .nan', 'out of range', 'speed: .nan', 12, 'between 0.0 and 1.0'),
    ('lift.yaml', 'steps: 40', 'steps: -10', 'out of range', 'steps: -10', 12, 'between 0 and 100'),
    ('lift.yaml', 'speed: 0.25', 'speed: 0.26', 'off the step', 'speed: 0.26', 12, '0.05 apart'),
    ('lift.yaml', 'steps: 40', 'steps: 45', 'off the step', 'steps: 45', 12, '10 apart'),
    ('lift.yaml', 'kind: fork', 'kind: hook', 'invalid', 'kind: hook', 18, "must be one of 'fork', 'clamp'"),
    ('controllers.yaml', 'interpolation: spline', 'interpolation: cubic', 'invalid', 'cubic', 20, "'spline', 'none'"),
    ('controllers.yaml', 'state_publish_rate: 50.0', 'state_publish_rate: 0.05', 'out of range', '0.05 #', 25,
     'at least 0.1'),
    ('controllers.yaml', 'goal: 0.03}', 'goal: 1.03}', 'out of range', '1.03', 42, 'between 0.0 and 1.0'),
    ('controllers.yaml', '[position]', '[torque]', 'invalid', 'torque', 25, "'position', 'velocity'"),
    ('controllers.yaml', '- elbow', '- elbow\n      - elbow', 'invalid', 'shoulder\n', 7, 'same element twice'),
    ('controllers.yaml', '[true, true, false]', '[true, true, true, true, true, true, true]', 'invalid', 'axes', 11,
     'longer than 6'),
    # twice, overridden, read otherwise
    ('lift.yaml', 'name: lift', 'name: lift\n    name: lift', 'duplicate', '    name: lift\n    steps', 5, 'line 10'),
    ('lift.yaml', 'steps: 40', 'steps: 40\n    tool.kind: fork', 'duplicate', 'kind: fork,', 12, 'line 12'),
    ('lift.yaml', '    tool:', '/hall_3/lift:\n  ros__parameters:\n    tool:', 'duplicate',
     '/hall_3/lift:\n  ros__parameters:\n    tool', 1, 'line 7 already'),
    ('lift.yaml', 'length: 1.2}', 'length: 1.2}\n/*/lift:\n  ros__parameters:\n    speed: 0.75\n', 'overridden',
     'speed: 0.25', 12, 'gets 0.75 for speed, from line 20'),
    ('lift.yaml', 'enabled: true', 'enabled: ~', 'wrong type', 'enabled: ~', 14, 'the string'),
    ('lift.yaml', 'name: lift', 'name: null', 'read otherwise', 'name: null', 11, 'as null'),
    ('lift.yaml', '"2024-01-01"', '2024-01-01', 'read otherwise', 'since:', 12, 'as a date'),
    ('lift.yaml', 'steps: 40', 'steps: 050', 'read otherwise', 'steps: 050', 12, 'the integer 40'),
    ('lift.yaml', ', length: 1.2}', '}\n    tool.length: 12:30', 'read otherwise', '12:30', 18, 'the integer 750'),
    # a value without which the node does not start
    ('controllers.yaml', '    command_interfaces: [position]\n', '', 'missing', 'arm_controller:\n  ros__', 1,
     'a value of command_interfaces: it has no default'),
    # what rcl rejects
    ('lift.yaml', 'gains: [1.0, 0.5]', 'gains: [[1.0], [0.5]]', 'unreadable', 'gains', 18, 'list of lists'),
]


@pytest.mark.parametrize(('name', 'old', 'new', 'kind', 'line', 'column', 'words'), SEEDED,
                         ids=[f'{each[0].partition(".")[0]}: {each[2].strip()}'[:60] for each in SEEDED])
def test_a_seeded_error_is_found_where_it_stands(write, name, old, new, kind, line, column, words):
    text = (FILES / name).read_text()
    assert text.count(old) >= 1
    text = text.replace(old, new, 1)
    path = write(text, name)
    findings = check_files(path, AGAINST[name])
    expected = [text.count('\n', 0, found.start()) + 1 for found in re.finditer(re.escape(line), text)]
    assert expected, 'the seed is not in the file'
    found = [each for each in findings if each.kind == kind and each.line in expected]
    assert found, findings
    assert words in found[0].message
    if kind != 'unreadable':
        assert found[0].column == column, findings
    # No finding is about a correct value, apart from the same one again for the values beside it.
    assert {each.kind for each in findings} <= {kind} or kind in ('never matched', 'unknown node'), findings


# What stands below the header of /hall_3/lift, the finding, its line and column, and words in its message.
LINES = [
    # what is not YAML
    ('    speed: 0.25\n\tname: lift\n', 'unreadable', 4, 1, 'Indent with spaces'),
    ('  \tspeed: 0.25\n', 'unreadable', 3, 3, 'Indent with spaces'),
    ('    name: lift\n    speed:0.25\n', 'unreadable', 4, 5, 'A name ends with a colon and a space'),
    ('    speed:0.25\n    name: lift\n', 'unreadable', 4, 9, 'It goes on with the line above'),
    ('    speed:0.25\n', 'unreadable', 3, 5, 'a space must follow the colon in speed:0.25'),
    ('    steps: 40\n      name: lift\n', 'unreadable', 4, 11, 'the names of one block begin in the same column'),
    ('    steps: 40\n   name: lift\n', 'unreadable', 4, 4, 'The names of one block begin in the same column'),
    ('    name: a: b\n', 'unreadable', 3, 12, "A text with ': ' in it needs quotes"),
    ('    name: @home\n', 'unreadable', 3, 11, 'A text that begins with @ needs quotes'),
    ('    name: *.txt\n', 'unreadable', 3, 12, 'A text that begins with * needs quotes'),
    ("    name: 'it's'\n", 'unreadable', 3, 15, 'a quote inside quotes is written twice'),
    ('    name: "lift\n    steps: 40\n', 'unreadable', 3, 11, 'The quote that begins here is not closed'),
    ('    name: "a\\q"\n', 'unreadable', 3, 13, 'A text with a backslash needs single quotes'),
    ('    gains: [1.0, 0.5\n    steps: 40\n', 'unreadable', 4, 10, 'in what begins in line 3'),
    (b'    name: gr\xfcn\n', 'unreadable', 3, 13, "the byte 0xfc would be 'ü' in Windows-1252"),
    (b'    unit: "\xc2\xb5\xe9"\n', 'unreadable', 3, 13, "'é' in Windows-1252"),
    (b'    name: \x81\n', 'unreadable', 3, 11, 'this is not UTF-8: the byte 0x81'),
    ('    name: a\x07\n', 'unreadable', 3, 12, 'control characters are not allowed'),
    # what is YAML, and not for rcl
    ('    speed: &s 0.25\n    tool.length: *s\n', 'unreadable', 4, 18, 'write the value itself instead of *s'),
    ('    tool: &t {kind: fork}\n    <<: *t\n', 'unreadable', 4, 9, 'ROS reads no aliases'),
    ('    gains: [1.0, 1]\n', 'unreadable', 3, 18, 'must all be of one type'),
    ('    gains:\n      - 1.0\n      - true\n', 'unreadable', 5, 9, 'must all be of one type'),
    ('    name: #lift\n', 'unreadable', 3, 10, 'name has no value'),
    # numbers and tags
    ('    speed: 0,25\n', 'wrong type', 3, 12, 'write 0.25'),
    ('    speed: 0x1\n', 'wrong type', 3, 12, 'write 1.0'),
    ('    speed: !!float 1\n', 'wrong type', 3, 12, 'write 1.0'),
    ('    speed: !!str 0.25\n', 'wrong type', 3, 12, 'is a string'),
    ('    steps: .inf\n', 'wrong type', 3, 12, 'is a double'),
    ('    steps: 1e1\n', 'wrong type', 3, 12, 'write 10'),
    (f'    steps: {"9" * 5000}\n', 'wrong type', 3, 12, 'type integer'),
    ('    steps: !!float 40\n', 'read otherwise', 3, 12, 'rcl ignores !!float'),
    # a block once more, by another name
    ('    speed: 0.25\nhall_3/lift:\n  ros__parameters:\n    steps: 40\n', 'duplicate', 4, 1, 'are one node'),
    ('    speed: 0.25\nhall_3:\n  lift:\n    ros__parameters:\n      steps: 40\n', 'duplicate', 5, 3,
     'a block for /hall_3/lift in line 1 already'),
]


@pytest.mark.parametrize('begins', [b'', codecs.BOM_UTF8], ids=['', 'BOM'])
@pytest.mark.parametrize('ends', [b'\n', b'\r\n'], ids=['LF', 'CRLF'])
@pytest.mark.parametrize(('lines', 'kind', 'line', 'column', 'words'), LINES,
                         ids=[ascii(each[0])[:40] for each in LINES])
def test_a_mistake_is_found_whatever_the_editor(write, lines, kind, line, column, words, begins, ends):
    content = b'/hall_3/lift:\n  ros__parameters:\n' + (lines if isinstance(lines, bytes) else lines.encode())
    finding, = check_files(write(begins + content.replace(b'\n', ends)), LIFT)
    assert (finding.kind, finding.line, finding.column) == (kind, line, column), finding
    assert words in finding.message
    assert finding.message.isprintable()


@pytest.mark.parametrize(('value', 'is_found'), [
    ('1e-9', False), ('1E5', False), ('1.5e3', False), ('0x10', False), ('5.', False), ('.5', False), ('.inf', False),
    ('None', False), ('640x480', False), ('00:1b:44', False), ('1.2.3', False), ('"1e5"', False), ('y', True),
    ('off', True), ('0123', True), ('12:30', True), ('2024-01-01', True), ('nan', True), ('inf', True), ('~', True),
    ('1_000', True), ('0o17', True), ('99999999999999999999', True), ('!!float 5', True), ('!!int 5', False),
    ('!!str 5', False), ('!mine 5', True)])
def test_without_a_description_only_a_value_that_can_mislead_is_found(write, value, is_found):
    found = check_files(write(f'/n:\n  ros__parameters:\n    a: {value}\n'))
    assert [(each.kind, each.line) for each in found] == [('read otherwise', 3)] * is_found


def test_every_kind_of_finding_is_seeded():
    assert {each[3] for each in SEEDED} == set(KINDS) - {'read only'}


def test_read_only_matters_only_where_the_node_runs(write):
    path = write("/hall_3/lift:\n  ros__parameters:\n    password: 'x'\n    speed: 1e-1\n")
    assert check_files(path, LIFT) == ()
    read_only, otherwise = check_files(path, LIFT, loading=True)
    assert (read_only.kind, read_only.line, read_only.column) == ('read only', 3, 15)
    assert (otherwise.kind, otherwise.line) == ('read otherwise', 4)
    assert "YAML 1.1 as the text '1e-1'" in otherwise.message


def test_all_errors_of_a_file_are_found_at_once(write):
    path = write('/hall_3/lift:\n  ros__parameters:\n    speed: 1\n    gains: [1, x]\n    length: a\n    name:\n'
                 '/hall_3/lft:\n  ros_parameters:\n    steps: 1\n')
    assert [(each.line, each.kind) for each in check_files(path, LIFT)] == [
        (3, 'wrong type'), (4, 'unreadable'), (5, 'unknown parameter'), (6, 'unreadable'),
        (8, 'no header')]


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


BESIDE_THE_LIFT = '/hall_3/lift: {{ros__parameters: {{steps: 10}}}}\n{}: {{ros__parameters: {{name: a}}}}\n'


@pytest.mark.parametrize('block', ['/hall_3/lifft', '/hall_3/list'])
def test_a_typo_is_found_beside_the_right_name(write, block):
    finding, = check_files(write(BESIDE_THE_LIFT.format(block)), Descriptions(LIFT.values()))
    assert (finding.kind, finding.line) == ('unknown node', 2)
    assert finding.message == f'there is no node {block}, so rcl ignores this block. Did you mean /hall_3/lift?'


@pytest.mark.parametrize('block', ['/hall_3/lift_2', '/hall_4/lift', '/hall_3/left_lift', '/hall_3/crane'])
def test_another_node_is_no_typo(write, block):
    assert check_files(write(BESIDE_THE_LIFT.format(block)), Descriptions(LIFT.values())) == ()


# -- formats --------------------------------------------------------------------------------------------------


def test_findings_as_text_json_and_annotations(write):
    path = write('/hall_3/lift:\n  ros__parameters:\n    name: "100 %"\n    steps: 10\n    steps: 10\n', 'a,b.yaml')
    findings = check_files(path, LIFT)
    assert [(each.line, each.severity) for each in findings] == [(5, 'warning')]
    assert re.match(rf'{re.escape(str(path))}:\d+:\d+: [a-z ]+: ', findings.text())
    first = json.loads(findings.as_json())[0]
    assert first.keys() == {'file', 'line', 'column', 'kind', 'message', 'node', 'parameter', 'severity'}
    assert first['node'] == '/hall_3/lift'
    annotation = findings.as_github().splitlines()[0]
    assert re.fullmatch(r'::(error|warning) file=[^,:]*a%2Cb\.yaml,line=\d+,col=\d+,title=[a-z ]+::.+', annotation)
    assert '<table' in findings._repr_html_()


@pytest.mark.parametrize('content', ['', '# nothing\n', 'a', '[]', b'\xff\xfe\x00', '\x00', '{' * 3000])
def test_what_is_no_parameter_file_is_a_finding(write, content):
    assert len(check_files(write(content), LIFT)) == 1


@pytest.mark.parametrize('against', [None, LIFT])
def test_a_name_that_is_no_pattern_is_a_finding_and_matches_nothing(write, against):
    block = '{}:\n  ros__parameters:\n    speed: 0.5\n'
    found = check_files(write(block.format('/hall_3/li[ft') + block.format('/hall_3.lift')), against)
    assert [(each.line, each.kind) for each in found] == [(2, 'unreadable'), (5, 'unreadable')]


# -- whatever comes -------------------------------------------------------------------------------------------


@pytest.mark.slow
@settings(max_examples=300)
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
    for text in (findings.text(), findings.as_json(), findings.as_github()):
        assert isinstance(text, str)
