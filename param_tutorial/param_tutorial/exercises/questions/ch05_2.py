"""Predictions of chapter 5.2: who judges, who acts, and when."""

from param_tutorial.exercises.prediction import Prediction, Recall, Scale, right, wrong

SOLVED = 'Your robot judges first and acts later, and takes no speed from which it cannot stop.'

RECALLS = (
    Recall('5.2-r1', 'A script runs `ros2 param set`, and the node rejects the value. What is the exit status of the '
           'command?', (
        wrong('1', 'The command prints the rejection and ends with 0 all the same. A script has to read what it '
              'prints.'),
        right('0', 'The command prints the rejection and ends with 0 all the same. A script has to read what it '
              'prints.')),
           chapter='5.1', section='Rejections and typos'),
    Recall('5.2-r2', "A node keeps `speed = self.get_parameter('max_speed_rpm')`. Later someone changes the "
           'parameter. What is `speed.value`?', (
        right('the old value', 'The object keeps the value that it had when the node took it.'),
        wrong('the new value', 'The object is not connected with the node. Ask again with `get_parameter`.')),
           chapter='4', section='An object and its value'),
)

PREDICTIONS = (
    Prediction('5.2-1', 'The winch holds 100 kg and 60 rpm. Three requests come: 400 kg; then 400 kg and 20 rpm '
               'together; then 30 rpm. How many of them does it accept?', (
        right('1', 'Only the second: 400 times 20 is 8000. The first is judged with the stored 60 rpm, and the third '
              'with the stored 400 kg.'),
        wrong('2', 'The third is judged with the 400 kg that the second has stored: 400 times 30 is 12,000. Only the '
              'second is accepted.'),
        wrong('3', 'The first is judged with the stored 60 rpm: 400 times 60 is 24,000. Only the second is '
              'accepted.'),
        wrong('0', 'The second sets both values at once, and 400 times 20 is 8000. The node accepts it.')),
        otherwise='The node accepts one of them, the second.'),
    Prediction('5.2-2', 'The requests are `max_speed_mps 2.0`, `stop_distance_m 2.5`, `max_speed_mps 2.0` and '
               '`stop_distance_m 0.5`. Which of them does the driver reject?', (
        wrong('the first, no other', 'The last would leave 2.0 m/s with half a meter, as the first would.'),
        wrong('the first and the third', 'When the third comes, 2.5 m are stored, and 2.0 m are enough. The last one '
              'is rejected.'),
        right('the first and the last', 'Each would leave 2.0 m/s with half a meter. When the third comes, 2.5 m are '
              'stored.'),
        wrong('the third and the last', 'The first meets the stored 0.5 m and is rejected. The third meets 2.5 m.'))),
    Prediction('5.2-3', 'The winch registers its judge after the declarations. It starts with `-p load_kg:=400`, '
               'and 400 times 60 breaks the rule. What is `load_kg`?', (
        right('400', 'The override counts when the parameter is declared, and the judge is registered after that.'),
        wrong('100', 'The override took the place of the default when the parameter was declared, and nobody objected: '
              'the judge is registered after that.')),
        otherwise='It is 400: the override counts when the parameter is declared, and the judge is registered later.'),
    Prediction('5.2-4', 'The speed is 100, and someone sets -20. rclpy asks `drive` first, and then `judge`, which '
               'rejects. What is `motor_rpm` after that?', (
        right('-20', 'The motor obeyed a proposal, and the proposal failed. Nothing takes back what `drive` did.'),
        wrong('100', 'The parameter still holds 100, and the motor does not: `drive` was asked first, and acted.'),
        wrong('0', '`drive` has set it to -20, before `judge` rejected the value.')),
        scale=Scale(-40, 160, 10, 'rpm'),
        otherwise='It is -20: `drive` was asked first, and acted on a proposal that failed.'),
    Prediction('5.2-5', '`drive` is a post-set callback now. Someone sets 120, and then -20. What is `motor_rpm` in '
               'the end?', (
        right('120', 'rclpy called it for 120, which was stored, and not for -20, which was rejected.'),
        wrong('-20', 'rclpy calls a post-set callback only when a value is stored, and -20 never was.'),
        wrong('100', 'rclpy called it for 120, once that was stored.')),
        scale=Scale(-40, 160, 10, 'rpm'),
        otherwise='It is 120: rclpy calls a post-set callback for what was stored, and for nothing else.'),
    Prediction('5.2-6', '`watch` returns nothing, and 50 rpm are fine for the winch. What does the node do with the '
               'request?', (
        wrong('It accepts it', 'An on-set callback without a result counts as a rejection. That keeps the node out of '
              'states that nobody has judged.'),
        right('It rejects it', 'An on-set callback has to return a result, and no result counts as a rejection.'),
        wrong('It never answers', 'Older versions of rclpy raise an exception there. Yours answers with a '
              'rejection.'))),
)
