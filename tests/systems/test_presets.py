"""Presets: snapshots in a folder, saved, listed, read, renamed and deleted."""

import datetime
import math
from pathlib import Path

import pytest

from param_tools.errors import NodeNotFoundError, ParameterFileError
from param_tools.node.client import ParameterValues
from param_tools.systems.presets import Presets
from param_tools.systems.snapshot import Snapshot


@pytest.fixture
def presets(tmp_path):
    return Presets(tmp_path / 'presets')


def snapshot(value, hour=12):
    return Snapshot({'/arm': ParameterValues({'speed': value, 'names': [], 'key': [b'\0']})}, {},
                    datetime.datetime(2026, 11, 27, hour, 30).astimezone())


def test_a_preset_is_a_snapshot_in_the_folder(presets):
    assert presets.all() == []
    left = presets.save('calm', snapshot(math.inf, 12))
    assert set(left) == {'/arm: names', '/arm: key'}
    presets.save('brisk.yaml', snapshot(1.5, 11))
    (presets.folder / 'by_hand.yaml').write_text('/arm:\n  ros__parameters: {speed: 1.0}\n')
    assert [(each.name, f'{each.taken:%H:%M}', each.holds) for each in presets.all()] == [
        ('calm', '12:30', '1 node'), ('brisk', '11:30', '1 node')]
    assert presets.read('calm') == {'/arm': {'speed': math.inf, 'names': []}}
    assert Snapshot.from_file(presets.folder / 'brisk.yaml')['/arm']['speed'] == 1.5


def test_a_preset_is_replaced_renamed_and_deleted(presets):
    presets.save('calm', snapshot(1.5))
    presets.save('calm', snapshot(2.5))
    assert presets.read('calm')['/arm']['speed'] == 2.5
    presets.save('other', snapshot(3.5))
    with pytest.raises(ParameterFileError, match=r'other\.yaml is there already: choose another name'):
        presets.rename('calm', 'other')
    presets.rename('calm', 'tuned')
    presets.delete('other')
    assert [each.name for each in presets.all()] == ['tuned']
    for lost in (presets.delete, presets.read, lambda name: presets.rename(name, 'x')):
        with pytest.raises(ParameterFileError, match=r'there is no preset other in .* any more'):
            lost('other')


@pytest.mark.parametrize('name', ['', ' ', '../calm', '/tmp/calm', '.calm', '~\0', 'two\nlines'])
def test_no_name_leads_out_of_the_folder(presets, name):
    with pytest.raises(ParameterFileError, match='is no name for a preset'):
        presets.save(name, snapshot(1.5))
    assert list(Path(presets.folder.parent).rglob('*.yaml')) == []


def test_a_file_that_is_no_snapshot_is_left_alone(presets):
    presets.folder.mkdir()
    by_hand = presets.folder / 'arm.yaml'
    by_hand.write_text('# Tuned with care\n')
    for harm in (lambda: presets.save('arm', snapshot(1.5)), lambda: presets.delete('arm'),
                 lambda: presets.rename('arm', 'x')):
        with pytest.raises(ParameterFileError):
            harm()
    assert by_hand.read_text() == '# Tuned with care\n'


def test_what_no_node_has_answered_is_not_saved(presets):
    with pytest.raises(ParameterFileError, match='there is no node /gone'):
        presets.save('none', Snapshot({}, {'/gone': NodeNotFoundError('/gone', [])}))
    with pytest.raises(ParameterFileError, match='there are no nodes to save'):
        presets.save('none', Snapshot({}, {}))
