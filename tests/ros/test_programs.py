"""Programs without processes: what ``ros2 run`` and ``ros2 launch`` start runs beside the cell, in the same Python.

Each test is a process of its own, on rclpy in Python, because a program has a default context, handlers of signals and
logs of its own there.
"""

import textwrap

from tests.support.processes import output_of

BEGIN = """
import subprocess, threading, time
from pathlib import Path
from param_tools.rcl_in_python.install import install
install(even_beside_the_real_one=True)
from param_tools.ros import turns
host = turns.install()
threading.Thread.start = subprocess.Popen.__init__ = None
import param_tutorial
from param_tutorial import ParameterClient, Terminal, wait_until
ros = param_tutorial.start()
"""


def run(source, tmp_path):
    """Run a program after BEGIN, and return what it prints."""
    return output_of(f'{BEGIN}{source}\nparam_tutorial.stop()\n', tmp_path)


def written(tmp_path, source):
    """Write a program in Python, and return the lines that start it in a terminal."""
    (tmp_path / 'program.py').write_text(textwrap.dedent(source))
    return "terminal = Terminal('python3 program.py')\n"


def test_a_program_has_its_own_arguments_and_is_asked_and_ended(tmp_path):
    (tmp_path / 'file.yaml').write_text('/**: {ros__parameters: {robot_name: Berta}}')
    assert run("robot = Terminal('ros2 run param_tutorial simple_param_node --ros-args -r __node:=late '\n"
               "                 '-p max_speed_rpm:=7 --params-file file.yaml')\n"
               "print(robot.read(until='max_speed_rpm'))\n"
               "from param_tutorial.nodes.simple_param_node import SimpleParamNode\n"
               "here = ros.add(SimpleParamNode)\n"
               "print(ParameterClient('/late').set_parameter('max_speed_rpm', 8))\n"
               "print(here.get_parameter('robot_name').value)\n"
               "print(robot.read(until='is now').splitlines()[-1])\n"
               "print(robot.is_running, robot.interrupt(), robot, ros.services.node_names())", tmp_path) == (
        '[INFO] [late]: SimpleParamNode has been started.\n'
        '[INFO] [late]: Parameters declared successfully.\n'
        '[INFO] [late]:   robot_name: Berta\n'
        '[INFO] [late]:   max_speed_rpm: 7\n'
        '/late accepted max_speed_rpm = 8\nClawbot\n'
        '[INFO] [late]: max_speed_rpm is now 8\n'
        'True 0 <Terminal: ros2 run param_tutorial simple_param_node --ros-args -r __node:=late -p max_speed_rpm:=7 '
        "--params-file file.yaml (ended with status 0)> ['/simple_param_node']\n")


def test_ctrl_c_is_raised_where_a_program_spins_and_what_it_does_then_is_done(tmp_path):
    assert run(written(tmp_path, """
        import sys
        import rclpy
        from rclpy.node import Node

        def live(node):
            rclpy.spin(node)

        def main():
            rclpy.init()
            try:
                live(Node('tidy'))
            except KeyboardInterrupt:
                print('interrupted')
            finally:
                print('tidy', rclpy.ok())
            sys.exit(3)

        main()
        """) + 'print(terminal.interrupt())\nprint(terminal.text)', tmp_path) == '3\ninterrupted\ntidy False\n\n'


def test_every_spin_of_rclpy_lets_others_live(tmp_path):
    assert run(written(tmp_path, """
        import rclpy, rclpy.executors
        from rclpy.node import Node
        rclpy.init()
        node, count, future = Node('counter'), 0, rclpy.Future()
        def tick():
            global count
            count += 1
            if count == 3:
                future.set_result(3)
        node.create_timer(0.02, tick)
        rclpy.spin_until_future_complete(node, future)
        while count < 6:
            rclpy.spin_once(node)
        print('six')
        executor = rclpy.executors.SingleThreadedExecutor()
        executor.add_node(node)
        executor.spin()
        """) + "print(ros.run(lambda: 'the stage is free', 'ask'))\nprint(terminal.read(until='six'))\n"
               "terminal.interrupt()", tmp_path) == 'the stage is free\nsix\n'


def test_a_launch_starts_three_programs_and_ends_them(tmp_path):
    (tmp_path / 'three_launch.py').write_text(textwrap.dedent("""
        from launch import LaunchDescription
        from launch_ros.actions import Node

        def generate_launch_description():
            return LaunchDescription([
                Node(package='param_tutorial', executable='simple_param_node', name=name, output=output,
                     parameters=[{'max_speed_rpm': speed}])
                for name, speed, output in (('anna', 1, 'own_log'), ('berta', 2, 'screen'), ('carla', 'x', 'log'))])
        """))
    assert run("launch = Terminal('ros2 launch three_launch.py')\n"
               "print([ParameterClient(name).get_parameter('max_speed_rpm') for name in ('/anna', '/berta')])\n"
               "print(launch.interrupt(), ros.services.node_names())\n"
               "for each in launch.text.splitlines():\n    if 'launch' in each or 'process' in each: print(each)",
               tmp_path).partition('exit code')[0] == (
        '[1, 2]\n0 []\n'
        '[INFO] [launch]: Default logging verbosity is set to INFO\n'
        '[INFO] [simple_param_node-1]: process started\n'
        '[INFO] [simple_param_node-2]: process started\n'
        '[INFO] [simple_param_node-3]: process started\n'
        '[ERROR] [simple_param_node-3]: process has died [')


def test_what_needs_a_process_says_so(tmp_path):
    assert run("from param_tools.errors import NoProcessError\n"
               "try: Terminal('git status')\nexcept NoProcessError as error: print(error)", tmp_path) == (
        "There are no processes in a web page, and 'git' needs one: only ros2, its programs of this course, and files "
        'in Python run here\n')
