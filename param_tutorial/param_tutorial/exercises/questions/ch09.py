"""Predictions of chapter 9: what ROS 2 rejects when a node comes over from ROS 1, and where the values live."""

from param_tutorial.exercises.prediction import Prediction, Recall, Scale, right, wrong

SOLVED = 'The gripper has moved, and its values came with it.'

RECALLS = (
    Recall('9-r1', 'A node asks for the value of a parameter that it has never declared. What does `get_parameter` do '
           'in ROS 2?', (
        wrong('It returns None instead', 'A node could overlook that. rclpy raises `ParameterNotDeclaredException`.'),
        wrong('It declares that name', 'Only `declare_parameter` declares.'),
        right('It raises an exception', 'rclpy raises `ParameterNotDeclaredException`.')),
           chapter='3', section='One default, one type'),
    Recall('9-r2', 'Which callback may change the motor?', (
        wrong('the on-set callback', 'It judges a proposal, and the next judge may still reject it.'),
        right('the post-set callback', 'It runs when the value is stored.')),
           chapter='5.2', section='Acting on what is stored'),
)

PREDICTIONS = (
    Prediction('9-1', "In ROS 1 somebody has set the gain to `[1, 'two', 3.0]`. The robot calculates "
               "`2 * rospy.get_param('~gain')`. How many elements does the result have?", (
        right('6', 'Python doubles a list by repeating it. Nobody complains, and the mistake shows up somewhere else.'),
        wrong('3', 'Python doubles the list and not its elements: it repeats all three.'),
        wrong('0', 'Nothing fails. ROS 1 never checked the type, and Python repeats the list.')),
        otherwise='It has six: Python doubles a list by repeating it.'),
    Prediction('9-2', 'The node of ROS 2 declares `gains` with a dictionary as its default. What happens?', (
        wrong('It is stored as it is', 'None of the types of a parameter is a dictionary, so rclpy raises an '
              'exception.'),
        right('The node does not start', 'None of the types of a parameter is a dictionary, so rclpy raises an '
              'exception.'),
        wrong('It becomes two parameters', 'In a file a dictionary becomes two names. In `declare_parameter` rclpy '
              'raises an exception.'))),
    Prediction('9-3', 'The gripper starts with the file that ROS 1 loaded, unchanged. What happens?', (
        wrong('It starts with those values', 'rcl looks for a level `ros__parameters`, and finds a value before it.'),
        wrong('It starts with its defaults', 'The file is worse than useless: rcl finds a value before '
              '`ros__parameters`, and rejects the whole file.'),
        right('The start ends with an error', 'rcl rejects the whole file: there is a value before '
              '`ros__parameters`.'))),
    Prediction('9-4', 'The code says `kp = 1.0`, and the file `kp: 2`. With which `gains.kp` does the gripper start?', (
        right('with none, it fails', 'The default has made it a double, and declaring it with an integer raises an '
              'exception.'),
        wrong('with a kp of 2.0', 'ROS converts nothing. An integer is no double, and the declaration raises an '
              'exception.'),
        wrong('with a kp of 1.0', 'An override of the wrong type is not passed over: the declaration raises an '
              'exception.'))),
    Prediction('9-5', 'The arm declares `gains.kp`, `gains.kd`, `gains/kp` and `gains`. How many of them does '
               "`get_parameters_by_prefix('gains')` return?", (
        right('2', 'The group has the two with a dot after `gains`.'),
        wrong('3', 'A slash in the name of a parameter is accepted, and means nothing. So `gains/kp` is not in the '
              'group.'),
        wrong('4', 'A slash means nothing in the name of a parameter, and `gains` is a parameter beside the group.'),
        wrong('1', 'In the tree of ROS 1 a longer name destroys a shorter one. In ROS 2 all four exist side by side, '
              'and two have a dot after `gains`.')),
        otherwise='Two: the group has `gains.kp` and `gains.kd`.'),
    Prediction('9-6', 'In ROS 1 the robot sets its speed to 900, and is killed. A new robot of that name asks for '
               '`~max_speed_rpm`, with 100 as its default. What does it get?', (
        right('900', 'In ROS 1 the parameter server keeps the values, and they outlive the node.'),
        wrong('100', 'The node is new, but the value was never in the node. The parameter server keeps it.')),
        scale=Scale(0, 1000, 50, 'rpm'),
        otherwise='It gets 900. The value was never in the node. The parameter server keeps it, and hands it to the '
                  'next.'),
    Prediction('9-7', 'The gripper is set to 30.0 N, and then started again, without its file. With which force, in '
               'newtons, does it start?', (
        right('10.0', 'The value went with the node. Without the file, the default counts.'),
        wrong('30.0', 'There is no server that would have kept it. The value went with the node.'),
        wrong('12.5', 'A file counts at the start that names it, and at no other.')),
        scale=Scale(0, 40, 0.5, 'N'),
        otherwise='It starts with its default, 10.0. The value went with the node.'),
    Prediction('9-8', 'In ROS 1, `dynamic_reconfigure` has the limit 300 for the speed, which is 150. What is the '
               'speed after a request for 900?', (
        right('300', '`dynamic_reconfigure` moves a value to its limit. The caller has to compare to find out.'),
        wrong('150', 'ROS 2 does that: it rejects 900, with a reason. `dynamic_reconfigure` moves the value, and '
              'tells nobody why.'),
        wrong('900', 'The limits are not for the slider only. The server enforces them, in its own way: it moves the '
              'value to the limit.')),
        scale=Scale(0, 1000, 50, 'rpm'),
        otherwise='It is 300. `dynamic_reconfigure` moves a value to its limit, and tells nobody why.'),
)
