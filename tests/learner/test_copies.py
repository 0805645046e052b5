"""The folder of the learner's copies: what is delivered, what stays, and what is kept if something goes wrong."""

import errno
import fcntl
import json
import os
import signal
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import nbformat
import pytest
from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, rule
from nbformat.sign import NotebookNotary

from param_tutorial.exercises import CHAPTERS
from param_tutorial.learner import command
from param_tutorial.learner.copies import Copies, CopiesError
from param_tutorial.learner.merging import NOTE
from param_tutorial.progress import ticks
from tests.support.lab import wait_for
from tests.support.paths import NOTEBOOKS, ROOT

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
    """Change the text of a cell as JupyterLab does, outputs and all; return what the file then holds."""
    notebook = nbformat.read(path, as_version=4)
    notebook.cells[number].source = source
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


# What stays


def test_a_second_start_changes_nothing(copies):
    edit(copies.folder / FIRST, 1, 'speed = 99')
    (copies.folder / '06_mine.ipynb').write_text('my own')
    (copies.folder / SECOND).rename(copies.folder / 'renamed.ipynb')
    (copies.folder / SECOND).write_bytes((copies.folder / 'renamed.ipynb').read_bytes())
    before = files(copies.folder)
    assert copies.deliver() == []
    assert files(copies.folder) == before


def test_an_untouched_copy_is_replaced_by_the_changed_chapter(copies):
    write_chapter(copies.chapters / FIRST, 'speed = 2', 'drive(speed)')
    assert copies.deliver() == []
    assert sources(copies.folder / FIRST) == ['# Title', 'speed = 2', 'drive(speed)']
    assert backups(copies) == []


def test_work_gets_into_the_changed_chapter_and_the_former_file_is_kept(copies):
    before = edit(copies.folder / FIRST, 1, 'speed = 99')
    write_chapter(copies.chapters / FIRST, 'speed = 1', 'drive(speed, lights=True)', 'stop()')
    said, = copies.deliver()
    assert sources(copies.folder / FIRST) == ['# Title', 'speed = 99', 'drive(speed, lights=True)', 'stop()']
    assert backups(copies) == [before]
    kept, = (copies.folder / 'backups').iterdir()
    assert said == (f'The course has changed my_lessons/{FIRST}. Your work is in the new version; the file as it was '
                    f'is now my_lessons/backups/{kept.name}/{FIRST}.')
    assert copies.deliver() == []


def test_a_second_change_of_the_chapter_is_brought_in_too(copies):
    edit(copies.folder / FIRST, 1, 'speed = 99')
    write_chapter(copies.chapters / FIRST, 'speed = 2', 'drive(speed)')
    copies.deliver()
    merged = ['# Title', 'speed = 99', NOTE + '~~~~python\nspeed = 2\n~~~~', 'drive(speed)']
    assert sources(copies.folder / FIRST) == merged
    write_chapter(copies.chapters / FIRST, 'speed = 2', 'stop()')
    copies.deliver()
    assert sources(copies.folder / FIRST) == [*merged[:3], 'stop()']
    assert len(backups(copies)) == 2


def test_an_older_state_saved_over_the_new_version_gets_the_change_once_more(copies):
    """As JupyterLab does when the chapter was open meanwhile, and the learner chooses to overwrite."""
    before = edit(copies.folder / FIRST, 1, 'speed = 99')
    write_chapter(copies.chapters / FIRST, 'speed = 1', 'stop()')
    copies.deliver()
    (copies.folder / FIRST).write_bytes(before)
    copies.deliver()
    assert sources(copies.folder / FIRST) == ['# Title', 'speed = 99', 'stop()']


@pytest.mark.parametrize('trusted', [True, False])
def test_a_merged_notebook_is_as_trusted_as_the_learners_was(copies, trusted):
    edit(copies.folder / FIRST, 1, 'speed = 99')
    notary = NotebookNotary(data_dir=str(copies.trust))
    if trusted:
        notary.sign(nbformat.read(copies.folder / FIRST, as_version=4))
    write_chapter(copies.chapters / FIRST, 'speed = 1', 'stop()')
    copies.deliver()
    assert notary.check_signature(nbformat.read(copies.folder / FIRST, as_version=4)) == trusted
    notary.store.close()


def test_a_deleted_copy_comes_back(copies):
    before = files(copies.folder)
    (copies.folder / FIRST).unlink()
    (copies.folder / 'index.md').unlink()
    assert copies.deliver() == []
    assert files(copies.folder) == before


@pytest.mark.parametrize('content', [
    b'', b'{"cells": [', b'<<<<<<< HEAD\n', b'\xff\xfe', b'[]', b'{}', b'{"cells": 5, "metadata": {}, "nbformat": 4}',
    b'{"cells": [{"cell_type": "code"}], "metadata": {}, "nbformat": 4, "nbformat_minor": 5}', b'[' * 100_000])
def test_a_copy_that_is_no_notebook_any_more_is_kept_aside(copies, content):
    fresh = files(copies.folder)[FIRST]
    (copies.folder / FIRST).write_bytes(content)
    said, = copies.deliver()
    assert said.startswith(f'my_lessons/{FIRST} was not a notebook any more. A fresh copy is in its place;')
    assert (copies.folder / FIRST).read_bytes() == fresh
    assert backups(copies) == [content]


def test_line_ends_of_windows_and_a_byte_order_mark_do_no_harm(copies):
    before = b'\xef\xbb\xbf' + edit(copies.folder / FIRST, 1, 'speed = 99').replace(b'\n', b'\r\n')
    (copies.folder / FIRST).write_bytes(before)
    write_chapter(copies.chapters / FIRST, 'speed = 1', 'stop()')
    copies.deliver()
    assert sources(copies.folder / FIRST) == ['# Title', 'speed = 99', 'stop()']
    assert backups(copies) == [before]


@pytest.mark.parametrize('metadata', [{}, {'param_tutorial': {'version': '0' * 32}}, {'param_tutorial': 7},
                                      {'param_tutorial': {'version': '../../elsewhere'}}])
def test_a_copy_that_does_not_say_its_version_stays_as_it_is(copies, metadata):
    notebook = nbformat.read(copies.folder / FIRST, as_version=4)
    notebook.metadata = metadata
    nbformat.write(notebook, copies.folder / FIRST)
    before = files(copies.folder)
    said, = copies.deliver()
    assert 'does not say which version' in said and 'make reset CHAPTER=01_first' in said
    assert files(copies.folder) == before


def test_a_chapter_that_is_not_a_notebook_is_named_and_the_others_are_delivered(copies):
    """Conflict markers as git leaves them after a merge."""
    before = files(copies.folder)[FIRST]
    (copies.chapters / FIRST).write_text('<<<<<<< HEAD\n')
    write_chapter(copies.chapters / SECOND, 'turn = 2')
    said, = copies.deliver()
    assert said.startswith(f'notebooks/{FIRST} is not a notebook')
    assert files(copies.folder)[FIRST] == before
    assert sources(copies.folder / SECOND) == ['# Title', 'turn = 2']


def test_a_page_that_the_learner_changed_stays_until_the_course_changes_it(copies):
    page = copies.folder / 'index.md'
    page.write_text('# My start')
    assert copies.deliver() == []
    assert page.read_text() == '# My start'
    (copies.chapters / 'index.md').write_text('# New start')
    said, = copies.deliver()
    assert said.startswith('The course has changed my_lessons/index.md.')
    assert page.read_text() == '# New start'
    assert backups(copies, 'index.md') == [b'# My start']


def test_an_untouched_page_follows_the_course(copies):
    (copies.chapters / 'index.md').write_text('# New start')
    assert copies.deliver() == []
    assert (copies.folder / 'index.md').read_text() == '# New start'
    assert backups(copies, 'index.md') == []


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


def test_the_copy_of_a_chapter_that_was_divided_stays_as_it_is(course, copies):
    (copies.folder / FIRST).write_text((copies.folder / FIRST).read_text().replace('speed = 1', 'speed = 2'))
    mine = (copies.folder / FIRST).read_bytes()
    (course / 'notebooks' / FIRST).unlink()
    write_chapter(course / 'notebooks' / '01_1_half.ipynb')
    assert copies.deliver() == []
    assert (copies.folder / FIRST).read_bytes() == mine
    assert (copies.folder / '01_1_half.ipynb').exists()


def test_a_fresh_chapter_is_left_as_it_is(copies):
    assert copies.reset('1') == f'my_lessons/{FIRST} is fresh already.'
    assert backups(copies) == []


def test_a_reset_needs_no_earlier_start(course):
    assert Copies(course).reset('1') == f'my_lessons/{FIRST} is fresh again.'
    assert list(files(course / 'my_lessons')) == [FIRST]


@pytest.mark.parametrize('chapter', ['6', '', '0', '1st', '../01_first', 'conftest', 'solutions/01_first'])
def test_a_chapter_that_is_not_there_is_an_error_that_names_those_that_are(course, capsys, chapter):
    assert command.main([chapter, '--course', str(course)]) == 1
    assert capsys.readouterr().err == f'{chapter!r} is not a chapter. There are: 01_first, 05_1_second\n'


def test_the_number_of_several_chapters_is_an_error_that_names_them(course, capsys):
    write_chapter(course / 'notebooks' / '05_2_third.ipynb')
    assert command.main(['05', '--course', str(course)]) == 1
    assert capsys.readouterr().err == "'05' is the number of several. There are: 05_1_second, 05_2_third\n"


def test_make_reset_says_which_chapter_it_wants():
    done = subprocess.run(['make', '--no-print-directory', '-o', 'setup', 'reset'], cwd=ROOT, capture_output=True,
                          text=True)
    assert done.returncode != 0
    assert done.stderr.splitlines()[0] == 'Which one? make reset CHAPTER=08'


# What goes wrong on the way


@pytest.mark.parametrize(('number', 'told'), [
    (errno.ENOSPC, 'The disk is full'), (errno.EROFS, 'Read-only file system'), (errno.EACCES, 'Permission denied')])
def test_what_the_system_rejects_is_one_sentence_and_changes_no_copy(copies, monkeypatch, number, told):
    edit(copies.folder / FIRST, 1, 'speed = 99')
    write_chapter(copies.chapters / FIRST, 'speed = 2', 'stop()')
    before = files(copies.folder)

    def reject(file: int) -> None:
        raise OSError(number, os.strerror(number), 'the file')

    monkeypatch.setattr(os, 'fsync', reject)
    with pytest.raises(CopiesError, match=told):
        copies.deliver()
    assert files(copies.folder) == before
    assert not [path for path in copies.folder.rglob('*.new')]
    monkeypatch.undo()
    copies.deliver()
    assert sources(copies.folder / FIRST) == ['# Title', 'speed = 99', NOTE + '~~~~python\nspeed = 2\n~~~~', 'stop()']


def test_a_file_in_the_place_of_the_folder_is_named(course):
    (course / 'my_lessons').touch()
    with pytest.raises(CopiesError, match=r'my_lessons could not be brought up to date.*File exists'):
        Copies(course).deliver()


def start(course: Path, code: str) -> subprocess.Popen[str]:
    """Start Python with `copies` for this course."""
    code = f'from pathlib import Path\nfrom param_tutorial.learner.copies import Copies\n' \
           f'copies = Copies(Path({str(course)!r}))\n{code}'
    return subprocess.Popen([sys.executable, '-c', code], text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)


# The steps are the moments right before and right after a file is moved to its place.
KILL = '''
import itertools, os, signal
def kill_at(number):
    steps, replace = itertools.count(1), Path.replace
    def step():
        if next(steps) == number:
            os.kill(os.getpid(), signal.SIGKILL)
    def replace_between_steps(self, target):
        step()
        replace(self, target)
        step()
    Path.replace = replace_between_steps
'''


@pytest.mark.slow
@pytest.mark.thorough
def test_a_delivery_that_is_killed_anywhere_is_made_up_for_by_the_next(tmp_path):
    """Each time one step later, until a delivery comes to its end."""
    for killed_at in range(1, 100):
        course = tmp_path / str(killed_at)
        write_course(course)
        copies = Copies(course)
        copies.deliver()
        before = edit(copies.folder / FIRST, 1, 'speed = 99')
        write_chapter(copies.chapters / FIRST, 'speed = 2', 'stop()')
        write_chapter(copies.chapters / SECOND, 'turn = 2')
        with start(course, f'{KILL}\nkill_at({killed_at})\ncopies.deliver()') as process:
            process.communicate()
        copy = copies.folder / FIRST
        assert copy.read_bytes() == before or before in backups(copies)
        copies.deliver()
        assert sources(copy) == ['# Title', 'speed = 99', NOTE + '~~~~python\nspeed = 2\n~~~~', 'stop()']
        assert sources(copies.folder / SECOND) == ['# Title', 'turn = 2']
        assert before in backups(copies)
        if process.returncode == 0:
            break
        assert process.returncode == -signal.SIGKILL
    assert process.returncode == 0 and killed_at > 8


def test_the_chapters_have_a_check_for_each_exercise_that_is_known(monkeypatch):
    """The ticks at a delivery go by the cells in the chapters, those after a check by the exercises themselves."""
    found = []
    monkeypatch.setattr(ticks, 'tick', lambda folder, exercises, solved: found.append(exercises))
    Copies(ROOT).tick()
    assert {name: numbers for name, numbers in found[0].items() if numbers} == {
        chapter.name: [each.number for each in chapter.exercises] for chapter in CHAPTERS.values()}


@pytest.mark.slow
def test_of_two_deliveries_at_once_one_waits_for_the_other(copies):
    before = edit(copies.folder / FIRST, 1, 'speed = 99')
    write_chapter(copies.chapters / FIRST, 'speed = 2', 'stop()')
    folder = os.open(copies.folder, os.O_RDONLY)
    fcntl.flock(folder, fcntl.LOCK_EX)
    processes = [start(copies.folder.parent, 'copies.deliver()') for _ in range(2)]

    def waiting() -> bool:
        blocked = [line.split() for line in Path('/proc/locks').read_text().splitlines() if '-> FLOCK' in line]
        return all(any(str(process.pid) in words for words in blocked) for process in processes)

    try:
        wait_for(waiting, 'both to wait for the lock')
        assert (copies.folder / FIRST).read_bytes() == before
    finally:
        os.close(folder)
        said = [process.communicate()[1] for process in processes]
    assert said == ['', '']
    assert sources(copies.folder / FIRST) == ['# Title', 'speed = 99', NOTE + '~~~~python\nspeed = 2\n~~~~', 'stop()']
    assert backups(copies) == [before]


some_text = st.sampled_from(['speed = 1', 'speed = 2', 'speed = 99', 'stop()', ''])
# How many files can be written before the disk is full.
some_room = st.one_of(st.just(1000), st.integers(0, 6))


class NothingIsEverLost(RuleBasedStateMachine):
    """A learner, a course that changes, and a disk that fills up, in any order."""

    def __init__(self) -> None:
        super().__init__()
        self._course = tempfile.TemporaryDirectory()
        self.copies = Copies(Path(self._course.name))
        write_course(Path(self._course.name))
        self.copies.deliver()

    def teardown(self) -> None:
        self._course.cleanup()

    @rule(texts=st.lists(some_text, max_size=3), name=st.sampled_from([FIRST, SECOND]))
    def the_course_changes(self, texts: list[str], name: str) -> None:
        write_chapter(self.copies.chapters / name, *texts)

    @rule(text=some_text)
    def a_page_changes(self, text: str) -> None:
        (self.copies.chapters / 'index.md').write_text(text)

    @rule(name=st.sampled_from([FIRST, SECOND]), number=st.integers(0, 2), text=some_text)
    def the_learner_changes_a_cell(self, name: str, number: int, text: str) -> None:
        path = self.copies.folder / name
        if path.exists() and (copy := self._read(path)) and number < len(copy.cells):
            edit(path, number, text)

    @rule(name=st.sampled_from([FIRST, 'index.md', 'own.ipynb']), content=st.sampled_from([b'', b'mine', b'{"cells":']))
    def the_learner_writes_a_file(self, name: str, content: bytes) -> None:
        (self.copies.folder / name).write_bytes(content)

    @rule(name=st.sampled_from([FIRST, SECOND, 'index.md']))
    def the_learner_deletes_a_file(self, name: str) -> None:
        (self.copies.folder / name).unlink(missing_ok=True)

    @rule(full_after=some_room)
    def make_lab(self, full_after: int) -> None:
        self._and_nothing_is_lost(self.copies.deliver, full_after)

    @rule(chapter=st.sampled_from(['1', '5.1']), full_after=some_room)
    def make_reset(self, chapter: str, full_after: int) -> None:
        self._and_nothing_is_lost(lambda: self.copies.reset(chapter), full_after)

    def _and_nothing_is_lost(self, work: Callable[[], object], full_after: int) -> None:
        before = set(files(self.copies.folder).values())
        writes, real = iter(range(full_after)), os.fsync

        def fill_up(file: int) -> None:
            if next(writes, None) is None:
                raise OSError(errno.ENOSPC, 'No space left on device')
            real(file)

        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(os, 'fsync', fill_up)
            try:
                work()
            except CopiesError as error:
                assert 'The disk is full' in str(error)
        delivered = {path.read_bytes() for path in (self.copies.folder / '.delivered').glob('*')}
        assert before - set(files(self.copies.folder).values()) <= delivered

    @staticmethod
    def _read(path: Path) -> nbformat.NotebookNode | None:
        try:
            return nbformat.read(path, as_version=4)
        except (ValueError, AttributeError):
            return None


NothingIsEverLost.TestCase.settings = settings(max_examples=60, stateful_step_count=12)
TestNothingIsEverLost = pytest.mark.slow(NothingIsEverLost.TestCase)
