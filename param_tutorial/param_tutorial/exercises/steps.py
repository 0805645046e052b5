"""Steps of the reader's own package as answers: the check makes the driver's node in its corner, and is its base."""

import contextlib
import itertools
import os
import shutil
import sys
import tempfile
import time
import types
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple
from xml.etree import ElementTree

from geometry_msgs.msg import Twist
from rclpy.node import Node
from rclpy.task import Future
from sensor_msgs.msg import Range

from param_tools.cli.launch.actions import LaunchDescription
from param_tools.cli.launch.context import Context, LaunchFailed
from param_tools.cli.launch.processes import Program
from param_tools.cli.launch.reading import load_description
from param_tools.markup.styles import style
from param_tools.ros.environment import PACKAGE_IN_WORK
from param_tools.ros.service_types import SERVICE_TYPES
from param_tutorial.exercises.exercise import Kind
from param_tutorial.exercises.trial import NotYet, NoUse, Trial, cleared, describe_error, expect
from param_tutorial.learner.package_files import NAME, PackageFiles
from param_tutorial.nodes.base_node import TICK_SEC, BaseNode
from param_tutorial.nodes.driver_node import DriverNode
from param_tutorial.package.following import FollowedPackage
from param_tutorial.package.loading import LoadError, load_node_class
from param_tutorial.views.drawing.track import Moment, draw_track

LAUNCH, CONFIG = 'launch/my_robot_launch.py', 'config/my_robot.yaml'
# The driver of chapter 5.2 takes a high speed only with a long distance; those before it have no such parameter.
FAR = '-p', 'stop_distance_m:=5.0'

# How long a command takes from the distance that the base has measured, as on the stage.
DELAY_TICKS = 1
PATIENCE_SEC = 300.0
STYLE = style('param_tutorial/views/drawing/track.css')


def file_of(work: FollowedPackage | PackageFiles, name: str) -> Path:
    """Return the path of a file in the reader's package.

    :raises NoUse: there is none, or nothing is in it.
    """
    files = work.files if isinstance(work, FollowedPackage) else work
    if not files.text(name).strip():
        raise NoUse(f'a file `{name}` in your package', 'there is none, or nothing in it')
    return files.path(name)


def text_of(work: FollowedPackage | PackageFiles, name: str) -> str:
    """Return the text of a file in the reader's package.

    :raises NoUse: there is none, or nothing in it.
    """
    return file_of(work, name).read_text(encoding='utf-8')


def class_of(path: Path) -> type[Node]:
    """Return the class of nodes in one of the reader's files.

    :raises NoUse: there is none.
    """
    try:
        return load_node_class(path, path.parents[1])
    except LoadError as error:
        raise NoUse(f'a class of nodes in `{path.name}`', str(error)) from None


PACKAGE = Kind('your package, as `Package(...)` has returned it',
               lambda work: isinstance(work, (FollowedPackage, PackageFiles)), 'package',
               lambda work: getattr(work, 'files', work))
"""The files of the reader's package."""
DRIVER = PACKAGE._replace(open=lambda work: class_of(file_of(work, 'driver_node.py')))
"""The class of nodes in the reader's driver."""
DRIVER_PROGRAM = DRIVER._replace(open=lambda work: file_of(work, 'driver_node.py'))
"""The file itself, as a program."""
TUNER = DRIVER._replace(open=lambda work: class_of(file_of(work, 'tuner_node.py')))
TUNER_PROGRAM = DRIVER._replace(open=lambda work: file_of(work, 'tuner_node.py'))


def package_xml(files: PackageFiles) -> ElementTree.Element:
    """Return the root of the reader's package.xml.

    :raises NoUse: ROS would not take it.
    """
    text = files.text('package.xml')
    if not text.strip():
        raise NoUse('a `package.xml` in your package', 'there is none, or nothing in it')
    try:
        root = ElementTree.fromstring(text.encode())
    except ElementTree.ParseError as error:
        line, _ = error.position
        shown = text.splitlines()[min(line, text.count('\n')) - 1].strip()
        raise NoUse('a `package.xml` that can be read, or ROS finds no package', f'{error}: `{shown}`') from None
    for tag, wanted in (('name', NAME), ('export/build_type', 'ament_python')):
        found = (root.findtext(tag) or '').strip()
        if found != wanted:
            raise NoUse(f'a `package.xml` that says `{wanted}` in `<{tag.rpartition("/")[2]}>`', f'it says `{found}`')
    return root


def needed_packages(root: ElementTree.Element) -> set[str]:
    """Return the packages that a package.xml names as needed when the package runs."""
    return {(each.text or '').strip() for tag in ('depend', 'exec_depend') for each in root.findall(tag)}


def remark_elsewhere(root: ElementTree.Element, names: Iterable[str]) -> str:
    """Return a sentence about the element in which packages stand that are not among those needed, if there is one."""
    tags = sorted({each.tag for each in root.iter() if (each.text or '').strip() in names})
    return f'. A `<{tags[0]}>` says something else' if tags else ''


def expect_entry_points(trial: Trial, root: Path, *names: str) -> None:
    """Expect the ``setup.py`` in a package's folder to make an executable of ``main`` in each node's file."""
    found = {''.join(str(each).split()) for given in setup_calls(trial, root)
             for each in given.get('entry_points', {}).get('console_scripts', ())}
    for name in names:
        line = f'{name} = my_robot.{name}:main'
        # Python joins two strings that have no comma between them.
        is_joined = any(line.replace(' ', '') in each for each in found)
        expect(line.replace(' ', '') in found, f'`{line!r}` among the `console_scripts`', 'there is no such line' + (
            '. Is there a comma between it and the other line?' if is_joined else ''))


def installed_files(trial: Trial, root: Path) -> dict[str, str]:
    """Return what the ``setup.py`` in a package's folder installs as data: each path in the install space, and its
    source in the package.

    :raises NoUse: it cannot be run, or names files that are not there.
    """
    try:
        found = {f'{place}/{Path(source).name}': str(source) for given in setup_calls(trial, root)
                 for place, sources in given.get('data_files', ()) for source in _as_list(sources)}
    except (TypeError, ValueError) as error:
        raise NoUse('`data_files` with pairs of a folder and a list of files', describe_error(error)) from None
    missing = [each for each in found.values() if not (root / each).is_file()]
    if missing:
        raise NoUse('entries in `data_files` for files that are there', f'there is no `{missing[0]}`')
    return found


def expect_installed(trial: Trial, name: str) -> None:
    """Expect a file of the package to be installed where a launch looks for it."""
    found = [target for target, source in installed_files(trial, trial.work.root).items() if Path(source) == Path(name)]
    expect(f'share/{NAME}/{name}' in found, f'`share/{NAME}/{name}` in the install space',
           'it goes to ' + ', '.join(f'`{each}`' for each in sorted(found)) if found
           else f'no entry of `data_files` has `{name}`')


def _as_list(sources: Any) -> list[Any]:
    if isinstance(sources, str):
        raise TypeError(f'`{sources}` is no list')
    return list(sources)


def setup_calls(trial: Trial, root: Path) -> list[dict[str, Any]]:
    """Run the ``setup.py`` of a package in its folder, as a build does, and return what it gives to ``setup``.

    Nothing is built, so it works in a page, too.

    :raises NoUse: it does not run to its end.
    """
    try:
        return trial.call('it', _run_setup, root)  # type: ignore[no-any-return]
    except NotYet as error:
        raise NoUse('a `setup.py` that Python can run', error.happened) from None


def _run_setup(root: Path) -> list[dict[str, Any]]:
    calls: list[dict[str, Any]] = []
    recorder = types.ModuleType('setuptools')
    recorder.__dict__.update(setup=lambda **words: calls.append(words), find_packages=lambda *_, **__: [NAME])
    path = root / 'setup.py'
    code = compile(path.read_text(encoding='utf-8'), str(path), 'exec')
    before, folder = sys.modules.get('setuptools'), Path.cwd()
    sys.modules['setuptools'] = recorder
    os.chdir(root)
    try:
        exec(code, {'__name__': '__main__', '__file__': path.name})
    finally:
        os.chdir(folder)
        if before is None:
            del sys.modules['setuptools']
        else:
            sys.modules['setuptools'] = before
    return calls


class Silent(Node):
    """A node whose parameter services are there, and never answer. It notes when it is asked."""

    NAME = ''

    def __init__(self) -> None:
        super().__init__(self.NAME, start_parameter_services=False)
        self.times_asked: list[float] = []
        for name, service_type in SERVICE_TYPES.items():
            self.create_service(service_type, f'~/{name}', self.take)

    async def take(self, _request: object, response: object) -> object:
        self.times_asked.append(time.monotonic())
        return await Future()


def log_of(trial: Trial, node: Node, since_ns: int, *levels: str) -> list[str]:
    """Return what a node has logged since a time.

    :param levels: Only lines of these; by default all.
    """
    return [each.text for each in trial.ros.node_log.recent(node.get_fully_qualified_name(), 500)
            if each.time_ns >= since_ns and (not levels or each.level in levels)]


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


class Drive(NamedTuple):
    """How a drive has ended."""

    fastest_mps: float
    gap_m: float
    """How far the robot is from the wall."""
    crash_speed_mps: float | None
    """How fast it hit the wall, if it did."""
    took_sec: float


def drive(trial: Trial, floor: Mapping[str, float] = MappingProxyType({})) -> Drive:
    """Let a new robot drive with the learner's settings until it is at rest; no time passes meanwhile.

    :param floor: Values of the base's parameters.
    :raises NoUse: it does not drive at all.
    """
    base, driver = trial.start(BaseNode), trial.start(DriverNode)
    trial.client(base).set_parameters(floor)
    trial.client(driver).set_parameters(trial.work)

    def run() -> tuple[float, float]:
        # The executor's thread is busy with this, so no message and no timer comes between.
        base.reset()
        commands, speeds = deque([0.0] * DELAY_TICKS), [0.0]
        for _ in range(round(PATIENCE_SEC / TICK_SEC)):
            driver.measure(Range(range=base.distance_m))
            commands.append(driver.speed_mps)
            command = Twist()
            command.linear.x = commands.popleft()
            base.take_command(command)
            base.tick()
            speeds.append(base.speed_mps)
            if base.has_crashed or (base.position_m > 0 and not any((base.speed_mps, *commands))):
                break
        return max(speeds), len(speeds) * TICK_SEC

    fastest_mps, took_sec = trial.ros.run(run, 'a drive')
    if not base.position_m:
        raise NoUse('a robot that drives', 'it stays at the start')
    crash_speed_mps = base.crash_speed_mps if base.has_crashed else None
    wall_m = base.position_m + base.distance_m
    picture = draw_track(Moment('/base', wall_m, base.position_m, 0.0, 0.0, crash_speed_mps))
    trial.picture = f'{STYLE}<div class="robot-view">{picture}</div>'
    return Drive(fastest_mps, base.distance_m, crash_speed_mps, took_sec)


def expect_settings(trial: Trial) -> None:
    """Expect the learner's work to be settings that the driver accepts.

    :raises NoUse: they are none, or it rejects one.
    """
    if not trial.work:
        raise NoUse('at least one parameter and its value', 'there is no setting yet')
    for name in trial.work:
        if not isinstance(name, str):
            raise NoUse('the names of parameters, as strings', f'`{name!r}` is not a string')
    try:
        results = trial.client(trial.start(DriverNode)).set_parameters(trial.work)
    except (TypeError, ValueError) as error:
        raise NoUse('values that a parameter can hold', describe_error(error)) from None
    rejected = [str(result) for result in results if not result.successful]
    if rejected:
        raise NoUse('no value is rejected', '; '.join(rejected))


class Launched(NamedTuple):
    """What a launch file starts."""

    words: list[str]
    """What follows ``--ros-args``; a parameter file by its name in ``files``."""
    files: dict[str, str]
    """The text of each parameter file."""
    warnings: list[str]
    """What the launch warns of."""
    arguments: list[str]
    """The names of the arguments that the launch file declares."""

    def start(self, trial: Trial) -> Node:
        """Put the driver on the stage, in the corner.

        :raises NoStart: it does not start.
        """
        driver = class_of(trial.work.path('driver_node.py'))
        namespace = next((word.partition(':=')[2] for word in self.words if word.startswith('__ns:=')), '')
        return trial.start_with_files(driver, self.files, *self.words, namespace=namespace.rstrip('/'))


@contextlib.contextmanager
def copied(files: PackageFiles, config: str) -> Iterator[Path]:
    """Yield a copy of the reader's package, in which commands find it, with another text as its parameter file."""
    with tempfile.TemporaryDirectory(prefix='param_tutorial_') as folder:
        root = Path(folder, NAME)
        shutil.copytree(files.root, root, ignore=shutil.ignore_patterns('__pycache__'))
        (root / CONFIG).parent.mkdir(exist_ok=True)
        (root / CONFIG).write_text(config, encoding='utf-8')
        # A build of the package that has been sourced would come first.
        wanted = {PACKAGE_IN_WORK: str(root), 'AMENT_PREFIX_PATH': ''}
        before = {name: os.environ.get(name) for name in wanted}
        os.environ.update(wanted)
        try:
            yield root
        finally:
            for name, value in before.items():
                os.environ.pop(name)
                if value is not None:
                    os.environ[name] = value


def carry_out(trial: Trial, root: Path, name: str, arguments: Mapping[str, str], log: Callable[[str, str, str], object]
              ) -> tuple[LaunchDescription, list[Program]]:
    """Return what a launch file of the package in a folder says, and what ``ros2 launch`` would start.

    :raises NotYet: it cannot be carried out.
    """
    def work_out() -> tuple[LaunchDescription, list[Program]]:
        description = load_description(root / name)
        return description, description.execute(Context(dict(arguments), root, log=log))

    try:
        return trial.call('the launch file', work_out)  # type: ignore[no-any-return]
    except NotYet as error:
        raise NotYet('a launch file that `ros2 launch` can run', error.happened.replace(
            f'{root}/', '').removeprefix(f'{LaunchFailed.__name__}: ')) from None


def launch(trial: Trial, config: str, given: str | None = None, **arguments: str) -> Launched:
    """Work out what ``ros2 launch`` would start.

    :param config: The text of the parameter file in the package.
    :param given: The text of one for the argument ``params_file``; empty for one that is not there.
    :param arguments: Of the launch file, besides ``params_file``.
    :raises NotYet: it cannot be carried out.
    :raises NoUse: there is no launch file, or it starts something else than the driver.
    """
    file_of(trial.work, LAUNCH)
    with copied(trial.work, config) as root:
        warnings: list[str] = []
        if given is not None:
            path = root / 'given.yaml'
            arguments['params_file'] = str(path)
            if given:
                path.write_text(given, encoding='utf-8')

        description, found = carry_out(trial, root, LAUNCH, arguments, lambda level, _, text: warnings.append(text)
                                       if level == 'WARNING' else None)
        if [program.name for program in found] != ['driver_node']:
            names = ', '.join(f'`{program.name}`' for program in found) or 'nothing'
            raise NoUse('a launch file that starts `driver_node`, once', f'it starts {names}')
        command = found[0].command
        words = command[command.index('--ros-args') + 1:]
        paths = [word for option, word in itertools.pairwise(words) if option == '--params-file']
        for each in paths:
            if not Path(each).is_absolute():
                raise NoUse('a path that leads to the file from every folder',
                            f'`{each}` leads there only from the folder `{Path.cwd().name}`')
        short = {path: f'{position}.yaml' for position, path in enumerate(paths)}
        return Launched([short.get(word, word) for word in words],
                        {name: Path(path).read_text(encoding='utf-8') for path, name in short.items()},
                        [each.replace(f'{root}/', '') for each in warnings],
                        [each.declaration.name for each in description.declared_arguments()])
