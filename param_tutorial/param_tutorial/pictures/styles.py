"""The style sheets of what the rooms show: .css files, each beside the module whose markup it is for.

They take their colors from JupyterLab's variables, which follow its theme; the colors behind those are for a page that
has no such variables.
"""

from importlib import resources


def sheet(path: str) -> str:
    """Return the text of a style sheet.

    :param path: Within this package, e.g. ``'widgets/panel.css'``.
    :raises FileNotFoundError: it is not there, or was not installed.
    """
    return resources.files('param_tutorial').joinpath(path).read_text(encoding='utf-8')


def style(path: str) -> str:
    """Return a style sheet as the ``<style>`` element that goes onto the page with the markup.

    :param path: As for ``sheet``.
    """
    return f'<style>\n{sheet(path)}</style>'
