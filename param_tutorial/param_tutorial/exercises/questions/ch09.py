"""Predictions of chapter 9: what ROS 1 took, and what ROS 2 does with it."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'The node has moved, its values are at home, and the master is not missed.'

RECALLS = (
    Recall('9-r1', 'A node asks for the value of a parameter that it has never declared. What does '
           '`get_parameter` do in ROS 2?', (
        wrong('It returns None', 'A node could overlook that. rclpy raises `ParameterNotDeclaredException`.'),
        wrong('It declares the parameter', 'Only `declare_parameter` declares.'),
        right('It raises an exception', 'rclpy raises `ParameterNotDeclaredException`.')),
           chapter='3', section='Break it: a name that was never declared'),
    Recall('9-r2', 'Two parameter files both have a block for `/robot` and give it another speed. Which speed '
           'does the robot start with?', (
        wrong('that of the first file', 'A later source overwrites an earlier one of the same block.'),
        right('that of the second file', 'A later source overwrites an earlier one of the same block.'),
        wrong('its default: the files contradict each other', 'That is no contradiction to rcl. A later source '
              'overwrites an earlier one.')),
           chapter='7.3', section='Two sources'),
)

PREDICTIONS = (
    Prediction('9-1', 'A stranger sets a color for a node that is not there, misspells a name, and deletes the speed '
               'of the robot. Which of the three does ROS 2 allow?', (
        wrong('all three, like ROS 1', "In ROS 2 the node itself is asked. One that is not there can't answer, and "
              'this one rejects the other two.'),
        wrong('the misspelled name: it becomes a new parameter', 'It was so in ROS 1. In ROS 2 a node has the '
              'parameters that it declares.'),
        wrong('the deletion', 'Only a dynamically typed parameter can be deleted from outside, and this one has a '
              'fixed type.'),
        right('none', 'Each node keeps its own parameters: no node, no parameter; no declaration, no name; and the '
              'type is fixed.'))),
    Prediction('9-2', 'In ROS 1 the robot sets its speed to 900, and is killed. A new robot of that name asks for '
               '`~max_speed_rpm`, with 100 as its default. What does it get?', (
        wrong('100: it is a new node', 'The value was never in the node. The parameter server keeps it.'),
        right('900', 'In ROS 1 the parameter server keeps the values, and they outlive the node.'),
        wrong('an error: the value went with the node', 'The value was never in the node. The parameter server keeps '
              'it, and hands it to the next.'))),
    Prediction('9-3', "In ROS 1 a stranger has set the gain to `[1, 'two', 3.0]`. The robot doubles its gain, "
               "`2 * rospy.get_param('~gain')`. What comes out?", (
        wrong('an exception: a list is no number', 'Python doubles a list by repeating it, and ROS 1 never checked the '
              'type.'),
        right('a list of six elements', 'Python doubles a list by repeating it. Nobody complains, and the mistake '
              'shows up somewhere else.'),
        wrong("[2, 'twotwo', 6.0]", 'Python doubles the list and not its elements: it repeats all three.'),
        wrong('1.0, since the list was never stored', 'ROS 1 stores what it is given, mixed lists too.'))),
    Prediction('9-4', 'In ROS 1, `dynamic_reconfigure` has the limit 300 for the speed. What becomes of a request for '
               '900?', (
        wrong('It is rejected, with a reason', 'ROS 2 does that. `dynamic_reconfigure` bends the value, and tells '
              'nobody why.'),
        right('It becomes 300', '`dynamic_reconfigure` bends a value until it fits. The caller has to compare to find '
              'out.'),
        wrong('It is stored: limits are for the slider only', 'The server enforces the limits, in its own way: it '
              'moves the value to the limit.'))),
    Prediction('9-5', 'A text of two lines, the texts `1e5` and `1.0`, and an empty list: how many of the four does '
               '`ros2 param load` set as they were saved?', (
        right('1', 'Only `1e5`. The two lines become one, and `1.0` and the empty list turn into something that the '
              'node rejects.'),
        wrong('4', 'ROS 1 does that. Here the two lines become one, and `1.0` and the empty list turn into something '
              'that the node rejects.'),
        wrong('3', 'Only `1e5`. The two lines become one, and `1.0` and the empty list are both rejected.'),
        wrong('2', 'Only `1e5`. The two lines become one, and `1.0` and the empty list are both rejected.'),
        wrong('0', 'One: `1e5` gets through, since the second reader takes it for a text too.')),
        otherwise='It is one: `1e5`. The two lines become one, and the other two are rejected.'),
)
