"""Predictions of chapter 5.1: what a terminal asks, and what the node answers."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'A dot, a quote, a pair of quotes: you spell values so that they arrive.'

RECALLS = (
    Recall('5.1-r1', 'A node copied `max_speed_rpm` into an attribute in its constructor, and its timer uses that '
           'attribute. Someone sets the parameter from 100 to 150, and the node accepts. How fast does it drive?', (
        wrong('150', 'Accepting a value stores it in the parameter. The copy knows nothing of that.'),
        right('100', 'The parameter says 150, but the node still uses its copy.')),
           chapter='4', section='Change it: when does a node notice?'),
    Recall('5.1-r2', 'A parameter is a double. Someone sends it the integer 1. What does the node do?', (
        wrong('It stores the double 1.0', 'An rclpy node does not convert, not even an integer to a double.'),
        wrong('It stores the integer 1', 'The declaration fixed the type. An integer is another type.'),
        right('It rejects the integer 1', 'The node does not convert: an integer is the wrong type for a double.')),
           chapter='3', section='One default, one type'),
)

_EIGHT = 'rclpy declares two more: `use_sim_time` and `start_type_description_service`.'

PREDICTIONS = (
    Prediction('5.1-1', 'The node declares six parameters. How many names does `ros2 param list` print for it?', (
        right('8', _EIGHT),
        wrong('6', _EIGHT),
        wrong('7', 'One more: besides `use_sim_time` there is `start_type_description_service`.')),
        otherwise='It prints eight: the six, `use_sim_time` and `start_type_description_service`.'),
    Prediction('5.1-2', 'You have set the speed to 150. What has the node logged about it?', (
        wrong('a change of its speed', 'A node logs what its program tells it to log. This program has no line for a '
              'change.'),
        wrong('a warning about it', 'A node does not mind who sets its parameters. It does not even learn who did.'),
        right('nothing about it', 'The node stored the value, and none of its own lines ran.'))),
    Prediction('5.1-3', 'The acceleration is a double, the speed an integer, the name a string. How many of these four '
               'values does the node accept: 0.75 and 1 for the acceleration, 150.5 for the speed, 42 for the '
               'name?', (
        right('1', 'Only 0.75. `1` is an integer, `150.5` a double, and `42` an integer too. The node converts none '
              'of them.'),
        wrong('2', 'Only 0.75. If you counted the 1: it has no dot, so it is an integer. If you counted the 42: it has '
              'no quotes, so it is not a string.'),
        wrong('3', 'Only 0.75. `1` has no dot, so it is an integer, and `42` has no quotes, so it is not a string.'),
        wrong('4', 'Only 0.75. The node converts nothing: not 1 to a double, not 150.5 to an integer, not 42 to a '
              'string.'),
        wrong('0', 'One: 0.75 has a dot, so it is a double, like the acceleration.')),
        otherwise='It accepts one: 0.75. It does not convert the others.'),
    Prediction('5.1-4', 'You set the speed, an integer, to `12:30`. What does the robot make of it?', (
        wrong('an error', 'In YAML 1.1 that is a number, in base 60, so the robot gets an integer.'),
        wrong('12 rpm', 'YAML 1.1 does not stop at the colon. It reads 12 times 60 plus 30.'),
        right('750 rpm', '12 times 60 plus 30: YAML 1.1 reads numbers in base 60.'))),
    Prediction('5.1-5', 'The node rejects 5.0. With which exit status does `ros2 param set` end?', (
        right('0', 'The command sends the request and prints the answer. It ends with 0 whatever the answer is.'),
        wrong('1', 'A rejection is an answer, and the command printed it. Its exit status is 0.'),
        wrong('2', 'Only the text has the reason. The exit status is 0.'))),
    Prediction('5.1-6', 'You misspell a name: `ros2 param set … max_sped_rpm 150`. What happens?', (
        wrong('The node gets a new parameter max_sped_rpm', 'That was so in ROS 1. This node has the parameters that '
              'it declared, and no others.'),
        right('The node rejects it', 'As you would expect of a node that declares what it has: it has not declared '
              'that name, so it rejects the request.'),
        wrong('The command does not send it', 'The command does not look up the name first. The node does, and rejects '
              'the request.'))),
    Prediction('5.1-7', 'The same typo with `ros2 param get … max_sped_rpm`. With which exit status does it end?', (
        wrong('0', '`set` had an answer to print. `get` has no value to print, and says so with a 1.'),
        right('1', 'There is no value to print, so the command has failed.'))),
    Prediction('5.1-8', 'The program of `/late_robot` needs a second or two to start. You ask for a parameter at once, '
               'with `--timeout 20`. What happens?', (
        wrong('An error, and no value at all', 'That would be so without the option, or with a shorter time. '
              '`--timeout` gives the node time to appear.'),
        wrong('The value, after 20 seconds', 'The 20 seconds are the longest wait. The command goes on as soon as the '
              'node is there.'),
        right('The value, as soon as it can', 'The option does what its name says: `--timeout` is the longest wait, '
              'not the shortest.'))),
    Prediction('5.1-9', 'Two nodes are called `/simple_param_node`, one on the stage and one in a terminal. One '
               '`ros2 param set` sets the speed to 70. Which of them obeys?', (
        wrong('The one that started last', 'The second node does not take over the name. Both have it, and both offer '
              'the service.'),
        wrong('Both, in any case', 'Both do if the command has found both. It sends the request as soon as it has '
              'found one.'),
        right('One of them, or both', 'The request reaches the nodes that the command has found, and it waits for one '
              'only. It prints the answer that comes first.'))),
)
