"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 5.2."""

# Lines of the steps and the solution, which the answers replace.
_REGISTER = '        self.add_on_set_parameters_callback(self.judge)\n'
_REGISTER_ACT = '        self.add_post_set_parameters_callback(self.act)\n'
_DECLARE = "        self.declare_parameter('max_speed_mps'"
_NEW = 'new = {parameter.name: parameter.value for parameter in parameters}'
_SPEED = "new.get('max_speed_mps', self.get_parameter('max_speed_mps').value)"
_STOP = "new.get('stop_distance_m', self.get_parameter('stop_distance_m').value)"
_REASON = "reason=f'{speed_mps} m/s takes {braking_m:.2f} m to brake, not {stop_m} m'"
_REJECTED = f'return SetParametersResult(\n                successful=False, {_REASON})'
_ACCEPTED = '        return SetParametersResult(successful=True)\n'
_START = ("        start = self.judge(self.get_parameters(['max_speed_mps', 'stop_distance_m']))\n"
          '        if not start.successful:\n            raise ValueError(start.reason)\n')
_LOG = "self.get_logger().info(f'max_speed_mps is now {parameter.value}')"
_IF_SPEED = "            if parameter.name == 'max_speed_mps':\n"
_MOTOR = "        self.motor_percent = self.get_parameter('open_percent').value"
_MOTOR_ACT = f'def act(self, parameters):\n{_MOTOR}'
_KNOWN = "if parameter.name in ('open_percent', 'force_percent') and not 0"
_EACH = 'for parameter in parameters:\n'
_LATER = 'in the call that stores it, and follows later'
_PROPOSAL = 'an on-set callback has only a proposal'
# What a driver keeps of a proposal, and drives with.
_KEEPS = [('        command = Twist()\n', '        command = Twist()\n        self.get_parameter = self.kept\n'),
          ('    def drive(', '    def kept(self, name):\n        from rclpy.parameter import Parameter\n'
           "        return Parameter(name, value=self.speed_mps) if name == 'max_speed_mps' else Node.get_parameter("
           'self, name)\n\n    def drive('),
          (_REGISTER, f'        self.speed_mps = 0.5\n{_REGISTER}')]

WRONG = {
    '5.2a': [
        ([(_REGISTER, '')], 0, 'No callback of yours is asked'),
        ([('stop_distance_m', 'stop_m')], 0, 'the node lacks one'),
        # Judges the value alone, or holds it against the default of the other one.
        ([(_STOP, '0.5')], 0, 'What counts for the other value is what is stored'),
        # Ignores the other value of the same request.
        ([(_STOP, "self.get_parameter('stop_distance_m').value if 'max_speed_mps' in new else new.get("
                  "'stop_distance_m', 0.5)")], 3, 'has to be compared with the other proposed one'),
        ([(_ACCEPTED, f'        self.speed_mps = speed_mps\n{_ACCEPTED}'), *_KEEPS], 3, 'it is 0.3'),
        ([(_STOP, "new.get('stop_distance_m', 0.5)"), (_SPEED, "new.get('max_speed_mps', 0.5)")], 3,
         'What counts for the other value'),
        ([(_NEW, 'new = {parameters[0].name: parameters[0].value}')], 3, 'with the other proposed one'),
        ([(_REASON, "reason=''")], 0, 'the reason is empty'),
        ([(_ACCEPTED, '')], 0, 'has to return a `SetParametersResult`'),
        ([(_ACCEPTED, '        return True\n')], 0, 'has to return a `SetParametersResult`'),
        ([(_REJECTED, 'return False')], 0, 'the reason is rclpy’s own'),
        ([(_REJECTED, "raise ValueError('too fast')")], 0, 'a callback raised ValueError: too fast'),
        ([(_REGISTER, ''), (_DECLARE, _REGISTER + _DECLARE)], 0, 'is asked about each of them'),
        ([('speed_mps ** 2 / 2', 'speed_mps ** 2')], 0, 'it was rejected: 0.8 m/s takes 0.64 m'),
        ([('braking_m > stop_m', 'braking_m < stop_m')], 0, 'it was rejected: 0.8 m/s takes 0.32 m'),
        ([(_REGISTER, _REGISTER.replace('self.judge', 'self.judge()'))], 0, 'without parentheses'),
        ([(_REGISTER, _REGISTER.replace('on_set', 'pre_set'))], 0, 'A pre-set callback returns a list'),
        ([(_REGISTER, _REGISTER.replace('on_set', 'post_set'))], 0, 'No callback of yours is asked'),
        ([('parameter.name: parameter.value', 'parameter.name: parameter')], 0, 'TypeError'),
        ([(_SPEED, "new['max_speed_mps']")], 0, "a callback raised KeyError: 'max_speed_mps'"),
    ],
    '5.2b': [
        ([(_START, '')], 3, 'it started, with `max_speed_mps = 2.0` and `stop_distance_m = 0.5`'),
        ([(_REGISTER, '')], 1, 'No callback of yours is asked'),
        ([(_REGISTER_ACT, '')], 3, 'it logs no line of that kind'),
        ([(_ACCEPTED, f'        self.speed_mps = speed_mps\n{_ACCEPTED}'), *_KEEPS], 3, 'it is 0.3'),
        # Logs in the judge: all proposals, or those that it accepts.
        ([(_REGISTER_ACT, ''), (f'        {_NEW}\n', f'        {_NEW}\n        self.act(parameters)\n')], 3, _PROPOSAL),
        ([(_REGISTER_ACT, ''), (_ACCEPTED, f'        self.act(parameters)\n{_ACCEPTED}')], 3,
         'it logs `max_speed_mps is now 0.7`'),
        ([(_IF_SPEED, '            if True:\n')], 3, 'it logs `max_speed_mps is now 0.9`'),
        ([('{parameter.value}', '0.8')], 3, 'the last line of that kind is'),
        ([(_LOG, "self.get_logger().info(f'{parameter.value} now')")], 3, 'it logs no line of that kind'),
        ([('            raise ValueError(start.reason)', '            self.get_logger().error(start.reason)')], 3,
         'it started, with'),
        ([('raise ValueError(start.reason)', 'self.set_parameters([])')], 3, 'it started, with'),
        ([('raise ValueError', 'raise SystemExit')], 3, 'its constructor did not finish. SystemExit: 2.0 m/s takes'),
        # Looks at the first parameter of a request alone.
        ([(f'{_EACH}{_IF_SPEED}', f'{_EACH}{_IF_SPEED}'.replace('parameters:', 'parameters[:1]:'))], 3,
         'the last line of that kind is `max_speed_mps is now 0.8`'),
        # Its judge is asked by the declarations, before there is a second parameter.
        ([(_START, ''), (_REGISTER, ''), (_DECLARE, _REGISTER + _DECLARE)], 0, 'is asked about each of them'),
        ([("['max_speed_mps', 'stop_distance_m']", "['max_speed']")], 0, 'ParameterNotDeclaredException'),
    ],
    '5.2c': [
        ([("reason=f'{parameter.value} is not a percentage'", "reason=''")], 2, 'the reason is empty'),
        ([(_EACH, _EACH.replace('parameters:', 'parameters[:1]:'))], 2, 'it was accepted'),
        # Judges everybody's parameters.
        ([(_KNOWN, 'if not 0')], 2, 'The callback is called for them, too'),
        ([(_ACCEPTED, "        self.motor_percent = {p.name: p.value for p in parameters}.get('open_percent', 50)\n"
                      f'{_ACCEPTED}')], 2, 'a side effect of an on-set callback'),
        ([('0 <= parameter.value <= 100', '0 < parameter.value <= 100')], 0, 'it was rejected: 0 is not a percentage'),
        ([('0 <= parameter.value <= 100', '0 <= parameter.value < 100')], 0, '100 is not a percentage'),
        ([(_KNOWN, "if parameter.name == 'open_percent' and not 0")], 2, 'it was accepted'),
        ([("__init__('door'", "__init__('door', start_parameter_services=False")], 0, 'it has no services for'),
        ([(_KNOWN, 'if type(parameter.value) is int and not 0')], 2, 'The callback is called for them, too'),
        ([(_KNOWN, "if parameter.name not in ('open_percent', 'force_percent') or not 0")], 2, 'called for them, too'),
        ([(_MOTOR, '        self.motor_percent = parameters[0].value if parameters else 0')], 0,
         "NameError: name 'parameters'"),
        ([(_MOTOR_ACT, 'def act(self, parameters):\n        self.motor_percent = parameters[0].value\n')], 2,
         'it is `20`'),
        ([('self.motor_percent = self', 'self.motor = self')], 2, 'it is `None`'),
        # Follows by an event, which the handler of rclpy or a subscription brings, or by a timer: each is late.
        ([(_REGISTER_ACT, '        from rclpy.parameter_event_handler import ParameterEventHandler\n'
           '        self.handler = ParameterEventHandler(self)\n'
           '        self.kept = self.handler.add_parameter_event_callback(self.act)\n')], 2, _LATER),
        ([(_REGISTER_ACT, "        from rcl_interfaces.msg import ParameterEvent\n"
           "        self.create_subscription(ParameterEvent, '/parameter_events', self.act, 10)\n")], 2, _LATER),
        ([(_REGISTER_ACT, '        self.create_timer(0.0001, lambda: self.act([]))\n')], 2, 'it is `0`'),
        ([(_MOTOR_ACT,
           f'def act(self, parameters):\n        import rclpy\n        rclpy.spin_once(self)\n{_MOTOR}')],
         0, 'this callback already runs inside the executor that it waits for'),
        ([("'force_percent', 50", "'force_percent', 50, __import__('rcl_interfaces.msg').msg.ParameterDescriptor("
           'dynamic_typing=True)')], 0, 'a callback raised TypeError'),
        ([("'force_percent', 50", "'force_percent', 100")], 2, 'type integer, value `100`'),
        ([(f'            {_KNOWN}', '            input()\n            if not 0')], 0,
         'a callback cannot ask with input()'),
    ],
}

RIGHT = {
    '5.2a': [
        # With a reserve for the time in which it notices.
        [('/ BRAKING_MPS2', '/ BRAKING_MPS2 + 0.2 * speed_mps')],
        [('braking_m > stop_m', 'braking_m >= stop_m')],
        # It asks only about its own two.
        [(f'        {_NEW}\n', f'        {_NEW}\n        if not new.keys() & {{"max_speed_mps", "stop_distance_m"}}:\n'
          '            return SetParametersResult(successful=True)\n')],
        # The judge is registered first, and knows that it is asked by the declarations too.
        [(_REGISTER, ''), (_DECLARE, _REGISTER + _DECLARE),
         (_SPEED, "new.get('max_speed_mps', self.get_parameter_or('max_speed_mps', Parameter('', value=0.0)).value)"),
         (_STOP, "new.get('stop_distance_m', self.get_parameter_or('stop_distance_m', Parameter('', value=9.0)).value)"
          ),
         ('import Node\n', 'import Node\nfrom rclpy.parameter import Parameter\n')],
        [(f'            {_REJECTED}\n{_ACCEPTED}',
          "            result = SetParametersResult()\n            result.reason = 'no'\n            return result\n"
          f'{_ACCEPTED}')],
    ],
    '5.2b': [
        [(_LOG, "self.get_logger().warning(f'Driver: max_speed_mps is now {parameter.value} m/s')")],
        [(_IF_SPEED, ''), (f'                {_LOG}', "            self.get_logger().info(f'{parameter.name} is now "
                                                     "{parameter.value}')")],
        [(_REGISTER_ACT, f'{_REGISTER_ACT}        self.act(self.get_parameters(["max_speed_mps"]))\n')],
        # The judge logs what it rejects, in its own words.
        [(f'            {_REJECTED}', f"            self.get_logger().warning('too fast')\n            {_REJECTED}")],
    ],
    '5.2c': [
        # A range in place of the callback.
        [("'open_percent', 0)", "'open_percent', 0, PERCENT)"),
         ("'force_percent', 50)", "'force_percent', 50, PERCENT)"),
         ('class Door', 'from rcl_interfaces.msg import IntegerRange, ParameterDescriptor\n\n'
          'PERCENT = ParameterDescriptor(integer_range=[IntegerRange(from_value=0, to_value=100, step=1)])\n\n\n'
          'class Door'), (_REGISTER, '')],
        [(_MOTOR_ACT,
          "def act(self, parameters):\n        for parameter in parameters:\n"
          "            if parameter.name == 'open_percent':\n                self.motor_percent = parameter.value\n")],
        # The motor is worked out when somebody looks at it.
        [(_REGISTER_ACT, ''), (f'{_MOTOR}\n        self.add_on', '        self.add_on'),
         (f'    {_MOTOR_ACT}', '    @property\n    def motor_percent(self):\n        return self.get_parameter('
          "'open_percent').value")],
        # By what sets it, from inside or outside.
        [(_REGISTER_ACT, ''),
         ('    def act', '    def set_parameters_atomically(self, parameters):\n        result = super()'
          '.set_parameters_atomically(parameters)\n        self.act([])\n        return result\n\n    def act')],
    ],
}
