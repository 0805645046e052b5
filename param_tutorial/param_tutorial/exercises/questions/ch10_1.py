"""Predictions of chapter 10.1: what is published, to whom, and what is not."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'Your tuner listens first, asks afterward, and misses nothing.'

RECALLS = (
    Recall('10.1-r1', 'A node sets its motor in a post-set callback. A client requests a speed that the node rejects. '
           'What does the post-set callback do?', (
        wrong('It gets the old speed', 'A post-set callback gets what has been stored, and a rejected request stores '
              'nothing.'),
        wrong('It gets the rejected speed', 'It is called only after all values have been accepted and stored.'),
        right('It is not called for this', 'A post-set callback gets what has been stored, and nothing has.')),
           chapter='5.2', section='Acting on what is stored'),
    Recall('10.1-r2', 'A callback sends a request to another node and then blocks until the answer comes, under the '
           'usual single-threaded executor. What happens?', (
        right('The answer never comes at all', 'Only the executor could deliver the answer, and the callback keeps the '
              'executor busy.'),
        wrong('The answer comes a little late', 'The executor would have to deliver the answer, and this callback '
              'keeps the executor busy.')),
           chapter='5.3', section="Don't wait for it"),
)

PREDICTIONS = (
    Prediction('10.1-1', 'The driver is asked for 5.0 m/s, which is out of its range, and then for 0.2 m/s. How many '
               'events does it publish?', (
        right('1', 'Nothing stored, no event: only the client hears of a rejection.'),
        wrong('2', 'An event reports what was stored, and 5.0 was not.'),
        wrong('0', 'A node publishes when it stores a value, and it stored 0.2.')),
        otherwise='It publishes one. A rejected value is not stored, so there is no event of it.'),
    Prediction('10.1-2', 'The speed is set to 0.25, and then to 0.0. What does the monitor log of the second, with its '
               'chain of `or`?', (
        wrong('max_speed_mps = 0.0', 'The chain skips every field that is false in Python, and 0.0 is false.'),
        right('max_speed_mps = False', '0.0 is false in Python, so the chain runs through to its last field, '
              '`bool_value`.'),
        wrong('max_speed_mps = 0.25', 'The message holds the new value alone. The chain skips it, and ends with '
              '`bool_value`.'))),
    Prediction('10.1-3', 'Three parameters are set one by one, and then to the same values again, in one atomic '
               'request. How many messages are there in all?', (
        right('4', 'Three for the first three, and one for the atomic request, although its values are not new.'),
        wrong('3', 'One more: a node does not compare. The atomic request makes an event, although its values are '
              'not new.'),
        wrong('6', 'The atomic request makes one event for all three.'),
        wrong('2', 'The first three are set one by one, and each makes its own event.')),
        otherwise='There are four: three for the first three, and one for the atomic request.'),
    Prediction('10.1-4', "The node calls `undeclare_parameter('x')`. What do the listeners hear?", (
        wrong('that x is deleted', 'The list of deleted parameters is for dynamic ones that were set to nothing. '
              '`undeclare_parameter` publishes no event.'),
        wrong('that x has changed', '`undeclare_parameter` publishes no event, so x is in none of the three lists.'),
        right('not a word about x', '`undeclare_parameter` publishes no event, and a listener keeps believing in the '
              'parameter.'))),
    Prediction('10.1-5', 'The topic is reliable. 200 events come while nobody can look at them. How many of them does '
               'the listener with a depth of 10 get?', (
        right('10', 'A queue of ten keeps the newest ten. That the topic is reliable does not help.'),
        wrong('200', 'Reliable means that they were delivered. The queue was too short to hold them.')),
        otherwise='It gets the newest ten. Its queue was too short to hold more.'),
    Prediction('10.1-6', 'A listener arrives after 200 changes of the speed, and then the gain is set once. How many '
               'events does it hear?', (
        right('1', 'Only the gain. The topic is volatile: for what came before, a listener has to ask.'),
        wrong('2', 'Not the last speed, only the gain. The topic is volatile: a message goes to those who are '
              'listening at that moment, and is then forgotten.'),
        wrong('201', 'The topic is volatile: nothing is kept for those who subscribe later.')),
        otherwise='One, of the gain. The topic is volatile: nothing is kept for those who subscribe later.'),
)
