"""Predictions of chapter 6.2: read-only, types that may change, arrays, and the order of the checks."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'Your driver has a fixed rate, and you can say which check rejected a request.'

RECALLS = (
    Recall('6.2-r1', 'A parameter has the default `1` and a range of doubles, 0.0 to 1.0. You set it to 900. How does '
           'the node answer?', (
        wrong('It says it is out of range', 'A range only counts for values of its own kind, and `1` is an integer.'),
        wrong('It says the type is wrong', 'The default made it an integer, and 900 is one.'),
        right('It accepts the value 900', '`1` is an integer, and rclpy ignores a range of doubles for an integer.')),
           chapter='6.1', section='A range that nobody enforces'),
    Recall('6.2-r2', 'A value has the wrong type. Does the node call its on-set callback?', (
        right('No, rclpy rejects it earlier', 'rclpy checks the type before it calls the on-set callbacks.'),
        wrong('Yes, with the value as it is', 'rclpy checks the type first. A check of it in the callback would never '
              'find anything.'),
        wrong('Yes, with the value converted', 'rclpy converts nothing, and rejects the value before any on-set '
              'callback.')),
           chapter='5.2', section='A rule about two values'),
)

PREDICTIONS = (
    Prediction('6.2-1', 'The metronome started with a `rate_hz` of 10, and its constructor made the timer. Now someone '
               'sets `rate_hz` to 50. How many times a second does it tick?', (
        right('10', 'The timer has the period that the constructor gave it, and nothing makes another.'),
        wrong('50', 'The parameter is 50. The timer has the period that the constructor gave it, 0.1 s.'),
        wrong('0', 'The timer that the constructor made goes on, ten times a second.')),
        otherwise='It ticks 10 times a second: the timer has the period that the constructor gave it.'),
    Prediction('6.2-2', '`rate_hz` is read-only and 10. Someone sets 20, and then 10. What does the driver do?', (
        wrong('It accepts both values', 'Read-only holds for each value, also for the one that is there.'),
        right('It rejects both values', 'rclpy does not compare the new value with the old one.'),
        wrong('It rejects the 20 alone', 'rclpy does not compare: it rejects the 10 for the same reason.'))),
    Prediction('6.2-3', '`rate_hz` is read-only, and its default is 10. The driver starts with `-p rate_hz:=20`. What '
               'is `rate_hz`?', (
        right('20', 'The override takes the place of the default, and only then is the value fixed.'),
        wrong('10', 'Read-only begins with the declaration, and the override takes the place of the default in it.')),
        otherwise='It is 20: the override takes the place of the default, and only then is the value fixed.'),
    Prediction('6.2-4', 'The metronome declared `rate_hz` with the default 10, and `note` with `dynamic_typing`. '
               'Someone deletes both. Which of the two does the node still have?', (
        wrong('both of them', 'The type of `note` may be anything, also `NOT_SET`, so it can be deleted.'),
        wrong('only the note', '`note` can be deleted, because its type may be `NOT_SET`. That of `rate_hz` may not.'),
        wrong('neither one', '`rate_hz` is an integer for good, so nobody deletes it from outside.'),
        right('only rate_hz', 'Its type is fixed, and `NOT_SET` is another type. `note` may have any.'))),
    Prediction('6.2-5', 'The default of `waypoints` is the empty list `[]`. Which type does rclpy choose?', (
        wrong('an array of strings', 'Nothing in an empty list says *string*. rclpy takes the first array type that '
              'fits, which is that of bytes.'),
        wrong('no type for now', 'Each declared parameter gets a type from its default. This one is a byte array.'),
        right('an array of bytes', 'It is the first array type that an empty list fits.'),
        wrong('an array of doubles', 'Nothing in an empty list says *double*. rclpy takes the first array type that '
              'fits, which is that of bytes.'))),
    Prediction('6.2-6', '`offsets_m` and `waypoints` have a value, and `stops` is not set. How many of the three are '
               'in the dump?', (
        right('0', 'One parameter without a value, and the node answers nothing at all.'),
        wrong('2', 'The node has two values, and does not tell them: one parameter without a value empties the '
              'answer.'),
        wrong('3', 'One parameter without a value empties the whole answer.')),
        otherwise='None of them: one parameter without a value empties the whole answer.'),
    Prediction('6.2-7', 'The cell above has eight requests. For how many of them does rclpy call the on-set callback '
               '`watch`?', (
        right('2', 'The last two pass all checks of rclpy. Your own rule rejects one of them.'),
        wrong('1', 'Two: 2.0 m/s passes the checks of rclpy as well, and is rejected by your own rule.'),
        wrong('8', 'Two: rclpy rejects the first six before it calls any callback.')),
        otherwise='For two, the last ones: rclpy rejects the first six before it calls any callback.'),
    Prediction('6.2-8', '`rate_hz` is read-only, and its range ends at 50. Someone sets 905. Which reason does the '
               'driver give?', (
        wrong('that it is too large', 'It is, and rclpy would say so, but it looks at read-only before the range.'),
        right('that it is read-only', 'rclpy looks at read-only before the range, and stops at the first check that '
              'fails.'),
        wrong('that both are wrong', 'rclpy stops at the first check that fails, and that is read-only.'))),
)
