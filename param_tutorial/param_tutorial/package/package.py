"""The reader's package, as a chapter works with it."""

from param_tutorial.package.editor import FileEditor
from param_tutorial.package.following import FollowedPackage
from param_tutorial.package.robot import RobotPicture


class Package(FollowedPackage):
    """The reader's package on the stage, with what a chapter shows of it."""

    def edit(self, name: str = 'driver_node.py') -> FileEditor:
        """Return an editor of one of the files.

        :param name: Its path in the package, or that of a node's file without its folder.
        """
        return FileEditor(self, name)

    @property
    def robot(self) -> RobotPicture:
        """The robot that the nodes drive, to be seen."""
        return RobotPicture(self)
