"""Wrong answers that people give to the exercises of chapter 10.1."""

WRONG = {
    '10.1a': [
        # The chain of the article.
        ([('parameter_value_to_python(parameter.value)',
           'parameter.value.string_value or parameter.value.integer_value or parameter.value.double_value '
           'or parameter.value.bool_value')], 2, "there is `('changed', 'offset', False)`"),
        # Raises an exception at each event.
        ([('event.deleted_parameters', 'event.removed_parameters')], 1,
         "the subscription callback write of /journal raised AttributeError: 'ParameterEvent' object has no attribute "
         "'removed_parameters'"),
        ([('self.write, qos_profile_parameter_events', 'self.write, 10')], 3, '10 of the speeds are in it'),
        ([("if event.node == '/rover':", "if event.node == 'rover':")], 0, 'the pages are `[]`'),
        ([("if event.node == '/rover':", 'if event.node:')], 3, "('changed', 'speed', 3), ('changed', 'speed', 5)"),
        ([("'deleted', parameter.name, None", "'deleted', parameter.name, parameter.name")], 3,
         "there is `('deleted', 'lamp', 'lamp')`"),
        ([("'/parameter_events'", "'/parameter_event'")], 0, 'it does not'),
    ],
    '10.1b': [
        ([("with three parameters': 3", "with three parameters': 1")], 6, 'It stores one after the other'),
        ([("atomically with three parameters': 1", "atomically with three parameters': 3")], 6, 'at one go'),
        ([("set_parameters with two, of which one is refused': 1",
           "set_parameters with two, of which one is refused': 0")], 6, 'the other one is stored'),
        ([("atomically with two, of which one is refused': 0", "atomically with two, of which one is refused': 1")], 6,
         'All or nothing'),
        ([("already': 1", "already': 0")], 6, 'A node does not compare'),
        ([("two parameters': 2", "two parameters': 1")], 6, 'It declares one after the other'),
        ([("undeclare_parameter': 0", "undeclare_parameter': 1")], 6, 'Nobody is told'),
    ],
}
