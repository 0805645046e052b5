"""Predictions of chapter 10.5: sets of parameters, compared and brought back."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'You know what differs, and the way back. Six services were enough for it.'

RECALLS = (
    Recall('10.5-r1', '`set_parameters` asks for three parameters, and the node rejects the second. What is stored '
           'then?', (
        right('the first and the third', 'The node decides about each parameter separately.'),
        wrong('only the first of the three', 'The node goes on, and decides about each parameter separately.'),
        wrong('not one of the three', 'That is what `set_parameters_atomically` does. Here the node decides about each '
              'separately.')),
           chapter='5.3', section='One by one, or all or nothing'),
    Recall('10.5-r2', 'A rule holds for two parameters. Which values does a right on-set callback judge?', (
        wrong('the values in the request', 'A request may hold one of the two, and the other is then the stored one.'),
        right('the values after the change', 'Proposed where there is one, and stored where there is none.'),
        wrong('each new with each old value', 'With both in one request, neither of the stored ones will be there '
              'afterwards.')),
           chapter='10.4', section='Five gaps'),
)

PREDICTIONS = (
    Prediction('10.5-1', "What does Python say to `{'gain': 1, 'safe': True} == {'gain': 1.0, 'safe': 1}`?", (
        right('True', 'For Python 1 equals 1.0, and True equals 1. For ROS nothing in the two is equal.'),
        wrong('False', 'The types differ, and for ROS that makes the values different. Python compares only the '
              'numbers.'))),
    Prediction('10.5-2', 'The file says 150 rpm and *brisk*, the robot holds 250 rpm and *brisk*. How many '
               'differences does `compare(file, robot, names=file)` find?', (
        right('1', 'You see it with the naked eye: the speed. The five parameters that the file does not mention are '
              'left out.'),
        wrong('6', 'So many it would find without `names=`: the speed, and five names that only the robot has.'),
        wrong('2', 'The mode is the same on both sides.')),
        otherwise='It finds one: the speed.'),
    Prediction('10.5-3', 'Stored are -30 and -10, and the saved set says -5 and 40. `set_parameters` gets all seven '
               'parameters of the set, in this order. How many does the robot reject?', (
        wrong('0', 'Two are read-only, and a request for them is rejected even if it changes nothing. And `low_c` '
              'meets the stored -10.'),
        wrong('2', 'The two read-only ones, and one more: `low_c` comes first and meets the stored -10.'),
        right('3', 'Two are read-only, and `low_c` meets the stored -10.')),
        otherwise='Three. Two are read-only, and `low_c` meets the stored -10.'),
    Prediction('10.5-4', 'The robot in the lab has another `serial`, which is read-only, and no `wings`. Its `low_c` '
               'differs as well. What does the atomic request of `bring_back` set?', (
        wrong('only low_c', 'An atomic request is all or nothing, and two of its parts are impossible.'),
        wrong('all before serial', 'The order does not matter: an atomic request is all or nothing.'),
        right('nothing at all', 'An atomic request is all or nothing, and two of its parts are impossible.'))),
    Prediction('10.5-5', 'Three values have changed since that evening, and `watch` saw one of the changes. How many '
               'values does the log bring back?', (
        right('3', 'When `watch` began, it wrote down the value of every parameter. That is enough to tell what they '
              'were that evening.'),
        wrong('1', 'The log has one change in it, but it has more than changes: the value of every parameter, from '
              'when `watch` began.'),
        wrong('0', 'A log with a gap is not worthless. The gap hides when the two values changed, and from what. It '
              'does not hide what they were before.')),
        otherwise='Three. When `watch` began, it wrote down the value of every parameter.'),
)
