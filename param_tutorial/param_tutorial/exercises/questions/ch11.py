"""Predictions of chapter 11: two robots from one file, and a drive in the cold."""

from param_tutorial.exercises.prediction import Prediction, Recall, Scale, right, wrong

SOLVED = 'Your package is released: others can build it, start two robots with it, and trust what it says.'

RECALLS = (
    Recall('11-r1', 'A tuned gain was set on a running ROS 2 node, and saved nowhere. The node is started again. Which '
           'value does the gain have?', (
        wrong('the tuned value', 'In ROS 1 a server kept it. In ROS 2 the values live in the node and go with it.'),
        right('its start value', 'The values live in the node and go with it.')),
           chapter='9', section='Where a value lives'),
    Recall('11-r2', '`get_parameters` is asked for three names, and one of them does not exist. What comes back?', (
        wrong('two of the three', 'Values come without names, so the gap would not show. rclpy sends none at all.'),
        right('none of the three', 'One unknown name empties the whole answer.'),
        wrong('three, one of them unset', 'That is what the comment in the interface promises, and not what rclpy '
              'does.')),
           chapter='10.2', section='A name too many'),
)

PREDICTIONS = (
    Prediction('11-1', 'Both drivers have started with 0.8 m/s from the same file. `/left/driver` is set to 0.4. Which '
               'speed, in m/s, does `/right/driver` hold?', (
        right('0.8', 'A parameter belongs to one node. The file gave both the same start, and no more.'),
        wrong('0.4', 'A parameter belongs to one node. The file gave both the same start, and no more.')),
        scale=Scale(0, 1, 0.1, 'm/s'),
        otherwise='It holds 0.8: a parameter belongs to one node.'),
    Prediction('11-2', 'The same way at 1.0 m/s, on a warm day with 1.0 m/s². How many seconds does the robot save?', (
        right('1.0', 'It speeds up and brakes in half the time. The way at full speed is as long as before.'),
        wrong('3.9', 'Only speeding up and braking get faster. The way at full speed is as long as before.'),
        wrong('2.0', '*v* / *a* goes from 2 seconds to 1.')),
        scale=Scale(0, 6, 0.1, 's'),
        otherwise='It saves 1.0 s: *v* / *a* goes from 2 seconds to 1.'),
)
