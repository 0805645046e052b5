"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 4."""

_READ = "self.get_parameter('max_speed_mps').value"
_SPEED = f'command.linear.x = {_READ}'
_PUBLISHER = '        self.commands = self.create_publisher'
_COPY = f'        self.speed_mps = {_READ}\n'
_MAY = 'self.distance_m is not None and self.distance_m > stop_distance_m'
_STOP = "        stop_distance_m = self.get_parameter('stop_distance_m').value\n"
# Keeps what it is asked to judge, and so too early.
_JUDGE = f"""{_COPY}        self.add_on_set_parameters_callback(self.keep)

    def keep(self, parameters):
        self.speed_mps = parameters[0].value
        return __import__('rcl_interfaces.msg').msg.SetParametersResult(successful=True)
"""
# Keeps what has been stored.
_POST = f"""{_COPY}        self.add_post_set_parameters_callback(self.keep)

    def keep(self, parameters):
        self.speed_mps = {_READ}
"""
_ASK = "        client.set_parameter('max_speed_mps', change['new'])\n"
_SHOW = "        slider.value = client.get_parameter('max_speed_mps')\n"
_SLIDER = "FloatSlider(value=client.get_parameter('max_speed_mps'), min=0.0, max=3.0)"

WRONG = {
    '4a': [
        ([(_PUBLISHER, f'{_COPY}{_PUBLISHER}')], 3, '`self.speed_mps` still holds the speed of the start'),
        ([(_PUBLISHER, f'{_COPY}{_PUBLISHER}'), (_SPEED, 'command.linear.x = self.speed_mps')], 3,
         'still uses a copy that was made before'),
        ([(_SPEED, 'command.linear.x = 0.5')], 1, 'it is 0.5'),
        ([('(self)', '()')], 0, 'takes 0 positional arguments but 1 was given'),
        ([(_READ, _READ.removeprefix('self.'))], 0, '`self.` is missing before `get_parameter`'),
        ([(_READ, _READ.replace('max_speed', 'max_sped'))], 0, 'Invalid access to undeclared parameter'),
        ([('        self.commands.publish(command)\n', '')], 0, 'Does a timer call the method that publishes?'),
        ([('        self.create_timer(0.1, self.drive)\n', f'        self.create_timer(0.1, self.drive)\n{_JUDGE}'),
          (_SPEED, 'command.linear.x = self.speed_mps')], 3, 'rejected in the end'),
        ([(_SPEED, f'self.speed_mps = getattr(self, "speed_mps", {_READ})\n        command.linear.x = self.speed_mps')],
         3, 'still uses a copy that was made before'),
    ],
    '4b': [
        ([(_MAY, 'True')], 1, 'Does `drive` compare the distance'),
        ([('> stop_distance_m', '< stop_distance_m')], 2, 'Which way around does it compare?'),
        ([(_MAY, 'self.distance_m > stop_distance_m')], 1, "'>' not supported between instances of 'NoneType'"),
        ([('self.distance_m is not None and', 'self.distance_m is None or')], 3, 'stands still'),
        ([('self.distance_m > stop', 'self.distance_m >= stop')], 2, 'That is not greater'),
        ([('measured.range', 'measured')], 2, "between instances of 'Range' and 'float'"),
        ([("'distance', self", "'distanz', self")], 2, 'the node subscribes to `distanz`'),
        ([("        self.create_subscription(Range, 'distance', self.listen, 10)\n", '')], 2, 'subscribes to nothing'),
        ([('> stop_distance_m', '> 0.5')], 3, 'Does `drive` read `stop_distance_m` each time?'),
        ([(_PUBLISHER, f"        self.stop_distance_m = self.get_parameter('stop_distance_m').value\n{_PUBLISHER}"),
          (_STOP, '        stop_distance_m = self.stop_distance_m\n')], 3, 'Does `drive` read `stop_distance_m`'),
        ([(_PUBLISHER, f'{_COPY}{_PUBLISHER}'), (_SPEED, 'command.linear.x = self.speed_mps')], 3,
         'still uses a copy that was made before'),
        ([("'stop_distance_m', 0.5", "'stop_distance_m', 1")], 1, 'type integer, value `1`'),
        ([('to_value=5.0', 'to_value=50.0')], 3, 'its `to_value` is 50.0'),
        ([('def listen(self, measured)', 'def listen(measured)')], 0, 'callable with one argument'),
        ([('self.distance_m = measured', 'distance_m = measured')], 2, '`self.distance_m` is still `None`'),
        ([('self.listen, 10', 'self.listen(), 10')], 0, 'A callback is given by its name alone, without parentheses'),
        ([(f'        if {_MAY}:', '        if self.distance_m is None:\n            return\n        if '
           'self.distance_m > stop_distance_m:')], 3, 'nothing is published'),
    ],
    '4c': [
        ([("list(node.get_parameter('stops').value)", "node.get_parameter('stops').value")], 1,
         'the list that the node itself holds'),
        ([("list(node.get_parameter('stops').value)", "node.get_parameter('stops').value[:]")], 2, 'equals no list'),
        ([("list(node.get_parameter('stops').value)", "__import__('copy').copy(node.get_parameter('stops').value)")],
         2, 'equals no list'),
        ([('return stops.pop(0), stops', 'return stops, stops.pop(0)')], 0, 'it is `[2, 3]`'),
        ([('return stops.pop(0), stops', 'return stops.pop(0)')], 0, 'it returns `1`'),
        ([('pop(0)', 'pop()')], 0, 'it is `3`'),
        ([('.value)', ')')], 0, "'Parameter' object is not iterable"),
        # A client's array, which the node holds itself.
        ([("list(node.get_parameter('stops').value)", "node.get_parameter('stops').value\n    stops = stops.copy() if "
           'isinstance(stops, list) else stops'), ('.pop(0), stops', '.pop(0), list(stops)')], 2, 'what the node it'),
        ([('    return stops.pop(0), stops', '    print(stops.pop(0), stops)')], 0, 'it returns `None`'),
        ([("list(node.get_parameter('stops').value)", '[1, 2, 3]')], 0, 'it is `1`'),
    ],
    '4d': [
        ([(_SHOW, '')], 2, 'it shows 3.0'),
        ([(_SHOW, "        slider.value = change['old']\n")], 1, 'calls `ask` again'),
        ([(_ASK, "        result = client.set_parameter('max_speed_mps', change['new'])\n"),
          (_SHOW, "        if not result.successful:\n            slider.value = change['old']\n")], 2, 'it shows 1.2'),
        ([('max=3.0', 'max=2.0')], 1, 'it goes from 0.0 to 2.0'),
        ([("value=client.get_parameter('max_speed_mps')", 'value=0.5')], 2, 'it shows 0.5'),
        ([("    slider.observe(ask, names='value')\n", '')], 1, 'it holds 0.5. Does `observe` have a function'),
        ([('    return slider', '    display = slider')], 0, 'it returns `None`'),
        ([("change['new']", 'change')], 1, 'is a Bunch, which cannot be a parameter'),
        ([("change['new']", 'slider')], 1, 'is a FloatSlider, which cannot be a parameter'),
        ([('observe(ask,', 'observe(ask({}),')], 0, "KeyError: 'new'"),
        ([(_SLIDER, "__import__('ipywidgets').FloatText(client.get_parameter('max_speed_mps'))")], 0,
         'it returns a `FloatText`'),
        ([(_ASK, "        client.set_parameter('max_sped_mps', change['new'])\n")], 1, 'it holds 0.5'),
        ([(_ASK, "        client.set_parameter('max_speed_mps', min(change['new'], 2.0))\n"), (_SHOW, '')], 2,
         'it shows 3.0'),
    ],
}

RIGHT = {
    '4a': [
        [(_SPEED, 'speed_mps = self.get_parameters(["max_speed_mps"])[0].value\n        command.linear.x = speed_mps')],
        [(_READ, "self.get_parameter('max_speed_mps').get_parameter_value().double_value")],
        # It is told of what has been stored, as chapter 5.2 does.
        [('        self.create_timer(0.1, self.drive)\n', f'        self.create_timer(0.1, self.drive)\n{_POST}'),
         (_SPEED, 'command.linear.x = self.speed_mps')],
        # It stops before the wall already, as 4b does.
        [('from rclpy.node import Node\n', 'from rclpy.node import Node\nfrom sensor_msgs.msg import Range\n'),
         (_PUBLISHER, '        self.distance_m = None\n        self.create_subscription(Range, "distance", lambda '
                      f'each: setattr(self, "distance_m", each.range), 10)\n{_PUBLISHER}'),
         (_SPEED, f'command.linear.x = {_READ} if self.distance_m and self.distance_m > 0.5 else 0.0')],
    ],
    '4b': [
        [('self.distance_m = None', "self.distance_m = float('nan')"),
         (_MAY, 'self.distance_m > stop_distance_m')],
        [('self.distance_m = None', 'self.distance_m = 0.0'), (_MAY, 'self.distance_m > stop_distance_m')],
        [(f'        if {_MAY}:\n            {_SPEED}\n', f'        is_near = self.distance_m is None or '
          f'self.distance_m <= stop_distance_m\n        command.linear.x = 0.0 if is_near else {_READ}\n')],
        [('self.create_subscription', 'self.subscription = self.create_subscription')],
    ],
    '4c': [
        [('return stops.pop(0), stops', 'return stops[0], stops[1:]')],
        [('stops = list(node', 'first, *stops = list(node'), ('return stops.pop(0), stops', 'return [first, stops]')],
        [("list(node.get_parameter('stops').value)", "[each for each in node.get_parameter('stops').value]")],
        # A message has an array of its own.
        [("list(node.get_parameter('stops').value)", "node.get_parameter('stops').get_parameter_value()."
          'integer_array_value'), ('.pop(0), stops', '.pop(0), list(stops)')],
    ],
    '4d': [
        [('min=0.0, max=3.0', 'max=3.0, step=0.01, continuous_update=False')],
        [(_ASK + _SHOW, "        if not client.set_parameter('max_speed_mps', change.new).successful:\n"
                        "            slider.value = client.get_parameter('max_speed_mps')\n")],
        [("slider.observe(ask, names='value')", "slider.observe(ask, 'value')")],
    ],
}
