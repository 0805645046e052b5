"""The Python of a lesson page as scripts, which a page on a disk can load, too: deflated, in base64.

Each script adds one part to a list of the page. Over the web the same files serve: one way to load them is enough, and
a page that never fetches may be forbidden to.
"""

import base64
import json
import re
import zipfile
import zlib
from collections.abc import Iterator
from pathlib import Path

# What JupyterLab's kernel needs and no lesson page: completion, a terminal, packages from elsewhere, widgets' own
# scripts; but for what IPython imports of these anyway.
_LEFT_OUT = ('jedi', 'micropip', 'parso', 'piplite', 'prompt_toolkit', 'wcwidth',
             'anywidget/labextension/', 'anywidget/nbextension/',
             'IPython/terminal/', 'IPython/testing/', 'IPython/sphinxext/', 'pygments/lexers/')
_KEPT = re.compile(r'IPython/(terminal|testing)/(__init__|skipdoctest|pt_inputhooks/__init__)\.py|'
                   r'pygments/lexers/(__init__|_mapping|css|data|html|javascript|markup|perl|python|ruby|shell|'
                   r'_(css|lua|ruby)\w*)\.py')
# Whose lines a traceback may show; what lies outside of the packages is read as it is.
_WITH_SOURCE = re.compile(r'rclpy/|/etc/|course/config/|course/\w+/launch/|.*/param_tutorial/nodes/')
_COMPILED = re.compile(r'(.*/)?__pycache__/(\w+)\.cpython-\d+\.pyc')
_ROOT = re.compile(r'[\w.-]+\.data/data(/.*)')
PACKAGES = 'packages'
_PYODIDE = ('pyodide.mjs', 'pyodide.asm.mjs', 'pyodide.asm.wasm', 'python_stdlib.zip', 'pyodide-lock.json')


def packages(pyodide: Path, notebooks: Path) -> bytes:
    """Return all packages in one, as ``unpackFiles`` of ``kernel.js`` reads them.

    :param pyodide: The folder that ``browser.page_python`` has filled.
    :param notebooks: The chapters, which stand beside the one that runs, as a notebook's neighbors do.
    """
    files = {**dict(_package_files(pyodide)), **_texts_of(notebooks)}
    names = json.dumps([[name, len(content)] for name, content in files.items()], separators=(',', ':'))
    return b'\n'.join([names.encode(), b''.join(files.values())])


def _package_files(pyodide: Path) -> Iterator[tuple[str, bytes]]:
    for archive in sorted((*pyodide.glob('*.whl'), *pyodide.glob('param-course*.zip'))):
        with zipfile.ZipFile(archive) as wheel:
            names = set(wheel.namelist())
            for name in sorted(names):
                where = root[1] if (root := _ROOT.fullmatch(name)) else name
                if where.startswith(_LEFT_OUT) and not _KEPT.fullmatch(_source_of(where)):
                    continue
                has_source = bool(_WITH_SOURCE.match(where))
                if (compiled := _COMPILED.fullmatch(where)) and not has_source:
                    where = f'{compiled[1] or ""}{compiled[2]}.pyc'
                elif where.endswith('.py') and not has_source and _compiled_of(name) in names:
                    continue
                yield where, wheel.read(name)


def _texts_of(notebooks: Path) -> dict[str, bytes]:
    """Return the chapters without their outputs, which nobody reads in them."""
    found = {}
    for path in sorted(notebooks.glob('*.ipynb')):
        notebook = json.loads(path.read_text(encoding='utf-8'))
        for cell in notebook['cells']:
            if cell['cell_type'] == 'code':
                cell['outputs'] = []
        found[f'/drive/{path.name}'] = json.dumps(notebook, ensure_ascii=False, separators=(',', ':')).encode()
    return found


def _source_of(name: str) -> str:
    compiled = _COMPILED.fullmatch(name)
    return f'{compiled[1] or ""}{compiled[2]}.py' if compiled else name


def _compiled_of(name: str) -> str:
    path = Path(name)
    return str(path.parent / '__pycache__' / f'{path.stem}.cpython-314.pyc')


def scripts(pyodide: Path, packed: bytes) -> dict[str, str]:
    """Return the scripts by their names, and in them all that a page's worker needs to begin."""
    parts = {name: (pyodide / name).read_bytes() for name in _PYODIDE}
    lock = json.loads(parts['pyodide-lock.json'])
    parts['pyodide-lock.json'] = json.dumps({**lock, 'packages': {}}).encode()
    parts[PACKAGES] = packed
    return {f'python-{number}.js': _script(name, content) for number, (name, content) in enumerate(parts.items(), 1)}


def _script(name: str, content: bytes) -> str:
    deflate = zlib.compressobj(9, wbits=-15)
    text = base64.b64encode(deflate.compress(content) + deflate.flush()).decode()
    return f'(self.lessonPython ??= {{}})[{json.dumps(name)}] = "{text}";\n'
