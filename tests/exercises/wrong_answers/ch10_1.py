"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 10.1."""

WRONG = {
    '10.1c': [
        ([('changed_parameters', 'new_parameters')], 0, 'it gives `{}`'),
        ([('parameter_value_to_python(parameter.value)', 'parameter.value')], 0, "it gives `{'speed':"),
        ([('parameter_value_to_python(parameter.value)', 'parameter.value.integer_value')],
         2, "it gives `{'speed': 7, 'offset': 0, 'label': 0, 'gains': 0,"),
        ([('parameter.name', 'parameter')], 0, "TypeError: unhashable type: 'Parameter'"),
        ([('event.changed_parameters', 'event')], 0, "TypeError: 'ParameterEvent' object is not iterable"),
        ([('event.changed_parameters', 'event.changed_parameters + event.new_parameters')],
         2, "it gives `{'lamp': 0}`"),
        ([('event.changed_parameters', 'event.changed_parameters[:1]')], 2, "it gives `{'speed': 7}`"),
        ([('parameter_value_to_python(parameter.value)', 'parameter_value_to_python(parameter)')],
         0, "AttributeError: 'Parameter' object has no attribute 'type'"),
        ([('changed_parameters', 'removed_parameters')],
         0, "AttributeError: 'ParameterEvent' object has no attribute"),
        ([(' for parameter in event.changed_parameters', '')], 0, "NameError: name 'parameter' is not defined"),
    ],
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
        ([("set_parameters with two, of which one is rejected': 1",
           "set_parameters with two, of which one is rejected': 0")], 6, 'the other one is stored'),
        ([("atomically with two, of which one is rejected': 0", "atomically with two, of which one is rejected': 1")],
         6, 'All or nothing'),
        ([("already': 1", "already': 0")], 6, 'A node does not compare'),
        ([("two parameters': 2", "two parameters': 1")], 6, 'It declares one after the other'),
        ([("undeclare_parameter': 0", "undeclare_parameter': 1")], 6, 'Nobody is told'),
    ],
}

RIGHT = {
    '10.1c': [
        [('{parameter.name: parameter_value_to_python(parameter.value) for parameter in '
          'event.changed_parameters}',
          'dict((each.name, parameter_value_to_python(each.value)) for each in '
          'event.changed_parameters)')],
        [('def changes', 'from rclpy.parameter import Parameter\n\n\ndef changes'),
         ('parameter_value_to_python(parameter.value)', 'Parameter.from_parameter_msg(parameter).value')],
        [('parameter in event', 'parameter in list(event'),
         ('changed_parameters}', 'changed_parameters)}')],
    ],
}
