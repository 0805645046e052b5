"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 8."""

# Lines of the steps and the solution, which the answers replace.
_HAS = "                assert driver.has_parameter(name), f'{path.name}: the driver has no {name}'\n"
_VALUE = "                assert driver.get_parameter(name).value == value, f'{path.name}: {name}'\n"
_REJECTED = "        answer, = driver.set_parameters([Parameter('max_speed_mps', value=2.0)])\n"
_FILES = "sorted(Path(__file__).parents[1].glob('config/*.yaml'))"
_ACT = '    def act(self, parameters):\n        self.limits = self.limits_with([])\n'
_JUDGE = '        new = self.limits_with(parameters)\n'
_MIXED = '        assert driver.limits == before\n'
_FROZEN = '@dataclass(frozen=True)'
_READS = 'command.linear.x = limits.max_speed_mps'
_NEW = '            if not self.has_parameter(name):\n                self.declare_parameter(name, 0.5)'

WRONG = {
    '8a': [
        # Starts the driver with each file, and compares nothing.
        ([(_HAS, ''), (_VALUE, '                pass\n')], 2, '`config/my_robot.yaml` says `max_sped_mps`'),
        ([(_VALUE, '')], 2, 'if its key is `/**/drive`'),
        ([(_FILES, "[Path(__file__).parents[1] / 'config' / 'my_robot.yaml']")], 2, 'if one more file'),
        ([(_REJECTED, _REJECTED.replace('2.0', "'fast'"))], 2, 'without its on-set callback'),
        ([('        assert not answer.successful\n', '')], 2, 'without its on-set callback'),
        ([('assert not answer', 'assert answer')], 0, 'fails: AssertionError'),
        ([('def test_', 'def check_')], 0, 'there is none'),
        ([('import yaml\n', '')], 0, "NameError: name 'yaml' is not defined"),
        ([('import yaml\n', 'import yamel\n')], 0, "No module named 'yamel' (line "),
        ([('        yield Driver()', '        rclpy.spin(Driver())')], 0, 'Does one of them spin?'),
    ],
    '8b': [
        ([(_FROZEN, '@dataclass')], 3, 'it is allowed'),
        ([(_ACT, '    def act(self, parameters):\n')], 2, 'it is `Limits(max_speed_mps=0.5'),
        ([(_JUDGE, f'{_JUDGE}        self.limits = new\n')], 3, 'it is `Limits(max_speed_mps=2.0'),
        ([(_ACT, '    def act(self, parameters):\n'),
          ('        return SetParametersResult(successful=True)\n',
           '        self.limits = new\n        return SetParametersResult(successful=True)\n'),
          ('        self.limits = self.limits_with([])\n        self.add_on', '        self.add_on')], 3,
         'an on-set callback has only a proposal'),
        ([(_READS, "command.linear.x = self.get_parameter('max_speed_mps').value")], 4,
         'Does `drive` still ask for a parameter?'),
        ([('> limits.stop_distance_m:', "> self.get_parameter('stop_distance_m').value:")], 4,
         'Does `drive` still ask for a parameter?'),
        ([(_MIXED, '')], 4, 'before the judge has agreed'),
        ([('self.limits = ', 'self.limit = '), ('= Twist(), self.limits', '= Twist(), self.limit')], 1,
         'the driver has no such attribute'),
    ],
    '8c': [
        ([(', read_only=True,', ',')], 2, 'it was accepted'),
        ([("Twist, 'cmd_vel', 10, qos_overriding_options=QoSOverridingOptions.with_default_policies())",
           "Twist, 'cmd_vel', 10)")], 2, 'it is 10'),
        ([('        assert driver.commands.qos_profile.depth == 1\n', '        pass\n')], 3, '1 of your tests fails'),
        ([('depth == 1', 'depth == 2')], 3, 'fails: '),
    ],
    '8d': [
        ([(_NEW, '            self.declare_parameter(name, 0.5)')], 1, 'ParameterAlreadyDeclaredException'),
        ([(_NEW, '            if self.has_parameter(name):\n                self.undeclare_parameter(name)\n'
           '            self.declare_parameter(name, 0.5)')], 2, 'it is `0.5`'),
        ([(_NEW, '            if not self.has_parameter("follow.max_speed_mps") or controller == "dock" '
           'and not self.has_parameter(name):\n                self.declare_parameter(name, 0.5)')], 2,
         'there is none'),
        ([('declare_parameter(name, 0.5)', 'declare_parameter(name, 0.5, ignore_override=True)')], 2, 'it is `0.5`'),
    ],
}

RIGHT = {
    '8a': [
        # With what only pytest knows.
        [('def test_each_file_reaches_the_driver():\n    assert FILES\n    for path in FILES:\n',
          "import pytest\n\n\n@pytest.mark.parametrize('path', FILES)\ndef test_each_file_reaches_the_driver(path):\n"
          '    if True:\n')],
        [(_HAS, ''), ('driver.get_parameter(name).value', 'driver.get_parameter_or(name).value')],
        [(_REJECTED, _REJECTED.replace('set_parameters(', 'set_parameters_atomically(').replace(', =', ' ='))],
    ],
    '8b': [
        [('limits_with', '_limits_after')],
        [(_FROZEN, '@dataclass(frozen=True, slots=True)')],
    ],
    '8c': [
        [('QoSOverridingOptions.with_default_policies()', 'QoSOverridingOptions([QoSPolicyKind.DEPTH])'),
         ('import QoSOverridingOptions\n', 'import QoSOverridingOptions\nfrom rclpy.qos import QoSPolicyKind\n')],
    ],
    '8d': [
        [(_NEW, '            try:\n                self.declare_parameter(name, 0.5)\n'
          '            except Exception:\n                pass')],
    ],
}
