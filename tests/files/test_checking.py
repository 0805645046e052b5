"""Checking parameter files: every seeded error is found where it stands, and correct files are left alone."""

import codecs
import cProfile
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
    assert findings.substitutions == tuple(f'{FOR_LAUNCH}:{line}' for line in (1, 3, 4, 7, 8, 9))
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


# What stands below the header of /lift, where something is found, and words of it.
OTHERWISE = [
    # lists of maps and of lists
    ('a: [{x: 1}, {x: 2}]', [(3, 8)], 'no lists of maps, and rcl makes a.x.x = [1, 2] of this: give each map a name'),
    ('a:\n    - x: b\n      z: c', [(4, 5)], "rcl makes a.x = ['b', 'z', 'c'] of this: give each map a name"),
    ('a: [{b: {c: true}}]', [(3, 8)], 'rcl makes a.b.c = [True] of this'),
    ('a: [1.0, [2.0]]', [(3, 8)], 'no lists of lists, and rcl makes a = [2.0] of this: write one list'),
    # a header below a header
    ('inner:\n      ros__parameters: {a: 1, b: 2}', [(4, 25)],
     'so /lift gets a parameter inner.ros__parameters.a: begin the block of a node in the first column'),
    ('ros__parameters: {a: 1}', [(3, 23)], 'gets a parameter ros__parameters.a: write it once'),
    ('b: 1\n    /door:\n      ros__parameters:\n        a: 1', [(6, 9)], 'a parameter /door.ros__parameters.a'),
    # signs that look like others
    ('a: \u22121.5', [(3, 8)], "a: a MINUS SIGN (U+2212) is in it, as on web pages, so rcl reads the text "
     "'\\u22121.5': write -1.5"),
    ('a: [\u20131.5, \u20132.5]', [(3, 9), (3, 15)], 'an EN DASH (U+2013) is in it'),
    ('a: 2.0\xa0', [(3, 8)], "a NO-BREAK SPACE (U+00A0) is in it, as on web pages, so rcl reads the text '2.0\\xa0': "
     'write 2.0'),
    ('a\u200b: 2.0', [(3, 5)], 'a ZERO WIDTH SPACE (U+200B) is in it, as on web pages, so rcl reads the name'),
    ('a: \u201cbase\u201d', [(3, 8)], 'write "base"'),
    ('a: "\u201cbase\u201d \u22121"', [], ''), ('a: 5\xa0\n    b: x \u2212 y', [(3, 8)], ''),
    # numbers with something behind them
    ('a: 30 Hz', [(3, 8)], "rcl reads '30 Hz' as a text, not as a number: write 30  # Hz"),
    ('a: 5#five', [(3, 8)], 'write 5  # five'), ('a: 5 // b', [(3, 8)], 'write 5  # b'),
    ('a: 1.5f', [(3, 8)], 'write 1.5'), ('a: -1e3,', [(3, 8)], 'write -1e3'),
    ('a: [0.5 m/s, 2 m/s]', [(3, 9), (3, 18)], 'write'),
    ('a: "30 Hz"\n    b: 5 wheels\n    c: 3f2a\n    d: 1.2.3\n    e: 3d', [], ''),
    # what nobody fills in
    ('a: ${HOME}/x', [(3, 8)], 'a: neither rcl nor launch fills in ${HOME}, so /lift gets this text: write the value'),
    ('a: "$HOME/x"', [(3, 8)], 'fills in $HOME'), ('a: "{{ gain }}"', [(3, 8)], 'fills in {{ gain }}'),
    ('a: $(find demo)/map', [(3, 8)], 'launch of ROS 2 knows no $(find demo), so /lift gets this text'),
    ('a: $(arg map)', [(3, 8)], 'or $(find-pkg-share …) or $(var …)'),
    ('a: $(var map)\n    b: "5$"\n    c: "^a{2}$"\n    d: a$b', [], ''),
    # an empty list
    ('a: []', [(3, 8)], 'rcl gives the empty list a no type, so a node of rclpy has no value for it'),
    ('a: {b: [\n    ]}', [(3, 12)], 'the empty list a.b'), ('a: [""]', [], ''),
]


@pytest.mark.parametrize(('text', 'places', 'words'), OTHERWISE)
def test_what_rcl_reads_otherwise_than_it_looks_is_found(write, text, places, words):
    path = write(f'/lift:\n  ros__parameters:\n    {text}\n')
    found = check_files(path)
    assert first_rejection([path]) is None
    assert [(each.line, each.column) for each in found] == places
    assert all(each.kind in ('likely mistake', 'not filled in') and words in each.message for each in found)


def test_what_a_described_node_takes_is_no_likely_mistake(write):
    against = Descriptions([NodeDescription('/n', {'x': DescribedParameter(Descriptor('x', values.STRING))})])
    assert check_files(write('/n:\n  ros__parameters:\n    x: 30 Hz\n'), against) == ()


@pytest.mark.parametrize('header', ['ros__parameters_off', 'ros__parameters2', '"ros__parameters "'])
def test_a_header_with_more_behind_it_is_still_one(write, header):
    path = write(f'/lift:\n  {header}:\n    a: 1\n')
    assert list(read_blocks(path)) == ['/lift']
    finding, = check_files(path)
    assert (finding.line, finding.column, finding.kind) == (2, 3, 'likely mistake')
    assert 'rcl, which compares no more than the beginning: write ros__parameters' in finding.message


@pytest.mark.parametrize('below', ['[]', '[{a: {b: 1}}]', '\n  - a: {b: 1}'])
def test_a_list_below_the_header_is_found_where_rcl_reads_it(write, below):
    path = write(f'/n: {{ros__parameters: {{a: 1}}}}\n/m:\n  ros__parameters: {below}\n')
    assert first_rejection([path]) is None
    assert 'remove the dashes' in check_files(path)[0].message


# A whole file that rcl rejects, where its cause stands, and words that say what to write.
REJECTED = [
    ('/n:\n  ros__parameters:\n\xa0 \xa0 a: 1\n', 3, 1, 'indents nothing in YAML: indent this line with plain spaces'),
    ('/n:\n\u3000ros__parameters:\n    a: 1\n', 2, 1, 'an IDEOGRAPHIC SPACE (U+3000)'),
    ('/n:\n  ros__parameters:\n    a: 1\n\u2003 \u2003b: 2\n', 4, 1, 'an EM SPACE (U+2003)'),
    ('/n:\n  ros__parameters:\n    a\uff1a 1\n', 3, 6, 'no colon: write a plain one and a space'),
    ('/n:\n  ros__parameters:\n    a = 1\n    b = 5\n', 3, 5, 'so write a: 1'),
    ('/n:\n  ros__parameters:\n    a.b=x y\n', 3, 5, 'so write a.b: x y'),
    ('/n: {ros__parameters: {a: 1}}\n/m:\n  a = 1\n', 3, 3, 'so write a: 1'),
    ('/n:\n  ros__parameters:\n    - a: 1\n    - b: 5\n', 3, 5, 'where names have to stand: remove the dashes'),
    ('/n:\n  ros__parameters:\n  - a: 1\n    b: 5\n', 3, 3, 'remove the dashes'),
    ('/n:\n  ros__parameters: !include n.yaml\n', 2, 20, 'write here what it stands for, or give that'),
    ('/n:\n  ros__parameters:\n    a: !secret\n    b: 1\n', 3, 8, 'fills in no !secret: write here what it stands for'),
    ('/m: {ros__parameters: {a: 1}}\n/n: !env\n', 2, 5, 'fills in no !env'),
    ('/n:\n  ros__parameters:\n    a: {{ a }}\n', 3, 8, '{{ a }} is a template that nobody has filled in'),
    ('{% if x %}\n/n:\n  ros__parameters: {a: 1}\n', 1, 1, '{% if x %} is a template'),
    ('/n:\n  ros__parameters:\n    a: {{a}}/b\n', 3, 8, '{{a}} is a template'),
    ('/n:\n  ros__parameters:\n    a: &amp;\n', 3, 8, '&amp; is how a web page writes &'),
    ('/n:\n  ros__parameters:\n    a: &lt; 5 &gt;\n', 3, 8, '&lt; is how a web page writes <'),
    ('/n:\n  ros__parameters:\n    a: &quot;b&quot;\n', 3, 8, '&quot; is how a web page writes "'),
    ('# of OpenCV\n%YAML:1.0\n---\n/n:\n  ros__parameters: {a: 1}\n', 2, 1, 'needs no line %YAML:1.0'),
    ('%YAML 1.2\n---\n/n:\n  ros__parameters: {a: 1}\n', 1, 1, 'needs no line %YAML 1.2, and rcl may read none'),
    ('%FOO\n/n:\n  ros__parameters: {a: 1}\n', 1, 1, 'needs no line %FOO'),
    # lists of several types
    ('/n:\n  ros__parameters:\n    a: [x, y]\n', 3, 12, "'y' is a boolean, and 'x' is a string: put each of them into "
     "quotes if they are texts, as in 'y'"),
    ('/n:\n  ros__parameters:\n    a: [0, 0.5]\n', 3, 12, "'0.5' is a double, and '0' is an integer: write each of "
     'them with a dot, as in 0.0'),
    ('/n:\n  ros__parameters:\n    a: [01, 08]\n', 3, 13, 'leave out the zeros before them'),
    ('/n:\n  ros__parameters:\n    a: [{b: x, c: 1.5, d: 2}]\n', 3, 19, 'no lists of maps, so give each map a name'),
    ('/n:\n  ros__parameters:\n    a:\n    - b: 1\n      c: x\n    - b: 2\n      c: y\n', 5, 7, 'no lists of maps'),
    ('dh_parameters: {a: 1}\narm:\n  solver: {b: x}\n  ros: 5\n', 1, 1, 'the file has no ros__parameters'),
]


@pytest.mark.parametrize(('content', 'line', 'column', 'words'), REJECTED)
def test_the_cause_of_a_rejection_is_said_once_and_with_a_remedy(write, content, line, column, words):
    path = write(content)
    assert first_rejection([path]) is not None
    finding, = check_files(path)
    assert (finding.line, finding.column) == (line, column), finding
    assert words in finding.message


@pytest.mark.parametrize(('content', 'is_passed_over'), [
    ('arm:\n  solver: demo/Solver\ngripper: {solver: a}\n', True), ('arm: {dh_parameters: {a: 1}}\n', True),
    ('a: [1\n', True), ('- {robot_parameters: 1}\n# ros__parameters: none\n', True),
    ('/n:\n  ros_parameters: {a: 1}\n', False), ('/n:\n  ros__parametres: {a: 1}\n', False),
    ('/n:\n\tros__parameters: {a: 1}\n', False), ('/n: {ros__parameters: {}}\narm: {solver: a}\n', False)])
def test_what_a_folder_has_beside_parameter_files_is_passed_over(write, content, is_passed_over):
    path = write(content)
    findings = check_files(path, are_meant=False)
    assert findings.no_parameter_files == (str(path),) * is_passed_over
    assert bool(findings) is not is_passed_over
    assert len(check_files(path)) >= 1


def test_a_list_of_many_maps_is_found_in_a_short_sentence(write):
    path = write('/n:\n  ros__parameters:\n    a:\n' + ''.join(f'    - key_{number}: x\n' for number in range(3000)))
    finding, = check_files(path)
    assert 'rcl makes a.key_0.key_1.' in finding.message
    assert len(finding.message) < 300


def test_the_work_is_in_proportion_to_the_length_of_a_file(write):
    block = '/robot{0}/node:\n  ros__parameters:\n    rate: {0}\n    again: 1\n    again: 2\n'
    calls = []
    for count in (500, 2000):
        path = write('/**:\n  ros__parameters: {rate: 1.5}\n' + ''.join(map(block.format, range(count))))
        with cProfile.Profile() as profile:
            assert len(check_files(path)) == count
        calls.append(sum(each.callcount for each in profile.getstats()))
    assert calls[1] < 5 * calls[0]
