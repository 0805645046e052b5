"""Predictions of chapter 7.3: which of several values wins."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'You predict the winner in any order, which few people who write launch files can.'

RECALLS = (
    Recall('7.3-r1', 'A parameter file begins with `/simple_param_node:`. A launch file gives it to a node named '
           '`berta`. What happens?', (
        right('berta starts with its defaults', 'The file is for another node, and a node ignores values for another '
              'node without a word.'),
        wrong("berta starts with the file's values", 'The key at the top of the file names the node that it is for, '
              'and that is not `berta`.'),
        wrong('The launch ends with an error', 'rcl can read the file, so there is no error. The file is for another '
              'node, and berta ignores it.')),
           chapter='7.2', section='The command line that a launch types'),
    Recall('7.3-r2', 'A node declares the string `serial_number`. Its parameter file says `serial_number: 0042`, '
           'without quotes. What happens at the start?', (
        right('It does not start at all', 'rcl reads a number, and the declaration of a string rejects it.'),
        wrong('It has the string 0042', 'To rcl, `0042` without quotes is a number, whatever the node declares.'),
        wrong('It has the string 42', 'rcl reads a number, and ROS does not convert a number to a string.')),
           chapter='7.1', section='Load it back'),
)

PREDICTIONS = (
    Prediction('7.3-1', 'Two sources name the same parameter. Which of them wins?', (
        right('The one that is given later', 'With two sources like these it wins every time. Keep an eye on three.'),
        wrong('The one with the exact name', 'It wins only if it comes later. Otherwise the file for every node beats '
              'it.'),
        wrong('The one from the option -p', 'It wins only if it comes later. If a file comes after `-p 400`, the node '
              'has the value in the file.'))),
    Prediction('7.3-2', 'Now all three sources, in all six orders. In how many of the six lines does the last one '
               'win?', (
        right('4', 'In the third line `-p` comes last and loses, and in the fifth `all.yaml` does.'),
        wrong('6', 'That was so with two sources. With three, `-p` comes last and loses in the third line, and '
              '`all.yaml` in the fifth.'),
        wrong('2', 'More: in four lines. The last one loses only where a source for every node follows the file for '
              'this node, and another one for every node precedes both.')),
        otherwise='In four. `-p` comes last and loses in the third line, and `all.yaml` in the fifth.'),
    Prediction('7.3-3', "`parameters=[{'robot_name': 'Berta'}, config, {'max_speed_rpm': 200, …}]`: the file is for "
               '`/simple_param_node` and says 180 rpm, and the default is 100. What is the speed?', (
        wrong('200', 'The first dictionary has opened the block `/**`. The last one goes into the same block, and the '
              "file's block comes after it."),
        right('180', "Both dictionaries are one block, `/**`, which the first one opened. The file's block comes after "
              'it.'),
        wrong('100', 'The file does reach the robot: its name and the key in the file are the same.')),
        otherwise='180. Both dictionaries are one block, which the first one opened, so the block of the file wins.'),
    Prediction('7.3-4', 'One file: first a block `/**` with 300, and below it a block `/robot` with 200. With which '
               'speed does the robot start?', (
        right('200', 'What looks natural is right here: the block for this robot comes later in the file. So write the '
              'general block first.'),
        wrong('300', 'The first block was opened first, and that is why it loses: among the blocks, the one that was '
              'opened later wins.'),
        wrong('100', 'Two blocks in one file are no contradiction. rcl keeps them apart, and the later one wins.')),
        otherwise='200. The block for this robot comes later in the file, and the later block wins.'),
    Prediction('7.3-5', 'The key in `robot.yaml` is `/robot`, and it gives the speed 200. The robot starts in the '
               'namespace `/lab`. What is its speed?', (
        wrong('200, as the file says', 'A file names a node by its fully qualified name, and that is `/lab/robot` '
              'now.'),
        right('100, as the code says', 'The fully qualified name is `/lab/robot`, the file is for `/robot`, and '
              'nothing tells you.'),
        wrong('none, it fails to start', 'A file that reaches no node is not an error. The robot starts with its '
              'default.'))),
    Prediction('7.3-6', 'A file says `sped: 200`, a typo, and `turbo: true`, which the node no longer declares. What '
               'do you see at the start?', (
        wrong('an error that names them', 'An override waits until its parameter is declared. If that never happens, '
              'nothing happens.'),
        right('neither error nor warning', 'An override waits until its parameter is declared. If that never happens, '
              'nothing tells you.'),
        wrong('a warning that names them', 'There is no warning. The node keeps the overrides aside without a word.'))),
    Prediction('7.3-7', 'The file still says `sped: 200`. The first option is `allow_undeclared_parameters`, the '
               'second `automatically_declare_parameters_from_overrides`. Which of the two turns it into a '
               'parameter?', (
        wrong('only the first', 'It lets others *set* what was not declared. For overrides it does nothing.'),
        wrong('neither of them', 'The second one declares every override that reaches the node, with a type and '
              'nothing else.'),
        wrong('both of them', 'The first one only lets others *set* what was not declared. For overrides it does '
              'nothing.'),
        right('only the second', 'Its name says so: this option declares every override that reaches the node, with a '
              'type and nothing else.'))),
    Prediction('7.3-8', 'A file has three mistakes: a typo in the name of a parameter, a value out of its range, and a '
               'block for a misspelled node. How many of them does the robot report when it starts with the file?', (
        right('1', 'The value out of range, because the declaration fails. The node ignores the other two without a '
              'word.'),
        wrong('3', 'A node checks values. It knows nothing of names that it has not declared, nor of blocks for '
              'others.'),
        wrong('2', 'A typo in a name is no error to a node: the override waits for a declaration. And the block is for '
              'another node, as far as rcl can tell.'),
        wrong('0', 'The declaration checks an override against the range, and the node does not start.')),
        otherwise='One: the value out of range, because the declaration fails. The node ignores the other two without '
                  'a word.'),
)
