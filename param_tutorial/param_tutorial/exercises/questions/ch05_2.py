"""Predictions of chapter 5.2: who judges, who acts, and when."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'You judge first and act later, and your motor never runs backwards by accident.'

RECALLS = (
    Recall('5.2-r1', 'A script types `ros2 param set`, and the node rejects the value. What is the exit status '
           'of the command?', (
        wrong('1: the value was not set', 'The command did its work: it asked, and it brought back the answer. A '
              'script has to read that answer.'),
        right('0', 'The command did its work: it asked, and it brought back the answer.')),
           chapter='5.1', section='Break it: rejections and mistakes'),
    Recall('5.2-r2', "A node keeps `speed = self.get_parameter('max_speed_rpm')`. Later somebody changes the "
           'parameter. What is `speed.value`?', (
        right('the old value', 'The object keeps the value of the moment when it was taken.'),
        wrong('the new value', 'The object is not connected with the node. Ask again with `get_parameter`.')),
           chapter='4', section='An object and its value'),
)

PREDICTIONS = (
    Prediction('5.2-1', 'The speed is 100, and 150 is being set. What does `get_parameter` return within the on-set '
               'callback?', (
        wrong('150', 'While the on-set callback runs, nothing is stored. 150 is a proposal, and it may still be '
              'rejected.'),
        right('100', 'While the on-set callback runs, the old value is still the value.'),
        wrong('an exception: the parameter is locked meanwhile', 'Nothing is locked. The callback reads the old value, '
              'as everybody else does at that moment.'))),
    Prediction('5.2-2', 'The newer callback set the motor to -20, and the older one then rejected -20. What do motor '
               'and parameter say?', (
        wrong('motor 100, parameter 100: the rejection undoes both', 'rclpy undoes nothing that a callback has done. '
              'It leaves the parameter as it was, and the motor turns.'),
        right('motor -20, parameter 100', 'The parameter was never changed, and nobody takes back what the callback '
              'did to the motor.'),
        wrong('motor -20, parameter -20: the first answer counts', 'One callback that says no is enough. The parameter '
              'stays at 100.'))),
    Prediction('5.2-3', 'The pre-set callback cuts the speed to 300 at most. A client asks for 900. What does the '
               'on-set callback see?', (
        wrong('900, as the client asked', 'The pre-set callback comes first, and what it returns takes the place of '
              'the request.'),
        right('300, while 100 is stored', 'What the pre-set callback returns takes the place of the request, and '
              'nothing is stored before on-set has agreed.'),
        wrong('300, and 300 is stored already', 'Nothing is stored before on-set has agreed. At that moment the '
              'parameter still says 100.'),
        wrong('nothing: the request is rejected', 'A pre-set callback rejects only by returning an empty list. This '
              'one returns another value.'))),
    Prediction('5.2-4', "A client asks for 'fast', a string, where an integer is declared. The pre-set callback calls "
               '`min(value, 300)`. What happens?', (
        wrong('The node rejects it: wrong type', 'It would, a rung later. The type is checked after the pre-set '
              'callbacks, and this one fails before.'),
        wrong('It is cut to 300', "`min` can't compare a string with a number. It raises a `TypeError`."),
        right('The callback raises an exception', 'In a pre-set callback no type has been checked yet, and `min` '
              "can't compare a string with a number."))),
    Prediction('5.2-5', 'The on-set callback returns `True` in place of a `SetParametersResult`. What becomes of the '
               'request?', (
        wrong('It is accepted: True means yes', 'rclpy wants a `SetParametersResult` and nothing else. Whatever is '
              'none counts as a no.'),
        right('It is rejected', 'Whatever is no `SetParametersResult` counts as a no, which is the safe side.'),
        wrong('The node ends with an exception', 'rclpy foresees this mistake. It rejects the request, and says that '
              'the callback returned an invalid type.'))),
    Prediction('5.2-6', 'The judge rejects negative speeds in its on-set callback, registered after the declaration. '
               'We start it with `-p max_speed_rpm:=-20`. What is its speed?', (
        wrong('100: the callback rejects the override', 'When the parameter is declared, the callback is not '
              'registered yet. Nobody asks it.'),
        wrong('There is none: the node does not start', 'It would not start if a range rejected the override. The '
              'callback is not registered yet when the parameter is declared.'),
        right('-20', 'The override counts when the parameter is declared, and the callback is registered only '
              'after that.'))),
)
