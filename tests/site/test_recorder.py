"""The recorder knows no view: it records anything that implements the protocol, and says what the page needs."""

import ast
import gc
import json
import math

import ipywidgets as widgets
import pytest
from rcl_interfaces.msg import IntegerRange, ParameterDescriptor
from rclpy.node import Node

from param_tools.node.client import ParameterClient
from param_tools.panel import recordable
from param_tools.panel.view import View
from param_tutorial import ParameterPanel
from param_tutorial.nodes.clawbot_node import ClawbotNode
from param_tutorial.site import archive
from param_tutorial.site.pages import drawing
from param_tutorial.site.recording import album, interview, recorder
from param_tutorial.views import EventView, LogView, RobotView
from param_tutorial.views.drawing import driving
from param_tutorial.views.robot import vehicle_of
from tests.support.albums import unpack
from tests.support.paths import PACKAGE

NO_PAGE = {'literals': [], 'source': '', 'views': [], 'albums': []}


class Oven(Node):
    def __init__(self):
        super().__init__('oven')
        self.declare_parameter('heat', 2, ParameterDescriptor(
            integer_range=[IntegerRange(from_value=0, to_value=4, step=1)]))


class Thermometer(View):
    """A view that the recorder has never heard of."""

    in_motion = False

    def __init__(self, node):
        self._name = node
        super().__init__([widgets.HTML('<b>heat</b>'), widgets.HBox([widgets.HTML('<i>now</i>')])], 'thermometer')

    @property
    def node(self):
        return self._name

    def rest(self):
        pass

    def look(self):
        return str(ParameterClient(self._name).get_parameter('heat'))

    def moments(self, step_sec):
        return ()

    def film(self, *, start=None):
        return None

    def _end(self):
        pass


@pytest.fixture
def oven(ros):
    ros.add(Oven)
    views = []

    def show(view):
        views.append(view)
        return view

    yield show
    for view in views:
        view.close()


def test_a_new_view_is_recorded_as_it_stands(oven):
    view = oven(Thermometer('/oven'))
    recording = recorder.record(view.model_id, NO_PAGE)
    assert recording['html'] == ('<div class="thermometer"><div class=""><b>heat</b></div>'
                                 '<div class=""><div class=""><i>now</i></div></div></div>')
    assert '<b>heat</b>' in drawing.Drawer('page').draw(recording)


@pytest.mark.slow
def test_a_page_pictures_a_node_with_a_view_of_a_later_cell(oven):
    views = recorder.describe([oven(Thermometer('/oven')).model_id])
    assert views == [{'node': '/oven', 'follows': [], 'portrait': f'{__name__}:Thermometer'}]
    recording = recorder.record(oven(ParameterPanel('/oven')).model_id, {**NO_PAGE, 'views': views})
    assert recording['names'] == ['heat']
    assert unpack(recording['looks']) == {f'heat={text}': text for text in '01234'}
    assert json.loads(json.dumps(recording)) == recording


def test_of_a_panel_with_too_many_parameters_the_first_are_asked_for_and_the_others_say_so(oven, monkeypatch):
    monkeypatch.setattr(interview, '_MOST_ASKED', 1)
    recording = recorder.record(oven(ParameterPanel('/oven')).model_id, NO_PAGE)
    first, *others = [row for row in recording['rows'] if row['name'] != 'start_type_description_service']
    assert 'answers' in first and not first['locked']
    assert others and all(row['locked'] and 'answers' not in row for row in others)
    drawn = drawing.Drawer('page').draw(recording)
    assert drawn.count('Not recorded: run the notebook to change it.') == len(others)


@pytest.mark.slow
def test_a_view_of_another_node_takes_no_pictures(oven):
    views = [{'node': '/fridge', 'follows': [], 'portrait': 'nowhere:Nothing'}]
    recording = recorder.record(oven(ParameterPanel('/oven')).model_id, {**NO_PAGE, 'views': views})
    assert 'looks' not in recording and 'films' not in recording


@pytest.mark.slow
def test_events_are_recorded_where_the_page_has_a_view_that_follows_them(oven):
    panel, table, log = oven(ParameterPanel('/oven')), oven(EventView()), oven(LogView())
    assert [each['follows'] for each in recorder.describe([panel.model_id, table.model_id, log.model_id])] == [
        [], ['events'], ['log']]
    for shown, expected in (([log], None), ([log, table], [['changed', 'heat', '3']])):
        page = {**NO_PAGE, 'views': recorder.describe([each.model_id for each in shown])}
        answers = recorder.record(panel.model_id, page)['rows'][0]['answers']
        assert answers['3'].get('events') == expected


def test_a_robot_that_is_not_there_is_recorded_as_it_stands(ros):
    view = RobotView('/nobody')
    recording = recorder.record(view.model_id, NO_PAGE)
    view.close()
    assert recording['kind'] == 'still' and '/nobody is not running' in recording['html']


def test_a_robot_is_recorded_at_rest_and_with_its_drive(ros):
    robot = ros.add(ClawbotNode, real_time=False)
    view = RobotView(robot)
    recording = recorder.record(view.model_id, NO_PAGE)
    view.close()
    assert recording['kind'] == 'robot' and recording['node'] == '/clawbot_node'
    film, = recording['films']
    assert film['changed'] == {} and film['look'] == recording['look']
    assert [scene[1] for scene in film['scenes']][-1] == 'STOPPED'


@pytest.mark.slow
def test_a_change_on_the_way_is_filmed_as_the_node_goes_on(ros):
    robot = ros.add(ClawbotNode, real_time=False)
    view = RobotView(robot)
    panel = ParameterPanel(robot, names=['max_acceleration_mps2', 'enable_safety_mode'])
    recording = recorder.record(panel.model_id, {**NO_PAGE, 'views': recorder.describe([view.model_id])})
    turns = unpack(recording['albums'][recording['turns']])
    # Up to 1.05 m/s with 0.5 m/s², 1.5 m, and down again: at each half second before 5.71 s, 11 of them.
    assert {name.rpartition('\n')[2] for name in turns} == {str(number) for number in range(1, 12)}
    client = ParameterClient(robot)
    for name, value, text in (('enable_safety_mode', False, 'false'), ('max_acceleration_mps2', 2.0, '2.0')):
        for number in (1, 5, 9):
            robot.drive()
            robot.step(number * album.TURN_SEC)
            before = client.get_parameter(name)
            client.set_parameter(name, value).raise_for_reason()
            scenes = driving.scenes(vehicle_of(robot, robot.motion[0]))
            assert turns[f'{name}={text}\n{number}']['scenes'] == [
                [pytest.approx(at_sec, abs=1e-3), *words, lean_rad] for at_sec, *words, lean_rad in scenes]
            robot.step(math.inf)
            client.set_parameter(name, before).raise_for_reason()
    view.close()
    panel.close()


@pytest.mark.slow
@pytest.mark.thorough
def test_every_combination_of_what_the_sliders_offer_is_filmed_once_for_a_page(ros):
    robot = ros.add(ClawbotNode, real_time=False)
    view = RobotView(robot)
    panel = ParameterPanel(robot, names=['max_speed_rpm', 'enable_safety_mode'])
    page = {**NO_PAGE, 'source': "panel['max_speed_rpm'].value = 77", 'views': recorder.describe([view.model_id])}
    recording = recorder.record(panel.model_id, page)
    films, speed = unpack(recording['albums'][recording['films']]), recording['rows'][0]
    assert {'0', '50', '77', '100', '300'} <= set(speed['positions'])
    for text in speed['positions']:
        for safety in ('true', 'false'):
            assert f'enable_safety_mode={safety}\nmax_speed_rpm={text}' in films
    last_words = {safety: films[f'enable_safety_mode={safety}\nmax_speed_rpm=100']['scenes'][-1][3]
                  for safety in ('true', 'false')}
    assert last_words == {'true': 'Clawbot has stopped 0.20 m from the wall.',
                          'false': 'Clawbot has run into the wall at 1.05 m/s.'}
    again = recorder.record(panel.model_id, {**page, 'albums': list(recording['albums'])})
    assert again['albums'] == {} and again['films'] == recording['films'] and again['turns'] == recording['turns']
    for each in (panel, view):
        each.close()
    assert robot.get_parameter('max_speed_rpm').value == 100


def test_what_stands_still_is_recorded_at_once_and_what_a_question_would_disturb_is_not(oven):
    assert recorder.record_still(oven(Thermometer('/oven')).model_id, NO_PAGE)['kind'] == 'still'
    assert recorder.record_still(oven(ParameterPanel('/oven')).model_id, NO_PAGE) == {}
    assert recorder.record_still(oven(LogView()).model_id, NO_PAGE) == {}
    assert recorder.record_still(widgets.HTML('x').model_id, NO_PAGE) is None


def test_a_widget_that_is_no_view_is_not_recorded(ros):
    assert recorder.record(widgets.HTML('x').model_id, NO_PAGE) is None
    assert recorder.describe([widgets.HTML('x').model_id]) == []


@pytest.mark.slow
def test_a_view_that_is_gone_is_not_kept(oven):
    view = Thermometer('/oven')
    model_id = view.model_id
    assert recordable.find(model_id) is view
    view.close()
    del view
    gc.collect()
    assert recordable.find(model_id) is None


@pytest.mark.slow
def test_a_recording_depends_on_nothing_of_the_pages():
    """So the digest under which recordings are kept may leave the rest of the lessons out."""
    room = PACKAGE / 'site'
    imported = lessons_imported_by((room / 'recording').glob('*.py'))
    assert len(imported) > 5
    assert [name for name in imported if not name.startswith('param_tutorial.site.recording')] == []
    assert lessons_imported_by(path for path in PACKAGE.rglob('*.py') if room not in path.parents) == set()


def lessons_imported_by(paths):
    """Return the modules of the lessons that files import."""
    found = set()
    for path in paths:
        for statement in ast.walk(ast.parse(path.read_text())):
            if isinstance(statement, ast.Import):
                found |= {alias.name for alias in statement.names}
            elif isinstance(statement, ast.ImportFrom) and statement.module:
                found.add(statement.module)
    return {name for name in found if name.startswith('param_tutorial.site')}


@pytest.mark.parametrize('name, runs_again', [
    ('site/recording/questions.py', True), ('views/log.py', True),
    ('site/pages/drawing.py', False), ('site/theme/_static/lesson.css', False)])
def test_what_a_chapter_runs_again_for(monkeypatch, tmp_path, name, runs_again):
    for path in ('site/recording/questions.py', 'site/pages/drawing.py', 'site/theme/_static/lesson.css',
                 'views/log.py'):
        file = tmp_path / 'ros' / 'package' / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text('before')
    monkeypatch.setattr(archive, 'ROOT', tmp_path)
    monkeypatch.setattr(archive, 'PACKAGE_ROOT', tmp_path / 'ros')
    monkeypatch.setattr(archive, '_SITE', tmp_path / 'ros' / 'package' / 'site')
    before = archive.digest_of_surroundings()
    (tmp_path / 'ros' / 'package' / name).write_text('after')
    assert (archive.digest_of_surroundings() != before) is runs_again
