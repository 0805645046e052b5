"""A notebook in the shape of a chapter, for tests that must not depend on any one chapter."""

from pathlib import Path

import nbformat
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook

LESSON = (
    '# A lesson\nStart ROS in the background, and a node in it:',
    'import param_tutorial\nfrom param_tutorial.nodes.simple_param_node import SimpleParamNode\n\n'
    'executor = param_tutorial.start()\nnode = executor.add(SimpleParamNode)',
    'Its parameters, as controls:',
    "panel = param_tutorial.ParameterPanel('/simple_param_node')\npanel",
    'What it says:',
    'param_tutorial.views.EventView()',
)


def write(path: Path, cells: tuple[str, ...] = LESSON) -> Path:
    """Write a notebook, not executed: text that starts like a sentence is Markdown, the rest code."""
    notebook = new_notebook(cells=[
        (new_markdown_cell if text.startswith('#') or text.endswith(':') else new_code_cell)(text) for text in cells])
    notebook.metadata.kernelspec = {'name': 'python3', 'display_name': 'Python 3', 'language': 'python'}
    nbformat.write(notebook, path)
    return path
