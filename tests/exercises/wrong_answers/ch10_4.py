"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 10.4."""

_CALL = ("Rules(self).matches('call_sign', '[A-Z]{3}').one_of('mode', ['hover', 'track', 'land']).check(\n"
         "            ['land_percent', 'home_percent'], lambda land, home: land < home,\n"
         "            'land_percent must be below home_percent')")
_BY_HAND = """import re
        self.add_on_set_parameters_callback(self.judge)
        result = self.judge([self.get_parameter(name) for name in ('call_sign', 'mode', 'land_percent')])
        if not result.successful:
            raise ValueError(result.reason)

    def judge(self, parameters):
        import re
        from rcl_interfaces.msg import SetParametersResult
        after = {name: self.get_parameter(name).value
                 for name in ('call_sign', 'mode', 'land_percent', 'home_percent')}
        after.update((p.name, p.value) for p in parameters)
        reason = ''
        if not re.fullmatch('[A-Z][A-Z][A-Z]', after['call_sign']):
            reason = 'no call sign'
        elif after['mode'] not in ('hover', 'track', 'land'):
            reason = 'no mode'
        elif not after['land_percent'] < after['home_percent']:
            reason = 'lands first'
        return SetParametersResult(successful=not reason, reason=reason)"""
_ALIASES = "Aliases(self, {'width': 'width_mm', 'plate': 'plate_number'})"
_NAMES = "Aliases(self, {'speed': 'speed_mmps', 'limit': 'limit_mmps'})"
_RULE = ("Rules(self).check(['speed_mmps', 'limit_mmps'], lambda speed, limit: speed <= limit,\n"
         "                          'speed_mmps must not be above limit_mmps')")
_DECLARED = """        self.declare_parameter('speed_mmps', 100)
        self.declare_parameter('limit_mmps', 500)
"""

WRONG = {
    '10.4a': [
        ([("'[A-Z]{3}'", "'[A-Z]{3}.*'")], 3, 'it was accepted'),
        ([("'mode', 'hover'", "'mode', 'land'")], 3, "it is `'land'`"),
        ([("'land_percent', 10", "'land_percent', 5")], 3, 'it is `5`'),
        # In a callback only, and with a return in the loop.
        ([(_CALL, _BY_HAND.replace('            raise ValueError(result.reason)', '            pass'))], 3,
         'it started'),
        ([("['hover', 'track', 'land']", "['hover', 'track']")], 3, 'must be one of'),
        ([(".one_of('mode', ['hover', 'track', 'land'])", ".matches('mode', '.*(hover|track|land).*')")], 3,
         'it was accepted'),
        ([('lambda land, home: land < home', 'lambda land, home: land <= home')], 3, 'it was accepted'),
        ([('lambda land, home: land < home', 'lambda home, land: land < home')], 0, 'land_percent must be below'),
        ([('Rules(self).matches', 'Rules(self).match')], 0, "no attribute 'match'"),
        ([("['hover', 'track', 'land']", "'hover'")], 0, 'give a list of at least one choice'),
        ([(_CALL, _BY_HAND.replace('after.update((p.name, p.value) for p in parameters)',
                                   'after[parameters[0].name] = parameters[0].value'))], 2, 'it was accepted'),
        ([(_CALL, _BY_HAND.replace('after.update((p.name, p.value) for p in parameters)', ''))], 1, 'it was accepted'),
        ([(_CALL, _BY_HAND.replace('after.update', 'after.updat'))], 0, "no attribute 'updat'"),
        ([("super().__init__('drone')", "super().__init__('drone')\n        import time; time.sleep(1000)")], 0,
         'was still running'),
    ],
    '10.4b': [
        ([(f'        {_ALIASES}\n', '')], 0, 'there are only `width_mm`, `plate_number`'),
        # The mirror of the chapter: it takes a contradiction, and the plate keeps its start value for itself.
        ([(_ALIASES, """from rclpy.parameter import Parameter
        old = self.declare_parameter('width', 800)
        self.declare_parameter('plate', 'none', ParameterDescriptor(read_only=True))
        self.add_pre_set_parameters_callback(lambda parameters: [
            Parameter(name, value=p.value) for p in parameters
            for name in (('width', 'width_mm') if p.name in ('width', 'width_mm') else [p.name])])""")], 2,
         'it is `'),
        ([(', ParameterDescriptor(read_only=True)', '')], 4, 'it could be set'),
        # The wrong way round: those who use the new names are warned.
        ([(_ALIASES, "Aliases(self, {'width_mm': 'width', 'plate_number': 'plate'})"),
          ("'width_mm', 800", "'width', 800"), ("'plate_number', 'none'", "'plate', 'none'")], 4, 'there is none'),
        ([(_ALIASES, "Aliases(self, {'width_mm': 'width', 'plate_number': 'plate'})")], 0, 'is an old name of'),
        ([(f'        {_ALIASES}\n', ''), ('read_only=True))', f'read_only=True))\n        {_ALIASES}')], 0,
         'before the first declaration'),
        # Both declared, and no alias: they do not follow one another.
        ([(_ALIASES, "self.declare_parameters('', [('width', 800), ('plate', 'none')])")], 0, 'it is `800`'),
        ([(", 'plate': 'plate_number'", '')], 0, 'there are only `width_mm`, `width`, `plate_number`'),
        ([("'width_mm', 800", "'width_mm', 800.0")], 0, 'Wrong parameter type'),
        ([("'wagon'", "'waggon'")], 5, 'it is called `waggon`'),
    ],
    '10.4c': [
        ([(f'        {_NAMES}\n', '')], 0, 'there are only `speed_mmps`, `limit_mmps`'),
        ([(_RULE, 'pass')], 1, 'it was accepted'),
        # Two callbacks that forward: each gets the original request.
        ([(_NAMES, """from rclpy.parameter import Parameter
        self.declare_parameters('', [('speed', 100), ('limit', 500)])
        for names in (('speed', 'speed_mmps'), ('limit', 'limit_mmps')):
            self.add_pre_set_parameters_callback(lambda parameters, names=names: [
                Parameter(name, value=p.value) for p in parameters
                for name in (names if p.name in names else [p.name])])""")], 2, 'it is `100`'),
        ([('speed <= limit', 'speed < limit')], 1, 'speed_mmps must not be above'),
        ([('lambda speed, limit', 'lambda limit, speed')], 0, 'speed_mmps must not be above'),
        ([(f'        {_NAMES}\n', ''), (_DECLARED, f'{_DECLARED}        {_NAMES}\n')], 0, 'before the first'),
        ([(_NAMES, "Aliases(self, {'speed': 'speed_mmps'})")], 0, 'there are only'),
        # The rule before the declarations.
        ([(_RULE, 'pass'), (_DECLARED, f'        {_RULE}\n{_DECLARED}')], 0, 'speed_mmps'),
        # The right limits, for another start.
        ([("'speed_mmps', 100", "'speed_mmps', 100.0"), ("'limit_mmps', 500", "'limit_mmps', 500.0")], 0, 'rejected'),
    ],
}

RIGHT = {
    '10.4a': [
        [(_CALL, _BY_HAND)],
        [("'[A-Z]{3}'", "'^[A-Z][A-Z][A-Z]$'")],
        [(_CALL, """rules = Rules(self)
        rules.check(['home_percent', 'land_percent'], lambda home, land: home > land, 'home first')
        rules.matches('mode', 'hover|track|land')
        rules.check('call_sign', lambda sign: len(sign) == 3 and all('A' <= letter <= 'Z' for letter in sign), 'ABC')
""")],
        [(_CALL, """Rules(self).matches('call_sign', '[A-Z]{3}')
        Rules(self).one_of('mode', ('hover', 'track', 'land'))
        Rules(self).check(('land_percent', 'home_percent'), lambda land, home: not land >= home, 'land below home')
""")],
    ],
    '10.4b': [
        [('        self.declare_parameter', '        _ = self.declare_parameter'),
         ("{'width': 'width_mm', 'plate': 'plate_number'}", "dict(plate='plate_number', width='width_mm')")],
        [(_ALIASES, f'self.aliases = {_ALIASES}'),
         ("self.declare_parameter('width_mm', 800)",
          "self.declare_parameter('width_mm', 800, ParameterDescriptor(description='in mm'))")],
        # By hand, from one end to the other.
        [(_ALIASES, """from rcl_interfaces.msg import SetParametersResult
        from rclpy.parameter import Parameter
        old = self.declare_parameter('width', 800).value
        plate = self.declare_parameter('plate', '', ParameterDescriptor(read_only=True)).value
        for name in ('width', 'plate'):
            if name in self._parameter_overrides:
                self.get_logger().warning(f'{name} has another name now')
        names = ('width_mm', 'width')

        def mirror(parameters):
            if any(p.name == 'width' for p in parameters):
                self.get_logger().warning('width is old')
            return [Parameter(name, value=p.value) for p in parameters
                    for name in (names if p.name in names else [p.name])]

        def judge(parameters):
            found = {p.value for p in parameters if p.name in names}
            return SetParametersResult(successful=len(found) < 2, reason='two widths')

        overrides = self._parameter_overrides
        for one, other in (('plate', 'plate_number'), ('plate_number', 'plate')):
            if one in overrides and other not in overrides:
                overrides[other] = Parameter(other, value=overrides[one].value)
        self.undeclare_parameter('width')
        width = overrides.get('width_mm') or overrides.get('width')
        self.declare_parameter('width', width.value if width else 800, ignore_override=True)"""),
         ("self.declare_parameter('width_mm', 800)", "self.declare_parameter('width_mm', old)"),
         ("self.declare_parameter('plate_number', 'none', ParameterDescriptor(read_only=True))",
          """self.declare_parameter('plate_number', 'none', ParameterDescriptor(read_only=True))
        self._descriptors['plate'].read_only = False
        self.undeclare_parameter('plate')
        self.declare_parameter('plate', 'none', ParameterDescriptor(read_only=True))
        self.add_pre_set_parameters_callback(mirror)
        self.add_on_set_parameters_callback(judge)""")],
    ],
    '10.4c': [
        [("['speed_mmps', 'limit_mmps']", "['speed', 'limit']")],
        [(_RULE, "Rules(self).check(('limit_mmps', 'speed_mmps'), lambda limit, speed: limit >= speed, 'too fast')")],
        [(_DECLARED, "        self.declare_parameters('', [('limit_mmps', 500), ('speed_mmps', 100)])\n")],
        # The rule by hand.
        [(_RULE, """from rcl_interfaces.msg import SetParametersResult
        self.limits = lambda: {name: self.get_parameter(name).value for name in ('speed_mmps', 'limit_mmps')}

        def judge(parameters):
            after = {**self.limits(), **{p.name: p.value for p in parameters}}
            return SetParametersResult(successful=after['speed_mmps'] <= after['limit_mmps'], reason='too fast')

        if not judge([]).successful:
            raise ValueError('too fast')
        self.add_on_set_parameters_callback(judge)""")],
        # Both by hand.
        [(_NAMES, """from rclpy.parameter import Parameter
        pairs = (('speed', 'speed_mmps'), ('limit', 'limit_mmps'))
        names = {name: pair for pair in pairs for name in pair}
        old = [self.declare_parameter(pair[0], default).value for pair, default in zip(pairs, (100, 500))]"""),
         (_DECLARED, """        new = [self.declare_parameter(pair[1], value) for pair, value in zip(pairs, old)]
        self.add_pre_set_parameters_callback(lambda parameters: [
            Parameter(name, value=p.value) for p in parameters for name in names.get(p.name, [p.name])])
        self.set_parameters_atomically(new)
""")],
    ],
}
