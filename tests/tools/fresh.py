"""Run README's two commands, and the chapters, on a fresh Debian without a compiler. `make test-fresh` runs this.

    python -m tests.tools.fresh [stable testing]

debootstrap makes each of these systems in a folder of its own, which takes root's rights; nothing of it stays. There,
somebody without any rights clones the course to a path with a space and a letter that is not ASCII, `make lab` has to
come up, and then the chapters run on the system's own Python, and the tests that need no browser and no minutes.
"""

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from tests.support.paths import ROOT

SYSTEMS = ('stable', 'testing')
PACKAGES = 'python3,python3-venv,make,git,ca-certificates,procps'
# What leads out of this machine, and says whom to trust.
SHARED = ('etc/resolv.conf', 'etc/hosts', 'etc/ssl/certs/ca-certificates.crt')
VARIABLES = ('PIP_CERT', 'PIP_DEFAULT_TIMEOUT', 'PIP_INDEX_URL', 'SSL_CERT_FILE', 'UV_DEFAULT_INDEX', 'http_proxy',
             'https_proxy', 'no_proxy')
# Mounts that end with the processes that see them.
MOUNTED = ['unshare', '--mount', '--pid', '--fork', '--kill-child', 'sh', '-ec', '''
mount -t proc proc "$0/proc"; mount -t sysfs sysfs "$0/sys"; mount --rbind /dev "$0/dev"
exec chroot "$0" su learner --shell /bin/bash --command "$1"''']
COMMANDS = '''
set -em  # each job is a group of processes
cd
git clone --quiet /course.git 'Kurs für alle'
cd 'Kurs für alle'
! command -v cc c++ gcc
make lab ARGS='--no-browser --port 0' > ~/lab 2>&1 &
for second in $(seq 600); do
    grep -q 'http://127.0.0.1' ~/lab && break
    kill -0 $! || break
    sleep 1
done
grep -m 1 -o 'http://127.0.0.1:[0-9]*/lab/tree/index.md' ~/lab || { cat ~/lab; exit 1; }
kill -TERM -$!
wait || true
make setup-all
.venv/bin/python --version
.venv/bin/python -m pytest -q -n 4 --dist loadscope --no-loadscope-reorder --nbval -m 'not slow' \\
    tests/nodes tests/files tests/node tests/systems tests/ros tests/widgets tests/views tests/notebook tests/cli \\
    tests/exercises notebooks
'''


def mirror() -> str:
    """Return the address from which this system has its packages."""
    listed = subprocess.run(['apt-get', 'indextargets', '--format', '$(REPO_URI)', 'Origin: Debian', 'Label: Debian'],
                            capture_output=True, text=True, check=True).stdout
    return listed.split()[0]


def try_on(system: str, folder: Path) -> bool:
    """Make a system in an empty folder, and return whether all went well there."""
    subprocess.run(['debootstrap', '--variant=minbase', f'--include={PACKAGES}', system, folder, mirror()],
                   stdout=subprocess.DEVNULL, check=True)
    for path in SHARED:
        shutil.copyfile(Path('/', path), folder / path)
    subprocess.run(['git', 'clone', '--quiet', '--bare', ROOT, folder / 'course.git'], check=True)
    subprocess.run(['chroot', folder, 'useradd', '--create-home', 'learner'], check=True)
    subprocess.run(['chroot', folder, 'chown', '--recursive', 'learner', '/course.git'], check=True)
    environment = {name: os.environ[name] for name in VARIABLES if name in os.environ}
    return subprocess.run([*MOUNTED, folder, COMMANDS], env={**environment, 'PATH': os.environ['PATH'],
                                                             'LANG': 'C.UTF-8'}, check=False).returncode == 0


def main(systems: list[str]) -> int:
    if os.geteuid() or not shutil.which('debootstrap'):
        print("This needs Debian's debootstrap, and root's rights.", file=sys.stderr)
        return 2
    failed = []
    for system in systems or SYSTEMS:
        with tempfile.TemporaryDirectory() as folder:
            Path(folder).chmod(0o755)
            print(f'Debian {system}:', flush=True)
            if not try_on(system, Path(folder)):
                failed.append(system)
    print(f'Failed on {" and ".join(failed)}.' if failed else 'All went well.')
    return int(bool(failed))


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
