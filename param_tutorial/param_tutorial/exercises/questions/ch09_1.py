"""Predictions of chapter 9.1: what ROS 2 rejects when a node comes over from ROS 1."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'The node has moved, and its values are at home.'

RECALLS = (
    Recall('9.1-r1', 'A node asks for the value of a parameter that it has never declared. What does `get_parameter` '
           'do in ROS 2?', (
        wrong('It returns None instead', 'A node could overlook that. rclpy raises `ParameterNotDeclaredException`.'),
        wrong('It declares that name', 'Only `declare_parameter` declares.'),
        right('It raises an exception', 'rclpy raises `ParameterNotDeclaredException`.')),
           chapter='3', section='One default, one type'),
    Recall('9.1-r2', 'Two parameter files both have a block for `/robot` and give it another speed. Which speed does '
           'the robot start with?', (
        wrong('that of the first file', 'A later source overwrites an earlier one of the same block.'),
        right('that of the second file', 'A later source overwrites an earlier one of the same block.'),
        wrong('that of its declaration', 'That is no contradiction to rcl. A later source overwrites an earlier one.')),
           chapter='7.3', section='Two sources'),
)

PREDICTIONS = (
    Prediction('9.1-1', 'The node of ROS 2 declares `gains` with a dictionary as its default. What happens?', (
        wrong('It is stored as it is', 'None of the types of a parameter is a dictionary, so rclpy raises an '
              'exception.'),
        right('The node does not start', 'None of the types of a parameter is a dictionary, so rclpy raises an '
              'exception.'),
        wrong('It becomes two parameters', 'In a file a dictionary becomes two names. In `declare_parameter` rclpy '
              'raises an exception.'))),
    Prediction('9.1-2', 'The node starts with the file that ROS 1 loaded, unchanged. What happens?', (
        wrong('It starts with those values', 'rcl looks for a level `ros__parameters`, and finds a value before it.'),
        wrong('It starts with its defaults', 'The file is worse than useless: rcl finds a value before '
              '`ros__parameters`, and rejects the whole file.'),
        right('The start ends with an error', 'rcl rejects the whole file: there is a value before '
              '`ros__parameters`.'))),
    Prediction('9.1-3', 'The code says `10`, and the file now says `force_n: 12.5`. With which force does the node '
               'start?', (
        right('with none, it fails', 'The default `10` has made it an integer, and declaring it with 12.5 raises an '
              'exception.'),
        wrong('with a force of 12.5', "The default `10` has made it an integer, and 12.5 isn't one."),
        wrong('with a force of 12', 'ROS rounds nothing. The default has made it an integer, and 12.5 is rejected.'),
        wrong('with a force of 10', 'An override of the wrong type is not passed over: the declaration raises an '
              'exception.'))),
    Prediction('9.1-4', "In ROS 1 a stranger has set the gain to `[1, 'two', 3.0]`. The robot doubles its gain, "
               "`2 * rospy.get_param('~gain')`. What comes out?", (
        wrong('an exception from Python', 'Python doubles a list by repeating it, and ROS 1 never checked the type.'),
        wrong('a list with three elements', 'Python doubles the list and not its elements: it repeats all three.'),
        wrong('twice the earlier number', 'ROS 1 stores what it is given, mixed lists too.'),
        right('a list with six elements', 'Python doubles a list by repeating it. Nobody complains, and the mistake '
              'shows up somewhere else.'))),
    Prediction('9.1-5', 'Both robots ask for the misspelled name with 100 as the default in the call. The real speed '
               'is set to 180. Which of the two gets 180?', (
        wrong('both of the robots', 'Neither. Nobody has ever set the misspelled name, so both get 100.'),
        wrong('only the ROS 2 robot', 'It raises an exception without a default. With `get_parameter_or` it gets the '
              '100 that it brings along, too.'),
        right('neither of the two', 'Nobody has ever set the misspelled name, so both get the 100 that they bring '
              'along.'))),
    Prediction('9.1-6', 'The arm declares `gains.kp`, `gains.kd`, `gains/kp` and `gains`. How many of them does '
               "`get_parameters_by_prefix('gains')` return?", (
        right('2', 'Your eye is right: the group has the two with a dot after `gains`.'),
        wrong('3', 'A slash in the name of a parameter is accepted, and means nothing. So `gains/kp` is not in the '
              'group.'),
        wrong('4', 'A slash means nothing in the name of a parameter, and `gains` is a parameter beside the group.'),
        wrong('1', 'In the tree of ROS 1 a longer name destroys a shorter one. In ROS 2 all four exist side by side, '
              'and two have a dot after `gains`.')),
        otherwise='Two: the group has `gains.kp` and `gains.kd`.'),
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
    Prediction('9.1-8', 'In ROS 1, all three lines did what they say. Which of them does the node of ROS 2 accept?', (
        wrong('all three of them', 'It accepts none: the name was never declared, the word is no integer, and only '
              'dynamic typing allows a deletion.'),
        right('none of the three', 'The name was never declared, the word is no integer, and only dynamic typing '
              'allows a deletion.'),
        wrong('only the deletion', 'Only a dynamically typed parameter can be deleted from outside.'))),
)
