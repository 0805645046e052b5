"""Predictions of chapter 5.3: one node asks another, and sets its parameters."""

from param_tutorial.exercises.prediction import Prediction, Recall, Scale, right, wrong

SOLVED = 'Your tuner asks, sets, and goes on, whatever the driver says.'

RECALLS = (
    Recall('5.3-r1', '`max_speed_mps` was declared with the default 0.5. Someone sends the number `1`, without a dot. '
           'What does the node hold then?', (
        wrong('the double 1.0', 'ROS does not convert. An integer is not a double, and the node rejects it.'),
        right('the double 0.5', 'The node rejects an integer, so its value is what it was.'),
        wrong('the integer 1', 'The default has decided the type for good, and an integer is not a double.')),
           chapter='3', section='One default, one type'),
    Recall('5.3-r2', 'The driver dies in the middle of the drive. What does the base do?', (
        wrong('It drives on as it was told', 'A command counts for half a second. A driver has to repeat it.'),
        right('It stops after half a second', 'It has heard no command for so long. So a driver sends its command '
              'again and again.'),
        wrong('It stops at the very next tick', 'It cannot know yet: the next command may be on its way. It waits for '
              'half a second.')),
           chapter='3', section='Let it drive'),
)

PREDICTIONS = (
    Prediction('5.3-1', 'In a timer’s callback the node asks the driver, and waits for one second. The driver is on '
               'the stage, too. What does it log as the answer?', (
        wrong('The speed, which is 0.5', 'The only thread of the executor is busy with the callback that waits, so '
              'nobody brings the answer.'),
        right('The word `None` alone', 'The only thread of the executor is busy with the callback that waits. The '
              'second passes, and `call` returns `None`.'),
        wrong('Nothing but an exception', 'Nothing forbids it, and nothing warns. The callback waits until its limit '
              'has passed, and `call` returns `None`.'))),
    Prediction('5.3-2', 'The future has been canceled. What does `future.done()` say of it now, `True` or `False`?', (
        right('False', 'It is done only when an answer has come, or an exception.'),
        wrong('True', 'It is done only when an answer has come, or an exception. For this there is `cancelled()`.')),
        otherwise='It says `False`: a future is done only when an answer has come.'),
    Prediction('5.3-3', 'The tuner’s limit is 0.3 m/s. You set the driver to 0.9 m/s. Which speed, in m/s, does the '
               'driver hold a second later?', (
        right('0.3', 'Half a second later at most, the tuner asks again, and sets its limit.'),
        wrong('0.9', 'So it was, until the tuner asked again and set its limit.')),
        scale=Scale(0, 1, 0.1, 'm/s'),
        otherwise='It holds 0.3: the tuner has asked again, and has set its limit.'),
    Prediction('5.3-4', 'The driver holds 0.3 m/s and 0.5 m. One request, `set_parameters`, asks for 1.5 m/s and then '
               'for 1.2 m. How many of the two does the driver accept?', (
        right('1', 'It judges the speed first, beside the old distance, and rejects it. The distance it accepts.'),
        wrong('2', 'So it would be if both were judged together. The speed is judged alone, beside the old distance.'),
        wrong('0', 'One bad value does not stop the others. The distance is fine by itself.')),
        otherwise='It accepts one, the distance. The speed is judged before that, beside the old distance.'),
    Prediction('5.3-5', 'Now the same two go into one atomic request. How many of the two does the driver accept?', (
        right('2', 'Its callback gets both at once, and they go well together.'),
        wrong('1', 'An atomic request is never stored by halves.'),
        wrong('0', 'Its callback gets both at once, and judges the new speed beside the new distance.')),
        otherwise='It accepts both: the callback gets them at once, and judges the new speed beside the new distance.'),
)
