"""Wrong answers that people give, and unusual right ones, to the steps of the capstone in chapter 11."""

_SPEED = "self.declare_parameter('max_speed_mps', 1.0, limited('Speed along the aisle in m/s.'))"
_ACCELERATION = ("self.declare_parameter('max_acceleration_mps2', 0.5, "
                 "limited('Acceleration in m/s², also for braking.'))")
_PROPOSED = "proposed.get('max_speed_mps', speed), proposed.get('max_acceleration_mps2', acceleration)"
_ON_SET = '        self.add_on_set_parameters_callback(self.validate)\n'
_START = '''        reason = self.objection(*self.settings())
        if reason:
            raise ValueError(reason)
'''
_POST_SET = 'self.add_post_set_parameters_callback(self.react)'
_TRIP = 'self.trip_sec = AISLE_M / speed + speed / acceleration'
_SAVE = "parameter_files.render('/**', values).save(path)"
_OVERRIDES = "{'max_speed_mps': 1.5, 'max_acceleration_mps2': 0.6}"
_CONFIG = "os.path.join(get_package_share_directory('param_tutorial'), 'config', 'cart_config.yaml')"
_SET = "client.set_parameters_atomically({'max_speed_mps': 2.0, 'max_acceleration_mps2': 1.0})"

WRONG = {
    '11a': [
        ([('floating_point_range=[\n        FloatingPointRange', 'integer_range=[\n        IntegerRange'),
          ('def limited', 'from rcl_interfaces.msg import IntegerRange\n\n\ndef limited')], 0,
         "must be of type 'int', and it is `0.1`"),
        ([(', read_only=True', '')], 3, '`read_only`'),
        ([("'max_speed_mps', 1.0, ", "'max_speed_mps', 1, ")], 3, 'type integer'),
        ([("'max_acceleration_mps2', 0.5", "'max_acceleration_mps2', 0.6")], 3, 'value `0.6`'),
        ([("'max_speed_mps', 1.0, ", "'max_speed_mps', '1.0', ")], 3, 'type string'),
        ([('to_value=2.0', 'to_value=20.0')], 2, 'accepted'),
        ([('to_value=2.0', 'to_value=2')], 2, 'it is `2`. A float has a dot'),
        ([('to_value=2.0)', 'to_value=2.0, step=0.1)')], 2, 'off the step'),
        ([("description='Painted on the side.', ", '')], 3, 'guess its unit'),
        ([("'cart_node'", "'cart'")], 4, 'it is called `cart`'),
        ([(_ACCELERATION, 'pass')], 2, 'the node has none of that name'),
        # One descriptor for two, in either order.
        ([(_SPEED, f"shared = limited('m/s')\n        {_SPEED}"),
          ("limited('Speed along the aisle in m/s.')", 'shared'),
          ("limited('Acceleration in m/s², also for braking.')", 'shared')], 0, 'it names `max_acceleration_mps2`'),
        ([(_SPEED, ''), (_ACCELERATION, "shared = limited('m')\n        self.declare_parameter("
                         "'max_acceleration_mps2', 0.5, shared)\n        self.declare_parameter("
                         "'max_speed_mps', 1.0, shared)")], 0, 'it names `max_speed_mps`'),
        ([('read_only=True', 'read_only=True, dynamic_typing=True'), ('description=description', 'description='
                                                                      'description, dynamic_typing=True')], 2,
         'accepted'),
        # Deaf to what it is started with.
        ([(_SPEED, _SPEED.replace("m/s.')", "m/s.'), ignore_override=True"))], 3, 'it is `1.0`'),
    ],
    '11b': [
        ([(_ON_SET, '')], 1, 'it was accepted'),
        ([('> SIGHT_M + 1e-9', '>= SIGHT_M')], 2, '2.0 m is still allowed'),
        # Only the callback.
        ([('            raise ValueError(reason)', '            pass')], 2, 'never sees the start values'),
        # Judges each of the two against the stored other one.
        ([(_PROPOSED, "proposed.get('max_speed_mps', speed), acceleration")], 1, 'it was accepted'),
        ([('successful=not reason, reason=reason', 'successful=not reason')], 1, 'the reason is empty'),
        ([('speed ** 2 / (2 * acceleration)', 'speed ** 2 / acceleration')], 0, '1.96 m'),
        ([('proposed.get', 'proposed.gett')], 1, "no attribute 'gett'"),
        ([('return SetParametersResult(successful=not reason, reason=reason)', 'return not reason')], 0,
         'has to return a `SetParametersResult`'),
        ([('        proposed = {', '        while True: pass\n        proposed = {')], 0, 'did not return'),
    ],
    '11c': [
        ([('        self.react([])\n', '')], 2, 'it is `None`'),
        ([(f'        {_POST_SET}', '')], 1, 'it is `14.0`'),
        # Acts on the proposal, which may still be rejected.
        ([('add_post_set_parameters_callback(self.react)', 'add_on_set_parameters_callback(self.react)'),
          ('speed, acceleration = self.settings()\n',
           'speed, acceleration = self.settings()\n        new = {each.name: each.value for each in parameters}\n'
           "        speed = new.get('max_speed_mps', speed)\n"
           "        acceleration = new.get('max_acceleration_mps2', acceleration)\n"),
          ('speed + speed / acceleration', 'speed + speed / acceleration\n'
           '        return SetParametersResult(successful=True)')], 2, 'a side effect of an on-set callback'),
        ([('        self.react([])', '        self.trip_sec = 14.0')], 2, 'it is `14.0`'),
        # Follows one of the two.
        ([(_TRIP, f"""if not parameters or parameters[0].name == 'max_speed_mps':
            {_TRIP}""")], 2, 'it is `8.0`'),
        ([('self.trip_sec =', 'trip_sec =')], 0, 'it is `None`'),
        ([(_TRIP, f"{_TRIP}\n        self.trip_sec = f'{{self.trip_sec}}'")], 0, "it is `'14.0'`"),
        ([(_POST_SET, _POST_SET.replace('self.react', 'self.react([])'))], 0, 'must be callable'),
        ([('def react(self, parameters)', 'def react(self)'), ('self.react([])', 'self.react()')], 1,
         'positional argument'),
    ],
    '11d': [
        ([(_SAVE, 'client.dump(path)')], 1, 'the nodes that its key'),
        ([("['max_speed_mps', 'max_acceleration_mps2']", '')], 1, 'to read-only parameters, too'),
        # Rounded: the first line is right.
        ([(_SAVE, '''path.write_text('/**:\\n  ros__parameters:\\n' + ''.join(
        f'    {name}: {value:.1f}\\n' for name, value in values.items()))''')], 1, '`max_acceleration_mps2 = 0.9`'),
        ([(_SAVE, 'return values')], 0, 'there is none'),
        ([("client.get_parameters(['max_speed_mps', 'max_acceleration_mps2'])", "client.get_parameters(['speed'])")], 0,
         'speed'),
        ([(_SAVE, """path.write_text('/**:\\n  ros__parameters:\\n' + ''.join(
        f'    {name}: {value:g}\\n' for name, value in values.items()))""")], 0, "of type 'INTEGER'"),
        ([(_SAVE, """path.write_text(''.join(f'{name}: {value}\\n' for name, value in values.items()))""")], 0,
         'Cannot have a value before ros__parameters'),
    ],
    '11e': [
        ([("            namespace='/aisle_3',\n", '')], 0, 'there came a `/cart_node`'),
        ([(f'config, {_OVERRIDES}', f'{_OVERRIDES}, config')], 2, '1.0 and 0.4'),
        ([('config, {', '{')], 2, "`'CART-01'`"),
        # With the acceleration of the file the cart could not stop, so it does not start.
        ([(", 'max_acceleration_mps2': 0.6", '')], 0, 'to stop'),
        ([(f'config, {_OVERRIDES}', "{'cart_id': 'CART-07', 'max_speed_mps': 1.5, 'max_acceleration_mps2': 0.6}"),
          ("'cart_config.yaml'", "'cart.yaml'")], 2, 'it does not'),
        ([('import LaunchDescription', 'import LaunchDescripton')], 0,
         "name 'LaunchDescription' is not defined"),
        ([("executable='cart_node'", "executable='simple_param_node'")], 0,
         'there came a `/aisle_3/simple_param_node`'),
        ([("executable='cart_node'", "executable='cart'")], 0, 'none came'),
        ([("'max_speed_mps': 1.5", "'max_speed_mps': '1.5'")], 0, 'STRING'),
        # A second cart.
        ([('return LaunchDescription([', "return LaunchDescription([Node(package='param_tutorial', "
           "executable='cart_node'),")], 0, 'the launch starts 2 processes'),
        # Hangs.
        ([('    config = ', '    import time; time.sleep(1000)\n    config = ')], 0, 'none came'),
        ([('return LaunchDescription', 'LaunchDescription')], 0, 'none came'),
    ],
    '11f': [
        # One by one, the new speed meets the old acceleration.
        ([('set_parameters_atomically', 'set_parameters')], 0, '1 m/s and 1 m/s²'),
        ([("'max_speed_mps': 2.0, 'max_acceleration_mps2': 1.0", "'max_speed_mps': 1.8, 'max_acceleration_mps2': 1.4")],
         2, 'there is a gentler one'),
        ([("'max_acceleration_mps2': 1.0", "'max_acceleration_mps2': 2.0")], 2, 'since 7.00 s are less than 8 s'),
        ([("set_parameters_atomically({'max_speed_mps': 2.0, 'max_acceleration_mps2': 1.0})",
           "set_parameters({'max_acceleration_mps2': 1.0, 'max_speed_mps': 2.0})")], 2, '2 requests, with 1 and 1'),
        ([("'max_acceleration_mps2': 1.0", "'max_acceleration_mps2': 3.0")], 0, '14.00 s'),
        ([('atomically', 'atomicaly')], 0, 'atomicaly'),
        ([(_SET, f'while True: {_SET}')], 0, 'was still running'),
    ],
    '11g': [
        ([('setup(\n', 'setup((\n')], 0, 'SyntaxError'),
        ([('door_node = warehouse.door_node:main', 'door = warehouse.door_node:main')], 1,
         'in `install/warehouse` there is `lib/warehouse/door`.'),
        ([('install_scripts=$base/lib/warehouse', 'install_scripts=$base/bin')], 1, 'there is `bin/door_node`'),
        ([("'open_sec', 5.0", "'open_sec', 5")], 4, 'type integer, value `5`'),
        ([('{open_sec} s', '5.0 s')], 5, 'its last line is'),
        ([('(KeyboardInterrupt, ExternalShutdownException)', 'KeyboardInterrupt')], 5, 'That is what SIGTERM raises'),
        ([('door_node:main', 'door_node:mian')], 1, "has no attribute 'mian'"),
        ([('<name>warehouse</name>', '<name>warehose</name>'), ("name='warehouse',", "name='warehose',")], 0,
         'it finds no package of this name'),
        ([("packages=['warehouse'],", '')], 0, 'Multiple top-level packages'),
        ([('rclpy.spin(Door())', 'Door()')], 1, 'Nothing spins the node'),
        ([("super().__init__('door')", "super().__init__('gate')")], 6, 'it is called `gate`'),
        ([('to_value=60.0', 'to_value=30.0')], 5, 'its `to_value` is 30.0'),
        ([('def main():', 'def main()')], 1, "expected ':'"),
    ],
}

RIGHT = {
    '11a': [
        [(_SPEED, f'{_ACCELERATION}\n        {_SPEED}\n        return')],
        [("'max_speed_mps', 1.0, limited", "name='max_speed_mps', value=1.0, descriptor=limited")],
        [(_SPEED + '\n        ' + _ACCELERATION, """self.declare_parameters('', [
            ('max_speed_mps', 1.0, limited('m/s')), ('max_acceleration_mps2', 0.5, limited('m/s^2'))])""")],
        [('        self.declare_parameter(\n', "        self.declare_parameter('color', 'red')\n"
          '        self.declare_parameter(\n')],
        [('to_value=2.0)', 'to_value=2.0, step=0.0)')],
    ],
    '11b': [
        [('raise ValueError', 'raise RuntimeError')],
        [('> SIGHT_M + 1e-9', '> SIGHT_M')],
        [(_START, ''), (_ON_SET, f"""{_ON_SET}        result = self.validate([])
        if not result.successful:
            raise ValueError(result.reason)
""")],
        # Judges the start values in the callback, by setting them again.
        [(_START, ''), (_ON_SET, f"""{_ON_SET}        names = ['max_speed_mps', 'max_acceleration_mps2']
        result = self.set_parameters_atomically(self.get_parameters(names))
        if not result.successful:
            raise ValueError(result.reason)
""")],
        [(f'{_START}{_ON_SET}', """        from param_tools import Rules
        Rules(self).check(['max_speed_mps', 'max_acceleration_mps2'],
                          lambda speed, acceleration: not self.objection(speed, acceleration), 'must stop in time')
""")],
        [('        proposed = {parameter.name: parameter.value for parameter in parameters}\n'
          '        speed, acceleration = self.settings()\n', """        speed, acceleration = self.settings()
        proposed = {}
        for parameter in parameters:
            if parameter.name == 'max_speed_mps':
                speed = parameter.value
            elif parameter.name == 'max_acceleration_mps2':
                acceleration = parameter.value
""")],
    ],
    '11c': [
        # Never old, since it is calculated when somebody looks.
        [('        self.react([])\n        self.add_post_set_parameters_callback(self.react)\n', ''),
         ('def react(self, parameters):', '@property\n    def trip_sec(self):'),
         ('self.trip_sec =', 'return')],
        [(f'        {_POST_SET}', '        self.add_post_set_parameters_callback(lambda parameters: self.react([]))')],
        # By the event of its own parameters.
        [(f'        {_POST_SET}', """        from rcl_interfaces.msg import ParameterEvent
        self.create_subscription(ParameterEvent, '/parameter_events', lambda event: self.react([]), 10)""")],
        # By a timer.
        [(f'        {_POST_SET}', '        self.create_timer(0.05, lambda: self.react([]))')],
        [(f'        self.react([])\n        {_POST_SET}', f"""        {_POST_SET}
        self.set_parameters([self.get_parameter('max_speed_mps')])""")],
    ],
    '11d': [
        [(_SAVE, "import json\n    path.write_text(json.dumps({'/**': {'ros__parameters': dict(values)}}))")],
        [(_SAVE, """path.write_text('/**:\\n  ros__parameters:\\n' + ''.join(
        f'    {name}: {value}\\n' for name, value in values.items()))""")],
        [(_SAVE, """import yaml
    with open(path, 'w') as file:
        yaml.safe_dump({'/**': {'ros__parameters': dict(values)}}, file)""")],
        [(_SAVE, """client.dump(path)
    lines = path.read_text().splitlines()
    path.write_text('\\n'.join(['/**:', *(line for line in lines[1:] if 'cart_id' not in line)]) + '\\n')""")],
    ],
    '11e': [
        [("namespace='/aisle_3'", "namespace='aisle_3'")],
        [("            output='screen',\n", ''), ('namespace=', "name='cart_node',\n            namespace=")],
        [('parameters=[config, {', 'parameters=[config, {"max_speed_mps": 1.0}, {')],
        [(_CONFIG, "str(__import__('pathlib').Path(get_package_share_directory('param_tutorial')) / 'config/"
          "cart_config.yaml')")],
    ],
    '11f': [
        [("'max_speed_mps': 2.0, 'max_acceleration_mps2': 1.0", "'max_acceleration_mps2': 1.0, 'max_speed_mps': 2.0")],
        [(_SET, """speed = 2.0
    client.set_parameters_atomically({
        'max_speed_mps': speed, 'max_acceleration_mps2': speed ** 2 / (8 * speed - 12)}).raise_for_reason()""")],
        # Step by step, each of them allowed.
        [(_SET, """for speed in (1.8, 1.9, 2.0):
        client.set_parameters_atomically({'max_speed_mps': speed,
                                          'max_acceleration_mps2': speed ** 2 / (8 * speed - 12)})""")],
    ],
    '11g': [
        [("packages=['warehouse']", 'packages=find_packages()'), ('import setup\n', 'import find_packages, setup\n')],
        [("'share/warehouse', ['package.xml']", "'share/' + 'warehouse', ['package.xml']")],
        [('script_dir=$base', 'script-dir=$base'), ('install_scripts=$base', 'install-scripts=$base')],
        [('def main():', 'def main(args=None):'), ('rclpy.init()', 'rclpy.init(args=args)')],
    ],
}
