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
    Prediction('10.2-2', 'A request names no parameter at all. Which values come back?', (
        wrong('all of its values', '`get_parameters` returns what it was asked for, and it was asked for nothing.'),
        right('none of its values', 'As the request says: nothing asked, nothing answered. To get all parameters, call '
              '`list_parameters` first.'),
        wrong('none, but an error', 'There is no error. An empty request has an empty answer.'))),
    Prediction('10.2-3', 'The arm has `pid.kp`, `pid.ki` and `pid.limits.max`. What does `list_parameters` return for '
               'the prefix `pi`?', (
        right('none of the names', 'A prefix consists of whole parts of a name, up to a dot.'),
        wrong('all three names', 'A prefix consists of whole parts of a name, up to a dot. Nothing here begins with '
              '`pi` and a dot.'),
        wrong('an error, no names', 'A prefix that matches nothing is not an error. The list is empty.'))),
    Prediction('10.2-4', 'One callback sends a hundred questions in a row through one client, and then is busy for '
               'half a second. Meanwhile the node in the other process answers each of them. How many answers does the '
               'client take in?', (
        wrong('all, one after another', 'The node answers all of them, but the client keeps only ten answers until the '
              'executor gets around to them.'),
        wrong('fewer, with error reports', 'There is no error. The future of a lost answer is never done.'),
        right('fewer, without an error', 'The client keeps only ten answers until the executor gets around to them. '
              'Older ones are lost without a word.'))),
    Prediction('10.2-5', 'The constructor of a node waits half a second for the services of the gripper. The next line '
               'of the program will start the gripper. What does `wait_for_service` do?', (
        wrong('It returns True', 'The next line runs once the constructor has returned, and the constructor waits for '
              'the next line.'),
        wrong('It raises an error', 'With a time limit, `wait_for_service` raises nothing. It returns False when the '
              'time is up.'),
        right('It returns False', 'The constructor waits for something that can only happen once it has returned.'))),
    Prediction('10.2-6', 'A callback awaits the answer of a node that never answers. After half a second, a timer '
               'cancels the future. What becomes of the `await`?', (
        right('It ends and returns None', 'The `await` ends, since the future is no longer pending. Its `done()` stays '
              'False, its result `None`.'),
        wrong('It raises CancelledError', 'The futures of rclpy are not those of asyncio. The `await` ends, since the '
              'future is no longer pending, and its result is `None`.'),
        wrong('It waits on for an answer', 'Canceling wakes up the callback that awaits the future. Its result is '
              '`None`.'))),
    Prediction('10.2-7', 'An `AsyncParameterClient` has created six service clients in its node. How many of the six '
               'are left in the node after `del parameter_client`?', (
        right('6', 'They belong to the node, and `AsyncParameterClient` has no method that destroys them.'),
        wrong('0', 'The object is gone, but its clients are not: they belong to the node.')),
        otherwise='All six: they belong to the node, and nothing destroys them.'),
)
