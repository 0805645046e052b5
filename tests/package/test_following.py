"""The reader's package on the stage: what is saved runs, what can't run leaves the robot as it was, nothing is lost."""

from contextlib import closing

import pytest

import param_tutorial
from param_tools.errors import ParameterToolError
from param_tools.ros import stage
from param_tools.ros.environment import package_in_work
from param_tutorial import Package, Terminal
from param_tutorial.learner import package_files
from param_tutorial.learner.package_files import ours
from param_tutorial.learner.progress import FILE, VARIABLE
from param_tutorial.package import loading

DRIVER = ours('3d')['my_robot/driver_node.py']
SLOW = DRIVER.replace('0.5', '0.25')
LAUNCH = '''
from launch import LaunchDescription
from launch.substitutions import PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    slow = PathJoinSubstitution([FindPackageShare('my_robot'), 'config', 'slow.yaml'])
    return LaunchDescription([Node(package='my_robot', executable='driver_node', name='driver', parameters=[slow])])
'''


@pytest.fixture
def package(ros, monkeypatch, tmp_path):
    monkeypatch.setenv(VARIABLE, str(tmp_path / FILE))
    monkeypatch.setattr(package_files, 'passed', set())
    monkeypatch.setattr('param_tutorial.package.following.passed', package_files.passed)
    package = Package('4')
    yield package
    package.close()


def speed(package):
    return package.node().get_parameter('max_speed_mps').value


def test_a_saved_file_runs_with_its_defaults(package):
    param_tutorial.ParameterClient('/driver').set_parameter('max_speed_mps', 1.5)
    package.save('driver_node.py', SLOW)
    assert speed(package) == 0.25
    assert package.status().words.endswith('It begins with the defaults: what was set before is lost.')


def test_a_file_that_something_else_saves_runs_too_and_an_editor_follows_it(package):
    with closing(package.edit()) as editor:
        package.files.path('driver_node.py').write_text(SLOW)
        param_tutorial.wait_until(lambda: editor.text == SLOW, 'the new text')
    assert speed(package) == 0.25


@pytest.mark.parametrize(('old', 'new', 'line', 'words'), [
    ("'max_speed_mps', 0.5, Par", "'max_speed_mps', 0.5, 'Par", 11, 'SyntaxError in line 11 of driver_node.py'),
    ("'max_speed_mps', 0.5", "'max_speed_mps' 0.5", 11, 'Perhaps you forgot a comma? Nothing'),
    ('import Twist', 'import Twits', 2, 'ImportError in line 2 of driver_node.py: cannot import name'),
    ('self.create_publisher', 'self.create_publishr', 15, "no attribute 'create_publishr'"),
    ('class Driver(Node)', 'class Driver', 0, 'has no class derived from `Node` yet'),
    ("super().__init__('driver')", 'pass', 11, '`__init__` has to call `super()'),
    ("super().__init__('driver')", 'while True: pass', 10, 'does not return in line'),
], ids=['syntax', 'comma', 'import', 'attribute', 'no class', 'no node', 'endless'])
def test_a_file_that_makes_no_node_leaves_the_robot_and_names_the_line(package, monkeypatch, old, new, line, words):
    monkeypatch.setattr(loading, 'LIMIT_SEC', 0.5)
    assert old in DRIVER
    package.save('driver_node.py', DRIVER.replace(old, new))
    assert words in package.status().words
    assert (package.status().is_error, package.status().line) == (True, line)
    assert [each.get_name() for each in stage.current().nodes if each.get_name() == 'driver']
    assert speed(package) == 0.5


def test_what_a_callback_raises_names_the_line_and_the_robot_stops(package):
    package.save('driver_node.py', DRIVER.replace('self.speed_mps\n', 'self.spede_mps\n'))
    param_tutorial.wait_until(lambda: package.status().is_error, 'the exception')
    assert package.status().line == 20
    assert 'timer callback drive of /driver: AttributeError in line 20 of driver_node.py' in package.status().words
    # That version runs again, and raises again; the file is another by now.
    package.save('driver_node.py', DRIVER.replace("'max_speed_mps').value", "'max_sped_mps').value"))
    param_tutorial.wait_until(lambda: any(f.callback.node is package.node() for f in stage.current().failures), 'it')
    package.refresh()
    assert 'ParameterNotDeclaredException in line' in package.status().words


def test_a_callback_that_does_not_return_takes_its_node_off_the_stage(package):
    package.save('driver_node.py', DRIVER.replace('command = Twist()', 'while True: pass'))
    param_tutorial.wait_until(lambda: stage.current().busy_sec, 'the callback')
    stage.current().run(lambda: None, 'ask for the thread')
    param_tutorial.wait_until(lambda: package.node() is None, 'the end of the node')
    assert package.status().line == 19
    assert package.status().words.endswith('The stage runs it no longer.')
    package.save('driver_node.py', SLOW)
    assert speed(package) == 0.25


def test_the_stage_runs_ours_until_a_step_is_passed_and_the_readers_file_stays(package):
    package.save('driver_node.py', SLOW)
    package.need('3d')
    assert speed(package) == 0.5
    assert 'The stage runs our driver_node.py as it is after step 3d.' in package.status().words
    assert package.files.text('driver_node.py') == SLOW
    assert package.root != package.files.root
    package.save('driver_node.py', SLOW)
    assert speed(package) == 0.25
    package_files.passed.add('3d')
    package.need('3d')
    assert speed(package) == 0.25
    package.save('driver_node.py', SLOW.replace('super', 'supper'))
    package.need('3d')
    assert speed(package) == 0.5
    assert 'Yours does not run; it stays as it is' in package.status().words


def test_nothing_of_the_readers_is_overwritten_without_a_backup(package, capsys):
    package.save('driver_node.py', SLOW)
    package.take_ours('3c')
    said = capsys.readouterr().out
    kept, = package.files.backups.rglob('driver_node.py')
    assert kept.read_text() == SLOW
    assert kept.parents[1].name in said
    # Where colcon looks for packages, there is one of this name.
    assert (package.files.backups / 'COLCON_IGNORE').exists()
    assert package.files.text('driver_node.py') == ours('3c')['my_robot/driver_node.py']
    # An editor that began with another text than is there now.
    package.files.path('driver_node.py').write_text(SLOW + '# more\n')
    package.edit().save(DRIVER, base=SLOW)
    assert SLOW + '# more\n' in [each.read_text() for each in package.files.backups.rglob('driver_node.py')]
    Package('4').close()
    assert package.files.text('driver_node.py') == DRIVER


def test_chapter_2_begins_with_nothing_and_leaves_a_package_alone_that_is_further(package, capsys):
    package.save('driver_node.py', SLOW)
    first = Package('2')
    assert 'is further than this chapter, and stays as it is' in capsys.readouterr().out
    assert first.home != package.home
    assert list(first.home.iterdir()) == []
    first.close()


def test_a_package_that_is_closed_is_followed_no_longer(package):
    assert package_in_work() == package.root
    package.files.path('driver_node.py').write_text(SLOW)
    package.close()
    package.refresh()
    assert package_in_work() is None


def test_an_editor_of_another_file_says_that_it_is_saved_or_not_there_yet(package):
    assert package.status('config/my_robot.yaml').words == 'There is no config/my_robot.yaml yet.'
    with closing(package.edit('package.xml')) as editor:
        editor.save(editor.text.replace('wall', 'door'))
        assert 'a door' in editor.text
    assert 'a door' in package.files.text('package.xml')
    assert package.status('package.xml').words == 'Saved.'


def test_a_step_or_a_chapter_that_there_is_not_is_named(package):
    with pytest.raises(ParameterToolError, match=r"There is no step '3x'\. There is: "):
        package.need('3x')
    with pytest.raises(ParameterToolError, match=r"chapter '1' has nothing to begin with"):
        Package('1')


def test_a_file_that_is_no_node_can_be_what_a_step_is_about(package):
    package.take_ours('5.3b')
    package.need('5.3b')
    assert package.root == package.files.root
    package.files.write('setup.py', '', package.files.text('setup.py'))
    package.need('5.3b')
    assert package.root != package.files.root


def test_a_start_takes_arguments_and_keeps_them(package):
    package.start('-p', 'max_speed_mps:=0.75')
    assert speed(package) == 0.75
    package.save('driver_node.py', SLOW)
    assert speed(package) == 0.75
    assert 'It begins as `-p max_speed_mps:=0.75` says' in package.status().words
    package.start('-p', 'max_speed_mps:=fast')
    assert package.status().is_error
    assert speed(package) == 0.75


def test_a_start_in_a_namespace_leaves_no_node_outside_of_it(package):
    package.start('-r', '__ns:=/left')
    assert [each.get_fully_qualified_name() for each in stage.current().nodes] == ['/base', '/left/driver']
    package.start()
    assert [each.get_fully_qualified_name() for each in stage.current().nodes] == ['/base', '/driver']


def test_a_program_takes_the_place_of_the_node_that_was_stopped(package):
    package.stop()
    package.save('driver_node.py', SLOW)
    assert [each.get_name() for each in stage.current().nodes] == ['base']
    program = Terminal('ros2 run my_robot driver_node')
    assert param_tutorial.ParameterClient('/driver', timeout_sec=30).get_parameter('max_speed_mps') == 0.25
    assert program.interrupt() == 0
    package.start()
    assert speed(package) == 0.25


def test_a_launch_finds_the_files_of_the_package_without_a_build(package):
    package.stop()
    package.files.write('launch/start_launch.py', LAUNCH, '')
    package.files.write('config/slow.yaml', '/driver:\n  ros__parameters:\n    max_speed_mps: 0.125\n', '')
    package.save('driver_node.py', DRIVER)
    program = Terminal('ros2 launch my_robot start_launch.py')
    assert param_tutorial.ParameterClient('/driver', timeout_sec=30).get_parameter('max_speed_mps') == 0.125
    assert program.interrupt() == 0
