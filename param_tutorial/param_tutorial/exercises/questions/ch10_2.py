"""Predictions of chapter 10.2: what an answer holds, and how long to wait for one."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'You can tell an empty answer from an empty node, and your questions have a deadline.'

RECALLS = (
    Recall('10.2-r1', 'Somebody sets three parameters of one node with `set_parameters`, and the node accepts '
           'all three. How many parameter events does it publish?', (
        wrong('one, with three changes', 'That is so for `set_parameters_atomically`. Here the node decides '
              'about each parameter alone.'),
        right('three', 'The node decides about each parameter alone, and reports each one alone.'),
        wrong('none: events are for declarations', 'A change of a value is reported too.')),
           chapter='10.1', section='Change it: what is published, and how often'),
    Recall('10.2-r2', 'The answer of `set_parameters` is a list of results. How do you know which result belongs '
           'to which parameter?', (
        wrong('Each result has a name', 'A result has `successful` and `reason`, and no name.'),
        right('By the order of the request', 'The results come in the order in which the parameters were sent.')),
           chapter='5.3', section='How it works'),
)

PREDICTIONS = (
    Prediction('10.2-1', 'A request names three parameters, and one of them is unknown. How many values come back?', (
        right('0', 'One unknown name empties the whole answer, wherever it stands in the request.'),
        wrong('2', 'The unknown name is not left out of the answer. It empties the whole of it.'),
        wrong('3', 'There is no place for *unknown* in the answer. One unknown name empties the whole of it.')),
        otherwise='None: one unknown name empties the whole answer.'),
    Prediction('10.2-2', 'A request names no parameter at all. Which values come back?', (
        wrong('all of them', '`get_parameters` answers what it was asked for, and it was asked for nothing.'),
        right('none', 'You asked for nothing, and get it. For all parameters ask `list_parameters` first.'),
        wrong('none, but an error', 'There is no error. An empty request has an empty answer.'))),
    Prediction('10.2-3', 'The arm has `pid.kp`, `pid.ki` and `pid.limits.max`. What does `list_parameters` return for '
               'the prefix `pi`?', (
        wrong('all three: they begin with pi', 'A prefix is whole parts of a name, up to a dot. Nothing here begins '
              'with `pi` and a dot.'),
        right('nothing', 'A prefix is whole parts of a name, up to a dot.'),
        wrong('an error: there is no such group', 'A prefix that fits nothing is no error. The list is empty.'))),
    Prediction('10.2-4', 'The constructor of a node waits half a second for the services of the gripper. The next line '
               'of the program will start the gripper. What does `wait_for_service` return?', (
        wrong('True: the gripper is started in time', 'The next line runs when the constructor has returned, and the '
              'constructor waits for the next line.'),
        right('False', 'The constructor waits for what can only happen when it has returned.'),
        wrong('an exception', '`wait_for_service` with a time limit raises nothing. It returns False when the time is '
              'up.'))),
    Prediction('10.2-5', 'An `AsyncParameterClient` has made six service clients in its node. How many of the six are '
               'left in the node after `del box`?', (
        right('6', 'They belong to the node, and `AsyncParameterClient` has no method that destroys them.'),
        wrong('0', 'The object is gone, and the clients are not: they belong to the node.')),
        otherwise='All six: they belong to the node, and nothing destroys them.'),
)
