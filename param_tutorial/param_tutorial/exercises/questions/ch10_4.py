"""Predictions of chapter 10.4: rules, a schema, and old names."""

from param_tutorial.exercises.prediction import Prediction, Recall, Scale, right, wrong

SOLVED = 'You did not wait for a better ROS. You built it out of three callbacks.'

RECALLS = (
    Recall('10.4-r1', 'A node rejects a value. How many parameter events does it publish?', (
        right('none for a rejection', 'Nothing has changed, so there is nothing to report.'),
        wrong('one with the old value', 'Events report what has changed, and nothing has.'),
        wrong('one with the reason', 'Only the caller gets the reason, in the answer.')),
           chapter='10.1', section='What is published, and how often'),
    Recall('10.4-r2', 'A node keeps a rule for two parameters in an on-set callback. Which request does the callback '
           'never see?', (
        wrong('one from a terminal', 'The terminal calls the same service as everyone else, and the node asks its '
              'callback.'),
        right('one of the wrong type', 'The node checks the type first, and rejects the value without asking the '
              'callback.'),
        wrong('one with one value only', 'The callback sees it, and has to look up the other value itself.')),
           chapter='6.2', section='Who rejects, and in which order?'),
)

PREDICTIONS = (
    Prediction('10.4-1', 'The pattern is two capital letters and four digits, and the callback tries it with '
               '`re.match`. What does the node answer to `AB1234567`?', (
        right('It accepts the serial number', '`re.match` asks whether the string *begins* like the pattern.'),
        wrong('It rejects the serial number', '`re.match` asks whether the string *begins* like the pattern. It does '
              'not look at what comes after that.'))),
    Prediction('10.4-2', 'Stored are -5 and 40. The callback compares each proposed value with the other stored one. '
               'What does the node answer to the pairs 50, 60 and 30, 20?', (
        wrong('It accepts the first and rejects the second', 'That would be right, but the callback compares with '
              'stored values.'),
        right('It rejects the first and accepts the second', '50 is not below the stored 40. But 30 is, and 20 is '
              'above the stored -5.'),
        wrong('It rejects the first as well as the second', 'The second passes: 30 is below the stored 40, and 20 is '
              'above the stored -5.'))),
    Prediction('10.4-3', 'The node has the rule for the two temperatures from `rule`. Stored are -5 and 40. What does '
               'it answer to the pairs 50, 60 and 30, 20 now?', (
        right('It accepts the first and rejects the second', 'As it should be: the rule judges the pair that the node '
              'would hold after the change.'),
        wrong('It rejects the first and accepts the second', 'That was `FirstTry`, which compared each proposed value '
              'with the other stored one.'),
        wrong('It accepts the first as well as the second', 'In the second pair 30 is not below 20, and `rule` sees '
              'the pair.'))),
    Prediction('10.4-4', 'Stored are 50 and 60. `set_parameters` is called with `high_c` = 10 and `low_c` = 0, in this '
               'order. What becomes of them?', (
        wrong('Both of them are accepted', 'In `set_parameters` each is a change of its own, and 10 is not above the '
              'stored 50.'),
        wrong('Both of them are rejected', 'The second is a change of its own, and 0 is below the stored 60.'),
        right('Only the second is accepted', 'Each is a change of its own: 10 is not above the stored 50, and 0 is '
              'below the stored 60.'))),
    Prediction('10.4-5', 'What does this node do when it starts without a file?', (
        wrong('It starts with three defaults', 'It checks the defaults too, and the default of `command_interface` '
              'fails.'),
        wrong('It starts with one value unset', 'It has a default, the empty string, and that default fails the '
              'check.'),
        right('It rejects one of its defaults', 'The default of `command_interface` is empty, and `not_empty<>` '
              'applies to defaults too. So the node does not start.'))),
    Prediction('10.4-6', 'Two pre-set callbacks now, one for each old name. A client sets `speed`, the old name that '
               'worked a moment ago. What happens?', (
        right('It is rejected as undeclared', 'The second callback passes `speed` on as it was, and no such parameter '
              'is declared.'),
        wrong('It works as it did before', 'Each gets the original request, and rclpy concatenates their answers. The '
              'second one passes `speed` on.'),
        wrong('Only the later callback runs', 'Both are called, and rclpy concatenates their answers. That is the '
              'trouble.'))),
    Prediction('10.4-7', 'Both names hold 120. One atomic request sets `max_speed_rpm` to 10 and `speed` to 20. Each '
               'name is the twin of the other. What does `max_speed_rpm` hold afterwards?', (
        right('20', 'And `speed` is 20, too. The callback makes each of the two a change of both names, and the later '
              'one stays.'),
        wrong('10', 'The callback makes each of the two a change of both names. The later one stays, and that is 20.'),
        wrong('120', 'Nobody looks for the contradiction, and a pre-set callback could not reject it.')),
        scale=Scale(0, 140, 10, 'rpm'),
        otherwise='It holds 20. The callback makes each of the two a change of both names, and the later one stays.'),
)
