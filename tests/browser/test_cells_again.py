"""Earlier cells are run again, in any order: no output loses what it shows."""

import pytest
from playwright.sync_api import expect

from tests.support.lab import wait_for

pytestmark = [pytest.mark.slow, pytest.mark.thorough, pytest.mark.timeout(600)]

# For each code cell, by its place in the notebook: how many robots and panels it shows.
SHOWN = """() => Object.fromEntries(window.jupyterapp.shell.currentWidget.content.widgets.map((cell, index) =>
    [index, cell.node.querySelectorAll('.robot-drive').length, cell.node.querySelectorAll('.param-head').length])
    .filter(([_, robots, panels]) => robots || panels).map(([index, ...shown]) => [index, shown]))"""
CELLS = (
    """import param_tutorial
from param_tutorial import ParameterPanel
from param_tutorial.nodes.clawbot_node import ClawbotNode
from param_tutorial.views import RobotView, SideBySide

ros = param_tutorial.start()
robot = ros.add(ClawbotNode)
view = RobotView(robot)
view""",
    "panel = ParameterPanel(robot, names=['enable_safety_mode'])\nSideBySide(view, panel)",
    'robot.drive()\nSideBySide(view, panel)',
    'panel',
)


def test_no_output_goes_blank(opened):
    _, page = opened
    page.page.set_viewport_size({'width': 900, 'height': 900})  # too narrow for what stands beside the text
    page.run_all()
    shown = {'0': [1, 0], '1': [1, 1], '2': [1, 1], '3': [0, 1]}
    for index in (None, 1, 0, 2, 1, 3):
        if index is not None:
            page.run_cell(index)
        wait_for(lambda: page.page.evaluate(SHOWN) == shown, f'all to be shown after cell {index} ran again')
    # What an output shows whose views are older ones is the robot on the stage, too.
    cells = page.page.locator('.jp-CodeCell')
    cells.nth(3).get_by_role('checkbox').uncheck()
    cells.nth(2).locator('.robot-drive').click()
    for cell in range(3):
        expect(cells.nth(cell).locator('.robot-says')).to_contain_text('run into the wall')
    for cell in (1, 2):
        expect(cells.nth(cell).get_by_role('checkbox')).not_to_be_checked()
