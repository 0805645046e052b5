"""Predictions of chapter 10.2: what an answer holds, and how long to wait for one."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'You can tell an empty answer from an empty node, and your questions have deadlines.'

RECALLS = (
    Recall('10.2-r1', 'Someone sets three parameters of one node with one `set_parameters` request, and the node '
           'accepts all three. How many parameter events does it publish?', (
        right('3', 'The node decides about each parameter separately, and publishes an event for each.'),
        wrong('1', 'That is what `set_parameters_atomically` does. Here the node decides about each parameter '
              'separately.'),
        wrong('0', 'Events are not for declarations only. A changed value is published too.')),
           otherwise='Three: the node decides about each parameter separately, and publishes an event for each.',
           chapter='10.1', section='What is published, and how often'),
    Recall('10.2-r2', 'The answer of `set_parameters` is a list of results. How do you know which result belongs to '
           'which parameter?', (
        wrong('by the name in each result', 'A result has `successful` and `reason`, but no name.'),
        right('by the order of the results', 'The results come in the order in which the parameters were sent.')),
           chapter='5.3', section='One by one, or all or nothing'),
)

PREDICTIONS = (
    Prediction('10.2-1', 'A request names three parameters, and the node does not have one of them. How many values '
               'come back?', (
        right('0', 'One unknown name empties the whole answer, wherever it stands in the request.'),
        wrong('2', 'The unknown name is not left out of the answer. It empties the whole answer.'),
        wrong('3', 'So the interface promises, with the type *not set* for the unknown one. But one unknown name '
              'empties the whole answer.')),
        otherwise='None: one unknown name empties the whole answer.'),
    Prediction('10.2-2', 'The camera has `frame_rate_hz` and `resolution` with values, and `exposure_ms` without one. '
               'How many values come back if you ask for all three?', (
        right('0', 'A parameter that is declared and has no value empties the answer, as an unknown one does.'),
        wrong('2', 'The one without a value is not left out. It empties the whole answer.'),
        wrong('3', 'So the interface promises. But one without a value empties the whole answer.')),
        otherwise='None: a parameter without a value empties the answer, as an unknown one does.'),
    Prediction('10.2-3', 'The gripper has `force_n`, `gains.kp`, `gains.kd` and `base_frame`. What does '
               '`list_parameters` return for the prefix `gai`?', (
        right('none of the names', 'A prefix consists of whole parts of a name, up to a dot.'),
        wrong('both of the gains', 'A prefix consists of whole parts of a name, up to a dot. Nothing here begins with '
              '`gai` and a dot.'),
        wrong('an error, no names', 'A prefix that matches nothing is not an error. The list is empty.'))),
    Prediction('10.2-4', 'A callback awaits the answer of a node that never answers. After half a second, a timer '
               'cancels the future. What becomes of the `await`?', (
        right('It ends and returns None', 'The `await` ends, since the future is no longer pending. Its `done()` stays '
              'False, its result `None`.'),
        wrong('It raises CancelledError', 'The futures of rclpy are not those of asyncio. The `await` ends, since the '
              'future is no longer pending, and its result is `None`.'),
        wrong('It waits on for an answer', 'Canceling wakes up the callback that awaits the future. Its result is '
              '`None`.'))),
)
