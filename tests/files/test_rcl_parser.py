"""rcl's own parser beside ours: both accept and reject the same files, and `check` passes on what only rcl rejects."""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

import hypothesis.strategies as st
import yaml
from hypothesis import example, given, settings

from param_tools.files import parsing, rcl_parser
from param_tools.files.checking import check_files
from param_tools.files.parsing import Parser, Rejected
from tests.files.test_parameter_files import DOCUMENTS
from tests.support.paths import CONFIG

SOURCES = [path.read_bytes() for folder in (CONFIG, Path(__file__).parent / 'parameter_files')
           for path in sorted(folder.rglob('*.yaml'))]
PIECES = st.sampled_from([
    b'', b' ', b'  ', b'    ', b'\t', b'\n', b'\r\n', b'\n---\n', b'\n...\n', b'{', b'}', b'[', b']', b'{}', b'[]',
    b',', b':', b': ', b'- ', b'? ', b'#', b"'", b'"', b'|\n', b'>', b'*x', b'&x ', b'!!str ', b'<<: ', b'~', b'@',
    b'/', b'/**', b'.', b'a.b: ', b'1', b'1.5', b'1e400', b'true', b'ros__parameters:', b'\0', b'\xff', b'\xc3\xa9'])


@st.composite
def mutations(draw):
    """Return a real parameter file in which a few things were inserted, replaced, repeated, moved or taken out."""
    content = draw(st.sampled_from(SOURCES))
    for _ in range(draw(st.integers(1, 4))):
        if draw(st.booleans()):
            begin = draw(st.integers(0, len(content)))
            end = begin + draw(st.sampled_from([0, 1, 4, 30]))
            new = draw(st.one_of(PIECES, st.just(content[begin:end] * 2)))
            content = content[:begin] + new + content[end:]
        else:
            lines = content.split(b'\n')
            line = lines.pop(draw(st.integers(0, len(lines) - 1)))
            lines.insert(draw(st.integers(0, len(lines))), draw(st.sampled_from([line, b' ' * 4 + line.lstrip()])))
            content = b'\n'.join(lines)
    return content


def rejections(*contents):
    """Return whether our parser rejects some files that a node gets together, and why rcl does."""
    parser = Parser()
    with tempfile.TemporaryDirectory() as folder:
        paths = []
        for number, content in enumerate(contents):
            paths.append(Path(folder, f'{number}.yaml'))
            paths[-1].write_bytes(content)
        try:
            for content in contents:
                parser.parse(content)
            ours = False
        except Rejected:
            ours = True
        theirs = rcl_parser.first_rejection(paths)
    return ours, theirs[1] if theirs else ''


def is_of_newer_yaml(content):
    """True if a text without quotes holds a colon or question mark: inside brackets, old versions of libyaml, as in the
    ROS wheels, read it otherwise than PyYAML's."""
    return any(isinstance(event, yaml.ScalarEvent) and event.style not in ("'", '"') and set(event.value) & {':', '?'}
               for event in yaml.parse(content, Loader=yaml.CSafeLoader))


# In CI thousands of files, elsewhere as many as a minute's suite has time for.
# Not for a file on which rcl's parser may end the process: none here has a block of more than 128 parameters.
@settings(max_examples=3000 if os.environ.get('CI') else 600)
@given(st.one_of(mutations().map(lambda content: (content,)),
                 st.tuples(DOCUMENTS.map(str.encode), DOCUMENTS.map(str.encode))))
@example((b'/b: {ros__parameters: {x: 1}}\n/a: {ros__parameters: {x: 1, y: 2}}\n/b: {ros__parameters: []}',))
@example((b'/b: {ros__parameters: {x: 1}}', b'/b: {ros__parameters: [2]}'))
def test_both_parsers_accept_and_reject_the_same_files(contents):
    ours, theirs = rejections(*contents)
    if ours or not any(map(is_of_newer_yaml, contents)):
        assert ours == bool(theirs), theirs


PARTS = st.one_of(st.sampled_from(['', '*', '**', '***', 'a', 'arm_1', '1a', '_', '~', 'a b', 'ä']),
                  st.sampled_from([243, 244, 245, 246, 254, 255, 256]).map('x'.__mul__))


@given(st.lists(PARTS, min_size=1, max_size=4), st.sampled_from(['', '/', '//']))
@example(['left', '', 'arm'], '')
@example(['x' * 255], '')
@example(['x' * 256], '/')
@example(['x' * 244, 'x' * 244, 'a'], '')
@example(['x' * 245, 'a'], '')
def test_a_block_may_have_just_the_names_that_rcl_takes(parts, begins):
    name = begins + '/'.join(parts)
    ours, theirs = rejections(f'"{name}":\n  ros__parameters:\n    a: 1\n'.encode())
    assert ours == bool(theirs), theirs


def test_what_only_rcl_rejects_is_a_finding(tmp_path, monkeypatch):
    first, second = tmp_path / 'first.yaml', tmp_path / 'second.yaml'
    first.write_text('/n:\n  ros__parameters:\n    a: 1\n')
    second.write_text('/my node:\n  ros__parameters:\n    a: 1\n')
    monkeypatch.setattr(parsing, 'flaw_of_block_name', lambda name: '')
    finding, = check_files([first, second])
    assert (finding.file, finding.line, finding.kind) == (str(second), 1, 'unreadable')
    assert finding.message.startswith('rcl rejects the file: node name must not contain characters other than')
    assert 'parse.c' not in finding.message


def test_a_file_that_would_end_the_process_in_rcl_is_rejected_before(write):
    path = write('/b:\n  ros__parameters:\n    x: 1\n/a:\n  ros__parameters:\n'
                 + ''.join(f'    p{number}: 1\n' for number in range(200)) + '/b:\n  ros__parameters: 5\n',
                 'twice.yaml')
    done = subprocess.run([sys.executable, '-m', 'param_tools', 'check', path], capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (1, '')
    assert f'{path}:207:20: unreadable: rcl rejects the file here: there is a value without a name' in done.stdout


def test_a_pipe_is_read_once(tmp_path):
    done = subprocess.run([sys.executable, '-m', 'param_tools', 'check', '/dev/stdin'], capture_output=True, text=True,
                          input='/n:\n  ros__parameters:\n    a: 1\n')
    assert (done.returncode, done.stdout, done.stderr) == (0, '', '')
