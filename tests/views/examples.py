"""An example of each drawing: states like those of the chapters, and what is hard to draw."""


from param_tutorial.views.drawing import track
from param_tutorial.views.drawing.calls import Call, Line, draw_calls
from param_tutorial.views.drawing.ladder import Step, draw_ladder
from param_tutorial.views.drawing.number_line import Attempt, Scale, draw_number_line
from param_tutorial.views.drawing.plane import Way, draw_plane
from param_tutorial.views.drawing.plots import Band, LinePlot

# Names and values are text, whatever is in them.
EVIL = '<b>"&'

_ACCEPTED = [
    Step('asked', 'set speed to 900', '100', proposed='900'),
    Step('pre-set', 'trim sees 900, gives 300', '100', who='trim', proposed='300'),
    Step('on-set', 'judge sees 300, accepts', '100', who='judge', proposed='300'),
    Step('stored', 'the value is written', '300'),
    Step('event', 'speed = 300', '300'),
    Step('post-set', 'act sees 300', '300', who='act', proposed='300'),
    Step('answer', 'successful', '300')]
_WHY = 'too fast for this robot and its wheels, which are small'
_REJECTED = [*_ACCEPTED[:2],
             Step('on-set', 'judge sees 300, rejects', '100', who='judge', proposed='300', objection=_WHY),
             Step('answer', f'rejected: {_WHY}', '100', objection=_WHY)]
_OUT_OF_RANGE = [_ACCEPTED[0], Step('answer', 'rejected: out of range', '100', objection='out of range')]
_RAISED = [_ACCEPTED[0], Step('pre-set', 'trim sees 900, raises TypeError', '100', who='trim',
                              objection='raises TypeError'), Step('no answer', 'the caller would wait forever', '100')]
_RAISED_LATE = [*_ACCEPTED[:5], Step('post-set', '', '300', who='act', proposed='300', objection='raises ValueError'),
                Step('no answer', '', '300')]

_CALLS = [
    Call('/arm', 'get_parameters', ('tool', 'pid.kp'), (Line("''"), Line('2.0'))),
    Call('/arm', 'set_parameters', ('kp = 3.0', f'tool = {EVIL}'),
         (Line('accepted', True), Line('rejected: wrong type', False))),
    Call('/arm', 'set_parameters_atomically', ('tool = 5',), (Line('rejected: wrong type', False),)),
    Call('/simple_param_node', 'list_parameters', (), tuple(Line(f'p{number}') for number in range(5))),
    Call('/amr', 'get_parameters', ('tool',), problem='there is no node /amr. Did you mean /arm?', is_delivered=False),
    Call('/dozing', 'list_parameters', (), problem='/dozing did not answer within 0.5 s')]

_PAIRS = {(low, high): low < high for low in range(-10, 71, 10) for high in range(-10, 71, 10)}
_WAYS = [Way('one by one', (50, 60), [('high_c = 10', (50, 10), (50, 60)), ('low_c = 0', (0, 60), (0, 60))]),
         Way('atomically', (50, 60), [('high_c = 10, low_c = 0', (0, 10), (0, 10))])]


DIAGRAMS = {
    'calls': draw_calls('this notebook', _CALLS),
    'calls_none': draw_calls('this notebook', []),
    'ladder_accepted': draw_ladder('/robot', 'speed', _ACCEPTED),
    'ladder_rejected': draw_ladder('/robot', 'speed', _REJECTED, _WHY),
    'ladder_out_of_range': draw_ladder('/robot', 'speed', _OUT_OF_RANGE, 'out of range'),
    'ladder_exception': draw_ladder('/robot', 'speed', _RAISED, 'TypeError: no'),
    'ladder_late_exception': draw_ladder('/robot', 'speed', _RAISED_LATE, 'ValueError: no'),
    'number_line': draw_number_line('/gripper', 'opening_mm', Scale(0, 85, 10), 40),
    'number_line_accepted': draw_number_line('/gripper', 'opening_mm', Scale(0, 85, 10), 80, before=40,
                                             request=Attempt(85, '85')),
    'number_line_rejected': draw_number_line('/gripper', 'opening_mm', Scale(0, 85, 10), 40, request=Attempt(
        45, '45', 'The parameter value for opening_mm is not a valid step')),
    'number_line_locked': draw_number_line('/gripper', 'serial', Scale.around(7), 7, is_locked=True, request=Attempt(
        None, "'x'", 'serial is read-only')),
    'plane': draw_plane(('low_c', 'high_c'), _PAIRS, _WAYS)}

EXAMPLES = {
    **{name: diagram.html(name) for name, diagram in DIAGRAMS.items()},
    'plot': LinePlot({name: [(0, 0.0), (2, number)] for number, name in enumerate(('ramp', EVIL, 'p', 'i'), start=1)},
                     x='time & more in s', y=EVIL, marks={1: 'changed'})._repr_html_(),
    'plot_band': LinePlot({'reference': [(0, 10.0), (3, 10.0)], 'conditional_integration': [(0, 0.0), (1, 10.0)]},
                          x='s', y='rad/s', before=[(0, 0.0), (1, 5.0)], band=Band(0.4, 9.7, 10.3))._repr_html_(),
    'track': track.draw_track(track.Moment(f'/{EVIL}', 4.0, 2.0, 0.5, 1.0))}
