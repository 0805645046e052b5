"""Predictions of chapter 9.1: what ROS 2 rejects when a node comes over from ROS 1."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'The node has moved, and its values are at home.'

RECALLS = (
    Recall('9.1-r1', 'A node asks for the value of a parameter that it has never declared. What does '
           '`get_parameter` do in ROS 2?', (
        wrong('It returns None', 'A node could overlook that. rclpy raises `ParameterNotDeclaredException`.'),
        wrong('It declares the parameter', 'Only `declare_parameter` declares.'),
        right('It raises an exception', 'rclpy raises `ParameterNotDeclaredException`.')),
           chapter='3', section='Break it: a name that was never declared'),
    Recall('9.1-r2', 'Two parameter files both have a block for `/robot` and give it another speed. Which speed '
           'does the robot start with?', (
        wrong('that of the first file', 'A later source overwrites an earlier one of the same block.'),
        right('that of the second file', 'A later source overwrites an earlier one of the same block.'),
        wrong('its default: the files contradict each other', 'That is no contradiction to rcl. A later source '
              'overwrites an earlier one.')),
           chapter='7.3', section='Two sources'),
)

PREDICTIONS = (
    Prediction('9.1-1', 'The node of ROS 2 declares `gains` with a dictionary as its default. What happens?', (
        wrong('The dictionary is stored, as in ROS 1', 'None of the types of a parameter is a dictionary, so rclpy '
              'raises an exception.'),
        wrong('It becomes two parameters, gains.kp and gains.kd', 'In a file a dictionary becomes two names. In '
              '`declare_parameter` rclpy raises an exception.'),
        right('The node does not start', 'None of the types of a parameter is a dictionary, so rclpy raises an '
              'exception.'))),
    Prediction('9.1-2', 'The node starts with the file that ROS 1 loaded, unchanged. What happens?', (
        wrong('It starts with the values of the file', 'rcl looks for a level `ros__parameters`, and finds a value '
              'before it.'),
        wrong('It starts with its defaults: nothing in the file is for it', 'The file is worse than useless: rcl '
              'finds a value before `ros__parameters`, and rejects the whole file.'),
        right('It does not start', 'rcl rejects the whole file: there is a value before `ros__parameters`.'))),
    Prediction('9.1-3', 'The code says `10`, and the file now says `force_n: 12.5`. With which force does the node '
               'start?', (
        wrong('12.5', "The default `10` has made it an integer, and 12.5 isn't one."),
        wrong('12', 'ROS rounds nothing. The default has made it an integer, and 12.5 is rejected.'),
        wrong('10, and a warning', 'An override of the wrong type is more than a warning: the declaration raises an '
              'exception.'),
        right('It does not start', 'The default `10` has made it an integer, and declaring it with 12.5 raises an '
              'exception.'))),
    Prediction('9.1-4', "In ROS 1 a stranger has set the gain to `[1, 'two', 3.0]`. The robot doubles its gain, "
               "`2 * rospy.get_param('~gain')`. What comes out?", (
        wrong('an exception: a list is no number', 'Python doubles a list by repeating it, and ROS 1 never checked the '
              'type.'),
        right('a list of six elements', 'Python doubles a list by repeating it. Nobody complains, and the mistake '
              'shows up somewhere else.'),
        wrong("[2, 'twotwo', 6.0]", 'Python doubles the list and not its elements: it repeats all three.'),
        wrong('1.0, since the list was never stored', 'ROS 1 stores what it is given, mixed lists too.'))),
    Prediction('9.1-5', 'Both robots ask for the misspelled name with 100 as the default in the call. The real speed '
               'is set to 180. Which of the two gets 180?', (
        wrong('both', 'Neither. Nobody has ever set the misspelled name, so both get 100.'),
        wrong('the one of ROS 2: it knows its names', 'It raises an exception without a default. With '
              '`get_parameter_or` it gets the 100 that it brings along, too.'),
        right('neither', 'Nobody has ever set the misspelled name, so both get the 100 that they bring along.'))),
    Prediction('9.1-6', "The arm declares `gains.kp`, `gains.kd`, `gains/kp` and `gains`. Which of them does "
               "`get_parameters_by_prefix('gains')` return?", (
        right('gains.kp and gains.kd', 'Your eye is right: the group has the two with a dot after `gains`.'),
        wrong('gains.kp, gains.kd and gains/kp', 'A slash in the name of a parameter is accepted, and means nothing.'),
        wrong('all four', 'A slash means nothing in the name of a parameter, and `gains` is a parameter beside the '
              'group.'),
        wrong('gains alone: a longer name destroys a shorter one', 'That is the tree of ROS 1. In ROS 2 all four '
              'exist side by side.'))),
    Prediction('9.1-7', 'A string of two lines, the strings `1e5` and `1.0`, and an empty list: how many of the four '
               'does `ros2 param load` set as they were saved?', (
        right('1', 'Only `1e5`. The two lines become one, and `1.0` and the empty list turn into something that the '
              'node rejects.'),
        wrong('4', 'ROS 1 does that. Here the two lines become one, and `1.0` and the empty list turn into something '
              'that the node rejects.'),
        wrong('3', 'Only `1e5`. The two lines become one, and `1.0` and the empty list are both rejected.'),
        wrong('2', 'Only `1e5`. The two lines become one, and `1.0` and the empty list are both rejected.'),
        wrong('0', 'One: `1e5` gets through, since the second reader takes it for a string too.')),
        otherwise='It is one: `1e5`. The two lines become one, and the other two are rejected.'),
    Prediction('9.1-8', 'In ROS 1, all three lines did what they say. How many of them does the node of ROS 2 '
               'accept?', (
        wrong('all three: set, set and delete', 'It accepts none: the name was never declared, the word is no integer, '
              'and only dynamic typing allows a deletion.'),
        wrong('one: the deletion', 'Only a dynamically typed parameter can be deleted from outside.'),
        right('none', 'The name was never declared, the word is no integer, and only dynamic typing allows a '
              'deletion.'))),
)
