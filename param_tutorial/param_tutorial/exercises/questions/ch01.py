"""Predictions of chapter 1: a running robot, and what a change does to it."""

from param_tutorial.exercises.prediction import Prediction, Scale, right, wrong

SOLVED = 'Your robot is fast, whole, and starts with a number of yours.'

RECALLS = ()

PREDICTIONS = (
    Prediction('1-1', 'The robot is going to drive at 2.0 m/s, and still brakes half a meter before the wall. How far '
               'from the wall does it stop?', (
        right('0', 'It does not stop before the wall. From 2 m/s it needs 2 m to stop, and there is half a meter.'),
        wrong('0.3', 'It brakes where it braked before, and is four times as fast there. From 2 m/s it needs 2 m, and '
              'there is half a meter.'),
        wrong('0.5', 'There it starts to brake. From 2 m/s it needs 2 m to stop, and there is half a meter.')),
        scale=Scale(0, 10, 0.1, 'm', tolerance=0.1, is_track=True),
        otherwise='It hits the wall. From 2 m/s it needs 2 m to stop, and there is half a meter.'),
    Prediction('1-2', 'The requests are 0.8, then the word `fast`, then -1.0. The node takes from 0.0 to 2.0. Which '
               'value does it hold afterwards?', (
        right('0.8', 'A request that is rejected changes nothing.'),
        wrong('0.0', 'The limits do not correct a value. The node rejects it, and keeps the one that it has.'),
        wrong('-1.0', 'That is out of range, so the node rejects it.')),
        otherwise='It is 0.8. The node rejects the other two, and a request that is rejected changes nothing.'),
    Prediction('1-3', 'One minute at 0.5 m/s, then the parameter is set to 1.0 m/s, then another minute. How many '
               'meters has the robot driven?', (
        right('90', 'Thirty meters plus sixty: the plain sum is right here, because the robot asks for its parameter '
              'each time it drives.'),
        wrong('60', 'That would be both minutes at the old speed, or a restart in between. This robot asks for its '
              'parameter each time it drives: 30 plus 60.'),
        wrong('120', 'That would be both minutes at the new speed. But the first minute is over: 30 plus 60.')),
        scale=Scale(0, 150, 5, 'm'),
        otherwise='It is 90: thirty meters at the old speed, and sixty at the new one.'),
    Prediction('1-4', 'The same two minutes, with a robot that asks for its parameter once, when it starts. How many '
               'meters?', (
        right('60', 'The node accepts 1.0 m/s, and drives on with the 0.5 m/s that it copied when it started.'),
        wrong('90', 'The node accepts the change, and its parameter says 1.0. But it drives with the copy that it made '
              'when it started: 30 plus 30.'),
        wrong('30', 'The node does not stop. It drives the second minute with the speed that it copied when it '
              'started: 30 plus 30.')),
        scale=Scale(0, 150, 5, 'm'),
        otherwise='It is 60. The node accepts the change, and drives on with the copy that it made when it started.'),
    Prediction('1-5', 'You have set `max_speed_mps` to 1.0, and the default is 0.5. The new driver is started with a '
               'value for `command_rate_hz` alone. Which `max_speed_mps` does it start with?', (
        right('0.5', 'It is a new node, and it knows nothing of what was set in the old one.'),
        wrong('1.0', 'That was set in the old node. The new one begins with its defaults.')),
        scale=Scale(0, 2, 0.1, 'm/s'),
        otherwise='It is 0.5, the default. The new node knows nothing of what was set in the old one.'),
    Prediction('1-6', 'The first driver is set to 1.2. Both come from the same class, and both have a parameter '
               '`max_speed_mps`. What is its value in the second?', (
        wrong('1.2, as in the first driver', 'A parameter does not belong to a class, nor to the whole system. Each '
              'node has its own.'),
        wrong('none until somebody sets it', 'Each node declares its own parameters, with a default. The second one '
              'still has that default.'),
        right('0.5, the default of the class', 'Nobody touched the second driver. A parameter belongs to one node.'))),
)
