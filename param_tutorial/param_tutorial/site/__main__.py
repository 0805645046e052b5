"""``python -m param_tutorial.site``: make the HTML lessons."""

import sys

if __name__ == '__main__':
    try:
        from param_tutorial.site.command import main
    except ModuleNotFoundError as error:
        sys.exit(f"The HTML lessons need {error.name}: install the course with its extra, pip install -e '.[html]'.")
    sys.exit(main())
