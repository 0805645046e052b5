"""The licenses of what comes into a page, each as the package states it of itself."""

import email
import importlib.metadata
import xml.etree.ElementTree as ET
import zipfile
from collections.abc import Iterable
from email.message import Message
from pathlib import Path

from param_tutorial.site.browser import page_python

# What is no wheel. JupyterLab's own parts are listed by its build, in the file that the sentence below names.
_OTHERS = (('CPython', '3.14', 'PSF-2.0'), ('Pyodide', page_python.PYODIDE_VERSION, 'MPL-2.0'))


def stated_in(about: Message, files: Iterable[Path] = ()) -> str:
    """Return the license that a package states, in its metadata or, as ROS does, in its package.xml.

    :param about: Its metadata.
    :param files: Its files.
    """
    for path in files:
        if path.name == 'package.xml':
            return ' and '.join((each.text or '').strip() for each in ET.parse(path).getroot().iter('license'))
    if expression := about.get('License-Expression'):
        return str(expression)
    named = [each.split(' :: ')[-1] for each in about.get_all('Classifier', []) if each.startswith('License :: ')]
    text = (about.get('License') or '').strip().splitlines()
    elsewhere = 'see its license file' if about.get('License-File') else 'not stated'
    return ' or '.join(each for each in named if each != 'OSI Approved') or (text[0] if text else elsewhere)


def of_installed(name: str) -> str:
    """Return the license of a package that is installed here."""
    files = importlib.metadata.files(name) or ()
    return stated_in(importlib.metadata.metadata(name), (Path(each.locate()) for each in files))  # type: ignore[arg-type]


def of_a_page() -> list[tuple[str, str, str]]:
    """Return the name, the version and the license of each package that a page loads."""
    rows = [*_OTHERS]
    for name in page_python.installed_distributions():
        rows.append((name, importlib.metadata.version(name), of_installed(name)))
    for path in page_python.wheels():
        with zipfile.ZipFile(path) as wheel:
            metadata = next(each for each in wheel.namelist() if each.endswith('.dist-info/METADATA'))
            about = email.message_from_bytes(wheel.read(metadata))
        rows.append((about['Name'], about['Version'], stated_in(about)))
    return sorted(rows, key=lambda row: row[0].lower())


def table(rows: Iterable[tuple[str, str, str]]) -> str:
    """Return licenses as a table in Markdown."""
    lines = ''.join(f'| {" | ".join(row)} |\n' for row in rows)
    return f'| Package | Version | License |\n| --- | --- | --- |\n{lines}'
