"""Predictions of chapter 10.3: files, gains, and what a controller does with them."""

from param_tutorial.exercises.prediction import Prediction, Recall, Scale, right, wrong

SOLVED = 'The wheel runs as it should, and its gains are in a file that reaches it.'

RECALLS = (
    Recall('10.3-r1', 'A block in a parameter file begins with `/lab/*/gripper:`. Which of these nodes does it '
           'reach?', (
        wrong('/lab/gripper', '`*` stands for exactly one name. `**` stands for any number of names, including '
              'none.'),
        right('/lab/left/gripper', '`*` stands for exactly one name.'),
        wrong('/lab/left/front/gripper', '`*` stands for one name only. For any number of names there is `**`.')),
           chapter='7.3', section='Which nodes does a file reach?'),
    Recall('10.3-r2', 'Two values are valid only together: the node would reject the old value of one with the new '
           'value of the other. How do you change them?', (
        wrong('with `set_parameters` in the right order', 'If the node rejects each new value beside the old one, no '
              'order helps.'),
        right('with `set_parameters_atomically` at once', 'The node judges both values together, and stores both or '
              'neither.')),
           chapter='5.3', section='One by one, or all or nothing'),
)

PREDICTIONS = (
    Prediction('10.3-1', 'The torque is `p` times the error, and nothing else. Which gain brings the wheel to 10 '
               'rad/s?', (
        wrong('both of them', 'Without an error there is no torque, and without torque the wheel slows down. It stays '
              'below 10.'),
        wrong('only p = 0.4', 'It comes closer. But without an error there is no torque, and the friction needs some.'),
        right('neither of them', 'Without an error there is no torque, and the friction needs some. More `p` makes the '
              'error smaller, never zero.'))),
    Prediction('10.3-2', 'Three gains are set in one call of `set_parameters`. How many sets of gains does the node '
               'put to use, one after the other?', (
        right('3', 'Each gain is a change. Nobody asked for the first two combinations.'),
        wrong('1', 'One call, but three changes: the service sets one parameter after the other.'),
        wrong('2', 'There are three changes, and the node puts each of them to use.')),
        otherwise='It puts three to use: the service sets one parameter after the other.'),
    Prediction('10.3-3', 'The same three gains come in one call of `set_parameters_atomically`. How many sets of gains '
               'does the node put to use now?', (
        right('1', 'As the name of the service promises: the node stores the three together, and calls its callbacks '
              'once.'),
        wrong('3', 'That was `set_parameters`. An atomic request is one change.'),
        wrong('0', 'The three are valid, so the node accepts and uses them.')),
        otherwise='One: the node stores the three together, and calls its callbacks once.'),
    Prediction('10.3-4', 'The callback rejects whatever is below zero. What does it do with `nan`, which is not a '
               'number?', (
        wrong('It rejects nan as invalid', 'The rule asks whether it is below zero, and `nan` is not below anything.'),
        right('It accepts nan as a gain', '`nan` is neither less nor greater than anything, so it is not below zero.'),
        wrong('It never gets to see nan', '`nan` is a double like any other, so the type is right.'))),
    Prediction('10.3-5', 'One atomic request asks for `p = 5.0` and an unknown strategy. It is rejected. With '
               'which `p` does the node work afterwards?', (
        right('5.0', 'The newer callback has acted before the older one rejected. What is stored, and what is in use, '
              'differ.'),
        wrong('0.1', 'That is what is stored. The newer callback has acted before the older one rejected.')),
        scale=Scale(0, 6, 0.1),
        otherwise='It works with 5.0. The newer callback has acted before the older one rejected.'),
    Prediction('10.3-6', 'A file gives a gain for `weel_joint`, and the joint is called `wheel_joint`. What happens '
               'when the controller starts?', (
        wrong('It stops with an exception', 'The gain is an override without a declaration. That is no error.'),
        wrong('It starts with the new gain', 'The file reaches it, but the node declares no parameter of that name.'),
        right('It starts with the default', 'The gain is an override without a declaration, so the node ignores it '
              'silently.'))),
)
