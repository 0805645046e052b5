"""Predictions of chapter 6.1: what a descriptor enforces, and what it only says."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'Your driver says what it enforces, and each parameter has a descriptor of its own.'

RECALLS = (
    Recall('6.1-r1', 'A node declares its parameters, and registers its judge after that. It is started with an '
           'override that breaks the rule. Who rejects the override?', (
        wrong('The judge, when it is registered', 'rclpy asks it about requests that come later. The override was '
              'stored when the parameter was declared.'),
        wrong('The judge, at the declaration', 'It was not registered yet. rclpy asks only those that are.'),
        right('Nobody, unless the node checks', 'The override was stored when the parameter was declared. So your '
              'constructor asks its own judge about the start values.')),
           chapter='5.2', section='Who judges the start?'),
    Recall('6.1-r2', 'One atomic request sets four parameters, and the node rejects one of the values. What happens to '
           'the other three?', (
        wrong('They get their new values', 'That is what `set_parameters` does. An atomic request succeeds as a whole '
              'or not at all.'),
        right('They keep their old values', 'An atomic request succeeds as a whole or not at all.'),
        wrong('Only those before it are set', 'The node judges the request as a whole before it stores anything.')),
           chapter='5.3', section='One by one, or all or nothing'),
)

PREDICTIONS = (
    Prediction('6.1-1', 'The range of `opening_mm` is 0 to 85 in steps of 10. How does the node answer 45, which is '
               'between two steps, and 85, which is no step either?', (
        right('It rejects 45 and accepts 85', '85 is off the step too, but it is an end of the range, and an end is '
              'always valid.'),
        wrong('It rejects both of the values', '45 is rejected, and 85 is not: the ends of a range are always valid.'),
        wrong('It accepts both of the values', 'A step is not for sliders only: the node enforces it. 45 is rejected '
              'as *not a valid step*.'),
        wrong('It rounds both to a valid step', 'A node never rounds. It rejects 45, and stores 85 as it is.'))),
    Prediction('6.1-2', 'The range of `max_speed_mps` is 0.0 to 2.0, without a step. How many of 2.0, 2.000001, '
               '2.0001, -1e-300 and `nan` does the driver accept?', (
        right('2', '2.0 and 2.000001. Doubles are compared with a tolerance of one part in a million, and at 0.0 that '
              'leaves no room.'),
        wrong('1', 'There is one more: 2.000001 differs from the end by no more than one part in a million.'),
        wrong('3', 'One fewer. 2.0 and 2.000001 are accepted: the tolerance is one part in a million, at 0.0 it leaves '
              'no room, and `nan` is in no range.'),
        wrong('4', 'Two fewer: 2.0001 is beyond the tolerance of one part in a million, and at 0.0 that leaves no '
              'room.'),
        wrong('5', 'Only two: 2.0 and 2.000001. The tolerance is one part in a million, and `nan` is in no range.')),
        otherwise='It accepts two: 2.0, and 2.000001, which is within the tolerance of one part in a million.'),
    Prediction('6.1-3', 'The steps of `braking_mps2` lead to 0.30000000000000004. The driver holds 1.0, and someone '
               'sets 0.3. What does it hold then?', (
        right('0.3', 'A tiny error of rounding is within the tolerance, and the node stores what was sent.'),
        wrong('0.30000000000000004', 'The value is close enough to that step to be accepted. Then the node stores what '
              'was sent, 0.3.'),
        wrong('1.0', 'It does not reject 0.3: the tolerance is there for such cases, one part in a million.')),
        otherwise='It holds 0.3: close enough to a step to be accepted, and stored as it was sent.'),
    Prediction('6.1-4', 'The range goes from -0.3 to 0.3 in steps of 0.1, and the default is 0.0. What happens when '
               'the node starts?', (
        wrong('It starts with 0.0', 'Three steps up lead to 5.551115123125783e-17. That is not 0.0, and at 0.0 the '
              'tolerance leaves no room.'),
        right('The declaration fails', 'Doubles miss 0.0 by 5.551115123125783e-17, and at 0.0 the tolerance leaves no '
              'room.'),
        wrong('It starts with -0.3', 'A node never moves a value. It rejects the default, and does not start.'))),
    Prediction('6.1-5', '`gain` has the default `1` and a range of doubles up to 1.0. `reach_m` has the default `0.5` '
               'and a range of integers up to 10. `speeds` is a list of integers, with a range of integers up to 10. '
               'We set them to 900, 900.0 and [5, 900]. How many of the three does the node reject?', (
        right('0', 'rclpy ignores a range of the wrong kind, and any range on an array. Nothing warns you.'),
        wrong('3', 'None. rclpy ignores a range of the wrong kind, and any range on an array.'),
        wrong('2', 'None. `1` is an integer and `0.5` a double, and each has a range of the other kind. And rclpy '
              'ignores a range on an array.'),
        wrong('1', 'None. rclpy ignores a range on an array; it does not compare the elements. And it ignores a range '
              'of the wrong kind.')),
        otherwise='None. rclpy ignores a range of the wrong kind, and any range on an array. Nothing warns you.'),
    Prediction('6.1-6', '`joint_count`, 4, and `maker`, Acme, share one descriptor, which has no range. How does the '
               'node answer if you set `joint_count` to 6?', (
        wrong('It accepts 6 for joint_count alone', 'The second declaration has written *string* into the shared '
              'descriptor, so 6 has the wrong type now.'),
        wrong('It accepts 6 for both parameters', "The two parameters don't share a value. They share the descriptor, "
              'and with it the type.'),
        right('It rejects 6 for its wrong type', 'The second declaration overwrote the type in the shared descriptor. '
              'One descriptor, one declaration.'))),
)
