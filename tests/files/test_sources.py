"""What the text of a package declares, beside what its parameter files hold."""

import pytest

from param_tools.errors import ParameterFileError
from param_tools.files.sources import compare_source, read_source
from tests.support.commands import run

PYTHON = '''
super().__init__('driver')
self.declare_parameter('speed', 1.0)  # self.declare_parameter('old')
self.declare_parameter(f'{side}.gain', value=("a", 'b'))
self.declare_parameters('wheels', [('left', 1), ('right', 2)])
'''
CPP = '''
// declare_parameter("older");
this->declare_parameter<std::map<std::string, int>>("rate", 5);
nav::declare_parameter_if_not_declared(node, plugin_name_ + ".tolerance", rclcpp::ParameterValue(0.5));
node->declare_parameter(
  std::string("frame"), "map");
'''


@pytest.fixture
def package(tmp_path):
    """Return a function that writes the files of a package, by name, and returns its folder."""
    def write(files):
        for name, text in files.items():
            (tmp_path / name).parent.mkdir(exist_ok=True)
            (tmp_path / name).write_text(text)
        return tmp_path

    return write


def test_the_names_of_calls_in_python_and_cpp(package):
    folder = package({'a.py': PYTHON, 'src/b.cpp': CPP, 'test/c.py': "x.declare_parameter('t')"})
    declared = read_source(folder).declared
    assert {name: (path.name, line) for name, (path, line) in declared.items()} == {
        'speed': ('a.py', 3), '*.gain': ('a.py', 4), 'wheels.left': ('a.py', 5), 'wheels.right': ('a.py', 5),
        'rate': ('b.cpp', 3), '*.tolerance': ('b.cpp', 4), 'frame': ('b.cpp', 5)}


def test_files_and_source_are_compared_in_both_directions(package):
    values = 'driver:\n  ros__parameters: {sped: 1.0, rate: 5, left.gain: 1, FollowPath: {tolerance: 1.0}}\n'
    folder = package({'a.py': PYTHON, 'b.cpp': CPP, 'config/c.yaml': values + '/other: {ros__parameters: {x: 1}}\n'})
    stdout, stderr, status = run('check', '--source', folder)
    lines = stdout.splitlines()
    assert lines[0] == (f'{folder}/config/c.yaml:2:21: not declared: no declare_parameter in the text of {folder} '
                        f'names sped, so probably no node reads it: remove the line, or write speed')
    assert [line.partition(' is declared here')[0] for line in lines[1:]] == [
        f'{folder}/{place}:1: in no file: {name}' for place, name in (
            ('a.py:3', 'speed'), ('a.py:5', 'wheels.left'), ('a.py:5', 'wheels.right'), ('b.cpp:5', 'frame'))]
    assert stderr == f'Not compared, because {folder} declares few of their parameters or none: /other\n'
    assert status == 1
    package({'config/c.yaml': values.replace('sped', 'speed')})
    stdout, _, status = run('check', '--source', folder, '--format', 'github')
    assert stdout.count('::notice ') == 3
    assert status == 0


@pytest.mark.parametrize('more', ['self.declare_parameter(name, 1)', 'Node(allow_undeclared_parameters=True)'])
def test_what_the_text_does_not_tell_is_said_and_no_finding(package, more):
    values = 'driver:\n  ros__parameters: {sped: 1.0, rate: 5}\n'
    found, notes = compare_source(package({'a.py': f'{PYTHON}{more}\n', 'b.cpp': CPP, 'c.yaml': values}))
    assert {each.kind for each in found} == {'in no file'}
    assert notes[0].endswith('so these may be declared, though no declare_parameter names them: sped')
    assert 'a.py' in notes[0]


def test_a_function_that_declares_for_its_callers_hides_nothing(package):
    helper = 'template<typename T> void declare_parameter(const std::string & name, T value);\n'
    values = '/**: {ros__parameters: {rate: 1, rat: 1}}'
    found, notes = compare_source(package({'b.cpp': helper + CPP, 'c.yaml': values}))
    assert ([each.parameter for each in found if each.kind == 'not declared'], notes) == (['rat'], [])


def test_a_file_that_rcl_rejects_is_compared_as_far_as_it_can_be_read(package):
    values = '/**: {ros__parameters: {rate: 1, rat: 1, frame: [1, a]}}'
    folder = package({'b.cpp': CPP, 'c.yaml': values, 'd.yaml': 'a: 1'})
    found, notes = compare_source(folder)
    assert [each.parameter for each in found if each.kind == 'not declared'] == ['rat']
    assert notes == [f'{folder}/c.yaml: compared as far as it can be read, because rcl rejects it; `check '
                     f'{folder}/c.yaml` says why']


def test_without_a_folder_nothing_is_compared(tmp_path):
    with pytest.raises(ParameterFileError, match='is not a folder'):
        compare_source(tmp_path / 'nowhere')
