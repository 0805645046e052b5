"""Predictions of chapter 8: what will hurt the next person."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'The next person who starts your node will not know whom to thank.'

RECALLS = (
    Recall('8-r1', 'An on-set callback accepts a speed and starts the motor with it. Then a second on-set callback '
           'rejects the speed. Which has the new speed in the end, the motor or the parameter?', (
        right('only the motor has it', 'The first callback acted on a proposal, and the proposal failed.'),
        wrong('both of them have it', 'A value is stored only if all callbacks accept it.'),
        wrong('neither of them has it', 'Nothing takes back what the first callback did. The motor already runs with '
              'the proposal.')),
           chapter='5.2', section='Acting too early'),
    Recall('8-r2', "The file says 180 rpm. A launch file has `parameters=[config, {'max_speed_rpm': 200}]`, where "
           '`config` is that file. With which speed does the robot start?', (
        right('200', 'Here the later source in the list wins.'),
        wrong('180', 'Here the later source in the list wins, and that is the dictionary.')),
           otherwise='200. Here the later source in the list wins, and that is the dictionary.',
           chapter='7.2', section='The command line that a launch types'),
)

PREDICTIONS = (
    Prediction('8-1', '`Late` declares its speed on the first ride. Someone starts it, and sets the speed before any '
               'ride. What is the answer?', (
        wrong('It is accepted for later', 'An override at the start waits for a declaration. A value that someone sets '
              'does not.'),
        right('It is rejected at once', 'Before the first ride there is no such parameter, so it can be neither seen '
              'nor set.'),
        wrong('There is no such node', '`Late` starts. It has no such parameter until its first ride.'))),
    Prediction('8-2', 'The descriptor of `before` says *double*, and its default is `0`. What does the node answer to '
               'the sensible speed 0.3?', (
        right('It rejects the speed 0.3', 'The default `0` has made it an integer, and the field `type` of the '
              'descriptor was overwritten.'),
        wrong('It accepts the speed 0.3', 'The default `0` has made it an integer, whatever the descriptor says. 0.3 '
              'is a double.'),
        wrong('It rounds the speed to 0', 'ROS converts nothing and rounds nothing. The value is of the wrong type.'))),
    Prediction('8-3', 'The four requests are 0.2 m/s; 0.5 m/s with 900 kg, which both nodes reject; 500 kg; and 0.1 '
               'm/s. How high, in meters, is the platform of `before` after four seconds?', (
        right('1.3', 'It started its motor while it judged, and drove at 0.5 m/s for two seconds: 0.2 + 0.5 + 0.5 + '
              '0.1.'),
        wrong('0.7', 'That is the node `after`. The node `before` started its motor while it judged, and nothing '
              'undoes that.'),
        wrong('0.8', 'A rejection stops nothing. The motor of the node `before` runs on at the speed that was '
              'rejected.'),
        wrong('1.0', 'Nothing takes the motor back to 0.2 m/s: the third request sets only the load. The motor runs at '
              '0.5 m/s for two seconds.')),
        otherwise='It is at 1.3 m: 0.2 + 0.5 + 0.5 + 0.1. The node `before` started its motor while it judged, and '
                  'nothing undoes that.'),
    Prediction('8-4', '`Careful` judges its start values before it registers its callback, and the forks carry 800 kg. '
               'What happens when it is started with 900?', (
        right('It ends with an error', 'As it should be: its constructor holds the start values against the rule, and '
              'raises an exception.'),
        wrong('It starts with 900 kg', 'That is what `Patient` did, which judged changes only.'),
        wrong('It starts with 300 kg', 'An override that is rejected is not replaced by the default. The constructor '
              'raises an exception.'))),
    Prediction('8-5', 'The dump holds `max speed`, `arm/left` and `gains..kp`. A new node starts with the file. How '
               'many of the three come back?', (
        right('0', 'The node does not start. Between the two dots is a part without a name, and rcl rejects the whole '
              'file for it.'),
        wrong('3', 'None. Between the two dots is a part without a name, and rcl rejects the whole file for it.'),
        wrong('2', "None. rcl does not pass over what it can't read. It rejects the whole file."),
        wrong('1', 'None. rcl accepts spaces and slashes. It is the part without a name between the two dots that it '
              'rejects, and the whole file with it.')),
        otherwise='None, and the node does not start. Between the two dots is a part without a name, and rcl rejects '
                  'the whole file for it.'),
    Prediction('8-6', 'The default is 300 kg, and 600 were meant. The command line says `-p lift.maxload_kg:=600.0`; '
               'the parameter is `lift.max_load_kg`. How does the lift start?', (
        wrong('with 600 kg', 'The two names differ by an underscore. The node ignores an override whose name it does '
              'not declare.'),
        right('with 300 kg', 'The node ignores an override whose name it does not declare, and logs nothing.'),
        wrong('not at all', 'An unknown name among the overrides is not an error. The node ignores it and logs '
              'nothing.'))),
    Prediction('8-7', 'The launch file of the course starts in this scratch folder, too, which holds neither of the '
               'two parameter files. How do the two lifts start?', (
        wrong('each with its defaults', 'That was the path in `mine_launch.py`, which counts from the current folder. '
              'This launch file asks the package for its share folder.'),
        right('each with its own file', 'It works as it looks: the launch file asks the package for its share folder, '
              'so the current folder does not matter.'),
        wrong('neither of them starts', 'The launch file is installed with its package, and so are the two parameter '
              'files.'))),
)
