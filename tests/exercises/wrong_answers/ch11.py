"""Wrong answers that people give, and unusual right ones, to the steps of the capstone in chapter 11."""

_LIMITS = ', floating_point_range=[\n        FloatingPointRange(from_value=0.1, to_value=2.0)])'
_SPEED = "self.declare_parameter('max_speed_mps', 1.0, limited('Speed along the aisle in m/s.'))"
_ACCELERATION = ("self.declare_parameter('max_acceleration_mps2', 0.5, "
                 "limited('Acceleration in m/s², also for braking.'))")
_READ_ONLY = "ParameterDescriptor(description='Painted on the side.', read_only=True)"
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
        ([(', read_only=True', '')], 3, '`read_only`'),
        ([("'max_speed_mps', 1.0, ", "'max_speed_mps', 1, ")], 3, 'type integer'),
        ([("'max_speed_mps', 1.0, ", "'max_speed_mps', '1.0', ")], 3, 'type string'),
        ([('to_value=2.0', 'to_value=20.0')], 2, 'accepted'),
        ([('to_value=2.0', 'to_value=2')], 2, 'it is `2`. A float has a dot'),
        ([('floating_point_range=[\n        FloatingPointRange', 'integer_range=[\n        IntegerRange'),
          ('def limited', 'from rcl_interfaces.msg import IntegerRange\n\n\ndef limited')], 0,
         "must be of type 'int', and it is `0.1`"),
        ([('from_value=0.1', 'from_value=0.0')], 2, 'accepted'),
        ([('to_value=2.0)', 'to_value=2.0, step=0.1)')], 2, 'off the step'),
        ([("description='Painted on the side.', ", '')], 3, 'guess its unit'),
        ([("limited('Speed along the aisle in m/s.')", "limited('  ')")], 3, 'guess its unit'),
        ([('FloatingPointRange(from_value=0.1, to_value=2.0)', ''), ('floating_point_range=[\n        ]',
                                                                    'floating_point_range=[]')], 2,
         'A double has its `floating_point_range`'),
        ([("'cart_node'", "'cart'")], 4, 'it is called `cart`'),
        ([(_ACCELERATION, 'pass')], 2, 'the node has none of that name'),
        ([("'max_acceleration_mps2'", "'max_acceleration'")], 2, 'the node has none of that name'),
        ([("'max_acceleration_mps2', 0.5", "'max_acceleration_mps2', 0.6")], 3, 'value `0.6`'),
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
        # Only the start values, only the callback.
        ([('            raise ValueError(reason)', '            pass')], 2, 'never sees the start values'),
        ([(_START, ''), (_ON_SET, f'{_ON_SET}')], 2, 'it has started'),
        # Judges each of the two against the stored other one.
        ([(_PROPOSED, "proposed.get('max_speed_mps', speed), acceleration")], 1, 'it was accepted'),
        ([(_PROPOSED, "speed, proposed.get('max_acceleration_mps2', acceleration)")], 1, 'it was accepted'),
        ([('successful=not reason, reason=reason', 'successful=not reason')], 1, 'the reason is empty'),
        ([('speed ** 2 / (2 * acceleration)', 'speed ** 2 / acceleration')], 0, '1.96 m'),
        ([('speed ** 2 / (2 * acceleration)', 'speed / (2 * acceleration)')], 0, 'it was accepted'),
        ([('speed ** 2 / (2 * acceleration)', 'speed ** 2 / 2 * acceleration')], 0, 'it was accepted'),
        ([('> SIGHT_M + 1e-9', '>= SIGHT_M')], 2, '2.0 m is still allowed'),
        # The stored values of the start, forever.
        ([('        self.add_on_set', '        self.stored = self.settings()\n        self.add_on_set'),
          ('        speed, acceleration = self.settings()\n', '        speed, acceleration = self.stored\n')], 2,
         'it was accepted'),
        # Only the first parameter of a request, or each as if it were a speed.
        ([('for parameter in parameters}', 'for parameter in parameters[:1]}')], 2, 'it was'),
        ([(_PROPOSED, 'list(proposed.values())[0], acceleration')], 1, 'it was accepted'),
        ([('proposed.get', 'proposed.gett')], 1, "no attribute 'gett'"),
        ([('return SetParametersResult(successful=not reason, reason=reason)', 'return not reason')], 0,
         'has to return a `SetParametersResult`'),
        ([('return SetParametersResult', 'SetParametersResult')], 0, 'has to return a `SetParametersResult`'),
        ([('add_on_set_parameters', 'add_post_set_parameters')], 1, 'it was accepted'),
        ([('        proposed = {', '        while True: pass\n        proposed = {')], 0, 'did not answer'),
    ],
    '11c': [
        ([(f'        {_POST_SET}', '')], 1, 'it is `14.0`'),
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
        # One of the two.
        ([(_TRIP, f"""if not parameters or parameters[0].name == 'max_speed_mps':
            {_TRIP}""")], 2, 'it is `8.0`'),
        ([(_TRIP, f"""if not parameters or any(each.name == 'max_acceleration_mps2' for each in parameters):
            {_TRIP}""")], 1, 'it is `14.0`'),
        ([(_TRIP, """new = {each.name: each.value for each in parameters}
        self.trip_sec = (AISLE_M / new.get('max_speed_mps', 1.0)
                         + new.get('max_speed_mps', 1.0) / new.get('max_acceleration_mps2', 0.5))""")], 1,
         'it is `14.0`'),
        ([('self.trip_sec =', 'trip_sec =')], 0, 'it is `None`'),
        ([('self.trip_sec =', 'self.trip_s =')], 0, 'it is `None`'),
        # Right only later.
        ([(f'        self.react([])\n        {_POST_SET}', '        self.create_timer(0.2, lambda: self.react([]))')],
         2, 'it is `None`'),
        ([(_TRIP, f"{_TRIP}\n        self.trip_sec = f'{{self.trip_sec}}'")], 0, "it is `'14.0'`"),
        ([(_TRIP, 'self.trip_sec = AISLE_M // speed + speed // acceleration')], 0, 'it is `9.0`'),
        ([(_POST_SET, _POST_SET.replace('self.react', 'self.react([])'))], 0, 'must be callable'),
        ([('def react(self, parameters)', 'def react(self)'), ('self.react([])', 'self.react()')], 1,
         'positional argument'),
    ],
    '11d': [
        ([(_SAVE, 'client.dump(path)')], 1, 'the nodes that its key'),
        ([("parameter_files.render('/**', values)", 'parameter_files.render(client.node, values)')], 1,
         'the nodes that its key'),
        ([("parameter_files.render('/**', values)", "parameter_files.render('/second_cart', values)")], 1,
         'the nodes that its key'),
        # For the root namespace alone.
        ([("parameter_files.render('/**', values)", "parameter_files.render('/*', values)")], 1,
         'the nodes that its key'),
        # Rounded: the first line is right.
        ([(_SAVE, '''path.write_text('/**:\\n  ros__parameters:\\n' + ''.join(
        f'    {name}: {value:.1f}\\n' for name, value in values.items()))''')], 1, '`max_acceleration_mps2 = 0.9`'),
        ([("['max_speed_mps', 'max_acceleration_mps2']", '')], 1, 'to read-only parameters, too'),
        ([("'max_speed_mps', ", '')], 1, '`max_speed_mps = 1.0`'),
        ([(_SAVE, 'return values')], 0, 'there is none'),
        ([("client.get_parameters(['max_speed_mps', 'max_acceleration_mps2'])", "client.get_parameters(['speed'])")], 0,
         'speed'),
        # Hard-coded, and numbers that lose their dot.
        ([("client.get_parameters(['max_speed_mps', 'max_acceleration_mps2'])",
           "{'max_speed_mps': 2.0, 'max_acceleration_mps2': 1.0}")], 1, '`max_speed_mps = 2.0`'),
        ([(_SAVE, """path.write_text('/**:\\n  ros__parameters:\\n' + ''.join(
        f'    {name}: {value:g}\\n' for name, value in values.items()))""")], 0, "of type 'INTEGER'"),
        ([(_SAVE, """path.write_text(''.join(f'{name}: {value}\\n' for name, value in values.items()))""")], 0,
         'Cannot have a value before ros__parameters'),
        ([(_SAVE, """path.write_text('/**:\\n' + ''.join(f'    {name}: {value}\\n' for name, value in values.items()))
""")], 0, 'Cannot have a value before ros__parameters'),
        ([(_SAVE, _SAVE.replace('path', "'fleet.yaml.tmp'")), ('values =', 'import os; os.chdir("/tmp"); values =')], 0,
         'there is none'),
    ],
    '11e': [
        ([("            namespace='/aisle_3',\n", '')], 0, 'there came a `/cart_node`'),
        # With the acceleration of the file the cart could not stop, so it does not start.
        ([(", 'max_acceleration_mps2': 0.6", '')], 0, 'to stop'),
        ([('config, {', '{')], 2, "`'CART-01'`"),
        ([(f'config, {_OVERRIDES}', f'{_OVERRIDES}, config')], 2, '1.0 and 0.4'),
        ([(f'config, {_OVERRIDES}', "{'cart_id': 'CART-07', 'max_speed_mps': 1.5, 'max_acceleration_mps2': 0.6}"),
          ("'cart_config.yaml'", "'cart.yaml'")], 2, 'it does not'),
        ([('import LaunchDescription', 'import LaunchDescripton')], 0, 'LaunchDescripton'),
        ([("executable='cart_node'", "executable='simple_param_node'")], 0,
         'there came a `/aisle_3/simple_param_node`'),
        ([("executable='cart_node'", "executable='cart'")], 0, 'none came'),
        ([("'max_speed_mps': 1.5", "'max_speed_mps': '1.5'")], 0, 'STRING'),
        ([("'cart_config.yaml'", "'cart.yaml'")], 2, 'the file has not been loaded'),
        # Relative to the folder in which it happens to be started.
        ([(_CONFIG, "'config/cart_config.yaml'")], 2, 'the file has not been loaded'),
        # A second one.
        ([('return LaunchDescription([', "return LaunchDescription([Node(package='param_tutorial', "
           "executable='cart_node'),")], 0, 'the launch starts 2 processes'),
        # Hangs.
        ([('    config = ', '    import time; time.sleep(1000)\n    config = ')], 0, 'none came'),
        ([('return LaunchDescription', 'LaunchDescription')], 0, 'none came'),
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
        # Rounded down.
        ([("'max_speed_mps': 2.0, 'max_acceleration_mps2': 1.0",
           "'max_speed_mps': 1.9, 'max_acceleration_mps2': 1.1281")], 0, '8.000037 s'),
        ([(_SET, 'return 2.0, 1.0')], 0, '14.00 s, with 1 m/s and 0.5 m/s², as before'),
        ([(_SET, "client.set_parameter('max_speed_mps', 2.0)")], 0, '14.00 s'),
        ([("'max_speed_mps': 2.0, 'max_acceleration_mps2': 1.0", "'max_speed_mps': 2, 'max_acceleration_mps2': 1")], 0,
         '14.00 s'),
        ([(_SET, "client.get_parameters()['max_speed_mps'] = 2.0")], 0, '14.00 s'),
        ([('atomically', 'atomicaly')], 0, 'atomicaly'),
        ([(_SET, f'while True: {_SET}')], 0, 'was still running'),
    ],
    '11g': [
        ([('door_node = warehouse.door_node:main', 'door = warehouse.door_node:main')], 1, 'No executable found'),
        ([('door_node:main', 'door_node:mian')], 1, "has no attribute 'mian'"),
        ([('setup(\n', 'setup((\n')], 0, 'SyntaxError'),
        ([('<name>warehouse</name>', '<name>warehose</name>'), ("name='warehouse',", "name='warehose',")], 0,
         'it finds no package of this name'),
        ([("    'setup.cfg': '''[develop]\nscript_dir=$base/lib/warehouse\n[install]\n"
           "install_scripts=$base/lib/warehouse\n''',\n", '')], 1, 'No executable found'),
        ([("packages=['warehouse'],", '')], 0, 'Multiple top-level packages'),
        ([('rclpy.spin(Door())', 'Door()')], 1, 'Nothing spins the node'),
        ([("super().__init__('door')", "super().__init__('gate')")], 6, 'it is called `gate`'),
        ([("'open_sec', 5.0", "'open_sec', 5")], 4, 'type integer, value `5`'),
        ([('to_value=60.0', 'to_value=30.0')], 5, 'its `to_value` is 30.0'),
        ([('{open_sec} s', '5.0 s')], 5, 'its last line is'),
        ([('(KeyboardInterrupt, ExternalShutdownException)', 'KeyboardInterrupt')], 5, 'That is what SIGTERM raises'),
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
