"""Draw the robot of the start page, which drives without a kernel: `python -m tests.tools.poster`."""

from param_tutorial.nodes.clawbot_node import Settings, plan
from param_tutorial.views.drawing import driving
from param_tutorial.views.drawing.robot import Robot
from tests.support.paths import NOTEBOOKS

FILE = NOTEBOOKS / 'images' / 'robot.svg'


def poster() -> str:
    """Return the picture: the robot of chapter 1, with its defaults, on three drives."""
    settings = Settings(max_speed_mps=1.05, max_acceleration_mps2=0.5)
    robot = Robot(name='Clawbot', serial_number='SN-CLAW-001', wheel_m=0.1, settings=settings,
                  motion=plan(0.0, 0.0, settings))
    return driving.poster(robot, times=3, pause_sec=2.0)


if __name__ == '__main__':
    FILE.write_text(poster(), encoding='utf-8')
    print(f'{FILE}: {FILE.stat().st_size} bytes')
