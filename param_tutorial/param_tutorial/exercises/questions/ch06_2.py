"""Predictions of chapter 6.2: locks, types that may change, arrays, and the order of the checks."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'Nobody gets 110 °C past you anymore, and you know which check to blame.'

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
    Prediction('6.2-1', '`serial_number` is read-only, and its default is GR-0042. This gripper starts with '
               '`-p serial_number:=GR-0043`. What is its serial number?', (
        wrong('GR-0042, the default', 'The lock begins with the declaration. The override takes the place of the '
              'default before that.'),
        right('GR-0043, the override', 'The override takes the place of the default, and only then is the parameter '
              'locked.'),
        wrong('none, it does not start', 'An override of a read-only parameter is allowed; it is how each gripper gets '
              'its own number.'))),
    Prediction('6.2-2', 'The default of `waypoints` is the empty list `[]`. Which type does rclpy choose?', (
        right('an array of bytes', 'It is the first array type that an empty list fits, and no string or number will '
              'ever go in.'),
        wrong('an array of strings', 'Nothing in an empty list says *string*. rclpy takes the first array type that '
              'fits, which is the byte array.'),
        wrong('none for the moment', 'Each parameter has a type, unless it is dynamically typed. This one is a byte '
              'array.'),
        wrong('none, it fails', 'The node starts without a word. It has a byte array, and that shows only when someone '
              'sets it.'))),
    Prediction('6.2-3', 'The constructor sets `waypoints` to an empty list, after its declaration. This node starts '
               'with `-p waypoints:="[dock, door]"`. What does `waypoints` hold?', (
        wrong('dock and door', 'They were there after the declaration, and the next line replaced them.'),
        right('an empty list', 'The override arrives with the declaration, and the next line replaces it.'),
        wrong('no value at all', 'Both are lists of strings, so no check rejects either, and the later one stays.'))),
    Prediction('6.2-4', '`PatientTour` sets the empty list only if the declaration brought no value. It starts with '
               '`-p waypoints:="[dock, door]"`. What does `waypoints` hold?', (
        right('dock and door', 'The code does what it seems to do: there was a value already, so the node left it '
              'alone.'),
        wrong('an empty list', '`EmptyTour` replaced the override in any case. This node looks first.'),
        wrong('no value at all', 'The override arrives with the declaration, so the parameter has a value at once.'))),
    Prediction('6.2-5', '`serial` is read-only, an integer from 0 to 100 in steps of 10. You set it to 905. Which of '
               'the three reasons does the node give?', (
        wrong('the end of the range', 'It is, and rclpy would have said so, but it checks the lock before the range.'),
        right('the read-only lock', 'The lock is checked before the range, and only the first failure is named.'),
        wrong('the step of the range', 'The step is checked last, and only the first failure is named.'),
        wrong('all of the three', 'rclpy stops at the first check that fails.'))),
    Prediction('6.2-6', 'Four commands: an acceleration of 1.5, an acceleration of 5.0, a new serial number, and a '
               'speed of 180. How many of them reach the callback with the branches?', (
        right('2', '1.5 and 180. The range and the lock reject the other two before any callback is called.'),
        wrong('3', 'Two. The lock rejects the serial number before any callback is called, and the range rejects 5.0.'),
        wrong('4', 'Two. The callback comes last, and rclpy rejects 5.0 and the serial number before it.')),
        otherwise='Two reach it: 1.5 and 180. The range and the lock reject the others before any callback is called.'),
)
