"""Predictions of chapter 10.3: files, gains and what a controller does with them, declarations from a schema."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

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
        wrong('with `set_parameters`, in the right order', 'If the node rejects each new value beside the old one, no '
              'order helps.'),
        right('with `set_parameters_atomically`', 'The node judges both values together, and stores both or '
              'neither.')),
           chapter='5.3', section='Change it: all or nothing'),
)

PREDICTIONS = (
    Prediction('10.3-1', 'A file gives a gain for `weel_joint`, and the joint is called `wheel_joint`. What happens '
               'when the controller starts?', (
        wrong('It does not start: there is no such joint', 'The gain is an override without a declaration. That is '
              'no error.'),
        wrong('It gets the gain: the file is for this controller', 'The file reaches it, but the node declares no '
              'parameter of that name.'),
        right('It starts with its former gain, and reports nothing', 'The gain is an override without a declaration, '
              'so the node ignores it silently.'))),
    Prediction('10.3-2', 'Which of the four keys reach the controller in the namespace `/clawbot`?', (
        wrong('all but /wheel_controller', 'A name without a slash means the root namespace too, so '
              '`wheel_controller` is no better.'),
        right('/**/wheel_controller and /**', '`**` stands for any number of names, including none. The other two '
              'keys mean the root namespace.'),
        wrong('only /**', '`/**/wheel_controller` reaches it too: `**` stands for any number of names.'),
        wrong('all four', 'The first two mean the controller in the root namespace, and no other.'))),
    Prediction('10.3-3', 'The torque is `p` times the error, and nothing else. Which gain brings the wheel to 10 '
               'rad/s?', (
        wrong('both, the larger one sooner', 'Without an error there is no torque, and without torque the wheel slows '
              'down. It stays below 10.'),
        wrong('only 0.4', 'It comes closer. But without an error there is no torque, and the friction needs some.'),
        right('neither', 'Without an error there is no torque, and the friction needs some. More `p` makes the error '
              'smaller, never zero.'))),
    Prediction('10.3-4', 'The callback rejects whatever is below zero. What does it do with `nan`, which is not a '
               'number?', (
        wrong('It rejects it: nan is not a valid gain', 'The rule asks whether it is below zero, and `nan` is not '
              'below anything.'),
        wrong('It never sees it: the type is wrong', '`nan` is a double like any other, so the type is right.'),
        right('It accepts it', '`nan` is neither less nor greater than anything, so it is not below zero.'))),
    Prediction('10.3-5', '`u_clamp_min` is -2.0, and a client sets `u_clamp_max` to -3.0. What will the client hear, '
               'and what will the wheel do?', (
        right('accepted, and the wheel turns as before', 'The node stores -3.0 and goes on with the old clamps: '
              'parameter and controller disagree.'),
        wrong('accepted, and the wheel is clamped to -3.0', 'The value is stored, but the controller skips clamps '
              'that cross.'),
        wrong('rejected, and the wheel turns as before', 'The real controller has no callback that rejects crossing '
              'clamps, and neither has this one.'))),
    Prediction('10.3-6', 'Three gains are set in one call of `set_parameters`. How many different controllers does the '
               'wheel have, one after the other?', (
        right('3', 'Each gain is a change. Nobody has chosen the first two combinations.'),
        wrong('1', 'One call, but three changes: the service sets one parameter after the other.'),
        wrong('2', 'There are three changes, and the node puts each of them to use.')),
        otherwise='It has three: the service sets one parameter after the other.'),
    Prediction('10.3-7', 'What does this node do when it starts without a file?', (
        wrong('It starts with the three defaults', 'It checks the defaults too, and the default of '
              '`command_interface` fails.'),
        wrong('It starts, and command_interface is unset', 'It has a default, the empty string, and that default fails '
              'the check.'),
        right('It does not start', 'The default of `command_interface` is empty, and `not_empty<>` applies to '
              'defaults too.'))),
)
