"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 8."""

WRONG = {
    '8a': [
        ([("'fan.speed', 0.5", "'speed', 0.5")], 0, 'its constructor did not finish.'),
        ([('to_value=1.0', 'to_value=2.0')], 2, 'it was accepted'),
        ([("'Speed, as a fraction of full speed.'", "''")], 2, 'there is none'),
        ([("'fan.speed', 0.5", "'fan.speed', 1")], 1, 'type integer, value `1`'),
        ([('0.5, Param', '0.25, Param')], 2, 'type double, value `0.25`'),
        ([('to_value=1.0', 'to_value=1')], 2, 'it is `1`. A float has a dot'),
        ([('from_value=0.0', 'from_value=0')], 2, 'it is `0`. A float has a dot'),
        ([('from_value=0.0', 'from_value=0.25')],
         2, 'it was rejected: Parameter fan.speed out of range Min: 0.25,'),
        ([("'Speed, as a fraction of full speed.'", '...')], 0, 'a `...` is still there'),
        ([("'Speed, as a fraction of full speed.'", '5')], 0, "must be of type 'str', and it is `5`"),
        ([("'Speed, as a fraction of full speed.'", "'TODO: description'")], 2, 'only `TODO: description`'),
        ([("'Speed, as a fraction of full speed.'", "'The speed of the fan.'")], 2, 'which the name says already'),
        ([('            description=', '            dynamic_typing=True, description=')], 2, 'it was accepted'),
        ([('        self.motor =', "        self.declare_parameter('fan.on', True)\n        self.motor =")],
         2, 'there is also `fan.on`'),
    ],
    '8b': [
        ([("        self.motor_mps = self.get_parameter('belt.speed_mps').value\n        self.add_on",
           '        self.add_on')], 6, 'it is `None`'),
        ([("'belt.speed_mps', 0.0, ParameterDescriptor(", "'belt.speed_mps', 0, ParameterDescriptor(")], 2,
         'it is of type integer: the default decides'),
        ([('from_value=0.0, to_value=2.0)', 'from_value=0.0, to_value=20.0)')], 6, 'it was accepted'),
        ([(', read_only=True', '')], 6, 'anybody can change it'),
        ([("new.get('belt.gap_m', self.get_parameter('belt.gap_m').value)", "self.get_parameter('belt.gap_m').value")],
         6, 'it was accepted'),
        ([('        if speed_mps > 1.0', '        self.motor_mps = speed_mps\n        if speed_mps > 1.0')], 6,
         'an on-set callback has only a proposal'),
        ([('start = self.validate([])', 'start = SetParametersResult(successful=True)')], 6, 'it has started'),
        ([("'belt.", "'")], 1, 'there is no `belt.speed_mps` and no `belt.gap_m`'),
        ([('            floating_point_range=[FloatingPointRange(from_value=0.0, to_value=1.0)]))', '            ))'),
          ('if speed_mps > 1.0 and gap_m < 0.3:', 'if speed_mps > 1.0 and gap_m < 0.3 or not 0.0 <= gap_m <= 1.0:')],
         6, 'a callback may reject, but no panel can know'),
        ([("description='Speed of the belt in m/s.',", '')], 6, 'there is none for `belt.speed_mps`'),
        ([("reason=f'{gap_m} m is too small a gap for {speed_mps} m/s'", "reason=''")], 6, 'the reason is empty'),
        ([('gap_m < 0.3', 'gap_m <= 0.3')], 6, 'A gap of 0.3 m is enough'),
        ([("    def react(self, parameters):\n        self.motor_mps = self.get_parameter('belt.speed_mps').value",
           "    def react(self, parameters):\n        if parameters[0].name == 'belt.speed_mps':\n"
           '            self.motor_mps = parameters[0].value')], 6, 'it is `0.6`'),
        ([('        self.add_post_set_parameters_callback(self.react)\n',
           '        from rcl_interfaces.msg import ParameterEvent\n'
           "        self.create_subscription(ParameterEvent, '/parameter_events', self.react, 10)\n")], 6,
         'in the call that stores it, and follows later'),
        ([("'belt.gap_m', 0.5,", "'belt.gap_m', 1.0,")], 6, 'it is `1.0`'),
        ([("'CB-0007'", "'CB-0008'")], 6, "it is `'CB-0008'`"),
        ([('from_value=0.0, to_value=2.0', 'from_value=0, to_value=2')], 6, 'A float has a dot'),
        ([("'belt.speed_mps', 0.0,", "'belt.speed_mps', '0.0',")], 0, 'its constructor did not finish. TypeError'),
        ([("        self.motor_mps = self.get_parameter('belt.speed_mps').value\n        self.add_on",
           '        self.add_on'),
          ('class Conveyor(Node):', 'class Conveyor(Node):\n    motor_mps = 0.0\n'),
          ('        self.motor_mps =', '        Conveyor.motor_mps =')],
         6, 'Does each conveyor have a motor of its own?'),
        ([("'conveyor'", "'conveyer'")], 7, 'it is called `conveyer`'),
        ([('gap_m < 0.3', 'gap_m < 30.0')], 3, 'is too small a gap'),
        ([("            return SetParametersResult(successful=False, reason=f'{gap_m} m is too small a gap for "
           "{speed_mps} m/s')", "            raise ValueError('too fast')")], 6, 'ValueError: too fast'),
        ([('    def react(self, parameters):\n', '    def react(self, parameters):\n        while True:\n'
           '            pass\n')], 2, 'Does a callback wait'),
        ([("        self.declare_parameter('belt.speed_mps'",
           '        self.add_on_set_parameters_callback(self.validate)\n'
           "        self.declare_parameter('belt.speed_mps'")], 0, 'its constructor did not finish.'),
    ],
    '8c': [
        ([("at once.': 1", "at once.': 6")], 4, 'is not initialized'),
        ([("took it.': 2", "took it.': 3")], 4, 'it accepted 50.0 m/s'),
        ([("all the same.': 3", "all the same.': 2")], 4, 'the motor runs at 1.5 m/s, and the parameter says 0.5'),
        ([("got none.': 4", "got none.': 5")], 4, 'begin with `controller.` is empty'),
        ([("weighs nothing.': 7", "weighs nothing.': 3")], 4, 'it accepted a gravity of 0'),
        ([("weighs nothing.': 7", "weighs nothing.': 0")], 4, 'there is `0`'),
        ([("weighs nothing.': 7", "weighs nothing.': [2, 7]")], 4, 'there is `[2, 7]`'),
        ([("weighs nothing.': 7", "weighs nothing.': True")], 4, 'there is `True`'),
    ],
    '8d': [
        ([('        rclpy.init()\n', '')], 0, 'Call `rclpy.init()` before'),
        ([('drum.speed_rpm', 'speed_rpm')], 4, 'the node has none of that name'),
        ([("description='Stamped on the frame.', ", '')], 7, 'there is none for `serial_number`'),
        ([("proposed.get('drum.tilt_deg', self.get_parameter('drum.tilt_deg').value)",
           "self.get_parameter('drum.tilt_deg').value")], 7, 'it was accepted'),
        ([('            raise ValueError(reason)', '            self.get_logger().error(reason)')], 7,
         'never sees the start values'),
        ([('        return SetParametersResult(successful', '        self.react(parameters)\n        return '
           'SetParametersResult(successful')], 7, 'an on-set callback has only a proposal'),
        ([('(KeyboardInterrupt, ExternalShutdownException)', 'KeyboardInterrupt')], 7, 'That is what SIGTERM raises'),
        ([("'drum.speed_rpm', 0.0", "'drum.speed_rpm', 0")], 4, 'type integer, value `0`'),
        ([("'drum.tilt_deg', 15.0", "'drum.tilt_deg', 10.0")], 7, 'type double, value `10.0`'),
        ([(',\n            floating_point_range=[FloatingPointRange(from_value=0.0, to_value=60.0)]', '')], 7,
         'it has none for its type'),
        ([('to_value=30.0', 'to_value=40.0')], 7, 'its `to_value` is 40.0'),
        ([(', read_only=True', '')], 7, 'accepted serial_number'),
        ([('tilt_deg > 30.0', 'tilt_deg >= 30.0')], 7, 'A tilt of 30° is still allowed'),
        # It logs no rejected speed, and still too early.
        ([('        return SetParametersResult(successful',
           '        if not reason:\n            self.react(parameters)\n'
           '        return SetParametersResult(successful'),
          ('        self.add_post_set_parameters_callback(self.react)\n', '')], 7,
         'an on-set callback has only a proposal'),
        ([('drum turns at', 'speed:')], 7, 'speed: 17.5 rpm'),
        ([('{parameter.value} rpm', '12.5 rpm')], 7, 'drum turns at 12.5 rpm'),
        # Of the tilt, too.
        ([("if parameter.name == 'drum.speed_rpm':", 'if True:')], 7, 'there is one more that begins with `'),
        # An import makes the node.
        ([('def main():\n    try:\n        rclpy.init()\n',
           'rclpy.init()\nmixer = Mixer()\n\n\ndef main():\n    try:\n'),
          ('rclpy.spin(Mixer())', 'rclpy.spin(mixer)')], 7,
         '`rclpy.init()` in line '),
        ([("if __name__ == '__main__':\n    main()", 'main()')], 7, 'starts ROS then, too'),
        ([('        self.add_post_set_parameters_callback(self.react)\n', '')], 7, 'it prints nothing'),
    ],
}

RIGHT = {
    '8b': [
        [('callback(self.react)',
          "callback(lambda _: setattr(self, 'motor_mps', self.get_parameter('belt.speed_mps').value))")],
        [("        self.motor_mps = self.get_parameter('belt.speed_mps').value\n        self.add_on",
          '        self.add_on'),
         ("    def react(self, parameters):\n        self.motor_mps = self.get_parameter('belt.speed_mps').value",
          '    def react(self, parameters):\n        pass\n\n    @property\n    def motor_mps(self):\n'
          "        return self.get_parameter('belt.speed_mps').value")],
        [("    def react(self, parameters):\n        self.motor_mps = self.get_parameter('belt.speed_mps').value",
          '    def react(self, parameters):\n        for parameter in parameters:\n'
          "            if parameter.name == 'belt.speed_mps':\n                self.motor_mps = parameter.value")],
        [('if speed_mps > 1.0 and gap_m < 0.3:', 'if not (speed_mps <= 1 or gap_m >= 0.3):')],
        [("reason=f'{gap_m} m is too small a gap for {speed_mps} m/s'", "reason='no'")],
        [("description='Speed of the belt in m/s.',", "description='m/s',")],
        [('        new = {parameter.name: parameter.value for parameter in parameters}\n',
          "        stored = self.get_parameters_by_prefix('belt').values()\n"
          '        new = {parameter.name: parameter.value for parameter in [*stored, *parameters]}\n'),
         ("new.get('belt.speed_mps', self.get_parameter('belt.speed_mps').value)", "new['belt.speed_mps']"),
         ("new.get('belt.gap_m', self.get_parameter('belt.gap_m').value)", "new['belt.gap_m']")],
        [('start = self.validate([])', 'start = SetParametersResult(successful=True)'),
         ("        self.declare_parameter('belt.gap_m'",
          '        self.add_on_set_parameters_callback(self.validate)\n'
          "        self.declare_parameter('belt.gap_m'"),
         ("new.get('belt.gap_m', self.get_parameter('belt.gap_m').value)",
          "new['belt.gap_m'] if 'belt.gap_m' in new else self.get_parameter('belt.gap_m').value")],
    ],
    '8c': [
        [("weighs nothing.': 7", "weighs nothing.': 2")],
        [("weighs nothing.': 7", "weighs nothing.': '7'")],
        [("at once.': 1", "at once.': 1.0")],
    ],
    '8a': [
        [('0.0, to_value=1.0', '-0.0, to_value=float(1)')],
        [("'Speed, as a fraction of full speed.'", "'0: off, 1: full'")],
        [("'Speed, as a fraction of full speed.'", "'Duty cycle'")],
        [("'fan.speed', 0.5", "'.'.join(['fan', 'speed']), 1 / 2")],
    ],
    '8d': [
        [("super().__init__('mixer')", "super().__init__('mixer')\n        self.get_logger().info('mixing')")],
        # Its reason begins like the line.
        [("'above 20 rpm the tilt is at most 30 degrees'", "f'no drum turns at {speed_rpm} rpm when it is tilted'"),
         ('        return SetParametersResult(successful', '        print(reason)\n        return SetParametersResult('
          'successful')],
        [("f'drum turns at {parameter.value} rpm'", '"drum turns at %.1f rpm" % parameter.value')],
        [('raise ValueError(reason)', 'raise SystemExit(reason)')],
        [('rclpy.spin(Mixer())', 'mixer = Mixer()\n        rclpy.spin(mixer)'),
         ('        pass', '        pass\n    finally:\n        rclpy.try_shutdown()')],
        [("self.declare_parameter('serial_number', 'MX-0001', ParameterDescriptor(\n            "
          "description='Stamped on the frame.', read_only=True))",
          "self.declare_parameters('', [('serial_number', 'MX-0001', ParameterDescriptor(\n            "
          "description='Stamped on the frame.', read_only=True))])")],
    ],
}
