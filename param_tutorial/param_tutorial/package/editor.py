"""One of the reader's files in the notebook or the page, to change and save."""

import contextlib
from typing import Any

import traitlets

from param_tools.errors import ParameterToolError, describe_error
from param_tools.markup.scripts import bundle
from param_tools.markup.styles import sheet
from param_tools.markup.tables import with_code
from param_tools.panel.close_with_cell import close_with_cell
from param_tools.panel.front import Front
from param_tools.panel.view import View
from param_tutorial.package.following import FollowedPackage


class _Front(Front):
    """The editor in the browser; it keeps what is typed until that is saved."""

    _esm = bundle('param_tutorial/package/editor.js')
    _css = sheet('param_tutorial/package/editor.css')
    name = traitlets.Unicode().tag(sync=True)
    text = traitlets.Unicode().tag(sync=True)
    """What the file holds."""
    status = traitlets.Unicode().tag(sync=True)
    """What became of it when it was run, as HTML."""
    line = traitlets.Int().tag(sync=True)
    """The number of the line that the status is about; 0 if it is about none."""
    is_error = traitlets.Bool().tag(sync=True)


class FileEditor(View):
    """An editor that shows a file as it is, also when another program changes it. Show it as a cell's last line."""

    def __init__(self, package: FollowedPackage, name: str):
        self._package, self._name = package, name
        self._front = _Front(name=name)
        self._front.on_msg(self._on_message)
        super().__init__([self._front], 'file-editor')
        self._stop_following = package.on_change(self._show)
        self._show()
        close_with_cell(self)

    def __repr__(self) -> str:
        return f'<FileEditor: {self._name}>'

    @property
    def node(self) -> str:
        """The name of the file: it stands in the place of a node's."""
        return self._name

    @property
    def text(self) -> str:
        """What the file holds."""
        return str(self._front.text)

    def save(self, text: str, base: str | None = None) -> None:
        """Save a text, as the button does; see ``FollowedPackage.save``."""
        self._package.save(self._name, text, base)

    def _on_message(self, _widget: object, content: dict[str, Any], _buffers: object) -> None:
        if content.get('do') != 'save':
            return
        try:
            self.save(str(content['text']), str(content['base']))
        except ParameterToolError as error:
            with self._front.hold_sync():
                self._front.status, self._front.line, self._front.is_error = with_code(describe_error(error)), 0, True

    def _show(self) -> None:
        with self._drawing, contextlib.suppress(ParameterToolError), self._front.hold_sync():
            status = self._package.status(self._name)
            self._front.text = self._package.files.text(self._name)
            self._front.status = with_code(status.words)
            self._front.is_error, self._front.line = status.is_error, status.line

    def _end(self) -> None:
        self._stop_following()
