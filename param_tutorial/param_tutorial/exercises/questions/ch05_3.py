"""Predictions of chapter 5.3: one node sets the parameters of another."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'You set the parameters of others without waiting for them. The executor thanks you.'

RECALLS = (
    Recall('5.3-r1', 'In which callback may a node start its motor with the new value?', (
        wrong('pre-set', 'It runs first, before the type of anything has been checked.'),
        wrong('on-set', 'It sees a proposal. Another callback may still reject it, and then the motor runs at a '
              'speed that no parameter holds.'),
        right('post-set', 'It runs when the values are stored.')),
           chapter='5.2', section='The callback ladder'),
    Recall('5.3-r2', '`ros2 param set /robot enable_safety_mode off` is typed in a terminal. What reaches the '
           'node?', (
        wrong("the string 'off'", 'YAML 1.1 has more words for false than `false`. For a string, two pairs of '
              'quotes are needed.'),
        right('the boolean False', 'The command reads the word as YAML 1.1, where `off` means false.'),
        wrong('the integer 0', 'YAML has booleans, and `off` is one of them.')),
           chapter='5.1', section='Break it: which type did you mean?'),
)

PREDICTIONS = (
    Prediction('5.3-1', 'One request asks for four values, and the last is out of its range. What becomes of the other '
               'three?', (
        wrong('They are rejected too: it is one request', 'The service is not atomic. Each parameter is decided for '
              'itself.'),
        right('They are accepted', 'Each parameter of a `set_parameters` request is decided for itself.'),
        wrong('They are set, and then taken back', 'Nothing is taken back. Each parameter is decided for itself, and '
              'three are in force.'))),
    Prediction('5.3-2', 'Now both go in one atomic request: the speed 300, which is fine, and the acceleration -0.1, '
               'which is not. What does the answer say of the speed?', (
        wrong('accepted', 'In an atomic request nothing is decided for itself. One invalid value, and none is set.'),
        right('rejected, with a reason that names the acceleration', 'There is one result for the whole list, and so '
              'one reason, also for the blameless.'),
        wrong('rejected, with no reason, since it has no fault', 'There is one result for the whole list. The client '
              'shows its reason at each parameter.'))),
    Prediction('5.3-3', "In a timer's callback the node calls its own service `set_parameters`, and waits for one "
               'second. Which answer does it log?', (
        wrong('successful: it asks itself, what could fail', 'The executor is busy with the callback that waits, so '
              'nobody serves the request.'),
        right('None', 'The executor is busy with the callback that waits, so nobody serves the request, and the second '
              'passes.'),
        wrong('an exception: a node must not call its own service', 'Nothing forbids it, and nothing warns. The '
              'callback waits until its time limit passes.'))),
    Prediction('5.3-4', 'A message says *double*, and its field for doubles was filled with the integer 2. What does '
               'the robot do?', (
        wrong('It rejects it: wrong type', 'The robot looks at the type that the message names, and that is double.'),
        wrong('It accepts it, and stores 2.0', 'Nobody converts. What is sent is no double, and the robot reads it as '
              'one.'),
        right('It accepts it, and stores another number', "Messages don't check their fields unless you ask for it. "
              'What is sent is not 2.0.'))),
)
