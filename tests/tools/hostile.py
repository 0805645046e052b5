"""How long hostile lines hold up a notebook: a table of lines, places and seconds until the next check worked.

    python -m tests.tools.hostile [WORD ...]

With words, only lines and places with one of them in their names.
"""

import sys

from tests.support.hostile import LINES, PLACES, attempt, started


def main(words: list[str]) -> None:
    """Print the table, each row as soon as it is known."""
    print('| line | place | answered after s | next check done after s | characters shown | |\n'
          '|---|---|---|---|---|---|')
    kernel = started()
    for name, line in LINES.items():
        for place in PLACES:
            if words and not any(word in name or word in place for word in words):
                continue
            try:
                tried = attempt(kernel, name, place)
            except TimeoutError:
                print(f'| {name} | {place} | | | | hangs |', flush=True)
                kernel.kill()
                kernel = started()
                continue
            lives, works = tried.goes_on
            faults = {'stage dead': not lives, 'next check fails': not works, 'no word': not tried.says(line.says)}
            print(f'| {name} | {place} | {tried.answered_sec:.1f} | {tried.all_sec:.1f} | {len(tried.text)} | '
                  f'{", ".join(fault for fault, is_so in faults.items() if is_so)} |', flush=True)
    kernel.end()


if __name__ == '__main__':
    main(sys.argv[1:])
