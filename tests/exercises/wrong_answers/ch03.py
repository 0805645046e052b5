"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 3."""

RANGE = 'FloatingPointRange(from_value=0.0, to_value=2.0)'
SPEED = f"""'max_speed_mps', 1.0, ParameterDescriptor(
            floating_point_range=[{RANGE}]))"""
WHEELS = "'wheels', 6, ParameterDescriptor(read_only=True))"
SET_RESULT = "__import__('rcl_interfaces.msg').msg.SetParametersResult"
# A post-set callback that comes too late.
UNDO = """
        def undo(parameters):
            if self.get_parameter('{0}').value not in ({1}, 0.0, 2.0, 0.01, 1.37):
                self.set_parameters([__import__('rclpy.parameter').parameter.Parameter('{0}', value={1})])
        self.add_post_set_parameters_callback(undo)"""
_MAIN = 'def main():\n    try:\n        rclpy.init()\n'

WRONG = {
    '3a': [
        ([("'driver'", "'pilot'")], 2, 'it is called `pilot`'),
        ([('0.5', '1')], 1, 'type integer, value `1`'),
        ([('class Driver(Node):', 'class Driver:')], 0, 'driver_node.py has no class derived from `Node`'),
        ([("        super().__init__('driver')\n", '')], 0, '`__init__` has to call `super().__init__(…)`'),
        ([('(self):', '(self)')], 0, "SyntaxError in line 5 of driver_node.py: expected ':'"),
        ([('import Node', 'import Nod')], 0, "ImportError in line 1 of driver_node.py: cannot import name 'Nod'"),
        ([('max_speed_mps', 'max_sped_mps')], 1, 'none of that name'),
        ([('self.declare_', 'self.declair_')], 0, 'in the line `self.declair_parameter'),
        ([("        self.declare_parameter('max_speed_mps', 0.5)\n", '')], 1, 'the node has none of that name'),
        ([('0.5', '0.5, dynamic_typing=True')], 0, 'its constructor did not finish'),
    ],
    '3b': [
        ([("'max_speed_mps', 1.0", "'max_speed_mps', 1")], 2, 'type integer, value `1`'),
        ([(SPEED, "'max_speed_mps', 1.0, ParameterDescriptor(description='0 to 2'))")], 3,
         'A description is for people'),
        ([("'wheels', 6", "'wheels', '6'")], 2, "type string, value `'6'`"),
        ([("'wheels', 6, ParameterDescriptor(read_only=True)", "'wheels', 6")], 3, '`read_only`'),
        ([(SPEED, "'max_speed_mps', 1.0)")], 3, 'Nothing limits it'),
        ([('to_value=2.0', 'to_value=3.0')], 3, 'Its range goes from 0.0 to 3.0'),
        ([('from_value=0.0, to_value=2.0', 'from_value=0, to_value=2')], 3, 'A float has a dot'),
        # The node could not send these: a client that asked for them would wait until its time was over.
        ([(RANGE, 'FloatingPointRange(from_value=0.0, to_value=1.0), FloatingPointRange(to_value=2.0)')], 0,
         'must be a set or sequence with length <= 1'),
        ([(f'floating_point_range=[{RANGE}]', "integer_range=[__import__('rcl_interfaces.msg').msg.IntegerRange("
           'from_value=0.0, to_value=2.0)]')], 0, "The 'from_value' field must be of type 'int', and it is `0.0`"),
        ([('to_value=2.0', 'to_value=2.0, step=0.5')], 3, 'off the step'),
        ([(f'[{RANGE}]', RANGE)], 0, 'A descriptor has its range in a list, in brackets'),
        ([(SPEED, SPEED.replace('ParameterDescriptor(', 'ParameterDescriptor(dynamic_typing=True,'))], 3,
         'it takes values of any type'),
        ([(SPEED, "'max_speed_mps', 1.0)\n        self.add_on_set_parameters_callback(lambda ps: "
           f'{SET_RESULT}(successful=all(p.name == "wheels" or 0 <= p.value <= 2 for p in ps)))')], 3,
         'the node starts with 3.0'),
        ([("'wheels', 6", "'wheels', 4")], 3, 'type integer, value `4`'),
        ([("'wheels'", "'weels'")], 2, 'none of that name'),
        ([(WHEELS, f"'wheels', 6){UNDO.format('wheels', 6)}")], 3, 'put the value back only afterward'),
        ([(SPEED, f"'max_speed_mps', 1.0){UNDO.format('max_speed_mps', 1.0)}")], 3,
         'put the value back only afterward'),
    ],
    '3c': [
        ([("'cmd_vel'", "'cmd_val'")], 1, 'it publishes on `cmd_val`'),
        ([('= self.speed_mps', '= 0.5')], 2, 'it is 0.5'),
        ([('to_value=2.0', 'to_value=20.0')], 2, 'Its range goes from 0.0 to 20.0'),
        ([('        self.create_timer(0.1, self.drive)\n', '')], 1, 'Does a timer call the method that publishes?'),
        ([('self.drive)', 'self.drive())')], 0, 'A callback is given by its name alone, without parentheses'),
        ([('        self.commands.publish(command)\n', '')], 1, 'Does a timer call the method that publishes?'),
        ([('linear.x', 'linear.y')], 2, 'Does the node set `linear.x`, and to a float?'),
        ([('def drive(self)', 'def drive()')], 0, 'The first parameter of a method is `self`'),
        ([(f'floating_point_range=[{RANGE}]', '')], 2,
         'A description is for people'),
        ([(f'[{RANGE}]', RANGE)], 0,
         'A descriptor has its range in a list'),
        ([("= self.get_parameter('max_speed_mps').value", "= self.get_parameter('max_speed_mps')")],
         2, 'it is 0.0'),
        ([('self.create_timer(0.1', 'self.create_timer(1.0')], 1, 'its timer comes every 1 s'),
        ([("description='Speed at which the robot drives, in m/s.'", "description=''")], 2, 'its descriptor has none'),
        ([('0.1, self.drive', '0.1, drive')], 0, '`self.` is missing before `drive`'),
        ([('        self.speed_mps =', '        speed_mps =')], 0, 'In `__init__`, `speed_mps` has no `self.`'),
    ],
    '3d': [
        ([('        rclpy.spin(Driver())\n', '        driver = Driver()\n')], 0, 'Nothing spins the node'),
        ([('rclpy.init()', 'rclpy.init(args=[])')], 0, 'Does `rclpy.init()` get arguments'),
        ([('(KeyboardInterrupt, ExternalShutdownException)', 'ZeroDivisionError')], 2, 'That is what Ctrl+C raises'),
        ([('ExternalShutdownException):', 'ZeroDivisionError):')], 3, 'That is what SIGTERM raises'),
        ([('\n    main()', '\n    pass')], 0, 'Nothing calls `main()`'),
        ([("== '__main__'", "== 'main'")], 0, 'two underscores'),
        ([("if __name__ == '__main__':\n    main()", 'main()')], 3, '`main()` in line 32 starts ROS then, too'),
        ([(_MAIN, 'rclpy.init()\n\n\ndef main():\n    try:\n')], 3, '`rclpy.init()` in line 24 starts ROS then, too'),
        ([('        rclpy.init()\n', '')], 0, 'Call `rclpy.init()` before'),
        ([('rclpy.spin(Driver())', 'driver = Driver()\n        while True:\n            pass')], 0, 'Nothing spins it'),
        ([("'driver'", "'pilot'")], 4, 'it is called `pilot`'),
        ([('        pass', '        pass\n    finally:\n        rclpy.shutdown()')], 2, 'leave `rclpy.shutdown()` out'),
        ([('        pass', '        raise SystemExit(1)')], 2, 'its exit status is 1'),
        ([('self.create_timer', 'self.create_tmer')], 0, "no attribute 'create_tmer'"),
    ],
}

RIGHT = {
    '3a': [
        [('0.5', '5e-1')],
        [("self.declare_parameter('max_speed_mps', 0.5)", "self.declare_parameters('', [('max_speed_mps', 0.5)])")],
    ],
    '3b': [
        [('from_value=0.0, to_value=2.0', 'from_value=2.0, to_value=0.0')],
        [('super().__init__', f'limits = ParameterDescriptor()\n        limits.floating_point_range.append({RANGE})\n'
          '        super().__init__'),
         (f'ParameterDescriptor(\n            floating_point_range=[{RANGE}])', 'limits')],
        # A callback that is there before the declarations judges the start as well.
        [("super().__init__('rover')", "super().__init__('rover')\n        self.add_on_set_parameters_callback("
          f"lambda ps: {SET_RESULT}(successful=all(p.value == 6 if p.name == 'wheels' else 0 <= p.value <= 2 "
          "for p in ps if p.name in ('wheels', 'max_speed_mps'))))"),
         (SPEED, "'max_speed_mps', 1.0)"), (WHEELS, "'wheels', 6)")],
    ],
    '3c': [
        [('self.create_timer', 'self.timer = self.create_timer')],
        [("'cmd_vel'", "'/cmd_vel'")],
        [('command = Twist()\n        command.linear.x = self.speed_mps\n', 'command = Twist()\n        '
          'command.linear.x = float(self.speed_mps)\n')],
        # It reads the parameter each time, as chapter 4 does.
        [('= self.speed_mps', "= self.get_parameter('max_speed_mps').value")],
    ],
    '3d': [
        [('        pass', '        pass\n    finally:\n        rclpy.try_shutdown()')],
        [('import rclpy\n', 'import rclpy\nimport rclpy.executors\n'),
         ('rclpy.spin(Driver())', 'executor = rclpy.executors.SingleThreadedExecutor()\n        '
          'executor.add_node(Driver())\n        executor.spin()')],
        [('rclpy.spin(Driver())', 'driver = Driver()\n        while rclpy.ok():\n            '
          'rclpy.spin_once(driver, timeout_sec=0.1)')],
        [('def main():', 'def main(args=None):'), ('rclpy.init()', 'rclpy.init(args=args)')],
        [("if __name__ == '__main__':\n    main()", "IS_PROGRAM = __name__ == '__main__'\nif IS_PROGRAM:\n    main()")],
        [("if __name__ == '__main__':\n    main()", "if __name__ != '__main__':\n    pass\nelse:\n    raise SystemExit("
          'main())')],
    ],
}
