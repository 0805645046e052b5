"""The style sheets of what the rooms show: .css files, each beside the module whose markup it is for.

They take their colors from JupyterLab's variables, which follow its theme; the colors behind those are for a page that
has no such variables.
"""

from importlib import resources


def sheet(path: str) -> str:
    """Return the text of a style sheet.

    :param path: Begins with the import package, e.g. ``'param_tools/panel/panel.css'``.
    :raises FileNotFoundError: it is not there, or was not installed.
    """
    package, _, file = path.partition('/')
    return resources.files(package).joinpath(file).read_text(encoding='utf-8')


def style(path: str) -> str:
    """Return a style sheet as the ``<style>`` element that goes onto the page with the markup.

    :param path: As for ``sheet``.
    """
    return f'<style>\n{sheet(path)}</style>'
