"""Predictions of chapter 6.1: what a descriptor enforces, and what it only says."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'Your ranges hold, and each parameter has a descriptor of its own.'

RECALLS = (
    Recall('6.1-r1', 'The description of a parameter says *Must be positive*, and the descriptor says nothing else. '
           'Someone sets it to -5. What does the node do?', (
        right('It accepts the value', 'A description is for people. Nothing enforces it.'),
        wrong('It rejects the value', 'A description is for people, and rclpy does not read it. A range enforces a '
              'limit, or a callback does.'),
        wrong('It accepts and warns', 'rclpy does not read a description, so it has nothing to warn about.')),
           chapter='3', section='Limits'),
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
    Prediction('6.1-2', 'The range is -20 to 52 in steps of 5. How many of the eight values -21, -20, -15, 0, 12, 50, '
               '52 and 53 does the node accept?', (
        right('5', '-20, -15, 0, 50 and 52: both ends are valid, and the steps count from -20.'),
        wrong('4', 'There is one more. Both ends are valid, 52 too, though no step leads there.'),
        wrong('3', 'There are two more. Both ends are valid: -20, and 52 as well.'),
        wrong('6', 'One fewer: 12 lies between the ends, but -20 plus any number of fives is never 12.'),
        wrong('8', 'A range is enforced: -21 and 53 are outside, and 12 is off the step.')),
        otherwise='It accepts five: -20, -15, 0, 50 and 52. Both ends are valid, and the steps count from -20.'),
    Prediction('6.1-3', 'The acceleration may go up to 2.0. How does the node answer 2.000001 and 2.0001?', (
        wrong('It rejects both of them', 'The comparison of doubles has a tolerance, and 2.000001 is within it.'),
        wrong('It stores 2.0 both times', 'A node never moves a value to the limit. It accepts 2.000001 as it is, and '
              'rejects 2.0001.'),
        right('It accepts only 2.000001', 'Doubles are compared with a tolerance of one part in a million, and 2.0001 '
              'is beyond it.'))),
    Prediction('6.1-4', 'The range goes from 0.0 to 1.0 in steps of 0.1. How does the node answer `3 * 0.1`, which is '
               '0.30000000000000004 in Python?', (
        right('It stores the value as it is', 'Your first thought holds. A tiny error of rounding is within the '
              'tolerance, so you can calculate a value.'),
        wrong('It says it is not a valid step', 'It is not exactly 0.3, and the tolerance is there for such cases: one '
              'part in a million.'),
        wrong('It stores 0.3 in its place', 'The node accepts the value as it is, with all its digits. It never moves '
              'a value.'))),
    Prediction('6.1-5', 'The range goes from -0.3 to 0.3 in steps of 0.1, and the default is 0.0. What happens when '
               'the node starts?', (
        wrong('It starts with 0.0', 'Three steps up lead to 5.551115123125783e-17. That is not 0.0, and at 0.0 the '
              'tolerance leaves no room.'),
        right('The declaration fails', 'Doubles miss 0.0 by 5.551115123125783e-17, and at 0.0 the tolerance leaves no '
              'room.'),
        wrong('It starts with -0.3', 'A node never moves a value. It rejects the default, and does not start.'))),
    Prediction('6.1-6', '`gain` has the default `1` and a range of doubles up to 1.0. `reach_m` has the default `0.5` '
               'and a range of integers up to 10. `speeds` is a list of integers, with a range of integers up to 10. '
               'We set them to 900, 900.0 and [5, 900]. How many of the three does the node reject?', (
        right('0', 'rclpy ignores a range of the wrong kind, and any range on an array. Nothing warns you.'),
        wrong('3', 'None. rclpy ignores a range of the wrong kind, and any range on an array.'),
        wrong('2', 'None. `1` is an integer and `0.5` a double, and each has a range of the other kind. And rclpy '
              'ignores a range on an array.'),
        wrong('1', 'None. rclpy ignores a range on an array; it does not compare the elements. And it ignores a range '
              'of the wrong kind.')),
        otherwise='None. rclpy ignores a range of the wrong kind, and any range on an array. Nothing warns you.'),
    Prediction('6.1-7', 'Both parameters share one descriptor, without a range or a lock. How does the node answer if '
               'you set `wheel_count`, 4, to 6?', (
        wrong('It accepts 6 for wheel_count alone', 'The second declaration has written *string* into the shared '
              'descriptor, so 6 has the wrong type now.'),
        wrong('It accepts 6 for both parameters', "The two parameters don't share a value. They share the descriptor, "
              'and with it the type.'),
        right('It rejects 6 for its wrong type', 'The second declaration overwrote the type in the shared descriptor. '
              'One descriptor, one declaration.'))),
)
