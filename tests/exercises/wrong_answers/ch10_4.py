"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 10.4."""

_SIGN = ("        rule(self, ['call_sign'], lambda sign: re.fullmatch('[A-Z]{3}', sign), "
         "'call_sign must be three letters')\n")
_MODE = ("        rule(self, ['mode'], lambda mode: mode in ('hover', 'track', 'land'), "
         "'mode must be hover, track or land')\n")
_ORDER = ("        rule(self, ['land_percent', 'home_percent'], lambda land, home: land < home,\n"
          "             'land_percent must be below home_percent')")
_CALL = _SIGN + _MODE + _ORDER
_BY_HAND = """        import re
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
_WARNING = """        if any(p.name == 'width' for p in parameters):
            self.get_logger().warning('width is deprecated: set width_mm instead')
"""
_JUDGE = '        self.add_on_set_parameters_callback(self.judge)\n'
_TWIN = '        self.add_pre_set_parameters_callback(self.both)\n'

WRONG = {
    '10.4a': [
        ([("'[A-Z]{3}'", "'[A-Z]{3}.*'")], 3, 'it was accepted'),
        ([("'mode', 'hover'), ('land", "'mode', 'land'), ('land")], 3, "it is `'land'`"),
        ([("'land_percent', 10", "'land_percent', 5")], 3, 'it is `5`'),
        # In a callback only, and with a return in the loop.
        ([(_CALL, _BY_HAND.replace('            raise ValueError(result.reason)', '            pass'))], 3,
         'it started'),
        ([("in ('hover', 'track', 'land')", "in ('hover', 'track')")], 3, 'must be hover, track or land'),
        ([("mode in ('hover', 'track', 'land')", "any(each in mode for each in ('hover', 'track', 'land'))")], 3,
         'it was accepted'),
        ([("re.fullmatch('[A-Z]{3}'", "re.match('[A-Z]{3}'")], 3, 'it was accepted'),
        ([('lambda land, home: land < home', 'lambda land, home: land <= home')], 3, 'it was accepted'),
        ([('lambda land, home: land < home', 'lambda home, land: land < home')], 0, 'land_percent must be below'),
        ([(_CALL, _BY_HAND.replace('after.update((p.name, p.value) for p in parameters)',
                                   'after[parameters[0].name] = parameters[0].value'))], 2, 'it was accepted'),
        ([(_CALL, _BY_HAND.replace('after.update((p.name, p.value) for p in parameters)', ''))], 1, 'it was accepted'),
        ([(_CALL, _BY_HAND.replace('after.update', 'after.updat'))], 0, "no attribute 'updat'"),
        ([("super().__init__('drone')", "super().__init__('drone')\n        import time; time.sleep(1000)")], 0,
         'was still running'),
    ],
    '10.4b': [
        # Both declared: they do not follow one another.
        ([(_TWIN, '')], 1, 'it is `800`'),
        ([("self.declare_parameter('width_mm', old.value)", "self.declare_parameter('width_mm', 800)")], 3,
         'it is `800`'),
        # The twin of the chapter: it takes a contradiction.
        ([(_JUDGE, '')], 3, 'it was accepted'),
        ([(_WARNING, '')], 3, 'there is none'),
        ([('        self.set_parameters([new])', '        pass')], 3, 'it is `800`'),
        # The wrong way round: those who use the new name are warned.
        ([("p.name == 'width' for", "p.name == 'width_mm' for")], 3, 'it has `width is'),
        # It forwards, and changes one name only.
        ([("'width_mm', old.value)", "'width_mm', 800)"), ('self.NAMES if p.name in', "['width_mm'] if p.name in")], 2,
         'it is `800`'),
        ([("'width', 800", "'width', 800.0")], 0, 'Wrong parameter type'),
        ([("'wagon'", "'waggon'")], 4, 'it is called `waggon`'),
    ],
}

RIGHT = {
    '10.4a': [
        [(_CALL, _BY_HAND)],
        [("'[A-Z]{3}'", "'^[A-Z][A-Z][A-Z]$'")],
        [('lambda land, home: land < home', 'lambda land, home: not land >= home')],
    ],
    '10.4b': [
        # The new name first, and what was set at the start goes from it to the old one.
        [("old = self.declare_parameter('width', 800)\n        new = self.declare_parameter('width_mm', old.value)",
          """new = self.declare_parameter('width_mm', 800)
        old = self.declare_parameter('width', new.value)
        new = old if old.value != new.value and old.value != 800 else new""")],
        # All in one judge, which looks at what the pre-set callback has noted.
        [(_WARNING, '        self.asked = {p.name: p.value for p in parameters}\n'),
         ('        widths = {', """        if 'width' in self.asked:
            self.get_logger().error('do not set width any more')
        widths = {""")],
    ],
}
