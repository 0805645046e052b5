"""The track in the real JupyterLab: a reader's node drives, the browser shows where the robot is, and it rests."""

import pytest
from playwright.sync_api import expect

from tests.support.lab import wait_for

pytestmark = [pytest.mark.thorough, pytest.mark.timeout(600)]  # each wait may take lab.TIMEOUT_SEC

DRIVER = '''
import param_tutorial
from geometry_msgs.msg import Twist
from param_tutorial.nodes.base_node import BaseNode
from param_tutorial.views import TrackView
from rclpy.node import Node
from sensor_msgs.msg import Range


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.declare_parameter('gap_m', 1.0)
        self.publisher = self.create_publisher(Twist, 'cmd_vel', 10)
        self.create_subscription(Range, 'distance', self.drive, 10)

    def drive(self, measured):
        command = Twist()
        missing = measured.range - self.get_parameter('gap_m').value
        command.linear.x = min(1.0, missing) if missing > 0.02 else 0.0
        self.publisher.publish(command)


ros = param_tutorial.start()
base = ros.add(BaseNode, ros_args=['-p', 'wall_m:=4.0', '-p', 'max_acceleration_mps2:=4.0'])
view = TrackView(base)
view
'''
CELLS = ('# A track\nThe base of a robot:', DRIVER)
# Where the robot's front is between the start and the wall, from 0 to 1.
AT = '''() => { const [way, robot] = ['.track-way', '.track-robot'].map(
    each => document.querySelector(each).getBoundingClientRect()); return (robot.x - way.x) / way.width; }'''


def test_the_readers_node_drives_it_and_nothing_is_sent_while_it_stands(opened):
    lab, page = opened
    page.run_all()
    word, reset = page.page.locator('.robot-word'), page.page.get_by_role('button', name='Back to the start')
    expect(word).to_have_text('READY')
    lab.ask_kernel('ros.add(Driver)')
    expect(word).to_have_text('DRIVING')
    expect(word).to_have_text('STOPPED')
    wait_for(lambda: page.page.evaluate(AT) == pytest.approx(0.745, abs=0.005), 'the robot to stand before the wall')
    expect(page.page.get_by_role('status').filter(has_text='The robot stands')).to_have_text(
        'The robot stands 1.02 m from the wall.')
    page.page.evaluate('''() => {
        window.changes = 0;
        new MutationObserver(list => window.changes += list.length).observe(
            document.querySelector('.robot-view'), {subtree: true, childList: true, attributes: true}) }''')
    page.page.wait_for_timeout(1000)
    assert page.page.evaluate('window.changes') == 0
    lab.ask_kernel("ros.remove('/driver')")
    reset.click()
    expect(word).to_have_text('READY')
    wait_for(lambda: page.page.evaluate(AT) == 0, 'the robot to stand at the start')
    lab.ask_kernel("ros.remove('/base')")
    expect(page.page.locator('.robot-head')).to_have_text('/base is not running. It comes back here when it does.')
    expect(reset).to_be_disabled()
