"""Where things are in this checkout."""

from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
NOTEBOOKS = ROOT / 'notebooks'
CONFIG = ROOT / 'config'
ROS_PACKAGE = ROOT / 'param_tutorial'
PACKAGE = ROS_PACKAGE / 'param_tutorial'
TOOLS = ROS_PACKAGE / 'param_tools'
