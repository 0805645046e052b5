"""Gathers the Python of a web page: Pyodide from npm, and the packages that it loads, as wheels.

rclpy, the messages and PyYAML are taken as they are installed here, without what is compiled; the other packages are
wheels of a lock for CPython 3.14, which Pyodide is; the course and its tools are those of this checkout. Pyodide itself
compiles every module beforehand, in Node.js, so that no page has to.
"""

import hashlib
import importlib.metadata
import importlib.util
import io
import json
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

from param_tools.errors import ParameterToolError
from param_tutorial.learner.storage import only_one, write_whole
from param_tutorial.notebook import stored
from param_tutorial.notebook.browser_kernel import STORED
from param_tutorial.site.archive import PACKAGE_ROOT, ROOT

VERSION = importlib.metadata.version('param-tutorial')
PYODIDE = ROOT / 'environment' / 'node_modules' / 'pyodide'
# What is kept from one build to the next.
WORK = ROOT / 'build' / 'page'
_PYODIDE_FILES = ('pyodide.asm.mjs', 'pyodide.asm.wasm', 'pyodide.mjs')
# Compiled, it brings Python into a page in a third of the time.
_STDLIB = 'python_stdlib.zip'
# What no page can use: mail and servers, since it has no connections, and what stands in for modules that are compiled.
_STDLIB_LEFT_OUT = ('ftplib', 'imaplib', 'mailbox', 'poplib', 'smtplib', 'wsgiref/', 'xmlrpc/', '_pydatetime', '_pyio')
_LOCK = ROOT / 'environment' / 'requirements-page.lock'
_COMPILE = Path(__file__).with_name('compile.mjs')
# In place of the kernel's own, which would import micropip.
_PIPLITE = Path(__file__).with_name('piplite')
# Import packages that are pure Python but for a few compiled files, in whose place the layer stands.
_INSTALLED = ('action_msgs', 'ament_index_python', 'builtin_interfaces', 'geometry_msgs', 'lifecycle_msgs',
              'rcl_interfaces', 'rclpy', 'rosgraph_msgs', 'rosidl_generator_py', 'rosidl_parser', 'rosidl_pycommon',
              'rpyutils', 'sensor_msgs', 'service_msgs', 'std_msgs', 'type_description_interfaces',
              'unique_identifier_msgs', 'yaml')
# The kernel fetches each of these by itself, unless a package of that name is loaded.
_KERNEL = ('comm', 'ipykernel', 'ipython', 'jedi', 'micropip', 'piplite', 'pyodide-kernel')
_COURSE, _NEEDS, _START = 'param-course', 'param-course-needs', 'param-course-start'
PACKAGES = (*_KERNEL, _NEEDS, _COURSE, _START)
"""What a page has to load."""
# Tests, what is installed outside of the packages, and stubs of libraries that no page has.
_PARTS_LEFT_OUT = ('/tests/', '.data/', '/django-stubs/', '/typeshed/stubs/')
# The kernel's IPython reads this when it starts.
_IPYTHON_CONFIG = '''import sys
sys.path.insert(0, '/lib/python3.14/site-packages/course/param_tutorial')
c = get_config()
c.InteractiveShellApp.extensions = ['param_tutorial.notebook.browser_kernel']
'''


class PagePythonError(ParameterToolError):
    """The Python of a page can't be put together."""


def gather(target: Path) -> None:
    """Put Pyodide, the wheels and their lock into a folder.

    :param target: Afterwards holds what a page loads, and nothing else.
    :raises PagePythonError: something is missing; the error says how to get it.
    """
    if not PYODIDE.exists():
        raise PagePythonError('Pyodide, the Python of web pages, is not there: `make lite` gets it from npm')
    shutil.rmtree(target, ignore_errors=True)
    target.mkdir(parents=True)
    WORK.mkdir(parents=True, exist_ok=True)
    for name in _PYODIDE_FILES:
        shutil.copy(PYODIDE / name, target / name)
    with zipfile.ZipFile(PYODIDE / _STDLIB) as stdlib:
        files = {name: stdlib.read(name) for name in stdlib.namelist()
                 if not name.endswith('/') and not name.startswith(_STDLIB_LEFT_OUT)}
    lock = json.loads((PYODIDE / 'pyodide-lock.json').read_text(encoding='utf-8'))
    with only_one(WORK):  # the first one compiles, and the others have it from there
        shutil.copy(_made('stdlib', files, _only_compiled), target / _STDLIB)
        lock['packages'] = {name: _make_wheel(name, files, target) for name, files in _wheels().items()}
    (target / 'pyodide-lock.json').write_text(json.dumps(lock, indent=1), encoding='utf-8')


def _wheels() -> dict[str, dict[str, bytes]]:
    """Return the files of each wheel: the packages that the kernel asks for, the course, and all that it needs."""
    needs = dict(_installed_files(_INSTALLED))
    packages: dict[str, dict[str, bytes]] = {}
    for path in wheels():
        name = re.sub(r'[-_.]+', '-', path.name.partition('-')[0]).lower()
        with zipfile.ZipFile(path) as wheel:
            files = {each: wheel.read(each) for each in wheel.namelist()
                     if not each.endswith(('/', '/RECORD')) and not any(part in each for part in _PARTS_LEFT_OUT)}
        if name in _KERNEL:
            packages[name] = files
        else:
            needs |= files
    return {**packages, 'micropip': {}, 'piplite': dict(_files_in(_PIPLITE, 'piplite')),
            _NEEDS: needs, _COURSE: dict(_course_files()), _START: _start_files()}


def wheels() -> list[Path]:
    """Return the wheels of Python packages that a page loads, those of the lock and those in the kernel's.

    :raises PagePythonError: they can't be fetched.
    """
    the_kernels = kernel_wheel()
    inside = WORK / 'wheels' / 'of_the_kernel'
    inside.mkdir(exist_ok=True)
    with zipfile.ZipFile(the_kernels) as kernel:
        for name in kernel.namelist():
            if name.endswith('.whl') and not name.rpartition('/')[2].startswith(('piplite-', 'widgetsnbextension-')):
                (inside / Path(name).name).write_bytes(kernel.read(name))
    return [*(path for path in _fetched() if path != the_kernels), *sorted(inside.glob('*.whl'))]


def kernel_wheel() -> Path:
    """Return the wheel of JupyterLite's kernel: an extension of JupyterLab, with Python packages in it."""
    return next(path for path in _fetched() if path.name.startswith('jupyterlite_pyodide_kernel-'))


def _fetched() -> list[Path]:
    """Return the wheels of the lock, each checked against its hash, and fetch them if the lock has changed.

    :raises PagePythonError: they can't be fetched.
    """
    folder = WORK / 'wheels'
    stamp = folder / _LOCK.name
    if not stamp.exists() or stamp.read_bytes() != _LOCK.read_bytes():
        shutil.rmtree(folder, ignore_errors=True)
        if subprocess.run([sys.executable, '-m', 'pip', 'download', '--quiet', '--quiet', '--disable-pip-version-check',
                           '--no-deps', '--require-hashes', '--python-version', '3.14', '--platform', 'any',
                           '--only-binary=:all:', '--dest', folder, '--requirement', _LOCK], check=False).returncode:
            raise PagePythonError("the packages of a page can't be fetched, for the reason above. This needs the "
                                  'network; run the same command again once that is put right')
        stamp.write_bytes(_LOCK.read_bytes())
    return sorted(folder.glob('*.whl'))


def _installed_files(packages: Sequence[str]) -> Iterator[tuple[str, bytes]]:
    """Yield the files of import packages as they are installed here, with their names in a wheel."""
    for package in packages:
        spec = importlib.util.find_spec(package)
        if spec is None or spec.origin is None:
            raise PagePythonError(f'{package} is not installed: `make lite` installs it')
        yield from _files_in(Path(spec.origin).parent, package)


def _files_in(folder: Path, name: str) -> Iterator[tuple[str, bytes]]:
    """Yield the files in a folder that a page can use, with their names in a wheel.

    :param name: Of the folder.
    """
    for path in sorted(folder.rglob('*')):
        if path.is_file() and path.suffix not in ('.so', '.c', '.pyc'):
            yield f'{name}/{path.relative_to(folder)}', path.read_bytes()


def _course_files() -> Iterator[tuple[str, bytes]]:
    """Yield the files of the course as in a checkout: its ROS package, the parameter files, and what can't run here."""
    notebooks = (json.loads(path.read_text(encoding='utf-8')) for path in sorted((ROOT / 'notebooks').rglob('*.ipynb')))
    yield f'course/{STORED}', json.dumps([cell for each in notebooks for cell in stored.collect(each)]).encode()
    yield from _files_in(ROOT / 'config', 'course/config')
    package = f'course/{PACKAGE_ROOT.name}'
    yield f'{package}/package.xml', (PACKAGE_ROOT / 'package.xml').read_bytes()
    for folder in ('launch', 'param_tools', 'param_tutorial'):
        for name, content in _files_in(PACKAGE_ROOT / folder, f'{package}/{folder}'):
            if '/param_tutorial/site/' not in name:  # a page builds no website
                yield name, content


def _start_files() -> dict[str, bytes]:
    """Return the files that tell Python and IPython of the course."""
    wheel = f'{_START.replace("-", "_")}-{VERSION}'
    # The embedded ros2 looks for packages among the entry points.
    points = ''.join(f'{each.name} = {each.value}\n' for each in importlib.metadata.entry_points(
        group='param_tools.packages'))
    return {name: text.encode() for name, text in {
        f'{wheel}.dist-info/METADATA': f'Metadata-Version: 2.1\nName: {_START}\nVersion: {VERSION}\n',
        f'{wheel}.dist-info/WHEEL': 'Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n',
        f'{wheel}.dist-info/entry_points.txt': f'[param_tools.packages]\n{points}',
        # What lies in data/ is put at the root of the page's file system, where IPython looks for its settings.
        f'{wheel}.data/data/etc/ipython/ipython_config.py': _IPYTHON_CONFIG}.items()}


def _make_wheel(name: str, files: dict[str, bytes], target: Path) -> dict[str, object]:
    """Write a wheel, and return what Pyodide's lock says of it."""
    archive = _made(name, files, lambda each: {**each, **_compiled(each)})
    # A wheel is of one package, with metadata; everything else is a plain archive.
    is_wheel = name != _NEEDS and any(each.endswith('.dist-info/METADATA') for each in files)
    file_name = f'{name.replace("-", "_")}-{VERSION}-py3-none-any.whl' if is_wheel else f'{name}.zip'
    path = Path(shutil.copy(archive, target / file_name))
    return {'name': name, 'version': VERSION, 'file_name': file_name, 'install_dir': 'site', 'depends': [],
            'imports': [], 'sha256': hashlib.sha256(path.read_bytes()).hexdigest(), 'package_type': 'package',
            'unvendored_tests': False}


def _made(name: str, files: dict[str, bytes], content: Callable[[dict[str, bytes]], dict[str, bytes]]) -> Path:
    """Return an archive of modules and what Pyodide makes of them.

    :param content: Returns what stands in the archive.
    """
    depends_on = b''.join((_COMPILE.read_bytes(), Path(__file__).read_bytes(), (PYODIDE / 'package.json').read_bytes(),
                           *(part for each in sorted(files) for part in (each.encode(), files[each]))))
    return kept(WORK / 'made', name, depends_on, lambda: _archive(content(files)))


def kept(folder: Path, name: str, depends_on: bytes, make: Callable[[], bytes]) -> Path:
    """Return a file that is made anew only if what it depends on has changed."""
    path = folder / f'{name}-{hashlib.sha256(depends_on).hexdigest()[:16]}.kept'
    if not path.exists():
        for old in folder.glob(f'{name}-{16 * "?"}.*'):
            old.unlink()
        write_whole(path, make())
    return path


def _archive(files: dict[str, bytes]) -> bytes:
    """Return files as an archive: the same files make the same one, byte for byte."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, 'w', zipfile.ZIP_DEFLATED) as archive:
        for name, content in sorted(files.items()):
            archive.writestr(zipfile.ZipInfo(name), content, zipfile.ZIP_DEFLATED)
    return buffer.getvalue()


def _only_compiled(files: dict[str, bytes]) -> dict[str, bytes]:
    """Return the files with compiled modules in place of the others, where Python looks for them in an archive."""
    compiled = {re.sub(r'__pycache__/([\w-]+)\.cpython-\d+\.pyc', r'\1.pyc', name): content
                for name, content in _compiled(files).items()}
    return {**{name: content for name, content in files.items() if not _is_module(name)}, **compiled}


def _is_module(name: str) -> bool:
    """True unless it is a file of another kind, or one of the reader's package, which is copied as it is."""
    return name.endswith('.py') and '/steps/' not in name


def _compiled(files: dict[str, bytes]) -> dict[str, bytes]:
    """Return the modules among the files as Pyodide compiles them, by their names in a wheel."""
    with tempfile.TemporaryDirectory() as folder:
        for each, content in files.items():
            if _is_module(each):
                path = Path(folder, each)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(content)
        subprocess.run([Path(sys.executable).with_name('node'), _COMPILE, PYODIDE, folder], check=True)
        return {str(path.relative_to(folder)): path.read_bytes() for path in Path(folder).rglob('*.pyc')}
