"""Make what is released of the course, in build/release/; `make release` runs this with .venv's Python.

- a wheel that holds the whole course as it lies in the checkout: chapters, parameter files, ROS package, JupyterLab's
  settings. So the package finds beside itself what it finds in a checkout, and `python -m param_tutorial lab` works. A
  .pth file in the wheel puts the ROS package's folder on Python's path.
- a wheel of the tools alone, param_tools.
- sbom.json: what a learner's environment consists of, with versions, licenses and hashes, as CycloneDX 1.6. Each of its
  facts is in the lock or in the packages' metadata, so no tool is needed for it.
- LICENSES.md: the same for people.
- an archive of the course for any browser, as `make lite` builds it.
"""

import base64
import contextlib
import csv
import hashlib
import importlib.metadata
import io
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

from setuptools import build_meta

from param_tutorial.site.browser import licenses, lite

ROOT = Path(__file__).resolve().parent.parent
TARGET = ROOT / 'build' / 'release'
LOCK = ROOT / 'environment' / 'requirements.lock'
# What the wheel holds of the checkout.
FOLDERS = ('config', 'environment/jupyter', 'notebooks', 'param_tutorial')
FILES = ('LICENSE', 'README.md', 'environment/CHANGELOG.md', 'environment/lab.py')
HOME = 'param_tutorial_course'
# A wheel made from the same files is the same, byte for byte.
TIME = (2026, 1, 1, 0, 0, 0)


def tracked() -> list[str]:
    """Return the files of the checkout that belong in a wheel; those that git knows, and nothing that lies about."""
    known = subprocess.run(['git', 'ls-files', '-z', *FOLDERS, *FILES], cwd=ROOT, capture_output=True, text=True,
                           check=True).stdout
    return sorted(filter(None, known.split('\0')))


def metadata() -> tuple[str, dict[str, bytes]]:
    """Return the name of the .dist-info folder, and the files in it that setuptools makes from pyproject.toml."""
    folder = TARGET / 'metadata'
    folder.mkdir(parents=True, exist_ok=True)
    os.chdir(ROOT)  # where setuptools looks for pyproject.toml
    with contextlib.redirect_stdout(sys.stderr):
        name = build_meta.prepare_metadata_for_build_wheel(str(folder))
    files = {f'{name}/{path.relative_to(folder / name)}': path.read_bytes()
             for path in sorted((folder / name).rglob('*')) if path.is_file() and path.name not in ('RECORD', 'WHEEL')}
    return name, files


def make_wheel() -> Path:
    """Make the wheel; return its path."""
    info, files = metadata()
    # See https://packaging.python.org/en/latest/specifications/binary-distribution-format/
    files[f'{info}/WHEEL'] = (
        b'Wheel-Version: 1.0\nGenerator: environment/release.py\nRoot-Is-Purelib: true\nTag: py3-none-any\n')
    files[f'{HOME}.pth'] = f'{HOME}/param_tutorial\n'.encode()
    files |= {f'{HOME}/{name}': (ROOT / name).read_bytes() for name in tracked()}
    record = io.StringIO()
    rows = csv.writer(record, lineterminator='\n')
    for name, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b'=').decode()
        rows.writerow([name, f'sha256={digest}', len(content)])
    rows.writerow([f'{info}/RECORD', '', ''])
    wheel = TARGET / f'{info.removesuffix(".dist-info")}-py3-none-any.whl'
    with zipfile.ZipFile(wheel, 'w', zipfile.ZIP_DEFLATED) as archive:
        for name, content in {**files, f'{info}/RECORD': record.getvalue().encode()}.items():
            archive.writestr(zipfile.ZipInfo(name, TIME), content, zipfile.ZIP_DEFLATED)
    return wheel


def make_tools_wheel() -> None:
    """Make the wheel of the tools alone, from a copy: setuptools leaves files beside what it builds."""
    with tempfile.TemporaryDirectory() as folder:
        copy = shutil.copytree(ROOT / 'param_tutorial' / 'param_tools', Path(folder, 'param_tools'),
                               ignore=shutil.ignore_patterns('__pycache__'))
        subprocess.run([sys.executable, '-m', 'pip', 'wheel', '--quiet', '--no-deps', '--no-build-isolation',
                        '--wheel-dir', TARGET, copy], env={**os.environ, 'SOURCE_DATE_EPOCH': '1767225600'}, check=True)


def locked() -> dict[str, tuple[str, list[str]]]:
    """Return each package of the lock that this Python gets, with its version and the hashes of its files."""
    found = {}
    for entry in re.split(r'^(?=[a-z])', LOCK.read_text(), flags=re.MULTILINE)[1:]:
        name, version = re.match(r'([\w.-]+)==(\S+)', entry).groups()
        with contextlib.suppress(importlib.metadata.PackageNotFoundError):
            if importlib.metadata.version(name) == version:
                found[name] = version, re.findall('sha256:([0-9a-f]{64})', entry)
    return found


def make_lists() -> None:
    """Write sbom.json and LICENSES.md."""
    version = importlib.metadata.version('param-tutorial')
    packages = {name: (number, licenses.of_installed(name), hashes) for name, (number, hashes) in locked().items()}
    (TARGET / 'sbom.json').write_text(json.dumps({
        'bomFormat': 'CycloneDX', 'specVersion': '1.6', 'version': 1,
        'metadata': {'component': {
            'type': 'application', 'name': 'param-tutorial', 'version': version, 'bom-ref': 'param-tutorial',
            'licenses': [{'license': {'id': 'Apache-2.0'}}]}},
        'components': [{
            'type': 'library', 'name': name, 'version': number, 'bom-ref': f'pkg:pypi/{name}@{number}',
            'purl': f'pkg:pypi/{name}@{number}', 'licenses': [{'license': {'name': stated}}],
            # A file for each system and Python; whichever pip takes has one of these.
            'properties': [{'name': 'param-tutorial:sha256', 'value': each} for each in hashes],
        } for name, (number, stated, hashes) in packages.items()],
        'dependencies': [{'ref': 'param-tutorial',
                          'dependsOn': [f'pkg:pypi/{name}@{number}' for name, (number, *_) in packages.items()]}],
    }, indent=1) + '\n')
    installed = licenses.table((name, number, stated) for name, (number, stated, _) in packages.items())
    in_a_page = licenses.table(licenses.of_a_page())
    (TARGET / 'LICENSES.md').write_text(
        f'# What param-tutorial {version} is installed with\n\nThe course is under Apache-2.0. What each package '
        f'states of itself:\n\n{installed}\n# What the course in a browser is made of\n\n{in_a_page}')


def make_browser_archive() -> None:
    """Make an archive of the course for any browser: static files for any web server."""
    with tempfile.TemporaryDirectory() as folder:
        name = f'param_tutorial_in_the_browser-{importlib.metadata.version("param-tutorial")}'
        lite.build(Path(folder, name))
        shutil.make_archive(str(TARGET / name), 'zip', folder, name)


def main() -> None:
    """Make it all, and say where it is."""
    TARGET.mkdir(parents=True, exist_ok=True)
    make_lists()
    make_tools_wheel()
    make_browser_archive()
    print(make_wheel().relative_to(ROOT))


if __name__ == '__main__':
    main()
