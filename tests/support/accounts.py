"""Accounts that some processes see and the rest of this machine does not: a mount namespace, as the kernel has them.

They sign in with PAM, and own files and processes like any other. Their /etc/passwd is a copy with them in it, and
their /etc/shadow has nobody else's password.
"""

import os
import subprocess
from collections.abc import Iterable
from pathlib import Path
from shlex import quote

# Where Linux distributions give accounts to people, and hardly any machine has as many.
_FIRST_NUMBER = 58_000


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
    mounts = [f'mount --bind {quote(str(folder / name))} /etc/{name}' for name in ('passwd', 'shadow')]
    # In place of a folder that is closed to others, one that is open and has in it what they need.
    closed: dict[Path, list[Path]] = {}
    for path in needed:
        for above in reversed(path.parents):
            if not above.stat().st_mode & 0o001:
                closed.setdefault(above, []).append(path)
                break
    for number, (above, paths) in enumerate(closed.items()):
        kept = folder / str(number)
        kept.mkdir()
        mounts += [f'mount --bind {quote(str(above))} {quote(str(kept))}',
                   f'mount -t tmpfs -o mode=755 none {quote(str(above))}']
        for path in paths:
            mounts += [f'mkdir -p {quote(str(path))}',
                       f'mount --bind {quote(str(kept / path.relative_to(above)))} {quote(str(path))}']
    return ['unshare', '--mount', 'sh', '-ec', '\n'.join([*mounts, 'exec "$@"']), 'sh', *words]
