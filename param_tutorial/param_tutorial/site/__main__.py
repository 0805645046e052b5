"""``python -m param_tutorial.site``: make the HTML lessons, one page for each chapter or one file for one."""

import argparse
import sys
from pathlib import Path

try:
    from param_tutorial.site import single
    from param_tutorial.site.archive import ROOT
    from param_tutorial.site.browser.page_python import PagePythonError
    from param_tutorial.site.build import Site
    from param_tutorial.site.live.running import ChapterError
    from param_tutorial.site.pages.writing import BuildError
except ModuleNotFoundError as error:
    sys.exit(f"The HTML lessons need {error.name}: install the course with its extra, pip install -e '.[html]'.")


def main(arguments: list[str] | None = None) -> int:
    """Read the command line, and build.

    :return: The exit status.
    """
    parser = argparse.ArgumentParser(prog='python -m param_tutorial.site', description='Make the HTML lessons.')
    parser.add_argument('--notebooks', type=Path, default=ROOT / 'notebooks', help='the folder of the chapters')
    parser.add_argument('--only', nargs='+', metavar='CHAPTER', help='chapters, by what their names begin with')
    parser.add_argument('--target', type=Path, default=ROOT / 'build' / 'html', help='where the site will be')
    parser.add_argument('--work', type=Path, default=ROOT / 'build' / 'lessons',
                        help='what is kept between builds')
    parser.add_argument('--lesson', metavar='CHAPTER', help='make one file of one chapter instead')
    options = parser.parse_args(arguments)
    try:
        names = [options.lesson] if options.lesson else options.only
        site = Site(options.notebooks.resolve(), options.target.resolve(), options.work.resolve(), names,
                    has_lab=names is None)
        if options.lesson:
            single.build(site)
        else:
            site.build()
    except (ChapterError, BuildError, PagePythonError) as error:
        print(f'{error}\nNo site was made; the previous one is kept.', file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print('\nStopped; the previous site is kept.', file=sys.stderr)
        return 130
    return 0


if __name__ == '__main__':
    sys.exit(main())
