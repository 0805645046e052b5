"""Predictions of chapter 8: what will hurt the next person."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'The next person who starts your node will not know whom to thank.'

RECALLS = (
    Recall('8-r1', 'An on-set callback accepts a speed and starts the motor with it. Then a second on-set '
           'callback rejects the speed. What is the result?', (
        wrong('Neither the motor nor the parameter has the new speed', 'Nothing takes back what the first '
              'callback did. The motor already runs with the proposal.'),
        right('The motor has the new speed, the parameter the old one', 'The first callback acted on a proposal, '
              'and the proposal failed.'),
        wrong('Both have the new speed', 'A value is stored only if all callbacks accept it.')),
           chapter='5.2', section='Break it: acting too early'),
    Recall('8-r2', "The file says 180 rpm. A launch file has `parameters=[config, {'max_speed_rpm': 200}]`, "
           'where `config` is that file. With which speed does the robot start?', (
        wrong('180: the file', 'Here the later source in the list wins, and that is the dictionary.'),
        right('200: the dictionary', 'Here the later source in the list wins.')),
           chapter='7.2', section='Change it: values in the launch file'),
)

PREDICTIONS = (
    Prediction('8-1', '`Late` declares its speed on the first ride. Someone starts it, and sets the speed before any '
               'ride. What is the answer?', (
        wrong('accepted: the value waits for the declaration', 'An override at the start waits for a declaration. A '
              'value that someone sets does not.'),
        right('rejected: undeclared', 'Before the first ride there is no such parameter, so it can be neither seen nor '
              'set.'),
        wrong('none: the node does not start', '`Late` starts. It has no such parameter until its first ride.'))),
    Prediction('8-2', 'The descriptor of `before` says *double*, and its default is `0`. What does the node answer to '
               'the sensible speed 0.3?', (
        wrong('It accepts it', 'The default `0` has made it an integer, whatever the descriptor says. 0.3 is a '
              'double.'),
        wrong('It rounds it to 0', 'ROS converts nothing and rounds nothing. The value is of the wrong type.'),
        right('It rejects it: wrong type', 'The default `0` has made it an integer, and the field `type` of the '
              'descriptor was overwritten.'))),
    Prediction('8-3', 'Both nodes reject the second request as a whole. How high are the two platforms after four '
               'seconds?', (
        wrong('at the same height: both rejected it', 'The node `before` started its motor while it judged, and '
              'nothing undoes that.'),
        right('before is higher', 'It started its motor while it judged, and drove at the speed that it then '
              'rejected.'),
        wrong('after is higher: before has stopped', 'A rejection stops nothing. The motor of the node `before` runs '
              'at the speed that was rejected.'))),
    Prediction('8-4', '`Careful` judges its start values before it registers its callback, and the forks carry 800 '
               'kg. What happens when it is started with 900?', (
        wrong('It starts with 900 kg', 'That is what `Patient` did, which judged changes only.'),
        wrong('It starts with 300 kg, its default', 'An override that is rejected is not replaced by the default. '
              'The constructor raises an exception.'),
        right('It does not start', 'As it should be: its constructor holds the start values against the rule, and '
              'raises an exception.'))),
    Prediction('8-5', 'The dump holds `max speed`, `arm/left` and `gains..kp`. A new node starts with the file. What '
               'happens?', (
        wrong('All three come back', 'Between the two dots is a part without a name, and rcl rejects the whole file '
              'for it.'),
        wrong('Two come back, and gains..kp is ignored', "rcl does not pass over what it can't read. It rejects the "
              'whole file.'),
        wrong('One comes back: names have no spaces and no slashes', 'rcl accepts both. It is the part without a name '
              'between the two dots that it rejects, and the whole file with it.'),
        right('The node does not start', 'Between the two dots is a part without a name, and rcl rejects the whole '
              'file for it.'))),
    Prediction('8-6', 'The default is 300 kg, and 600 were meant. The command line says `-p lift.maxload_kg:=600.0`; '
               'the parameter is `lift.max_load_kg`. How does the lift start?', (
        wrong('with 600 kg', 'The two names differ by an underscore. The node ignores an override whose name '
              'it does not declare.'),
        right('with 300 kg, and no warning', 'The node ignores an override whose name it does not declare, '
              'and logs nothing.'),
        wrong('not at all', 'An unknown name among the overrides is not an error. The node '
              'ignores it and logs nothing.'))),
    Prediction('8-7', 'The launch file of the course starts in this scratch folder, too, which holds neither of the '
               'two parameter files. How do the two lifts start?', (
        right('each with the values of its file', 'It works as it looks: the launch file asks the package for its '
              'share folder, so the current folder does not matter.'),
        wrong('both with their defaults, after a warning', 'That was the path in `mine_launch.py`, which counts from '
              'the current folder. This launch file asks the package for its share folder.'),
        wrong('not at all', 'The launch file is installed with its package, and so are the two parameter files.'))),
)
