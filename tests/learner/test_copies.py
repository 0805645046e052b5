"""The folder of the learner's copies: what is delivered, what stays, and what is kept if something goes wrong."""

import errno
import os
import subprocess
from pathlib import Path

import nbformat
import pytest
from nbformat.sign import NotebookNotary

from param_tools.errors import ParameterToolError
from param_tutorial.learner.__main__ import main
from param_tutorial.learner.copies import Copies
from tests.support.paths import ROOT

FIRST, SECOND, SOLUTION = '01_first.ipynb', '05_1_second.ipynb', 'solutions/01_first.ipynb'


def write_chapter(path: Path, *sources: str) -> None:
    """Write a chapter as it is stored: run, with outputs."""
    cells = [nbformat.v4.new_markdown_cell('# Title', id='cell-00')]
    for number, source in enumerate(sources, start=1):
        cells.append(nbformat.v4.new_code_cell(source, id=f'cell-{number:02}', execution_count=number, outputs=[
            nbformat.v4.new_output('display_data', {'text/html': '<b>42</b>', 'text/plain': '42'})]))
    path.parent.mkdir(parents=True, exist_ok=True)
    nbformat.write(nbformat.v4.new_notebook(cells=cells), path)


def write_course(course: Path) -> None:
    """Write a small course."""
    write_chapter(course / 'notebooks' / FIRST, 'speed = 1', 'drive(speed)')
    write_chapter(course / 'notebooks' / SECOND, 'turn = 1')
    write_chapter(course / 'notebooks' / SOLUTION, 'solution = 1')
    for name, text in (('index.md', '# Start'), ('conftest.py', 'import pytest'), ('images/robot.svg', '<svg/>'),
                       ('.ipynb_checkpoints/old.ipynb', '{}')):
        path = course / 'notebooks' / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text)


@pytest.fixture
def course(tmp_path: Path) -> Path:
    write_course(tmp_path / 'ein Käse')
    return tmp_path / 'ein Käse'


@pytest.fixture
def copies(course: Path) -> Copies:
    """The copies of the small course, delivered for the first time."""
    copies = Copies(course)
    copies.deliver()
    return copies


def files(folder: Path) -> dict[str, bytes]:
    """Return what a learner sees in a folder, and the backups."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob('*'))
            if path.is_file() and not any(part.startswith('.') for part in path.relative_to(folder).parts)}


def backups(copies: Copies, name: str = FIRST) -> list[bytes]:
    return [path.read_bytes() for path in sorted((copies.folder / 'backups').glob(f'*/{name}'))]


def sources(path: Path) -> list[str]:
    return [cell.source for cell in nbformat.read(path, as_version=4).cells]


def edit(path: Path, number: int, source: str) -> bytes:
    """Change the text of a cell as JupyterLab does, and run it; return what the file then holds."""
    notebook = nbformat.read(path, as_version=4)
    notebook.cells[number].source = source
    if notebook.cells[number].cell_type == 'code':
        notebook.cells[number].outputs = [nbformat.v4.new_output('stream', text='ran')]
    nbformat.write(notebook, path)
    return path.read_bytes()


def test_the_first_start_delivers_what_a_learner_needs_and_nothing_of_the_tests(copies):
    assert list(files(copies.folder)) == [FIRST, SECOND, 'images/robot.svg', 'index.md', SOLUTION]
    for name in (FIRST, SECOND, SOLUTION):
        copy = nbformat.read(copies.folder / name, as_version=4)
        nbformat.validate(copy)
        assert sources(copies.folder / name) == sources(copies.chapters / name)
        assert [(cell.outputs, cell.execution_count) for cell in copy.cells[1:]] == [([], None)] * (len(copy.cells) - 1)


def test_jupyterlab_trusts_a_fresh_copy(copies):
    notary = NotebookNotary(data_dir=str(copies.trust))
    assert notary.check_signature(nbformat.read(copies.folder / FIRST, as_version=4))
    notary.store.close()


def test_git_and_make_clean_leave_them_alone(course, copies):
    """The real Makefile, in the small course."""
    done = subprocess.run(['git', 'check-ignore', 'my_lessons/01_what_are_parameters.ipynb'], cwd=ROOT,
                          capture_output=True, text=True)
    assert done.stdout == 'my_lessons/01_what_are_parameters.ipynb\n'
    (course / 'Makefile').write_text((ROOT / 'Makefile').read_text())
    before = files(copies.folder)
    subprocess.run(['make', 'clean'], cwd=course, check=True, capture_output=True)
    assert files(copies.folder) == before


def test_what_the_learner_has_not_changed_follows_the_course(copies):
    notebook = nbformat.read(copies.folder / FIRST, as_version=4)
    notebook.cells[1].outputs = [nbformat.v4.new_output('stream', text='ran')]
    notebook.cells.append(nbformat.v4.new_code_cell())  # as Shift+Enter does in the last cell
    text = '\ufeff' + nbformat.v4.writes(notebook).replace('\n', '\r\n')  # an editor of Windows saved it
    (copies.folder / FIRST).write_bytes(text.encode())
    write_chapter(copies.chapters / FIRST, 'speed = 2', 'drive(speed)')
    (copies.chapters / 'index.md').write_text('# New start')
    assert copies.deliver() == []
    assert sources(copies.folder / FIRST) == ['# Title', 'speed = 2', 'drive(speed)']
    assert (copies.folder / 'index.md').read_text() == '# New start'


def test_a_deleted_copy_comes_back(copies):
    before = files(copies.folder)
    (copies.folder / FIRST).unlink()
    assert copies.deliver() == []
    assert files(copies.folder) == before


@pytest.mark.parametrize(('name', 'remedy'), [
    (FIRST, 'make reset CHAPTER=1 gives you the new one and keeps yours as a backup.'),
    (SECOND, 'make reset CHAPTER=5.1 gives you the new one and keeps yours as a backup.'),
    (SOLUTION, 'Rename or delete yours, and the next make lab brings the new one.')])
def test_a_changed_copy_stays_and_a_sentence_says_how_to_get_the_new_version(copies, name, remedy):
    edit(copies.folder / name, 1, 'mine = 99')
    before = files(copies.folder)
    write_chapter(copies.chapters / name, 'new = 2')
    for _ in range(2):
        assert copies.deliver() == [f'There is a new version of my_lessons/{name}. Yours stays as it is, because you '
                                    f'have changed it. {remedy}']
    assert files(copies.folder) == before


def test_a_chapter_is_made_fresh_again_and_what_was_there_is_kept(copies):
    fresh = files(copies.folder)[SECOND]
    before = edit(copies.folder / SECOND, 1, 'turn = 99')
    said = copies.reset('5.1')
    kept, = (copies.folder / 'backups').iterdir()
    assert said.startswith(f'my_lessons/{SECOND} is fresh again. What was there is now my_lessons/backups/{kept.name}/')
    assert files(copies.folder)[SECOND] == fresh
    assert backups(copies, SECOND) == [before]
    assert copies.reset('05_1_second') == f'my_lessons/{SECOND} is fresh already.'


@pytest.mark.parametrize(('chapter', 'there'), [
    ('05', 'Did you mean 5.1?'), ('6', 'There is: 1, 5.1')])
def test_a_chapter_that_is_not_there_is_an_error_that_names_those_that_are(course, capsys, chapter, there):
    assert main([chapter, '--course', str(course)]) == 1
    assert capsys.readouterr().err == f'There is no chapter {chapter!r}. {there}\n'


@pytest.mark.parametrize('written', [0, 1])  # 1 is the backup
def test_what_the_system_rejects_is_one_sentence_and_changes_no_copy(copies, monkeypatch, written):
    mine = edit(copies.folder / FIRST, 1, 'speed = 1')
    write_chapter(copies.chapters / FIRST, 'speed = 2')
    before = files(copies.folder)
    writes, real = iter(range(written)), os.fsync

    def reject(file: int) -> None:
        if next(writes, None) is None:
            raise OSError(errno.ENOSPC, 'No space left on device', 'the file')
        real(file)

    monkeypatch.setattr(os, 'fsync', reject)
    with pytest.raises(ParameterToolError, match=(
            r'nothing of yours was lost\. The reason: No space left on device: the file')):
        copies.reset('1')
    assert {name: content for name, content in files(copies.folder).items() if 'backups/' not in name} == before
    assert backups(copies) == [mine] * written
    assert not [path for path in copies.folder.rglob('*.new')]
