"""What a learner hands in: the blanks and solutions in the notebooks, and answers made from them."""

import ast
import contextlib
import functools
import os
import re
import shlex
import tempfile
from pathlib import Path

import nbformat

from param_tutorial.exercises import EXERCISES
from param_tutorial.exercises.chapters import ch05_1
from param_tutorial.learner.package_files import NAME, WORKSPACE, PackageFiles, steps
from tests.support import commands
from tests.support.paths import NOTEBOOKS

# Where the programs are written, and what the cells have made: their own folders go with the last reference to them.
_PROGRAMS = tempfile.TemporaryDirectory()
_spaces = []
# What is judged by the nodes on the stage, after a reader has typed commands.
TYPED = (ch05_1.PACKAGE, ch05_1.NODE)


@functools.cache
def notebook(number, folder=''):
    """Return the cells of the chapter that holds an exercise, or of its solutions."""
    exercise = EXERCISES[number]
    return nbformat.read(NOTEBOOKS / (exercise.solutions if folder else f'{exercise.chapter}.ipynb'), 4).cells


def cell(number, kind):
    """Return a cell of an exercise: its 'exercise' and 'check' in the chapter, or its 'solution'."""
    cells = notebook(number, 'solutions' if kind == 'solution' else '')
    found, = (each for each in cells if each.id == f'{kind}-{number.replace(".", "-")}')
    return found


def answer(number, source, kind):
    """Run the source of a cell as its notebook would, and return what its check is given."""
    if source.startswith('%%writefile '):
        first, _, text = source.partition('\n')
        path = Path(_PROGRAMS.name, first.split()[1])
        path.write_text(f'{text}\n')
        return str(path)
    if EXERCISES[number].takes in TYPED:
        return typed(number, source)
    space = {'__name__': '__main__'}
    _spaces.append(space)
    for each in notebook(number, 'solutions' if kind == 'solution' else ''):
        if each.cell_type == 'code' and not each.source.startswith('%%'):
            lines = [line for line in each.source.splitlines() if not line.lstrip().startswith('%')]
            body = ast.parse('\n'.join(lines)).body
            imports = [each for each in body if isinstance(each, (ast.Import, ast.ImportFrom))]
            exec(compile(ast.Module(imports, []), 'imports', 'exec'), space)
    # In a capstone each step builds on those before it.
    for each in notebook(number, 'solutions' if kind == 'solution' else ''):
        if each.id == cell(number, kind).id:
            break
        earlier = each.id.removeprefix(f'{kind}-').replace('-', '.')
        if each.id.startswith(f'{kind}-') and earlier not in steps() and EXERCISES[earlier].takes not in TYPED:
            exec(each.source, space)
    exec(source, space)
    return space[checked(number)]


def checked(number):
    """Return what the check of an exercise is given, as its cell names it."""
    return re.fullmatch(rf"exercises\.check\('{number}', (\w+)\)", cell(number, 'check').source).group(1)


def _type(line):
    with contextlib.suppress(ValueError):  # quotes that are not closed
        commands.run(*shlex.split(line, comments=True))


def typed(number, source):
    """Put the nodes of the notebook onto the stage, and type a cell's lines; return what the check is given."""
    folder = Path.cwd()
    space = {'ros2': _type}
    for each in notebook(number, 'solutions'):
        if each.cell_type == 'code' and each.id.startswith('solutions-'):
            exec(re.sub(r'(?m)^%load_ext.*', '', each.source), space)
    space['package'].close()
    os.chdir(folder)  # a package without a learner works in a temporary one
    exec(re.sub(r'(?m)^%ros2 (.*)', lambda line: f'ros2({line[1]!r})', source), space)
    return space[checked(number)]


def package(step, *replacements):
    """Return the package as it stands after a step, with some of its words replaced by others."""
    files = PackageFiles(Path(tempfile.mkdtemp(dir=_PROGRAMS.name)))
    files.lay_out(step)
    (files.lessons / WORKSPACE / 'install' / NAME).mkdir(parents=True)  # as after a build with links
    texts = sorted((each for each in files.root.rglob('*') if each.is_file()), key=lambda each: each.suffix != '.py')
    for old, new in replacements:
        path = next((each for each in texts if old in each.read_text()), None)
        assert path, f'step {step} has changed: {old!r} is not in it'
        path.write_text(path.read_text().replace(old, new))
    return files


def blank(number):
    """Return what an exercise begins with."""
    if number in steps():
        return package(steps()[steps().index(number) - 1])
    return answer(number, cell(number, 'exercise').source, 'exercise')


def solution(number, *replacements):
    """Return a solution, with some of its words replaced by others."""
    if number in steps():
        return package(number, *replacements)
    source = cell(number, 'solution').source
    for old, new in replacements:
        assert old in source, f'the solution of {number} has changed: {old!r} is not in it'
        source = source.replace(old, new)
    return answer(number, source, 'solution')


def not_yet(result):
    """Return what happened, for each requirement that is not met."""
    return {finding.sentence: finding.happened for finding in result.findings if finding.done is not True}
