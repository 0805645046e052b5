"""shell: a bash that remembers, shows what does not change from day to day, and leaves nothing behind."""

import shlex
import sys
from contextlib import closing
from pathlib import Path

import pytest
from IPython.core.error import UsageError

from param_tools.errors import ParameterToolError
from param_tutorial import Shell
from param_tutorial.learner.package_files import NAME, ours
from tests.support.commands import run


@pytest.fixture
def shell():
    shell = Shell()
    yield shell
    shell.close()


def test_it_remembers_folder_and_environment(shell):
    assert shell.run('mkdir -p ws/src; cd ws; export COLOR=red') == ''
    assert shell.run('pwd; echo $COLOR') == '~/ws\nred'
    assert shell.folder() == shell.home / 'ws'
    assert shell.environment()['COLOR'] == 'red'


def test_status_order_and_mistakes(shell):
    assert shell.run('echo out; echo err >&2; false') == 'out\nerr'
    assert shell.status == 1
    assert shell.run('no_such_command') == 'bash: no_such_command: command not found'
    assert 'unexpected EOF' in shell.run('echo "never closed')
    assert shell.run('cat; echo and on') == 'and on'
    assert shell.status == 0


def test_a_command_that_ends_the_shell_or_takes_too_long(shell):
    second = Shell(beside=shell)
    with pytest.raises(ParameterToolError, match="'echo last; exit' ended the shell; what came:\nlast"):
        second.run('echo last; exit')
    with pytest.raises(ParameterToolError, match='closed'):
        second.run('ls')
    with pytest.raises(ParameterToolError, match=r"'sleep 60' was not done within 0.1 s; what came:\n\(nothing\)"):
        shell.run('sleep 60', timeout_sec=0.1)
    assert not shell.home.exists()


def test_the_magic_types_a_cell_into_the_shell_it_names(shell, ipython, capsys):
    ipython.user_ns['first'] = shell
    ipython.run_cell('%%shell first\necho {braces} $((1 + 1))\nfalse\n')
    assert capsys.readouterr().out == '{braces} 2\n'
    assert ipython.user_ns['_exit_code'] == 1
    error = ipython.run_cell('%%shell nobody\necho lost').error_in_exec
    assert isinstance(error, UsageError) and 'nobody is none' in str(error)


def test_a_home_folder_that_is_given_stays(tmp_path):
    with closing(Shell(home=tmp_path)) as shell:
        assert shell.run('echo kept > file; pwd') == '~'
    assert (tmp_path / 'file').read_text() == 'kept\n'


# -- ros2 pkg create: what it writes is recorded in tests/cli/transcripts ---------------------------------------------


def create(*words):
    """Run ros2 pkg create in this process: standard output, standard error, exit status."""
    return run('pkg', 'create', *words, in_notebook=False, get_executor=pytest.fail)


@pytest.fixture
def here(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_what_is_told_stands_in_the_files_whatever_it_is(here):
    from catkin_pkg.package import parse_package

    name, email = """O'Brien & "Söhne" <x>""", 'a@b.example'
    _, err, status = create(
        'arm', '--build-type', 'ament_python', '--license', 'MIT', '--description', "it's an arm", '--maintainer-name',
        name, '--maintainer-email', email, '--dependencies', 'rclpy', 'std_msgs')
    assert (err, status) == ('', 0)
    package = parse_package(str(here / 'arm' / 'package.xml'))
    assert (package.name, package.description, package.licenses) == ('arm', "it's an arm", ['MIT'])
    assert (package.maintainers[0].name, package.maintainers[0].email) == (name, email)
    assert [each.name for each in package.exec_depends] == ['rclpy', 'std_msgs']
    compile((here / 'arm' / 'setup.py').read_text(), 'setup.py', 'exec')


@pytest.mark.parametrize(('words', 'why'), [
    (['x'], 'packages of --build-type ament_python only, not ament_cmake'),
    (['test', '--build-type', 'ament_python'], "can't be named 'test'"),
    (['../x', '--build-type', 'ament_python'], "'../x' cannot be the name of a Python package"),
    (['class', '--build-type', 'ament_python'], "'class' cannot be"),
    (['x', '--build-type', 'ament_python', '--node-name', 'a b'], "'a b' cannot be the name of a Python executable"),
])
def test_what_cannot_be_a_package_is_rejected(here, words, why):
    out, err, status = create(*words)
    assert (out, status) == ('', 1)
    assert why in err
    assert list(here.iterdir()) == []


def test_it_writes_the_first_step_of_the_readers_package(here):
    create(NAME, '--build-type', 'ament_python', '--node-name', 'driver_node', '--maintainer-name', 'learner',
           '--maintainer-email', 'learner@todo.todo')
    assert ours('2') == {path.relative_to(NAME).as_posix(): path.read_text()
                         for path in Path(NAME).rglob('*') if path.is_file() and path.parent.name != 'test'}


def test_a_folder_that_is_there_is_left_alone(here):
    create('x', '--build-type', 'ament_python')
    (here / 'x' / 'setup.py').write_text('mine')
    _, err, status = create('x', '--build-type', 'ament_python')
    assert status == 1
    assert err.startswith('\nAborted!\nThe directory already exists: ./x\n')
    assert (here / 'x' / 'setup.py').read_text() == 'mine'


@pytest.mark.parametrize('home', ['', 'a home'])
def test_what_is_built_runs_where_python_lies_below_a_space(tmp_path, monkeypatch, home):
    folder = tmp_path / 'a folder'
    folder.symlink_to(sys.prefix)
    (tmp_path / 'a home').mkdir()
    monkeypatch.setattr(sys, 'executable', str(folder / 'bin' / 'python'))
    first, second = (shell := Shell(home=tmp_path / home if home else None)), Shell(beside=shell)
    first.run('mkdir -p ws/src; cd ws/src; ros2 pkg create hello --build-type ament_python --node-name greeter; cd ..')
    assert 'Finished <<< hello' in first.run('colcon build')
    # Linux starts no program whose first line has a space in the name of what is to run it.
    assert first.run('head -1 install/hello/lib/hello/greeter').endswith('/.python/bin/python')
    assert second.run('cd ws; source install/setup.bash; ros2 run hello greeter') == 'Hi from hello.'
    assert 'Finished <<< hello' in second.run('colcon build')


def test_a_workspace_with_a_package_of_our_name_does_not_hide_the_embedded_ros2(shell):
    shell.run('mkdir param_tutorial; touch param_tutorial/__init__.py; export PYTHONPATH=$PWD')
    # As the programs that it starts see it, and as it sees itself.
    find = shlex.join([sys.executable, '-c', 'import param_tutorial; print(param_tutorial.__file__)'])
    assert shell.run(find) == '~/param_tutorial/__init__.py'
    assert shell.run('ros2 run param_tutorial simple_param_node') == "Package 'param_tutorial' not found"
