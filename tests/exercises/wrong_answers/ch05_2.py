"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 5.2."""

# Lines of the solutions, which the answers replace.
_REGISTER_JUDGE = '        self.add_on_set_parameters_callback(self.validate)\n'
_REGISTER_REACT = '        self.add_post_set_parameters_callback(self.react)\n'
_AT_THE_START = '        self.react([])  # for the values that the heater starts with\n'
_START = ("        start = self.validate(self.get_parameters(['low_c', 'high_c']))\n        if not start.successful:\n"
          '            raise ValueError(start.reason)\n')
_ACCEPTED = '        return SetParametersResult(successful=True)'
_REJECTED = "return SetParametersResult(successful=False, reason=f'{low_c} is not below {high_c}')"
_PROPOSED = 'proposed = {parameter.name: parameter.value for parameter in parameters}'
_REACT = "self.target_c = (self.get_parameter('low_c').value + self.get_parameter('high_c').value) / 2"
_EACH = 'for parameter in parameters:\n'
_KNOWN = "if parameter.name in ('open_percent', 'force_percent') and not 0"
_SKIP = "            if parameter.name not in ('open_percent', 'force_percent'):\n                continue\n"
_MOTOR = "        self.motor_percent = self.get_parameter('open_percent').value"
_MOTOR_REACT = f'def react(self, parameters):\n{_MOTOR}'

_LATE = '        return SetParametersResult(successful'
_NO_REACT = ('        self.add_post_set_parameters_callback(self.react)\n', '')
_LATER = 'in the call that stores it, and follows later'
_PROPOSAL = 'an on-set callback has only a proposal'

WRONG = {
    '5.2a': [
        ([(_REGISTER_JUDGE, '')], 4, 'No callback of yours is asked'),
        ([(_PROPOSED, 'proposed = {parameters[0].name: parameters[0].value}')], 4, 'it was accepted'),  # one of two
        ([('add_post_set_parameters_callback(self.react)', 'add_on_set_parameters_callback(self.judge_late)'),
          (_AT_THE_START, '        self.judge_late([])\n'),
          ('def react(self, parameters):', 'def judge_late(self, parameters):'),
          ('.value) / 2', '.value) / 2\n        return SetParametersResult(successful=True)')], 4, 'it is `20.0`'),
        # Acts in time, with what it noted in the judge.
        ([(_ACCEPTED, f'        self.noted = (low_c + high_c) / 2\n{_ACCEPTED}'),
          (_AT_THE_START, '        self.noted = 20\n        self.react([])\n'), (_REACT, 'self.target_c = self.noted')],
         5, 'That is the middle of the defaults'),
        # Nobody judges the start.
        ([(_START, '')], 5, 'it started, with `low_c = 30` and `high_c = 22`'),
        # Acts in the judge: with the proposed values, which may still be rejected, and with the stored, which are old.
        ([(_ACCEPTED, f'        self.target_c = (low_c + high_c) / 2\n{_ACCEPTED}')], 5,
         'a side effect of an on-set callback'),
        ([("reason=f'{low_c} is not below {high_c}'", "reason=''")], 4, 'the reason is empty'),
        ([("self.get_parameter('low_c').value)\n", '18)\n'), ("self.get_parameter('high_c').value)\n", '22)\n')],
         5, 'the limit that is stored at that moment'),  # held against the defaults
        ([(_ACCEPTED, f'        self.noted.update(proposed)\n{_ACCEPTED}'),
          (_START, "        self.noted = {n: self.get_parameter(n).value for n in ('low_c', 'high_c')}\n"
                   f'{_START}'),
          (_REACT, "self.target_c = (self.noted['low_c'] + self.noted['high_c']) / 2")], 5,
         'a value that was rejected has come through'),
        # Follows by an event, which the handler of rclpy or a subscription brings, or by a timer: each is late.
        ([(_REGISTER_REACT, '        from rclpy.parameter_event_handler import ParameterEventHandler\n'
           '        self.handler = ParameterEventHandler(self)\n'
           '        self.kept = self.handler.add_parameter_event_callback(self.react)\n')], 4, _LATER),
        ([(_REGISTER_REACT, "        from rcl_interfaces.msg import ParameterEvent\n"
           "        self.create_subscription(ParameterEvent, '/parameter_events', self.react, 10)\n")], 4, _LATER),
        ([(_REGISTER_REACT, '        self.create_timer(0.0001, lambda: self.react([]))\n')], 4, 'it is `20.0`'),
        ([(_REACT, f'self.executor.create_task(self.later)\n\n    def later(self):\n        {_REACT}'),
          (_AT_THE_START, '        self.later()\n')], 4, 'it is `20.0`'),
        ([(_REACT, _REACT.replace(' / 2', ' // 2'))], 4, 'it is `27`'),
        ([(_REACT, 'low_c, high_c = [p.value for p in parameters] or (18, 22)\n'
                   '        self.target_c = (low_c + high_c) / 2')],
         0, 'ValueError: not enough values to unpack'),
        ([('self.target_c = (', 'self.target = (')], 3, 'it is `None`'),
        ([(_START, ''), (_ACCEPTED, '        return True')], 0, 'has to return a `SetParametersResult`'),
        ([(_ACCEPTED, '        return True')], 0, "'bool' object has no attribute 'successful'"),
        ([(_REJECTED, 'return False')], 4, 'the reason is rclpy’s own'),
        ([(_REJECTED, "raise ValueError('not below')")], 0, 'a callback raised ValueError: not below'),
        ([(_REJECTED, 'input()')], 0, 'a callback cannot ask with input()'),
        ([("proposed.keys() & {'low_c', 'high_c'} and", "parameters[0].name == 'use_sim_time' or")], 5,
         '-3 is not below 12'),
        ([("reason=f'{low_c} is not below {high_c}'", 'reason=low_c')], 0, 'TypeError'),
        ([('low_c >= high_c', 'low_c >= high_c or high_c > 40')], 2, 'it was rejected'),  # a rule too many
        # Starts right, and then adds a new limit to the default of the other one.
        ([(_AT_THE_START, f"{_AT_THE_START}        self.limits = {{'low_c': 18, 'high_c': 22}}\n"),
          (_REACT, 'if parameters:\n            self.limits.update({p.name: p.value for p in parameters})\n'
                   "            self.target_c = (self.limits['low_c'] + self.limits['high_c']) / 2\n"
                   f'        else:\n            {_REACT}')], 5, 'not its default'),
    ],
    '5.2b': [
        ([("reason=f'{parameter.value} is not a percentage'", "reason=''")], 2, 'the reason is empty'),
        ([(_EACH, _EACH.replace('parameters:', 'parameters[:1]:'))], 3, 'it was accepted'),
        # Judges everybody's parameters.
        ([(_KNOWN, 'if not 0')], 3, 'The callback is called for them, too'),
        ([(_ACCEPTED, "        self.motor_percent = {p.name: p.value for p in parameters}.get('open_percent', 50)\n"
                      f'{_ACCEPTED}')], 3, 'a side effect of an on-set callback'),
        ([('0 <= parameter.value <= 100', '0 < parameter.value <= 100')], 2, 'it was rejected: 0 is not a percentage'),
        ([('0 <= parameter.value <= 100', '0 <= parameter.value < 100')], 3, '100 is not a percentage'),
        ([(_KNOWN, "if parameter.name == 'open_percent' and not 0")], 2, 'it was accepted'),
        ([(_KNOWN, 'if type(parameter.value) is int and not 0')], 3, 'The callback is called for them, too'),
        ([(_KNOWN, "if parameter.name not in ('open_percent', 'force_percent') or not 0")], 3, 'called for them, too'),
        ([(_MOTOR, '        self.motor_percent = parameters[0].value if parameters else 0')], 0,
         "NameError: name 'parameters'"),
        ([(_MOTOR_REACT,
           'def react(self, parameters):\n        self.motor_percent = parameters[0].value\n')], 3, 'it is `20`'),
        ([('self.motor_percent = self', 'self.motor = self')], 3, 'it is `None`'),
        ([(_REGISTER_REACT, "        from rcl_interfaces.msg import ParameterEvent\n"
           "        self.create_subscription(ParameterEvent, '/parameter_events', self.react, 10)\n")], 3, _LATER),
        ([('            if parameter.name', '            from rcl_interfaces.msg import ParameterType\n'
           '            if parameter.type_ != ParameterType.PARAMETER_INTEGER:\n'
           "                return SetParametersResult(successful=False, reason='not an integer')\n"
           '            if parameter.name')], 0, 'look at what the comparison compares'),
        ([(_MOTOR_REACT,
           f'def react(self, parameters):\n        import rclpy\n        rclpy.spin_once(self)\n{_MOTOR}')],
         0, 'this callback already runs inside the executor that it waits for'),
        ([("'force_percent', 50", "'force_percent', 50, __import__('rcl_interfaces.msg').msg.ParameterDescriptor("
           'dynamic_typing=True)')], 0, 'a callback raised TypeError'),
        ([("'force_percent', 50", "'force_percent', 100")], 3, 'type integer, value `100`'),
    ],
    '5.2c': [
        ([('dbeca', 'bdeca')], 3, 'called its pre-set callback, and then rejected'),
        ([('dbeca', 'debca')], 3, 'never called its on-set callback'),
        ([('dbeca', 'dbcea')], 3, 'still held 100'),
        ([('dbeca', 'dbeac')], 3, 'held 150'),
        ([('dbeca', 'dbec')], 0, "your order is `'dbec'`"),
        ([('dbeca', 'dbecaa')], 0, "your order is `'dbecaa'`"),
        ([("'dbeca'", '12345')], 0, 'the check was given `12345`'),
    ],
    '5.2d': [
        ([('0 <= floor', '1 <= floor')], 0, 'there is no floor 0: the top floor is 5'),
        ([('return SetParametersResult(successful=not reason, reason=reason)', 'return not reason')], 1,
         'An on-set callback has to return a `SetParametersResult`'),
        ([('            raise ValueError(reason)', '            self.get_logger().error(reason)')], 6,
         'never sees the start values'),
        ([('        return SetParametersResult(successful', '        self.react(parameters)\n        return '
           'SetParametersResult(successful')], 6, 'an on-set callback has only a proposal'),
        ([('(KeyboardInterrupt, ExternalShutdownException)', 'KeyboardInterrupt')], 6, 'That is what SIGTERM raises'),
        ([('floor <= top_floor', 'floor < top_floor')], 5, 'there is no floor 5: the top floor is 5'),
        ([('0 <= floor <= top_floor', 'floor <= top_floor')], 5, 'it was accepted'),
        ([("proposed.get('top_floor', self.get_parameter('top_floor').value)",
           "self.get_parameter('top_floor').value")], 5, 'it was accepted'),
        ([('        self.add_on_set_parameters_callback(self.validate)\n', '')], 4, 'it was accepted'),
        # It logs no rejected floor, and still too early: there, by a constant, and by a helper of a helper.
        ([(_LATE, '        if not reason:\n            self.react(parameters)\n' + _LATE), _NO_REACT], 6, _PROPOSAL),
        ([(_LATE, '        if not reason:\n            self.react(parameters)\n' + _LATE), _NO_REACT,
          ('    def __init__', "    WORDS = 'going to floor'\n\n    def __init__"),
          ("f'going to floor {parameter.value}'", "f'{self.WORDS} {parameter.value}'")], 6, _PROPOSAL),
        ([(_LATE, '        if not reason:\n            self.tell(parameters)\n' + _LATE), _NO_REACT,
          ('    def react', '    def tell(self, parameters):\n        self.react(parameters)\n\n    def react')],
         6, _PROPOSAL),
        ([(_LATE, "        for p in parameters:\n            if p.name == 'floor' and not reason:\n"
                  "                print('going to floor', p.value)\n" + _LATE), _NO_REACT], 6, _PROPOSAL),
        ([('add_on_set_parameters_callback(self.validate)', 'add_pre_set_parameters_callback(self.early)'),
          ('    def react', '    def early(self, parameters):\n        if self.validate(parameters).successful:\n'
           '            self.react(parameters)\n            return parameters\n        return []\n\n    def react'),
          _NO_REACT], 6, _PROPOSAL),
        # It logs what has not changed, what the exercise's text says, and in other words.
        ([("            if parameter.name == 'floor':\n                self.get_logger().info(f'going to floor "
           "{parameter.value}')", "            self.get_logger().info(f'going to floor "
           """{self.get_parameter("floor").value}')""")], 6, 'there is one more that begins with `'),
        ([("if parameter.name == 'floor':", 'if True:')], 6,
         'there is one more that begins with `'),
        ([('going to floor {parameter.value}', 'going to floor 3')], 6, 'going to floor 3'),
        ([('going to floor {parameter.value}', 'going to {parameter.value}')], 6, 'going to 1'),
        # It starts below the ground.
        ([('        reason = self.objection({})', "        reason = self.objection({}) if self.get_parameter('floor')"
           ".value > 0 else ''")], 6, 'never sees the start values'),
        ([('        self.add_post_set_parameters_callback(self.react)\n', '')], 6, 'it prints nothing'),
        ([('reason=reason)', "reason='')")], 4, 'the reason is empty'),
        ([('{p.name: p.value for', '{p.name: p.valeu for')], 1, 'in line 25, `reason = '),
        ([('raise ValueError(reason)', 'raise SystemExit')], 6, 'it ended with exit status 0'),
        ([("'elevator'", "'lift'")], 7, 'it is called `lift`'),
    ],
}

RIGHT = {
    '5.2a': [
        # The judge is registered first, and knows that it is asked by the declarations too.
        [(f'{_REGISTER_JUDGE}{_REGISTER_REACT}', _REGISTER_REACT),
         ("        self.declare_parameter('low_c', 18)\n",
          f"{_REGISTER_JUDGE}        self.declare_parameter('low_c', 18)\n"),
         ("self.get_parameter('low_c').value)\n", "self.get_parameter_or('low_c', Parameter('', value=-99)).value)\n"),
         ("self.get_parameter('high_c').value)\n", "self.get_parameter_or('high_c', Parameter('', value=99)).value)\n"),
         ('class Heater', 'from rclpy.parameter import Parameter\n\n\nclass Heater')],
        # target_c is worked out when somebody looks at it.
        [(_REGISTER_REACT, ''), (_AT_THE_START, ''),
         ('    def react(self, parameters):\n        self.target_c =',
          '    @property\n    def target_c(self):\n        return')],
        # By two callbacks, one for each name.
        [(_REGISTER_REACT, "        for name in ('low_c', 'high_c'):\n            self.add_post_set_"
          'parameters_callback(lambda ps, name=name: self.react(ps) if name in [p.name for p in ps] else None)\n')],
        # By what sets it, from inside or outside.
        [(_REGISTER_REACT, ''),
         ('    def react', '    def set_parameters_atomically(self, parameters):\n        result = super()'
          '.set_parameters_atomically(parameters)\n        self.react([])\n        return result\n\n    def react')],
        # It judges before anything is checked; an empty list is a rejection.
        [('add_on_set_parameters_callback(self.validate)', 'add_pre_set_parameters_callback(self.validate)'),
         (_START, "        if not self.validate(self.get_parameters(['low_c', 'high_c'])):\n"
                  "            raise ValueError('not below')\n"),
         (_REJECTED, 'return []'), (_ACCEPTED, '        return parameters')],
        [(_PROPOSED, 'proposed = {}\n        for parameter in parameters:\n'
                     '            proposed[parameter.name] = parameter.get_parameter_value().integer_value'),
         (f'            {_REJECTED}\n{_ACCEPTED}',
          "            result = SetParametersResult()\n            result.reason = 'no'\n            return result\n"
          f'{_ACCEPTED}')],
        [(_REACT, "low, high = self.get_parameters(['low_c', 'high_c'])\n"
                  '        self.target_c = low.value + (high.value - low.value) * 0.5')],
    ],
    '5.2b': [
        # The right comparison of the types.
        [('            if parameter.name', f'{_SKIP}            from rclpy.parameter import Parameter\n'
          '            if parameter.type_ != Parameter.Type.INTEGER:\n'
          "                return SetParametersResult(successful=False, reason='not an integer')\n"
          '            if parameter.name')],
        [('            if parameter.name', f'{_SKIP}            from rcl_interfaces.msg import ParameterType\n'
          '            if parameter.type_.value != ParameterType.PARAMETER_INTEGER:\n'
          "                return SetParametersResult(successful=False, reason='not an integer')\n"
          '            if parameter.name')],
        # A range in place of the callback.
        [("'open_percent', 0)", "'open_percent', 0, PERCENT)"),
         ("'force_percent', 50)", "'force_percent', 50, PERCENT)"),
         ('class Door', 'from rcl_interfaces.msg import IntegerRange, ParameterDescriptor\n\n'
          'PERCENT = ParameterDescriptor(integer_range=[IntegerRange(from_value=0, to_value=100, step=1)])\n\n\n'
          'class Door'), (_REGISTER_JUDGE, '')],
        [(_MOTOR_REACT,
          "def react(self, parameters):\n        for parameter in parameters:\n"
          "            if parameter.name == 'open_percent':\n                self.motor_percent = parameter.value\n")],
    ],
    '5.2c': [
        [('dbeca', 'D, B, E, C, A')],
        [('dbeca', 'd > b > e > c > a')],
        [("'dbeca'", "'''d\nb\ne\nc\na'''")],
        [("'dbeca'", "('d', 'b', 'e', 'c', 'a')")],
    ],
    '5.2d': [
        [('raise ValueError(reason)', 'raise SystemExit(reason)')],
        [("self.get_logger().info(f'going to floor {parameter.value}')",
          "print('going to floor', parameter.value)")],
        # A callback that is there before the declarations judges the start as well.
        [('        reason = self.objection({})\n        if reason:\n            raise ValueError(reason)\n'
          '        self.add_on_set_parameters_callback(self.validate)\n', ''),
         ("        self.declare_parameter('floor', 0)\n        self.declare_parameter('top_floor', 5)\n",
          "        self.add_on_set_parameters_callback(self.validate)\n        self.declare_parameter('top_floor', 5)\n"
          "        self.declare_parameter('floor', 0)\n"),
         ("proposed.get('floor', self.get_parameter('floor').value)",
          "proposed.get('floor', self.get_parameter_or('floor', Parameter('floor', value=0)).value)"),
         ("proposed.get('top_floor', self.get_parameter('top_floor').value)",
          "proposed.get('top_floor', self.get_parameter_or('top_floor', Parameter('top_floor', value=5)).value)"),
         ('import Node\n', 'import Node\nfrom rclpy.parameter import Parameter\n')],
        [('        pass', '        print()')],
        # The reason begins like the line, and is logged; so is the start; and there is more in the line.
        [("f'there is no floor {floor}: the top floor is {top_floor}'",
          "f'going to floor {floor} is impossible: the top is {top_floor}'"),
         ('        return SetParametersResult(successful', '        if reason:\n            self.get_logger().info('
          'reason)\n        return SetParametersResult(successful')],
        [('        self.add_on_set', "        self.get_logger().info('going to floor 0')\n        self.add_on_set"),
         ('{parameter.value}', '{parameter.value} of {self.get_parameter("top_floor").value}')],
        [("f'there is no floor {floor}: the top floor is {top_floor}'", "f'not going to floor {floor}'")],
        [('{p.name: p.value for p in parameters})', "{p.name: p.value for p in parameters})\n"
          "        self.get_logger().debug('somebody asks for going to floor …')")],
        [('import rclpy\n', '"""An elevator."""\n\nfrom __future__ import annotations\n\nimport rclpy\n')],
        # It tells of a floor only if that is another one.
        [("if parameter.name == 'floor':", "if parameter.name == 'floor' and parameter.value != "
          "getattr(self, 'last', None):\n                self.last = parameter.value")],
    ],
}
