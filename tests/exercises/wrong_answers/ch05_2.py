"""Wrong answers that people give to the exercises of chapter 5.2."""

WRONG = {
    '5.2a': [
        ([('self.add_on_set_parameters_callback(self.validate)\n', '\n')], 2, 'it was accepted'),
        ([("reason=f'{low_c} is not below {high_c}'", "reason=''")], 2, 'the reason is empty'),
        ([("proposed.get('low_c', self.get_parameter('low_c').value)", "self.get_parameter('low_c').value")], 2,
         'it was accepted'),
        ([("high_c = proposed.get('high_c', self.get_parameter('high_c').value)",
           "high_c = self.get_parameter('high_c').value")], 1, 'it was accepted'),
        # Acts in the judge: with the proposed values, which may still be rejected, and with the stored, which are old.
        ([('        return SetParametersResult(successful=True)',
           '        self.target_c = (low_c + high_c) / 2\n        return SetParametersResult(successful=True)')], 3,
         'a side effect of an on-set callback'),
        ([('add_post_set_parameters_callback(self.react)', 'add_on_set_parameters_callback(self.judge_late)'),
          ('def react(self, parameters):', 'def judge_late(self, parameters):'),
          ('.value) / 2', '.value) / 2\n        return SetParametersResult(successful=True)')], 2, 'it is `20.0`'),
        ([('return SetParametersResult(successful=True)', 'return True')], 0, 'has to return a `SetParametersResult`'),
    ],
    '5.2b': [
        ([('for parameter in parameters:\n', 'for parameter in parameters[:1]:\n')], 2, 'it was accepted'),
        ([("reason=f'{parameter.value} is not a percentage'", "reason=''")], 2, 'the reason is empty'),
        ([('        return SetParametersResult(successful=True)',
           "        self.motor_percent = {p.name: p.value for p in parameters}.get('open_percent', 50)\n"
           '        return SetParametersResult(successful=True)')], 2,
         'a side effect of an on-set callback'),
        ([('self.motor_percent = self', 'self.motor = self')], 2, 'it is `0`'),
    ],
    '5.2c': [
        ([('dbeca', 'bdeca')], 3, 'called its pre-set callback, and then rejected'),
        ([('dbeca', 'debca')], 3, 'never called its on-set callback'),
        ([('dbeca', 'dbcea')], 3, 'still held 100'),
        ([('dbeca', 'dbeac')], 3, 'held 150'),
        ([('dbeca', 'dbec')], 0, "your order is 'dbec'"),
    ],
}
