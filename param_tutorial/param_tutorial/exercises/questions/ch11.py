"""Predictions of chapter 11: the course once more, on a cart."""

from param_tutorial.exercises.prediction import Prediction, Recall, right, wrong

SOLVED = 'The cart is yours: declared, judged, saved, launched and tuned. The wall stands.'

RECALLS = (
    Recall('11-r1', 'A tuned gain was set on a running ROS 2 node, and saved nowhere. The node is started again. Which '
           'value does the gain have?', (
        wrong('the tuned value', 'In ROS 1 a server kept it. In ROS 2 the values live in the node and go with it.'),
        right('its start value', 'The values live in the node and go with it.')),
           chapter='9', section='Where a value lives'),
    Recall('11-r2', '`get_parameters` is asked for three names, and one of them does not exist. What comes back?', (
        wrong('two of the three', 'Values come without names, so the gap would not show. rclpy sends none at all.'),
        right('none of the three', 'One unknown name empties the whole answer.'),
        wrong('three, one of them unset', 'That is what the comment in the interface promises, and not what rclpy '
              'does.')),
           chapter='10.2', section='A name too many'),
)

PREDICTIONS = (
    Prediction('11-1', 'The cart drives at 1.0 m/s with 0.5 m/s². One call of `set_parameters` asks for 2.0 m/s and '
               '1.0 m/s², which are valid together. What becomes of them?', (
        wrong('Both of them are accepted', 'The cart decides one by one, and the speed meets the old acceleration: it '
              'needs 4 m to stop.'),
        wrong('Both of them are rejected', 'The cart decides one by one, and the acceleration alone breaks no rule.'),
        right('Only the speed is rejected', 'The cart judges the speed first, with the old acceleration. Half of the '
              'request comes true.'))),
    Prediction('11-2', 'The file was dumped from `/cart_node` and says 1.5 m/s. The default is 1.0. Another cart, '
               '`/second_cart`, starts with the file. How fast is it, in m/s?', (
        right('1.0', 'The key in the file is `/cart_node`. For this cart the file holds nothing.'),
        wrong('1.5', 'The key in the file is `/cart_node`, and this cart is another node.')),
        otherwise='1.0. The key in the file is `/cart_node`, so the file holds nothing for this cart. That is not an '
                  'error, and rcl passes over it in silence.'),
    Prediction('11-3', 'The file is for every node now, and says CART-01. The second cart gets `-p cart_id:=CART-02` '
               'before it. `cart_id` is read-only. What is its number?', (
        right('CART-01 from the file', 'Both are in the block `/**`, where the later value wins, and a read-only '
              'parameter takes it like any other.'),
        wrong('CART-02 from the option', 'Both are in the block `/**`, and within a block the later value wins. That '
              'is the one of the file.'),
        wrong('none, it does not start', 'Nothing is set twice here. The declaration takes the later of the two start '
              'values, and from then on the parameter is read-only.'))),
    Prediction('11-4', 'The file says 0.4 m/s² for `/**/cart_node`, and `-p` comes after it and says 0.8, for no node '
               'in particular. Which acceleration does the cart have, in m/s²?', (
        right('0.8', 'Here the last word counts: `-p` opens the block `/**` after the block of the file, and the block '
              'that was opened later wins.'),
        wrong('0.4', 'How exactly a file names the node does not matter. `-p` opens the block `/**` after the block of '
              'the file, and the later block wins.'),
        wrong('0.5', "That is the default. Overrides don't cancel each other. One of them wins.")),
        otherwise='0.8. `-p` opens the block `/**` after the block of the file, and the block that was opened later '
                  'wins.'),
)
