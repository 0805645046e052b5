"""Predictions of chapter 10.4: rules, aliases, and sets of parameters."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'You did not wait for a better ROS. You built it out of three callbacks and six services.'

RECALLS = (
    Recall('10.4-r1', 'A node rejects a value. How many parameter events does it publish?', (
        right('none', 'Nothing has changed, so there is nothing to report.'),
        wrong('one, with the old value', 'Events report what has changed, and nothing has.'),
        wrong('one, with the reason', 'The reason goes to the caller alone, in the answer.')),
           chapter='10.1', section='Change it: what is published, and how often'),
    Recall('10.4-r2', 'A node keeps a rule for two parameters in an on-set callback. When is it not asked?', (
        wrong('when the value comes from a terminal', 'Whoever asks, the callback is called: the service is the '
              'same.'),
        wrong('when only one of the two is set', 'It is called for each request that gets that far, and has to '
              'look up the other value itself.'),
        right('when the value has the wrong type', 'The type is checked first, and the callback never sees such '
              'a value.')),
           chapter='6.2', section='Who rejects, and in which order?'),
)

PREDICTIONS = (
    Prediction('10.4-1', 'The pattern is two capital letters and four digits, and the callback tries it with '
               '`re.match`. What does the node answer to `AB1234567`?', (
        wrong('It rejects it: there are too many digits', '`re.match` looks whether the text *begins* like the '
              'pattern. What comes after that is free.'),
        right('It accepts it', '`re.match` looks whether the text *begins* like the pattern; `re.fullmatch` is what '
              'was meant.'))),
    Prediction('10.4-2', 'Stored are -5 and 40. Each proposed value is compared with the stored other one. What does '
               'the node answer to the pairs 50, 60 and 30, 20?', (
        wrong('It accepts the first and rejects the second', 'That would be right, and it is not what the callback '
              'does: it compares with stored values.'),
        right('It rejects the first and accepts the second', '50 is not below the stored 40. And 30 is below it, as 20 '
              'is above the stored -5.'),
        wrong('It rejects both', 'The second passes: 30 is below the stored 40, and 20 is above the stored -5.'))),
    Prediction('10.4-3', 'Stored are 50 and 60. `set_parameters` is called with `high_c` = 10 and `low_c` = 0, in this '
               'order. What becomes of them?', (
        wrong('Both are accepted: together they are in order', 'In `set_parameters` each is a change of its own, and '
              '10 is not above the stored 50.'),
        wrong('Both are rejected', 'The second is a change of its own, and 0 is below the stored 60.'),
        right('The first is rejected, the second accepted', 'Each is a change of its own: 10 is not above the stored '
              '50, and 0 is below the stored 60.'))),
    Prediction('10.4-4', 'Two pre-set callbacks now, one for each old name. A client sets `speed`, the old name that '
               'worked a moment ago. What happens?', (
        wrong('It works: each callback forwards its own name', 'Each gets the original request, and rclpy strings '
              'their answers together. The second one passes `speed` on.'),
        right('It is rejected: undeclared', 'The second callback passes `speed` on as it was, and that parameter is '
              'not declared.'),
        wrong('Only the callback registered last is called', 'Both are called, and rclpy strings their answers '
              'together. That is the trouble.'))),
    Prediction('10.4-5', "What does Python say to `{'gain': 1, 'safe': True} == {'gain': 1.0, 'safe': 1}`?", (
        right('True', 'For Python 1 is 1.0, and True is 1. For ROS nothing in the two is equal.'),
        wrong('False: the types differ', 'For ROS they do, and that is what counts for a parameter. Python compares '
              'the numbers.'))),
)
