"""Predictions of chapter 4: what a node reads, and when."""

from param_tutorial.exercises.prediction import Prediction, Recall, Scale, right, wrong

SOLVED = 'Your driver reads at the right moment. Many robots in the field do not.'

RECALLS = (
    Recall('4-r1', 'The range of a double goes from 0.0 to 2.0. Which of these values does the node accept?', (
        wrong('2.1', 'It is out of range, and the node does not correct it.'),
        right('2.0', 'Both ends of a range are valid.'),
        wrong('2', 'That is an integer. The parameter is a double, and ROS does not convert.')),
           chapter='3', section='Limits'),
    Recall('4-r2', 'Two robots run the same program, each under its own name. You set the speed of the first to 150. '
           'What does the second do?', (
        wrong('It drives at 150 too', 'The program is the same, but each node has its own parameters.'),
        right('It keeps its own speed', 'A parameter lives in one node.'),
        wrong('It does after a restart', 'A restart brings back the default. What you set on one node does not reach '
              'the other.')),
           chapter='1', section='Two robots of one class'),
)

PREDICTIONS = (
    Prediction('4-1', 'You took the object `parameter` when the speed was 1.0. Then a client sets 1.5. What is '
               '`parameter.value` after that?', (
        right('1.0', 'The object of a number keeps the value that it had when you took it.'),
        wrong('1.5', 'The object is not connected with the node. To see 1.5, ask the node again with '
              '`get_parameter`.')),
        scale=Scale(0, 2, 0.1, 'm/s'),
        otherwise='It is 1.0: the object of a number keeps the value that it had when you took it.'),
    Prediction('4-2', 'The driver reads each time now. A client sets 1.5, which the driver then commands. The next one '
               'sets 3.0. Which speed does the driver command then, in m/s?', (
        right('1.5', 'The node rejected 3.0, so the parameter still holds 1.5, and that is what `drive` reads.'),
        wrong('3.0', 'The range ends at 2.0. The node rejected 3.0 and still holds 1.5, which is what `drive` reads.'),
        wrong('2.0', 'A range does not correct a value. The node rejected 3.0 and still holds 1.5.'),
        wrong('0.5', 'That was the copy. `drive` reads the parameter now, and it still holds 1.5.')),
        scale=Scale(0, 4, 0.1, 'm/s'),
        otherwise='It commands 1.5: the node rejected 3.0, and the parameter still holds 1.5.'),
    Prediction('4-3', 'The arm declares `calibration` as a double, without a value. What does `get_parameter` do?', (
        wrong('It returns the value 0.0', 'A type brings no default with it, not even zero. This parameter has no '
              'value.'),
        wrong('It returns the value None', 'A node could easily overlook a None. rclpy raises an exception instead.'),
        right('It raises an exception', 'It is a `ParameterUninitializedException`: the parameter exists, but it has '
              'no value.'))),
    Prediction('4-4', 'Your driver commands 2.0 m/s, until the wall is 0.5 m away. Then it commands 0.0. How far from '
               'the wall does the robot come to rest?', (
        right('0', 'It hits the wall: from 2.0 m/s, with 1 m/s², it needs 2 m to stop.'),
        wrong('0.5', 'There the driver commands 0.0. The base brakes with 1 m/s², and from 2.0 m/s that takes 2 m.'),
        wrong('0.3', 'So it was at the lower speed. From 2.0 m/s the base needs 2 m to stop.')),
        scale=Scale(0, 10, 0.1, 'm', tolerance=0.1, is_track=True),
        otherwise='It hits the wall: from 2.0 m/s, with 1 m/s², it needs 2 m to stop, and half a meter is left.'),
    Prediction('4-5', 'The courier has driven its route once, and nobody has set `stops`. How many stops does a client '
               'get now?', (
        right('0', '`.value` is the list that the node holds, so `pop` has changed the parameter itself.'),
        wrong('3', 'Nobody has sent a request. But `pop` took the stops off the list that the node holds.')),
        otherwise='It gets none: `.value` is the list that the node holds, and `pop` has emptied it.'),
    Prediction('4-6', 'A client sets `stops` to `[3, 4]`, and the node accepts. What is '
               "`courier.get_parameter('stops').value == [3, 4]` then?", (
        wrong('True', 'The numbers are the same. But they are in an `array.array`, which equals no list.'),
        right('False', 'The value is an `array.array`, and that equals no list, whatever is in it.'))),
    Prediction('4-7', 'The range of `wall_m` ends at 50.0, and the node holds 20.0. Your slider is moved to 60.0. '
               'What does the slider show afterward?', (
        right('60.0', 'The node rejected the value, and nobody told the slider.'),
        wrong('50.0', 'The node does not correct a value, and the slider knows nothing of the range. It shows 60.0.'),
        wrong('20.0', 'That is what the node holds. Nobody told the slider, so it shows 60.0.')),
        scale=Scale(0, 70, 5, 'm'),
        otherwise='It shows 60.0: the node rejected the value, and nobody told the slider.'),
)
