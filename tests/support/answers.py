"""What a learner hands in: the blanks and solutions in the notebooks, and answers made from them."""

import ast
import functools
import re
import tempfile
from pathlib import Path

import nbformat

from param_tutorial.exercises import EXERCISES
from param_tutorial.learner.package_files import PackageFiles, steps
from tests.support.paths import NOTEBOOKS

# Where the programs are written, and what the cells have made: their own folders go with the last reference to them.
_PROGRAMS = tempfile.TemporaryDirectory()
_spaces = []


@functools.cache
def notebook(number, folder=''):
    """Return the cells of the chapter that holds an exercise, or of its solutions."""
    return nbformat.read(NOTEBOOKS / folder / Path(EXERCISES[number].solutions).name, as_version=4).cells


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
        if each.id.startswith(f'{kind}-') and each.id.removeprefix(f'{kind}-') not in steps():
            exec(each.source, space)
    exec(source, space)
    name = re.fullmatch(rf"exercises\.check\('{number}', (\w+)\)", cell(number, 'check').source).group(1)
    return space[name]


def package(step, *replacements):
    """Return the package as it stands after a step, with some of the words of its programs replaced by others."""
    files = PackageFiles(Path(tempfile.mkdtemp(dir=_PROGRAMS.name)))
    files.lay_out(step)
    programs = sorted(files.root.glob('my_robot/*_node.py'))
    for old, new in replacements:
        path = next((each for each in programs if old in each.read_text()), None)
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
