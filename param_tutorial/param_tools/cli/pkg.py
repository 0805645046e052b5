"""ros2 pkg create, executables, list and prefix.

``create`` writes a new Python package (ament_python) into a workspace, with the files of ros2pkg 0.32.2 (Copyright Open
Source Robotics Foundation, Inc., Apache License 2.0). The other verbs print what has been built and sourced.
"""

import argparse
import getpass
import keyword
import os
import re
import shutil
import subprocess
from html import escape
from pathlib import Path

from param_tools.cli import index
from param_tools.cli.run import installed_programs
from param_tools.cli.session import CommandFailed, Commands, Session, add_verbs

BUILD_TYPE = 'ament_python'
# The names for which the genuine command writes a LICENSE file.
LICENSES = ('Apache-2.0', 'BSL-1.0', 'BSD-2.0', 'BSD-2-Clause', 'BSD-3-Clause', 'GPL-3.0-only', 'LGPL-3.0-only',
            'MIT', 'MIT-0')
# The linters that a new package brings along as tests, and that check it under `colcon test`.
_LINTERS = ('copyright', 'flake8', 'pep257')


def add_to(commands: Commands) -> None:
    verbs = add_verbs(commands, 'pkg', 'packages')
    create = verbs.add_parser('create', help='write a new Python package')
    create.add_argument('package_name', help='name of the package')
    create.add_argument('--package-format', '--package_format', type=int, default=3, choices=[3],
                        help='format of package.xml')
    create.add_argument('--description', default='TODO: Package description', help='what the package is for')
    create.add_argument('--license', default='TODO: License declaration',
                        help='e.g. Apache-2.0; ? lists those that are known')
    create.add_argument('--destination-directory', default=os.curdir, help='where to make its folder')
    create.add_argument('--build-type', default='ament_cmake', choices=['cmake', 'ament_cmake', BUILD_TYPE],
                        help=f'here always {BUILD_TYPE}')
    create.add_argument('--dependencies', nargs='+', default=[], metavar='PACKAGE', help='packages that it needs')
    create.add_argument('--maintainer-email', help="default: what git's user.email says")
    create.add_argument('--maintainer-name', help='default: the name of the user')
    create.add_argument('--node-name', help='name of a first executable, which only greets')
    create.set_defaults(verb=create_package)
    executables = verbs.add_parser('executables', help='list the programs of a package, or of all packages')
    executables.add_argument('package_name', nargs='?', help='name of the package')
    executables.add_argument('--full-path', action='store_true', help='print the path of each')
    executables.set_defaults(verb=list_executables)
    verbs.add_parser('list', help='list the packages that have been sourced').set_defaults(verb=list_packages)
    prefix = verbs.add_parser('prefix', help='print where a package is installed')
    prefix.add_argument('package_name', help='name of the package')
    prefix.add_argument('--share', action='store_true', help='print its share folder')
    prefix.set_defaults(verb=print_prefix)


def list_executables(session: Session, args: argparse.Namespace) -> None:
    """Print the names of programs, each after its package's, or their paths."""
    for package in index.sourced_packages() if args.package_name is None else [args.package_name]:
        try:
            paths = installed_programs(package)
        except index.PackageNotFound:
            raise CommandFailed(f"Package '{package}' not found{_note_on_own(package)}") from None
        for path in sorted(map(str, paths)):
            session.print(*([path] if args.full_path else [package, Path(path).name]))


def list_packages(session: Session, _args: argparse.Namespace) -> None:
    for package in index.sourced_packages():
        session.print(package)


def print_prefix(session: Session, args: argparse.Namespace) -> None:
    """Print the install space that holds a package, or the package's share folder in it."""
    try:
        prefix = index.prefix_of(args.package_name, os.environ.get('AMENT_PREFIX_PATH', ''))
    except index.PackageNotFound:
        raise CommandFailed(f'Package not found{_note_on_own(args.package_name)}') from None
    session.print(prefix / 'share' / args.package_name if args.share else prefix)


def _note_on_own(package: str) -> str:
    """Return why ``ros2 run`` finds a package that has not been built."""
    if package not in index.provided():
        return ''
    return f': {package} has not been built and sourced. The embedded ros2 runs its nodes all the same'


def create_package(session: Session, args: argparse.Namespace) -> None:
    """Write the package, and print each file."""
    if args.license == '?':
        session.print('Supported licenses:', *LICENSES, sep='\n')
        return
    _check(args)
    args.maintainer_name = args.maintainer_name or getpass.getuser()
    args.maintainer_email = args.maintainer_email or _email_of_git() or f'{args.maintainer_name}@todo.todo'
    # As the genuine command prints it: ./name where no folder is given.
    folder = os.path.join(args.destination_directory, args.package_name)
    if Path(folder).exists():
        raise CommandFailed(
            f'\nAborted!\nThe directory already exists: {folder}\nEither remove the directory or '
            f'choose a different destination directory or package name')
    _print_properties(session, args)
    session.print('creating folder', folder)
    Path(folder).mkdir(parents=True)
    for name, text in _files(args).items():
        if text is None:
            if name == args.package_name:
                session.print('creating source folder')
            session.print('creating folder', os.path.join(folder, name))
            Path(folder, name).mkdir()
        else:
            session.print('creating', os.path.join(folder, name))
            Path(folder, name).write_text(text, encoding='utf-8')
    _print_note_on_license(session, args.license)


def _check(args: argparse.Namespace) -> None:
    if args.build_type != BUILD_TYPE:
        raise CommandFailed(
            f'The embedded ros2 writes packages of --build-type {BUILD_TYPE} only, not {args.build_type}, which is '
            f'what the genuine command writes unless told otherwise. environment/README.md says how to get that one')
    if args.package_name == 'test':
        raise CommandFailed("Aborted since 'ament_python' packages can't be named 'test'. Please choose a different "
                            'package name.')
    for what, name in (('package', args.package_name), ('executable', args.node_name)):
        # Both become modules of Python, and a package's name also a folder, a topic and a name in XML.
        if name is not None and (not re.fullmatch(r'[a-z][a-z0-9_]*', name) or keyword.iskeyword(name)):
            raise CommandFailed(f'{name!r} cannot be the name of a Python {what}: it takes lower-case letters, digits '
                                f'and underscores, starts with a letter, and is no word of the language')


def _email_of_git() -> str:
    if shutil.which('git') is None:
        return ''
    return subprocess.run(['git', 'config', 'user.email'], stdout=subprocess.PIPE, text=True).stdout.strip()


def _print_properties(session: Session, args: argparse.Namespace) -> None:
    session.print('going to create a new package')
    session.print('package name:', args.package_name)
    session.print('destination directory:', os.path.abspath(args.destination_directory))
    session.print('package format:', args.package_format)
    session.print('version:', '0.0.0')
    session.print('description:', args.description)
    session.print('maintainer:', [f'{args.maintainer_name} <{args.maintainer_email}>'])
    session.print('licenses:', [args.license])
    session.print('build type:', BUILD_TYPE)
    session.print('dependencies:', args.dependencies)
    if args.node_name:
        session.print('node_name:', args.node_name)


def _print_note_on_license(session: Session, license_name: str) -> None:
    if license_name in LICENSES:
        session.print(f'\n[WARNING]: No LICENSE file has been created: the text of {license_name} is not at hand '
                      f'here. The genuine command writes it.')
        return
    session.print(f"\n[WARNING]: Unknown license '{license_name}'.  This has been set in the package.xml, but no "
                  f'LICENSE file has been created.\nIt is recommended to use one of the ament license identifiers:')
    session.print(*LICENSES, sep='\n')


def _files(args: argparse.Namespace) -> dict[str, str | None]:
    """Return the text of each file, and None for a folder, by path and in the order in which they are made."""
    name = args.package_name
    files = {
        'package.xml': _package_xml(args),
        name: None,
        'setup.py': _setup_py(args),
        'setup.cfg': f'[develop]\nscript_dir=$base/lib/{name}\n[install]\ninstall_scripts=$base/lib/{name}\n',
        'resource': None,
        f'resource/{name}': '',
        f'{name}/__init__.py': '',
        'test': None,
        **{f'test/test_{linter}.py': _linter_test(linter) for linter in _LINTERS},
    }
    if args.node_name:
        files[f'{name}/{args.node_name}.py'] = _node(name)
    return files


def _package_xml(args: argparse.Namespace) -> str:
    depends = ''.join(f'  <depend>{escape(name)}</depend>\n' for name in args.dependencies)
    tests = ''.join(f'  <test_depend>{name}</test_depend>\n' for name in (
        *(f'ament_{linter}' for linter in _LINTERS), 'python3-pytest'))
    return f'''<?xml version="1.0"?>
<?xml-model href="http://download.ros.org/schema/package_format3.xsd" schematypens="http://www.w3.org/2001/XMLSchema"?>
<package format="3">
  <name>{args.package_name}</name>
  <version>0.0.0</version>
  <description>{escape(args.description)}</description>
  <maintainer email="{escape(args.maintainer_email)}">{escape(args.maintainer_name)}</maintainer>
  <license>{escape(args.license)}</license>

{depends}{chr(10) if depends else ''}{tests}
  <export>
    <build_type>{BUILD_TYPE}</build_type>
  </export>
</package>
'''


def _setup_py(args: argparse.Namespace) -> str:
    entry = f"            '{args.node_name} = {args.package_name}.{args.node_name}:main'\n" if args.node_name else ''
    return f'''from setuptools import find_packages, setup

package_name = {args.package_name!r}

setup(
    name=package_name,
    version='0.0.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages',
            ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer={args.maintainer_name!r},
    maintainer_email={args.maintainer_email!r},
    description={args.description!r},
    license={args.license!r},
    tests_require=['pytest'],
    entry_points={{
        'console_scripts': [
{entry}        ],
    }},
)
'''


# The year in the license of each linter's test, and the test.
_LINTER_TESTS = {'copyright': (2015, '''\
from ament_copyright.main import main
import pytest


# Remove the `skip` decorator once the source file(s) have a copyright header
@pytest.mark.skip(reason='No copyright header has been placed in the generated source file.')
@pytest.mark.copyright
@pytest.mark.linter
def test_copyright():
    rc = main(argv=['.', 'test'])
    assert rc == 0, 'Found errors'
'''), 'flake8': (2017, '''\
from ament_flake8.main import main_with_errors
import pytest


@pytest.mark.flake8
@pytest.mark.linter
def test_flake8():
    rc, errors = main_with_errors(argv=[])
    assert rc == 0, \\
        'Found %d code style errors / warnings:\\n' % len(errors) + \\
        '\\n'.join(errors)
'''), 'pep257': (2015, '''\
from ament_pep257.main import main
import pytest


@pytest.mark.linter
@pytest.mark.pep257
def test_pep257():
    rc = main(argv=['.', 'test'])
    assert rc == 0, 'Found code style errors / warnings'
''')}
_LICENSE_OF_LINTER_TESTS = '''\
# Copyright {year} Open Source Robotics Foundation, Inc.
#
# Licensed under the Apache License, Version 2.0 (the "License");
# you may not use this file except in compliance with the License.
# You may obtain a copy of the License at
#
#     http://www.apache.org/licenses/LICENSE-2.0
#
# Unless required by applicable law or agreed to in writing, software
# distributed under the License is distributed on an "AS IS" BASIS,
# WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
# See the License for the specific language governing permissions and
# limitations under the License.

'''


def _linter_test(linter: str) -> str:
    year, text = _LINTER_TESTS[linter]
    return _LICENSE_OF_LINTER_TESTS.format(year=year) + text


def _node(package: str) -> str:
    return f'''def main():
    print('Hi from {package}.')


if __name__ == '__main__':
    main()
'''
