"""Predictions of chapter 5.2: who judges, who acts, and when."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'You judge first and act later, and your motor never runs backward by accident.'

RECALLS = (
    Recall('5.2-r1', 'A script runs `ros2 param set`, and the node rejects the value. What is the exit status of the '
           'command?', (
        wrong('1', 'The command prints the rejection and ends with 0 all the same. A script has to read what it '
              'prints.'),
        right('0', 'The command prints the rejection and ends with 0 all the same. A script has to read what it '
              'prints.')),
           chapter='5.1', section='Break it: rejections and mistakes'),
    Recall('5.2-r2', "A node keeps `speed = self.get_parameter('max_speed_rpm')`. Later someone changes the "
           'parameter. What is `speed.value`?', (
        right('the old value', 'The object keeps the value that it had when the node took it.'),
        wrong('the new value', 'The object is not connected with the node. Ask again with `get_parameter`.')),
           chapter='4', section='An object and its value'),
)

PREDICTIONS = (
    Prediction('5.2-1', 'All four values are reasonable, and of the types that the robot declared. How many of the '
               'four commands succeed?', (
        wrong('all four', 'A `Parameter.Type` equals no number, so the two always differ, and the robot rejects every '
              'speed and every acceleration.'),
        wrong('three', 'The range ends at 2.0. It is the comparison of the types that rejects 0.75, and 150 as well.'),
        right('two', 'The callback rejects the speed and the acceleration: a `Parameter.Type` equals no number, so the '
              'two always differ. The other two pass, because it does not look at them.'),
        wrong('none', 'The callback looks at the speed and the acceleration only. The other two commands succeed.'))),
    Prediction('5.2-2', 'The speed is 100, and someone sets 150. What does `get_parameter` return within the on-set '
               'callback?', (
        wrong('150', 'While the on-set callback runs, nothing is stored. 150 is a proposal, which may still be '
              'rejected.'),
        right('100', 'While the on-set callback runs, the old value is still the value.'),
        wrong('an exception', 'Nothing is locked. The callback reads the old value.'))),
    Prediction('5.2-3', 'The motor follows in a post-set callback now. Someone sets 120, and then -20. What do motor '
               'and parameter say in the end?', (
        right('motor 120, parameter 120', 'No surprise this time, and that is what post-set is for: it was called for '
              '120, which was stored, and not for -20, which was rejected.'),
        wrong('motor -20, parameter 120', 'rclpy calls a post-set callback only when a value is stored, and -20 never '
              'was.'),
        wrong('motor 100, parameter 120', 'The post-set callback was called for 120, once it was stored.'))),
    Prediction('5.2-4', 'The robot starts with `-p max_speed_rpm:=250`. Its constructor sets `motor_rpm` to 100, and '
               'registers the post-set callback after the declaration. What do motor and parameter say?', (
        wrong('motor 250, parameter 250', 'The callback was registered after the declaration, so nobody told the '
              'motor about the override.'),
        right('motor 100, parameter 250', 'The override took the place of the default when the parameter was declared. '
              'But the constructor set the motor to 100.'),
        wrong('motor 100, parameter 100', 'The override takes the place of the default, so the parameter says 250.'))),
    Prediction('5.2-5', "A client asks for 'fast', a string, where an integer is declared. The pre-set callback calls "
               '`min(value, 300)`. What happens?', (
        wrong('The node rejects the type', 'It would, one rung later. rclpy checks the type after the pre-set '
              'callbacks, and this one fails first.'),
        wrong('The value is cut to 300', "`min` can't compare a string with a number. It raises a `TypeError`."),
        right('The callback itself fails', "rclpy has not checked the type yet, and `min` can't compare a string with "
              'a number.'))),
    Prediction('5.2-6', 'This node registered its three callbacks, and then declared two parameters. Which callbacks '
               'were called?', (
        wrong('none of the three', 'A declaration stores a value too. rclpy calls on-set before that, and post-set '
              'after it.'),
        wrong('all of the three', 'A declaration does not call pre-set callbacks: there is no request to rewrite.'),
        right('on-set and post-set', 'A declaration calls both, for each parameter. It does not call pre-set.'),
        wrong('on-set only', 'rclpy calls post-set too, after it has stored the value.'))),
    Prediction('5.2-7', 'One `set_parameters` request holds two parameters. How often is the on-set callback '
               'called?', (
        wrong('once, with both', 'That would be an atomic request. `set_parameters` sets one parameter after the '
              'other.'),
        right('twice, with one each', '`set_parameters` sets one parameter after the other, and each goes down '
              'the whole ladder.'))),
    Prediction('5.2-8', 'The judge rejects negative speeds in its on-set callback, which it registered after the '
               'declaration. We start it with `-p max_speed_rpm:=-20`. What is its speed?', (
        wrong('100', 'When the parameter is declared, the callback is not registered yet, so rclpy does not call it.'),
        wrong('none', 'It would not start if a range rejected the override. But the callback is not registered yet '
              'when the parameter is declared.'),
        right('-20', 'The override counts when the parameter is declared. The callback is registered after that.'))),
    Prediction('5.2-9', 'The winch holds 100 kg and 60 rpm, and its load times its speed may be 10,000 at most. First '
               'it is set to 400 kg alone, then to 400 kg and 20 rpm in one atomic request. What does it answer?', (
        wrong('It rejects both', '400 times 20 is 8000, and the callback gets both values at once. The second request '
              'keeps the rule.'),
        right('It rejects the first and accepts the second', 'Do the sum, and that is all: 400 times 60 is too much, '
              'and 400 times 20 is not.'),
        wrong('It accepts both', '400 times the stored 60 is 24,000, so the first request breaks the rule.'))),
)
