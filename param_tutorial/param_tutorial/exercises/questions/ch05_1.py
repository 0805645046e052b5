"""Predictions of chapter 5.1: what a terminal asks, and what the node answers."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'A dot, a quote, a pair of quotes: you spell values so that they arrive.'

RECALLS = (
    Recall('5.1-r1', 'A node copied `max_speed_rpm` into an attribute in its constructor, and its timer uses '
           'that attribute. Somebody sets the parameter from 100 to 150, and the node accepts. How fast does it '
           'drive?', (
        wrong('150: it has accepted', 'Accepting a value stores it in the parameter. The copy knows nothing of '
              'that.'),
        right('100', 'The parameter says 150, and the node still uses its copy.')),
           chapter='4', section='Change it: when does a node notice?'),
    Recall('5.1-r2', 'A parameter is a double. Somebody sends it the integer 1. What does the node do?', (
        wrong('It converts it, and stores 1.0', 'ROS never converts, not even a whole number to a double.'),
        wrong('It stores the integer 1', 'The type was fixed by the declaration. An integer is another type.'),
        right('It rejects the value', 'ROS never converts: an integer is the wrong type for a double.')),
           chapter='3', section='Build it: one declaration, one type'),
)

PREDICTIONS = (
    Prediction('5.1-1', 'The node declares six parameters. How many names does `ros2 param list` print for it?', (
        right('8', 'Two more belong to every node in Python: `use_sim_time` and `start_type_description_service`.'),
        wrong('6', 'Two more belong to every node in Python: `use_sim_time` and `start_type_description_service`.'),
        wrong('7', 'One more: besides `use_sim_time` there is `start_type_description_service`.')),
        otherwise='It prints eight: the six, `use_sim_time` and `start_type_description_service`.'),
    Prediction('5.1-2', 'The speed was just set to 150. What has the node logged about it?', (
        wrong('that its speed has changed', 'A node logs what its program tells it to log. Nothing in this one is '
              'called when a parameter changes.'),
        wrong('a warning that somebody else changed it', 'A node does not mind who sets its parameters, and it does '
              'not even learn who it was.'),
        right('nothing', 'The node stored the value, and no line of its program was called.'))),
    Prediction('5.1-3', 'The acceleration is a double, the speed an integer, the name a string. How many of these four '
               'values does the node accept: 0.75 and 1 for the acceleration, 150.5 for the speed, 42 for the '
               'name?', (
        right('1', 'Only 0.75. `1` is an integer, `150.5` a double, and `42` an integer too; ROS converts none of '
              'them.'),
        wrong('2', 'Only 0.75. If you counted the 1, it has no dot, so it is an integer. If you counted the 42, it has '
              'no quotes, so it is no string.'),
        wrong('3', 'Only 0.75. `1` has no dot, so it is an integer, and `42` has no quotes, so it is no string.'),
        wrong('4', 'Only 0.75. ROS converts nothing: neither 1 to a double, nor 150.5 to an integer, nor 42 to a '
              'string.'),
        wrong('0', 'One: 0.75 has a dot, so it is a double, as the acceleration is.')),
        otherwise='It accepts one: 0.75. ROS converts none of the others.'),
    Prediction('5.1-4', 'You set the speed, an integer, to `12:30`. What does the robot make of it?', (
        wrong('It rejects it: that is no number', 'In YAML 1.1 it is one, in base 60, and so the robot gets an '
              'integer.'),
        wrong('12 rpm', 'YAML 1.1 does not stop at the colon. It reads 12 times 60 plus 30.'),
        right('750 rpm', '12 times 60 plus 30: YAML 1.1 reads numbers in base 60.'))),
    Prediction('5.1-5', 'The node rejects 5.0. With which exit status does `ros2 param set` end?', (
        right('0', 'The command has done its work: it asked, and it brought back the answer.'),
        wrong('1', 'A rejection is an answer, and the command brought it back. Its exit status is 0.'),
        wrong('another number that stands for the reason', 'The reason is in the text only. The exit status is 0.')),
    ),
    Prediction('5.1-6', 'You misspell a name: `ros2 param set … max_sped_rpm 150`. What happens?', (
        wrong('The node gets a new parameter max_sped_rpm', 'It was so in ROS 1. In ROS 2 a node has the parameters '
              'that it declares.'),
        right('The node rejects it', "A name that was not declared does not exist, so it can't be set either."),
        wrong('The command does not send it', 'The command does not look up the name first. The node does, and rejects '
              'it.'))),
)
