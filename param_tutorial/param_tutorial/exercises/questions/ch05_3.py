"""Predictions of chapter 5.3: one node sets the parameters of another."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'You set the parameters of other nodes without hanging your own.'

RECALLS = (
    Recall('5.3-r1', 'In which callback may a node start its motor with the new value?', (
        wrong('pre-set', 'It runs first, before anything has been checked.'),
        wrong('on-set', 'It sees a proposal. Another callback may still reject it, and then the motor runs at a '
              'speed that no parameter holds.'),
        right('post-set', 'It runs once the values are stored.')),
           chapter='5.2', section='The callback ladder'),
    Recall('5.3-r2', 'Someone types `ros2 param set /robot enable_safety_mode off` in a terminal. What reaches the '
           'node?', (
        wrong("the string 'off'", 'YAML 1.1 has more words for false than `false`. To send a string, use two pairs of '
              'quotes.'),
        right('the boolean False', 'The command reads the word as YAML 1.1, where `off` means false.'),
        wrong('the integer 0', 'YAML has booleans, and `off` is one of them.')),
           chapter='5.1', section='Break it: which type did you mean?'),
)

PREDICTIONS = (
    Prediction('5.3-1', 'One request asks for four values, and the last one is out of range. What happens to the other '
               'three?', (
        wrong('They are rejected too', '`set_parameters` is not atomic. The node decides about each parameter '
              'separately.'),
        right('They are all accepted', 'The node decides about each parameter of a `set_parameters` request '
              'separately.'),
        wrong('They are taken back', 'Nothing is taken back. The node decides about each parameter separately, and '
              'three are stored.'))),
    Prediction('5.3-2', 'Now both go in one atomic request: the speed 300, which is fine, and the acceleration -0.1, '
               'which is not. What does the answer say about the speed?', (
        wrong('It is accepted, as valid', 'An atomic request is stored as a whole or not at all. One invalid value, '
              'and none is set.'),
        right('Nothing about it alone', 'One request, one result, one reason. It names only the acceleration, but the '
              'speed is rejected with it.'),
        wrong('It is rejected, on its own', 'That would be two results. An atomic request has one, for the whole '
              'list.'))),
    Prediction('5.3-3', "In a timer's callback the node calls its own service `set_parameters`, and waits for one "
               'second. Which answer does it log?', (
        wrong('successful', 'The only thread of the executor is busy with the callback that waits, so nothing serves '
              'the request.'),
        right('None', 'The only thread of the executor is busy with the callback that waits. Nothing serves the '
              'request, and the second passes.'),
        wrong('an exception', 'Nothing forbids it, and nothing warns. The callback waits until its time limit '
              'passes.'))),
    Prediction('5.3-4', 'The timer of `Courteous` had a group of its own, and its question got an answer. Here the '
               'timer has none, and logs its question. What does it log then?', (
        wrong('the answer, as before', '`await` gives the thread back, but not the group: the executor starts no other '
              'callback of the group until `tick` has finished.'),
        right('nothing after that', '`tick` is paused but not finished, and until it has finished, `rclpy.spin` starts '
              'no other callback of its group. So the client cannot receive the answer.'),
        wrong('a warning, then the answer', 'There is no warning. `rclpy.spin` starts no other callback of the group '
              'until `tick` has finished, so `tick` waits forever.'))),
    Prediction('5.3-5', 'The last of the three blocks in `call`, in an executor with two threads, and its timer has a '
               'group of its own. Does it get its answer?', (
        wrong('No, it waits for it forever', 'It keeps one thread, and its own group. The other thread and the default '
              'group are free, and the client needs no more.'),
        right('Yes, in the other group', 'Exactly what the two threads and the two groups are for: one thread waits in '
              'one group, and the other brings the answer in the other group.'),
        wrong('Only with a client group', 'Timer and client have to be in two groups. One of them may stay in the '
              'default group.'))),
    Prediction('5.3-6', 'A message says *double*, and its field for doubles was filled with the integer 2. What does '
               'the robot do?', (
        wrong('It rejects the value', 'The robot looks at the type that the message names, and that is double.'),
        wrong('It stores the value 2.0', 'Nobody converts the integer. Its bytes are read as if they were a double.'),
        right('It stores another value', "Messages don't check their fields unless you ask for it. What arrives is not "
              '2.0.'))),
)
