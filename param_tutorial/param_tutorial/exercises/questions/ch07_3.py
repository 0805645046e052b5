"""Predictions of chapter 7.3: which of several values wins."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'You predict the winner in any order, which few who write launch files can say.'

RECALLS = (
    Recall('7.3-r1', 'A parameter file begins with `/simple_param_node:`. A launch file gives it to a node named '
           '`berta`. What happens?', (
        right('berta starts with its defaults, and nobody says a word', 'The file is for another node, and what '
              'is for somebody else is passed over in silence.'),
        wrong('berta starts with the values of the file', 'The first line of the file names the node that it is '
              'for, and that is not `berta`.'),
        wrong('The launch ends with an error', 'The file can be read, so there is no error. It is for somebody '
              'else, and is passed over in silence.')),
           chapter='7.2', section='Break it: a file for another node'),
    Recall('7.3-r2', 'A node declares the string `serial_number`. In its parameter file stands `serial_number: '
           '0042`, without quotes. How does the node start?', (
        wrong("with the string '0042'", 'To rcl `0042` without quotes is a number, whatever the node has '
              'declared.'),
        wrong("with the string '42'", 'rcl reads a number, and ROS never converts a number to a string.'),
        right('not at all', 'rcl reads a number, and the declaration of a string rejects it.')),
           chapter='7.1', section='Load it back'),
)

PREDICTIONS = (
    Prediction('7.3-1', 'Two sources name the same parameter. Which of them wins?', (
        wrong('The one that names the node exactly', 'It wins only if it comes later. The file for every node beats it '
              'otherwise.'),
        wrong('The one on the command line, -p', 'It wins only if it comes later. `-p 400` and then a file gives the '
              'value of the file.'),
        right('The one that comes later', 'With two sources it is so each time. Keep an eye on three.'))),
    Prediction('7.3-2', 'Now all three sources, in all six orders. In how many of the six lines does the last one '
               'win?', (
        right('4', 'In the third line `-p` comes last and loses, and in the fifth `all.yaml` does.'),
        wrong('6', 'With two sources it was so. With three, `-p` comes last and loses in the third line, and '
              '`all.yaml` in the fifth.'),
        wrong('2', 'It is better than that: four lines. Only where a source for every node follows the file for this '
              'node, after another of its kind, does the last one lose.')),
        otherwise='In four. `-p` comes last and loses in the third line, and `all.yaml` in the fifth.'),
    Prediction('7.3-3', 'The first line of `robot.yaml` is `/robot`, and it gives the speed 200. The robot starts in '
               'the namespace `/lab`. What is its speed?', (
        wrong('200: its name is still robot', 'A file names a node by its full name, and that is `/lab/robot` now.'),
        right('100', 'The full name is `/lab/robot`, the file is for `/robot`, and nobody says a word.'),
        wrong('There is none: no node takes the file, so the start fails', 'A file that reaches nobody is no error. '
              'The robot starts with its default.'))),
    Prediction('7.3-4', 'A file says `sped: 200`, a typo, and `turbo: true`, which the node no longer declares. What '
               'does the start say?', (
        wrong('an error: there are no such parameters', 'An override waits for a declaration of its name. If none '
              'comes, nothing happens.'),
        wrong('a warning with both names', 'There is no warning. An override that nobody declares is put aside in '
              'silence.'),
        right('nothing', 'An override waits for a declaration of its name. If none comes, nobody says a word.'))),
    Prediction('7.3-5', 'The file still says `sped: 200`. Which of the two options makes a parameter of it?', (
        wrong('allow_undeclared_parameters', 'It lets others *set* what was not declared. For overrides it does '
              'nothing.'),
        right('automatically_declare_parameters_from_overrides', 'It declares whatever overrides there are, with a '
              'type and no more.'),
        wrong('both', 'The first only lets others *set* what was not declared. For overrides it does nothing.'),
        wrong('neither', 'The second declares whatever overrides there are, with a type and no more.'))),
)
