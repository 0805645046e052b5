"""The Python of a lesson page as a script, which a page on a disk can load, too: packed by xz, and written as text.

Over the web the same script serves: one way to load it is enough, and a page that never fetches may be forbidden to.
"""

import io
import json
import lzma
import re
import zipfile
from collections.abc import Iterator, Mapping
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
_COMPILED = re.compile(r'(.*/)?__pycache__/([\w-]+)\.cpython-\d+\.pyc')
_ROOT = re.compile(r'[\w.-]+\.data/data(/.*)')
_PYODIDE = ('pyodide.mjs', 'pyodide.asm.mjs', 'pyodide.asm.wasm', 'pyodide-lock.json')
_STDLIB = 'python_stdlib.zip'
# All of ASCII that is printed but for what means something between the quotes of a script in a page. That leaves 91
# letters, and two of them have 8,281 values, of which 13 bits take 8,192.
_LETTERS = [chr(code) for code in range(ord('!'), ord('~') + 1) if chr(code) not in '"<\\']
_PAIRS = [first + second for first in _LETTERS for second in _LETTERS]


def packages(pyodide: Path, notebooks: Path) -> bytes:
    """Return all packages in one, as ``filesIn`` of ``kernel.js`` reads them.

    :param pyodide: The folder that ``browser.page_python`` has filled.
    :param notebooks: The chapters, which stand beside the one that runs, as a notebook's neighbors do.
    """
    return _joined({**dict(_package_files(pyodide)), **_texts_of(notebooks)})


def _joined(files: Mapping[str, bytes]) -> bytes:
    names = json.dumps([[name, len(content)] for name, content in files.items()], separators=(',', ':'))
    return b'\n'.join([names.encode(), b''.join(files.values())])


def _package_files(pyodide: Path) -> Iterator[tuple[str, bytes]]:
    for archive in sorted((*pyodide.glob('*.whl'), *pyodide.glob('param-course*.zip'))):
        with zipfile.ZipFile(archive) as wheel:
            names = sorted(wheel.namelist())
            compiled_from = {_source_of(name) for name in names if _COMPILED.fullmatch(name)}
            for name in names:
                where = root[1] if (root := _ROOT.fullmatch(name)) else name
                if where.startswith(_LEFT_OUT) and not _KEPT.fullmatch(_source_of(where)):
                    continue
                has_source = bool(_WITH_SOURCE.match(where))
                if (compiled := _COMPILED.fullmatch(where)) and not has_source:
                    where = f'{compiled[1] or ""}{compiled[2]}.pyc'
                elif where.endswith('.py') and not has_source and name in compiled_from:
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


def everything(pyodide: Path, packed: bytes) -> bytes:
    """Return all that a page's worker needs to begin, in one as well.

    :param packed: What ``packages`` returns.
    """
    parts = {name: (pyodide / name).read_bytes() for name in _PYODIDE}
    lock = json.loads(parts['pyodide-lock.json'])
    parts['pyodide-lock.json'] = json.dumps({**lock, 'packages': {}}).encode()
    return _joined({**parts, _STDLIB: _not_deflated(pyodide / _STDLIB), 'packages': packed})


def script(content: bytes) -> str:
    """Return the script that brings ``everything`` into a page: two thirds of what each file deflated would take."""
    # A window of 32 MB, which holds nearly all. Browsers keep a script's text, and would keep a string beside it.
    return f'self.lessonPython = () => {{//{_as_text(lzma.compress(content, preset=8))}\n}};\n'


def _not_deflated(archive: Path) -> bytes:
    """Return an archive with its files as they are: only so is what they have in common seen when all is packed."""
    content = io.BytesIO()
    with zipfile.ZipFile(archive) as source, zipfile.ZipFile(content, 'w') as target:
        for each in source.infolist():
            target.writestr(zipfile.ZipInfo(each.filename), source.read(each))
    return content.getvalue()


def _as_text(content: bytes) -> str:
    """Return bytes as text, 13 bits as two letters: 1.23 letters a byte, where base64 has 1.33. Zeros fill the end."""
    blocks = (int.from_bytes(content[at:at + 13].ljust(13, b'\0'), 'big') for at in range(0, len(content), 13))
    return ''.join(_PAIRS[block >> shift & 0x1fff] for block in blocks for shift in range(91, -1, -13))
