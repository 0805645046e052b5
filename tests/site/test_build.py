"""However a build ends, it leaves one complete site."""

import shutil

import pytest

from param_tutorial.site import replacing


def test_the_old_site_stays_until_the_new_one_is_whole(tmp_path, monkeypatch):
    for name in ('html', 'work'):
        (tmp_path / name).mkdir()
        (tmp_path / name / f'{name}.html').touch()

    def run_out_of_room(_, target, **__):
        target.mkdir()
        raise OSError('no room')

    with monkeypatch.context() as patched, pytest.raises(OSError, match='no room'):
        patched.setattr(shutil, 'copytree', run_out_of_room)
        replacing.replace(tmp_path / 'work', tmp_path / 'html')
    assert (tmp_path / 'html' / 'html.html').exists()
    replacing.replace(tmp_path / 'work', tmp_path / 'html')
    assert [path.name for path in (tmp_path / 'html').iterdir()] == ['work.html']
    assert {path.name for path in tmp_path.iterdir()} == {'html', 'work'}
