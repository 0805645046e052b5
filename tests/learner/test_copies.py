"""The folder of the learner's copies: what is delivered, what stays, and what is kept if something goes wrong."""

import errno
import json
import os
import subprocess
from pathlib import Path

import nbformat
import pytest
from nbformat.sign import NotebookNotary

from param_tutorial.learner import command
from param_tutorial.learner.copies import Copies, CopiesError
from tests.support.paths import NOTEBOOKS, ROOT

FIRST, SECOND, SOLUTION = '01_first.ipynb', '05_1_second.ipynb', 'solutions/01_first.ipynb'


def write_chapter(path: Path, *sources: str, tags: tuple[str, ...] = ()) -> None:
    """Write a chapter as it is stored: run, with outputs."""
    cells = [nbformat.v4.new_markdown_cell('# Title', id='cell-00')]
    for number, source in enumerate(sources, start=1):
        cells.append(nbformat.v4.new_code_cell(source, id=f'cell-{number:02}', execution_count=number, outputs=[
            nbformat.v4.new_output('display_data', {'text/html': '<b>42</b>', 'text/plain': '42'})]))
        cells[-1].metadata.tags = list(tags)
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


# What is delivered


def test_the_first_start_delivers_what_a_learner_needs_and_nothing_of_the_tests(copies):
    assert list(files(copies.folder)) == [FIRST, SECOND, 'images/robot.svg', 'index.md', SOLUTION]
    for name in (FIRST, SECOND, SOLUTION):
        copy = nbformat.read(copies.folder / name, as_version=4)
        nbformat.validate(copy)
        assert sources(copies.folder / name) == sources(copies.chapters / name)
        assert [(cell.outputs, cell.execution_count) for cell in copy.cells[1:]] == [([], None)] * (len(copy.cells) - 1)


@pytest.mark.slow
def test_the_course_itself_is_delivered_whole(tmp_path):
    (tmp_path / 'notebooks').symlink_to(NOTEBOOKS)
    copies = Copies(tmp_path)
    copies.deliver()
    delivered = files(copies.folder)
    chapters = [path.name for path in sorted(NOTEBOOKS.glob('*.ipynb'))]
    assert {*chapters, 'index.md', 'claims.md', *(f'solutions/{name}' for name in chapters)} <= delivered.keys()
    assert not [name for name in delivered if name.endswith('.py')]
    for name, content in delivered.items():
        assert not name.endswith('.ipynb') or not any(cell.get('outputs') or cell.get('execution_count')
                                                      for cell in json.loads(content)['cells'])


def test_only_the_first_start_has_something_to_say(course):
    said, = Copies(course).deliver()
    assert said == 'Your own copies of the chapters are in my_lessons/. Change whatever you like there.'
    assert Copies(course).deliver() == []


def test_jupyterlab_trusts_a_fresh_copy(copies):
    notary = NotebookNotary(data_dir=str(copies.trust))
    assert notary.check_signature(nbformat.read(copies.folder / FIRST, as_version=4))
    notary.store.close()


def test_git_sees_nothing_of_it():
    done = subprocess.run(['git', 'check-ignore', 'my_lessons/01_what_are_parameters.ipynb'], cwd=ROOT,
                          capture_output=True, text=True)
    assert done.stdout == 'my_lessons/01_what_are_parameters.ipynb\n'


def test_make_clean_leaves_it_alone(course, copies):
    """The real Makefile, in the small course."""
    (course / 'Makefile').write_text((ROOT / 'Makefile').read_text())
    (course / 'build').mkdir()
    before = files(copies.folder)
    subprocess.run(['make', 'clean'], cwd=course, check=True, capture_output=True)
    assert not (course / 'build').exists()
    assert files(copies.folder) == before


# What follows the course


def test_an_untouched_copy_is_replaced_by_the_changed_chapter(copies):
    write_chapter(copies.chapters / FIRST, 'speed = 2', 'drive(speed)')
    (copies.chapters / 'index.md').write_text('# New start')
    assert copies.deliver() == []
    assert sources(copies.folder / FIRST) == ['# Title', 'speed = 2', 'drive(speed)']
    assert (copies.folder / 'index.md').read_text() == '# New start'
    assert not (copies.folder / 'backups').exists()


def test_a_chapter_whose_tags_have_changed_is_a_new_version(copies):
    write_chapter(copies.chapters / FIRST, 'speed = 1', 'drive(speed)', tags=('raises-exception',))
    copies.deliver()
    assert nbformat.read(copies.folder / FIRST, as_version=4).cells[1].metadata.tags == ['raises-exception']


def test_a_copy_that_was_run_is_replaced_too_and_its_outputs_are_kept(copies):
    edit(copies.folder / FIRST, 1, 'speed = 1')
    notebook = nbformat.read(copies.folder / FIRST, as_version=4)
    notebook.cells.append(nbformat.v4.new_code_cell())  # as Shift+Enter does in the last cell
    text = '\ufeff' + nbformat.v4.writes(notebook).replace('\n', '\r\n')  # an editor of Windows saved it
    (copies.folder / FIRST).write_bytes(before := text.encode())
    write_chapter(copies.chapters / FIRST, 'speed = 2')
    said, = copies.deliver()
    kept, = (copies.folder / 'backups').iterdir()
    assert said == (f'my_lessons/{FIRST} is now the new version. You had changed no cell; the file with your '
                    f'outputs is kept as my_lessons/backups/{kept.name}/{FIRST}.')
    assert sources(copies.folder / FIRST) == ['# Title', 'speed = 2']
    assert backups(copies) == [before]


def test_a_deleted_copy_comes_back(copies):
    before = files(copies.folder)
    (copies.folder / FIRST).unlink()
    (copies.folder / 'index.md').unlink()
    assert copies.deliver() == []
    assert files(copies.folder) == before


# What stays


def test_a_second_start_changes_nothing(copies):
    edit(copies.folder / FIRST, 1, 'speed = 99')
    (copies.folder / 'index.md').write_text('# My start')
    (copies.folder / '06_mine.ipynb').write_text('my own')
    before = files(copies.folder)
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


def test_a_changed_page_stays_too(copies):
    (copies.folder / 'index.md').write_text('# My start')
    (copies.chapters / 'index.md').write_text('# New start')
    said, = copies.deliver()
    assert said.startswith('There is a new version of my_lessons/index.md.')
    assert (copies.folder / 'index.md').read_text() == '# My start'


def test_who_resets_a_changed_chapter_follows_the_course_again(copies):
    edit(copies.folder / FIRST, 1, 'speed = 99')
    write_chapter(copies.chapters / FIRST, 'speed = 2')
    copies.reset('1')
    assert copies.deliver() == []
    write_chapter(copies.chapters / FIRST, 'speed = 3')
    assert copies.deliver() == []
    assert sources(copies.folder / FIRST) == ['# Title', 'speed = 3']


def test_a_copy_from_before_deliveries_were_noted_counts_as_changed_unless_it_is_todays_chapter(copies):
    for path in (copies.folder / '.delivered').iterdir():
        path.unlink()
    write_chapter(copies.chapters / FIRST, 'speed = 2')
    said, = copies.deliver()
    assert said.startswith(f'There is a new version of my_lessons/{FIRST}.')
    assert sources(copies.folder / FIRST) == ['# Title', 'speed = 1', 'drive(speed)']
    write_chapter(copies.chapters / SECOND, 'turn = 2')
    copies.deliver()
    assert sources(copies.folder / SECOND) == ['# Title', 'turn = 2']


def test_a_solution_in_the_place_of_its_chapter_is_a_change_too(copies):
    (copies.folder / FIRST).write_bytes((copies.folder / SOLUTION).read_bytes())
    assert copies.deliver() == []
    assert sources(copies.folder / FIRST) == ['# Title', 'solution = 1']


def test_the_copy_of_a_chapter_that_was_divided_stays_as_it_is(copies):
    mine = edit(copies.folder / FIRST, 1, 'speed = 99')
    (copies.chapters / FIRST).unlink()
    write_chapter(copies.chapters / '01_1_half.ipynb')
    assert copies.deliver() == []
    assert (copies.folder / FIRST).read_bytes() == mine
    assert (copies.folder / '01_1_half.ipynb').exists()


# What is no notebook


@pytest.mark.parametrize('content', [
    b'', b'{"cells": [', b'\xff\xfe', b'[]', b'{"cells": 5, "metadata": {}, "nbformat": 4}',
    b'{"cells": [{"cell_type": "code"}], "metadata": {}, "nbformat": 4, "nbformat_minor": 5}'])
def test_a_copy_that_is_no_notebook_any_more_is_kept_aside(copies, content):
    fresh = files(copies.folder)[FIRST]
    (copies.folder / FIRST).write_bytes(content)
    said, = copies.deliver()
    assert said.startswith(f'my_lessons/{FIRST} was not a notebook any more. A fresh copy is in its place;')
    assert (copies.folder / FIRST).read_bytes() == fresh
    assert backups(copies) == [content]


def test_a_chapter_that_is_not_a_notebook_is_named_and_the_others_are_delivered(copies):
    """Conflict markers as git leaves them after a merge."""
    before = files(copies.folder)[FIRST]
    (copies.chapters / FIRST).write_text('<<<<<<< HEAD\n')
    write_chapter(copies.chapters / SECOND, 'turn = 2')
    said, = copies.deliver()
    assert said == f'notebooks/{FIRST} is not a notebook: git status may say why. Your copy stays as it is.'
    assert files(copies.folder)[FIRST] == before
    assert sources(copies.folder / SECOND) == ['# Title', 'turn = 2']


# Fresh again


@pytest.mark.parametrize('chapter', ['5.1', '05_1', '5_1', '05_1_second', SECOND])
def test_a_chapter_is_made_fresh_again_and_what_was_there_is_kept(copies, chapter):
    fresh = files(copies.folder)[SECOND]
    before = edit(copies.folder / SECOND, 1, 'turn = 99')
    said = copies.reset(chapter)
    kept, = (copies.folder / 'backups').iterdir()
    assert said.startswith(f'my_lessons/{SECOND} is fresh again. What was there is now my_lessons/backups/{kept.name}/')
    assert files(copies.folder)[SECOND] == fresh
    assert backups(copies, SECOND) == [before]


def test_a_fresh_chapter_is_left_as_it_is(copies):
    assert copies.reset('1') == f'my_lessons/{FIRST} is fresh already.'
    assert backups(copies) == []


def test_a_reset_needs_no_earlier_start(course):
    assert Copies(course).reset('1') == f'my_lessons/{FIRST} is fresh again.'
    assert list(files(course / 'my_lessons')) == [FIRST]


@pytest.mark.parametrize(('chapter', 'there'), [
    ('05', 'Did you mean 5.1?'), ('6', 'There is: 1, 5.1'), ('', 'There is: 1, 5.1'), ('1st', 'There is: 1, 5.1'),
    ('solutions/01_first', 'There is: 1, 5.1')])
def test_a_chapter_that_is_not_there_is_an_error_that_names_those_that_are(course, capsys, chapter, there):
    assert command.main([chapter, '--course', str(course)]) == 1
    assert capsys.readouterr().err == f'There is no chapter {chapter!r}. {there}\n'


def test_make_reset_says_which_chapter_it_wants():
    done = subprocess.run(['make', '--no-print-directory', '-o', 'setup', 'reset'], cwd=ROOT, capture_output=True,
                          text=True)
    assert done.returncode != 0
    assert done.stderr.splitlines()[0] == 'Which one? make reset CHAPTER=08'


# What goes wrong on the way


@pytest.mark.parametrize(('number', 'told', 'written'), [
    (errno.ENOSPC, 'The disk is full', 0), (errno.EROFS, 'Read-only file system', 0),
    (errno.EACCES, 'Permission denied', 0), (errno.ENOSPC, 'The disk is full', 1)])  # 1 is the backup
@pytest.mark.parametrize('work', [Copies.deliver, lambda copies: copies.reset('1')], ids=['deliver', 'reset'])
def test_what_the_system_rejects_is_one_sentence_and_changes_no_copy(copies, monkeypatch, work, number, told, written):
    mine = edit(copies.folder / FIRST, 1, 'speed = 1')
    write_chapter(copies.chapters / FIRST, 'speed = 2')
    before = files(copies.folder)
    writes, real = iter(range(written)), os.fsync

    def reject(file: int) -> None:
        if next(writes, None) is None:
            raise OSError(number, os.strerror(number), 'the file')
        real(file)

    monkeypatch.setattr(os, 'fsync', reject)
    with pytest.raises(CopiesError, match=told):
        work(copies)
    assert {name: content for name, content in files(copies.folder).items() if 'backups/' not in name} == before
    assert backups(copies) == [mine] * written
    assert not [path for path in copies.folder.rglob('*.new')]
    monkeypatch.undo()
    copies.deliver()
    assert sources(copies.folder / FIRST) == ['# Title', 'speed = 2']


def test_a_file_in_the_place_of_the_folder_is_named(course):
    (course / 'my_lessons').touch()
    with pytest.raises(CopiesError, match=r'could not be brought up to date.*Not a directory: .*my_lessons'):
        Copies(course).deliver()
