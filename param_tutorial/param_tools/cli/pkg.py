"""ros2 pkg create: write a new Python package (ament_python) into a workspace.

``new_package.txt`` holds the files of ros2pkg 0.32.2 (Copyright Open Source Robotics Foundation, Inc., Apache License
2.0): below each line that begins with ``===``, one file or, where the line ends with a slash, one folder.
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
from string import Template

from param_tools.cli.session import CommandFailed, Commands, Session, add_verbs

BUILD_TYPE = 'ament_python'
# The names for which the genuine command writes a LICENSE file.
LICENSES = ('Apache-2.0', 'BSL-1.0', 'BSD-2.0', 'BSD-2-Clause', 'BSD-3-Clause', 'GPL-3.0-only', 'LGPL-3.0-only',
            'MIT', 'MIT-0')
_TEMPLATE = Path(__file__).with_name('new_package.txt')


def add_to(commands: Commands) -> None:
    create = add_verbs(commands, 'pkg', 'packages').add_parser('create', help='write a new Python package')
    create.add_argument('package_name', help='name of the package')
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
        if name == f'{args.package_name}/':
            session.print('creating source folder')
        session.print('creating folder' if name.endswith('/') else 'creating', os.path.join(folder, name).rstrip('/'))
        if name.endswith('/'):
            Path(folder, name).mkdir()
        else:
            Path(folder, name).write_text(text, encoding='utf-8')
    if args.license in LICENSES:
        session.print(f'\n[WARNING]: No LICENSE file has been created: the text of {args.license} is not at hand '
                      f'here. The genuine command writes it.')
        return
    session.print(f"\n[WARNING]: Unknown license '{args.license}'.  This has been set in the package.xml, but no "
                  f'LICENSE file has been created.\nIt is recommended to use one of the ament license identifiers:')
    session.print(*LICENSES, sep='\n')


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
    session.print('package format:', 3)
    session.print('version:', '0.0.0')
    session.print('description:', args.description)
    session.print('maintainer:', [f'{args.maintainer_name} <{args.maintainer_email}>'])
    session.print('licenses:', [args.license])
    session.print('build type:', BUILD_TYPE)
    session.print('dependencies:', args.dependencies)
    if args.node_name:
        session.print('node_name:', args.node_name)


def _files(args: argparse.Namespace) -> dict[str, str]:
    """Return the text of each file by its path, in their order; a folder's path ends in a slash."""
    name, node = args.package_name, args.node_name
    texts = {'person': args.maintainer_name, 'email': args.maintainer_email, 'description': args.description,
             'license': args.license}
    filled = Template(_TEMPLATE.read_text(encoding='utf-8')).substitute(
        {'name': name, 'node': node,
         'depends': ''.join(f'  <depend>{escape(each)}</depend>\n' for each in args.dependencies)
                    + ('\n' if args.dependencies else ''),
         'entry': f"            '{node} = {name}.{node}:main'\n" if node else ''},
        **{f'xml_{key}': escape(text) for key, text in texts.items()},
        **{f'py_{key}': repr(text) for key, text in texts.items()})
    # What stands before the first of these lines is nothing.
    _, *parts = re.split(r'^=== (.*)\n', filled, flags=re.MULTILINE)
    files = dict(zip(parts[::2], parts[1::2]))
    if not node:
        del files[f'{name}/{node}.py']
    return files
