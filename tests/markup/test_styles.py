"""The style sheets: each belongs to a module, and none has to be looked for."""

import re
import subprocess
import sys

import pytest

from param_tools.markup.styles import style
from tests.support.paths import PACKAGE, ROS_PACKAGE, TOOLS

THEME = PACKAGE / 'site' / 'theme'
SHEETS = {str(path.relative_to(ROS_PACKAGE)) for room in (PACKAGE, TOOLS) for path in room.rglob('*.css')
          if THEME not in path.parents}
MODULES = {path: path.read_text() for room in (PACKAGE, TOOLS) for path in room.rglob('*.py')}


def test_a_sheet_that_is_not_there_is_named():
    with pytest.raises(FileNotFoundError, match=r'nothing\.css'):
        style('param_tutorial/views/nothing.css')


def test_each_sheet_is_used_and_stands_beside_the_module_that_uses_it_or_writes_its_markup():
    used = {path: re.findall(r"\b(?:style|sheet)\('(.*?\.css)'\)", text) for path, text in MODULES.items()}
    beside = {name for path, names in used.items() for name in names
              if ROS_PACKAGE / name in path.parent.iterdir() or (ROS_PACKAGE / name).with_suffix('.py') in MODULES}
    assert len(SHEETS) >= 10
    assert beside == SHEETS == {name for names in used.values() for name in names}


def test_drawings_can_be_imported_without_ros_and_widgets():
    """Also through what they import in turn."""
    names = [f'param_tutorial.views.drawing.{path.stem}' for path in (PACKAGE / 'views' / 'drawing').glob('[a-z]*.py')]
    code = (f'import sys, {", ".join(names)}\n'
            'print(sorted({"rclpy", "rcl_interfaces", "ipywidgets", "IPython"} & sys.modules.keys()))')
    done = subprocess.run([sys.executable, '-c', code], capture_output=True, text=True, check=True)
    assert len(names) >= 10 and done.stdout == '[]\n'
