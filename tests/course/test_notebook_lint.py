"""The notebook lint: a sound notebook passes, and each rule can fail."""

import copy

import nbformat
import pytest

from tests.tools import notebook_lint


def markdown(source):
    return nbformat.v4.new_markdown_cell(source)


def code(source, count, outputs=(), tags=(), **metadata):
    if tags:
        metadata['tags'] = list(tags)
    return nbformat.v4.new_code_cell(source, execution_count=count, outputs=list(outputs), metadata=metadata)


def printed(text):
    return nbformat.v4.new_output('stream', name='stdout', text=text)


def raised(name='ValueError'):
    return nbformat.v4.new_output('error', ename=name, evalue='no', traceback=[name])


def sound_cells():
    return [
        markdown('# Title\n\nA question.\n\n## First step'),
        code('print(1)', 1, [printed('1\n')]),
        markdown('That was it. See [the other](other.md#Its-part) and [the web](https://docs.ros.org).'),
        code('1 + 1', 2),
    ]


@pytest.fixture
def problems_of(tmp_path):
    (tmp_path / 'other.md').write_text('# Other\n\n## Its part\n')

    def check(cells, kernel='python3', name='lesson.ipynb'):
        notebook = nbformat.v4.new_notebook(cells=cells)
        notebook.metadata['kernelspec'] = {'name': kernel, 'display_name': 'Python 3', 'language': 'python'}
        path = tmp_path / name
        nbformat.write(notebook, path)
        return [f'{problem.cell}: {problem.text}' for problem in notebook_lint.check_file(path)]

    return check


def test_a_sound_notebook_passes(problems_of):
    assert problems_of(sound_cells()) == []


@pytest.mark.parametrize(
    ('cell', 'where', 'words'),
    [
        pytest.param(code('1', None), 5, 'was not run', id='not run'),
        pytest.param(code('1', 7), 5, 'run as [7] and not as [3]', id='out of order'),
        pytest.param(code('1', 3, [raised()]), 5, 'ends in ValueError', id='error'),
        pytest.param(code('1', 3, tags=['raises-exception']), 5, 'raised none', id='intended error missing'),
        pytest.param(code('1', 3, tags=['nbval-skip']), 5, 'says no reason', id='skipped by tag'),
        pytest.param(code('# NBVAL_IGNORE_OUTPUT\n1', 3), 5, 'says no reason', id='ignored by comment'),
        pytest.param(code('1', 3, tags=['nbval-skip']), 0, '1 of 3 code cells', id='too many not compared'),
        pytest.param(code('open("/home/ada/a.yaml")', 3), 5, 'path of one machine', id='path in source'),
        pytest.param(code('1', 3, [printed('in /tmp/abc')]), 5, 'path of one machine', id='path in output'),
        pytest.param(code('1\n\n', 3), 5, 'ends with blanks', id='blank lines'),
        pytest.param(code('', 3), 5, 'is empty', id='empty code'),
        pytest.param(markdown('  \n'), 5, 'is empty', id='empty prose'),
        pytest.param(markdown('# Another title'), 5, 'another heading of level 1', id='two titles'),
        pytest.param(markdown('#### Deep'), 5, 'jumps from level 2 to level 4', id='heading jumps'),
        pytest.param(markdown('[next](nowhere.ipynb)'), 5, 'there is no nowhere.ipynb', id='dead link'),
        pytest.param(markdown('[next](other.md#Missing)'), 5, 'no heading of that name', id='dead anchor'),
        pytest.param(markdown('[up](#Missing)'), 5, 'no heading of that name', id='dead anchor here'),
        pytest.param(markdown('![A panel](panel.png)'), 5, 'there is no panel.png', id='dead image'),
        pytest.param(markdown('![ ](other.md)'), 5, 'no alternative text', id='image without alt'),
        pytest.param(markdown('<img src="other.md" alt="">'), 5, 'no alternative text', id='html image without alt'),
        pytest.param(markdown('x' * 301_000), 0, 'at most 300 kB', id='too large'),
    ],
)
def test_each_rule_can_fail(problems_of, cell, where, words):
    found = problems_of([*sound_cells(), cell])
    assert any(problem.startswith(f'{where}: ') and words in problem for problem in found), found


@pytest.mark.parametrize(
    'cell',
    [
        pytest.param(code('1', 3, [raised()], tags=['raises-exception']), id='intended error'),
        pytest.param(markdown('### Deeper\n\n## Up again'), id='headings go up by any number'),
        pytest.param(markdown('```\n# not a heading\n[not](a_link)\n```\nand `[this](neither)`'), id='code in prose'),
        pytest.param(markdown('<img src="other.md" alt="A panel">'), id='html image with alt'),
        pytest.param(markdown('[up](#First-step)'), id='anchor here'),
        pytest.param(code('"share/tmp/x"', 3), id='path that only contains such a name'),
    ],
)
def test_what_the_rules_allow(problems_of, cell):
    assert problems_of([*sound_cells(), cell]) == []


@pytest.mark.parametrize(
    'skipped',
    [
        code('# Not compared: the time.\n# NBVAL_IGNORE_OUTPUT\n1', 10),
        code('1', 10, tags=['nbval-skip'], nbval_reason='the time'),
    ],
)
def test_one_cell_in_ten_may_be_left_out_with_a_reason(problems_of, skipped):
    cells = [markdown('# Title')]
    for count in range(1, 10):
        cells += [code('1', count), markdown('Prose.')]
    assert problems_of([*cells, skipped]) == []
    second = copy.deepcopy(skipped)
    second.id = 'second'
    assert any('2 of 11 code cells' in problem for problem in problems_of([*cells, skipped, second]))


def test_the_fifth_code_cell_in_a_row_is_rejected(problems_of):
    cells = [markdown('# Title'), *(code('1', count) for count in range(1, 5))]
    assert problems_of(cells) == []
    assert problems_of([*cells, code('1', 5)]) == ['6: is the fifth code cell in a row: say something after at most 4.']


def test_the_title_comes_first(problems_of):
    assert any('must start with the title' in problem for problem in problems_of([code('1', 1), markdown('# Late')]))
    assert '0: has no title, a heading of level 1.' in problems_of([markdown('Prose.')])


def test_the_kernel_is_python3(problems_of):
    assert any('must name the kernel python3' in problem for problem in problems_of(sound_cells(), kernel='mine'))


def test_what_is_no_notebook_is_named(tmp_path):
    for text in ('not json', '{"cells": []}', '{"cells": [{}], "metadata": {}, "nbformat": 4, "nbformat_minor": 5}'):
        (tmp_path / 'broken.ipynb').write_text(text)
        (problem,) = notebook_lint.check_file(tmp_path / 'broken.ipynb')
        assert 'is not a valid notebook' in str(problem)


def test_the_command_names_notebook_and_cell(tmp_path, capsys):
    nbformat.write(nbformat.v4.new_notebook(cells=[markdown('# Title'), code('1', None)]), tmp_path / 'a.ipynb')
    assert notebook_lint.main([str(tmp_path)]) == 1
    assert f'{tmp_path / "a.ipynb"}: cell 2: was not run' in capsys.readouterr().out


def test_checkpoints_are_left_out(tmp_path):
    (tmp_path / '.ipynb_checkpoints').mkdir()
    (tmp_path / '.ipynb_checkpoints' / 'a-checkpoint.ipynb').write_text('old')
    assert notebook_lint.main([str(tmp_path)]) == 0
