"""Predictions of chapter 9.2: where the values of ROS 1 and ROS 2 live, and who guards them."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'The master is not missed, and nobody gets past your callbacks.'

RECALLS = (
    Recall('9.2-r1', 'A node declares `gains.kp`. Someone sets `gains/kp`, as it was called in ROS 1. What does the '
           'node do?', (
        wrong('It sets gains.kp', 'A slash in a parameter name means nothing, so this is another name, and nobody '
              'declared it.'),
        wrong('It adds gains/kp', 'ROS 1 did that. In ROS 2 a node has the parameters that it declares.'),
        right('It rejects gains/kp', 'A slash in a parameter name means nothing: this is another name, and nobody '
              'declared it.')),
           chapter='9.1', section='Names'),
    Recall('9.2-r2', 'Which callback may change the motor?', (
        wrong('the on-set callback', 'It judges a proposal, and the next judge may still reject it.'),
        right('the post-set callback', 'It runs when the value is stored.')),
           chapter='8', section='One object, replaced as a whole'),
)

PREDICTIONS = (
    Prediction('9.2-1', 'A stranger sets a color for a node that is not there, misspells a name, and deletes the speed '
               'of the robot. Which of the three does ROS 2 allow?', (
        right('none of the three', 'Each node keeps its own parameters: no node, no parameter; no declaration, no '
              'name; and the type is fixed.'),
        wrong('all three of them', "In ROS 2 the node itself is asked. One that is not there can't answer, and this "
              'one rejects the other two.'),
        wrong('only the misspelled name', 'That was so in ROS 1. In ROS 2 a node has the parameters that it declares.'),
        wrong('only the deletion', 'Only a dynamically typed parameter can be deleted from outside, and this one has a '
              'fixed type.'))),
    Prediction('9.2-2', 'In ROS 1 the robot sets its speed to 900, and is killed. A new robot of that name asks for '
               '`~max_speed_rpm`, with 100 as its default. What does it get?', (
        right('900', 'In ROS 1 the parameter server keeps the values, and they outlive the node.'),
        wrong('100', 'The node is new, but the value was never in the node. The parameter server keeps it.')),
        otherwise='It gets 900. The value was never in the node. The parameter server keeps it, and hands it to the '
                  'next.'),
    Prediction('9.2-3', 'The robot has called `get_param` and `get_param_cached` before. Now the master of ROS 1 is '
               'held up. Which of the two functions still gives the robot its own speed?', (
        wrong('both of them', 'Its own parameter lives in the master, and `get_param` waits for it.'),
        right('only the second', 'It reads from a copy in the node, which the master keeps fresh while it can.'),
        wrong('neither of them', '`get_param_cached` reads from a copy in the node, if it has been called before.'))),
    Prediction('9.2-4', 'In ROS 1, `dynamic_reconfigure` has the limit 300 for the speed, which is 150. What is the '
               'speed after a request for 900?', (
        right('300', '`dynamic_reconfigure` clamps a value to its limits. The caller has to compare to find out.'),
        wrong('150', 'ROS 2 does that: it rejects 900, with a reason. `dynamic_reconfigure` clamps the value, and '
              'tells nobody why.'),
        wrong('900', 'The limits are not for the slider only. The server enforces them, in its own way: it moves the '
              'value to the limit.')),
        otherwise='It is 300. `dynamic_reconfigure` clamps a value to its limits, and tells nobody why.'),
    Prediction('9.2-5', 'The callback rejects a gain above 1.0. The node is started with `-p gain:=7.0`. With which '
               'gain does it run?', (
        wrong('with a gain of 0.5', 'An override takes the place of the default, and here nobody judges it.'),
        right('with a gain of 7.0', 'When the gain is declared the callback is not registered yet, so nobody asks it.'),
        wrong('with none, it fails', 'It would not if the callback were registered before the declaration. Here nobody '
              'asks the callback.'))),
    Prediction('9.2-6', 'The node rejects a gain of 7.0. You type it into `rqt_reconfigure`. What does the field show '
               'afterwards?', (
        wrong('0.5 and the reason', 'That is our panel. This field drops the answer, with the reason in it.'),
        wrong('0.5 and no reason', 'The field never learns that it was rejected. It shows what was typed.'),
        right('7.0 and no reason', 'The field shows what was typed, and drops the answer of the node.'))),
    Prediction('9.2-7', 'Someone sets the same gain of 7.0 in the panel of this course. What does the panel show '
               'afterwards?', (
        wrong('7.0 and no reason', 'That is `rqt_reconfigure`, which drops the answer. The panel waits for it.'),
        right('0.5 and the reason', 'As in every chapter so far: the panel shows what the node confirmed, and why it '
              'rejected the rest.'),
        wrong('0.5 and no reason', 'The answer has a reason in it, and the panel shows it.'))),
)
