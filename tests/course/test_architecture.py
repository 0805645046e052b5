"""Imports go downward only, from room to room; no file is in a circle; param_tutorial/README.md draws it as it is."""

import ast
import re
from collections.abc import Iterator

import pytest

import param_tools
import param_tutorial
from tests.support.paths import NOTEBOOKS, PACKAGE, ROS_PACKAGE, TOOLS

README = (ROS_PACKAGE / 'README.md').read_text()
FILES = {'.'.join(path.relative_to(ROS_PACKAGE).with_suffix('').parts).removesuffix('.__init__'): path
         for package in (TOOLS, PACKAGE) for path in sorted(package.rglob('*.py'))
         if 'steps' not in path.parts}  # the reader's package: files to copy
# The facades import what a name needs when the name is first used, and stand above every room of their package.
FACADES = ('param_tools', 'param_tutorial')
ABOVE = (*FACADES, 'param_tools.__main__', 'param_tutorial.__main__')


def room_of(module: str) -> str:
    return module.split('.')[1]


def picture_of_the_readme() -> dict[str, list[str]]:
    """Return README's table: the rooms, top to bottom, and the rooms that each imports."""
    table = README.partition('| Room | Imports | What is in it |\n| --- | --- | --- |\n')[2].partition('\n\n')[0]
    rows = [re.fullmatch(r'\| `(\w+)` \| (.+?) \| .+ \|', row).groups() for row in table.splitlines()]
    return {room: re.findall(r'\w+', imported) for room, imported in rows}


def rooms_of_the_readme() -> list[str]:
    return list(picture_of_the_readme())


def imports_of(module: str) -> Iterator[str]:
    """Yield the modules of the package that a file imports, anywhere in the file."""
    for statement in ast.walk(ast.parse(FILES[module].read_text())):
        if isinstance(statement, ast.Import):
            yield from (alias.name for alias in statement.names if alias.name in FILES)
        elif isinstance(statement, ast.ImportFrom):
            assert not statement.level, f'{module}: name the module in full, as everywhere here'
            source = statement.module
            for alias in statement.names:
                if f'{source}.{alias.name}' in FILES:
                    yield f'{source}.{alias.name}'
                elif source in FILES:
                    yield source


@pytest.fixture(scope='module')
def arrows() -> dict[str, list[str]]:
    """Return what each file of the package imports of it."""
    return {module: sorted(set(imports_of(module))) for module in FILES}


def test_readme_and_packages_name_the_same_rooms():
    drawn = [room for package in (param_tutorial, param_tools)
             for room in re.findall(r'^    (\w+)$', package.__doc__, re.MULTILINE)]
    assert drawn == rooms_of_the_readme()
    assert sorted(drawn) == sorted({room_of(module) for module in FILES if module not in ABOVE})


def test_readme_draws_the_arrows_that_there_are(arrows):
    drawn = {room: set() for room in picture_of_the_readme()}
    for module, others in arrows.items():
        if module not in ABOVE:
            drawn[room_of(module)] |= {room_of(other) for other in others if other not in FACADES} - {room_of(module)}
    assert {room: set(imported) for room, imported in picture_of_the_readme().items()} == drawn


def test_imports_go_downward_only(arrows):
    floor = {room: number for number, room in enumerate(reversed(rooms_of_the_readme()))}
    upward = [f'{module} imports {other}' for module, others in arrows.items() if module not in ABOVE
              for other in others if other in ABOVE or floor[room_of(other)] > floor[room_of(module)]]
    assert sum(map(len, arrows.values())) > 200
    assert upward == []


def test_no_file_is_in_a_circle_of_imports(arrows):
    remaining = dict(arrows)
    while leaves := [module for module, others in remaining.items() if not any(each in remaining for each in others)]:
        for module in leaves:
            del remaining[module]
    assert remaining == {}


def test_no_chapter_of_the_exercises_imports_another(arrows):
    chapters = [module for module in FILES if module.startswith('param_tutorial.exercises.chapters.')]
    assert len(chapters) == len(list(NOTEBOOKS.glob('[0-9]*.ipynb')))
    assert [(module, other) for module in chapters for other in arrows[module] if other in chapters] == []


def test_the_tools_know_nothing_of_the_course(arrows):
    assert [(module, other) for module, others in arrows.items() for other in others
            if module.startswith('param_tools') and other.startswith('param_tutorial')] == []
