"""Predictions of chapter 8: what goes wrong where nobody looks."""

from param_tutorial.exercises.prediction import Prediction, Recall, Scale, right, wrong

SOLVED = 'Your package says by itself when something is wrong with it.'

RECALLS = (
    Recall('8-r1', 'An on-set callback accepts a speed and starts the motor with it. Then a second on-set callback '
           'rejects the speed. Which has the new speed in the end, the motor or the parameter?', (
        right('only the motor has it', 'The first callback acted on a proposal, and the proposal failed.'),
        wrong('both of them have it', 'A value is stored only if all callbacks accept it.'),
        wrong('neither of them has it', 'Nothing takes back what the first callback did. The motor already runs with '
              'the proposal.')),
           chapter='5.2', section='Acting too early'),
    Recall('8-r2', 'The rule is `max_speed_mps ** 2 / 2 <= stop_distance_m`. The node holds 0.5 and 0.5, and someone '
           'starts it with `-p max_speed_mps:=2.0`. Its judge is registered after the declarations. With which speed '
           'does it start, if nothing else looks?', (
        right('2.0', 'A callback judges requests. The override counted when the parameter was declared.'),
        wrong('0.5', 'An override is not undone. It counted when the parameter was declared, before there was a '
              'judge.')),
           otherwise='2.0. The override counted when the parameter was declared, before there was a judge.',
           chapter='5.2', section='Who judges the start?'),
)

PREDICTIONS = (
    Prediction('8-1', '`night.yaml` says `max_sped_mps: 0.3`, and the default is 0.5. The driver starts with the file. '
               'What is its `max_speed_mps`?', (
        right('0.5', 'The node declares no `max_sped_mps`, so that override waits forever, and nobody hears of it.'),
        wrong('0.3', 'The two names differ by a letter. The node ignores an override whose name it does not '
              'declare.')),
        scale=Scale(0, 1, 0.1, 'm/s'),
        otherwise='It is 0.5, the default: the node ignores an override whose name it does not declare.'),
    Prediction('8-2', 'The node holds 0.5 m/s and 0.5 m. One atomic request sets 2.0 m/s and 2.5 m. With how many '
               'meters to stop does `drive` see 2.0 m/s?', (
        right('0.5', '`act` had written the speed and not yet the distance. The request was atomic; reading what came '
              'of it was not.'),
        wrong('2.5', 'The parameters change together, and the two attributes one after the other. `drive` ran in '
              'between.')),
        otherwise='It is 0.5 m: `act` had written the speed and not yet the distance.'),
    Prediction('8-3', 'One atomic request asks for 2.0 m/s and 0.6 m. `Early` takes the speed, and then rejects the '
               'distance. What is `limits.max_speed_mps` afterwards?', (
        right('2.0', '`Early` had already put the speed to use, and nothing takes back what it did.'),
        wrong('0.5', 'The parameter is still 0.5. The object was replaced before the distance was judged, and nobody '
              'puts the old one back.')),
        scale=Scale(0, 2.5, 0.1, 'm/s'),
        otherwise='It is 2.0: `Early` put the speed to use before it judged the distance.'),
    Prediction('8-4', 'Someone raises `braking_mps2` to 3.0, and then `max_speed_mps` to 1.7. The brakes of the base '
               'can do 1.0. How far from the wall does the robot stop?', (
        right('0', 'It drives into the wall: the judge calculated with brakes that the base does not have.'),
        wrong('0.5', 'There it starts to brake. With its real brakes it needs 1.44 m.'),
        wrong('0.3', 'With brakes of 3.0 it would need half a meter. The base has brakes of 1.0, and needs 1.44 m.')),
        scale=Scale(0, 10, 0.1, 'm', tolerance=0.1, is_track=True),
        otherwise='It drives into the wall: the base needs 1.44 m, and half a meter is left.'),
    Prediction('8-5', 'The driver starts in the namespace `/left`, and publishes on the relative name `cmd_vel`. Which '
               'parameter holds the depth?', (
        wrong('qos_overrides./cmd_vel.publisher.depth', 'rclpy takes the full name of the topic, and in this namespace '
              'that is `/left/cmd_vel`.'),
        right('qos_overrides./left/cmd_vel.publisher.depth', 'rclpy takes the full name of the topic.'),
        wrong('left.qos_overrides./cmd_vel.publisher.depth', 'The names of parameters do not get the namespace of '
              'their node. The full name of the topic stands in this one.'))),
    Prediction('8-6', 'The server is configured. Someone sets `follow.max_speed_mps` to 0.3, and it is configured '
               'again. What does the second call do?', (
        wrong('It sets it back to 0.5', 'A declaration is no request: a name that is there already can’t be declared.'),
        wrong('It leaves it at 0.3', 'It gets no further than the first name: that is there already, and can’t be '
              'declared again.'),
        right('It raises an exception', 'The first name is declared already, and rclpy declares none twice.'))),
)
