"""Parameter files saved from a panel and loaded into one, with a look at what that would do; without a browser."""

import html
from pathlib import Path

import pytest
from rcl_interfaces.msg import SetParametersResult

from param_tools import values
from param_tools.errors import NodeNotFoundError, ParameterFileError
from param_tools.files import parameter_files
from param_tools.node.client import ParameterClient
from param_tools.panel.panel import ParameterPanel
from param_tools.ros.waiting import wait_until
from param_tools.systems.restoring import MAY_BE_TAKEN
from tests.support.nodes import Band
from tests.support.widgets import enter, says

NODE = '/arm'
MIXED = '''
/arm:
  ros__parameters:
    tool: drill
    joints: 9
    tol: x
    gains: {kp: 0.4}
    reach: 7.5
    model: B
    serial: 1.5
    offset: 0.5
/other:
  ros__parameters: {a: 1, b: 2}
'''


@pytest.fixture(autouse=True)
def _folder(tmp_path, monkeypatch):
    """Files are relative to an empty folder with a config/ in it."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / 'config').mkdir()
    return tmp_path


def write(path, text):
    Path(path).write_text(text)
    return path


def ask_form(panel, do, *, is_save, path='', changed_only=False):
    """Do what the browser does when someone uses the form, and return what the kernel sends back."""
    sent = []
    panel._front.send = sent.append
    panel._front._handle_custom_msg(
        {'do': do, 'is_save': is_save, 'path': path, 'changed_only': changed_only, 'client': 'test', 'number': 7}, [])
    wait_until(lambda: sent, 'the answer')
    assert (sent[0]['client'], sent[0]['form']) == ('test', 7)
    return sent[0]


def test_what_is_saved_comes_back(arm):
    first = ParameterClient(NODE).get_parameters()
    dump = arm.save('config/arm.yaml')
    assert set(dump.left_out) == {'calibrated_at', 'firmware'}
    for name, text in (('tool', 'saw'), ('offset', '2'), ('order', '[7]')):
        enter(arm, name, text)
    loaded = arm.load('config/arm.yaml')
    assert (loaded, set(loaded.names)) == ({}, {'tool', 'offset', 'order'})
    now = ParameterClient(NODE).get_parameters()
    assert [name for name in first if not values.same(first[name], now[name])] == []


def test_only_what_has_changed_is_saved_on_request(arm):
    with pytest.raises(ParameterFileError, match='no parameter of /arm differs from its first value'):
        arm.save('config/arm.yaml', changed_only=True)
    assert not Path('config/arm.yaml').exists()
    enter(arm, 'gains.kp', '0.6')  # still on its way
    arm.save('config/arm.yaml', changed_only=True)
    assert parameter_files.read('config/arm.yaml', NODE) == {'gains.kp': 0.6}


def test_what_cannot_be_written_leaves_everything_as_it_was(arm):
    for path in ('config', 'none/arm.yaml'):
        with pytest.raises(OSError, match='the parameters were not written'):
            arm.save(path)
    assert list(Path().rglob('*')) == [Path('config')]


def test_a_preview_says_what_becomes_of_each_value_and_changes_nothing(arm):
    preview = arm.preview(write('config/mixed.yaml', MIXED))
    assert {row.name: row.verdict for row in preview} == {
        'tool': 'changes', 'joints': 'changes', 'tol': 'not declared', 'gains.kp': 'off the step',
        'reach': 'out of range',
        'model': 'read-only', 'serial': 'wrong type', 'offset': 'same', 'a': 'not for this node',
        'b': 'not for this node'}
    assert (preview['tool'].now, preview['tool'].wanted) == ('gripper', 'drill')
    assert preview['tol'].reason == f'{MAY_BE_TAKEN}. Did you mean tool?'
    assert preview.summary == '2 values will change, 1 the same, 5 will not be loaded, 2 for other nodes'
    assert 'reach' in repr(preview) and '<td>out of range</td>' in preview._repr_html_()
    arm.settle()
    assert arm.changed == {}


def test_what_a_preview_says_is_what_the_node_says(arm):
    """The node rejects each value that the form objects to, and accepts each other one."""
    preview = arm.preview(write('config/mixed.yaml', MIXED))
    client = ParameterClient(NODE)
    for row in preview:
        if row.verdict not in ('not for this node', 'same'):
            assert client.set_parameter(row.name, row.wanted).successful == (row.verdict == 'changes'), row


def test_a_load_is_one_edit_and_says_what_was_left_out(arm):
    loaded = arm.load(write('config/mixed.yaml', MIXED))
    assert loaded.names == ('tool', 'joints')
    assert set(loaded) == {'tol', 'gains.kp', 'reach', 'model', 'serial'}
    assert loaded['reach'] == 'out of range: 7.5 is not between 0.01 and 2.0'
    assert ParameterClient(NODE).get_parameters(['tool', 'joints']) == {'tool': 'drill', 'joints': 9}
    arm.undo()
    assert arm.not_restored == {}
    assert (arm.changed, arm._front.state['undo']) == ({}, False)
    arm.redo()
    assert arm.not_restored == {}
    assert (arm['tool'].value, arm['joints'].value) == ('drill', 9)


def test_a_rule_across_parameters_is_met_by_the_file_as_a_whole(ros):
    ros.add(Band).add_on_set_parameters_callback(lambda parameters: SetParametersResult(
        successful=all(each.value != 'bad' for each in parameters), reason='bad'))
    panel = ParameterPanel('/band')
    loaded = panel.load(write('band.yaml', 'band:\n  ros__parameters: {low: 10, high: 20}'))
    assert (loaded, loaded.names) == ({}, ('low', 'high'))
    # Where the whole is rejected, each value stands for itself, in whichever order works; undo takes it back at once.
    loaded = panel.load(write('bad.yaml', 'band:\n  ros__parameters: {low: 30, high: 40, name: bad}'))
    assert (loaded, set(loaded.names)) == ({'name': 'bad'}, {'low', 'high'})
    assert says(panel, 'name') == ('rejected', 'bad')
    panel.undo()
    assert panel.not_restored == {}
    assert (panel['low'].value, panel['high'].value) == (10, 20)


def test_while_changes_are_gathered_a_file_is_gathered_too(arm):
    arm.gather()
    loaded = arm.load(write('config/mixed.yaml', MIXED))
    assert loaded.is_gathered and 'model' in loaded
    assert arm.gathered == {'tool': 'drill', 'joints': 9}
    assert arm.apply() == ''
    assert (arm['tool'].value, arm['joints'].value) == ('drill', 9)


@pytest.mark.parametrize(('text', 'words'), [
    ('/arm:\n  ros__parameters:\n    tool: &a x\n    other: *a\n', 'line 4: ROS reads no aliases'),
    ('/arm:\n  tool: x\n', 'line 2'),
    ('/arm:\n  ros__parameters:\n    tool:\n', 'tool has no value'),
    ('{', 'this is not YAML'),
])
def test_a_file_that_rcl_would_reject_changes_nothing_and_is_said_with_its_line(arm, text, words):
    path = write('config/bad.yaml', text)
    for look in (arm.preview, arm.load):
        with pytest.raises(ParameterFileError, match=words):
            look(path)
    answer = ask_form(arm, 'look', is_save=False, path=path)
    assert not answer['can'] and words in answer['markup']
    assert arm.changed == {}


@pytest.mark.slow
def test_a_load_into_a_node_that_is_gone_says_so(ros, arm):
    ros.remove_all()
    wait_until(lambda: arm.status, 'the panel to miss the node')
    path = write('config/mixed.yaml', MIXED)
    with pytest.raises(NodeNotFoundError, match='there is no node /arm'):
        arm.load(path)
    assert 'there is no node /arm' in ask_form(arm, 'act', is_save=False, path=path)['said']
    # What it had last can still be saved.
    arm.save('config/last.yaml')
    assert parameter_files.read('config/last.yaml', NODE)['tool'] == 'gripper'


def test_a_panel_of_some_parameters_saves_and_loads_those(ros, arm):
    some = ParameterPanel(NODE, names=['tool', 'joints'])
    some.save('config/some.yaml')
    assert parameter_files.read('config/some.yaml', NODE) == {'tool': 'gripper', 'joints': 5}
    row = some.preview(write('a.yaml', 'arm:\n  ros__parameters: {offset: 1.0}'))['offset']
    assert (row.verdict, row.reason.partition('.')[0]) == ('not shown', 'this panel shows no such parameter')


# -- the form -------------------------------------------------------------------------------------------


def test_the_form_shows_what_loading_would_do_and_then_what_it_did(arm):
    path = write('config/<mixed>.yaml', MIXED)
    answer = ask_form(arm, 'look', is_save=False, path=path)
    assert answer['can'] and answer['button'] == 'Load'
    assert '2 values will change, 1 the same' in answer['markup']
    assert '2 values for /other: not for this node.' in answer['markup']
    names = [part.partition('<')[0] for part in answer['markup'].split('<th scope="row">')[1:]]
    assert names[:2] == ['tool', 'joints'], 'what will change stands first'
    assert 'offset' not in names
    said = ask_form(arm, 'act', is_save=False, path=path)['said']
    assert '2 values of config/&lt;mixed&gt;.yaml loaded.' in said
    assert 'Not loaded: model, read-only: only an override at the start of the node can set it.' in said
    assert arm['tool'].value == 'drill'


def test_the_form_says_what_saving_would_replace(arm):
    path = write('config/mixed.yaml', MIXED)
    answer = ask_form(arm, 'look', is_save=True, path=path)
    assert (answer['can'], answer['button']) == (True, 'Replace')
    assert 'Its parameters for /other would be lost.' in answer['markup']
    assert '20 values of /arm will be written to ' in answer['markup']
    assert 'Left out: firmware, a parameter file has no byte arrays.' in answer['markup']
    for wrong, words in (('config', 'config is a folder'), ('no/a.yaml', 'there is no folder no')):
        answer = ask_form(arm, 'look', is_save=True, path=wrong)
        assert words in answer['markup'] and not answer['can']
    enter(arm, 'tool', 'saw')
    arm.settle()
    assert ask_form(arm, 'look', is_save=True, path='config/new.yaml', changed_only=True)['button'] == 'Save'
    assert 'Saved to config/new.yaml.' in ask_form(
        arm, 'act', is_save=True, path='config/new.yaml', changed_only=True)['said']
    assert parameter_files.read('config/new.yaml', NODE) == {'tool': 'saw'}


def test_the_form_suggests_a_file_and_offers_nothing_but_parameter_files(arm):
    write('.pre-commit.yaml', 'repos: []')
    answer = ask_form(arm, 'look', is_save=True, path='')
    assert (answer['suggested'], answer['offered']) == ('arm.yaml', [])
    # Without an ending it would not be offered.
    assert f'will be written to {Path("tuned.yaml").resolve()}.' in ask_form(
        arm, 'look', is_save=True, path='tuned')['markup']
    assert 'Saved to tuned.yaml.' in ask_form(arm, 'act', is_save=True, path='tuned')['said']
    assert ask_form(arm, 'look', is_save=False, path='')['offered'] == ['tuned.yaml']


@pytest.mark.parametrize('is_save', [True, False])
def test_the_form_says_what_is_wrong_with_a_path(arm, is_save):
    path, words = '~nobody_of_that_name/a.yaml', 'begins with a user that this machine does not have'
    answer = ask_form(arm, 'look', is_save=is_save, path=path)
    assert words in html.unescape(answer['markup']) and not answer['can']
    assert words in html.unescape(ask_form(arm, 'act', is_save=is_save, path=path)['said'])
