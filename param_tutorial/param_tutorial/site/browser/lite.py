"""Builds JupyterLab for the browser, with the chapters and their kernel in it: JupyterLite, static files only.

    .venv/bin/python -m param_tutorial.site.browser.lite [FOLDER]

The learner's copies and progress stay in the browser. Any server of static files will do, and none but that is asked.
"""

import hashlib
import json
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from param_tutorial.learner.copies import Copies
from param_tutorial.site.archive import ROOT
from param_tutorial.site.browser import page_python
from param_tutorial.site.replacing import replace

TARGET = ROOT / 'build' / 'lite'
_HERE = Path(__file__).parent
# Neither the page nor a kernel in it may ask another host for anything. JupyterLab makes style sheets, and Pyodide
# machine code, of their own.
_POLICY = "default-src 'self' blob: data: 'unsafe-inline' 'unsafe-eval'"
# The folder of the page's Python.
PYODIDE = 'pyodide'
_KERNEL = '@jupyterlite/pyodide-kernel-extension'
_SETTINGS = ROOT / 'environment' / 'jupyter' / 'labconfig'
_OUR_EXTENSION = ROOT / 'environment' / 'jupyter' / 'labextensions' / 'param-tutorial'
# The end of the start page says where a learner's work is kept. In a browser it ends like this.
_WHERE_WORK_IS = 'Your changes are saved as you work.'
_WORK_IN_BROWSER = f'''{_WHERE_WORK_IS} They are kept in this browser and nowhere else; a private window forgets them
when you close it. The exercises you solve are saved here too, in `progress.json`. When you open this page again, a ✓
marks each chapter whose exercises you have all solved.

To keep your work safe, or to move it to another browser, right-click a file in the list on the left and choose
*Download*. The arrow above that list uploads it again. If you delete a chapter that you have changed, a fresh copy
appears. If you delete `progress.json`, the course forgets what you have solved.

The nodes of a notebook live in its tab, with ROS 2's own Python library and without a network. A cell that needs a
shell says so, and shows what it prints on a computer that has one.
'''

_LICENSES = f'''# What comes into the page

The course, rclpy and the messages of ROS 2 are under Apache-2.0, PyYAML under MIT, CPython under PSF-2.0, and Pyodide
under MPL-2.0. JupyterLite and JupyterLab are under BSD-3-Clause; what they contain is listed in
`build/third-party-licenses.json`. Every other Python package has its license in its archive, in `{PYODIDE}/`.
'''


def build(target: Path) -> None:
    """Build the site into a folder; the one of before stays until the new one is whole.

    :raises PagePythonError: the kernel's Python can't be put together.
    """
    with tempfile.TemporaryDirectory() as folder:
        lite, files, site = (Path(folder, name) for name in ('lite', 'files', 'site'))
        lite.mkdir()
        Copies(ROOT, files).deliver()
        for path in files.glob('.*'):  # notes for later deliveries, of which there are none in a browser
            shutil.rmtree(path)
        _adapt(files)
        page_python.gather(Path(folder, PYODIDE))
        (lite / 'jupyter-lite.json').write_text(json.dumps(_configuration()), encoding='utf-8')
        (lite / 'jupyter_lite_config.json').write_text(json.dumps({'LiteBuildConfig': {
            'federated_extensions': [str(page_python.kernel_wheel()), str(_OUR_EXTENSION)]}}), encoding='utf-8')
        (lite / 'overrides.json').write_text(json.dumps(_settings()), encoding='utf-8')
        subprocess.run([sys.executable, '-W', 'ignore', '-m', 'jupyterlite_core', 'build', '--log-level', 'ERROR',
                        '--lite-dir', lite, '--contents', files, '--output-dir', site, '--apps', 'lab',
                        '--no-sourcemaps'], check=True, cwd=folder, stdout=subprocess.DEVNULL)
        Path(folder, PYODIDE).rename(site / PYODIDE)
        (site / 'LICENSES.md').write_text(_LICENSES, encoding='utf-8')
        _finish(site)
        replace(site, target)


def _adapt(files: Path) -> None:
    """Change what learners get where it would not be true, or not be seen, in a browser."""
    start = files / 'index.md'
    text, _, _ = start.read_text(encoding='utf-8').partition(_WHERE_WORK_IS)
    start.write_text(text + _WORK_IN_BROWSER, encoding='utf-8')
    for picture in files.rglob('*.svg'):  # which JupyterLite hands to the browser as Latin-1
        picture.write_bytes(picture.read_text(encoding='utf-8').encode('ascii', 'xmlcharrefreplace'))


def _finish(site: Path) -> None:
    """Add what JupyterLite has no setting for: a policy, a notice while a kernel loads, and work without a network."""
    page = site / 'lab' / 'index.html'
    head = (f'<head>\n    <meta http-equiv="Content-Security-Policy" content="{_POLICY}">\n'
            f'    <script src="../loading.js"></script>')
    page.write_text(page.read_text(encoding='utf-8').replace('<head>', head, 1), encoding='utf-8')
    shutil.copy(_HERE / 'loading.js', site)
    (site / 'service-worker.js').rename(site / 'jupyterlite-service-worker.js')
    files = sorted(path for path in site.rglob('*') if path.is_file())
    version = hashlib.sha256(b''.join(hashlib.sha256(path.read_bytes()).digest() for path in files)).hexdigest()
    values = {'VERSION': version, 'POLICY': _POLICY, 'FILES': [str(path.relative_to(site)) for path in files]}
    worker = (_HERE / 'service_worker.js').read_text(encoding='utf-8')
    for name, value in values.items():
        worker = worker.replace(f"'__{name}__'", json.dumps(value))
    (site / 'service-worker.js').write_text(worker, encoding='utf-8')


def _configuration() -> dict[str, object]:
    """Return what JupyterLab and its kernel read when they start."""
    page = json.loads((_SETTINGS / 'page_config.json').read_text(encoding='utf-8'))
    return {'jupyter-lite-schema-version': 0, 'jupyter-config-data': {
        'appName': 'Mastering ROS 2 Parameters',
        'exposeAppInBrowser': True,  # for notebook.veil, as in environment/jupyter
        'disabledExtensions': [name for name, is_disabled in page['disabledExtensions'].items() if is_disabled],
        'litePluginSettings': {f'{_KERNEL}:kernel': {
            'disablePyPIFallback': True, 'pipliteUrls': [], 'pyodideUrl': f'./{PYODIDE}/pyodide.mjs',
            'loadPyodideOptions': {'packages': page_python.PACKAGES}}}}}


def _settings() -> dict[str, dict[str, object]]:
    """Return the course's settings of JupyterLab; here it also saves often, since people close a tab without asking."""
    settings = json.loads((_SETTINGS / 'default_setting_overrides.json').read_text(encoding='utf-8'))
    settings['@jupyterlab/docmanager-extension:plugin']['autosaveInterval'] = 10
    return dict(settings)


def main(arguments: Sequence[str]) -> None:
    """Build the site, and say where it is."""
    target = Path(arguments[0]) if arguments else TARGET
    build(target.resolve())
    print(target / 'lab' / 'index.html')


if __name__ == '__main__':
    try:
        main(sys.argv[1:])
    except page_python.PagePythonError as error:
        sys.exit(str(error))
