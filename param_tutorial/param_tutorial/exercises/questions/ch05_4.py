"""Predictions of chapter 5.4: callbacks that wait, and what keeps their answers out."""

from param_tutorial.exercises.prediction import Prediction, Recall, Scale, right, wrong

SOLVED = 'Your callbacks wait without hanging, and you know who keeps an answer out.'

RECALLS = (
    Recall('5.4-r1', 'Who calls the method that a node has given to `create_timer`?', (
        wrong('The timer, in a thread of its own', 'A timer has no thread. It only knows when it is due.'),
        right('The executor, in the thread that spins', 'It calls whatever is due, one callback after the other.'),
        wrong('The node, between its other methods', 'A node does nothing by itself. `rclpy.spin` runs an executor, '
              'and that calls its callbacks.')),
           chapter='3', section='From a class to a program'),
    Recall('5.4-r2', 'A timer’s callback blocks until another node has answered, under `rclpy.spin`. When does the '
           'answer arrive?', (
        wrong('As soon as the other node sends it', 'The one thread is busy with the callback, so nobody takes the '
              'answer from the network.'),
        wrong('When the timer comes the next time', 'The timer doesn’t come again before the callback has ended, and '
              'that waits for the answer.'),
        right('Never, unless the callback gives up', 'The one thread is busy with the callback, and that waits for the '
              'answer.')),
           chapter='5.3', section="Don't wait for it"),
)

PREDICTIONS = (
    Prediction('5.4-1', 'Its timer had a group of its own before, and its question got an answer. Now it has none, and '
               'has logged its question. What does it log in the next two seconds?', (
        wrong('the answer, as it did before', '`await` gives the thread back, but not the group: the executor starts '
              'no other callback of the group until `tick` has finished.'),
        right('nothing, and nothing later on', '`tick` is paused but not finished, and until it has finished, no other '
              'callback of its group starts. So the client cannot receive the answer.'),
        wrong('a warning, and then the answer', 'There is no warning. No other callback of its group starts until '
              '`tick` has finished, so `tick` waits forever.'))),
    Prediction('5.4-2', 'Three nodes ask: one with a group for its timer, one with a group for its client, and one '
               'with a single reentrant group for both. How many of the three get an answer?', (
        right('3', 'In the first two, the client is in another group than the timer. In the third, callbacks may '
              'overlap.'),
        wrong('2', 'The third one gets its answer, too: in a reentrant group, callbacks may overlap.'),
        wrong('1', 'It doesn’t matter which of the two is in another group, and in a reentrant one callbacks may '
              'overlap.')),
        otherwise='All three do. In the first two, the client is in another group than the timer. In the third, '
                  'callbacks may overlap.'),
    Prediction('5.4-3', 'This one blocks in `call`, in an executor with two threads, and its timer has a group of its '
               'own. Does it get its answer?', (
        wrong('No, it waits for it forever', 'It keeps one thread, and its own group. The other thread and the default '
              'group are free, and the client needs no more.'),
        right('Yes, in the other group', 'Exactly what the two threads and the two groups are for: one thread waits in '
              'one group, and the other brings the answer in the other group.'),
        wrong('Only with a client group', 'Timer and client have to be in two groups. One of them may stay in the '
              'default group.'))),
    Prediction('5.4-4', 'After half a second the future is canceled. What does `await future` return then?', (
        right('None', 'The future has no result, and nothing says that it was canceled. So look before you use it.'),
        wrong('False', 'It returns what the future’s result is, and a canceled one has none: `None`.')),
        otherwise='It returns `None`: the future has no result.'),
    Prediction('5.4-5', 'The driver holds 0.2. Its own `set_parameters` gets `max_sped_mps = 0.1`, which is not '
               'declared, and `max_speed_mps = 0.1`, which is. Which speed does it hold then?', (
        right('0.2', 'The first name raises an exception, and what comes after it is not tried.'),
        wrong('0.1', 'The service would go on after a rejection. This method raises an exception at the first '
              'name.')),
        scale=Scale(0, 1, 0.1, 'm/s'),
        otherwise='It holds 0.2: the first name raises an exception, and what comes after it is not tried.'),
)
