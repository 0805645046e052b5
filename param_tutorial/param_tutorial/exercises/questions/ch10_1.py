"""Predictions of chapter 10.1: what is published, to whom, and what is not."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'You listen first and ask afterwards, and your copy stays true.'

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
    Prediction('10.1-1', 'The robot rejects a speed of -1. What do the listeners hear?', (
        right('nothing at all', 'As simple as that: nothing stored, no event. Only the client gets an answer.'),
        wrong('the speed -1', 'An event reports what was stored, and nothing was.'),
        wrong('the old speed', 'A node publishes when it stores a value. Here it stored none, not even the old one '
              'again.'))),
    Prediction('10.1-2', 'The speed is set to 0. What does the monitor log, with its chain of `or`?', (
        wrong('0', 'The chain skips every field that is false in Python, and 0 is false.'),
        right('False', '0 is false in Python, so the chain runs through to its last field, `bool_value`.'),
        wrong('0.0', 'The chain does skip the integer 0. But it skips 0.0 as well, and ends with `bool_value`.'))),
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
    Prediction('10.1-5', 'The robot publishes three events: its speed is now 80, its speed is now 80, its name is now '
               '*Logged*. Before, the speed was 120. How many changes does the follower report?', (
        right('2', 'You counted as the follower does: the second event repeats a value that it knows already.'),
        wrong('3', 'The robot does publish three events. But the follower compares each with what it knows, and the '
              'second one repeats the first.'),
        wrong('1', 'The last value of each parameter is one change each: the speed and the name are two parameters, '
              'and both have changed.')),
        otherwise='Two: the second event repeats a value that the follower knows already.'),
    Prediction('10.1-6', 'The topic is reliable. 200 events come while nobody can look at them. Which of them does the '
               'listener with a depth of 10 get?', (
        right('the latest ten', 'A queue of ten keeps the newest ten. That the topic is reliable does not help.'),
        wrong('all 200 of them', 'Reliable means that they were delivered. The queue was too short to hold them.'),
        wrong('the first ten', 'A full queue drops its oldest message to make room for the next one.'))),
    Prediction('10.1-7', 'A listener arrives after 200 changes of the speed, and then the gain is set once. How many '
               'events does it hear?', (
        right('1', 'Only the gain. The topic is volatile: for what came before, a listener has to ask.'),
        wrong('2', 'Not the last speed, only the gain. The topic is volatile: a message goes to those who are '
              'listening at that moment, and is then forgotten.'),
        wrong('201', 'The topic is volatile: nothing is kept for those who subscribe later.')),
        otherwise='One, of the gain. The topic is volatile: nothing is kept for those who subscribe later.'),
    Prediction('10.1-8', 'A parameter callback is registered for `note`. The arm declares `note`, and then `note` is '
               'deleted. How often is the callback called?', (
        right('1', 'It hears of the declaration. The handler never looks for the name among the deleted parameters.'),
        wrong('2', 'The handler looks for the name among the new and the changed parameters, and not among the deleted '
              'ones.'),
        wrong('0', 'A declaration is an event too: `note` is new.')),
        otherwise='Once, for the declaration. The handler never looks for the name among the deleted parameters.'),
)
