"""Wrong answers that people give to the exercises of chapter 10.4."""

WRONG = {
    '10.4a': [
        ([("'[A-Z]{3}'", "'[A-Z]{3}.*'")], 2, 'it was accepted'),
        ([("['hover', 'track', 'land']", "['hover', 'track']")], 3, 'must be one of'),
        ([('lambda land, home: land < home', 'lambda land, home: land <= home')], 3, 'it was accepted'),
        # Across parameters, but judged by hand and with the stored other one.
        ([("['land_percent', 'home_percent'], lambda land, home: land < home",
           "'land_percent', lambda land: land < self.get_parameter('home_percent').value")], 3, 'it was accepted'),
        ([('Rules(self).matches', 'Rules(self).match')], 0, "no attribute 'match'"),
        ([("['hover', 'track', 'land']", "'hover'")], 0, 'give a list of at least one choice'),
    ],
    '10.4b': [
        ([("        Aliases(self, {'width': 'width_mm', 'plate': 'plate_number'})\n", '')], 0,
         'there are only width_mm, plate_number'),
        ([("{'width': 'width_mm', 'plate': 'plate_number'}", "{'width_mm': 'width', 'plate_number': 'plate'}")], 0,
         'is an old name of'),
        ([("        Aliases(self, {'width': 'width_mm', 'plate': 'plate_number'})\n", ''),
          ('read_only=True))', "read_only=True))\n"
           "        Aliases(self, {'width': 'width_mm', 'plate': 'plate_number'})")], 0,
         'before the first declaration'),
        ([(', ParameterDescriptor(read_only=True)', '')], 2, 'it could be set'),
        # Both declared, and no alias: they do not follow one another.
        ([("Aliases(self, {'width': 'width_mm', 'plate': 'plate_number'})",
           "self.declare_parameters('', [('width', 800), ('plate', 'none')])")], 0, 'it is `800`'),
    ],
    '10.4c': [
        ([('if name not in keep', '')], 2, "it is `'white'`"),
        ([("if outcome.word != 'set'", "if outcome.word == 'set'")], 1, 'it returned `['),
        ([("[outcome.name for outcome in restore(node, wanted) if outcome.word != 'set']",
           'restore(node, wanted).complete')], 1, 'it returned `True`'),
        ([('ParameterSet.defaults(node_class)', 'ParameterSet.of(node)')], 0, 'it is `1`'),
    ],
}
