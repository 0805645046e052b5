"""Wrong answers that people give to the steps of the capstone in chapter 11."""

WRONG = {
    '11a': [
        ([(', read_only=True', '')], 3, '`read_only`'),
        ([("'max_speed_mps', 1.0, ", "'max_speed_mps', 1, ")], 3, 'type integer'),
        ([('to_value=2.0', 'to_value=20.0')], 2, 'accepted'),
        ([("description='Painted on the side.', ", '')], 3, 'guess its unit'),
        ([('FloatingPointRange(from_value=0.1, to_value=2.0)', ''), ('floating_point_range=[\n        ]',
                                                                    'floating_point_range=[]')], 2,
         'A double has its `floating_point_range`'),
        ([("'cart_node'", "'cart'")], 4, 'it is called `cart`'),
    ],
    '11b': [
        ([('        self.add_on_set_parameters_callback(self.validate)\n', '')], 1, 'it was accepted'),
        # Only the start values, only the callback.
        ([('            raise ValueError(reason)', '            pass')], 2, 'not asked about start values'),
        # Judges each of the two against the stored other one.
        ([("proposed.get('max_speed_mps', speed), proposed.get('max_acceleration_mps2', acceleration)",
           "proposed.get('max_speed_mps', speed), acceleration")], 1, 'it was accepted'),
        ([('successful=not reason, reason=reason', 'successful=not reason')], 1, 'the reason is empty'),
        ([('speed ** 2 / (2 * acceleration)', 'speed ** 2 / acceleration')], 0, '1.96 m'),
        ([('speed ** 2 / (2 * acceleration)', 'speed / (2 * acceleration)')], 0, 'it was accepted'),
        ([('> SIGHT_M + 1e-9', '>= SIGHT_M')], 2, '2.0 m are just allowed'),
    ],
    '11c': [
        ([('        self.add_post_set_parameters_callback(self.react)', '')], 1, 'it is `14.0`'),
        ([('        self.react([])\n', '')], 2, 'it is `None`'),
        ([('        self.react([])', '        self.trip_sec = 14.0')], 2, 'it is `14.0`'),
        ([('add_post_set_parameters_callback(self.react)', 'add_on_set_parameters_callback(self.react)'),
          ('speed + speed / acceleration', 'speed + speed / acceleration\n'
           '        return SetParametersResult(successful=True)')], 1, 'it is `14.0`'),
        # Acts on the proposal, which may still be rejected.
        ([('add_post_set_parameters_callback(self.react)', 'add_on_set_parameters_callback(self.react)'),
          ('speed, acceleration = self.settings()\n',
           'speed, acceleration = self.settings()\n        new = {each.name: each.value for each in parameters}\n'
           "        speed = new.get('max_speed_mps', speed)\n"
           "        acceleration = new.get('max_acceleration_mps2', acceleration)\n"),
          ('speed + speed / acceleration', 'speed + speed / acceleration\n'
           '        return SetParametersResult(successful=True)')], 2, 'a side effect of an on-set callback'),
        ([('speed + speed / acceleration', 'speed')], 0, 'it is `12.0`'),
    ],
    '11d': [
        ([("parameter_files.render('/**', values).save(path)", 'client.dump(path)')], 0,
         'the nodes that its first line'),
        ([("parameter_files.render('/**', values)", 'parameter_files.render(client.node, values)')], 0,
         'holds nothing for /second_cart'),
        ([("['max_speed_mps', 'max_acceleration_mps2']", '')], 1, 'to read-only parameters, too'),
        ([("'max_speed_mps', ", '')], 0, '`max_speed_mps = 1.0`'),
        ([("parameter_files.render('/**', values).save(path)", 'return values')], 0, 'there is none'),
        ([("client.get_parameters(['max_speed_mps', 'max_acceleration_mps2'])", "client.get_parameters(['speed'])")], 0,
         'speed'),
    ],
    '11e': [
        ([("            namespace='/aisle_3',\n", '')], 0, 'there came a `/cart_node`'),
        # With the acceleration of the file the cart could not stop, so it does not start.
        ([(", 'max_acceleration_mps2': 0.6", '')], 0, 'to stop'),
        ([('config, {', '{')], 2, "`'CART-01'`"),
        ([('import LaunchDescription', 'import LaunchDescripton')], 0, 'LaunchDescripton'),
    ],
    '11f': [
        # One by one, the new speed meets the old acceleration.
        ([('set_parameters_atomically', 'set_parameters')], 0, '1 m/s and 1 m/s²'),
        ([("'max_acceleration_mps2': 1.0", "'max_acceleration_mps2': 3.0")], 0, '14.00 s'),
        ([("'max_speed_mps': 2.0, 'max_acceleration_mps2': 1.0", "'max_speed_mps': 1.8, 'max_acceleration_mps2': 1.4")],
         2, 'there is a gentler one'),
        ([("set_parameters_atomically({'max_speed_mps': 2.0, 'max_acceleration_mps2': 1.0})",
           "set_parameters({'max_acceleration_mps2': 1.0, 'max_speed_mps': 2.0})")], 2, '2 requests, with 1 and 1'),
        ([("'max_speed_mps': 2.0", "'max_speed_mps': 1.9")], 0, '8.22 s'),
    ],
}
