"""Predictions of chapter 7.1: what a file brings back."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'What you save is what you get back, and you know whom to distrust on the way.'

RECALLS = (
    Recall('7.1-r1', 'A double has an `integer_range` from 0 to 10. Somebody sets it to 50.0. What does the node '
           'do?', (
        wrong('It rejects the value', 'A range of the wrong kind is ignored. A double needs a '
              '`floating_point_range`.'),
        right('It accepts', 'A range of the wrong kind is ignored.'),
        wrong('It has never started: the descriptor is wrong', 'rclpy does not compare the kind of a range with '
              'the type. It ignores the range without a word.')),
           chapter='6.1', section='Change it: limits and steps'),
    Recall('7.1-r2', 'The parameter `label` is a string. What do you type after `ros2 param set /gripper label`, '
           'so that it becomes the text 42?', (
        wrong('42', 'YAML reads a number, and the node rejects it.'),
        wrong("'42'", 'The shell takes these quotes away, and YAML reads a number.'),
        right('"\'42\'"', 'The shell takes one pair of quotes away, and YAML the other.')),
           chapter='5.1', section='Break it: which type did you mean?'),
)

PREDICTIONS = (
    Prediction('7.1-1', 'The file holds all nine parameters of the robot, as it had them. How many of the nine does '
               '`ros2 param load` set on a fresh robot?', (
        right('7', 'Two are read-only, and the node rejects them even with the value that they have.'),
        wrong('9', 'Two are read-only. The node rejects them even with the value that they have.'),
        wrong('8', 'One less. Besides the serial number, `start_type_description_service` is read-only too.'),
        wrong('3', 'The command sets every line of the file, whether its value is new or not. Only the two read-only '
              'parameters are rejected.')),
        otherwise='It sets seven. The node rejects the two read-only ones, though they have that value already.'),
    Prediction('7.1-2', 'The file says `robot_name: 1e5`, without quotes. What becomes of a robot that starts with '
               'it?', (
        wrong('Its name is 1e5, as it was saved', 'That is what the writer meant. rcl reads the file by rules of its '
              'own, and `1e5` is a number for it.'),
        wrong('Its name is 100000.0', 'rcl does read that number. But the node declares a string, and nothing is '
              'converted.'),
        right('It does not start', 'rcl reads a double, the node declares a string, and the constructor ends in an '
              'exception.'))),
    Prediction('7.1-3', 'Four texts are written by `ros2 param dump`, and read by rcl at a start. Which comes back as '
               'something else?', (
        wrong('on', 'The command puts it in quotes, since its own rules take `on` for true. So it comes back.'),
        right('y', 'For the writer it is a plain text, so it gets no quotes. For rcl it means true.'),
        wrong('1.0', 'The command puts it in quotes, since it looks like a double. So it comes back.'),
        wrong('12:30', 'The command puts it in quotes, since it would be 750 without them. So it comes back.'))),
    Prediction('7.1-4', "The file says `version: '1.0'`, in quotes, and the node declares a string. What does "
               '`ros2 param load` do with that line?', (
        wrong("It sets the string '1.0'", 'The quotes are gone after the first reading. `load` guesses the type once '
              'more, and gets a double.'),
        right('It tries to set a double, and the node rejects that', '`load` reads the file, turns each value into '
              "text, and guesses again. Quotes don't survive that."))),
    Prediction('7.1-5', "The file says `waypoints: []`, and the default is ['dock']. What does the node get when it "
               'reads `waypoints`?', (
        wrong('[]', 'An empty array in a file has no type, so it is no value either.'),
        wrong("['dock']", 'The file does take the default away. It gives nothing in its place.'),
        right('an exception: there is no value', 'The empty array takes the default away and gives nothing '
              'instead.'))),
    Prediction('7.1-6', 'A node has a name, a speed, and a calibration that is declared and was never set. What does '
               '`ros2 param dump` save?', (
        wrong('name and speed', 'A node answers a request for many values with nothing at all if one of them has no '
              'value.'),
        wrong('all three, the last as null', 'There is no null in a parameter file. The node answers with nothing at '
              'all, because of the one.'),
        right('nothing', 'A node answers a request for many values with nothing at all if one of them is unset. The '
              'exit status is 0.'))),
)
