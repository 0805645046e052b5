"""Processes that this one starts: none outlives it."""

import subprocess

# It reads a line, or learns that the process at the other end is gone. launch needs up to 10 s for nodes that ignore
# signals, and leaves them running if it is killed before.
_GUARD = """
read -r _ && exit
kill -s TERM -- "-$0" || exit
for _ in $(seq 200); do sleep 0.1; kill -s 0 -- "-$0" || exit; done
kill -s KILL -- "-$0"
"""


class Guard:
    """Ends a group of processes if this process ends before, however it ends: SIGTERM, and SIGKILL 20 s later.

    Unlike Linux's "parent death signal", it also reaches what a command has started in its turn, and minds no thread.
    """

    def __init__(self, group: int):
        """Guard from now on.

        :param group: The group's id, which is the process id of the one that was started in a new session.
        """
        self._process = subprocess.Popen(['sh', '-c', _GUARD, str(group)], stdin=subprocess.PIPE,
                                         stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)

    def dismiss(self) -> None:
        """Guard no longer: the group has ended, and another may get its number."""
        self._process.communicate(b'\n')

    def __enter__(self) -> 'Guard':
        return self

    def __exit__(self, *_: object) -> None:
        self.dismiss()
