"""Predictions of chapter 1: a running robot, and what a change does to it."""

from param_tutorial.exercises.prediction import Prediction, right, wrong

SOLVED = 'The robot is parked to the centimeter, and nobody had to touch its program.'

RECALLS = ()

PREDICTIONS = (
    Prediction('1-1', 'The acceleration and the speed are the same as before, and the safety mode is off. Where does '
               'the robot stop?', (
        wrong('closer to the wall', 'The safety mode does the braking. Without it the robot does not brake at all, '
              'neither early nor late.'),
        wrong('where it did before', 'Only the safety mode looks at the wall. The node accepted the change, so the '
              'change counts.'),
        right('in the wall itself', 'The safety mode does the braking. Without it the robot meets the wall at full '
              'speed.'))),
    Prediction('1-2', 'After one second of its drive, the robot gets 0.2 m/s² instead of 0.5 m/s². What does its speed '
               'do?', (
        wrong('It falls back to what 0.2 m/s² would have given by now', 'A change does not rewrite the past. The '
              'robot keeps the speed that it has.'),
        right('It goes on from 0.5 m/s, and climbs less steeply', 'The change counts from that moment on, without a '
              'jump.'),
        wrong('It climbs as before; the change counts for the next drive', 'The change does not wait for the next '
              'drive. The curve bends at one second.'))),
    Prediction('1-3', 'One minute at 0.5 m/s, then the parameter is set to 1.0 m/s, then another minute. How many '
               'meters has the robot driven?', (
        right('90', 'Thirty meters plus sixty: the plain sum is right here, because the robot asks for its parameter '
              'each time it drives.'),
        wrong('60', 'That would be both minutes at the old speed, or a restart in between. This robot asks for its '
              'parameter each time it drives: 30 plus 60.'),
        wrong('120', 'That would be both minutes at the new speed. But the first minute is over: 30 plus 60.')),
        otherwise='It is 90: thirty meters at the old speed, and sixty at the new one.'),
    Prediction('1-4', 'The same two minutes, with a robot that asks for its parameter once, when it starts. How many '
               'meters?', (
        right('60', 'The node accepts 1.0 m/s, and drives on with the 0.5 m/s that it copied when it started.'),
        wrong('90', 'The node accepts the change, and its parameter says 1.0. But it drives with the copy that it made '
              'when it started: 30 plus 30.'),
        wrong('30', 'The node does not stop. It drives the second minute with the speed that it copied when it '
              'started: 30 plus 30.')),
        otherwise='It is 60. The node accepts the change, and drives on with the copy that it made when it started.'),
    Prediction('1-5', 'Only the first robot was set to 200 rpm. Both come from the same class, and both have a '
               'parameter `max_speed_rpm`. What is its value in the second?', (
        wrong('200, as the first one', 'A parameter does not belong to a class, nor to the whole system. Each node has '
              'its own.'),
        right('100, as it was before', 'Nobody touched the second robot, so nothing changed in it. A parameter belongs '
              'to one node.'),
        wrong('none, and no default', 'Each node declares its own parameters, with a default. The second robot still '
              'has that default.'))),
)
