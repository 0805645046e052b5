"""Accounts that some processes see and the rest of this machine does not: a mount namespace, as the kernel has them.

They sign in with PAM, and own files and processes like any other. Their /etc/passwd is a copy with them in it, and
their /etc/shadow has nobody else's password.
"""

import os
import subprocess
from collections.abc import Iterable
from pathlib import Path

# Where Linux distributions give accounts to people, and hardly any machine has as many.
_FIRST_NUMBER = 58_000
# The first argument says where files may be kept.
_SCRIPT = '''
set -eu
folder=$1
shift
mount --bind "$folder/passwd" /etc/passwd
mount --bind "$folder/shadow" /etc/shadow
# In place of a folder that is closed to others, one that is open and has in it what they need.
while read -r number closed; do
    mount --bind "$closed" "$folder/$number"
    mount -t tmpfs -o mode=755 none "$closed"
    while read -r of path; do
        if [ "$of" = "$number" ]; then
            mkdir -p "$path"
            mount --bind "$folder/$number/${path#"$closed/"}" "$path"
        fi
    done < "$folder/needed"
done < "$folder/closed"
exec "$@"
'''


def why_none() -> str | None:
    """Return why no accounts can be made here, or None."""
    if os.geteuid() != 0:
        return 'not root'
    done = subprocess.run(['unshare', '--mount', 'mount', '-t', 'tmpfs', 'none', '/mnt'], capture_output=True,
                          text=True)
    return done.stderr.strip() if done.returncode != 0 else None


def command(words: Iterable[str | Path], folder: Path, homes: Path, names: Iterable[str], password_hash: str,
            needed: Iterable[Path]) -> list[str | Path]:
    """Return a command that runs this one with some accounts more.

    :param folder: For files of this function's; others have no business in it.
    :param homes: Where the accounts' home folders are made.
    :param names: Of the accounts.
    :param password_hash: Of the password of each, as in /etc/shadow.
    :param needed: Folders that the accounts may enter, none inside another.
    """
    passwd, shadow = Path('/etc/passwd').read_text(), ''
    for number, name in enumerate(names, _FIRST_NUMBER):
        home = homes / name
        home.mkdir(parents=True)
        os.chown(home, number, number)
        passwd += f'{name}:x:{number}:{number}::{home}:/bin/bash\n'
        shadow += f'{name}:{password_hash}:20000:0:99999:7:::\n'
    (folder / 'passwd').write_text(passwd)
    (folder / 'passwd').chmod(0o644)
    (folder / 'shadow').write_text(shadow)
    (folder / 'shadow').chmod(0o600)
    closed: list[Path] = []
    entries = []
    for path in needed:
        above = next((each for each in reversed(path.parents) if not each.stat().st_mode & 0o001), None)
        if above is None:
            continue
        if above not in closed:
            (folder / str(len(closed))).mkdir()
            closed.append(above)
        entries.append(f'{closed.index(above)} {path}\n')
    (folder / 'closed').write_text(''.join(f'{number} {path}\n' for number, path in enumerate(closed)))
    (folder / 'needed').write_text(''.join(entries))
    return ['unshare', '--mount', 'sh', '-c', _SCRIPT, 'sh', folder, *words]
