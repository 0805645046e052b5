"""Steps of the reader's own package as answers: the check makes the driver's node in its corner, and is its base."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from geometry_msgs.msg import Twist
from rclpy.node import Node
from sensor_msgs.msg import Range

from param_tutorial.exercises.exercise import Kind
from param_tutorial.exercises.trial import NoUse, Trial, cleared, expect
from param_tutorial.learner.package_files import PackageFiles
from param_tutorial.package.following import FollowedPackage
from param_tutorial.package.loading import LoadError, load_node_class


def _path(work: FollowedPackage | PackageFiles, name: str) -> Path:
    files = work.files if isinstance(work, FollowedPackage) else work
    if not files.text(name).strip():
        raise NoUse(f'a file `{name}` in your package', 'there is none, or nothing in it')
    return files.path(name)


def class_of(path: Path) -> type[Node]:
    """Return the class of nodes in one of the reader's files.

    :raises NoUse: there is none.
    """
    try:
        return load_node_class(path, path.parents[1])
    except LoadError as error:
        raise NoUse(f'a class of nodes in `{path.name}`', str(error)) from None


def _is_package(work: Any) -> bool:
    return isinstance(work, (FollowedPackage, PackageFiles))


PACKAGE = Kind('your package, as `Package(...)` has returned it', _is_package, 'package',
               lambda work: getattr(work, 'files', work))
"""The files of the reader's package."""
DRIVER = PACKAGE._replace(open=lambda work: class_of(_path(work, 'driver_node.py')))
"""The class of nodes in the reader's driver."""
DRIVER_PROGRAM = DRIVER._replace(open=lambda work: _path(work, 'driver_node.py'))
"""The file itself, as a program."""
TUNER = DRIVER._replace(open=lambda work: class_of(_path(work, 'tuner_node.py')))
TUNER_PROGRAM = DRIVER._replace(open=lambda work: _path(work, 'tuner_node.py'))


class Bench(Node):
    """Stands in for the base of the reader's robot: hears what the driver commands, and tells it a distance.

    The wall is far at first, so a driver that stops before it drives in the earlier steps, too.
    """

    def __init__(self) -> None:
        super().__init__('bench')
        self.speeds_mps: list[float] = []
        """All that was commanded, oldest first."""
        self._distance_m: float | None = 10.0
        self.create_subscription(Twist, 'cmd_vel', self._hear, 10)
        self._distances = self.create_publisher(Range, 'distance', 10)
        self.create_timer(0.05, self._tell)

    def _hear(self, command: Twist) -> None:
        self.speeds_mps.append(command.linear.x)

    def measure(self, distance_m: float | None) -> None:
        """Tell the driver this distance from now on, again and again, as a sensor does; None tells it nothing."""
        self._distance_m = distance_m

    def _tell(self) -> None:
        if self._distance_m is not None:
            self._distances.publish(Range(range=self._distance_m, max_range=50.0))


def start_on_bench(trial: Trial, *words: str) -> tuple[Node, Bench]:
    """Start the learner's driver, with arguments, beside a bench."""
    bench = trial.start(Bench)
    return trial.start(ros_args=words), bench


def expect_commands(trial: Trial, bench: Bench) -> None:
    """Expect the driver to publish commands, again and again."""
    expected = 'a `Twist` on `cmd_vel`, again and again'
    node = next(each for each in trial.ros.nodes if isinstance(each, trial.work))
    topics = {each.topic_name.rpartition('/')[2] for each in node.publishers} - {'rosout', 'parameter_events'}
    expect('cmd_vel' in topics, expected, 'it publishes on ' + ', '.join(f'`{each}`' for each in sorted(topics))
           if topics else 'it has no publisher')
    before = len(bench.speeds_mps)
    trial.wait(lambda: len(bench.speeds_mps) >= before + 3, expected,
               lambda: 'it has the publisher, and hardly uses it. Does a timer call the method that publishes?')


def expect_speed(trial: Trial, bench: Bench, speed_mps: float, when: str,
                 because: Mapping[float, str] | None = None) -> None:
    """Expect the driver to command a speed, and to stay with it.

    :param because: For speeds that it may command instead, what to think of.
    """
    expected = f'`linear.x` is {speed_mps!r} {when}'
    before = len(bench.speeds_mps)

    def is_commanded() -> bool:
        last = bench.speeds_mps[before:][-2:]
        return len(last) == 2 and all(abs(each - speed_mps) < 1e-6 for each in last)

    def happened() -> str:
        if not bench.speeds_mps:
            return 'nothing is published on `cmd_vel`'
        found = bench.speeds_mps[-1]
        remark = (because or {}).get(found) or ('' if found else 'Does the node set `linear.x`, and to a float?')
        return f'it is {found!r}' + (f'. {remark}' if remark else '')

    trial.wait(is_commanded, expected, happened)


def expect_start_speeds(trial: Trial) -> None:
    """Expect the driver to command the speed with which it has started, the default or an override."""
    for speed_mps, *words in ((0.5,), (0.75, '-p', 'max_speed_mps:=0.75')):
        with cleared(trial.ros):
            _, bench = start_on_bench(trial, *words)
            expect_speed(trial, bench, speed_mps, f'after a start with `max_speed_mps = {speed_mps}`')
