"""Predictions of chapter 7.3: which start values reach a node, and which of several wins."""

from param_tutorial.exercises.prediction import Prediction, Recall, Scale, right, wrong

SOLVED = 'You can say with which values a node starts, and find out why it started with others.'

RECALLS = (
    Recall('7.3-r1', 'Your driver declares `max_speed_mps` with the default 0.5. Which of the two values `1` and `1.0` '
           'does it accept?', (
        wrong('both of them', 'ROS does not convert, not even a whole number to a double. Without the dot, it is an '
              'integer.'),
        right('only the second', 'The default has made it a double, and without the dot, `1` is an integer. ROS does '
              'not convert.'),
        wrong('only the first', 'That one is an integer. The default has made the parameter a double, and ROS does not '
              'convert.')),
           chapter='3', section='One default, one type'),
    Recall('7.3-r2', 'A node declares the string `mode`. You type `%ros2 param set /gripper mode off`. What does the '
           'node hold then?', (
        wrong('the string off', 'In YAML 1.1, `off` without quotes is false, and a node rejects a boolean for a '
              'string.'),
        wrong('the value false', 'The command sends a boolean, and the node rejects it, because it has declared a '
              'string.'),
        right('what it held before', 'In YAML 1.1, `off` is false. The node has declared a string, and rejects a '
              'boolean. It reads a file by similar rules.')),
           chapter='5.1', section='Which type did you mean?'),
)

PREDICTIONS = (
    Prediction('7.3-1', 'The file is for `/driver` and says 0.8 m/s, and the default is 0.5. Your driver starts with '
               'the file, in the namespace `/left`. What is its `max_speed_mps`?', (
        right('0.5', 'The node is called `/left/driver` now. The file is for `/driver`, and nothing tells you.'),
        wrong('0.8', 'A file names a node by its full name, and that is `/left/driver` now.')),
        scale=Scale(0, 1, 0.1, 'm/s'),
        otherwise='0.5, the default. The node is called `/left/driver` now, and the file is for `/driver`.'),
    Prediction('7.3-2', 'How many of the four nodes `/driver`, `/left/driver`, `/hall/left/driver` and `/lifter` does '
               'the key `/*/driver` reach?', (
        right('1', 'One star is exactly one name: it reaches `/left/driver`, and no other.'),
        wrong('3', 'That would be `/**/driver`. One star is exactly one name, so it reaches `/left/driver` only.'),
        wrong('2', 'One star is exactly one name, neither none nor two: it reaches `/left/driver` only.'),
        wrong('4', 'The last part of the key is `driver`, and the lifter is called otherwise.')),
        otherwise='One. A star is exactly one name, so the key reaches `/left/driver` only.'),
    Prediction('7.3-3', 'Two sources name the same parameter. Which of them wins?', (
        right('The one that is given later', 'With two sources like these it wins every time. Keep an eye on three.'),
        wrong('The one with the exact name', 'It wins only if it comes later. Otherwise the file for every node beats '
              'it.'),
        wrong('The one from the option -p', 'It wins only if it comes later. If a file comes after `-p`, the node has '
              'the value in the file.'))),
    Prediction('7.3-4', 'Now all three sources, in all six orders. In how many of the six lines does the last one '
               'win?', (
        right('4', 'In the third line `-p` comes last and loses, and in the fifth `fleet.yaml` does.'),
        wrong('6', 'That was so with two sources. With three, `-p` comes last and loses in the third line, and '
              '`fleet.yaml` in the fifth.'),
        wrong('2', 'More: in four lines. The last one loses only where a source for every node follows the file for '
              'this node, and another one for every node precedes both.')),
        otherwise='In four. `-p` comes last and loses in the third line, and `fleet.yaml` in the fifth.'),
    Prediction('7.3-5', 'In one file, a block `/driver` with 0.6 comes first, and a block `/**` with 0.7 comes last. '
               'With which speed does your driver start?', (
        right('0.7', 'The general block comes later, so it wins over the one that was written for this driver.'),
        wrong('0.6', 'The more specific name does not win. The general block was opened later.'),
        wrong('0.5', 'Two blocks in one file are no contradiction. Both match, and the later one wins.')),
        scale=Scale(0, 1, 0.1, 'm/s'),
        otherwise='0.7. Both blocks match, and the one that was opened later wins.'),
    Prediction('7.3-6', 'The list is a dictionary with a stop distance, the file for `/driver` with 0.6, and a '
               'dictionary with 0.8. With which speed does the driver start?', (
        wrong('0.8', 'The first dictionary has opened the block `/**`. The last one goes into the same block, and the '
              "file's block comes after it."),
        right('0.6', "Both dictionaries are one block, `/**`, which the first one opened. The file's block comes after "
              'it.'),
        wrong('0.5', 'The file does reach the driver: its key is the name of the node.')),
        scale=Scale(0, 1, 0.1, 'm/s'),
        otherwise='0.6. Both dictionaries are one block, which the first one opened, so the block of the file wins.'),
    Prediction('7.3-7', 'A file says `max_sped_mps: 0.8`, with a typo. Your driver starts with it. What do you see?', (
        wrong('an error that names it', 'An override waits until its parameter is declared. If that never happens, '
              'nothing happens.'),
        right('no message about it', 'An override waits until its parameter is declared. If that never happens, '
              'nothing tells you.'),
        wrong('a warning that names it', 'There is no warning. The node keeps the override aside without a word.'))),
    Prediction('7.3-8', 'A file has three mistakes: a typo in the name of a parameter, a value out of its range, and a '
               'block for a misspelled node. How many of them does the driver report when it starts with the file?', (
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
