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
                self.set_parameters([Parameter('{0}', value={1})])
        self.add_post_set_parameters_callback(undo)"""
_MAIN = 'def main():\n    try:\n        rclpy.init()\n'

WRONG = {
    '3a': [
        ([('90', '90.0')], 2, 'type double, value `90.0`'),
        ([('30.0', '30')], 2, 'type integer, value `30`'),
        ([("'7'", '7')], 2, 'type integer, value `7`'),
        ([('90', '...')], 0, 'its constructor did not finish. TypeError: The'),
        ([('90', "'90'")], 2, "type string, value `'90'`"),
        ([('90', 'Parameter.Type.INTEGER')], 2, 'type integer, no value'),
        ([('90', '[90]')], 2, 'type integer array, value `[90]`'),
        ([('30.0', '30.5')], 2, 'type double, value `30.5`'),
        ([("'label'", "'lable'")], 2, 'the node has none of that name'),
        ([("'7'", "'7.0'")], 2, "type string, value `'7.0'`"),
        ([("'door'", "'doors'")], 3, 'it is called `doors`'),
        ([("'7'", "'7', ParameterDescriptor(dynamic_typing=True)")], 2, 'it takes values of any type'),
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
        ([('50.0', '50')], 2, 'type integer, value `50`'),
        ([('FloatingPointRange(from_value=0.0', 'FloatingPointRange(from_value=-1000.0'), ('100.0)', '1000.0)')], 3,
         'Its range goes from -1000.0 to 1000.0'),
        ([("'warm_white', True", "'warm_white', 1")], 3, 'type integer, value `1`'),
        ([('Parameter.Type.DOUBLE', '0.0')], 3, 'type double, value `0.0`'),
        ([('to_value=100.0', 'to_value=100.0, step=1.0')], 3, 'off the step'),
        ([('to_value=100.0', 'to_value=100.0, step=0')], 3, 'A float has a dot'),
        ([('50.0', '5.0')], 3, 'type double, value `5.0`'),
        ([("'warm_white', True", "'warm_white', False")], 3, 'type boolean, value `False`'),
        ([("'warm_white', True", "'warm_white', True, ParameterDescriptor(read_only=True)")], 3, 'read only'),
        ([("'warm_white', True", "'warm_white', True, ParameterDescriptor(dynamic_typing=True)")], 3,
         'it takes values of any type'),
        ([('Parameter.Type.DOUBLE', 'None')], 0, 'its constructor did not finish'),
        ([('Parameter.Type.DOUBLE', 'Parameter.Type.INTEGER')], 3, 'type integer, no value'),
        ([('Parameter.Type.DOUBLE', 'Parameter.Type.DOUBLE, ParameterDescriptor(read_only=True)')], 3, 'read only'),
    ],
    '3d': [
        ([('        rclpy.spin(Kettle())\n', '        kettle = Kettle()\n')], 0, 'Nothing spins the node'),
        ([("'target_c', 80.0", "'target_c', 80")], 4, 'type integer, value `80`'),
        ([('ParameterDescriptor(read_only=True)', "ParameterDescriptor(description='fixed')")], 5, '`read_only`'),
        ([("self.get_logger().info(f'heating to {target_c} degrees')", 'pass')], 5, 'it prints nothing'),
        ([('(KeyboardInterrupt, ExternalShutdownException)', 'ZeroDivisionError')], 4, 'That is what Ctrl+C raises'),
        ([('ExternalShutdownException):', 'ZeroDivisionError):')], 5, 'That is what SIGTERM raises'),
        ([('\n    main()', '\n    pass')], 0, 'Nothing calls `main()`'),
        ([("== '__main__'", "== 'main'")], 0, 'two underscores'),
        ([("if __name__ == '__main__':\n    main()", 'main()')], 5, '`main()` in line 25 starts ROS then, too'),
        ([('def main():\n    try:', 'if True:\n    try:'), ("if __name__ == '__main__':\n    main()", '')], 5,
         'starts ROS then, too'),
        # An import makes the node, or half of it, by whatever name.
        ([(_MAIN, 'rclpy.init()\nnode = Kettle()\n\n\ndef main():\n    try:\n'),
          ('rclpy.spin(Kettle())', 'rclpy.spin(node)')], 5, '`rclpy.init()` in line 17 starts ROS then, too'),
        ([(_MAIN, 'rclpy.init()\n\n\ndef main():\n    try:\n')], 5,
         '`rclpy.init()` in line 17 starts ROS then, too'),
        ([('import rclpy\n', 'import rclpy\nfrom rclpy import init as begin\n'), ('        rclpy.init()\n', ''),
          ('def main():', 'begin(args=None)\n\n\ndef main():')], 5, '`begin(args=None)` in line 18 starts'),
        ([('        pass\n', '        pass\n    finally:\n        rclpy.try_shutdown()\n'),
          ("if __name__ == '__main__':", "if __name__ != 'kettle':")], 5, '`main()` in line 28 starts ROS then, too'),
        ([('def main():\n', 'def connect():\n    rclpy.init()\n\n\ndef main():\n'), ('        rclpy.init()\n', ''),
          ('if __name__', 'connect()\nif __name__')], 5, '`connect()` in line '),
        ([('        rclpy.init()\n', '')], 0, 'Call `rclpy.init()` before'),
        ([('rclpy.init()', 'rclpy.init(args=[])')], 0, 'Does `rclpy.init()` get arguments'),
        ([('rclpy.spin(Kettle())', 'kettle = Kettle()\n        while True:\n            pass')], 0,
         'Nothing spins it'),
        ([("'kettle'", "'kettel'")], 6, 'it is called `kettel`'),
        ([('get_logger()', 'get_loger()')], 0,
         "in line 14, `self.get_loger().info(f'heating to {target_c} degrees')`"),
        ([('def main():', 'def main()')], 0, "expected ':', in line 17, `def main()`"),
        ([('import Node', 'import Nod')], 0, "cannot import name 'Nod'"),
        ([('        pass', '        pass\n    finally:\n        rclpy.shutdown()')], 4, 'leave `rclpy.shutdown()` out'),
        ([('        pass', '        raise SystemExit(1)')], 4, 'its exit status is 1'),
        ([('{target_c}', '80.0')], 5, '[kettle]: heating to 80.0 degrees'),
        ([('to_value=100.0', 'to_value=110.0')], 5, 'accepted target_c = 100.1'),
        ([('from_value=20.0, to_value=100.0', 'from_value=20, to_value=100')], 5, 'A float has a dot'),
        ([("super().__init__('kettle')", "while True:\n            __import__('time').sleep(0.1)")], 0,
         'none has come after 15 s'),
    ],
}

RIGHT = {
    '3a': [
        [('30.0', '3e1')],
        [('90', 'int(90.0)')],
        [("'7'", 'str(7)'),
         ('30.0', "float('30')")],
        [("        self.declare_parameter('max_angle_deg', 90)\n"
          "        self.declare_parameter('speed_dps', 30.0)\n",
          "        self.declare_parameters('', [('max_angle_deg', 90), ('speed_dps', 30.0)])\n")],
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
        [('to_value=100.0', 'to_value=100.0, step=0.5')],
        [("'warm_white', True", "'warm_white', bool('true')")],
        [("        self.declare_parameter('warm_white', True)\n        self.declare_parameter('calibration', "
          'Parameter.Type.DOUBLE)', "        self.declare_parameters('', [('warm_white', True), ('calibration', "
          'Parameter.Type.DOUBLE)])')],
    ],
    '3d': [
        [('        pass', '        pass\n    finally:\n        rclpy.try_shutdown()')],
        [('self.get_logger().info(', 'print('), ('import rclpy\n', 'import rclpy\nimport rclpy.executors\n'),
         ('rclpy.spin(Kettle())', 'executor = rclpy.executors.SingleThreadedExecutor()\n        '
          'executor.add_node(Kettle())\n        executor.spin()')],
        [('rclpy.spin(Kettle())', 'kettle = Kettle()\n        while rclpy.ok():\n            '
          'rclpy.spin_once(kettle, timeout_sec=0.1)')],
        # No function, and no class.
        [('def main():\n    try:', "if __name__ == '__main__':\n    try:"),
         ("\n\nif __name__ == '__main__':\n    main()", ''),
         ('class Kettle(Node):\n    def __init__(self):\n        super().__init__',
          'def Kettle():\n        self = Node'),
         (" degrees')", " degrees')\n        return self")],
        [('def main():', 'def main(args=None):'), ('rclpy.init()', 'rclpy.init(args=args)')],
        [("if __name__ == '__main__':\n    main()", "IS_PROGRAM = __name__ == '__main__'\nif IS_PROGRAM:\n    main()")],
        [("if __name__ == '__main__':\n    main()", "if __name__ != '__main__':\n    pass\nelse:\n    raise SystemExit("
          'main())')],
    ],
}
